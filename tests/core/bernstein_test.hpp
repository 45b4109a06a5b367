// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gmock/gmock.h>

#include <cfenv>
#include <random>
#include <string>

#include "exact.hpp"

namespace seamwright::test {

/// Runs its tests in each rounding mode of the processor: no bound may lean on one of them.
class InEachRoundingMode : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { std::fesetround(GetParam()); }
  void TearDown() override { std::fesetround(FE_TONEAREST); }
};

inline const auto kRoundingModes =
    testing::Values(FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO);

inline std::string roundingModeName(const testing::TestParamInfo<int>& info) {
  switch (info.param) {
    case FE_TONEAREST:
      return "Nearest";
    case FE_UPWARD:
      return "Upward";
    case FE_DOWNWARD:
      return "Downward";
    default:
      return "TowardZero";
  }
}

inline double uniform(std::mt19937_64& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

/// Numbers of either sign whose sizes spread over the given powers of ten, some of them 0.
inline double spread(std::mt19937_64& random, double lower_power, double upper_power) {
  if (random() % 8 == 0) return 0;
  const double size = std::pow(10, uniform(random, lower_power, upper_power));
  return random() % 2 ? size : -size;
}

MATCHER_P(Encloses, truth, "") {
  *result_listener << "truth about " << static_cast<double>(truth.approximate());
  return Dyadic(arg.lower) <= truth && truth <= Dyadic(arg.upper);
}

}  // namespace seamwright::test
