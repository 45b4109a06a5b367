// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/core/join/checked_connection.hpp>
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
      refuse(fmt::format("weight {} of a move of {} is {}: weights must be positive and finite", i,
                         name, side.weights(i)));
}

void requireConnection(const ConnectionFunctions& connection, const std::string& name) {
  static constexpr std::array names = {"gamma", "alpha", "beta", "p", "q"};
  const auto all = functions(connection);
  for (int f = 0; f < function_count; ++f) {
    if (all[f]->size() == 0 || all[f]->size() > 7)
      refuse(std::string(names[f]) + " of the connection of " + name + " has " +
             std::to_string(all[f]->size()) + " coefficients: 1 to 7 are needed");
    for (Eigen::Index k = 0; k < all[f]->size(); ++k) {
      const double value = (*all[f])(k);
      if (!std::isfinite(value) || (f <= Alpha && !(value > 0)))
        refuse(fmt::format("coefficient {} of {} of the connection of {} is {}: it must be {}", k,
                           names[f], name, value, f <= Alpha ? "positive" : "finite"));
    }
  }
  if (!isConstant(connection.e0, 1) || !isZero(connection.e1) || !isZero(connection.e2))
    refuse("the connection of " + name + " scales poles: e0 must be 1, e1 and e2 must be 0");
}

void requireSameSeam(const nearest::SeamRows& a, const nearest::SeamRows& b,
                     const std::string& name) {
  if (a.degree != b.degree || a.knots.size() != b.knots.size())
    refuse("degrees along " + name + " are " + std::to_string(a.degree) + " and " +
           std::to_string(b.degree) + ", poles " + std::to_string(a.count) + " and " +
           std::to_string(b.count) + ": they must be equal");
  // Scaling to 0..1 takes some roundings of each knot, and files round knots too.
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < a.knots.size(); ++i)
    if (!(std::abs(a.knots[i] - b.knots[i]) <= rounding))
      refuse(fmt::format("knot {} along {}, scaled to 0..1, is {} and {}: they must be equal", i,
                         name, a.knots[i], b.knots[i]));
}

/// The unknown of each pole, per surface, and the number of unknowns.
struct Numbering {
  std::vector<std::vector<int>> of_pole;
  int count = 0;
};

/// Poles on a seam have the same unknown on both sides.
Numbering numbered(const std::vector<NetworkSurface>& surfaces,
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
  Numbering result;
  std::vector<int> number(offset.back(), -1);
  result.of_pole.resize(surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    for (int k = 0; k < surfaces[s].surface.poles.rows(); ++k) {
      int& n = number[sets.of(offset[s] + k)];
      if (n < 0) n = result.count++;
      result.of_pole[s].push_back(n);
    }
  return result;
}

/// Of all poles. Its centre does not depend on the order of surfaces, as their mean would by
/// rounding.
struct Box {
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
  double largest = 0;  ///< coordinate
};

Box boxOf(const std::vector<Poles>& poles) {
  Eigen::RowVector3d low = Eigen::RowVector3d::Constant(std::numeric_limits<double>::infinity()),
                     high = -low;
  for (const Poles& of : poles) {
    low = low.cwiseMin(of.colwise().minCoeff());
    high = high.cwiseMax(of.colwise().maxCoeff());
  }
  return {.centre = (low + high) / 2,
          .largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff())};
}

/// A pole of a surface, as a wish for the position of its unknown.
struct Wish {
  int unknown = 0;
  bool fixed = false;
  double weight = 1;
  Eigen::RowVector3d x = Eigen::RowVector3d::Zero();  ///< relative to the centre
};

std::vector<Wish> wishes(const std::vector<NetworkSurface>& surfaces, const Numbering& numbering,
                         const std::vector<Poles>& poles, const Eigen::RowVector3d& centre) {
  std::vector<Wish> result;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    for (int k = 0; k < poles[s].rows(); ++k) {
      const NetworkSurface& of = surfaces[s];
      result.push_back({.unknown = numbering.of_pole[s][k],
                        .fixed = !of.moves || (!of.fixed.empty() && of.fixed[k]),
                        .weight = of.weights.size() == 0 ? 1.0 : of.weights(k),
                        .x = poles[s].row(k) - centre});
    }
  return result;
}

/// The target of each unknown: the position of its first fixed pole, or the weighted mean.
struct Targets {
  Eigen::MatrixXd position;
  Eigen::VectorXd weight;   ///< sum of its poles
  std::vector<int> shared;  ///< number of its poles
  std::vector<bool> stays;
};

Targets targetsOf(const std::vector<Wish>& wishes, int count) {
  Targets t{.position = Eigen::MatrixXd::Zero(count, 3),
            .weight = Eigen::VectorXd::Zero(count),
            .shared = std::vector<int>(count, 0),
            .stays = std::vector<bool>(count, false)};
  for (const Wish& wish : wishes) {
    const int i = wish.unknown;
    ++t.shared[i];
    if (wish.fixed && !t.stays[i]) t.position.row(i) = wish.x;
    t.stays[i] = t.stays[i] || wish.fixed;
    if (!t.stays[i]) t.position.row(i) += wish.weight * wish.x;
    t.weight(i) += wish.weight;
  }
  for (int i = 0; i < count; ++i)
    if (!t.stays[i]) t.position.row(i) /= t.weight(i);
  return t;
}

/// How far the wishes are from the targets, as in Unknowns.
struct Distances {
  Eigen::VectorXd contradiction;
  double joining = 0;
};

Distances distancesOf(const std::vector<Wish>& wishes, const Targets& targets) {
  Distances result{.contradiction = Eigen::VectorXd::Zero(targets.position.rows())};
  for (const Wish& wish : wishes) {
    const int i = wish.unknown;
    const double distance = (wish.x - targets.position.row(i)).norm();
    if (wish.fixed) result.contradiction(i) = std::max(result.contradiction(i), distance);
    if (!wish.fixed) result.joining += wish.weight * distance * distance;
  }
  return result;
}

}  // namespace

void requireNetwork(const std::vector<NetworkSurface>& surfaces,
                    const std::vector<NetworkSeam>& seams, const NetworkOptions& options) {
  if (!(options.regular_rad >= 0 && options.regular_rad <= 1))
    refuse(fmt::format("regular_rad is {}: 0 to 1 is needed", options.regular_rad));
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
    if (seam.held) requireConnection(*seam.held, name);
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
  Numbering numbering = numbered(surfaces, seams, takes_part);
  std::vector<Poles> poles;
  for (const NetworkSurface& surface : surfaces)
    poles.push_back(affinePoles(surface.surface.poles));
  const Box box = boxOf(poles);
  const std::vector<Wish> all = wishes(surfaces, numbering, poles, box.centre);
  Targets targets = targetsOf(all, numbering.count);
  Distances distances = distancesOf(all, targets);
  // A pole that is not shared keeps its position bitwise. The quotient of weighted positions may
  // differ from it by rounding.
  for (const Wish& wish : all)
    if (targets.shared[wish.unknown] == 1) targets.position.row(wish.unknown) = wish.x;
  for (int i = 0; i < numbering.count; ++i)
    if (targets.stays[i]) targets.weight(i) = 0;
  return {.of_pole = std::move(numbering.of_pole),
          .target = std::move(targets.position),
          .move_weights = std::move(targets.weight),
          .shared = std::move(targets.shared),
          .contradiction = std::move(distances.contradiction),
          .centre = box.centre,
          .largest = box.largest,
          .joining = distances.joining};
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

Eigen::MatrixXd polesOf(const Eigen::MatrixXd& x, const std::vector<int>& columns) {
  Eigen::MatrixXd result(std::ssize(columns), x.cols());
  for (Eigen::Index i = 0; i < result.rows(); ++i) result.row(i) = x.row(columns[i]);
  return result;
}

}  // namespace seamwright::network
