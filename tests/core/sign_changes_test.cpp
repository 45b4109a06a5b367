// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <seamwright/core/bernstein/sign_changes.hpp>

#include "support/random.hpp"

namespace seamwright {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The product of (t - root), in Bernstein form.
BernsteinPolynomial withRoots(const std::vector<double>& roots) {
  BernsteinPolynomial result(Eigen::VectorXd::Ones(1));
  for (const double root : roots)
    result = result * BernsteinPolynomial(Eigen::Vector2d(-root, 1 - root));
  return result;
}

/// Roots with gaps of at least 0.04; some on middles of intervals, some outside of [0, 1].
std::vector<double> randomRoots(std::mt19937_64& random) {
  std::vector<double> roots;
  std::uniform_real_distribution<double> anywhere(-0.5, 1.5);
  for (int i = 0; i < 8; ++i) {
    const double root = i == 0 ? 0.5 : i == 1 ? 0.25 : anywhere(random);
    const auto near = [&](double other) { return std::abs(root - other) < 0.04; };
    if (std::ranges::none_of(roots, near) && !near(0) && !near(1)) roots.push_back(root);
  }
  std::ranges::shuffle(roots, random);
  return roots;
}

// Identity (1).
TEST(SignChanges, EachSimpleRootIsInOneInterval) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const std::vector<double> roots = randomRoots(random);
    const SignChanges found = signChanges(withRoots(roots));
    std::vector<double> inside;
    std::ranges::copy_if(roots, std::back_inserter(inside),
                         [](double root) { return 0 < root && root < 1; });
    std::ranges::sort(inside);
    EXPECT_THAT(found.undecided, IsEmpty());
    ASSERT_THAT(found.changes, SizeIs(inside.size()));
    // The sign at 1 is positive after an even number of roots above 1.
    bool positive = std::ranges::count_if(roots, [](double r) { return r > 1; }) % 2 == 0;
    for (std::size_t k = inside.size(); k-- > 0; positive = !positive) {
      EXPECT_TRUE(found.changes[k].interval.contains(inside[k]));
      EXPECT_LT(found.changes[k].interval.width(), 1e-8);
      EXPECT_EQ(found.changes[k].to_positive, positive);
    }
  }
}

// Identity (2).
TEST(SignChanges, OfTheNegativeGoTheOtherWay) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const BernsteinPolynomial p = withRoots(randomRoots(random));
    const SignChanges one = signChanges(p), other = signChanges(-p);
    ASSERT_EQ(one.changes.size(), other.changes.size());
    for (std::size_t k = 0; k < one.changes.size(); ++k) {
      EXPECT_EQ(one.changes[k].interval.lower, other.changes[k].interval.lower);
      EXPECT_EQ(one.changes[k].to_positive, !other.changes[k].to_positive);
    }
  }
}

// Identity (3).
TEST(SignChanges, OfZeroAreUndecidedEverywhere) {
  const BernsteinPolynomial noise(Eigen::Vector4d(1e-17, -1e-17, 2e-17, 0), 1e-16);
  for (const BernsteinPolynomial& p : {noise, BernsteinPolynomial(Eigen::Vector3d::Zero())}) {
    const SignChanges found = signChanges(p);
    EXPECT_THAT(found.changes, IsEmpty());
    ASSERT_THAT(found.undecided, SizeIs(1));
    EXPECT_EQ(found.undecided[0].lower, 0);
    EXPECT_EQ(found.undecided[0].upper, 1);
  }
}

// Identity (4): also a root of order 3, which is not a simple one.
TEST(SignChanges, MultipleRootsAreUndecided) {
  for (const double root : {0.5, 1.0 / 3, 0.875}) {
    for (const std::vector<double>& roots :
         {std::vector<double>{root, root}, {root, root, root}, {root, root, -0.5}}) {
      const SignChanges found = signChanges(withRoots(roots));
      EXPECT_THAT(found.changes, IsEmpty());
      ASSERT_THAT(found.undecided, SizeIs(1));
      EXPECT_TRUE(found.undecided[0].contains(root));
      EXPECT_LT(found.undecided[0].width(), 1e-4);
    }
  }
}

TEST(SignChanges, RootsAtTheEndsAreUndecided) {
  const SignChanges found = signChanges(withRoots({0, 0.3, 1}));
  ASSERT_THAT(found.changes, SizeIs(1));
  EXPECT_TRUE(found.changes[0].interval.contains(0.3));
  ASSERT_THAT(found.undecided, SizeIs(2));
  EXPECT_EQ(found.undecided[0].lower, 0);
  EXPECT_EQ(found.undecided[1].upper, 1);
}

// A double root that rounding may have moved apart or off the axis must not be called two changes
// or none.
TEST(SignChanges, PaddingHidesCloseRoots) {
  const BernsteinPolynomial exact = withRoots({0.4, 0.4 + 1e-7});
  const SignChanges found = signChanges(BernsteinPolynomial(exact.coefficients(), 1e-12));
  EXPECT_THAT(found.changes, IsEmpty());
  ASSERT_THAT(found.undecided, SizeIs(1));
  EXPECT_TRUE(found.undecided[0].contains(0.4));
  EXPECT_TRUE(found.undecided[0].contains(0.4 + 1e-7));
}

TEST(SignChanges, InvalidWidthIsNamed) {
  const BernsteinPolynomial p(Eigen::Vector2d(-1, 1));
  for (const double width : {0.0, -1.0, 2.0, 1e-300, std::nan("")})
    EXPECT_THROW(signChanges(p, width), std::invalid_argument) << width;
}

}  // namespace
}  // namespace seamwright
