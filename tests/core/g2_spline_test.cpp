// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <seamwright/core/spline/g2_spline.hpp>

#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::expectRefused;
using test::Vec;

constexpr double eps = std::numeric_limits<double>::epsilon(),
                 nan = std::numeric_limits<double>::quiet_NaN();

double drawn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Random vertices; every fifth polygon is plane, every seventh has three vertices on a line, every
/// eleventh a short edge.
Poles randomVertices(int count, int i, std::mt19937_64& random) {
  Poles result(count, 3);
  for (int k = 0; k < count; ++k) result.row(k) = test::randomVector(random).transpose();
  if (i % 5 == 0) result.col(2).setConstant(0.25);
  if (i % 7 == 0) result.row(2) = 3 * result.row(1) - 2 * result.row(0);
  if (i % 11 == 0) result.row(2) = result.row(1) + 1e-3 * (result.row(2) - result.row(1));
  return result;
}

G2Polygon randomPolygon(int i, std::mt19937_64& random) {
  const bool closed = i % 2 == 0;
  const int count = (closed ? 3 : 4) + i % 6, edges = closed ? count : count - 1;
  G2Polygon polygon{randomVertices(count, i, random), closed, {}, {}};
  for (int e = 0; e < edges; ++e) {
    polygon.alpha.push_back(drawn(random, 0.02, 0.6));
    polygon.omega.push_back(drawn(random, polygon.alpha[e] + 0.02, 0.98));
  }
  return polygon;
}

GammaPolygon randomGamma(int i, std::mt19937_64& random) {
  const bool closed = i % 2 == 0;
  const int count = (closed ? 3 : 4) + i % 6, segments = closed ? count : count - 3;
  GammaPolygon polygon{randomVertices(count, i, random), closed, {}, {}};
  for (int s = 0; s < segments; ++s) {
    polygon.lengths.push_back(test::logUniform(random, -0.5, 0.5));
    polygon.gamma.push_back(test::logUniform(random, -2, 1.5));
  }
  return polygon;
}

/// The poles beside a joint and what rounding of them makes of its curvature.
struct Beside {
  Eigen::RowVector3d b1, b2, joint, c1, c2;

  double noise() const {
    const double size = std::max({b1.norm(), b2.norm(), joint.norm(), c1.norm(), c2.norm()});
    const double leg = std::min((joint - b2).norm(), (c1 - joint).norm());
    const double far = std::max((b2 - b1).norm(), (c2 - c1).norm());
    return 32 * eps * size * (1 + far / leg) / (leg * leg);
  }
};

Beside beside(const BezierSpline& spline, int joint) {
  const Eigen::Index at = 3L * joint, last = spline.poles.rows() - 1,
                     before = joint == 0 ? last : at;
  const auto pole = [&](Eigen::Index i) {
    return Eigen::RowVector3d(spline.poles.row(i).head<3>());
  };
  return {pole(before - 2), pole(before - 1), pole(at), pole(at + 1), pole(at + 2)};
}

/// The joint that figure i of measureJoints() is of.
int jointOf(const BezierSpline& spline, std::size_t i) {
  return static_cast<int>(i + 1) % spline.segments();
}

/// What rounding of poles of that size makes of X''(+) - X''(-) - nu X' between segments of lengths
/// h and k.
double nielsonNoise(double size, double h, double k, double nu) {
  return 64 * eps * size * (1 / (h * h) + 1 / (k * k)) * (1 + std::abs(nu) * std::min(h, k));
}

TEST(G2Spline, Identity1EveryJointIsG2) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 3000; ++i) {
    const BezierSpline spline = directG2Spline(randomPolygon(i, random));
    const std::vector<CurveJoint> joints = measureJoints(spline, 2);
    EXPECT_EQ(joints.size(), spline.closed ? spline.segments() : spline.segments() - 1);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const Beside at = beside(spline, jointOf(spline, j));
      ASSERT_EQ(joints[j].differences.size(), 3);
      EXPECT_EQ(*joints[j].gap_mm, 0);
      EXPECT_LT(joints[j].differences[2], at.noise()) << i << " joint " << j;
    }
  }
}

/// One inner pole off by 1e-6 of the size is seen, as much as the closed form says: the pole second
/// from a joint, moved by d across the tangent, adds (2/3) d / leg^2 to the curvature.
TEST(G2Spline, Identity1FailsForAMovedPole) {
  std::mt19937_64 random(testSeed());
  for (int i = 1; i < 300; i += 2) {
    BezierSpline spline = directG2Spline(randomPolygon(12 * i, random));
    const Beside at = beside(spline, 1);
    const double leg = (at.c1 - at.joint).norm(),
                 moved = 1e-6 * spline.poles.leftCols<3>().cwiseAbs().maxCoeff();
    const Vec across = Vec((at.c1 - at.joint) / leg).unitOrthogonal();
    spline.poles.row(5).head<3>() += moved * across.transpose();
    const double added = 2.0 / 3.0 * moved / (leg * leg);
    EXPECT_NEAR(measureJoints(spline, 2).front().differences[2], added, 1e-6 * added + at.noise())
        << i;
  }
}

TEST(G2Spline, KnotsMakeItC1) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const BezierSpline spline = directG2Spline(randomPolygon(i, random));
    EXPECT_EQ(spline.knots[0], 0);
    EXPECT_EQ(spline.knots[1], 1);
    const BSplineCurve curve = bsplineCurve(spline, 1);
    EXPECT_EQ(curve.count(), 2 * spline.segments() + 2);
    const double t = drawn(random, 0, spline.knots.back());
    EXPECT_LT((derivatives(curve, t, 0) - derivatives(spline, t, 0)).norm(),
              1e-13 * spline.poles.cwiseAbs().maxCoeff());
  }
}

TEST(G2Spline, Identity2HullAndOsculatingPlane) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const G2Polygon polygon = randomPolygon(i, random);
    const BezierSpline spline = directG2Spline(polygon);
    const Vec direction = test::randomVector(random);
    const double size = polygon.vertices.cwiseAbs().maxCoeff();
    for (int s = 0; s < spline.segments(); ++s) {
      const BezierCurve piece = segment(spline, s);
      const Eigen::VectorXd heights = piece.poles() * direction;
      const double height = piece.point(drawn(random, 0, 1)).dot(direction);
      EXPECT_LE(height, heights.maxCoeff() + 1e-15 * size * direction.norm());
      EXPECT_GE(height, heights.minCoeff() - 1e-15 * size * direction.norm());
    }
    const auto count = static_cast<int>(polygon.vertices.rows());
    for (int s = spline.closed ? 0 : 1; s < spline.segments(); ++s) {
      const int v = spline.closed ? s : s + 1;
      const Vec at = polygon.vertices.row(v).transpose(),
                before = polygon.vertices.row((v + count - 1) % count).transpose() - at,
                after = polygon.vertices.row((v + 1) % count).transpose() - at;
      const Vec normal = before.cross(after);
      const Beside poles = beside(spline, s);
      for (const Eigen::RowVector3d& pole : {poles.b1, poles.b2, poles.joint, poles.c1, poles.c2})
        EXPECT_NEAR((pole.transpose() - at).dot(normal), 0, 1e-14 * size * size * size)
            << i << " joint " << s;
    }
  }
}

TEST(G2Spline, Identity3AffineImages) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    G2Polygon polygon = randomPolygon(i, random);
    const BezierSpline plain = directG2Spline(polygon);
    Eigen::Matrix3d map;
    map << test::randomVector(random), test::randomVector(random), test::randomVector(random);
    const Vec shift = test::randomVector(random);
    polygon.vertices = ((polygon.vertices * map.transpose()).rowwise() + shift.transpose()).eval();
    const BezierSpline image = directG2Spline(polygon);
    EXPECT_EQ(image.knots, plain.knots);
    const Poles wanted =
        (plain.poles.leftCols<3>() * map.transpose()).rowwise() + shift.transpose();
    EXPECT_LT((image.poles.leftCols<3>() - wanted).norm(), 1e-13 * (1 + wanted.norm()));
  }
}

TEST(G2Spline, ReversedPolygonGivesTheCurveBackwards) {
  std::mt19937_64 random(testSeed());
  for (int i = 1; i < 1000; i += 2) {
    const G2Polygon polygon = randomPolygon(i, random);
    G2Polygon back{polygon.vertices.colwise().reverse(), false, {}, {}};
    for (std::size_t e = polygon.alpha.size(); e-- > 0;) {
      back.alpha.push_back(1 - polygon.omega[e]);
      back.omega.push_back(1 - polygon.alpha[e]);
    }
    const BezierSpline there = directG2Spline(polygon), returned = directG2Spline(back);
    EXPECT_LT((there.poles - returned.poles.colwise().reverse()).norm(),
              1e-13 * there.poles.norm());
  }
}

TEST(G2Spline, OracleOfSixtyDigits) {
  for (const nlohmann::json& entry : test::splineCases("g2_splines.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    G2Polygon polygon{test::points(in["d"]), in["closed"], test::numbers(in["alpha"]),
                      test::numbers(in["omega"])};
    if (!polygon.closed) {
      polygon.alpha.pop_back();
      polygon.omega.pop_back();
    }
    const BezierSpline spline = directG2Spline(polygon);
    ASSERT_EQ(spline.segments(), static_cast<int>(out["segments"].size()));
    for (int s = 0; s < spline.segments(); ++s)
      EXPECT_LT((segment(spline, s).poles() - test::points(out["segments"][s])).norm(),
                1e-14 * polygon.vertices.cwiseAbs().maxCoeff());
    const std::size_t count = out["r"].size();
    for (std::size_t j = 0; j < count; ++j) {
      const Beside at = beside(spline, jointOf(spline, j));
      const double r = (at.joint - at.b2).norm() / (at.c1 - at.b2).norm();
      const double given = test::number(out["r"][j]);
      EXPECT_NEAR(r, given, 1e-13);
    }
  }
}

TEST(G2Spline, GammaOracleOfSixtyDigits) {
  for (const nlohmann::json& entry : test::splineCases("gamma_splines.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const GammaPolygon polygon{test::points(in["d"]), in["closed"], test::numbers(in["Delta"]),
                               test::numbers(in["gamma"])};
    const G2Polygon shares = g2Polygon(polygon);
    for (std::size_t e = 0; e < shares.alpha.size(); ++e) {
      EXPECT_NEAR(shares.alpha[e], test::number(out["alpha"][e]), 1e-15);
      EXPECT_NEAR(shares.omega[e], test::number(out["omega"][e]), 1e-15);
    }
    const BezierSpline spline = gammaSpline(polygon);
    const double size = polygon.vertices.cwiseAbs().maxCoeff();
    for (int s = 0; s < spline.segments(); ++s)
      EXPECT_LT((segment(spline, s).poles() - test::points(out["segments"][s])).norm(),
                1e-14 * size);
    const std::vector<double>& l = polygon.lengths;
    for (std::size_t j = 0; j < out["nu"].size(); ++j) {
      const int s = spline.closed ? static_cast<int>(j) : static_cast<int>(j) + 1;
      const int before = s > 0 ? s - 1 : spline.segments() - 1;
      const CurveDerivatives a = segment(spline, before).derivatives(1, 2),
                             b = segment(spline, s).derivatives(0, 2);
      const double nu = test::number(out["nu"][j]), h = l[before], k = l[s];
      const Eigen::RowVector3d jump = b.row(2) / (k * k) - a.row(2) / (h * h);
      EXPECT_LT((jump - nu * b.row(1) / k).norm(), nielsonNoise(size, h, k, nu)) << s;
    }
    // The direct spline of these shares is the same but for its parameter.
    EXPECT_LT((directG2Spline(shares).poles - spline.poles).norm(), 1e-13 * size);
  }
}

TEST(G2Spline, Identity4NielsonsCondition) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 2000; ++i) {
    const GammaPolygon polygon = randomGamma(i, random);
    const BezierSpline spline = gammaSpline(polygon);
    const double size = polygon.vertices.cwiseAbs().maxCoeff();
    for (int s = spline.closed ? 0 : 1; s < spline.segments(); ++s) {
      const int before = s > 0 ? s - 1 : spline.segments() - 1;
      const double h = polygon.lengths[before], k = polygon.lengths[s];
      const double nu = 2 * (1 / h + 1 / k) * (1 / polygon.gamma[s] - 1);
      const CurveDerivatives a = segment(spline, before).derivatives(1, 2),
                             b = segment(spline, s).derivatives(0, 2);
      EXPECT_LT((b.row(1) / k - a.row(1) / h).norm(), 64 * eps * size * (1 / h + 1 / k))
          << i << " joint " << s;
      EXPECT_LT((b.row(2) / (k * k) - a.row(2) / (h * h) - nu * b.row(1) / k).norm(),
                nielsonNoise(size, h, k, nu))
          << i << " joint " << s;
    }
  }
}

TEST(G2Spline, Identity5OnesGiveTheBSpline) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    GammaPolygon polygon = randomGamma(i, random);
    std::ranges::fill(polygon.gamma, 1.0);
    const BezierSpline spline = gammaSpline(polygon);
    if (!polygon.closed) {
      const BSplineCurve curve{3, test::flatKnots(3, spline.knots, 1),
                               test::homogeneous(polygon.vertices)};
      const double t = drawn(random, 0, spline.knots.back());
      EXPECT_LT((derivatives(spline, t, 0) - derivatives(curve, t, 0)).norm(),
                1e-13 * polygon.vertices.norm());
      EXPECT_LT((bsplineCurve(spline, 2).poles - curve.poles).norm(),
                1e-12 * polygon.vertices.norm())
          << i;
      continue;
    }
    std::ranges::fill(polygon.lengths, 0.5);
    const BezierSpline even = gammaSpline(polygon);
    const auto count = static_cast<int>(polygon.vertices.rows());
    for (int s = 0; s < count; ++s) {
      const Eigen::RowVector3d wanted =
          (polygon.vertices.row((s + count - 1) % count) + 4 * polygon.vertices.row(s) +
           polygon.vertices.row((s + 1) % count)) /
          6;
      EXPECT_LT((even.poles.row(3L * s).head<3>() - wanted).norm(),
                1e-14 * polygon.vertices.norm());
    }
  }
}

double distanceToPolygon(const Poles& vertices, const Vec& x) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index e = 0; e < vertices.rows(); ++e) {
    const Vec from = vertices.row(e).transpose(),
              along = vertices.row((e + 1) % vertices.rows()).transpose() - from;
    const double share = std::clamp((x - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (x - from - share * along).norm());
  }
  return least;
}

double distanceToPolygon(const GammaPolygon& polygon, int first, int last) {
  const BezierSpline spline = gammaSpline(polygon);
  double most = 0;
  for (int s = first; s <= last; ++s)
    for (int i = 0; i <= 64; ++i)
      most =
          std::max(most, distanceToPolygon(polygon.vertices, segment(spline, s).point(i / 64.0)));
  return most;
}

TEST(G2Spline, Identity6SmallGammaRunsIntoThePolygon) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 24; ++i) {
    GammaPolygon polygon = randomGamma(36 + i, random);
    std::ranges::fill(polygon.lengths, 1.0);
    const auto segments = static_cast<int>(polygon.lengths.size());
    const int first = polygon.closed ? 0 : 1, last = polygon.closed ? segments - 1 : segments - 2;
    if (last < first) continue;
    double longest = 0, before = 0;
    for (Eigen::Index e = 0; e < polygon.vertices.rows(); ++e)
      longest = std::max(longest, (polygon.vertices.row((e + 1) % polygon.vertices.rows()) -
                                   polygon.vertices.row(e))
                                      .norm());
    for (const double gamma : {1e-2, 1e-3, 1e-4, 1e-5}) {
      std::ranges::fill(polygon.gamma, gamma);
      const double distance = distanceToPolygon(polygon, first, last);
      EXPECT_LT(distance, gamma * longest);
      if (gamma < 1e-2 && before > 1e-9) {
        // Proportional to gamma as it goes to 0, the later the shorter an edge is.
        EXPECT_NEAR(distance / before, 0.1, 0.05) << i << " gamma " << gamma;
      }
      before = distance;
    }
    if (polygon.closed) continue;
    HomogeneousPoles limit = test::homogeneous(polygon.vertices.topRows<4>());
    limit.row(3) = limit.row(2);
    EXPECT_LT((gammaSpline(polygon).poles.topRows<4>() - limit).norm(), 1e-5 * 4 * longest);
  }
}

/// The printed ends, alpha_0 = 0 and b_{3L-4} = d_{L-1}: there is no such pole, and alpha_0 belongs
/// to an edge without segment. What holds is alpha_1 = 0, b_{3L-7} = d_{L-1}, b_{3L-6} = d_L (C5.2
/// of docs/theory/curves.md).
TEST(G2Spline, PrintedEndIndicesAreFalse) {
  std::mt19937_64 random(testSeed());
  for (int i = 1; i < 100; i += 2) {
    G2Polygon polygon = randomPolygon(i, random);
    const BezierSpline spline = directG2Spline(polygon);
    const Eigen::Index L = polygon.vertices.rows() - 1;
    EXPECT_LT(spline.poles.rows() - 1, 3 * L - 4);
    EXPECT_EQ(spline.poles.row(1).head<3>(), polygon.vertices.row(1));
    EXPECT_EQ(spline.poles.row(3 * L - 7).head<3>(), polygon.vertices.row(L - 1));
    EXPECT_EQ(spline.poles.row(3 * L - 6).head<3>(), polygon.vertices.row(L));
    EXPECT_EQ(spline.poles.row(0).head<3>(), polygon.vertices.row(0));
    polygon.alpha.front() = polygon.alpha[1] = nan;
    polygon.omega.back() = polygon.omega[L - 2] = nan;
    EXPECT_EQ(directG2Spline(polygon), spline);
  }
}

/// The printed omega of gamma-splines is 1 - alpha. Unless lengths and gamma are symmetric the
/// joint then divides its leg in another ratio than that of the lengths, and gamma = 1 is not the
/// B-spline (C5.4).
TEST(G2Spline, PrintedGammaOmegaIsFalse) {
  GammaPolygon polygon{Poles(5, 3), true, {1, 1.2, 1.1, 1, 1.3}, {1, 1, 1, 1, 1}};
  polygon.vertices << 0, 0, 0, 4, 0, 0, 5, 3, 0, 2, 5, 0, -1, 3, 0;
  G2Polygon printed = g2Polygon(polygon);
  for (int e = 0; e < 5; ++e) printed.omega[e] = 1 - printed.alpha[e];
  const BezierSpline right = gammaSpline(polygon), wrong = directG2Spline(printed);
  const auto ratio = [](const BezierSpline& spline, int joint) {
    const Beside at = beside(spline, joint);
    return (at.joint - at.b2).norm() / (at.c1 - at.joint).norm();
  };
  double worst = 0;
  for (int s = 0; s < 5; ++s) {
    const double wanted = polygon.lengths[(s + 4) % 5] / polygon.lengths[s];
    EXPECT_NEAR(ratio(right, s), wanted, 1e-14);
    worst = std::max(worst, std::abs(ratio(wrong, s) / wanted - 1));
  }
  EXPECT_GT(worst, 0.1);
  EXPECT_GT((wrong.poles - right.poles).norm(), 0.1);
}

TEST(G2Spline, RefusesBadPolygons) {
  Poles vertices(5, 3);
  vertices << 0, 0, 0, 4, 0, 0, 5, 3, 0, 2, 5, 0, -1, 3, 0;
  const G2Polygon good{vertices, true, std::vector<double>(5, 0.3), std::vector<double>(5, 0.7)};
  EXPECT_EQ(directG2Spline(good).segments(), 5);
  const auto refused = [&](auto change, const std::string& part) {
    G2Polygon bad = good;
    change(bad);
    expectRefused([&] { directG2Spline(bad); }, part);
  };
  refused([](G2Polygon& p) { p.vertices = p.vertices.topRows<2>().eval(); },
          "vertices are 2: a closed polygon needs 3");
  refused([](G2Polygon& p) { p.vertices.resize(0, 3); }, "vertices are 0");
  refused(
      [](G2Polygon& p) {
        p.closed = false;
        p.vertices = p.vertices.topRows<3>().eval();
      },
      "vertices are 3: an open polygon needs 4");
  refused([](G2Polygon& p) { p.closed = false; }, "alpha are 5: one for each of 4 edges");
  refused([](G2Polygon& p) { p.omega.pop_back(); }, "omega are 4: one for each of 5 edges");
  refused([](G2Polygon& p) { p.vertices(3, 1) = nan; }, "vertex 3 is not finite");
  refused([](G2Polygon& p) { p.vertices.row(3) = p.vertices.row(2); },
          "edge 2 has no length: vertices 2 and 3");
  refused([](G2Polygon& p) { p.vertices.row(4) = p.vertices.row(0); },
          "edge 4 has no length: vertices 4 and 0");
  refused([](G2Polygon& p) { p.alpha[2] = nan; }, "alpha of edge 2 is nan");
  refused([](G2Polygon& p) { p.alpha[2] = 0; },
          "alpha of edge 2 is 0: it must lie between 0 and 1");
  refused([](G2Polygon& p) { p.alpha[2] = -0.1; }, "alpha of edge 2 is -0.1");
  refused([](G2Polygon& p) { p.omega[4] = 1; },
          "omega of edge 4 is 1: it must lie between 0 and 1");
  refused([](G2Polygon& p) { p.omega[4] = std::numeric_limits<double>::infinity(); },
          "omega of edge 4 is inf");
  refused([](G2Polygon& p) { p.omega[1] = p.alpha[1]; }, "alpha must be the smaller one");
  refused([](G2Polygon& p) { p.omega[1] = 0.25; }, "alpha must be the smaller one");
}

TEST(G2Spline, FoldsAreRefusedAndLinesStayStraight) {
  Poles vertices(4, 3);
  vertices << 0, 0, 0, 2, 0, 0, 1, 0, 0, 1, 3, 0;
  G2Polygon polygon{vertices, true, std::vector<double>(4, 0.5), std::vector<double>(4, 0.75)};
  expectRefused([&] { directG2Spline(polygon); }, "vertex 1: the polygon folds back");
  polygon.alpha[1] = 0.25;
  for (const CurveJoint& joint : measureJoints(directG2Spline(polygon), 2))
    EXPECT_LT(joint.differences[2], 1e-12);
  vertices << 0, 0, 0, 1, 2, 3, 2, 4, 6, 4, 8, 12;
  const BezierSpline line = directG2Spline({vertices, false, {0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(line.segments(), 1);
  EXPECT_LT(derivatives(line, 0.3, 2).row(2).cross(Eigen::RowVector3d(1, 2, 3)).norm(), 1e-14);
}

TEST(G2Spline, RefusesBadGamma) {
  Poles vertices(5, 3);
  vertices << 0, 0, 0, 4, 0, 0, 5, 3, 0, 2, 5, 0, -1, 3, 0;
  const GammaPolygon good{vertices, false, {1, 2}, {nan, 0.5}};
  EXPECT_EQ(gammaSpline(good).knots, (std::vector<double>{0, 1, 3}));
  const auto refused = [&](auto change, const std::string& part) {
    GammaPolygon bad = good;
    change(bad);
    expectRefused([&] { gammaSpline(bad); }, part);
  };
  refused([](GammaPolygon& p) { p.gamma[1] = 0; }, "gamma 1 is 0: it must be positive");
  refused([](GammaPolygon& p) { p.gamma[1] = -1; }, "gamma 1 is -1");
  refused([](GammaPolygon& p) { p.gamma[1] = nan; }, "gamma 1 is nan");
  refused([](GammaPolygon& p) { p.gamma[1] = 1e-40; }, "omega of edge 1 is 1");
  refused([](GammaPolygon& p) { p.lengths[0] = 0; }, "length 0 is 0");
  refused([](GammaPolygon& p) { p.lengths[0] = std::numeric_limits<double>::infinity(); },
          "length 0 is inf");
  refused([](GammaPolygon& p) { p.lengths.push_back(1); },
          "lengths are 3: one for each of 2 segments");
  refused([](GammaPolygon& p) { p.gamma.clear(); }, "gamma are 0: one for each of 2 segments");
  refused([](GammaPolygon& p) { p.vertices(0, 0) = nan; }, "vertex 0 is not finite");
  expectRefused([&] { g2Polygon({vertices.topRows<2>(), true, {}, {}}); }, "vertices are 2");
}

/// The inner poles beside a vertex are one but for rounding, or just not.
TEST(G2Spline, FoldsAreToldFromSharpTurns) {
  for (const double turn : {4e-16, 1e-13}) {
    G2Polygon polygon{Poles(5, 3), false, std::vector<double>(4, 1.0 / 3),
                      std::vector<double>(4, 2.0 / 3)};
    // Edge 2 goes back along edge 1.
    polygon.vertices << 0, 0, 0, 0, 1, 0, 3, 1, 0, 0, 1 + 3 * turn, 0, 0, 2, 0;
    const auto make = [&] { directG2Spline(polygon); };
    if (turn < 1e-14)
      EXPECT_THROW(make(), std::invalid_argument);
    else
      EXPECT_NO_THROW(make());
  }
}

/// Its knots add lengths up: what shrinks loses digits there, not in the curve.
TEST(G2Spline, ShrinkingLengthsLoseDigitsInTheKnots) {
  GammaPolygon polygon{Poles(6, 3), false, {1, 1e-3, 1e6}, {1, 1, 1}};
  polygon.vertices << 0, 0, 0, 1, 2, 0, 3, 3, 1, 5, 1, 0, 7, 2, 2, 9, 0, 0;
  EXPECT_EQ(continuity(gammaSpline(polygon)), 2);
  polygon.lengths = {1e6, 1e-3, 1};
  const BezierSpline spline = gammaSpline(polygon);
  EXPECT_LT(continuity(spline), 2);
  for (const CurveJoint& joint : measureJoints(spline, 2)) EXPECT_GE(orderReached(joint, {}), 1);
}

}  // namespace
}  // namespace seamwright
