// SPDX-License-Identifier: LGPL-2.1-or-later
// Umbrellas around given spokes: against nets known to 20 digits, and against what they promise.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>

#include "support/random.hpp"
#include "umbrellas.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using std::numbers::pi;
using test::uniform;
using test::whole;
using testing::HasSubstr;
using testing::ThrowsMessage;

// Nets of the data file.

UmbrellaMember memberOf(const json& net, const json& kind) {
  if (kind == "tri") return test::triangle(net);
  return test::patch(net);
}

struct Case {
  std::string id;
  std::vector<BezierCurve> spokes;
  UmbrellaOptions options;
  Eigen::VectorXd alpha, beta;
  Eigen::Index free_vectors = 0;
};

/// The data's member i lies before spoke i of a closed fan; here it is that behind it.
Case caseOf(const json& entry) {
  const json &input = entry["input"], &expected = entry["expected"];
  Case result;
  result.id = entry["id"];
  result.options.closed = entry["kind"] == "umbrella";
  const int members = static_cast<int>(input["kinds"].size());
  for (std::size_t i = 0; i < input["curves"].size(); ++i) {
    json points = input["curves"][i];
    if (input.contains("solve_C2_index") && input["solve_C2_index"] == i)
      points[2] = expected["C2_solved"];
    result.spokes.push_back(test::bezierCurve(points, nullptr));
  }
  for (int i = 0; i < members; ++i) {
    const int there = result.options.closed ? (i + 1) % members : i;
    result.options.members.push_back(memberOf(expected["nets"][there], input["kinds"][there]));
  }
  const auto ofSpokes = [&](const Eigen::VectorXd& inner) {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(std::ssize(result.spokes));
    all.segment(result.options.closed ? 0 : 1, inner.size()) = inner;
    return all;
  };
  result.alpha = ofSpokes(test::function(expected["alpha"]));
  result.beta = ofSpokes(test::function(expected["beta"]));
  result.options.lambda = ofSpokes(test::function(input["lam"]));
  if (input.contains("mu")) result.options.mu = ofSpokes(test::function(input["mu"]));
  result.free_vectors = std::ssize(input["free_points"]) + (input.contains("twist0") ? 1 : 0);
  for (const json& master : input["master"])
    result.free_vectors += std::ssize(master["vec_index2plus"]);
  return result;
}

std::vector<Case> dataCases() {
  std::vector<Case> cases;
  for (const char* kind : {"umbrella", "open_fan"})
    for (const json& entry : test::dataCases("umbrellas.json", kind))
      cases.push_back(caseOf(entry));
  return cases;
}

double sizeOf(const UmbrellaOptions& options) {
  double size = 0;
  for (const UmbrellaMember& member : options.members)
    size = std::max(size, test::polesOf(member).cwiseAbs().maxCoeff());
  return size;
}

TEST(UmbrellaData, NetsAreAmongThoseThatCanBeChosen) {
  const std::vector<Case> cases = dataCases();
  ASSERT_EQ(cases.size(), 15u);
  for (const Case& given : cases) {
    const Umbrella found = umbrellaAround(given.spokes, given.options);
    EXPECT_LE(found.largest_member_move_mm, 1e-12 * sizeOf(given.options)) << given.id;
    EXPECT_EQ(found.free_vectors, given.free_vectors) << given.id;
    EXPECT_LE((found.vertex.alpha - given.alpha).norm(), 1e-12 * (1 + given.alpha.norm()))
        << given.id;
    EXPECT_LE((found.vertex.beta - given.beta).norm(), 1e-12 * given.beta.norm()) << given.id;
    EXPECT_LE(test::worstLaw(found), 1e-12) << given.id;
  }
}

TEST(UmbrellaData, LambdaIsRecognised) {
  for (Case given : dataCases()) {
    if (given.options.mu && !given.options.mu->isZero(0)) continue;
    if (given.id.find("lam0") != std::string::npos) continue;  // its degree allows no other lambda
    const Eigen::VectorXd lambda = *given.options.lambda;
    given.options.lambda.reset();
    const Umbrella found = umbrellaAround(given.spokes, given.options);
    EXPECT_LE(found.largest_member_move_mm, 1e-11 * sizeOf(given.options)) << given.id;
    for (int i = 0; i < found.vertex.spokes(); ++i) {
      if (!found.vertex.isInner(i)) continue;
      const Eigen::VectorXd& a = found.functions[i].a;
      EXPECT_NEAR(a(a.size() - 1) - a(0), lambda(i), 1e-11 * (1 + found.vertex.alpha.norm()))
          << given.id;
    }
  }
}

// Identities of umbrella.hpp.

struct Fan {
  std::vector<BezierCurve> spokes;
  UmbrellaOptions options;
};

Fan randomFan(std::mt19937_64& random, int largest = 9) {
  Fan fan;
  fan.options.closed = whole(0, 3, random) != 0;
  const int count = whole(3, largest, random);
  fan.spokes = test::randomSpokes(count, fan.options.closed, whole(1, 4, random), random);
  fan.options.kinds = test::randomKinds(fan.options.closed ? count : count - 1, random);
  return fan;
}

TEST(Umbrella, Identity1JoinsAcrossEverySpoke) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 250; ++run) {
    const Fan fan = randomFan(random);
    const Umbrella found = umbrellaAround(fan.spokes, fan.options);
    EXPECT_LE(test::worstLaw(found), 1e-12) << run;
    EXPECT_EQ(found.members.size(), fan.options.kinds.size());
    const int degree =
        lowestUmbrellaDegree(fan.options.kinds, fan.options.closed, found.spokes[0].degree());
    for (const UmbrellaMember& member : found.members)
      EXPECT_EQ(test::polesOf(member).rows(), std::holds_alternative<BezierPatch>(member)
                                                  ? (degree + 1) * (degree + 1)
                                                  : (degree + 1) * (degree + 2) / 2);
  }
}

TEST(Umbrella, MembersMeetWithCertainty) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 25; ++run) {
    const Fan fan = randomFan(random, 6);
    Umbrella found = umbrellaAround(fan.spokes, fan.options);
    EXPECT_LE(test::certifiedAngle(found), 1e-9) << run;
    // A pole of the first row behind spoke 1 that is not part of it: the verdict changes.
    const auto verdict = [&] {
      return joinCondition(test::ribbonBefore(found.members[0]),
                           test::ribbonAfter(found.members[1]))
          .verdict;
    };
    EXPECT_EQ(verdict(), JoinVerdict::G1) << run;
    Poles poles = test::polesOf(found.members[1]);
    const int degree = std::holds_alternative<BezierPatch>(found.members[1])
                           ? std::get<BezierPatch>(found.members[1]).degreeU()
                           : std::get<BezierTriangle>(found.members[1]).degree();
    poles.row(degree + 2) += 1e-6 * found.vertex.normal.transpose();  // (1, 1)
    if (const auto* patch = std::get_if<BezierPatch>(&found.members[1]))
      found.members[1] = BezierPatch(patch->degreeU(), patch->degreeV(), poles);
    else
      found.members[1] = BezierTriangle(poles);
    EXPECT_NE(verdict(), JoinVerdict::G1) << run;
    EXPECT_GE(test::worstLaw(found), 1e-9) << run;
  }
}

TEST(Umbrella, Identity2ComesBackAndDisturbedComesNearer) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 100; ++run) {
    Fan fan = randomFan(random, 7);
    const Umbrella first = umbrellaAround(fan.spokes, fan.options);
    fan.options.members = first.members;
    const Umbrella again = umbrellaAround(first.spokes, fan.options);
    EXPECT_LE(again.largest_member_move_mm, 1e-10) << run;
    EXPECT_LE(again.largest_spoke_move_mm, 1e-12) << run;
    double disturbed = 0, moved = 0;
    for (UmbrellaMember& member : fan.options.members) {
      Poles poles = test::polesOf(member);
      for (double& x : poles.reshaped()) x += uniform(-0.3, 0.3, random);
      disturbed += (poles - test::polesOf(member)).squaredNorm();
      if (const auto* patch = std::get_if<BezierPatch>(&member))
        member = BezierPatch(patch->degreeU(), patch->degreeV(), poles);
      else
        member = BezierTriangle(poles);
    }
    const Umbrella near = umbrellaAround(first.spokes, fan.options);
    EXPECT_LE(test::worstLaw(near), 1e-12) << run;
    for (std::size_t i = 0; i < near.members.size(); ++i)
      moved +=
          (test::polesOf(near.members[i]) - test::polesOf(fan.options.members[i])).squaredNorm();
    EXPECT_LE(moved, disturbed * (1 + 1e-12)) << run;
    EXPECT_GT(moved, 0) << run;
  }
}

TEST(Umbrella, Identity3OrderSenseMotionAndScaleDoNotMatter) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 60; ++run) {
    Fan fan = randomFan(random, 7);
    if (run % 2 == 0) {
      fan.options.members = umbrellaAround(fan.spokes, fan.options).members;
      for (UmbrellaMember& member : fan.options.members)
        member =
            test::mapped(member, Eigen::Matrix3d::Identity() + 0.1 * test::randomRotation(random),
                         Eigen::RowVector3d(0.1, 0.2, -0.3));
    }
    const Umbrella found = umbrellaAround(fan.spokes, fan.options);
    const int m = static_cast<int>(found.members.size());
    if (fan.options.closed) {
      Fan turned = fan;
      std::rotate(turned.spokes.begin(), turned.spokes.begin() + 1, turned.spokes.end());
      std::rotate(turned.options.kinds.begin(), turned.options.kinds.begin() + 1,
                  turned.options.kinds.end());
      if (!turned.options.members.empty())
        std::rotate(turned.options.members.begin(), turned.options.members.begin() + 1,
                    turned.options.members.end());
      const Umbrella other = umbrellaAround(turned.spokes, turned.options);
      EXPECT_LE(test::largestDifference(other, found, 1), 1e-9) << run;
    }
    Fan back = fan;
    std::reverse(back.spokes.begin(), back.spokes.end());
    std::reverse(back.options.kinds.begin(), back.options.kinds.end());
    std::reverse(back.options.members.begin(), back.options.members.end());
    // Member i of the reversed order lies between spokes m - 1 - i and m - 2 - i.
    if (fan.options.closed) {
      std::rotate(back.options.kinds.begin(), back.options.kinds.begin() + 1,
                  back.options.kinds.end());
      if (!back.options.members.empty())
        std::rotate(back.options.members.begin(), back.options.members.begin() + 1,
                    back.options.members.end());
    }
    for (UmbrellaMember& member : back.options.members) member = test::exchanged(member);
    const Umbrella reversed = umbrellaAround(back.spokes, back.options);
    for (int i = 0; i < m; ++i) {
      const int there = fan.options.closed ? (2 * m - 2 - i) % m : m - 1 - i;
      const Poles p = test::polesOf(test::exchanged(reversed.members[i])),
                  q = test::polesOf(found.members[there]);
      EXPECT_LE((p - q).cwiseAbs().maxCoeff(), 1e-9) << run << " " << i;
    }

    const Eigen::Matrix3d linear = 3.7 * test::randomRotation(random);
    const Eigen::RowVector3d move(1, -2, 0.5);
    Fan there = fan;
    for (BezierCurve& spoke : there.spokes) spoke = test::mapped(spoke, linear, move);
    for (UmbrellaMember& member : there.options.members)
      member = test::mapped(member, linear, move);
    const Umbrella elsewhere = umbrellaAround(there.spokes, there.options);
    for (int i = 0; i < m; ++i)
      EXPECT_LE((test::polesOf(elsewhere.members[i]) -
                 test::polesOf(test::mapped(found.members[i], linear, move)))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-8)
          << run;
  }
}

/// Spokes at equal angles, each bent downwards.
std::vector<BezierCurve> regularSpokes(int m, bool closed = true) {
  std::vector<BezierCurve> spokes;
  for (int i = 0; i < (closed ? m : m + 1); ++i) {
    Poles poles(4, 3);
    poles << 0, 0, 0, 3, 0, 0, 6, 0, -1, 9, 0, -4;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(2 * pi * i / m, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    spokes.emplace_back(Poles(poles * turn.transpose()));
  }
  return spokes;
}

// Around a point with an even number of members, one of the free vectors is multiplied by areas.
TEST(Umbrella, Identity3HoldsForAnyUnit) {
  for (const int members : {3, 4, 6, 8}) {
    const std::vector<BezierCurve> spokes = regularSpokes(members);
    const Umbrella one = umbrellaAround(spokes, {});
    for (const double unit : {1e-9, 1e-6, 1e6, 1e9}) {
      std::vector<BezierCurve> other = spokes;
      for (BezierCurve& spoke : other) spoke = BezierCurve(Poles(unit * spoke.poles()));
      const Umbrella found = umbrellaAround(other, {});
      for (int i = 0; i < members; ++i)
        EXPECT_LE((test::polesOf(found.members[i]) / unit - test::polesOf(one.members[i]))
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-12)
            << members << " " << unit;
    }
  }
}

TEST(Umbrella, Identity4SymmetricSpokesMakeASymmetricOne) {
  for (int m = 3; m <= 12; ++m)
    for (const MemberKind kind : {MemberKind::Tensor, MemberKind::Triangle}) {
      UmbrellaOptions options;
      options.kinds.assign(m, kind);
      const Umbrella found = umbrellaAround(regularSpokes(m), options);
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(2 * pi / m, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      for (int i = 0; i < m; ++i) {
        const Poles here = test::polesOf(found.members[i]),
                    next = test::polesOf(found.members[(i + 1) % m]);
        EXPECT_LE((here * turn.transpose() - next).cwiseAbs().maxCoeff(), 1e-11) << m << " " << i;
        EXPECT_LE((found.functions[i].b.array() + 1).abs().maxCoeff(), 1e-12);
      }
      // The mirror at the bisector of sector 0 exchanges u and v.
      const Eigen::Vector3d across(-std::sin(pi / m), std::cos(pi / m), 0);
      const Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity() - 2 * across * across.transpose();
      const Poles mirrored = test::polesOf(test::exchanged(found.members[0])) * mirror;
      EXPECT_LE((mirrored - test::polesOf(found.members[0])).cwiseAbs().maxCoeff(), 1e-11) << m;
      EXPECT_EQ(found.largest_spoke_move_mm < 1e-14, true)
          << m << " " << found.largest_spoke_move_mm;
    }
}

/// |P_uu|^2 + 2 |P_uv|^2 + |P_vv|^2 by differences, as a product of two sets of members.
double energy(const std::vector<UmbrellaMember>& a, const std::vector<UmbrellaMember>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto* patch = std::get_if<BezierPatch>(&a[i]);
    const int n = patch ? patch->degreeU() : std::get<BezierTriangle>(a[i]).degree();
    const Poles p = test::polesOf(a[i]), q = test::polesOf(b[i]);
    const auto row = [&](int r, int s) {
      return patch ? static_cast<Eigen::Index>(r * (n + 1) + s) : BezierTriangle::row(n, r, s);
    };
    const auto inside = [&](int r, int s) { return patch ? r <= n && s <= n : r + s <= n; };
    const auto uu = [&](const Poles& x, int r, int s) -> Eigen::Vector3d {
      return x.row(row(r, s)) - 2 * x.row(row(r + 1, s)) + x.row(row(r + 2, s));
    };
    const auto vv = [&](const Poles& x, int r, int s) -> Eigen::Vector3d {
      return x.row(row(r, s)) - 2 * x.row(row(r, s + 1)) + x.row(row(r, s + 2));
    };
    const auto uv = [&](const Poles& x, int r, int s) -> Eigen::Vector3d {
      return x.row(row(r, s)) - x.row(row(r + 1, s)) - x.row(row(r, s + 1)) +
             x.row(row(r + 1, s + 1));
    };
    for (int r = 0; r <= n; ++r)
      for (int s = 0; s <= n; ++s) {
        if (inside(r + 2, s)) sum += uu(p, r, s).dot(uu(q, r, s));
        if (inside(r, s + 2)) sum += vv(p, r, s).dot(vv(q, r, s));
        if (inside(r + 1, s + 1)) sum += 2 * uv(p, r, s).dot(uv(q, r, s));
      }
  }
  return sum;
}

TEST(Umbrella, Identity5NoOtherIsFairer) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 60; ++run) {
    Fan fan = randomFan(random, 7);
    const Umbrella fair = umbrellaAround(fan.spokes, fan.options);
    // Another umbrella with the same spokes and lambda: a difference that the fairest is orthogonal
    // to.
    UmbrellaOptions others = fan.options;
    others.members = fair.members;
    for (UmbrellaMember& member : others.members)
      member = test::mapped(member, test::randomRotation(random), Eigen::RowVector3d(1, 2, 3));
    const Umbrella free = umbrellaAround(fair.spokes, others);
    EXPECT_GE(energy(free.members, free.members), energy(fair.members, fair.members)) << run;
    others.lambda = Eigen::VectorXd::Zero(fair.vertex.spokes());
    for (int i = 0; i < fair.vertex.spokes(); ++i)
      if (fair.vertex.isInner(i))
        (*others.lambda)(i) =
            fair.functions[i].a(fair.functions[i].a.size() - 1) - fair.functions[i].a(0);
    others.degree =
        lowestUmbrellaDegree(fan.options.kinds, fan.options.closed, fair.spokes[0].degree());
    const Umbrella same = umbrellaAround(fair.spokes, others);
    const double cross = energy(fair.members, same.members) - energy(fair.members, fair.members);
    EXPECT_LE(std::abs(cross), 1e-11 * (1 + energy(same.members, same.members))) << run;
  }
}

// Spokes of even fans, forms, degenerate fans.

TEST(Umbrella, EvenFansChangeTheirSpokesAsLittleAsTheyCan) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 40; ++run) {
    const int m = 2 * whole(2, 4, random), degree = whole(2, 4, random);
    const std::vector<BezierCurve> spokes = test::randomSpokes(m, true, degree, random);
    const Umbrella found = umbrellaAround(spokes);
    EXPECT_GT(found.largest_second_change, 0) << run;
    for (int i = 0; i < m; ++i) {
      EXPECT_LE((found.spokes[i].point(1) - spokes[i].point(1)).norm(), 1e-13) << run;
      const Eigen::Vector3d change =
          (found.spokes[i].derivatives(0, 2) - spokes[i].derivatives(0, 2)).row(2).transpose();
      EXPECT_LE(change.cross(found.vertex.normal).norm(), 1e-10) << run;
    }
    // Spokes on one quadratic surface to second order need no change.
    UmbrellaOptions options;
    options.form = test::randomRotation(random);
    options.form = Eigen::Matrix3d(*options.form + options.form->transpose());
    const Umbrella shaped = umbrellaAround(spokes, options);
    EXPECT_LE(test::worstLaw(shaped), 1e-12) << run;
    for (const BezierCurve& spoke : shaped.spokes) {
      const CurveDerivatives d = spoke.derivatives(0, 2);
      const Eigen::Vector3d r = d.row(1).transpose(), q = d.row(2).transpose();
      EXPECT_NEAR(r.dot(*options.form * r), shaped.vertex.normal.dot(q), 1e-9 * r.squaredNorm())
          << run;
    }
  }
}

TEST(Umbrella, ACrossingKeepsItsSpokes) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 20; ++run) {
    std::vector<BezierCurve> spokes = test::randomSpokes(4, true, 3, random);
    for (int i = 2; i < 4; ++i) {
      Poles poles = spokes[i].poles();
      poles.row(1) =
          poles.row(0) - uniform(0.3, 2, random) * (spokes[i - 2].poles().row(1) - poles.row(0));
      spokes[i] = BezierCurve(poles);
    }
    const Umbrella found = umbrellaAround(spokes);
    EXPECT_TRUE(found.vertex.isRegular());
    EXPECT_LE(found.largest_spoke_move_mm, 1e-13) << run;
    EXPECT_LE(test::worstLaw(found), 1e-12) << run;
    // Hardly a crossing: the same to what the angle is.
    Poles poles = spokes[0].poles();
    poles.row(1) += 1e-4 * (spokes[1].poles().row(1) - poles.row(0));
    spokes[0] = BezierCurve(poles);
    const Umbrella nearly = umbrellaAround(spokes);
    EXPECT_FALSE(nearly.vertex.isRegular());
    EXPECT_LE(test::worstLaw(nearly), 1e-12) << run;
  }
}

TEST(Umbrella, SectorsNearlyOfPiAreBuiltWithAWarningFigure) {
  for (const double gap : {1e-2, 1e-4, 1e-6}) {
    std::vector<BezierCurve> spokes;
    for (const double angle : {0.0, pi - gap, 1.5 * pi}) {
      Poles poles(3, 3);
      poles << 0, 0, 0, std::cos(angle), std::sin(angle), 0, 2 * std::cos(angle),
          2 * std::sin(angle), 0.2;
      spokes.emplace_back(poles);
    }
    const Umbrella found = umbrellaAround(spokes);
    EXPECT_LE(test::worstLaw(found), 1e-12) << gap;
    EXPECT_GT(found.vertex.condition, 0.3 / gap);
  }
}

// What cannot be.

TEST(Umbrella, LowestDegrees) {
  const auto T = MemberKind::Tensor, D = MemberKind::Triangle;
  EXPECT_EQ(lowestUmbrellaDegree({T, T, T}, true, 3), 3);
  EXPECT_EQ(lowestUmbrellaDegree({T, D, T, D}, true, 3), 3);
  EXPECT_EQ(lowestUmbrellaDegree({D, T, D}, true, 3), 4);
  EXPECT_EQ(lowestUmbrellaDegree({D, T, D}, false, 3), 3);
  EXPECT_EQ(lowestUmbrellaDegree({D, D, D}, true, 3), 4);
  EXPECT_EQ(lowestUmbrellaDegree({T, D, T, D}, true, 1), 2);
  EXPECT_EQ(lowestUmbrellaDegree({T, T, T}, true, 1), 1);
}

TEST(Umbrella, RefusesWhatIsNone) {
  const std::vector<BezierCurve> spokes = regularSpokes(5);
  const auto fails = [](std::vector<BezierCurve> curves, const UmbrellaOptions& options,
                        const char* why) {
    EXPECT_THAT([&] { umbrellaAround(curves, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
  };
  fails({}, {}, "0 spokes");
  fails(spokes, {.degree = 25}, "5 members of degree 25 have 3380 poles: at most 1600");
  fails({spokes[0], spokes[1]}, {}, "2 spokes");
  std::vector<BezierCurve> other = spokes;
  other[3] = BezierCurve(spokes[3].poles(), Eigen::Vector4d(1, 2, 1, 1));
  fails(other, {.lambda = Eigen::VectorXd::Zero(5)}, "lambda and mu are found");
  other[3] = BezierCurve(Poles::Zero(1, 3));
  fails(other, {}, "spoke 3 has degree 0");
  other[3] = test::mapped(spokes[3], Eigen::Matrix3d::Identity(), Eigen::RowVector3d(0, 0, 0.1));
  fails(other, {}, "begins 0.0");
  UmbrellaOptions options;
  options.kinds.assign(4, MemberKind::Tensor);
  fails(spokes, options, "4 kinds for 5 sectors");
  options = {};
  options.members = {BezierTriangle(Poles::Zero(3, 3))};
  fails(spokes, options, "1 members for 5 sectors");
  options = {};
  options.degree = 2;
  fails(spokes, options, "degree 2 of the members");
  options = {};
  options.lambda = Eigen::VectorXd::Zero(3);
  fails(spokes, options, "3 values of lambda for 5 spokes");
  options.lambda = Eigen::VectorXd::Zero(5);
  (*options.lambda)(2) = std::nan("");
  fails(spokes, options, "lambda of spoke 2 is nan");
  options = {};
  options.kinds.assign(5, MemberKind::Triangle);
  options.lambda = Eigen::VectorXd::Ones(5);
  options.degree = 3;
  fails(spokes, options, "spoke 0 of degree 3 has lambda 1 between triangles: they need degree 4");
  options.degree = 4;
  options.mu = Eigen::VectorXd::Ones(5);
  fails(spokes, options, "spoke 0 has mu 1 before a triangle");
  options = {};
  options.form = Eigen::Matrix3d::Zero();
  (*options.form)(0, 1) = 1;
  fails(spokes, options, "not symmetric");
  options = {};
  options.gap_mm = -1;
  fails(spokes, options, "gap_mm is -1");
  options.gap_mm = std::numeric_limits<double>::infinity();
  fails(spokes, options, "gap_mm is inf");
}

}  // namespace
}  // namespace seamwright
