// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <Geom_CylindricalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "follow_seams.hpp"

#include <seamwright/occ_adapter/repair/seam_target.hpp>

namespace seamwright::test {
namespace {

using occ::agreeAtVertex;
using occ::FaceFollow;
using occ::FaceTask;
using occ::followPath;
using occ::followPaths;
using occ::meetingEnds;
using occ::Pcurve;
using occ::SeamTarget;
using occ::TargetPoint;
using occ::VertexConsensus;
using occ::vertexConsensus;
using occ::VertexView;

constexpr std::array<bool, 2> both_move = {false, false};

using Path = handle<Geom2d_BSplineCurve>;

Spline copyOf(const Spline& surface) {
  return Spline::DownCast(surface->Copy());
}

/// Two sheets that nearly join along a curved path, and their seam.
struct NearlyJoined {
  NearlyJoined(std::mt19937& generator, double noise) {
    const Spline truth = sheet(generator, 14, 12, 3, 3);
    for (Spline& side : sides) {
      side = copyOf(truth);
      addNoise(side, generator, noise);
    }
    const auto height = [&] { return 0.5 + random(generator, 0.2); };
    path = curvedPath({{0.1, height()}, {0.4, height()}, {0.7, height()}, {0.9, height()}});
    seam = seamBetween({sides[0], path, true}, {sides[1], path, false});
  }
  Pcurve pcurve() const { return wholePath(path); }
  SeamTarget target(int order, const std::array<bool, 2>& stays = both_move) const {
    return SeamTarget(seam, {pcurve(), pcurve()}, stays, order);
  }

  std::array<Spline, 2> sides;
  handle<Geom2d_BSplineCurve> path;
  occ::Seam seam;
};

/// A point, normal and tensor near what a target shows.
TargetPoint near(const TargetPoint& target, std::mt19937& generator, double mm, double rad) {
  TargetPoint moved = target;
  for (int c = 0; c < 3; ++c) {
    moved.point[c] += random(generator, mm);
    moved.normal[c] += random(generator, rad);
  }
  moved.normal.normalize();
  const Eigen::Vector3d x = moved.normal.unitOrthogonal(), y = moved.normal.cross(x);
  const double a = random(generator, 0.05), b = random(generator, 0.05), c = random(generator, 0.05);
  moved.curvature =
      a * x * x.transpose() + b * (x * y.transpose() + y * x.transpose()) + c * y * y.transpose();
  return moved;
}

double difference(const TargetPoint& a, const TargetPoint& b) {
  return std::max(
      {(a.point - b.point).norm(), (a.normal - b.normal).norm(), (a.curvature - b.curvature).norm()});
}

TEST(SeamTarget, IsConsistent_1_2_4) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 60; ++trial) {
    const int order = 1 + trial % 2;
    const NearlyJoined pair(generator, logRandom(generator, 0.1, 2));
    SeamTarget target = pair.target(order);
    std::array<TargetPoint, 2> ends;
    if (trial % 3 > 0)
      for (const int end : {0, 1}) {
        ends[end] = near(target.at(end), generator, 0.05, 0.005);
        TargetPoint given = ends[end];
        if (trial % 3 == 2) given = {given.point, -given.normal, -given.curvature};
        target.setEnd(end, given);
        const TargetPoint there = target.at(end);
        EXPECT_LT((there.point - ends[end].point).norm(), 1e-12);
        EXPECT_LT((there.normal - ends[end].normal).norm(), 1e-10);
        if (order == 2) {
          EXPECT_LT((there.curvature - ends[end].curvature).norm(), 2e-6);
        }
      }
    const SeamTarget renewed = target.renewed();
    for (const double s : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      EXPECT_EQ(renewed.at(s).point, target.at(s).point);
      EXPECT_EQ(renewed.at(s).normal, target.at(s).normal);
      EXPECT_EQ(renewed.at(s).curvature, target.at(s).curvature);
    }
    for (int k = 0; k < 40; ++k) {
      // Richardson's central differences: independent of the library's.
      constexpr double h = 1e-3;
      const double s = std::uniform_real_distribution<double>(2 * h, 1 - 2 * h)(generator);
      const auto slope = [&](const auto& of) {
        return Eigen::Vector3d((8 * (of(target.at(s + h)) - of(target.at(s - h))) -
                                (of(target.at(s + 2 * h)) - of(target.at(s - 2 * h)))) /
                               (12 * h));
      };
      const TargetPoint here = target.at(s);
      const Eigen::Vector3d dx = slope([](const TargetPoint&point) { return point.point; }),
                            dn = slope([](const TargetPoint&point) { return point.normal; });
      EXPECT_NEAR(here.normal.norm(), 1, 1e-14);
      EXPECT_LT(std::abs(here.normal.dot(dx)) / dx.norm(), 1e-6) << "trial " << trial << " s " << s;
      EXPECT_LT((here.curvature * here.normal).norm(), 1e-14);
      EXPECT_LT((here.curvature - here.curvature.transpose()).norm(), 1e-14);
      if (order == 2) {
        EXPECT_LT((dn + here.curvature * dx).norm() / dx.norm(), 1e-4) << "trial " << trial << " s " << s;
      }
    }
  }
}

TEST(SeamTarget, SwapChangesNothingButTheSense_3) {
  std::mt19937 generator(6);
  for (int trial = 0; trial < 20; ++trial) {
    const NearlyJoined pair(generator, 0.05);
    occ::Seam swapped = pair.seam;
    std::swap(swapped.sides[0], swapped.sides[1]);
    // The second side with u and v exchanged has its normal turned.
    SeamTarget target = pair.target(2);
    SeamTarget other(swapped, {pair.pcurve(), pair.pcurve()}, both_move, 2);
    for (const double s : {0.0, 0.13, 0.5, 0.98, 1.0})
      EXPECT_LT(difference(target.at(s), other.at(s)), 1e-11);
    const Spline exchanged = copyOf(pair.sides[1]);
    exchanged->ExchangeUV();
    std::vector<gp_Pnt2d> poles;
    for (int i = 1; i <= pair.path->NbPoles(); ++i)
      poles.emplace_back(pair.path->Pole(i).Y(), pair.path->Pole(i).X());
    const handle<Geom2d_BSplineCurve> mirrored = curvedPath(poles);
    const SeamTarget turned(seamBetween({pair.sides[0], pair.path, true}, {exchanged, mirrored, true}),
                            {pair.pcurve(), wholePath(mirrored)}, both_move, 2);
    for (const double s : {0.0, 0.13, 0.5, 0.98, 1.0}) {
      EXPECT_LT(difference(target.at(s), turned.at(s)), 1e-10);
      const TargetPoint own = turned.at(1, s, 2), first = turned.at(0, s, 2);
      const TargetPoint plane = turned.at(1, s, 1);
      EXPECT_LT((own.point - plane.point).norm() + (own.normal - plane.normal).norm(), 1e-12);
      EXPECT_TRUE(plane.curvature.isZero());
      EXPECT_LT((own.normal + first.normal).norm(), 1e-14);
      EXPECT_LT((own.curvature + first.curvature).norm(), 1e-14);
      EXPECT_EQ(own.point, first.point);
    }
  }
}

TEST(SeamTarget, OfASmoothJoinIsWhatBothShow_5) {
  std::mt19937 generator(7);
  for (int trial = 0; trial < 20; ++trial) {
    const NearlyJoined pair(generator, 0);
    const SeamTarget target = pair.target(2);
    for (double s = 0; s <= 1; s += 0.125) {
      const gp_Pnt2d uv = pair.path->Value(s);
      const TargetPoint shown = shownBy(pair.sides[0], uv), there = target.at(s);
      EXPECT_LT((there.point - shown.point).norm(), 1e-12);
      EXPECT_LT((there.normal - shown.normal).norm(), 1e-12);
      EXPECT_LT((there.curvature - shown.curvature).norm(), 1e-5 * (1 + shown.curvature.norm()));
    }
  }
}

TEST(SeamTarget, OfASideThatStaysIsWhatItShows) {
  std::mt19937 generator(8);
  const NearlyJoined pair(generator, 0.05);
  for (const int side : {0, 1}) {
    SeamTarget target = pair.target(2, {side == 0, side == 1});
    target.setEnd(0, near(target.at(0), generator, 0.05, 0.005));
    for (double s = 0; s <= 1; s += 0.1)
      EXPECT_LT(difference(target.at(s), shownBy(pair.sides[side], pair.path->Value(s))), 1e-11);
  }
}

TEST(SeamTarget, OfAMatchedSeamIsTheSameFromBothSides) {
  std::mt19937 generator(11);
  for (int trial = 0; trial < 20; ++trial) {
    const int order = 1 + trial % 2;
    const NearlyJoined pair(generator, 0.01);
    // The second path runs back, from beyond one end of the first.
    const Path reversed = Path::DownCast(pair.path->Copy());
    reversed->Reverse();
    occ::Seam seam = seamBetween({pair.sides[0], pair.path, true}, {pair.sides[1], reversed, false});
    seam.kind = occ::SeamKind::Matched;
    seam.correspondence = {{0, 0.5, 1}, {0.1, 0.5, 1}, {0.9, 0.5, 0}};
    const SeamTarget matched(seam, {pair.pcurve(), wholePath(reversed)}, both_move, order),
        shared = pair.target(order);
    EXPECT_NEAR(matched.path(0).first, 0.1, 1e-15);
    EXPECT_NEAR(matched.path(1).last, 0.9, 1e-15);
    for (const double place : {0.15, 0.3, 0.62, 0.9}) {
      const TargetPoint a = matched.at(0, (place - 0.1) / 0.9, order), same = shared.at(place),
                        b = matched.at(1, (1 - place) / 0.9, order);
      // Nearest points instead of those of equal parameters: they differ along the seam by no more than the noise.
      EXPECT_LT((a.point - same.point).norm(), 0.02);
      EXPECT_LT((a.point - b.point).norm(), 0.02);
      EXPECT_LT((a.normal - b.normal).norm(), 1e-3);
      EXPECT_LT((a.normal - same.normal).norm(), 1e-3);
      // It is a point of one and the same curve.
      double nearest = 1;
      for (int k = -400; k <= 400; ++k)
        nearest =
            std::min(nearest, (matched.at(0, (place - 0.1) / 0.9 + 2.5e-6 * k, 1).point - b.point).norm());
      EXPECT_LT(nearest, 2e-4);
    }
  }
}

bool isFinite(const TargetPoint& target) {
  return target.point.allFinite() && target.normal.allFinite() && target.curvature.allFinite();
}

TEST(SeamTarget, WhereItsPathStandsStillItShowsThePlace) {
  std::mt19937 generator(41);
  for (const int order : {1, 2})
    for (const occ::LeadReach reach : {occ::LeadReach::Spans, occ::LeadReach::Half}) {
      const std::array<Spline, 2> sides = disturbedSheets(generator, 0.02);
      const Path along = curvedPath({{0.4, 0.3}, {0.4, 0.6}}), still = Path::DownCast(along->Copy());
      for (int k = 1; k <= still->NbPoles(); ++k) still->SetPole(k, gp_Pnt2d(0.4, 0.3));
      SeamTarget target(seamBetween({sides[0], along}, {sides[1], along, false}),
                        {wholePath(still), wholePath(still)}, both_move, order, reach);
      const gp_Pnt a = sides[0]->Value(0.4, 0.3), b = sides[1]->Value(0.4, 0.3);
      const TargetPoint before = target.at(0);
      target.setEnd(1, near(before, generator, 0.01, 0.001));
      for (const double s : {0.0, 0.3, 0.9, 1.0})
        for (const int side : {0, 1})
          EXPECT_TRUE(isFinite(target.at(side, s, order))) << s << " side " << side;
      EXPECT_LT((before.point - Eigen::Vector3d(a.X() + b.X(), a.Y() + b.Y(), a.Z() + b.Z()) / 2).norm(),
                1e-9);
      const Eigen::Vector3d mean =
          shownBy(sides[0], {0.4, 0.3}).normal + shownBy(sides[1], {0.4, 0.3}).normal;
      EXPECT_LT(before.normal.cross(mean.normalized()).norm(), 1e-9);
    }
}

TEST(SeamTarget, PlacesOfAMatchedSeamMayBeGivenTwice) {
  std::mt19937 generator(42);
  NearlyJoined pair(generator, 0.01);
  const SeamTarget once = pair.target(1);
  pair.seam.kind = occ::SeamKind::Matched;
  pair.seam.edges = {1, 2};
  pair.seam.correspondence = {{0, 0, 0.5, 0.5, 1, 1}, {0, 0, 0.5, 0.5, 1, 1}, {0, 0, 0.5, 0.5, 1, 1}};
  const SeamTarget twice = pair.target(1);
  for (const double s : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    ASSERT_TRUE(isFinite(twice.at(s))) << s;
    // The sides are a hundredth of a millimetre apart, and so are the nearest points and those of equal parameters.
    EXPECT_LT((twice.at(s).point - once.at(s).point).norm(), 0.02) << s;
    EXPECT_LT((twice.at(s).normal - once.at(s).normal).norm(), 0.002) << s;
  }
}

TEST(VertexConsensus, IsTheMeanUnlessAFaceIsHeld) {
  std::mt19937 generator(9);
  for (int trial = 0; trial < 300; ++trial) {
    const TargetPoint middle{Eigen::Vector3d::Random() * 50, Eigen::Vector3d::Random().normalized(), {}};
    std::vector<VertexView> views;
    for (int face = 1; face <= 4; ++face) {
      TargetPoint shown = near(middle, generator, 0.01, 0.001);
      if (face % 2 == 0) shown = {shown.point, -shown.normal, -shown.curvature};
      views.push_back({face, shown, -1});
    }
    const VertexConsensus mean = vertexConsensus(views, 2, {});
    EXPECT_TRUE(mean.contradiction.empty());
    EXPECT_LT((mean.target.point - middle.point).norm(), 0.02);
    EXPECT_GT(mean.target.normal.dot(middle.normal), 0.99999);
    EXPECT_LT((mean.target.curvature * mean.target.normal).norm(), 1e-15);
    std::swap(views[0], views[2]);
    EXPECT_LT(difference(vertexConsensus(views, 2, {}).target, mean.target), 1e-13);
    views[1].held = 2;
    const TargetPoint held = vertexConsensus(views, 2, {}).target;
    EXPECT_LT((held.point - views[1].shown.point).norm(), 1e-13);
    EXPECT_LT((held.normal + views[1].shown.normal).norm(), 1e-13);
    EXPECT_LT((held.curvature + views[1].shown.curvature).norm(), 1e-13);
    views[1].held = 0;
    const TargetPoint pinned = vertexConsensus(views, 2, {}).target;
    EXPECT_LT((pinned.point - views[1].shown.point).norm(), 1e-13);
    EXPECT_LT((pinned.normal - mean.target.normal).norm(), 1e-13);
  }
}

TEST(SeamTarget, OfASharpVertexTheCurveKeepsToTheTangentPlanes) {
  std::mt19937 generator(43);
  for (int trial = 0; trial < 20; ++trial) {
    const NearlyJoined pair(generator, 0.02);
    const int end = trial % 2, sense = end == 0 ? 1 : -1;
    SeamTarget target = pair.target(0);
    const Eigen::Vector3d given = target.at(end).point + 0.02 * Eigen::Vector3d::Random();
    std::map<int, Eigen::Vector3d> normals;
    for (const int face : {1, 2})
      if (trial % 3 == 0 || trial % 3 == face) normals[face] = Eigen::Vector3d::Random().normalized();
    target.setSharpEnd(end, given, normals);
    EXPECT_LT((target.at(end).point - given).norm(), 1e-12);
    const auto at = [&](double distance) { return target.at(end + sense * distance).point; };
    constexpr double h = 1e-4;
    const Eigen::Vector3d slope = (4 * at(h) - 3 * at(0) - at(2 * h)) / (2 * h);
    for (const auto& [face, normal] : normals) EXPECT_LT(std::abs(slope.dot(normal)), 1e-3 * slope.norm());
    // Beyond the lead nothing has changed.
    EXPECT_EQ(target.at(1 - end).point, pair.target(0).at(1 - end).point);
  }
}

/// Two faces with the normals +-a beside z in the plane of x, curved along x; ways along x and y, those of the second half as long.
std::vector<VertexView> twoViews(double a, double first_per_mm, double second_per_mm) {
  std::vector<VertexView> views;
  for (const int sign : {1, -1}) {
    TargetPoint shown;
    shown.normal = Eigen::Vector3d(sign * std::sin(a), 0, std::cos(a));
    shown.curvature(0, 0) = sign == 1 ? first_per_mm : second_per_mm;
    const double length = sign == 1 ? 8 : 4;
    views.push_back({sign == 1 ? 1 : 2,
                     shown,
                     -1,
                     false,
                     {length * Eigen::Vector3d::UnitX(), length * Eigen::Vector3d::UnitY()}});
  }
  return views;
}

TEST(VertexConsensus, LongerWaysCountMore) {
  // Along a way what the normals differ by counts with its square, against a thousandth of all of it.
  const double a = 0.5 * degree, weight = 1.0 / 4;
  const TargetPoint tilted = vertexConsensus(twoViews(a, 0, 0), 1, {}).target;
  const Eigen::Vector3d normal((1 - weight) * std::sin(a) / (1 + weight + 2e-3), 0, std::cos(a));
  EXPECT_LT((tilted.normal - normal.normalized()).norm(), 1e-12);
  // Tensors are forms of two ways: the fourth power.
  const TargetPoint curved = vertexConsensus(twoViews(0, 0.03, 0.01), 2, {}).target;
  const double form = 1.0 / 16;
  EXPECT_NEAR(curved.curvature(0, 0), (0.03 * (1 + 1e-3) + 0.01 * (form + 1e-3)) / (1 + form + 2e-3), 1e-12);
  EXPECT_NEAR(curved.curvature.norm(), curved.curvature(0, 0), 1e-12);
  // What has no ways counts as a whole.
  std::vector<VertexView> bare = twoViews(a, 0.03, 0.01);
  for (VertexView& view : bare) view.ways.clear();
  EXPECT_LT((vertexConsensus(bare, 2, {}).target.normal - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(VertexConsensus, AlongAWayThatIsHeldTheNormalTurnsAsItDoes) {
  std::mt19937 generator(13);
  for (int trial = 0; trial < 100; ++trial) {
    const TargetPoint middle{Eigen::Vector3d::Random() * 50, Eigen::Vector3d::Random().normalized(), {}};
    std::vector<VertexView> views;
    for (int face = 1; face <= 3; ++face) views.push_back({face, near(middle, generator, 0, 0), -1});
    // Of one face how the normal turns along a way, of the others all the rest.
    const Eigen::Vector3d way = views[0].shown.normal.unitOrthogonal(),
                          across = way.cross(views[0].shown.normal);
    views[0].shown.curvature += 0.5 * across * across.transpose() + 0.3 * way * way.transpose() +
                                0.2 * (way * across.transpose() + across * way.transpose());
    views[0].held = 1;
    views[0].held_along = 3 * way;
    views[0].ways = {3 * way};
    for (const int other : {1, 2}) views[other].ways = {5 * way, 5 * across};
    const Eigen::Matrix3d common = vertexConsensus(views, 2, {}).target.curvature;
    EXPECT_LT((common * way - views[0].shown.curvature * way).norm(), 1e-7);
    views[0].held_along.reset();
    const Eigen::Matrix3d free = vertexConsensus(views, 2, {}).target.curvature;
    EXPECT_GT((free * way - views[0].shown.curvature * way).norm(), 0.01);
    EXPECT_NEAR(across.dot(common * across), across.dot(free * across), 1e-7);
    views[0].held = 2;
    const Eigen::Matrix3d whole = vertexConsensus(views, 2, {}).target.curvature;
    EXPECT_LT((whole - views[0].shown.curvature).norm(), 1e-12);
    EXPECT_GT(std::abs(across.dot(whole * across) - across.dot(common * across)), 0.01);
  }
}

TEST(VertexConsensus, TwoThatCantChangeAndDifferAreTold) {
  TargetPoint a{Eigen::Vector3d(1, 2, 3), Eigen::Vector3d::UnitZ(), Eigen::Matrix3d::Zero()}, b = a;
  b.point.x() += 0.5;
  b.normal = Eigen::AngleAxisd(0.3 * degree, Eigen::Vector3d::UnitX()) * b.normal;
  EXPECT_EQ(vertexConsensus({{3, a, 1}, {5, b, 1}}, 1, {}).contradiction,
            "faces 3 and 5 can't change at (1.25, 2, 3), where they are 0.5 mm, 0.3 degrees apart");
  EXPECT_EQ(vertexConsensus({{3, a, 0}, {5, b, 1}}, 1, {}).contradiction,
            "faces 3 and 5 can't change at (1.25, 2, 3), where they are 0.5 mm apart");
  EXPECT_EQ(vertexConsensus({{3, a, 1}, {5, b, -1}}, 1, {}).contradiction, "");
  b.point = a.point;
  EXPECT_EQ(vertexConsensus({{3, a, 0}, {5, b, 1}}, 1, {}).contradiction, "");
}

TEST(VertexConsensus, APoleShowsNoCurvatureAndANormalOnlyWhereItIsHeld) {
  std::mt19937 generator(12);
  for (int trial = 0; trial < 100; ++trial) {
    const TargetPoint middle{Eigen::Vector3d::Random() * 50, Eigen::Vector3d::Random().normalized(), {}};
    std::vector<VertexView> views;
    for (int face = 1; face <= 3; ++face) views.push_back({face, near(middle, generator, 0.01, 0.001), -1});
    const TargetPoint without = vertexConsensus(views, 2, {}).target;
    TargetPoint rounding = near(middle, generator, 0, 0.5);
    rounding.point = without.point;
    rounding.curvature = 1e3 * Eigen::Matrix3d::Identity();
    views.push_back({4, rounding, -1, true});
    const TargetPoint with = vertexConsensus(views, 2, {}).target;
    EXPECT_LT(difference(with, without), 1e-12);
    views.back().held = 2;
    const TargetPoint held = vertexConsensus(views, 2, {}).target;
    EXPECT_GT(std::abs(held.normal.dot(rounding.normal)), 1 - 1e-12);
    EXPECT_LT(held.curvature.norm(), 10);
    // Two poles that are held contradict one another in their normals alone.
    views.push_back({5, {rounding.point, rounding.normal, -rounding.curvature}, 2, true});
    EXPECT_EQ(vertexConsensus(views, 2, {}).contradiction, "");
    // Of poles alone all count.
    const TargetPoint alone = vertexConsensus({views[3], views[4]}, 1, {}).target;
    EXPECT_GT(std::abs(alone.normal.dot(rounding.normal)), 1 - 1e-12);
  }
}

/// Four faces of one sheet about a vertex, each disturbed on its own, and the seams between them.
struct FourFaces {
  FourFaces(std::mt19937& generator, double noise) {
    const Spline truth = sheet(generator, 16, 16, 3, 3);
    const gp_Pnt2d middle(0.5 + random(generator, 0.05), 0.5 + random(generator, 0.05));
    const std::array<gp_Pnt2d, 4> outside = {gp_Pnt2d(1, 0.5), gp_Pnt2d(0.5, 1), gp_Pnt2d(0, 0.5),
                                             gp_Pnt2d(0.5, 0)};
    for (int k = 0; k < 4; ++k) {
      faces[k] = copyOf(truth);
      addNoise(faces[k], generator, noise);
      const gp_XY way = outside[k].XY() - middle.XY();
      const auto along = [&](double share) {
        const gp_XY aside(-way.Y(), way.X());
        return gp_Pnt2d(middle.XY() + share * way + random(generator, 0.1) * aside);
      };
      rays[k] = curvedPath({middle, along(0.3), along(0.6), outside[k]});
    }
    const BRep_Builder builder;
    TopoDS_Vertex vertex;
    builder.MakeVertex(vertex, truth->Value(middle.X(), middle.Y()), 0.5);
    for (int k = 0; k < 4; ++k) {
      TopoDS_Vertex end;
      const gp_Pnt2d uv = rays[k]->Value(1);
      builder.MakeVertex(end, truth->Value(uv.X(), uv.Y()), 0.5);
      ends[k] = {vertex, end};
    }
  }
  occ::Seam seam(int k) const {
    return seamBetween({faces[k], rays[k], true}, {faces[(k + 3) % 4], rays[k], false},
                       {k + 1, (k + 3) % 4 + 1}, ends[k]);
  }

  std::array<Spline, 4> faces;
  std::array<handle<Geom2d_BSplineCurve>, 4> rays;
  std::array<std::array<TopoDS_Vertex, 2>, 4> ends;
};

TEST(SeamTarget, FourFacesMeetAtAVertex) {
  std::mt19937 generator(10);
  for (int trial = 0; trial < 4; ++trial) {
    const int order = 1 + trial % 2;
    const bool one_stays = trial > 1;
    const double noise = logRandom(generator, 0.05, 1.5);
    FourFaces patch(generator, noise);
    std::vector<std::shared_ptr<SeamTarget>> targets;
    for (int k = 0; k < 4; ++k) {
      const Pcurve path = wholePath(patch.rays[k]);
      targets.push_back(std::make_shared<SeamTarget>(
          patch.seam(k), std::array<Pcurve, 2>{path, path},
          std::array<bool, 2>{one_stays && k == 0, one_stays && (k + 3) % 4 == 0}, order));
    }
    const auto meeting = meetingEnds(targets);
    ASSERT_EQ(meeting.size(), 5);
    ASSERT_EQ(meeting[0].size(), 4);
    for (const auto& ends : meeting) EXPECT_EQ(agreeAtVertex(ends, {}, fine()), "");
    for (const auto& target : targets) {
      EXPECT_LT((target->at(0).point - targets[0]->at(0).point).norm(), 1e-12);
      EXPECT_LT((target->at(0).normal - targets[0]->at(0).normal).norm(), 1e-10);
      if (order == 2) {
        EXPECT_LT((target->at(0).curvature - targets[0]->at(0).curvature).norm(), 1e-6);
      }
    }
    std::array<Spline, 4> moved;
    for (int k = 0; k < 4; ++k) {
      moved[k] = patch.faces[k];
      if (one_stays && k == 0) continue;
      FaceTask task{patch.faces[k],
                    {followPath(targets[k], 0, order), followPath(targets[(k + 1) % 4], 1, order)},
                    fine()};
      const FaceFollow follow = followPaths(task);
      // Of curvature at the vertex its derivatives along the seams contradict one another: it is met with the spans' first power.
      EXPECT_LE(std::ranges::max(follow.ratios), 0.5) << follow.failure;
      EXPECT_LE(follow.largest_move_mm, 4 * noise) << trial;
      moved[k] = follow.surface;
    }
    patch.faces = moved;
    for (int k = 0; k < 4; ++k) {
      const occ::SeamResult after = certified(patch.seam(k), fine(), order);
      EXPECT_TRUE(after.verdict.level >= (order == 1 ? Level::G1 : Level::G2))
          << trial << " " << describe(after);
    }
  }
}

}  // namespace
}  // namespace seamwright::test
