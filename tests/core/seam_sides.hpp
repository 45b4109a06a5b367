// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <vector>

#include "curves.hpp"

/// Bezier patches along paths of their parameter planes, for measuring at points and for enclosing.
namespace seamwright::test {

/// 0 and 1, each degree + 1 times.
inline SplineDirection bezierDirection(int degree) {
  SplineDirection direction{degree, std::vector<double>(2 * (degree + 1), 0.0), 0};
  std::fill(direction.knots.begin() + degree + 1, direction.knots.end(), 1.0);
  return direction;
}

inline std::vector<Vec> poleList(const Poles& poles) {
  std::vector<Vec> list;
  for (Eigen::Index i = 0; i < poles.rows(); ++i) list.push_back(poles.row(i).transpose());
  return list;
}

inline std::vector<double> weightList(const Eigen::VectorXd& weights) {
  if ((weights.array() == 1).all()) return {};
  return {weights.data(), weights.data() + weights.size()};
}

inline std::shared_ptr<const SplineEvaluator> splineOf(const BezierPatch& patch) {
  return std::make_shared<SplineEvaluator>(bezierDirection(patch.degreeU()),
                                           bezierDirection(patch.degreeV()),
                                           poleList(patch.poles()), weightList(patch.weights()));
}

inline std::shared_ptr<const SplineEvaluator> splineOf(const BezierCurve& curve) {
  const Poles poles = curve.poles();
  return std::make_shared<SplineEvaluator>(bezierDirection(static_cast<int>(poles.rows()) - 1),
                                           SplineDirection{0, {0, 1}, 0}, poleList(poles),
                                           weightList(curve.weights()));
}

/// The line of the parameter plane from (u0, v0) to (u1, v1).
inline BezierCurve linePath(double u0, double v0, double u1, double v1) {
  Poles poles(2, 3);
  poles << u0, v0, 0, u1, v1, 0;
  return BezierCurve(poles);
}

/// One side of a seam: patch, path, and the place s on the seam at parameter s or, reversed, 1 - s
/// of the path.
struct PatchSide {
  BezierPatch surface;
  BezierCurve path;
  bool face_on_left = true;
  bool reversed = false;

  SidePoint at(double s) const {
    const CurveJet uv = path.jet(reversed ? 1 - s : s);
    SidePoint point;
    point.jet = surface.jet(uv.p.x(), uv.p.y());
    point.noise = surface.noise();
    point.tangent = (reversed ? -1 : 1) * (uv.d1.x() * point.jet.u + uv.d1.y() * point.jet.v);
    point.face_on_left = face_on_left;
    return point;
  }
  SeamSide seamSide() const {
    SeamSide side{splineOf(path), splineEvaluator(splineOf(surface))};
    if (reversed) side.t = {1, 0};
    side.face_on_left = face_on_left;
    return side;
  }
};

inline BezierPatch patch(const nlohmann::json& net) {
  const int m = static_cast<int>(net.size()) - 1, n = static_cast<int>(net[0].size()) - 1;
  Poles poles((m + 1) * (n + 1), 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(poles.rows());
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const nlohmann::json& pole = net[i][j];
      const Eigen::Index row = i * (n + 1) + j;
      if (pole.size() == 4) weights(row) = number(pole[3]);
      for (int c = 0; c < 3; ++c) poles(row, c) = number(pole[c]) / weights(row);
    }
  return {m, n, poles, weights};
}

/// The pcurve of that key, or without it the edge u = const.
inline BezierCurve path(const nlohmann::json& input, const char* key, double u) {
  if (!input.contains(key)) return linePath(u, 0, u, 1);
  Poles poles = Poles::Zero(static_cast<Eigen::Index>(input[key].size()), 3);
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    for (int c = 0; c < 2; ++c) poles(i, c) = number(input[key][i][c]);
  return BezierCurve(poles);
}

inline bool hasPositiveWeights(const nlohmann::json& net) {
  for (const nlohmann::json& row : net)
    for (const nlohmann::json& pole : row)
      if (pole.size() == 4 && number(pole[3]) <= 0) return false;
  return true;
}

/// Binomial coefficient.
inline double choose(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

}  // namespace seamwright::test
