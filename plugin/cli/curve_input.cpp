// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <seamwright/core/planar/plane_frame.hpp>
#include <seamwright/plugin/cli/curve_input.hpp>
#include <seamwright/plugin/cli/point_file.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

CurveInput pointInput(const CurveArguments& arguments) {
  if (!arguments.edges.empty() || arguments.all_edges)
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
  curve.record.points = file.points.rows();
  curve.record.closed = arguments.closed;
  curve.record.plane = plane.frame;
  curve.record.off_plane_mm = plane.distance_mm;
  CurveInput input;
  input.facts.path = arguments.input;
  input.facts.format = "points";
  input.facts.length_unit = "mm (assumed)";
  input.curves.push_back(std::move(curve));
  return input;
}

}  // namespace

CurveInput curveInput(const CurveArguments& arguments) {
  return pointInput(arguments);
}

}  // namespace seamwright::cli
