// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bspline/blossom.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/spline/g2_spline.hpp>

namespace seamwright {

namespace {

using bernstein::text;

/// The vertices and edges of a polygon, and the edge on which each segment lies.
class Layout {
 public:
  /// \throws std::invalid_argument for too few vertices.
  Layout(const Poles& vertices, bool closed)
      : vertices_(static_cast<int>(vertices.rows())), closed_(closed) {
    if (vertices_ < (closed ? 3 : 4))
      refuse("vertices are " + std::to_string(vertices_) + ": " +
             (closed ? "a closed polygon needs 3" : "an open polygon needs 4"));
  }

  bool closed() const { return closed_; }
  int edges() const { return closed_ ? vertices_ : vertices_ - 1; }
  int segments() const { return closed_ ? vertices_ : vertices_ - 3; }
  int edgeOf(int segment) const { return closed_ ? segment : segment + 1; }
  /// The segment before a joint; joint s is the beginning of segment s.
  int before(int joint) const { return joint > 0 ? joint - 1 : segments() - 1; }
  bool isJoint(int joint) const { return closed_ || (joint > 0 && joint < segments()); }
  /// The vertex where an edge ends.
  int endOf(int edge) const { return (edge + 1) % vertices_; }

 private:
  int vertices_;
  bool closed_;
};

void requireCount(const char* name, std::size_t given, int wanted, const char* each) {
  if (given != static_cast<std::size_t>(wanted))
    refuse(std::string(name) + " are " + std::to_string(given) + ": one for each of " +
           std::to_string(wanted) + " " + each + " is needed");
}

std::string ofEdge(const char* name, const std::vector<double>& values, int edge) {
  return std::string(name) + " of edge " + std::to_string(edge) + " is " + text(values[edge]);
}

void requireVertices(const Poles& vertices, const Layout& layout) {
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    if (!vertices.row(i).allFinite()) refuse("vertex " + std::to_string(i) + " is not finite");
  for (int e = 0; e < layout.edges(); ++e)
    if (vertices.row(e) == vertices.row(layout.endOf(e)))
      refuse("edge " + std::to_string(e) + " has no length: vertices " + std::to_string(e) +
             " and " + std::to_string(layout.endOf(e)) + " are one point");
}

/// The polygon with the shares at open ends set.
G2Polygon completed(G2Polygon polygon, const Layout& layout) {
  requireCount("alpha", polygon.alpha.size(), layout.edges(), "edges");
  requireCount("omega", polygon.omega.size(), layout.edges(), "edges");
  const int last = layout.segments() - 1;
  if (!layout.closed()) {
    polygon.alpha[layout.edgeOf(0)] = 0;
    polygon.omega[layout.edgeOf(last)] = 1;
  }
  for (int s = 0; s <= last; ++s) {
    const int e = layout.edgeOf(s);
    const double alpha = polygon.alpha[e], omega = polygon.omega[e];
    if (layout.isJoint(s) && !(alpha > 0 && alpha < 1))
      refuse(ofEdge("alpha", polygon.alpha, e) + ": it must lie between 0 and 1");
    if (layout.isJoint(s + 1) && !(omega > 0 && omega < 1))
      refuse(ofEdge("omega", polygon.omega, e) + ": it must lie between 0 and 1");
    if (!(alpha < omega))
      refuse(ofEdge("alpha", polygon.alpha, e) + ", omega " + text(omega) +
             ": alpha must be the smaller one");
  }
  return polygon;
}

Eigen::RowVector4d vertex(const Poles& vertices, int i) {
  return {vertices(i, 0), vertices(i, 1), vertices(i, 2), 1};
}

/// The poles of the spline. \param ratios of the length of the segment before joint s to that of
/// segment s.
/// \pre completed(), requireVertices().
HomogeneousPoles splinePoles(const G2Polygon& polygon, const Layout& layout,
                             const std::vector<double>& ratios) {
  const int segments = layout.segments();
  HomogeneousPoles poles(3 * segments + 1, 4);
  for (int s = 0; s < segments; ++s) {
    const int e = layout.edgeOf(s);
    const Eigen::RowVector4d from = vertex(polygon.vertices, e),
                             to = vertex(polygon.vertices, layout.endOf(e));
    poles.row(3 * s + 1) = bspline::between(from, to, polygon.alpha[e]);
    poles.row(3 * s + 2) = bspline::between(from, to, polygon.omega[e]);
  }
  for (int s = 0; s < segments; ++s) {
    if (!layout.isJoint(s)) continue;
    const Eigen::RowVector4d y = poles.row(3 * layout.before(s) + 2), x = poles.row(3 * s + 1);
    const double size = std::max(x.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff()),
                 leg = (x - y).norm();
    if (!(leg > 8 * std::numeric_limits<double>::epsilon() * size))
      refuse("vertex " + std::to_string(layout.edgeOf(s)) +
             ": the polygon folds back, the inner poles beside it are " + text(leg) +
             " mm apart and the joint has no tangent");
    poles.row(3 * s) = bspline::between(y, x, ratios[s] / (1 + ratios[s]));
  }
  if (layout.closed()) {
    poles.row(3 * segments) = poles.row(0);
  } else {
    poles.row(0) = vertex(polygon.vertices, 0);
    poles.row(3 * segments) =
        vertex(polygon.vertices, static_cast<int>(polygon.vertices.rows()) - 1);
  }
  return poles;
}

BezierSpline spline(const G2Polygon& polygon, const Layout& layout,
                    const std::vector<double>& ratios, const std::vector<double>& lengths) {
  BezierSpline result{3, {0.0}, splinePoles(polygon, layout, ratios), polygon.closed};
  for (const double length : lengths) result.knots.push_back(result.knots.back() + length);
  requireValid(result);
  return result;
}

}  // namespace

BezierSpline directG2Spline(const G2Polygon& polygon) {
  const Layout layout(polygon.vertices, polygon.closed);
  requireVertices(polygon.vertices, layout);
  const G2Polygon whole = completed(polygon, layout);
  std::vector<double> ratios(layout.segments(), 1.0), lengths(layout.segments(), 1.0);
  for (int s = 0; s < layout.segments(); ++s) {
    if (!layout.isJoint(s)) continue;
    const int e = layout.edgeOf(layout.before(s)), f = layout.edgeOf(s);
    const double lambda = (whole.omega[e] - whole.alpha[e]) / (1 - whole.omega[e]);
    const double rho = whole.alpha[f] / (whole.omega[f] - whole.alpha[f]);
    ratios[s] = std::sqrt(lambda * rho);
    if (s > 0) lengths[s] = lengths[s - 1] / ratios[s];
  }
  return spline(whole, layout, ratios, lengths);
}

G2Polygon g2Polygon(const GammaPolygon& polygon) {
  const Layout layout(polygon.vertices, polygon.closed);
  const int segments = layout.segments();
  requireCount("lengths", polygon.lengths.size(), segments, "segments");
  requireCount("gamma", polygon.gamma.size(), segments, "segments");
  const auto requirePositive = [](const char* name, const std::vector<double>& values, int s) {
    if (!(values[s] > 0 && std::isfinite(values[s])))
      refuse(std::string(name) + " " + std::to_string(s) + " is " + text(values[s]) +
             ": it must be positive");
  };
  for (int s = 0; s < segments; ++s) {
    requirePositive("length", polygon.lengths, s);
    if (layout.isJoint(s)) requirePositive("gamma", polygon.gamma, s);
  }
  G2Polygon result{polygon.vertices, polygon.closed, std::vector<double>(layout.edges(), 0.0),
                   std::vector<double>(layout.edges(), 0.0)};
  for (int s = 0; s < segments; ++s) {
    const int next = s + 1 < segments ? s + 1 : 0;
    const double left =
        layout.isJoint(s) ? polygon.gamma[s] * polygon.lengths[layout.before(s)] : 0;
    const double right = layout.isJoint(s + 1) ? polygon.gamma[next] * polygon.lengths[next] : 0;
    const double sum = left + polygon.lengths[s] + right;
    result.alpha[layout.edgeOf(s)] = left / sum;
    result.omega[layout.edgeOf(s)] = (left + polygon.lengths[s]) / sum;
  }
  return result;
}

BezierSpline gammaSpline(const GammaPolygon& polygon) {
  const Layout layout(polygon.vertices, polygon.closed);
  requireVertices(polygon.vertices, layout);
  const G2Polygon whole = completed(g2Polygon(polygon), layout);
  std::vector<double> ratios(layout.segments(), 1.0);
  for (int s = 0; s < layout.segments(); ++s)
    ratios[s] = polygon.lengths[layout.before(s)] / polygon.lengths[s];
  return spline(whole, layout, ratios, polygon.lengths);
}

}  // namespace seamwright
