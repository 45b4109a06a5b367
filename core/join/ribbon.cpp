// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <seamwright/core/join/ribbon.hpp>
#include <stdexcept>
#include <vector>

namespace seamwright {

namespace {

constexpr int highest_order = 3;  ///< of the derivatives of a ribbon

/// Row i of the net, i counted along u.
HomogeneousPoles row(const BezierPatch& patch, int i) {
  const int columns = patch.degreeV() + 1;
  return patch.homogeneousPoles().middleRows(static_cast<Eigen::Index>(i) * columns, columns);
}

Ribbon turned(Ribbon ribbon, Across across) {
  if (across == Across::Into) return ribbon;
  ribbon.first = -ribbon.first;
  ribbon.third = -ribbon.third;
  return ribbon;
}

/// The ribbon of rows of poles, counted from the edge. In a triangle each row is shorter than the
/// one before it; its last poles have no difference.
Ribbon ribbonOf(std::vector<HomogeneousPoles> rows, int degree_across, Across across) {
  Ribbon result;
  result.degree_across = degree_across;
  double factor = 1;
  int order = 0;
  for (HomogeneousPoles* part : result.parts()) {
    *part = factor * rows.front();
    factor *= degree_across - order++;
    for (std::size_t r = 0; r + 1 < rows.size(); ++r)
      rows[r] = (rows[r + 1] - rows[r].topRows(rows[r + 1].rows())).eval();
    if (rows.size() > 1) rows.pop_back();
  }
  return turned(std::move(result), across);
}

BezierPatch reversedV(const BezierPatch& patch) {
  return patch.transposed().reversedU().transposed();
}

}  // namespace

BezierPatch turnedToU0(const BezierPatch& patch, PatchEdge edge, bool reversed) {
  const bool along_u = edge == PatchEdge::V0 || edge == PatchEdge::V1;
  BezierPatch turned = along_u ? patch.transposed() : patch;
  if (edge == PatchEdge::U1 || edge == PatchEdge::V1) turned = turned.reversedU();
  return reversed ? reversedV(turned) : turned;
}

BezierPatch turnedFromU0(const BezierPatch& patch, PatchEdge edge, bool reversed) {
  BezierPatch turned = reversed ? reversedV(patch) : patch;
  if (edge == PatchEdge::U1 || edge == PatchEdge::V1) turned = turned.reversedU();
  const bool along_u = edge == PatchEdge::V0 || edge == PatchEdge::V1;
  return along_u ? turned.transposed() : turned;
}

Ribbon ribbon(const BezierPatch& patch, PatchEdge edge, bool reversed, Across across) {
  const BezierPatch turned_patch = turnedToU0(patch, edge, reversed);
  std::vector<HomogeneousPoles> rows;
  for (int r = 0; r <= std::min(turned_patch.degreeU(), highest_order); ++r)
    rows.push_back(row(turned_patch, r));
  return ribbonOf(std::move(rows), turned_patch.degreeU(), across);
}

Eigen::Index poleRow(int degree, TriangleEdge edge, bool reversed, int r, int k) {
  const int opposite = static_cast<int>(edge);
  const int begin = (opposite + 1) % 3, end = (opposite + 2) % 3;
  std::array<int, 3> powers{};
  powers[opposite] = r;
  powers[reversed ? begin : end] = k;
  powers[reversed ? end : begin] = degree - r - k;
  return BezierTriangle::row(degree, powers[0], powers[1]);
}

Ribbon ribbon(const BezierTriangle& triangle, TriangleEdge edge, bool reversed, Across across) {
  const int n = triangle.degree();
  if (n < 1) throw std::invalid_argument("a triangle of degree 0 has no edges");
  const auto behind = [&](int r) {
    HomogeneousPoles poles(n + 1 - r, 4);
    for (int k = 0; k <= n - r; ++k)
      poles.row(k) = triangle.homogeneousPoles().row(poleRow(n, edge, reversed, r, k));
    return poles;
  };
  std::vector<HomogeneousPoles> rows;
  for (int r = 0; r <= std::min(n, highest_order); ++r) rows.push_back(behind(r));
  return ribbonOf(std::move(rows), n, across);
}

CanonicalPair orient(const BezierPatch& a, PatchEdge edge_a, const BezierPatch& b,
                     PatchEdge edge_b) {
  const BezierPatch first = turnedToU0(a, edge_a, false);
  const BezierPatch second = turnedToU0(b, edge_b, false);
  const auto apart = [&](double t, double other) {
    return (first.point(0, t) - second.point(0, other)).norm();
  };
  double same = apart(0, 0) + apart(1, 1), opposite = apart(0, 1) + apart(1, 0);
  const double noise = 64 * std::numeric_limits<double>::epsilon() *
                       (a.poles().cwiseAbs().maxCoeff() + b.poles().cwiseAbs().maxCoeff());
  if (std::abs(same - opposite) <= noise) {
    same = apart(0.25, 0.25) + apart(0.75, 0.75);
    opposite = apart(0.25, 0.75) + apart(0.75, 0.25);
  }
  const bool reversed = opposite < same;
  return {first.reversedU(), reversed ? reversedV(second) : second, reversed};
}

}  // namespace seamwright
