// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <seamwright/core/planar/plane_frame.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/planar/planar_wires.hpp>
#include <seamwright/plugin/cli/curve_input.hpp>
#include <seamwright/plugin/cli/point_file.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

void requireEnds(const CurveArguments& arguments) {
  if (!arguments.free_ends) return;
  if (arguments.method != "fair")
    throw std::runtime_error("--free-ends: is for the method fair, not for " + arguments.method);
  if (arguments.closed)
    throw std::runtime_error("--free-ends: a curve with --closed has no ends; corners stay");
}

void requirePolygon(const CurveArguments& arguments) {
  if (arguments.polygon && arguments.method != "arcs")
    throw std::runtime_error("--polygon: is for the method arcs, not for " + arguments.method);
}

/// Tolerances of points; empty if they have none of their own.
Eigen::VectorXd ownTolerances(const PointFile& file, double default_mm) {
  const auto& own = file.tolerances_mm;
  if (std::ranges::none_of(own, [](const auto& one) { return one.has_value(); })) return {};
  Eigen::VectorXd result(std::ssize(own));
  for (std::size_t i = 0; i < own.size(); ++i)
    result(static_cast<Eigen::Index>(i)) = own[i].value_or(default_mm);
  return result;
}

std::string tolerancesNote(const Eigen::VectorXd& tolerances_mm) {
  return fmt::format("tolerances of the points, by their file: {:.3g} to {:.3g} mm",
                     tolerances_mm.minCoeff(), tolerances_mm.maxCoeff());
}

CurveInput pointInput(const CurveArguments& arguments) {
  requireEnds(arguments);
  requirePolygon(arguments);
  if (arguments.edges.isGiven())
    throw std::runtime_error(arguments.input +
                             ": is a file of points, which has no edges: --edge "
                             "is for models");
  PointFile file = readPoints(arguments.input);
  requireCurve(file, arguments.input, arguments.closed);
  const FittedPlane plane = fitPlane(file.points);
  if (plane.distance_mm > arguments.flatness_mm)
    throw std::runtime_error(fmt::format(
        "{}: the points are not in a plane: that of line {} is {:.3g} mm from the nearest plane, "
        "more than --flatness {:.6g} mm",
        arguments.input, file.lines[plane.most_distant], plane.distance_mm, arguments.flatness_mm));
  GivenCurve curve;
  curve.points = coordinatesIn(plane.frame, file.points);
  curve.rounding_mm = file.rounding_mm;
  curve.lines = file.lines;
  curve.polygon = arguments.polygon;
  curve.free_ends = arguments.free_ends;
  if (const std::string note = arguments.closed ? "" : endsNote(file); !note.empty())
    curve.record.notes.push_back(note);
  curve.record.points = file.points.rows();
  curve.record.closed = arguments.closed;
  curve.record.plane = plane.frame;
  curve.record.off_plane_mm = plane.distance_mm;
  CurveInput input;
  input.facts.path = arguments.input;
  input.facts.format = "points";
  input.facts.length_unit = "mm (assumed)";
  input.notes = file.notes;
  if (arguments.method == "fair")
    curve.tolerances_mm = ownTolerances(file, arguments.tolerance_mm);
  else if (!file.tolerances_mm.empty())
    input.notes.emplace_back("tolerances of points are for the method fair: --tolerance holds");
  if (curve.tolerances_mm.size() > 0)
    curve.record.notes.push_back(tolerancesNote(curve.tolerances_mm));
  input.curves.push_back(std::move(curve));
  return input;
}

GivenCurve givenCurve(occ::PlanarWire wire) {
  GivenCurve curve;
  curve.record.edges = wire.edges;
  curve.record.closed = wire.chain.closed;
  curve.record.plane = wire.frame;
  curve.record.off_plane_mm = wire.height_mm;
  curve.chain = std::move(wire.chain);
  curve.gap_mm = wire.gap_mm;
  return curve;
}

CurveInput modelInput(const CurveArguments& arguments) {
  if (arguments.free_ends)
    throw std::runtime_error(arguments.input + ": is a model: --free-ends is for points");
  if (arguments.polygon)
    throw std::runtime_error(arguments.input + ": is a model: --polygon is for points");
  if (arguments.closed)
    throw std::runtime_error(
        arguments.input + ": is a model, whose curves are closed or not: --closed is for points");
  const occ::Model model = readUnderBar(arguments.input, occ::Needed::Edges);
  CurveInput input;
  input.facts = occ::factsOf(model);
  input.notes = model.notes;
  try {
    occ::PlanarWireSearch found = occ::findPlanarWires(
        model.shape,
        {.flatness_mm = arguments.flatness_mm,
         .chains = {.edges = arguments.edges.numbers, .each_alone = arguments.edges.all}});
    for (occ::PlanarWire& wire : found.wires) input.curves.push_back(givenCurve(std::move(wire)));
    for (const occ::RefusedChain& chain : found.refused)
      input.refused.push_back({.edges = chain.edges, .reason = chain.reason});
  } catch (const occ::GeometryError& error) {
    throw std::runtime_error(arguments.input + ": " + error.what());
  }
  if (input.curves.empty() && input.refused.empty())
    throw std::runtime_error(arguments.input +
                             ": has no free edges: name edges with --edge, or take --edge all");
  return input;
}

}  // namespace

CurveInput curveInput(const CurveArguments& arguments) {
  return isPointFile(arguments.input) ? pointInput(arguments) : modelInput(arguments);
}

}  // namespace seamwright::cli
