// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/blend/lateral_boundary.hpp>
#include <seamwright/occ_adapter/curves/edge_chain.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::string pointText(const Vector3d& point) {
  return fmt::format("at ({:.6g})", fmt::join(point, ", "));
}

Vector3d endOf(const EdgeChain& chain, int end) {
  const ChainedEdge& edge = end == 0 ? chain.edges.front() : chain.edges.back();
  return edge.edge.ends[(end == 0) == edge.forward ? 0 : 1];
}

SideSample sampleAt(const ChosenEnd& end, int corner) {
  return end.path->besidePoleAtShare(corner, corner == 0);
}

/// The second derivative of a path by the share at its end.
Vector3d secondAt(const ChosenEnd& end, int corner) {
  // One-sided differences, exact to the square of the step.
  const double step = corner == 0 ? 1e-3 : -1e-3;
  const auto derivative = [&](int steps) {
    return end.path->besidePoleAtShare(corner + steps * step, corner == 0).derivative;
  };
  return (-3 * derivative(0) + 4 * derivative(1) - derivative(2)) / (2 * step);
}

/// The ends of both sides that a chain joins, and in which direction.
struct Corners {
  std::array<int, 2> of_sides{};
  bool backwards = false;
  double gap_mm = HUGE_VAL;
  Vector3d at;  ///< the end of the chain with the gap
};

Corners nearestCorners(const EdgeChain& chain, const std::vector<ChosenEnd>& ends) {
  Corners nearest;
  for (const bool backwards : {false, true})
    for (const int first : {0, 1})
      for (const int second : {0, 1}) {
        const Vector3d from = endOf(chain, backwards ? 1 : 0), to = endOf(chain, backwards ? 0 : 1);
        const double at_start = (sampleAt(ends[0], first).point - from).norm(),
                     at_end = (sampleAt(ends[1], second).point - to).norm();
        const double gap_mm = std::max(at_start, at_end);
        if (gap_mm < nearest.gap_mm)
          nearest = {{first, second}, backwards, gap_mm, at_start > at_end ? from : to};
      }
  return nearest;
}

/// The order of the boundary along these edges.
int orderOf(const LateralChoice& choice, const std::vector<int>& edges) {
  std::optional<int> order;
  for (const auto& [edge, own] : choice.orders) {
    if (std::ranges::count(edges, edge) == 0) continue;
    if (order && *order != own)
      throw std::invalid_argument(
          fmt::format("lateral orders {} and {} for one boundary", *order, own));
    order = own;
  }
  return order.value_or(choice.order);
}

/// The faces beside a chain that were chosen; of free edges their own.
HoleSide edgesWithFaces(const TopoDS_Shape& model, const LateralChoice& choice,
                        const std::vector<int>& edges) {
  const SeamGraph graph = findSeams(model);
  const auto isFree = [&](int edge) {
    return std::ranges::any_of(graph.open,
                               [&](const NonSeamEdge& open) { return open.edge == edge; });
  };
  const auto isNamed = [&](int edge) {
    return std::ranges::any_of(graph.seams, [&](const Seam& seam) {
      return std::ranges::count(seam.edges, edge) > 0 &&
             std::ranges::any_of(seam.sides, [&](const Coedge& use) {
               return std::ranges::count(choice.faces, use.face) > 0;
             });
    });
  };
  if (orderOf(choice, edges) == 0 && !std::ranges::any_of(edges, isNamed) &&
      !std::ranges::all_of(edges, isFree))
    return {};
  SideChoice side{.edges = edges, .faces = choice.faces, .name = "lateral"};
  if (std::ranges::all_of(edges, isFree)) side.faces.clear();
  bool closed = false;
  return chosenSide(model, side, closed);
}

void requireChoice(const LateralChoice& choice, const std::vector<EdgeChain>& chains,
                   const std::vector<ChosenEnd>& ends) {
  std::vector<int> orders = {choice.order};
  for (const auto& [edge, order] : choice.orders) {
    if (std::ranges::count(choice.edges, edge) == 0)
      throw std::invalid_argument(fmt::format("lateral order: edge {} is not in lateral", edge));
    orders.push_back(order);
  }
  for (const int order : orders)
    if (order < 0 || order > 2)
      throw std::invalid_argument(fmt::format("lateral order is {}: 0 to 2 are possible", order));
  for (const int edge : choice.edges) {
    if (std::ranges::count(choice.edges, edge) > 1)
      throw std::invalid_argument(fmt::format("lateral: edge {} is given twice", edge));
    for (const ChosenEnd& end : ends)
      if (std::ranges::count(end.end.side.edges, edge) > 0)
        throw std::invalid_argument(
            fmt::format("edge {} is in {} and in lateral", edge, end.end.side.name));
  }
  if (ends[0].closed)
    throw std::invalid_argument("lateral: closed sides have no lateral boundaries");
  if (chains.size() > 2)
    throw std::invalid_argument(
        fmt::format("lateral: the edges are {} chains: one or two are possible, from an end of the "
                    "start to one "
                    "of the end",
                    chains.size()));
}

ChosenLateral chosenLateral(const TopoDS_Shape& model, const BlendSurfaceOptions& options,
                            const std::vector<ChosenEnd>& ends, const EdgeChain& chain) {
  const Corners corners = nearestCorners(chain, ends);
  if (chain.closed || !(corners.gap_mm <= options.tolerance.gap_mm))
    throw std::invalid_argument(fmt::format(
        "it does not run from an end of the start to an end of the end: gap_mm = {:.3g} {}, {:.3g} "
        "is possible",
        corners.gap_mm, pointText(corners.at), options.tolerance.gap_mm));
  ChosenLateral lateral;
  lateral.corners = corners.of_sides;
  for (const ChainedEdge& edge : chain.edges) lateral.edges.push_back(edge.edge.number);
  lateral.order = orderOf(options.lateral, lateral.edges);
  lateral.uses = edgesWithFaces(model, options.lateral, lateral.edges);
  lateral.curve = std::make_shared<const LateralCurve>(chain, corners.backwards);
  if (!lateral.uses.edges.empty()) {
    lateral.beside = std::make_shared<const SidePath>(lateral.uses, options.tolerance.gap_mm);
    lateral.against = (lateral.beside->atShare(0, true).point - lateral.curve->at(0)).norm() >
                      (lateral.beside->atShare(1, false).point - lateral.curve->at(0)).norm();
  }
  if (corners.backwards) std::ranges::reverse(lateral.edges);
  return lateral;
}

/// \throws std::invalid_argument where the curve leaves the tangent plane of a side, or goes back.
void requireTangent(const ChosenLateral& lateral, const ChosenEnd& end, int k,
                    const ContinuityTolerance& tolerance) {
  if (end.end.order < 1) return;
  const SideSample sample = sampleAt(end, lateral.corners[k]);
  const Vector3d direction = lateral.curve->atEnd(k).row(1).transpose();
  const double angle_rad = std::asin(std::min(1.0, std::abs(direction.dot(sample.normal))));
  if (!(angle_rad <= tolerance.angle_rad))
    throw std::invalid_argument(fmt::format(
        "it leaves the tangent plane of the {} by angle_rad = {:.3g} ({:.3g} degrees) {}: G{} "
        "allows {:.3g}; G0 allows any",
        end.end.side.name, angle_rad, angle_rad / radians_per_degree, pointText(sample.point),
        end.end.order, tolerance.angle_rad));
  // A choice: lines across that start along the side make no surface.
  constexpr double least_rad = 5 * radians_per_degree;
  const Vector3d out = (k == 0 ? -1 : 1) * sample.beyond;
  const double turn_rad = std::asin(std::clamp(direction.dot(out), -1.0, 1.0));
  if (!(turn_rad >= least_rad))
    throw std::invalid_argument(fmt::format(
        "it goes {} {}: the angle from the side is angle_rad = {:.3g} ({:.3g} degrees), away from "
        "the face at least {:.3g} is needed",
        turn_rad < -least_rad ? "back over the face of the" : "on along the", end.end.side.name,
        turn_rad, turn_rad / radians_per_degree, least_rad));
}

/// \throws std::invalid_argument where the face beside has another tangent plane than the side.
void requirePlaneBeside(const ChosenLateral& lateral, const ChosenEnd& end, int k,
                        const ContinuityTolerance& tolerance) {
  if (lateral.order < 1) return;
  const SideSample of_side = sampleAt(end, lateral.corners[k]);
  const Vector3d tangent = of_side.derivative.normalized(), normal = lateral.normalAt(k);
  const double angle_rad = std::asin(std::min(1.0, std::abs(tangent.dot(normal))));
  if (!(angle_rad <= tolerance.angle_rad))
    throw std::invalid_argument(fmt::format(
        "the {} leaves the tangent plane of the face beside it by angle_rad = {:.3g} ({:.3g} "
        "degrees) {}: G1 allows {:.3g}; G0 allows any",
        end.end.side.name, angle_rad, angle_rad / radians_per_degree, pointText(of_side.point),
        tolerance.angle_rad));
}

/// \throws std::invalid_argument where the side has another normal curvature than the face beside.
void requireBendBeside(const ChosenLateral& lateral, const ChosenEnd& end, int k,
                       const ContinuityTolerance& tolerance) {
  if (lateral.order < 2) return;
  const SideSample of_side = sampleAt(end, lateral.corners[k]);
  const Vector3d tangent = of_side.derivative.normalized(), normal = lateral.normalAt(k);
  const Matrix3d beside = lateral.curvatureAt(k);
  const double k_side =
                   secondAt(end, lateral.corners[k]).dot(normal) / of_side.derivative.squaredNorm(),
               k_beside = tangent.dot(beside * tangent);
  const CurvatureDifference curvature{.difference_per_mm = std::abs(k_side - k_beside),
                                      .norm_a_per_mm = std::abs(k_side),
                                      .norm_b_per_mm = std::max(beside.norm(), std::abs(k_beside))};
  if (const double rel = relativeDifference(curvature, tolerance.flat_radius_mm);
      !(rel <= tolerance.curvature_rel))
    throw std::invalid_argument(fmt::format(
        "the normal curvature of the {} is {:.3g}/mm, that of the face beside in its direction "
        "{:.3g}/mm, {}: curvature_rel = {:.3g}, G2 allows {:.3g}; G1 allows any",
        end.end.side.name, k_side, k_beside, pointText(of_side.point), rel,
        tolerance.curvature_rel));
}

/// How a line that runs along the curve bends at a side.
/// \throws std::invalid_argument where no surface of the order can hold the curve.
LineBend bendOf(const ChosenLateral& lateral, const ChosenEnd& end, const SideSample& sample, int k,
                const ContinuityTolerance& tolerance) {
  LineBend bend;
  const int order = end.end.order;
  if (order < 2) return bend;
  const CurveDerivatives curve = lateral.curve->atEnd(k);
  const double sense = k == 0 ? 1 : -1;
  const LineFrame frame = lineFrame(sample, sense);
  bend.geodesic_per_mm = curve.row(2).dot(frame.along);
  bend.third_per_mm2 = {curve.row(3).dot(frame.across), curve.row(3).dot(frame.along)};
  const CurveDerivatives of_face = continuation(sample, sense, order, bend);
  const auto normal = [&](const CurveDerivatives& rows, int row) {
    return rows.row(row).dot(sample.normal);
  };
  const double k_face = normal(of_face, 2), k_curve = normal(curve, 2);
  const CurvatureDifference curvature{
      .difference_per_mm = std::abs(k_face - k_curve),
      .norm_a_per_mm =
          std::max(curvatureTensor(sample.jet, sample.normal).norm(), std::abs(k_face)),
      .norm_b_per_mm = std::abs(k_curve)};
  if (const double rel = relativeDifference(curvature, tolerance.flat_radius_mm);
      !(rel <= tolerance.curvature_rel))
    throw std::invalid_argument(fmt::format(
        "its normal curvature is {:.3g}/mm, that of the {} in its direction {:.3g}/mm, {}: "
        "curvature_rel = {:.3g}, G{} allows {:.3g}; G1 allows any",
        k_curve, end.end.side.name, k_face, pointText(sample.point), rel, order,
        tolerance.curvature_rel));
  if (order < 3) return bend;
  const double c_face = normal(of_face, 3), c_curve = normal(curve, 3);
  const CurvatureChange change{.difference_per_mm2 = std::abs(c_face - c_curve),
                               .change_a_per_mm2 = std::abs(c_face),
                               .change_b_per_mm2 = std::abs(c_curve)};
  if (const double rel = relativeChange(change, curvature, tolerance.flat_radius_mm);
      !(rel <= tolerance.curvature_rel))
    throw std::invalid_argument(fmt::format(
        "its normal curvature changes by {:.3g}/mm2, that of the {} by {:.3g}/mm2, {}: "
        "curvature_rel = {:.3g}, G3 allows {:.3g}; G2 allows any",
        c_curve, end.end.side.name, c_face, pointText(sample.point), rel, tolerance.curvature_rel));
  return bend;
}

/// Runs a check of a chain; the message of what it throws begins with its edges.
template <typename Check>
auto named(const std::vector<int>& edges, const Check& check) {
  try {
    return check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("lateral boundary of edge {}: {}", fmt::join(edges, ", "), error.what()));
  }
}

/// \throws std::invalid_argument for a face that was chosen and is beside none of them.
void requireFacesBeside(const std::vector<ChosenLateral>& laterals, const LateralChoice& choice) {
  for (const int face : choice.faces)
    if (std::ranges::none_of(laterals, [&](const ChosenLateral& lateral) {
          return std::ranges::any_of(lateral.uses.edges,
                                     [&](const HoleEdge& edge) { return edge.use.face == face; });
        }))
      throw std::invalid_argument(
          fmt::format("lateral: face {} is beside none of the edges", face));
}

std::vector<int> numbersOf(const EdgeChain& chain) {
  std::vector<int> numbers;
  for (const ChainedEdge& edge : chain.edges) numbers.push_back(edge.edge.number);
  return numbers;
}

}  // namespace

SideSample ChosenLateral::besideAt(double share) const {
  return beside->besidePoleAtShare(against ? 1 - share : share, (share < 1) != against);
}

Matrix3d ChosenLateral::curvatureAt(double share) const {
  const SideSample sample = besideAt(share);
  return curvatureTensor(sample.jet, sample.normal);
}

std::vector<ChosenLateral> chosenLaterals(const TopoDS_Shape& model,
                                          const BlendSurfaceOptions& options,
                                          const std::vector<ChosenEnd>& ends) {
  const LateralChoice& choice = options.lateral;
  if (choice.edges.empty()) {
    if (choice.order != 0 || !choice.orders.empty() || !choice.faces.empty())
      throw std::invalid_argument("lateral faces or a lateral order need lateral edges");
    return {};
  }
  const std::vector<EdgeChain> chains = edgeChains(model, {.edges = choice.edges});
  requireChoice(choice, chains, ends);
  std::vector<ChosenLateral> laterals;
  for (const EdgeChain& chain : chains)
    laterals.push_back(named(numbersOf(chain), [&] {
      ChosenLateral lateral = chosenLateral(model, options, ends, chain);
      for (const int k : {0, 1}) {
        requireTangent(lateral, ends[k], k, options.tolerance);
        requirePlaneBeside(lateral, ends[k], k, options.tolerance);
        requireBendBeside(lateral, ends[k], k, options.tolerance);
      }
      return lateral;
    }));
  requireFacesBeside(laterals, choice);
  std::ranges::sort(laterals, {}, [](const ChosenLateral& of) { return of.corners[0]; });
  if (laterals.size() == 2)
    for (const int k : {0, 1})
      if (laterals[0].corners[k] == laterals[1].corners[k])
        throw std::invalid_argument(fmt::format(
            "lateral boundaries of edge {} and of edge {} end at the same end of the {}",
            fmt::join(laterals[0].edges, ", "), fmt::join(laterals[1].edges, ", "),
            ends[k].end.side.name));
  return laterals;
}

LateralDirections directionsOf(const std::vector<ChosenLateral>& laterals,
                               const std::vector<ChosenEnd>& ends, int k) {
  LateralDirections result;
  for (const ChosenLateral& lateral : laterals)
    if (ends[k].end.order > 0)
      result[lateral.corners[k]] = (k == 0 ? 1 : -1) * lateral.curve->atEnd(k).row(1).transpose();
  return result;
}

std::vector<BlendLateral> lateralsOf(const std::vector<ChosenLateral>& laterals,
                                     const std::vector<ChosenEnd>& ends,
                                     const std::vector<BlendSide>& sides,
                                     const ContinuityTolerance& tolerance) {
  std::vector<BlendLateral> result;
  for (const ChosenLateral& chosen : laterals) {
    BlendLateral lateral{.side = chosen.corners[0] == 0 ? LateralSide::First : LateralSide::Last,
                         .curve = chosen.curve,
                         .pace = LateralPace(ends[0].end, ends[1].end)};
    const int u = chosen.corners[0];
    const std::array<SideSample, 2> at = {sides[0].at(u, u == 0), sides[1].at(u, u == 0)};
    lateral.longer_mm = chosen.curve->length_mm() - (at[1].point - at[0].point).norm();
    for (const int k : {0, 1})
      lateral.bends[k] =
          named(chosen.edges, [&] { return bendOf(chosen, ends[k], at[k], k, tolerance); });
    if (chosen.order > 0)
      lateral.normal = [chosen](double share) { return chosen.normalAt(share); };
    if (chosen.order > 1)
      lateral.curvature = [chosen](double share) { return chosen.curvatureAt(share); };
    result.push_back(std::move(lateral));
  }
  return result;
}

}  // namespace seamwright::occ
