// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace seamwright {
namespace {

std::uint32_t fnv1a(std::string_view text) {
  std::uint32_t hash = 2166136261;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619;
  return hash;
}

std::uint32_t numberOf(std::string_view text) {
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stopped != end)
    throw std::invalid_argument("SEAMWRIGHT_SEED is '" + std::string(text) +
                                "': a number from 0 to 4294967295 is needed");
  return number;
}

std::string runningTest() {
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  if (const testing::TestInfo* test = tests.current_test_info())
    return std::string(test->test_suite_name()) + "." + test->name();
  if (const testing::TestSuite* suite = tests.current_test_suite()) return suite->name();
  throw std::logic_error("a seed was asked for while no test runs");
}

/// Prints the seed that a failed test had asked for.
class SeedPrinter : public testing::EmptyTestEventListener {
 public:
  void use(std::uint32_t seed) { seed_ = seed; }

  void OnTestEnd(const testing::TestInfo& test) override {
    if (seed_ && test.result()->Failed())
      std::cout << "Random numbers began with SEAMWRIGHT_SEED=" << *seed_ << std::endl;
    seed_.reset();
  }

 private:
  std::optional<std::uint32_t> seed_;
};

SeedPrinter& seedPrinter() {
  // GoogleTest owns its listeners.
  static SeedPrinter* const printer = [] {
    auto* made = new SeedPrinter;
    testing::UnitTest::GetInstance()->listeners().Append(made);
    return made;
  }();
  return *printer;
}

}  // namespace

std::uint32_t testSeed(std::uint32_t index) {
  const char* const given = std::getenv("SEAMWRIGHT_SEED");
  const std::uint32_t seed = given ? numberOf(given) : fnv1a(runningTest());
  seedPrinter().use(seed);
  // 2^32 over the golden ratio: an odd number, so that all indices give different seeds.
  return seed + index * 2654435769U;
}

}  // namespace seamwright
