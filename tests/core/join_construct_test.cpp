// SPDX-License-Identifier: LGPL-2.1-or-later
// Constructed joins against rows known to 40 digits, and against the equations they stand for.
#include <gmock/gmock.h>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::built;
using test::function;
using test::gentlePatch;
using test::gentleTriangle;
using test::relativeError;
using test::uniform;
using test::value;
using test::whole;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double wanted = 1e-12;

Ribbon endingAtU1(const json& net) {
  return test::endingAtU1(test::patch(net));
}

ConnectionFunctions connectionOf(const json& input) {
  ConnectionFunctions c;
  const auto take = [&](const char* key, Eigen::VectorXd& f) {
    if (input.contains(key)) f = function(input[key]);
  };
  take("alpha", c.alpha);
  take("beta", c.beta);
  take("p", c.p);
  take("q", c.q);
  take("e0", c.e0);
  take("e1", c.e1);
  take("gamma", c.e1);
  take("e2", c.e2);
  return c;
}

// Rows of the data files.

TEST(JoinRowsData, RowsBesidePatches) {
  for (const json& entry : test::dataCases("tensor_joins.json", "construct")) {
    const JoinRows found = tensorRows(endingAtU1(entry["input"]["P"]), connectionOf(entry["input"]),
                                      1, entry["input"]["l"]);
    const json& expected = entry["expected"];
    EXPECT_EQ(found.rows[0].rows() - 1, expected["along_degree"].get<int>()) << entry["id"];
    EXPECT_LE(relativeError(found.rows[0], test::row(expected["Q_row0"])), wanted) << entry["id"];
    EXPECT_LE(relativeError(found.rows[1], test::row(expected["Q_row1"])), wanted) << entry["id"];
  }
}

TEST(JoinRowsData, TensorG1InTheSameDegree) {
  for (const json& entry : test::dataCases("tensor_joins.json", "construct_same_degree")) {
    const json &input = entry["input"], &expected = entry["expected"];
    const auto build = [&] {
      json functions = input;
      functions.erase("q");  // here the degree
      return tensorRows(endingAtU1(input["P"]), connectionOf(functions), 1, input["l"],
                        input["q"].get<int>());
    };
    if (!expected["representable"].get<bool>()) {
      EXPECT_THAT(build, ThrowsMessage<std::invalid_argument>(HasSubstr("the defect is ")));
      continue;
    }
    EXPECT_LE(relativeError(build().rows[1], test::row(expected["Q_row1"])), wanted) << entry["id"];
  }
}

TEST(JoinRowsData, RowsBesideRationalPatches) {
  for (const json& entry : test::dataCases("tensor_joins.json", "rational_construct")) {
    json input = entry["input"];
    const JoinRows found =
        tensorRows(endingAtU1(input["P_hom"]), connectionOf(input), 1, input["l"]);
    EXPECT_LE(relativeError(found.rows[0], test::row(entry["expected"]["Q_row0"])), wanted)
        << entry["id"];
    EXPECT_LE(relativeError(found.rows[1], test::row(entry["expected"]["Q_row1"])), wanted)
        << entry["id"];
  }
}

TEST(JoinRowsData, TensorG2AndRational) {
  for (const auto& [file, kind, net, rows] :
       {std::array{"g2_joins.json", "g2_construct", "P", "rows"},
        std::array{"rational_surface_joins.json", "rational_surface", "P_hom", "rows_hom"}})
    for (const json& entry : test::dataCases(file, kind)) {
      const json& input = entry["input"];
      const int order = input.value("order", 2);
      const JoinRows found =
          tensorRows(endingAtU1(input[net]), connectionOf(input), order, input["l"]);
      const json& expected = entry["expected"];
      EXPECT_EQ(found.rows[0].rows() - 1, expected["along_degree"].get<int>()) << entry["id"];
      ASSERT_EQ(found.rows.size(), expected[rows].size()) << entry["id"];
      for (std::size_t r = 0; r < found.rows.size(); ++r)
        EXPECT_LE(relativeError(found.rows[r], test::row(expected[rows][r])), wanted)
            << entry["id"] << " " << r;
    }
}

/// The case's cross direction points out of both triangles, with beta < 0 on it and alpha along the
/// seam.
ConnectionFunctions ofTriangles(const json& input) {
  ConnectionFunctions c;
  c.alpha = -function(input["beta"]);
  c.beta = -function(input["alpha"]);
  return c;
}

TEST(JoinRowsData, RowsOfTrianglesBesideTriangles) {
  for (const json& entry : test::dataCases("triangle_joins.json", "tri_construct")) {
    const json& input = entry["input"];
    const Ribbon given =
        ribbon(test::triangle(input["T1"]), TriangleEdge::L0, false, Across::OutOf);
    const JoinRows found = triangleRows(given, ofTriangles(input), 1);
    EXPECT_EQ(found.degree_across, input["degree0"].get<int>()) << entry["id"];
    EXPECT_LE(relativeError(found.rows[0], test::row(entry["expected"]["row0"])), wanted)
        << entry["id"];
    EXPECT_LE(relativeError(found.rows[1], test::row(entry["expected"]["row1"])), wanted)
        << entry["id"];
  }
}

TEST(JoinRowsData, TriangleFromTriangleInTheSameDegree) {
  for (const json& entry : test::dataCases("triangle_joins.json", "tri_construct_same_degree")) {
    const json &input = entry["input"], &expected = entry["expected"];
    const Ribbon given =
        ribbon(test::triangle(input["T1"]), TriangleEdge::L0, false, Across::OutOf);
    const auto build = [&] {
      return triangleRows(given, ofTriangles(input), 1, input["degree0"].get<int>());
    };
    if (expected["representable"].get<bool>())
      EXPECT_LE(relativeError(build().rows[1], test::row(expected["row1"])), wanted) << entry["id"];
    else
      EXPECT_THAT(build, ThrowsMessage<std::invalid_argument>(HasSubstr("the defect is ")));
  }
}

TEST(JoinRowsData, RowsOfPatchesBesideTriangles) {
  for (const json& entry : test::dataCases("triangle_joins.json", "tensor_from_tri")) {
    const json& input = entry["input"];
    // t multiplies P1, so the edge runs backwards; the case's cross direction keeps the weight of
    // P2, not of P1.
    const Ribbon given = ribbon(test::triangle(input["T"]), TriangleEdge::L0, true, Across::OutOf);
    ConnectionFunctions c;
    c.alpha = -function(input["alpha"]);
    c.beta = function(input["beta"]) - function(input["alpha"]);
    const JoinRows found = tensorRows(given, c, 1, input["m"]);
    EXPECT_LE(relativeError(found.rows[0], test::row(entry["expected"]["P_row_m"])), wanted)
        << entry["id"];
    EXPECT_LE(relativeError(found.rows[1], test::row(entry["expected"]["P_row_m1"])), wanted)
        << entry["id"];
  }
}

TEST(JoinRowsData, RowsOfTrianglesBesidePatches) {
  for (const json& entry : test::dataCases("triangle_joins.json", "tri_from_tensor")) {
    const json& input = entry["input"];
    ConnectionFunctions c;
    c.alpha = -function(input["alpha_bar"]);
    c.beta = 1 - function(input["beta_bar"]).array();
    const JoinRows found = triangleRows(endingAtU1(input["P"]), c, 1);
    EXPECT_EQ(found.degree_across, input["tri_degree"].get<int>()) << entry["id"];
    EXPECT_LE(relativeError(found.rows[0], test::row(entry["expected"]["T0"])), wanted)
        << entry["id"];
    EXPECT_LE(relativeError(found.rows[1], test::row(entry["expected"]["T1"])), wanted)
        << entry["id"];
  }
}

// The equations of ConnectionFunctions, evaluated pointwise.

Eigen::Vector4d derivativeAt(const HomogeneousPoles& rows, double t) {
  const Eigen::Index n = rows.rows() - 1;
  if (n == 0) return Eigen::Vector4d::Zero();
  return value(HomogeneousPoles(static_cast<double>(n) * (rows.bottomRows(n) - rows.topRows(n))),
               t);
}

HomogeneousPoles differenced(const HomogeneousPoles& rows) {
  const Eigen::Index n = rows.rows() - 1;
  return n == 0 ? HomogeneousPoles(HomogeneousPoles::Zero(1, 4))
                : HomogeneousPoles(static_cast<double>(n) * (rows.bottomRows(n) - rows.topRows(n)));
}

/// By how much b misses the equations with a, relative to the sizes of their terms.
double equationDefect(const Ribbon& a, const Ribbon& b, const ConnectionFunctions& c, int order,
                      double t) {
  const auto f = [t](const Eigen::VectorXd& g) { return value(g, t); };
  const Eigen::Vector4d P = value(a.position, t), P_s = value(a.first, t),
                        P_t = derivativeAt(a.position, t);
  const Eigen::Vector4d Y1 = f(c.alpha) * P_s + f(c.beta) * P_t;
  double worst = (value(b.position, t) - f(c.e0) * P).norm() / P.norm();
  const double scale = P.norm() + P_s.norm() + P_t.norm();
  worst = std::max(worst, (value(b.first, t) - f(c.e1) * P - f(c.e0) * Y1).norm() / scale);
  if (order < 2) return worst;
  const Eigen::Vector4d P_ss = value(a.second, t), P_st = derivativeAt(a.first, t),
                        P_tt = derivativeAt(differenced(a.position), t);
  const Eigen::Vector4d Y2 = std::pow(f(c.alpha), 2) * P_ss + 2 * f(c.alpha) * f(c.beta) * P_st +
                             std::pow(f(c.beta), 2) * P_tt + f(c.p) * P_s + f(c.q) * P_t;
  const Eigen::Vector4d expected = f(c.e2) * P + 2 * f(c.e1) * Y1 + f(c.e0) * Y2;
  const double scale_2 = scale + P_ss.norm() + P_st.norm() + P_tt.norm();
  worst = std::max(worst, (value(b.second, t) - expected).norm() / scale_2);
  if (order < 3) return worst;
  const Eigen::Vector4d P_sss = value(a.third, t), P_sst = derivativeAt(a.second, t),
                        P_stt = derivativeAt(differenced(a.first), t),
                        P_ttt = derivativeAt(differenced(differenced(a.position)), t);
  const double alpha = f(c.alpha), beta = f(c.beta), p = f(c.p), q = f(c.q);
  const Eigen::Vector4d Y3 =
      std::pow(alpha, 3) * P_sss + 3 * alpha * alpha * beta * P_sst +
      3 * alpha * beta * beta * P_stt + std::pow(beta, 3) * P_ttt +
      3 * (alpha * p * P_ss + (alpha * q + beta * p) * P_st + beta * q * P_tt) + f(c.h) * P_s +
      f(c.k) * P_t;
  const Eigen::Vector4d third = f(c.e3) * P + 3 * f(c.e2) * Y1 + 3 * f(c.e1) * Y2 + f(c.e0) * Y3;
  return std::max(worst, (value(b.third, t) - third).norm() /
                             (scale_2 + P_sss.norm() + P_sst.norm() + P_stt.norm() + P_ttt.norm()));
}

/// The third derivative by u at u = 0 of E(u, t) P(sigma(u, t), tau(u, t)), by differences: P is
/// continued by its Taylor polynomial across the seam.
Eigen::Vector4d thirdByDifferences(const Ribbon& a, const ConnectionFunctions& c, double t) {
  const auto f = [t](const Eigen::VectorXd& g) { return value(g, t); };
  const auto at = [&](double u) -> Eigen::Vector4d {
    const double s = f(c.alpha) * u + f(c.p) * u * u / 2 + f(c.h) * u * u * u / 6,
                 tau = t + f(c.beta) * u + f(c.q) * u * u / 2 + f(c.k) * u * u * u / 6,
                 e = f(c.e0) + f(c.e1) * u + f(c.e2) * u * u / 2 + f(c.e3) * u * u * u / 6;
    return e * (value(a.position, tau) + s * value(a.first, tau) +
                s * s / 2 * value(a.second, tau) + s * s * s / 6 * value(a.third, tau));
  };
  const auto central = [&](double h) -> Eigen::Vector4d {
    return (at(2 * h) - 2 * at(h) + 2 * at(-h) - at(-2 * h)) / (2 * h * h * h);
  };
  // The error of the difference has even powers of the step, two of which are removed.
  constexpr double h = 4e-3;
  const Eigen::Vector4d one = (4 * central(h) - central(2 * h)) / 3,
                        two = (4 * central(2 * h) - central(4 * h)) / 3;
  return (16 * one - two) / 15;
}

TEST(JoinConstruct, TheThirdDerivativeIsThatOfTheReparametrisedSide) {
  std::mt19937_64 random(testSeed());
  int count = 0;
  for (int run = 0; run < 200; ++run) {
    const BezierPatch patch =
        gentlePatch(whole(1, 4, random), whole(1, 4, random), run % 3 == 0, random);
    ConnectionFunctions c =
        test::randomConnection(whole(0, 1, random), whole(0, 2, random), random);
    if (run % 3 == 0) c = test::withScaling(c, random);
    const Ribbon given = test::endingAtU1(patch);
    const auto next = built([&] { return continuation(given, c, 3, 4); });
    if (!next) continue;
    ++count;
    const Ribbon found = ribbon(*next, PatchEdge::U0, false, Across::Into);
    for (const double t : {0.2, 0.5, 0.8}) {
      const Eigen::Vector4d expected = thirdByDifferences(given, c, t);
      EXPECT_LE((value(found.third, t) - expected).norm(), 1e-5 * (100 + expected.norm())) << run;
    }
  }
  EXPECT_GE(count, 120);
}

TEST(JoinConstruct, Identity1EquationsHoldForTensorPatches) {
  std::mt19937_64 random(testSeed());
  int count = 0;
  for (int run = 0; run < 3000; ++run) {
    const bool rational = run % 3 == 0;
    const BezierPatch patch =
        gentlePatch(whole(1, 7, random), whole(1, 7, random), rational, random);
    const int order = whole(1, 3, random), k = whole(0, 2, random);
    ConnectionFunctions c = test::randomConnection(k, whole(0, k + 1, random), random);
    if (rational) c = test::withScaling(c, random);
    const Ribbon given = ribbon(patch, test::patch_edges[run % 4], run % 8 < 4, Across::OutOf);
    const auto next = built([&] { return continuation(given, c, order, whole(order, 7, random)); });
    if (!next) continue;
    ++count;
    const Ribbon found = ribbon(*next, PatchEdge::U0, false, Across::Into);
    for (const double t : {0.0, 0.3, 1.0})
      EXPECT_LE(equationDefect(given, found, c, order, t), 2e-13) << run;
  }
  EXPECT_GE(count, 2100);
}

TEST(JoinConstruct, Identity4EquationsHoldForTriangles) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1000; ++run) {
    const bool to_tensor = run % 3 == 0, from_tensor = run % 3 == 1;
    const int n = whole(1, 6, random), k = whole(0, 2, random);
    const ConnectionFunctions c = test::randomConnection(k, whole(0, k + 1, random), random);
    const Ribbon given = from_tensor
                             ? ribbon(gentlePatch(whole(1, 5, random), n, false, random),
                                      test::patch_edges[run % 4], run % 2, Across::OutOf)
                             : ribbon(gentleTriangle(n, false, random),
                                      test::triangle_edges[run % 3], run % 2, Across::OutOf);
    const int order = run % 9 / 3 + 1;
    const Ribbon found =
        to_tensor
            ? ribbon(continuation(given, c, order, 4), PatchEdge::U0, false, Across::Into)
            : ribbon(triangleContinuation(given, c, order), TriangleEdge::L0, false, Across::Into);
    for (const double t : {0.0, 0.6, 1.0})
      EXPECT_LE(equationDefect(given, found, c, order, t), 2e-13) << run << " order " << order;
  }
}

TEST(JoinConstruct, ContinuationsAreTheirTaylorPolynomials) {
  std::mt19937_64 random(testSeed());
  const ConnectionFunctions c = test::randomConnection(1, 2, random);
  const Ribbon given =
      ribbon(gentlePatch(3, 3, false, random), PatchEdge::V1, false, Across::OutOf);
  const BezierPatch next = continuation(given, c, 3, 5);
  const Ribbon seam = ribbon(next, PatchEdge::U0, false, Across::Into);
  const BezierTriangle triangle = triangleContinuation(given, c, 2);
  const Ribbon edge = ribbon(triangle, TriangleEdge::L0, false, Across::Into);
  for (const double t : {0.1, 0.7}) {
    const double s = 0.25;
    const Eigen::Vector4d taylor = value(seam.position, t) + s * value(seam.first, t) +
                                   s * s / 2 * value(seam.second, t) +
                                   s * s * s / 6 * value(seam.third, t);
    EXPECT_LE((next.point(s, t) - taylor.head<3>()).norm(), 1e-12);
    const Eigen::Vector4d parabola =
        value(edge.position, t) + s * value(edge.first, t) + s * s / 2 * value(edge.second, t);
    EXPECT_LE((triangle.point(s, 1 - s - t) - parabola.head<3>()).norm(), 1e-12);
  }
}

TEST(JoinConstruct, Identity3OnesAndZerosContinueParametrically) {
  std::mt19937_64 random(testSeed());
  const BezierPatch patch = gentlePatch(4, 3, false, random);
  const BezierPatch next =
      continuation(ribbon(patch, PatchEdge::U1, false, Across::OutOf), {}, 3, 4);
  for (const double t : {0.0, 0.4, 1.0}) {
    const SurfaceJet a = patch.jet(1, t), b = next.jet(0, t);
    for (const auto part :
         {&SurfaceJet::p, &SurfaceJet::u, &SurfaceJet::v, &SurfaceJet::uu, &SurfaceJet::uv,
          &SurfaceJet::vv, &SurfaceJet::uuu, &SurfaceJet::uuv, &SurfaceJet::uvv, &SurfaceJet::vvv})
      EXPECT_LE((a.*part - b.*part).norm(), 1e-11);
  }
  EXPECT_FALSE(next.isRational());
}

TEST(JoinConstruct, DegreesAreThoseOfTheTable) {
  std::mt19937_64 random(testSeed());
  const Ribbon tensor =
      ribbon(gentlePatch(3, 4, false, random), PatchEdge::U1, false, Across::OutOf);
  const Ribbon triangle =
      ribbon(gentleTriangle(4, false, random), TriangleEdge::L0, false, Across::OutOf);
  const auto along = [](const JoinRows& rows) { return rows.rows[0].rows() - 1; };
  const auto functions = [&](int a, int b) { return test::randomConnection(a, b, random); };
  EXPECT_EQ(along(tensorRows(tensor, functions(0, 0), 1, 3)), 4);
  EXPECT_EQ(along(tensorRows(tensor, functions(0, 1), 1, 3)), 4);  // the natural family
  EXPECT_EQ(along(tensorRows(tensor, functions(0, 1), 2, 3)), 4);
  EXPECT_EQ(along(tensorRows(tensor, functions(1, 2), 1, 3)), 5);
  EXPECT_EQ(along(tensorRows(tensor, functions(1, 1), 2, 3)), 6);
  EXPECT_EQ(along(tensorRows(tensor, functions(2, 3), 2, 3)), 8);
  EXPECT_EQ(along(tensorRows(triangle, functions(0, 1), 1, 3)), 4);
  EXPECT_EQ(along(tensorRows(triangle, functions(1, 1), 1, 3)), 4);  // no raise from a triangle
  EXPECT_EQ(along(tensorRows(tensor, functions(0, 1), 3, 3)), 4);
  EXPECT_EQ(along(tensorRows(tensor, functions(1, 2), 3, 3)), 7);
  EXPECT_EQ(along(triangleRows(triangle, functions(0, 0), 1)), 4);
  EXPECT_EQ(along(triangleRows(triangle, functions(1, 1), 1)), 5);
  EXPECT_EQ(along(triangleRows(triangle, functions(0, 0), 2)), 5);
  EXPECT_EQ(along(triangleRows(triangle, functions(0, 0), 3)), 6);
  EXPECT_EQ(along(triangleRows(tensor, functions(0, 0), 1)), 5);
  EXPECT_EQ(along(triangleRows(tensor, functions(0, 1), 2)), 6);
  EXPECT_EQ(along(triangleRows(tensor, functions(0, 1), 3)), 7);
  ConnectionFunctions straight;
  straight.alpha = Eigen::VectorXd::Constant(1, 0.8);
  straight.beta = Eigen::VectorXd::Constant(1, 0.3);
  for (const int order : {1, 2, 3}) EXPECT_EQ(along(triangleRows(triangle, straight, order)), 4);
  ConnectionFunctions same = functions(0, 1);
  same.alpha = Eigen::Vector2d(1.25, 1.25);
  EXPECT_EQ(along(tensorRows(tensor, same, 1, 3)), 4);
  EXPECT_EQ(along(tensorRows(tensor, functions(0, 1), 1, 3, 6)), 6);
}

TEST(JoinConstruct, ReplacedRowsLeaveTheOthers) {
  std::mt19937_64 random(testSeed());
  int replaced = 0;
  for (int run = 0; run < 64; ++run) {
    const PatchEdge edge = test::patch_edges[run % 4];
    const bool reversed = run % 8 < 4, rational = run % 3 == 0;
    const int order = whole(1, 2, random), n = whole(2, 4, random);
    const Ribbon given =
        ribbon(gentlePatch(3, n, rational, random), PatchEdge::U1, false, Across::OutOf);
    const BezierPatch before = gentlePatch(4, 4, rational, random);
    const ConnectionFunctions c = test::randomConnection(0, 1, random);
    const auto rows = built([&] { return tensorRows(given, c, order, 4); });
    if (!rows) continue;
    ++replaced;
    const BezierPatch after = withRows(before, edge, reversed, *rows);
    EXPECT_LE(equationDefect(given, ribbon(after, edge, reversed, Across::Into), c, order, 0.4),
              1e-13);
    const BezierPatch old = turnedToU0(before, edge, reversed),
                      now = turnedToU0(after, edge, reversed);
    for (int i = order + 1; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j) EXPECT_LE((old.pole(i, j) - now.pole(i, j)).norm(), 1e-14);
  }
  EXPECT_GT(replaced, 32);
}

TEST(JoinConstruct, ReplacedRowsOfATriangleLeaveTheOthers) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 18; ++run) {
    const TriangleEdge edge = test::triangle_edges[run % 3];
    const bool reversed = run % 6 < 3;
    const Ribbon given =
        ribbon(gentleTriangle(3, false, random), TriangleEdge::L1, false, Across::OutOf);
    const BezierTriangle before = gentleTriangle(4, false, random);
    const ConnectionFunctions c = test::randomConnection(1, 1, random);
    const BezierTriangle after = withRows(before, edge, reversed, triangleRows(given, c, 1));
    EXPECT_LE(equationDefect(given, ribbon(after, edge, reversed, Across::Into), c, 1, 0.4), 1e-13);
    for (int r = 2; r <= 4; ++r)
      for (int k = 0; k <= 4 - r; ++k) {
        const Eigen::Index row = poleRow(4, edge, reversed, r, k);
        EXPECT_EQ(before.homogeneousPoles().row(row), after.homogeneousPoles().row(row));
      }
  }
}

TEST(JoinConstruct, RowsAreRaisedOrRaiseThePatch) {
  std::mt19937_64 random(testSeed());
  const Ribbon given =
      ribbon(gentlePatch(2, 3, false, random), PatchEdge::U1, false, Across::OutOf);
  const JoinRows rows = tensorRows(given, {}, 1, 3);
  EXPECT_EQ(withRows(gentlePatch(3, 5, false, random), PatchEdge::U0, false, rows).degreeV(), 5);
  EXPECT_EQ(withRows(gentlePatch(3, 2, false, random), PatchEdge::U0, false, rows).degreeV(), 3);
  const BezierTriangle raised = withRows(gentleTriangle(2, false, random), TriangleEdge::L1, true,
                                         triangleRows(given, {}, 1));
  EXPECT_EQ(raised.degree(), 4);
  EXPECT_LE(equationDefect(given, ribbon(raised, TriangleEdge::L1, true, Across::Into), {}, 1, 0.3),
            1e-13);
}

ConnectionFunctions with(Eigen::VectorXd ConnectionFunctions::*function,
                         const Eigen::VectorXd& coefficients) {
  ConnectionFunctions c;
  c.*function = coefficients;
  return c;
}

template <class Build>
std::string refusal(const Build& build) {
  try {
    build();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(JoinConstruct, RefusesBadConnectionsAndDegrees) {
  std::mt19937_64 random(testSeed());
  const Ribbon given =
      ribbon(gentlePatch(3, 3, false, random), PatchEdge::U1, false, Across::OutOf);
  const auto refused = [&](const ConnectionFunctions& c, int order = 1, int across = 3,
                           std::optional<int> degree = {}) {
    return refusal([&] { tensorRows(given, c, order, across, degree); });
  };
  const double nan = std::nan("");
  EXPECT_THAT(refused(with(&ConnectionFunctions::alpha, Eigen::Vector2d(1, -0.25))),
              HasSubstr("alpha is -0.25 at t = 1:"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::alpha, Eigen::Vector3d(1, -3, 1))),
              HasSubstr("alpha is "));
  EXPECT_THAT(refused(with(&ConnectionFunctions::alpha, Eigen::Vector3d(1, -1, 1))),
              HasSubstr("at t = 0.5:"));  // touches 0
  EXPECT_THAT(refused(with(&ConnectionFunctions::alpha, Eigen::Vector3d(1, -0.9, 1))),
              HasSubstr("nothing was refused"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::alpha, Eigen::VectorXd::Zero(1))),
              HasSubstr("alpha is 0"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::beta, Eigen::Vector2d(0, nan))),
              HasSubstr("beta has coefficient 1 = nan"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::q, Eigen::VectorXd())),
              HasSubstr("q has no coefficient"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::e0, -Eigen::VectorXd::Ones(1))),
              HasSubstr("e0 is -1"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::e1, Eigen::VectorXd::Constant(1, -4))),
              HasSubstr("row 1, pole 0 has weight -0.33333333333333326: it must be positive; e1"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::beta, Eigen::VectorXd::Random(200))),
              HasSubstr("beta has degree 199"));
  EXPECT_THAT(refused(with(&ConnectionFunctions::gamma, Eigen::Vector2d(1, 2))),
              HasSubstr("gamma is not 1"));
  EXPECT_THAT(refused({}, 4), HasSubstr("order 4"));
  EXPECT_THAT(refused({}, 0), HasSubstr("order 0"));
  EXPECT_THAT(refused({}, 2, 1), HasSubstr("order 2 needs a degree across of at least as much: 1"));
  EXPECT_THAT(refused({}, 1, 3, 2), HasSubstr("cannot be written in degree 2"));
  EXPECT_THAT(refused({}, 1, 3, 100000), HasSubstr("degree 100000"));
  EXPECT_THAT(refused({}, 1, 3, -1), HasSubstr("degree -1"));
  EXPECT_THAT(refusal([&] { triangleRows(given, {}, 1, 3); }),
              HasSubstr("Q_s has degree 3 and cannot be written in degree 2"));
  EXPECT_THAT(refusal([&] {
                withRows(gentlePatch(2, 3, false, random), PatchEdge::U0, false,
                         tensorRows(given, {}, 1, 3));
              }),
              HasSubstr("the patch has degree 2"));
  EXPECT_THAT(refusal([&] {
                withRows(gentleTriangle(5, false, random), TriangleEdge::L0, false,
                         triangleRows(given, {}, 1));
              }),
              HasSubstr("rows for a triangle of degree 4"));
  Ribbon broken = given;
  broken.first(0, 0) = nan;
  EXPECT_THAT(refusal([&] { continuation(broken, {}, 1, 2); }), HasSubstr("not finite"));
}

}  // namespace
}  // namespace seamwright
