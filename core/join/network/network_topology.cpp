// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/core/join/network/network_topology.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::network {

namespace {

/// The corner of an edge where its own sense begins (end 0) or ends.
int cornerOf(PatchEdge edge, int end) {
  switch (edge) {
    case PatchEdge::U0:
      return end;
    case PatchEdge::U1:
      return 2 + end;
    case PatchEdge::V0:
      return 2 * end;
    case PatchEdge::V1:
      return 2 * end + 1;
  }
  return 0;
}

PatchEdge otherEdge(int corner, PatchEdge edge) {
  if (along(edge) == SurfaceDirection::V) return (corner & 1) != 0 ? PatchEdge::V1 : PatchEdge::V0;
  return (corner & 2) != 0 ? PatchEdge::U1 : PatchEdge::U0;
}

int indexOf(int surface, PatchEdge edge) {
  return 4 * surface + static_cast<int>(edge);
}

/// A side of a seam: -1 for none.
struct Use {
  int seam = -1;
  int side = 0;
};

bool runsBackwards(const NetworkSeam& seam, int side) {
  return side == 1 && seam.reversed;
}

struct Walk {
  const std::vector<NetworkSeam>& seams;
  const std::vector<Use>& uses;

  const Use& useOf(const Corner& corner, PatchEdge edge) const {
    return uses[indexOf(corner.surface, edge)];
  }

  /// The spoke on that edge of the corner, and the corner beyond it, with the edge that leads on.
  Spoke cross(Corner& corner, PatchEdge& edge) const {
    const Use use = useOf(corner, edge);
    const NetworkSeam& seam = seams[use.seam];
    const int own_end = cornerOf(edge, 1) == corner.corner ? 1 : 0;
    const int end = runsBackwards(seam, use.side) ? 1 - own_end : own_end;
    const int beyond = 1 - use.side;
    const PatchEdge entered = seam.edges[beyond];
    corner.surface = seam.surfaces[beyond];
    corner.corner = cornerOf(entered, runsBackwards(seam, beyond) ? 1 - end : end);
    edge = otherEdge(corner.corner, entered);
    return {use.seam, end, use.side == 0};
  }
};

void requireSurface(const NetworkSurface& side, std::size_t index) {
  const std::string name = "surface " + std::to_string(index);
  try {
    requireValid(side.surface);
  } catch (const std::invalid_argument& error) {
    refuse(name + ": " + error.what());
  }
  if (isRational(side.surface.poles)) refuse(name + " is rational: weights of poles must be equal");
  const Eigen::Index count = side.surface.poles.rows();
  if (side.weights.size() != 0 && side.weights.size() != count)
    refuse("weights of " + name + " are " + std::to_string(side.weights.size()) +
           ": none, or one for each of " + std::to_string(count) + " poles is needed");
  if (!side.fixed.empty() && static_cast<Eigen::Index>(side.fixed.size()) != count)
    refuse("fixed poles of " + name + " are " + std::to_string(side.fixed.size()) +
           ": none, or one for each of " + std::to_string(count) + " poles is needed");
  for (Eigen::Index i = 0; i < side.weights.size(); ++i)
    if (!(side.weights(i) > 0) || !std::isfinite(side.weights(i)))
      refuse("weight " + std::to_string(i) + " of a move of " + name + " is " +
             std::to_string(side.weights(i)) + ": weights must be positive and finite");
}

void requireLaw(const SeamLaw& law, const std::string& name) {
  static constexpr std::array names = {"c", "d", "e", "p", "q"};
  const auto all = functions(law);
  for (int f = 0; f < law_functions; ++f) {
    if (all[f]->size() == 0 || all[f]->size() > 7)
      refuse(std::string(names[f]) + " of the law of " + name + " has " +
             std::to_string(all[f]->size()) + " coefficients: 1 to 7 are needed");
    for (Eigen::Index k = 0; k < all[f]->size(); ++k) {
      const double value = (*all[f])(k);
      if (!std::isfinite(value) || (f <= D && !(value > 0)))
        refuse("coefficient " + std::to_string(k) + " of " + names[f] + " of the law of " + name +
               " is " + std::to_string(value) +
               (f <= D ? ": it must be positive" : ": it must be finite"));
    }
  }
}

void requireSameSeam(const nearest::SeamRows& a, const nearest::SeamRows& b,
                     const std::string& name) {
  if (a.degree != b.degree || a.knots.size() != b.knots.size())
    refuse("degrees along " + name + " are " + std::to_string(a.degree) + " and " +
           std::to_string(b.degree) + ", poles " + std::to_string(a.count) + " and " +
           std::to_string(b.count) + ": they must be equal");
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < a.knots.size(); ++i)
    if (!(std::abs(a.knots[i] - b.knots[i]) <= rounding))
      refuse("knot " + std::to_string(i) + " along " + name + ", scaled to 0..1, is " +
             std::to_string(a.knots[i]) + " and " + std::to_string(b.knots[i]) +
             ": they must be equal");
}

}  // namespace

void requireNetwork(const std::vector<NetworkSurface>& surfaces,
                    const std::vector<NetworkSeam>& seams, const NetworkOptions& options) {
  if (!(options.regular_rad >= 0 && options.regular_rad <= 1))
    refuse("regular_rad is " + std::to_string(options.regular_rad) + ": 0 to 1 is needed");
  if (options.max_iterations < 0)
    refuse("max_iterations is " + std::to_string(options.max_iterations) +
           ": it must not be negative");
  for (std::size_t i = 0; i < surfaces.size(); ++i) requireSurface(surfaces[i], i);
  std::vector<int> seam_of(4 * surfaces.size(), -1);
  for (std::size_t i = 0; i < seams.size(); ++i) {
    const NetworkSeam& seam = seams[i];
    const std::string name = "seam " + std::to_string(i);
    if (seam.order != 1 && seam.order != 2)
      refuse("order of " + name + " is " + std::to_string(seam.order) + ": 1 or 2 is needed");
    for (int side = 0; side < 2; ++side) {
      const int surface = seam.surfaces[side];
      if (surface < 0 || surface >= std::ssize(surfaces))
        refuse(name + " names surface " + std::to_string(surface) + " of " +
               std::to_string(surfaces.size()));
      int& use = seam_of[indexOf(surface, seam.edges[side])];
      if (use >= 0)
        refuse("an edge of surface " + std::to_string(surface) + " is in seam " +
               std::to_string(use) + " and in " + name);
      use = static_cast<int>(i);
    }
    requireSameSeam(rowsOf(surfaces, seam, 0, seam.order), rowsOf(surfaces, seam, 1, seam.order),
                    name);
    if (seam.held) requireLaw(*seam.held, name);
  }
}

nearest::SeamRows rowsOf(const std::vector<NetworkSurface>& surfaces, const NetworkSeam& seam,
                         int side, int order) {
  JoinSide of;
  of.surface = surfaces[seam.surfaces[side]].surface;
  of.edge = seam.edges[side];
  of.reversed = runsBackwards(seam, side);
  return nearest::seamRows(of, order);
}

int directionOf(int surface, PatchEdge edge) {
  return 2 * surface + (along(edge) == SurfaceDirection::V ? 1 : 0);
}

std::vector<int> strips(std::size_t surfaces, const std::vector<NetworkSeam>& seams) {
  DisjointSets sets(static_cast<int>(2 * surfaces));
  for (const NetworkSeam& seam : seams)
    sets.unite(directionOf(seam.surfaces[0], seam.edges[0]),
               directionOf(seam.surfaces[1], seam.edges[1]));
  std::vector<int> result(2 * surfaces);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = sets.of(static_cast<int>(i));
  return result;
}

std::vector<Vertex> vertices(std::size_t surfaces, const std::vector<NetworkSeam>& seams,
                             const std::vector<bool>& takes_part) {
  std::vector<Use> uses(4 * surfaces);
  for (std::size_t i = 0; i < seams.size(); ++i)
    for (int side = 0; side < 2 && takes_part[i]; ++side)
      uses[indexOf(seams[i].surfaces[side], seams[i].edges[side])] = {static_cast<int>(i), side};
  const Walk walk{seams, uses};
  std::vector<bool> seen(4 * surfaces, false);
  std::vector<Vertex> result;
  for (int index = 0; index < std::ssize(seen); ++index) {
    if (seen[index]) continue;
    const Corner start{index / 4, index % 4};
    const PatchEdge u = (start.corner & 2) != 0 ? PatchEdge::U1 : PatchEdge::U0;
    // Back to the first corner of an open fan, or once around.
    Corner corner = start;
    PatchEdge edge = u;
    while (walk.useOf(corner, edge).seam >= 0) {
      walk.cross(corner, edge);
      if (corner.surface == start.surface && corner.corner == start.corner) break;
    }
    Vertex vertex;
    const Corner first = corner;
    if (walk.useOf(corner, edge).seam < 0) edge = otherEdge(corner.corner, edge);
    do {
      vertex.corners.push_back(corner);
      seen[4 * corner.surface + corner.corner] = true;
      if (walk.useOf(corner, edge).seam < 0) break;
      vertex.spokes.push_back(walk.cross(corner, edge));
    } while (corner.surface != first.surface || corner.corner != first.corner);
    if (!vertex.spokes.empty()) result.push_back(std::move(vertex));
  }
  return result;
}

Unknowns unknowns(const std::vector<NetworkSurface>& surfaces,
                  const std::vector<NetworkSeam>& seams, const std::vector<bool>& takes_part) {
  std::vector<int> offset = {0};
  for (const NetworkSurface& surface : surfaces)
    offset.push_back(offset.back() + static_cast<int>(surface.surface.poles.rows()));
  DisjointSets sets(offset.back());
  for (std::size_t i = 0; i < seams.size(); ++i) {
    if (!takes_part[i]) continue;
    const NetworkSeam& seam = seams[i];
    const nearest::SeamRows a = rowsOf(surfaces, seam, 0, 1), b = rowsOf(surfaces, seam, 1, 1);
    for (int j = 0; j < a.count; ++j)
      sets.unite(offset[seam.surfaces[0]] + a.pole(0, j), offset[seam.surfaces[1]] + b.pole(0, j));
  }
  Unknowns u;
  std::vector<int> number(offset.back(), -1);
  int count = 0;
  u.of_pole.resize(surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    for (int k = 0; k < surfaces[s].surface.poles.rows(); ++k) {
      int& n = number[sets.of(offset[s] + k)];
      if (n < 0) n = count++;
      u.of_pole[s].push_back(n);
    }

  // The middle of the box, which does not depend on the order of surfaces.
  Eigen::RowVector3d low = Eigen::RowVector3d::Constant(std::numeric_limits<double>::infinity()),
                     high = -low;
  std::vector<Poles> poles;
  for (const NetworkSurface& surface : surfaces) {
    poles.push_back(affinePoles(surface.surface.poles));
    low = low.cwiseMin(poles.back().colwise().minCoeff());
    high = high.cwiseMax(poles.back().colwise().maxCoeff());
  }
  u.largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  u.centre = (low + high) / 2;
  u.target = Eigen::MatrixXd::Zero(count, 3);
  u.move_weights = Eigen::VectorXd::Zero(count);
  u.contradiction = Eigen::VectorXd::Zero(count);
  u.shared.assign(count, 0);
  std::vector<bool> stays(count, false);
  const auto each = [&](const auto& visit) {
    for (std::size_t s = 0; s < surfaces.size(); ++s)
      for (int k = 0; k < poles[s].rows(); ++k) {
        const NetworkSurface& of = surfaces[s];
        const bool fixed = !of.moves || (!of.fixed.empty() && of.fixed[k]);
        const double weight = of.weights.size() == 0 ? 1.0 : of.weights(k);
        visit(u.of_pole[s][k], fixed, weight, Eigen::RowVector3d(poles[s].row(k) - u.centre));
      }
  };
  each([&](int i, bool fixed, double weight, const Eigen::RowVector3d& x) {
    ++u.shared[i];
    if (fixed && !stays[i]) u.target.row(i) = x;
    stays[i] = stays[i] || fixed;
    if (!stays[i]) u.target.row(i) += weight * x;
    u.move_weights(i) += weight;
  });
  for (int i = 0; i < count; ++i)
    if (!stays[i]) u.target.row(i) /= u.move_weights(i);
  each([&](int i, bool fixed, double weight, const Eigen::RowVector3d& x) {
    const double distance = (x - u.target.row(i)).norm();
    if (fixed) u.contradiction(i) = std::max(u.contradiction(i), distance);
    if (!fixed) u.joining += weight * distance * distance;
    if (u.shared[i] == 1) u.target.row(i) = x;
  });
  for (int i = 0; i < count; ++i)
    if (stays[i]) u.move_weights(i) = 0;
  return u;
}

std::vector<int> columnsOf(const Unknowns& unknowns, const NetworkSeam& seam,
                           const Condition& condition) {
  std::vector<int> result;
  const auto add = [&](int side, int row) {
    for (int j = 0; j < condition.side(side).count; ++j)
      result.push_back(unknowns.of_pole[seam.surfaces[side]][condition.side(side).pole(row, j)]);
  };
  for (int row = 0; row <= condition.side(0).depth; ++row) add(0, row);
  for (int row = 1; row <= condition.side(1).depth; ++row) add(1, row);
  return result;
}

}  // namespace seamwright::network
