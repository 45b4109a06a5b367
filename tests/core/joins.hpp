// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <seamwright/core/join/condition/construct.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "seam_sides.hpp"

/// Random patches, triangles and connection functions, and those of the data files.
namespace seamwright::test {

inline constexpr std::array patch_edges = {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0,
                                           PatchEdge::V1};
inline constexpr std::array triangle_edges = {TriangleEdge::L0, TriangleEdge::L1, TriangleEdge::L2};

inline double uniform(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline int whole(int low, int high, std::mt19937_64& random) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

/// A patch of 10 mm by 12 mm and at most 3 mm high, its poles a quarter of their spacing off a
/// grid.
inline BezierPatch gentlePatch(int m, int n, bool rational, std::mt19937_64& random) {
  Poles poles((m + 1) * (n + 1), 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(poles.rows());
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const Eigen::Index row = static_cast<Eigen::Index>(i) * (n + 1) + j;
      poles.row(row) << 10 * (i + uniform(-0.25, 0.25, random)) / m,
          12 * (j + uniform(-0.25, 0.25, random)) / n, uniform(-1.5, 1.5, random);
      if (rational) weights(row) = uniform(0.5, 2, random);
    }
  return {m, n, poles, weights};
}

/// A triangle of 10 mm, its poles off a grid as those of gentlePatch().
inline BezierTriangle gentleTriangle(int n, bool rational, std::mt19937_64& random) {
  Poles poles((n + 1) * (n + 2) / 2, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(poles.rows());
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Eigen::Index row = BezierTriangle::row(n, i, j);
      poles.row(row) << 10 * (i + uniform(-0.25, 0.25, random)) / n,
          10 * (j + uniform(-0.25, 0.25, random)) / n, uniform(-1.5, 1.5, random);
      if (rational) weights(row) = uniform(0.5, 2, random);
    }
  return {poles, weights};
}

inline Eigen::VectorXd randomFunction(int degree, double low, double high,
                                      std::mt19937_64& random) {
  Eigen::VectorXd f(degree + 1);
  for (double& c : f) c = uniform(low, high, random);
  return f;
}

/// alpha, p, h of one degree, beta, q, k of another.
inline ConnectionFunctions randomConnection(int alpha_degree, int beta_degree,
                                            std::mt19937_64& random) {
  ConnectionFunctions c;
  c.alpha = randomFunction(alpha_degree, 0.6, 1.6, random);
  c.beta = randomFunction(beta_degree, -0.4, 0.4, random);
  c.p = randomFunction(alpha_degree, -1, 1, random);
  c.q = randomFunction(beta_degree, -1, 1, random);
  c.h = randomFunction(alpha_degree, -1, 1, random);
  c.k = randomFunction(beta_degree, -1, 1, random);
  return c;
}

inline nlohmann::json dataCases(const char* file, const char* kind) {
  std::ifstream stream(std::string(SEAMWRIGHT_TEST_DATA "/") + file);
  const nlohmann::json data = nlohmann::json::parse(stream);
  nlohmann::json found = nlohmann::json::array();
  for (const nlohmann::json& entry : data["cases"])
    if (entry["kind"] == kind) found.push_back(entry);
  return found;
}

inline Eigen::VectorXd function(const nlohmann::json& values) {
  Eigen::VectorXd f(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < f.size(); ++i) f(i) = number(values[i]);
  return f;
}

/// Points or homogeneous points, as homogeneous rows.
inline HomogeneousPoles row(const nlohmann::json& points) {
  HomogeneousPoles poles(static_cast<Eigen::Index>(points.size()), 4);
  for (Eigen::Index k = 0; k < poles.rows(); ++k)
    for (int c = 0; c < 4; ++c)
      poles(k, c) = c < static_cast<int>(points[k].size()) ? number(points[k][c]) : 1;
  return poles;
}

/// T[i][j] as in BezierTriangle.
inline BezierTriangle triangle(const nlohmann::json& net) {
  const int n = static_cast<int>(net.size()) - 1;
  Poles poles((n + 1) * (n + 2) / 2, 3);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      poles.row(BezierTriangle::row(n, i, j)) = vector(net[i][j]).transpose();
  return BezierTriangle(poles);
}

/// Largest difference of coefficients relative to the largest coefficient.
inline double relativeError(const HomogeneousPoles& found, const HomogeneousPoles& expected) {
  if (found.rows() != expected.rows()) return std::numeric_limits<double>::infinity();
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// Value of a polynomial given by Bernstein coefficients, by its definition.
inline double value(const Eigen::VectorXd& f, double t) {
  const int n = static_cast<int>(f.size()) - 1;
  double sum = 0;
  for (int i = 0; i <= n; ++i) sum += choose(n, i) * std::pow(t, i) * std::pow(1 - t, n - i) * f(i);
  return sum;
}

inline Eigen::Vector4d value(const HomogeneousPoles& rows, double t) {
  Eigen::Vector4d sum;
  for (int c = 0; c < 4; ++c) sum(c) = value(Eigen::VectorXd(rows.col(c)), t);
  return sum;
}

inline Ribbon endingAtU1(const BezierPatch& patch) {
  return ribbon(patch, PatchEdge::U1, false, Across::OutOf);
}
inline Ribbon beginningAtU0(const BezierPatch& patch) {
  return ribbon(patch, PatchEdge::U0, false, Across::Into);
}

/// What is built; nothing where a weight would not be positive, as may be with rational patches.
template <class Build>
auto built(const Build& build) -> std::optional<decltype(build())> {
  try {
    return build();
  } catch (const std::invalid_argument& error) {
    if (std::string(error.what()).find("weight") == std::string::npos) throw;
    return std::nullopt;
  }
}

struct Join {
  Ribbon a, b;
  ConnectionFunctions connection;
  int order = 1;
};

inline ConnectionFunctions withScaling(ConnectionFunctions c, std::mt19937_64& random) {
  c.e0 = randomFunction(whole(0, 1, random), 0.8, 1.25, random);
  c.e1 = randomFunction(0, -0.1, 0.1, random);
  c.e2 = randomFunction(0, -0.1, 0.1, random);
  c.e3 = randomFunction(0, -0.1, 0.1, random);
  return c;
}

/// Tensor-product patches and triangles in the four pairings, one in four rational, those whose
/// weights come out well.
inline Join randomJoin(int run, std::mt19937_64& random) {
  for (;;) {
    const bool rational = run % 4 == 3, from_triangle = run % 3 == 0, to_triangle = run % 5 == 0;
    const int n = whole(1, 7, random), k = whole(0, 2, random);
    Join join;
    join.order = whole(1, 3, random);
    join.connection = randomConnection(k, whole(0, k + 1, random), random);
    if (rational) join.connection = withScaling(join.connection, random);
    if (rational && to_triangle)
      join.connection.e1 = join.connection.e2 = join.connection.e3 = Eigen::VectorXd::Zero(1);
    const bool reversed = run % 2 == 0;
    join.a = from_triangle ? ribbon(gentleTriangle(n, rational, random), triangle_edges[run % 3],
                                    reversed, Across::OutOf)
                           : ribbon(gentlePatch(whole(1, 7, random), n, rational, random),
                                    patch_edges[run % 4], reversed, Across::OutOf);
    try {
      if (to_triangle)
        join.b = ribbon(triangleContinuation(join.a, join.connection, join.order), TriangleEdge::L0,
                        false, Across::Into);
      else
        join.b = beginningAtU0(
            continuation(join.a, join.connection, join.order, whole(join.order, 6, random)));
      return join;
    } catch (const std::invalid_argument&) {
      // a weight that is not positive
    }
  }
}

inline Ribbon mapped(Ribbon ribbon, const Eigen::Matrix3d& linear,
                     const Eigen::RowVector3d& translation) {
  for (HomogeneousPoles* part : ribbon.parts())
    part->leftCols<3>() =
        (part->leftCols<3>() * linear.transpose() + part->col(3) * translation).eval();
  return ribbon;
}

}  // namespace seamwright::test
