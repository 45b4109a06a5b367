// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <numbers>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {
namespace {

using testing::DoubleNear;

struct Published {
  std::string_view name;
  double gap_mm, angle_deg, curvature_rel;
};

class Profile : public testing::TestWithParam<Published> {};

TEST_P(Profile, HasThePublishedFiguresAndIsValid) {
  const auto tolerance = toleranceProfile(GetParam().name);
  ASSERT_TRUE(tolerance);
  EXPECT_NO_THROW(tolerance->validate());
  EXPECT_DOUBLE_EQ(tolerance->gap_mm, GetParam().gap_mm);
  EXPECT_THAT(tolerance->angle_rad * 180 / std::numbers::pi,
              DoubleNear(GetParam().angle_deg, 1e-15));
  EXPECT_DOUBLE_EQ(tolerance->curvature_rel, GetParam().curvature_rel);
  EXPECT_DOUBLE_EQ(tolerance->flat_radius_mm, 100000);
  EXPECT_THAT(tolerance->crease_rad * 180 / std::numbers::pi, DoubleNear(5, 1e-14));
}

INSTANTIATE_TEST_SUITE_P(All, Profile,
                         testing::Values(Published{"default", 0.01, 0.1, 0.02},
                                         Published{"class-a", 0.001, 0.01, 0.02},
                                         Published{"vda", 0.02, 0.1, 0.1}));

TEST(Profiles, DefaultIsWhatAToleranceBeginsWith) {
  const ContinuityTolerance plain;
  const ContinuityTolerance named = toleranceProfile("default").value();
  EXPECT_EQ(plain.gap_mm, named.gap_mm);
  EXPECT_EQ(plain.angle_rad, named.angle_rad);
  EXPECT_EQ(plain.curvature_rel, named.curvature_rel);
  EXPECT_EQ(plain.flat_radius_mm, named.flat_radius_mm);
  EXPECT_EQ(plain.crease_rad, named.crease_rad);
}

TEST(Profiles, NamesAreExact) {
  for (const std::string_view name : {"", "Default", "class-A", "class_a", "vda ", "custom"})
    EXPECT_FALSE(toleranceProfile(name)) << name;
}

}  // namespace
}  // namespace seamwright
