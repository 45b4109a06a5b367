// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <seamwright/core/fair/fair_hermite.hpp>
#include <seamwright/core/planar/clothoid.hpp>

#include "dense_variation.hpp"
#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Index;
using std::numbers::pi;
using test::number;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Eigen::Vector3d randomVector(std::mt19937_64& random, bool planar) {
  return {uniform(random, -3, 3), uniform(random, -3, 3), planar ? 0 : uniform(random, -3, 3)};
}

MatrixCurve randomCurve(int degree, int count, bool planar, std::mt19937_64& random) {
  MatrixCurve curve{.degree = degree, .knots = {}, .poles = {}};
  curve.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
  for (int i = 1; i < count - degree; ++i) curve.knots.push_back(i + uniform(random, -0.3, 0.3));
  curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(degree) + 1, count - degree);
  for (int i = 0; i < count; ++i)
    curve.poles.push_back({.point = randomVector(random, planar),
                           .tangent = randomVector(random, planar),
                           .weight = uniform(random, 0.3, 3),
                           .stiffness = i % 4 == 0 ? 0 : std::exp(uniform(random, -2, 4))});
  return curve;
}

double parameterOf(const MatrixCurve& curve, double share) {
  return curve.knots.front() + share * (curve.knots.back() - curve.knots.front());
}

Eigen::Vector3d pointOf(const MatrixCurve& curve, double share) {
  return pointAndTangent(curve, parameterOf(curve, share)).row(0).transpose();
}

Eigen::Vector3d spatialVector(const nlohmann::json& value) {
  return {number(value[0]), number(value[1]), value.size() > 2 ? number(value[2]) : 0};
}

TEST(MatrixCurve, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("matrix_curves.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const std::size_t count = in["P"].size();
    MatrixCurve curve{.degree = static_cast<int>(count) - 1, .knots = {}, .poles = {}};
    curve.knots.assign(count, 0.0);
    curve.knots.insert(curve.knots.end(), count, 1.0);
    for (std::size_t i = 0; i < count; ++i)
      curve.poles.push_back({.point = spatialVector(in["P"][i]),
                             .tangent = spatialVector(in["tangent"][i]),
                             .weight = number(in["omega"][i]),
                             .stiffness = number(in["mu"][i])});
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < in["P"][i].size(); ++k)
        for (std::size_t l = 0; l < in["P"][i].size(); ++l)
          EXPECT_NEAR(curve.poles[i].matrix()(Index(k), Index(l)), number(out["M"][i][k][l]),
                      1e-13 * (1 + number(in["mu"][i])));
    // The solution loses the digits of the stiffness.
    double rounding = 1e-11;
    for (const MatrixPole& pole : curve.poles) rounding += 1e-15 * pole.stiffness;
    EXPECT_LT((pointOf(curve, number(in["t"])) - spatialVector(out["value"])).norm(), rounding);
    const BezierSpline rational = bezierSpline(curve);
    ASSERT_EQ(std::size_t(rational.poles.rows()), out["weights"].size());
    const double scale = number(out["weights"][0]) / rational.poles(0, 3);
    for (Index i = 0; i < rational.poles.rows(); ++i) {
      const Eigen::Vector4d pole = rational.poles.row(i);
      const double weight = number(out["weights"][std::size_t(i)]);
      EXPECT_NEAR(pole.w() * scale, weight, rounding * weight);
      EXPECT_LT((pole.hnormalized() - spatialVector(out["points"][std::size_t(i)])).norm(),
                rounding);
    }
  }
}

// Identity (1).
TEST(MatrixCurve, WithoutStiffnessIsRational) {
  std::mt19937_64 random(testSeed());
  MatrixCurve curve = randomCurve(3, 9, false, random);
  BSplineCurve plain{3, curve.knots, HomogeneousPoles(9, 4)};
  for (Index i = 0; i < 9; ++i) {
    curve.poles[std::size_t(i)].stiffness = 0;
    const MatrixPole& pole = curve.poles[std::size_t(i)];
    plain.poles.row(i) << pole.weight * pole.point.transpose(), pole.weight;
  }
  for (int i = 0; i <= 100; ++i) {
    const double t = parameterOf(curve, i / 100.0);
    EXPECT_LT((pointAndTangent(curve, t) - derivatives(plain, t, 1)).norm(), 1e-12);
  }
}

// Identity (2), by differences of the sum.
TEST(MatrixCurve, PointsAreLeast) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 40; ++i) {
    const MatrixCurve bezier = [&] {
      MatrixCurve curve = randomCurve(3, 4, false, random);
      curve.knots = {0, 0, 0, 0, 1, 1, 1, 1};
      return curve;
    }();
    const double t = uniform(random, 0, 1), s = 1 - t;
    const std::array<double, 4> basis = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    const auto sum = [&](const Eigen::Vector3d& x) {
      double total = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const MatrixPole& pole = bezier.poles[k];
        const Eigen::Vector3d d = x - pole.point;
        total +=
            basis[k] * pole.weight *
            (d.squaredNorm() + pole.stiffness * d.cross(pole.tangent.normalized()).squaredNorm());
      }
      return total;
    };
    const Eigen::Vector3d x = pointOf(bezier, t);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = 1e-3 * Eigen::Vector3d::Unit(axis);
      EXPECT_NEAR((sum(x + step) - sum(x - step)) / sum(x), 0, 1e-10);
    }
    // The derivative too.
    const double h = 1e-5;
    const Eigen::Vector3d slope = (pointOf(bezier, t + h) - pointOf(bezier, t - h)) / (2 * h);
    EXPECT_LT((pointAndTangent(bezier, t).row(1).transpose() - slope).norm(),
              1e-5 * slope.norm() + 1e-6);
  }
}

// Identity (3).
TEST(MatrixCurve, KeepsLinesAndFollowsMotionAndScale) {
  std::mt19937_64 random(testSeed());
  MatrixCurve line = randomCurve(3, 8, false, random);
  const Eigen::Vector3d from(1, 2, 3), along = Eigen::Vector3d(2, -1, 1).normalized();
  for (MatrixPole& pole : line.poles) {
    pole.point = from + uniform(random, -5, 5) * along;
    pole.tangent = 3 * along;
  }
  const MatrixCurve curve = randomCurve(4, 8, false, random);
  MatrixCurve other = curve;
  const Eigen::Matrix3d turn =
      2.5 * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (MatrixPole& pole : other.poles) {
    pole.point = turn * pole.point + from;
    pole.tangent = turn * pole.tangent;
    pole.weight *= 7;
  }
  for (int i = 0; i <= 50; ++i) {
    EXPECT_LT((pointOf(line, i / 50.0) - from).cross(along).norm(), 1e-13);
    const Eigen::Vector3d moved = turn * pointOf(curve, i / 50.0) + from;
    EXPECT_LT((pointOf(other, i / 50.0) - moved).norm(), 1e-12);
  }
}

// Identity (4).
TEST(MatrixCurve, IsARationalCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 40; ++i) {
    const bool planar = i % 2 == 0;
    const int degree = 1 + static_cast<int>(random() % 4);
    MatrixCurve curve =
        randomCurve(degree, degree + 1 + static_cast<int>(random() % 6), planar, random);
    const BezierSpline rational = bezierSpline(curve);
    EXPECT_EQ(rational.degree, degree * (planar ? 2 : 3));
    EXPECT_GT(rational.poles.col(3).minCoeff(), 0);
    const BSplineCurve spline = bsplineCurve(curve);
    for (std::size_t k = 0; k < spline.knots.size(); ++k)
      if (spline.knots[k] > spline.knots.front() && spline.knots[k] < spline.knots.back()) {
        EXPECT_EQ(std::count(spline.knots.begin(), spline.knots.end(), spline.knots[k]),
                  rational.degree - degree + 1);
      }
    for (int k = 0; k <= 60; ++k) {
      const double t = parameterOf(curve, k / 60.0);
      const CurveDerivatives wanted = pointAndTangent(curve, t);
      EXPECT_LT((derivatives(rational, t, 1) - wanted).norm(), 1e-9 * (1 + wanted.norm()));
      EXPECT_LT((derivatives(spline, t, 0) - wanted.row(0)).norm(), 1e-9);
    }
  }
  MatrixCurve curve = randomCurve(9, 10, false, random);
  EXPECT_THAT([&] { bezierSpline(curve); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the degree 27")));
}

TEST(MatrixCurve, RefusesInvalidNumbers) {
  std::mt19937_64 random(testSeed());
  const MatrixCurve curve = randomCurve(3, 6, true, random);
  const auto refused = [&](const auto& change, const char* text) {
    MatrixCurve other = curve;
    change(other);
    EXPECT_THAT([&] { requireValid(other); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused([](MatrixCurve& c) { c.poles[2].stiffness = -1; }, "the stiffness of pole 2 is -1");
  refused([](MatrixCurve& c) { c.poles[2].stiffness = 2e8; }, "the stiffness of pole 2");
  refused([](MatrixCurve& c) { c.poles[1].tangent.setZero(); }, "pole 1 has a stiffness");
  refused([](MatrixCurve& c) { c.poles[3].weight = 0; }, "weight");
  refused([](MatrixCurve& c) { c.poles.pop_back(); }, "");
  EXPECT_THAT([&] { pointAndTangent(curve, NAN); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the parameter is nan")));
}

/// Points of an ellipse or a helix, at parameters that are moved by up to the spread of their
/// distance, with tangents.
HermitePoints arm(Index count, bool planar, double spread, std::mt19937_64& random) {
  HermitePoints data{.points = Poles(count, 3), .tangents = Poles(count, 3)};
  for (Index i = 0; i < count; ++i) {
    const double t = 4 * (double(i) + uniform(random, -spread, spread)) / double(count - 1);
    data.points.row(i) << 5 * std::cos(t), 3 * std::sin(t), planar ? 0 : t;
    data.tangents.row(i) << -5 * std::sin(t), 3 * std::cos(t), planar ? 0 : 1;
  }
  return data;
}

HermitePoints noisyArm(Index count, bool planar, double noise_mm, std::mt19937_64& random) {
  HermitePoints data = arm(count, planar, 0.1, random);
  for (Index i = 0; i < count; ++i)
    data.points.row(i) += noise_mm / 3 * randomVector(random, planar).transpose();
  return data;
}

// Identity (1) of fitHermite().
TEST(HermiteFit, MeetsThePoints) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const bool planar = i % 2 == 0;
    const HermitePoints data = arm(30, planar, 0.3, random);
    const MatrixFit found =
        fitHermite(data, {.degree = 2 + i % 3, .stiffness = std::array{0.0, 1.0, 8.0}[i % 3]});
    EXPECT_LT(found.missed_mm, 1e-12);
    EXPECT_LT(found.missed_tangent_rad, 0.15);
    for (Index k = 0; k < 30; ++k)
      EXPECT_LT(
          (pointAndTangent(found.curve, found.parameters(k)).row(0) - data.points.row(k)).norm(),
          1e-12);
  }
}

// Identity (2) of fitHermite(): the curve moves along.
TEST(HermiteFit, FollowsMotionAndScale) {
  std::mt19937_64 random(testSeed());
  const HermitePoints data = arm(20, false, 0.3, random);
  const Eigen::Matrix3d turn =
      2 * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const HermitePoints other{.points = (data.points * turn).rowwise() + Eigen::RowVector3d(1, 2, 3),
                            .tangents = data.tangents * turn};
  const MatrixFit found = fitHermite(data), moved = fitHermite(other);
  for (int i = 0; i <= 50; ++i) {
    const Eigen::RowVector3d wanted =
        pointOf(found.curve, i / 50.0).transpose() * turn + Eigen::RowVector3d(1, 2, 3);
    EXPECT_LT((pointOf(moved.curve, i / 50.0).transpose() - wanted).norm(), 1e-12);
  }
}

// Identities (3) and (4) of fairHermite().
TEST(FairHermite, StaysWithinTheToleranceAndIsFairer) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 8; ++i) {
    const bool planar = i % 2 == 0;
    const HermitePoints data = noisyArm(30, planar, 0.01, random);
    const double tolerance = i % 4 < 2 ? 0.02 : 0.005;
    const FairedHermite found = fairHermite(data, tolerance, {.fair_tangents = i % 3 != 0});
    const Eigen::VectorXd moves = (found.data.points - data.points).rowwise().norm();
    EXPECT_LE(moves.maxCoeff(), tolerance);
    EXPECT_EQ(moves.maxCoeff(), found.moved_mm);
    EXPECT_EQ(found.data.points.row(0), data.points.row(0));
    EXPECT_EQ(found.data.points.row(29), data.points.row(29));
    EXPECT_LT(found.after.energy_per_mm3, 0.7 * found.before.energy_per_mm3);
    EXPECT_LT(found.fit.missed_mm, 1e-12);
    EXPECT_EQ(found.addedInflections(),
              std::max(0, found.after.inflections - found.before.inflections));
    const FairedHermite same = fairHermite(data, 0);
    EXPECT_EQ(same.data.points, data.points);
    EXPECT_EQ(same.data.tangents, data.tangents);
  }
}

// Identity (4) of fairHermite(): for points without order the curves nearly stop.
TEST(FairHermite, TheVariationOfWildPointsDoesNotGrow) {
  std::mt19937_64 random(testSeed());
  const auto sampled = [](const MatrixCurve& curve) {
    const BezierSpline spline = bezierSpline(curve);
    constexpr int samples = 2000;
    double sum = 0;
    for (int i = 0; i < spline.segments(); ++i) {
      const BezierCurve one = segment(spline, i);
      for (int k = 0; k < samples; ++k) {
        const CurveDerivatives at = one.derivatives((k + 0.5) / samples, 3);
        sum += test::frenetDensity(at.row(1), at.row(2), at.row(3)) / samples;
      }
    }
    return sum;
  };
  int faired = 0;
  for (int i = 0; i < 20; ++i) {
    HermitePoints data{.points = Poles::Zero(6, 3), .tangents = Poles::Zero(6, 3)};
    for (int k = 0; k < 6; ++k)
      for (int axis = 0; axis < 2; ++axis) {
        data.points(k, axis) = uniform(random, 0, 10);
        data.tangents(k, axis) = uniform(random, -1, 1);
      }
    const FairedHermite found = fairHermite(data, 2);
    const double before = sampled(fitHermite(data).curve), after = sampled(found.fit.curve);
    EXPECT_LE(after, before * 1.001) << i;
    EXPECT_LE(found.after.energy_per_mm3, found.before.energy_per_mm3);
    if (found.passes > 0) ++faired;
  }
  EXPECT_GT(faired, 5);
}

// Identity (5) of fairHermite().
TEST(FairHermite, CirclesStayAndWithoutStiffnessMeansAreTaken) {
  std::mt19937_64 random(testSeed());
  const double step = 0.2;
  HermitePoints data{.points = Poles(15, 3), .tangents = Poles(15, 3)};
  for (Index i = 0; i < 15; ++i) {
    const double angle = step * double(i);
    data.points.row(i) << 4 * std::cos(angle), 4 * std::sin(angle), 1;
    data.tangents.row(i) << -std::sin(angle), std::cos(angle), 0;
  }
  const HermitePoints circle = matrixPass(data, 1 / std::cos(step), true);
  EXPECT_LT((circle.points - data.points).norm(), 1e-13);
  EXPECT_LT((circle.tangents - data.tangents).norm(), 1e-13);
  const HermitePoints means = matrixPass(data, 0, false);
  for (Index i = 1; i < 14; ++i) {
    const Eigen::RowVector3d wanted =
        (data.points.row(i - 1) + 4 * data.points.row(i) + data.points.row(i + 1)) / 6;
    EXPECT_LT((means.points.row(i) - wanted).norm(), 1e-14);
  }
}

TEST(FairHermite, RefusesInvalidNumbers) {
  std::mt19937_64 random(testSeed());
  const HermitePoints data = arm(9, true, 0, random);
  const auto refused = [](const auto& call, const char* text) {
    EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused([&] { fairHermite(data, -1); }, "the tolerance is -1 mm");
  refused([&] { fairHermite(data, 1, {.most_passes = -1}); }, "-1 passes");
  refused([&] { fitHermite(data, {.degree = 9}); }, "9 points make no curve of degree 9");
  refused([&] { fitHermite(data, {.stiffness = -1}); }, "the stiffness of pole 0");
  refused([&] { matrixPass(data, -1, true); }, "the stiffness is -1");
  HermitePoints fewer = data;
  fewer.tangents.conservativeResize(8, 3);
  refused([&] { matrixPass(fewer, 1, true); }, "8 tangents for 9 points");
  HermitePoints bad = data;
  bad.points.row(4) = bad.points.row(3);
  refused([&] { fitHermite(bad); }, "points 3 and 4 are equal");
  bad.points(4, 0) = NAN;
  refused([&] { fitHermite(bad); }, "point 4 is (nan");
  bad = data;
  bad.tangents.row(2).setZero();
  refused([&] { fitHermite(bad); }, "point 2 is");
  bad.tangents = bad.tangents.topRows(8).eval();
  refused([&] { fitHermite(bad); }, "8 tangents for 9 points");
}

// Identities (1) and (2) of variationOf().
TEST(CurvatureVariation, OfAClothoidIsItsSlope) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    const Clothoid curve = clothoid(
        test::endsWith(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.5, 5)));
    const BezierSpline spline = bezierSpline({curve}, 1e-11 * curve.length_mm, false, 0).curve;
    const double wanted =
        curve.curvature_slope_per_mm2 * curve.curvature_slope_per_mm2 * curve.length_mm;
    const CurvatureVariation found = variationOf(spline);
    EXPECT_NEAR(found.energy_per_mm3 / wanted, 1, 1e-4);  // the spline is near the clothoid
    EXPECT_EQ(found.inflections,
              curve.curvature_per_mm * curve.curvatureAt_per_mm(curve.length_mm) < 0 ? 1 : 0);
    BezierSpline other = spline;
    const Eigen::Matrix3d turn =
        4 * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    other.poles.leftCols<3>() = spline.poles.leftCols<3>() * turn;
    EXPECT_NEAR(variationOf(other).energy_per_mm3 * 64 / found.energy_per_mm3, 1, 1e-9);
  }
}

}  // namespace
}  // namespace seamwright
