// SPDX-License-Identifier: LGPL-2.1-or-later
#include <map>
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/planar/conic.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::number;
using test::planarVector;
using test::uniform;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Curvature from the derivatives of the rational curve.
double curvatureAt(const PlanarConic& conic, double t) {
  const CurveDerivatives d = bezierCurve(conic).derivatives(t, 2);
  return (d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0)) / std::pow(d.row(1).norm(), 3);
}

double tangentDirection(const PlanarConic& conic, double t) {
  const CurveDerivatives d = bezierCurve(conic).derivatives(t, 1);
  return std::atan2(d(1, 1), d(1, 0));
}

void expectG2(const PlanarConic& left, const PlanarConic& right, double tolerance) {
  EXPECT_EQ(left.end, right.start);
  EXPECT_LT(test::angleBetween(tangentDirection(left, 1), tangentDirection(right, 0)), tolerance);
  const double before = curvatureAt(left, 1), after = curvatureAt(right, 0);
  EXPECT_NEAR(before, after, tolerance * std::abs(before));
}

TwoConicsEnds randomEnds(std::mt19937_64& random) {
  const double sign = random() % 2 == 0 ? 1 : -1;
  const Vector2d start(uniform(random, -5, 5), uniform(random, -5, 5));
  const double direction = uniform(random, -3, 3), turn = sign * uniform(random, 0.1, 3);
  const Vector2d apex = start + uniform(random, 1, 5) * unitVector(direction);
  return {.start = start,
          .apex = apex,
          .end = apex + uniform(random, 1, 5) * unitVector(direction + turn),
          .start_curvature_per_mm = sign * uniform(random, 0.1, 2),
          .end_curvature_per_mm = sign * uniform(random, 0.1, 2),
          .start_share = uniform(random, 0.05, 0.95),
          .end_share = uniform(random, 0.05, 0.95)};
}

// Identity (1).
TEST(TwoConics, JoinG2WithTheGivenEnds) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const TwoConicsEnds ends = randomEnds(random);
    const auto [first, second] = twoConics(ends);
    expectG2(first, second, 1e-9);
    EXPECT_EQ(first.start, ends.start);
    EXPECT_EQ(second.end, ends.end);
    EXPECT_NEAR(curvatureAt(first, 0) / ends.start_curvature_per_mm, 1, 1e-10);
    EXPECT_NEAR(curvatureAt(second, 1) / ends.end_curvature_per_mm, 1, 1e-10);
    const Vector2d out = ends.apex - ends.start, in = ends.end - ends.apex;
    EXPECT_LT(test::angleBetween(tangentDirection(first, 0), directionOf(out)), 1e-12);
    EXPECT_LT(test::angleBetween(tangentDirection(second, 1), directionOf(in)), 1e-12);
  }
}

// Identity (2): reversal and mirror.
TEST(TwoConics, OfReversedEndsAreReversed) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const TwoConicsEnds ends = randomEnds(random);
    const TwoConicsEnds back = {.start = ends.end,
                                .apex = ends.apex,
                                .end = ends.start,
                                .start_curvature_per_mm = -ends.end_curvature_per_mm,
                                .end_curvature_per_mm = -ends.start_curvature_per_mm,
                                .start_share = ends.end_share,
                                .end_share = ends.start_share};
    const auto one = twoConics(ends), other = twoConics(back);
    for (int k : {0, 1}) {
      const PlanarConic expected = reversed(one[1 - k]);
      EXPECT_LT((other[k].start - expected.start).norm(), 1e-12);
      EXPECT_LT((other[k].corner - expected.corner).norm(), 1e-12);
      EXPECT_NEAR(other[k].weight / expected.weight, 1, 1e-11);
    }
  }
}

TEST(TwoConics, AgreeWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("two_conics.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    TwoConicsEnds ends = {.start = planarVector(in["P0"]),
                          .apex = planarVector(in["d"]),
                          .end = planarVector(in["P4"]),
                          .start_curvature_per_mm = number(in["k0"]),
                          .end_curvature_per_mm = number(in["k2"]),
                          .start_share = number(in["s"]),
                          .end_share = number(in["q"])};
    const Vector2d a = ends.apex - ends.start, b = ends.end - ends.apex;
    if (a.x() * b.y() - a.y() * b.x() < 0) {
      ends.start_curvature_per_mm *= -1;
      ends.end_curvature_per_mm *= -1;
    }
    const auto [first, second] = twoConics(ends);
    EXPECT_LT((first.end - planarVector(out["P2"])).norm(), 1e-13);
    EXPECT_NEAR(first.weight, number(out["w1"]), 1e-13);
    EXPECT_NEAR(second.weight, number(out["w2"]), 1e-13);
    EXPECT_NEAR(std::abs(first.endCurvature_per_mm()), number(out["kappa_mid"]), 1e-11);
  }
}

TEST(TwoConics, InvalidEndsAreNamed) {
  const TwoConicsEnds good = {
      .apex = {1, 0}, .end = {2, 1}, .start_curvature_per_mm = 1, .end_curvature_per_mm = 1};
  EXPECT_NO_THROW(twoConics(good));
  const auto message = [&](auto change) -> std::string {
    TwoConicsEnds ends = good;
    change(ends);
    try {
      twoConics(ends);
      return "nothing";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_THAT(message([](auto& e) { e.end = {3, 0}; }), HasSubstr("on a line"));
  EXPECT_THAT(message([](auto& e) { e.apex = e.start; }), HasSubstr("on a line"));
  EXPECT_THAT(message([](auto& e) { e.end_curvature_per_mm = -1; }), HasSubstr("sign of the turn"));
  EXPECT_THAT(message([](auto& e) { e.start_curvature_per_mm = 0; }),
              HasSubstr("sign of the turn"));
  EXPECT_THAT(message([](auto& e) { e.start_share = 1; }), HasSubstr("share 1"));
  EXPECT_THAT(message([](auto& e) { e.end_share = std::nan(""); }), HasSubstr("share nan"));
  EXPECT_THAT(message([](auto& e) { e.apex.x() = INFINITY; }), HasSubstr("not finite"));
}

/// A convex G1 chain; its neighbours turn by less than \p most_turn together.
std::vector<PlanarConic> randomChain(std::mt19937_64& random, int count, double most_turn) {
  const double sign = random() % 2 == 0 ? 1 : -1;
  std::vector<PlanarConic> chain;
  Vector2d point(uniform(random, -5, 5), uniform(random, -5, 5));
  double direction = uniform(random, -3, 3);
  for (int i = 0; i < count; ++i) {
    PlanarConic conic = {.start = point, .weight = uniform(random, 0.3, 2)};
    conic.corner = point + uniform(random, 0.5, 2) * unitVector(direction);
    direction += sign * uniform(random, 0.05, most_turn / 2);
    point = conic.end = conic.corner + uniform(random, 0.5, 2) * unitVector(direction);
    chain.push_back(conic);
  }
  return chain;
}

/// Regular closed chain of arcs of different conics, around the origin.
std::vector<PlanarConic> closedChain(std::mt19937_64& random, int count) {
  std::vector<Vector2d> corners;
  for (int i = 0; i < count; ++i)
    corners.push_back(uniform(random, 2.9, 3.1) * unitVector(2 * pi * i / count));
  std::vector<PlanarConic> chain;
  const auto joint = [&](int i) -> Vector2d {
    return (corners[(i + count - 1) % count] + corners[i % count]) / 2;
  };
  for (int i = 0; i < count; ++i)
    chain.push_back({.start = joint(i),
                     .corner = corners[i],
                     .end = joint(i + 1),
                     .weight = uniform(random, 0.5, 1.2)});
  chain.back().end = chain.front().start;
  return chain;
}

// Identities (3) and (4), for open chains with and without division.
TEST(G2Conics, OpenChainsBecomeG2) {
  std::mt19937_64 random(testSeed());
  int divided = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<PlanarConic> chain = randomChain(random, 1 + i % 9, i % 2 == 0 ? 2 : 5.5);
    const double factor = i % 3 == 0 ? uniform(random, 0.5, 2) : 1;
    const double start = factor * chain.front().startCurvature_per_mm();
    G2ConicOptions options;
    if (factor != 1) options.start_curvature_per_mm = start;
    const G2Conics found = g2Conics(chain, options);
    divided += found.divisions;
    EXPECT_THAT(found.g1_joints, IsEmpty());
    EXPECT_EQ(found.conics.size(), chain.size() + found.divisions);
    for (std::size_t k = 1; k < found.conics.size(); ++k)
      expectG2(found.conics[k - 1], found.conics[k], 1e-8);
    EXPECT_NEAR(curvatureAt(found.conics.front(), 0) / start, 1, 1e-8);
    EXPECT_NEAR(curvatureAt(found.conics.back(), 1) / curvatureAt(chain.back(), 1), 1, 1e-8);
    EXPECT_LT(test::angleBetween(tangentDirection(found.conics.front(), 0),
                                 tangentDirection(chain.front(), 0)),
              1e-10);
    // Every joint of the chain is one of the result.
    for (const PlanarConic& conic : chain) {
      EXPECT_TRUE(std::ranges::any_of(
          found.conics, [&](const PlanarConic& one) { return one.start == conic.start; }));
    }
    EXPECT_EQ(found.conics.back().end, chain.back().end);
  }
  EXPECT_GT(divided, 20);
}

// Identity (3) for closed chains: also the joint that closes it.
TEST(G2Conics, ClosedChainsBecomeG2) {
  std::mt19937_64 random(testSeed());
  for (const int count : {3, 4, 7, 12}) {
    const std::vector<PlanarConic> chain = closedChain(random, count);
    const G2Conics found = g2Conics(chain, {.closed = true});
    EXPECT_THAT(found.g1_joints, IsEmpty());
    const std::size_t n = found.conics.size();
    for (std::size_t k = 0; k < n; ++k) expectG2(found.conics[k], found.conics[(k + 1) % n], 1e-8);
    EXPECT_EQ(found.conics.front().start, chain.front().start);
    EXPECT_LE(found.least_weight, found.largest_weight);
  }
}

// Identity (5).
TEST(G2Conics, AG2ChainStaysAsItIs) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const G2Conics once = g2Conics(randomChain(random, 6, 2.5));
    const G2Conics twice = g2Conics(once.conics);
    ASSERT_EQ(once.conics.size(), twice.conics.size());
    EXPECT_LT(twice.largest_move_mm, 1e-7);
    for (std::size_t k = 0; k < once.conics.size(); ++k)
      EXPECT_NEAR(once.conics[k].weight / twice.conics[k].weight, 1, 1e-6);
  }
}

TEST(G2Conics, AgreeWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("g2_conics.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    std::vector<PlanarConic> chain;
    for (std::size_t i = 0; i < in["w"].size(); ++i)
      chain.push_back({.start = planarVector(in["P"][2 * i]),
                       .corner = planarVector(in["P"][2 * i + 1]),
                       .end = planarVector(in["P"][2 * i + 2]),
                       .weight = number(in["w"][i])});
    const double sign = chain.front().turn_rad() > 0 ? 1 : -1;
    const G2Conics found =
        g2Conics(chain, {.start_curvature_per_mm = sign * std::abs(number(in["k_start"]))});
    ASSERT_EQ(found.conics.size(), chain.size());
    for (std::size_t i = 0; i < chain.size(); ++i) {
      EXPECT_LT((found.conics[i].corner - planarVector(out["P_new"][2 * i + 1])).norm(), 1e-11);
      EXPECT_NEAR(found.conics[i].weight, number(out["w_new"][i]), 1e-11);
    }
  }
}

// A chain with an inflection and a line stays G1 there, and is G2 elsewhere.
TEST(G2Conics, InflectionsAndLinesStayG1) {
  const std::vector<PlanarArc> arcs = [] {
    std::vector<PlanarArc> result;
    PlanarArc arc = {.direction_rad = 0.3};
    for (const double k : {1.0, 0.5, -0.4, -0.9, 0.0, 0.7, 0.3}) {
      arc.curvature_per_mm = k;
      arc.length_mm = 0.8;
      result.push_back(arc);
      arc.start = arc.end();
      arc.direction_rad = arc.endDirection_rad();
    }
    return result;
  }();
  const G2Conics found = g2Conics(conicsOf(arcs));
  EXPECT_THAT(found.g1_joints, ElementsAre(2, 4, 5));
  for (int k : {1, 3, 6}) expectG2(found.conics[k - 1], found.conics[k], 1e-9);
}

// Closed chain of arcs with inflections: joints are counted from the given first segment.
TEST(G2Conics, AClosedChainWithInflectionsBeginsWhereItDid) {
  // A peanut: eight arcs, symmetric to both axes.
  std::vector<PlanarArc> arcs;
  PlanarArc arc = {.direction_rad = pi / 2};
  for (const double sweep :
       {0.9, 0.9, 0.9, -0.5 - 0.629203673205103, 0.9, 0.9, 0.9, -0.5 - 0.629203673205103}) {
    // Sweeps sum up to 2 pi; equal lengths give a closed curve by symmetry.
    arc.length_mm = 1;
    arc.curvature_per_mm = sweep;
    arcs.push_back(arc);
    arc.start = arc.end();
    arc.direction_rad = arc.endDirection_rad();
  }
  double total = 0;
  for (const PlanarArc& one : arcs) total += one.sweep_rad();
  const double correction = (2 * pi - total) / 8;
  arc = {.direction_rad = pi / 2};
  for (PlanarArc& one : arcs) {
    one = {.start = arc.start,
           .direction_rad = arc.direction_rad,
           .curvature_per_mm = one.curvature_per_mm + correction,
           .length_mm = 1};
    arc.start = one.end();
    arc.direction_rad = one.endDirection_rad();
  }
  ASSERT_LT((arcs.back().end() - arcs.front().start).norm(), 1e-12);
  std::rotate(arcs.begin(), arcs.begin() + 1, arcs.end());
  const G2Conics found = g2Conics(conicsOf(arcs), {.closed = true});
  EXPECT_EQ(found.conics.front().start, arcs.front().start);
  EXPECT_THAT(found.g1_joints, ElementsAre(2, 3, 6, 7));
  for (int k : {1, 5, 8}) expectG2(found.conics[k - 1], found.conics[k % 8], 1e-9);
}

TEST(G2Conics, InvalidChainsAreNamed) {
  std::mt19937_64 random(testSeed());
  const std::vector<PlanarConic> good = randomChain(random, 3, 2);
  const auto message = [&](auto change, G2ConicOptions options = {}) -> std::string {
    std::vector<PlanarConic> chain = good;
    change(chain);
    try {
      g2Conics(chain, options);
      return "nothing";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  const auto nothing = [](auto&) {};
  EXPECT_THAT(message([](auto& c) { c.clear(); }), HasSubstr("empty"));
  EXPECT_THAT(message([](auto& c) { c[1].weight = 0; }), HasSubstr("weight of segment 1 is 0"));
  EXPECT_THAT(message([](auto& c) { c[2].corner.x() = std::nan(""); }), HasSubstr("segment 2"));
  EXPECT_THAT(message([](auto& c) { c[1].corner = c[1].start; }), HasSubstr("one of its ends"));
  EXPECT_THAT(message([](auto& c) { c[1].start.x() += 0.1; }), HasSubstr("mm apart"));
  EXPECT_THAT(message([](auto& c) { c[1].corner.x() += 0.1; }), HasSubstr("not G1"));
  EXPECT_THAT(message(nothing, {.closed = true}), HasSubstr("joint 0"));
  EXPECT_THAT(message(nothing, {.start_curvature_per_mm = 0}), HasSubstr("sign"));
}

/// A conic with its corner anywhere, also such that it turns back.
PlanarConic randomConic(std::mt19937_64& random) {
  return {.start = {uniform(random, -2, 2), uniform(random, -2, 2)},
          .corner = {uniform(random, -2, 2), uniform(random, -2, 2)},
          .end = {uniform(random, -2, 2), uniform(random, -2, 2)},
          .weight = std::exp(uniform(random, -1.5, 1.5))};
}

// Identity (6).
TEST(CurvatureKind, IsThatOfTheSignChanges) {
  std::mt19937_64 random(testSeed());
  std::map<ConicCurvature, int> seen;
  for (int i = 0; i < 1000; ++i) {
    const PlanarConic conic = randomConic(random);
    const CurvatureProfile profile = planarCurvatureProfile(bezierCurve(conic));
    if (!profile.undecided_extrema.empty()) continue;
    const ConicCurvature kind = curvatureKind(conic);
    ++seen[kind];
    const bool left = conic.turn_rad() > 0;
    std::vector<bool> maxima;
    for (const CurvatureExtremum& extremum : profile.extrema)
      maxima.push_back(extremum.maximum == left);
    std::sort(maxima.begin(), maxima.end());
    const std::map<ConicCurvature, std::vector<bool>> expected = {
        {ConicCurvature::Monotone, {}},
        {ConicCurvature::OneMaximum, {true}},
        {ConicCurvature::OneMinimum, {false}},
        {ConicCurvature::MaximumAndMinimum, {false, true}}};
    EXPECT_EQ(maxima, expected.at(kind));
  }
  EXPECT_THAT(seen, SizeIs(4));
}

TEST(CurvatureKind, AgreesWithHighPrecision) {
  const std::map<std::string, ConicCurvature> kinds = {
      {"monotone", ConicCurvature::Monotone},
      {"one_max", ConicCurvature::OneMaximum},
      {"one_min", ConicCurvature::OneMinimum},
      {"max_and_min", ConicCurvature::MaximumAndMinimum}};
  for (const nlohmann::json& entry : test::splineCases("conic_extrema.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const PlanarConic conic = {.start = planarVector(in["R0"]),
                               .corner = planarVector(in["R1"]),
                               .end = planarVector(in["R2"]),
                               .weight = number(in["w"])};
    EXPECT_EQ(curvatureKind(conic), kinds.at(out["class"].get<std::string>()));
    const CurvatureProfile profile = planarCurvatureProfile(bezierCurve(conic));
    const std::vector<double> extrema = test::numbers(out["extrema"]);
    ASSERT_EQ(profile.extrema.size(), extrema.size());
    for (std::size_t i = 0; i < extrema.size(); ++i) {
      EXPECT_NEAR(profile.extrema[i].parameters.middle(), extrema[i], 1e-9);
      const double size = number(out["kappa_extrema"][i]);
      EXPECT_NEAR(std::abs(profile.extrema[i].curvature_per_mm), size, 1e-9 * size);
    }
    EXPECT_NEAR(std::abs(conic.startCurvature_per_mm()) / number(out["kappa0"]), 1, 1e-12);
    EXPECT_NEAR(std::abs(conic.endCurvature_per_mm()) / number(out["kappa1"]), 1, 1e-12);
  }
}

TEST(PlanarConic, HalvesAreTheCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const PlanarConic conic = randomConic(random);
    const auto [left, right] = halves(conic);
    EXPECT_EQ(left.end, right.start);
    // The squared weight over the product of the end weights is kept by any reparametrisation; the
    // pieces of the rational curve have the same corners.
    const auto [first, second] = bezierCurve(conic).split(0.5);
    EXPECT_LT((first.poles().row(1).head<2>().transpose() - left.corner).norm(), 1e-13);
    EXPECT_LT((second.poles().row(1).head<2>().transpose() - right.corner).norm(), 1e-13);
    const Eigen::VectorXd w = first.weights();
    EXPECT_NEAR(left.weight * left.weight, w[1] * w[1] / (w[0] * w[2]), 1e-13);
    EXPECT_NEAR(curvatureAt(left, 1), curvatureAt(right, 0), 1e-9 * std::abs(curvatureAt(left, 1)));
  }
}

// The oracle is the rational curve.
TEST(PlanarConic, DirectionAndCurvatureAreThoseOfTheCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    for (const PlanarConic& conic : twoConics(randomEnds(random))) {
      for (const double t : {0.0, 0.3, 0.7, 1.0}) {
        EXPECT_LT(test::angleBetween(conic.directionAt_rad(t), tangentDirection(conic, t)), 1e-11);
        EXPECT_NEAR(conic.curvatureAt_per_mm(t) / curvatureAt(conic, t), 1, 1e-9);
      }
      EXPECT_NEAR(conic.curvatureAt_per_mm(0) / conic.startCurvature_per_mm(), 1, 1e-12);
      EXPECT_NEAR(conic.curvatureAt_per_mm(1) / conic.endCurvature_per_mm(), 1, 1e-12);
    }
  }
}

TEST(PlanarConic, OfAnArcIsOnItsCircle) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const PlanarArc arc = {.start = {uniform(random, -5, 5), uniform(random, -5, 5)},
                           .direction_rad = uniform(random, -3, 3),
                           .curvature_per_mm = i % 5 == 0 ? 0 : uniform(random, -1, 1),
                           .length_mm = uniform(random, 0.2, 3)};
    const std::vector<PlanarConic> conics = conicsOf({arc, arc});
    for (const PlanarConic& conic : {conics.front(), conics.back()}) {
      EXPECT_NEAR(curvatureAt(conic, 0.3), arc.curvature_per_mm, 1e-11);
      EXPECT_NEAR(conic.startCurvature_per_mm(), arc.curvature_per_mm, 1e-11);
    }
    EXPECT_EQ(conics.front().start, arc.start);
    EXPECT_LT((conics.back().end - arc.end()).norm(), 1e-13);
  }
  EXPECT_THROW(conicOf({.curvature_per_mm = 1, .length_mm = 3.2}), std::domain_error);
}

// Identity (7).
TEST(PlanarConic, LengthsOfCirclesAndParabolas) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const double sweep_rad = i % 2 == 0 ? uniform(random, -3.1, 3.1) : uniform(random, -0.1, 0.1);
    const PlanarArc arc = {.start = {uniform(random, -5, 5), uniform(random, -5, 5)},
                           .direction_rad = uniform(random, -3, 3),
                           .curvature_per_mm = sweep_rad / 2,
                           .length_mm = 2};
    EXPECT_NEAR(conicOf(arc).length_mm(), 2, 2e-10);
  }
  // y = x^2 over [0, a] with the slope m = 2 a at its end.
  const double a = 1.5, m = 2 * a;
  const PlanarConic parabola = {.start = {0, 0}, .corner = {a / 2, 0}, .end = {a, a * a}};
  const double expected = (m * std::sqrt(1 + m * m) + std::asinh(m)) / 4;
  EXPECT_NEAR(parabola.length_mm(), expected, 1e-10 * expected);
  for (int i = 0; i < 50; ++i) {
    const PlanarConic conic = randomConic(random);
    const double length_mm = conic.length_mm();
    const auto [first, second] = halves(conic);
    EXPECT_NEAR(first.length_mm() + second.length_mm(), length_mm, 2e-10 * length_mm);
    EXPECT_NEAR(reversed(conic).length_mm(), length_mm, 2e-10 * length_mm);
  }
  EXPECT_EQ(PlanarConic{}.length_mm(), 0);
  EXPECT_THROW(static_cast<void>(PlanarConic{.corner = {1, 0}, .weight = -1}.length_mm()),
               std::invalid_argument);
}

TEST(PlanarConic, AChainIsASpline) {
  std::mt19937_64 random(testSeed());
  const std::vector<PlanarConic> chain = g2Conics(closedChain(random, 5), {.closed = true}).conics;
  const BezierSpline spline = bezierSpline(chain, true);
  EXPECT_EQ(spline.segments(), static_cast<int>(chain.size()));
  for (const CurveJoint& joint : measureJoints(spline, 2)) {
    EXPECT_EQ(joint.gap_mm.value(), 0);
    EXPECT_LT(joint.angle_rad.value(), 1e-10);
  }
  EXPECT_THROW(bezierSpline(std::vector<PlanarConic>{}, false), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
