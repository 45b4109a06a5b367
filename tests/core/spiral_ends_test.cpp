// SPDX-License-Identifier: LGPL-2.1-or-later
#include <optional>
#include <seamwright/core/planar/spiral.hpp>
#include <seamwright/core/planar/spiral_ends.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::endsWith;
using test::number;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

CurvedEnds endsOf(const Clothoid& curve) {
  return {.ends = {.start = curve.start,
                   .start_direction_rad = curve.direction_rad,
                   .end = curve.end(),
                   .end_direction_rad = curve.directionAt_rad(curve.length_mm)},
          .start_curvature_per_mm = curve.curvature_per_mm,
          .end_curvature_per_mm = curve.curvatureAt_per_mm(curve.length_mm)};
}

CurvedEnds endsOf(const Biarc& curve) {
  return {.ends = {.start = curve.first.start,
                   .start_direction_rad = curve.first.direction_rad,
                   .end = curve.second.end(),
                   .end_direction_rad = curve.second.endDirection_rad()},
          .start_curvature_per_mm = curve.first.curvature_per_mm,
          .end_curvature_per_mm = curve.second.curvature_per_mm};
}

CurvedEnds reversedEnds(const CurvedEnds& e) {
  return {.ends = {.start = e.ends.end,
                   .start_direction_rad = e.ends.end_direction_rad + pi,
                   .end = e.ends.start,
                   .end_direction_rad = e.ends.start_direction_rad + pi},
          .start_curvature_per_mm = -e.end_curvature_per_mm,
          .end_curvature_per_mm = -e.start_curvature_per_mm};
}

CurvedEnds mirrored(CurvedEnds e) {
  e.ends.start.y() *= -1;
  e.ends.end.y() *= -1;
  e.ends.start_direction_rad *= -1;
  e.ends.end_direction_rad *= -1;
  e.start_curvature_per_mm *= -1;
  e.end_curvature_per_mm *= -1;
  return e;
}

SpiralKind opposite(SpiralKind kind) {
  if (kind == SpiralKind::Rising) return SpiralKind::Falling;
  return kind == SpiralKind::Falling ? SpiralKind::Rising : kind;
}

/// The clothoid between random ends, which is the short one, with a notable change of curvature.
std::optional<Clothoid> randomClothoid(std::mt19937_64& random) {
  const double a = uniform(random, -2, 2), b = uniform(random, -2, 2);
  if (std::abs(a - b) < 0.02) return std::nullopt;
  HermiteEnds ends = endsWith(a, b, uniform(random, 0.1, 20));
  ends.start += Eigen::Vector2d(3, -4);
  ends.end += Eigen::Vector2d(3, -4);
  return clothoid(ends);
}

/// Ends with given angles against the chord and given values of the excesses.
CurvedEnds endsOfFigures(double a, double b, double u, double v, double chord_mm) {
  return {.ends = endsWith(-a, b, chord_mm),
          .start_curvature_per_mm = (u - std::sin(a)) * 2 / chord_mm,
          .end_curvature_per_mm = (v + std::sin(b)) * 2 / chord_mm};
}

// Identities (1) and (5).
TEST(SpiralEnds, OfClothoidsHaveTheirKindAndTheirBilens) {
  std::mt19937_64 random(testSeed());
  int found = 0;
  while (found < 500) {
    const std::optional<Clothoid> curve = randomClothoid(random);
    if (!curve) continue;
    ++found;
    const CurvedEnds ends = endsOf(*curve);
    const SpiralKind kind =
        curve->curvature_slope_per_mm2 > 0 ? SpiralKind::Rising : SpiralKind::Falling;
    EXPECT_EQ(spiralCertificate(ends).kind, kind);
    const Interval bilens = bilens_rad(ends.ends);
    for (int k = 1; k < 50; ++k) {
      const double turn = turnThrough_rad(ends.ends, curve->point(curve->length_mm * k / 50));
      EXPECT_GT(turn, bilens.lower - 1e-12);
      EXPECT_LT(turn, bilens.upper + 1e-12);
    }
  }
}

// Identity (1).
TEST(SpiralEnds, OfLogarithmicSpiralsHaveTheirKind) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double turn = uniform(random, 0.1, 3), share = uniform(random, 0.2, 0.8);
    if (std::abs(share - 0.5) < 0.01) continue;
    const HermiteEnds ends = endsWith(turn * share, turn * (1 - share), uniform(random, 0.1, 9));
    const LogSpiral curve = logSpiral(ends);
    const SpiralCertificate found =
        spiralCertificate({.ends = ends,
                           .start_curvature_per_mm = 1 / curve.radiusAt_mm(0),
                           .end_curvature_per_mm = 1 / curve.radiusAt_mm(curve.turn_rad)});
    EXPECT_EQ(found.kind, curve.growth < 0 ? SpiralKind::Rising : SpiralKind::Falling);
  }
}

// Identity (2).
TEST(SpiralEnds, OfArcsAndBiarcsAreLimits) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double angle = uniform(random, -3, 3);
    const HermiteEnds circle = endsWith(angle, angle, 2);
    EXPECT_EQ(spiralCertificate({circle, std::sin(angle), std::sin(angle)}).kind, SpiralKind::Arc);
    EXPECT_EQ(spiralCertificate({circle, 0.1 + std::sin(angle), 0.1 + std::sin(angle)}).kind,
              SpiralKind::Nothing);
    const double a = uniform(random, -1.5, 1.5), b = uniform(random, -1.5, 1.5);
    if (std::abs(a - b) < 0.1) continue;
    CurvedEnds ends = endsOf(biarc(endsWith(a, b), uniform(random, 0.2, 0.8)));
    EXPECT_EQ(spiralCertificate(ends).kind, SpiralKind::Biarc);
    const double step = 1e-6 * (ends.end_curvature_per_mm - ends.start_curvature_per_mm);
    ends.start_curvature_per_mm += step;
    EXPECT_EQ(spiralCertificate(ends).kind, SpiralKind::Nothing);
    ends.start_curvature_per_mm -= 2 * step;
    EXPECT_EQ(spiralCertificate(ends).kind, b > a ? SpiralKind::Rising : SpiralKind::Falling);
  }
  EXPECT_EQ(spiralCertificate({endsWith(0, 0, 5), 0, 0}).kind, SpiralKind::Arc);
}

/// The biarc of the family whose second arc has the curvature.
std::optional<Biarc> biarcWithEnd(const HermiteEnds& ends, double curvature_per_mm) {
  const auto excess = [&](double x) {
    return biarc(ends, x).second.curvature_per_mm - curvature_per_mm;
  };
  constexpr int samples = 200;
  for (int i = 1; i + 1 < samples; ++i) {
    double low = double(i) / samples, high = double(i + 1) / samples;
    if ((excess(low) > 0) == (excess(high) > 0)) continue;
    for (int step = 0; step < 50; ++step) {
      const double middle = (low + high) / 2;
      ((excess(middle) > 0) == (excess(low) > 0) ? low : high) = middle;
    }
    return biarc(ends, low);
  }
  return std::nullopt;
}

/// A chain of three arcs of rising curvature, by a search for the length of the first arc.
bool threeArcsExist(const CurvedEnds& ends) {
  const double ka = ends.start_curvature_per_mm, kb = ends.end_curvature_per_mm;
  PlanarArc first{.start = ends.ends.start,
                  .direction_rad = ends.ends.start_direction_rad,
                  .curvature_per_mm = ka};
  const double longest_mm = std::min(2 * pi / std::abs(ka), 3.0);
  for (int i = 0; i < 400; ++i) {
    first.length_mm = longest_mm * i / 400;
    HermiteEnds rest = ends.ends;
    rest.start = first.end();
    rest.start_direction_rad = first.endDirection_rad();
    const ChordAngles angles = chordAngles(rest);
    if (std::abs(angles.alpha_rad + angles.beta_rad) > 6.2) continue;
    const std::optional<Biarc> found = biarcWithEnd(rest, kb);
    if (found && found->first.curvature_per_mm >= ka && found->first.curvature_per_mm <= kb)
      return true;
  }
  return false;
}

// Identity (3).
TEST(SpiralEnds, RisingOnesAreJoinedByThreeArcs) {
  std::mt19937_64 random(testSeed());
  int found = 0;
  while (found < 40) {
    const double a = uniform(random, -2.5, 2.5), b = uniform(random, -2.5, 2.5);
    const CurvedEnds ends =
        endsOfFigures(a, b, -uniform(random, 0.05, 3), uniform(random, 0.05, 3), 1);
    const SpiralCertificate certificate = spiralCertificate(ends);
    if (certificate.kind != SpiralKind::Rising || certificate.separation.value > -0.02 ||
        certificate.turn_rad.value < 0.1)
      continue;
    ++found;
    EXPECT_TRUE(threeArcsExist(ends))
        << a << " " << b << " " << ends.start_curvature_per_mm << " " << ends.end_curvature_per_mm;
  }
}

// Identity (4).
TEST(SpiralEnds, FollowMirrorReversalMotionAndScale) {
  std::mt19937_64 random(testSeed());
  std::array<int, 6> kinds{};
  for (int i = 0; i < 500; ++i) {
    CurvedEnds ends = endsOfFigures(uniform(random, -3, 3), uniform(random, -3, 3),
                                    uniform(random, -3, 3), uniform(random, -3, 3), 2);
    const SpiralKind kind = spiralCertificate(ends).kind;
    ++kinds[static_cast<std::size_t>(kind)];
    EXPECT_EQ(spiralCertificate(reversedEnds(ends)).kind, kind);
    EXPECT_EQ(spiralCertificate(mirrored(ends)).kind, opposite(kind));
    const double turn = uniform(random, -3, 3), scale = std::exp(uniform(random, -5, 5));
    const Eigen::Rotation2Dd rotation(turn);
    ends.ends.start = scale * (rotation * ends.ends.start);
    ends.ends.end = scale * (rotation * ends.ends.end);
    ends.ends.start_direction_rad += turn;
    ends.ends.end_direction_rad += turn;
    ends.start_curvature_per_mm /= scale;
    ends.end_curvature_per_mm /= scale;
    EXPECT_EQ(spiralCertificate(ends).kind, kind);
  }
  EXPECT_GT(kinds[static_cast<std::size_t>(SpiralKind::Rising)], 20);
  EXPECT_GT(kinds[static_cast<std::size_t>(SpiralKind::Falling)], 20);
  EXPECT_GT(kinds[static_cast<std::size_t>(SpiralKind::Nothing)], 100);
}

TEST(SpiralEnds, AgreeWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("spiral_theorems.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const Clothoid curve{.direction_rad = number(in["theta0"]),
                         .curvature_per_mm = number(in["k0"]),
                         .curvature_slope_per_mm2 = number(in["gamma"]),
                         .length_mm = number(in["L"])};
    const CurvedEnds ends = endsOf(curve);
    const SpiralCertificate found = spiralCertificate(ends);
    EXPECT_NEAR(found.start_angle_rad, number(out["a"]), 1e-14);
    EXPECT_NEAR(found.end_angle_rad, number(out["b"]), 1e-14);
    EXPECT_EQ(found.turn_rad.sign(), out["vogt"].get<int>());
    EXPECT_EQ(found.kind, out["vogt"] == 1 ? SpiralKind::Rising : SpiralKind::Falling);
    const Interval bilens = bilens_rad(ends.ends);
    EXPECT_NEAR(bilens.lower, number(out["bilens_lo"]), 1e-14);
    EXPECT_NEAR(bilens.upper, number(out["bilens_hi"]), 1e-14);
    EXPECT_NEAR(turnThrough_rad(ends.ends, curve.point(curve.length_mm / 2)),
                number(out["subtended"]), 1e-14);
    if (!out.contains("c0")) continue;
    const double distance = number(out["centre_distance"]), k0 = ends.start_curvature_per_mm,
                 k1 = ends.end_curvature_per_mm, radii = 1 / k0 - 1 / k1;
    EXPECT_EQ(found.separation.sign() < 0, out["nested"].get<bool>());
    const double expected = k0 * k1 / 4 * (distance * distance - radii * radii);
    EXPECT_NEAR(found.separation.value, expected, 1e-13);
  }
}

TEST(SpiralEnds, InvalidNumbersAreRefused) {
  const auto refused = [](const CurvedEnds& ends, const char* text) {
    EXPECT_THAT([&] { spiralCertificate(ends); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused({endsWith(0.1, 0.2), std::nan(""), 0}, "must be finite");
  refused({endsWith(0.1, 0.2, 1e10), 0, 1e308}, "must be finite");
  refused({endsWith(0.1, 0.2, 0), 0, 1}, "both ends are the point");
  EXPECT_THAT([] { turnThrough_rad(endsWith(0.1, 0.2), Eigen::Vector2d(1, 0)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the point (1, 0)")));
}

}  // namespace
}  // namespace seamwright
