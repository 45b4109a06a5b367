// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <seamwright/plugin/report/enclosure.hpp>

#include "support/random.hpp"

namespace seamwright::report {
namespace {

std::optional<double> valueOf(const nlohmann::json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

TEST(EnclosureText, FollowsTheCommonCases) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/enclosure_texts.json");
  const nlohmann::json cases = nlohmann::json::parse(file)["cases"];
  ASSERT_GT(cases.size(), 20U);
  for (const auto& one : cases)
    EXPECT_EQ(enclosureText({one["lower"], valueOf(one["upper"]), 0}, 1, valueOf(one["limit"])),
              one["text"].get<std::string>())
        << one;
}

TEST(EnclosureText, TheFactorChangesTheUnitOnly) {
  EXPECT_EQ(enclosureText({0.02, 0.02, 0}, 100, 2.0), "2");
  EXPECT_EQ(enclosureText({0.0200004, 0.0200005, 0}, 100, 2.0), "2.00005");
}

/// What the words say: a set of values that the true one may have.
struct Said {
  double lower = 0;
  double upper = HUGE_VAL;
};

Said read(const std::string& text) {
  const std::string at_most = "\u2264";
  const std::string at_least = "\u2265";
  if (text.starts_with(at_most)) return {0, std::stod(text.substr(at_most.size()))};
  if (text.starts_with(at_least)) return {std::stod(text.substr(at_least.size())), HUGE_VAL};
  if (const auto dots = text.find(".."); dots != std::string::npos)
    return {std::stod(text), std::stod(text.substr(dots + 2))};
  return {std::stod(text), std::stod(text)};
}

TEST(EnclosureText, NeverSaysLessThanIsKnownToOnePercentAndTellsTheSideOfTheLimit) {
  std::mt19937 random(testSeed());
  const auto logUniform = [&](double low, double high) {
    return std::exp(std::uniform_real_distribution(std::log(low), std::log(high))(random));
  };
  for (int i = 0; i < 20000; ++i) {
    const double limit = logUniform(1e-3, 10);
    const double lower = logUniform(1e-17, 1e4) * (i % 7 == 0 ? limit / 1e-3 : 1);
    const double upper = lower * (1 + logUniform(1e-15, 1e3));
    const std::string text = enclosureText({lower, upper, 0}, 1, limit);
    const Said said = read(text);
    const double slack = 1 + 1e-6;
    const double digits =
        text.find("..") == std::string::npos && !text.starts_with("\u2264") ? 1.06 : slack;
    EXPECT_LE(said.lower, lower * digits) << text << ' ' << lower << ' ' << upper;
    EXPECT_GE(said.upper * digits, upper) << text << ' ' << lower << ' ' << upper;
    EXPECT_TRUE(digits <= slack || (said.upper > limit) == (upper > limit))
        << text << ' ' << upper << ' ' << limit;
    EXPECT_EQ(text.find(' '), std::string::npos) << "one word: " << text;
  }
}

TEST(RangeText, RoundsOutward) {
  EXPECT_EQ(rangeText({1.2345, 1.2355, 0}), "1.23..1.24");
  EXPECT_EQ(rangeText({0.5, 0.5, 0}, 2), "1..1");
}

TEST(ShownWidth, CountsLetters) {
  EXPECT_EQ(shownWidth("\u22641e-13"), 6U);
  EXPECT_EQ(shownWidth(""), 0U);
}

}  // namespace
}  // namespace seamwright::report
