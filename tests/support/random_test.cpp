// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/random.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

namespace seamwright {
namespace {

/// Sets SEAMWRIGHT_SEED, or removes it, and puts it back.
class Variable {
 public:
  explicit Variable(const char* value) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  ~Variable() { set(before_ ? before_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  static constexpr const char* name = "SEAMWRIGHT_SEED";
  static void set(const char* value) {
    if (value)
      setenv(name, value, 1);
    else
      unsetenv(name);
  }
  std::optional<std::string> before_;
};

TEST(TestSeed, IsTheHashOfTheTestsName) {
  const Variable none(nullptr);
  EXPECT_EQ(testSeed(), 2603231991u);
}

TEST(TestSeed, DiffersByTheIndex) {
  EXPECT_NE(testSeed(0), testSeed(1));
  EXPECT_NE(testSeed(1), testSeed(2));
}

TEST(TestSeed, IsReplacedByTheEnvironment) {
  const Variable given("4294967295");
  EXPECT_EQ(testSeed(), 4294967295u);
}

TEST(TestSeed, RefusesWhatIsNoSeed) {
  for (const char* bad : {"", "-1", "4294967296", "7 ", "seven"}) {
    const Variable given(bad);
    EXPECT_THROW(testSeed(), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace seamwright
