// SPDX-License-Identifier: LGPL-2.1-or-later
// Umbrellas with a given outer boundary or with weights: against what they promise.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "support/random.hpp"
#include "umbrellas.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::uniform;
using test::whole;
using testing::HasSubstr;
using testing::ThrowsMessage;

Eigen::Vector3d endDerivative(const BezierCurve& curve) {
  return curve.derivatives(1, 1).row(1).transpose();
}

/// A cubic edge from a point, with that derivative there, to another point.
BezierCurve edgeFrom(const Eigen::Vector3d& begin, const Eigen::Vector3d& derivative,
                     const Eigen::Vector3d& end, std::mt19937_64& random) {
  Poles poles(4, 3);
  poles.row(0) = begin.transpose();
  poles.row(1) = (begin + derivative / 3).transpose();
  poles.row(3) = end.transpose();
  for (int c = 0; c < 3; ++c) poles(2, c) = (begin(c) + 2 * end(c)) / 3 + uniform(-1, 1, random);
  return BezierCurve(poles);
}

/// A boundary for patches around spokes: at the end of each spoke both edges set out in one tangent
/// plane with it, to either side.
std::vector<MemberBoundary> randomBoundary(const std::vector<BezierCurve>& spokes, bool closed,
                                           std::mt19937_64& random) {
  const std::size_t n = spokes.size(), m = closed ? n : n - 1;
  std::vector<Eigen::Vector3d> u(n), v(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d along = endDerivative(spokes[i]),
                          to = spokes[(i + 1) % n].point(1) - spokes[i].point(1),
                          normal = along.cross(to).normalized(),
                          left = normal.cross(along).normalized();
    v[i] = uniform(4, 8, random) * left + uniform(-0.4, 0.4, random) * along;
    u[i] = -uniform(4, 8, random) * left + uniform(-0.4, 0.4, random) * along;
  }
  std::vector<MemberBoundary> boundary;
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t next = (i + 1) % n;
    const Eigen::Vector3d corner =
        spokes[i].point(1) + spokes[next].point(1) - spokes[i].point(0) +
        Eigen::Vector3d(uniform(-1, 1, random), uniform(-1, 1, random), uniform(-1, 1, random));
    boundary.push_back({edgeFrom(spokes[i].point(1), v[i], corner, random),
                        edgeFrom(spokes[next].point(1), u[next], corner, random)});
  }
  return boundary;
}

/// Largest distance of the outer edges from the given ones, over points.
double boundaryDistance(const Umbrella& umbrella, const std::vector<MemberBoundary>& boundary) {
  double worst = 0;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const BezierPatch& patch = std::get<BezierPatch>(umbrella.members[i]);
    for (int k = 0; k <= 16; ++k) {
      const double t = k / 16.0;
      if (boundary[i].from_first)
        worst = std::max(worst, (patch.point(1, t) - boundary[i].from_first->point(t)).norm());
      if (boundary[i].from_second)
        worst = std::max(worst, (patch.point(t, 1) - boundary[i].from_second->point(t)).norm());
      if (boundary[i].across_first)
        worst = std::max(worst, (patch.jet(1, t).u - boundary[i].across_first->point(t)).norm());
      if (boundary[i].across_second)
        worst = std::max(worst, (patch.jet(t, 1).v - boundary[i].across_second->point(t)).norm());
    }
  }
  return worst;
}

TEST(UmbrellaBoundary, Identity6IsKept) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 40; ++run) {
    const bool closed = run % 4 != 0;
    const int count = 3 + run % 6;
    UmbrellaOptions options;
    options.closed = closed;
    const std::vector<BezierCurve> first =
        test::randomSpokes(closed ? count : std::max(4, count), closed, 3, random);
    // Even fans move their spokes first.
    const std::vector<BezierCurve> spokes = umbrellaAround(first, options).spokes;
    options.boundary = randomBoundary(spokes, closed, random);
    const Umbrella found = umbrellaAround(spokes, options);
    EXPECT_LE(boundaryDistance(found, options.boundary), 1e-12) << run;
    EXPECT_LE(test::worstLaw(found), 1e-11) << run;
    EXPECT_LE(found.largest_spoke_move_mm, 1e-12) << run;
  }
}

/// The outer edges of patches, and the derivatives across them.
std::vector<MemberBoundary> boundaryOf(const Umbrella& umbrella) {
  std::vector<MemberBoundary> boundary;
  for (const UmbrellaMember& member : umbrella.members) {
    const BezierPatch& patch = std::get<BezierPatch>(member);
    const int n = patch.degreeU();
    Poles first(n + 1, 3), second(n + 1, 3), across_first(n + 1, 3), across_second(n + 1, 3);
    for (int k = 0; k <= n; ++k) {
      first.row(k) = patch.pole(n, k).transpose();
      second.row(k) = patch.pole(k, n).transpose();
      across_first.row(k) = n * (patch.pole(n, k) - patch.pole(n - 1, k)).transpose();
      across_second.row(k) = n * (patch.pole(k, n) - patch.pole(k, n - 1)).transpose();
    }
    boundary.push_back({BezierCurve(first), BezierCurve(second), BezierCurve(across_first),
                        BezierCurve(across_second)});
  }
  return boundary;
}

TEST(UmbrellaBoundary, Identity6DerivativesAcrossAreKept) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 12; ++run) {
    UmbrellaOptions options;
    options.closed = run % 4 != 0;
    const Umbrella first =
        umbrellaAround(test::randomSpokes(4 + run % 4, options.closed, 3, random), options);
    options.boundary = boundaryOf(first);
    // The rest is free, and the law is that of the first one: of a higher degree by its freedom.
    const Umbrella found = umbrellaAround(first.spokes, options);
    EXPECT_LE(boundaryDistance(found, options.boundary), 1e-11) << run;
    EXPECT_LE(test::worstLaw(found), 1e-11) << run;
    options.members = first.members;
    EXPECT_LE(umbrellaAround(first.spokes, options).largest_member_move_mm, 1e-9) << run;
    // Another mixed derivative at the end of spoke 1, along the normal, contradicts.
    Poles poles = options.boundary[1].across_first->poles();
    poles.row(1) += first.vertex.normal.transpose();
    options.boundary[1].across_first = BezierCurve(poles);
    EXPECT_THAT([&] { umbrellaAround(first.spokes, options); },
                ThrowsMessage<std::invalid_argument>(
                    HasSubstr("beside the end of spoke 1 have no common mixed derivative")))
        << run;
  }
}

TEST(UmbrellaBoundary, TrianglesKeepTheirOuterEdge) {
  std::mt19937_64 random(testSeed());
  UmbrellaOptions options;
  options.kinds.assign(5, MemberKind::Triangle);
  const Umbrella first = umbrellaAround(test::randomSpokes(5, true, 3, random), options);
  for (const UmbrellaMember& member : first.members) {
    const BezierTriangle& triangle = std::get<BezierTriangle>(member);
    const int n = triangle.degree();
    Poles edge(n + 1, 3);
    for (int k = 0; k <= n; ++k)
      edge.row(k) = triangle.poles().row(BezierTriangle::row(n, n - k, k));
    edge.row(2) += Eigen::RowVector3d(0.3, -0.2, 0.5);
    options.boundary.push_back({BezierCurve(edge), {}, {}, {}});
  }
  const Umbrella found = umbrellaAround(first.spokes, options);
  EXPECT_LE(test::worstLaw(found), 1e-11);
  EXPECT_LE(test::certifiedAngle(found), 1e-9);
  for (int i = 0; i < 5; ++i) {
    const BezierTriangle& triangle = std::get<BezierTriangle>(found.members[i]);
    for (int k = 0; k <= 8; ++k) {
      const double t = k / 8.0;
      EXPECT_LE((triangle.point(1 - t, t) - options.boundary[i].from_first->point(t)).norm(),
                1e-12);
    }
  }
}

TEST(UmbrellaBoundary, SomeEdgesMayBeFree) {
  std::mt19937_64 random(testSeed());
  UmbrellaOptions options;
  const std::vector<BezierCurve> spokes =
      umbrellaAround(test::randomSpokes(6, true, 3, random)).spokes;
  options.boundary = randomBoundary(spokes, true, random);
  options.boundary[2] = {};
  options.boundary[4].from_second.reset();
  const Umbrella found = umbrellaAround(spokes, options);
  EXPECT_LE(boundaryDistance(found, options.boundary), 1e-12);
  EXPECT_LE(test::worstLaw(found), 1e-11);
  EXPECT_LE(test::certifiedAngle(found), 1e-9);
}

// Weights.

/// Cubic spokes with weights, at nearly equal angles.
std::vector<BezierCurve> weightedSpokes(int count, double around, std::mt19937_64& random) {
  std::vector<BezierCurve> result;
  for (int i = 0; i < count; ++i) {
    const double angle = (i + uniform(-0.1, 0.1, random)) * around / count;
    Poles poles(4, 3);
    Eigen::VectorXd weights(4);
    for (int k = 0; k < 4; ++k) {
      poles.row(k) << 3 * k * std::cos(angle), 3 * k * std::sin(angle), -0.1 * k * (k - 1);
      weights(k) = 1 - 0.03 * k + uniform(-0.01, 0.01, random);
    }
    result.emplace_back(poles, weights);
  }
  return result;
}

TEST(UmbrellaWeights, RationalSpokesJoinWithCertainty) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 10; ++run) {
    UmbrellaOptions options;
    options.closed = run % 4 != 0;
    const int count = 3 + run % 5;
    const std::vector<BezierCurve> spokes =
        weightedSpokes(count, options.closed ? 2 * pi : 3, random);
    const Umbrella found = umbrellaAround(spokes, options);
    for (int i = 0; i < count; ++i) {
      const double allowed = 2 * found.largest_spoke_move_mm + 1e-12;
      for (int k = 0; k <= 8; ++k)
        EXPECT_LE((found.spokes[i].point(k / 8.0) - spokes[i].point(k / 8.0)).norm(), allowed)
            << run;
      if (!found.vertex.isInner(i)) continue;
      const UmbrellaMember &before = found.members[found.vertex.memberBefore(i)],
                           &behind = found.members[i];
      EXPECT_TRUE(std::visit([](const auto& m) { return m.isRational(); }, behind)) << run;
      EXPECT_EQ(joinCondition(test::ribbonBefore(before), test::ribbonAfter(behind)).verdict,
                JoinVerdict::G1)
          << run << " " << i;
    }
    EXPECT_LE(test::certifiedAngle(found), 1e-8) << run;
  }
}

/// The image under w -> w + c (P - O), which keeps O.
template <class Shape>
HomogeneousPoles projected(const Shape& shape, const Eigen::RowVector3d& origin,
                           const Eigen::Vector3d& c) {
  HomogeneousPoles poles = shape.homogeneousPoles();
  const Eigen::MatrixXd about = poles.leftCols<3>() - poles.col(3) * origin;
  poles.col(3) += about * c;
  poles.leftCols<3>() = about + poles.col(3) * origin;
  return poles;
}

TEST(UmbrellaWeights, Identity7ProjectiveMapsComeBack) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 12; ++run) {
    UmbrellaOptions options;
    const Umbrella first = umbrellaAround(test::randomSpokes(3 + run % 5, true, 3, random));
    const Eigen::RowVector3d origin = first.spokes[0].point(0).transpose();
    const Eigen::Vector3d c(0.01, -0.015, 0.008);
    std::vector<BezierCurve> spokes;
    for (const BezierCurve& spoke : first.spokes)
      spokes.push_back(BezierCurve::fromHomogeneous(projected(spoke, origin, c)));
    for (const UmbrellaMember& member : first.members) {
      const BezierPatch& patch = std::get<BezierPatch>(member);
      options.members.emplace_back(BezierPatch::fromHomogeneous(patch.degreeU(), patch.degreeV(),
                                                                projected(patch, origin, c)));
    }
    const Umbrella found = umbrellaAround(spokes, options);
    EXPECT_LE(found.largest_member_move_mm, 1e-9) << run;
    EXPECT_LE(test::largestDifference(found, Umbrella{options.members, {}, {}, {}}), 1e-9) << run;
  }
}

TEST(UmbrellaBoundary, RefusalsHaveTheNumbers) {
  std::mt19937_64 random(testSeed());
  const std::vector<BezierCurve> spokes =
      umbrellaAround(test::randomSpokes(5, true, 3, random)).spokes;
  UmbrellaOptions options;
  const std::vector<MemberBoundary> boundary = randomBoundary(spokes, true, random);
  const auto refuses = [&](const char* words) {
    EXPECT_THAT([&] { umbrellaAround(spokes, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
  };
  options.boundary.assign(2, {});
  refuses("2 boundaries for 5 sectors");
  options.boundary = boundary;
  options.lambda = Eigen::VectorXd::Zero(5);
  refuses("lambda and mu are found");
  options.lambda.reset();
  const auto moved = [&](int pole, const Eigen::RowVector3d& by) {
    Poles poles = boundary[1].from_first->poles();
    poles.row(pole) += by;
    options.boundary[1].from_first = BezierCurve(poles);
  };
  moved(0, {0, 0, 0.5});
  refuses("member 1: the boundary from its first spoke and the end of the spoke differ by 0.5 mm");
  moved(3, {0, 0.25, 0});
  refuses(
      "member 1: poles that its boundary, spokes and derivatives across give differ by 0.25 mm");
  moved(1, {0, 0, 3});
  refuses("the boundaries beside the end of spoke 1 have no common tangent plane");
  options.boundary = boundary;
  options.boundary[1].across_first = boundary[1].from_first;
  options.boundary[1].from_first.reset();
  refuses("member 1: a derivative across the boundary needs the boundary");
  options.boundary = boundary;
  options.degree = 2;
  refuses("degree 2 of the members is too low");
}

}  // namespace
}  // namespace seamwright
