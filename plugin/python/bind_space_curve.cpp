// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/differential/frenet.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <vector>

namespace seamwright::python {

namespace {

const char* nameOf(CurvePoint kind) {
  switch (kind) {
    case CurvePoint::Regular:
      return "regular";
    case CurvePoint::Inflection:
      return "inflection";
    case CurvePoint::Cusp:
      return "cusp";
    case CurvePoint::Point:
      break;
  }
  return "point";
}

py::dict frenetFrameOf(const BezierCurve& curve, const py::object& t) {
  const FrenetFrame frame = frenetFrame(curve, argument<double>("t", t, "a number"));
  py::dict dict;
  dict["kind"] = nameOf(frame.kind);
  dict["speed"] = frame.speed;
  dict["speed_error"] = frame.speed_error;
  dict["tangent"] = frame.tangent;
  dict["tangent_error_rad"] = frame.tangent_error_rad;
  dict["normal"] = frame.normal;
  dict["binormal"] = frame.binormal;
  dict["binormal_error_rad"] = frame.binormal_error_rad;
  dict["curvature_per_mm"] = frame.curvature_per_mm;
  dict["curvature_error_per_mm"] = frame.curvature_error_per_mm;
  dict["torsion_per_mm"] = frame.torsion_per_mm;
  dict["torsion_error_per_mm"] = frame.torsion_error_per_mm;
  dict["curvature_change_per_mm2"] = frame.curvature_change_per_mm2;
  dict["curvature_change_error_per_mm2"] = frame.curvature_change_error_per_mm2;
  return dict;
}

py::dict degeneraciesOf(const BezierCurve& curve, const py::object& resolution) {
  const CurveDegeneracies found =
      findDegeneracies(curve, argument<double>("resolution", resolution, "a number"));
  py::list places;
  for (const CurveDegeneracies::Place& place : found.places) {
    py::dict entry;
    entry["kind"] = nameOf(place.kind);
    entry["first"] = place.first;
    entry["last"] = place.last;
    places.append(entry);
  }
  py::dict dict;
  dict["places"] = places;
  dict["straight"] = found.straight;
  dict["speed_lower"] = found.speed_lower;
  return dict;
}

py::dict arcLengthOf(const BezierCurve& curve, const py::object& tolerance_mm,
                     const py::object& first, const py::object& last) {
  const ArcLength length = arcLength(
      curve, argument<double>("tolerance_mm", tolerance_mm, "a number"),
      argument<double>("first", first, "a number"), argument<double>("last", last, "a number"));
  py::dict dict;
  dict["value_mm"] = length.value_mm;
  dict["lower_mm"] = length.lower_mm;
  dict["upper_mm"] = length.upper_mm;
  dict["reached"] = length.reached;
  return dict;
}

double parameterAtLengthOf(const BezierCurve& curve, const py::object& length_mm,
                           const py::object& tolerance_mm) {
  return parameterAtLength(curve, argument<double>("length_mm", length_mm, "a number"),
                           argument<double>("tolerance_mm", tolerance_mm, "a number"));
}

std::optional<Eigen::Vector3d> normalOf(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  constexpr const char* kind = "a sequence of three numbers";
  const auto numbers = argument<std::vector<double>>("normal", value, kind);
  if (numbers.size() != 3)
    throw py::value_error("normal is " + shown(value) + ": " + kind + " is needed");
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

py::dict movingFramesOf(const BezierCurve& curve, const py::object& parameters,
                        const py::object& normal) {
  const auto t = argument<std::vector<double>>("parameters", parameters, "a sequence of numbers");
  const std::vector<MovingFrame> frames = rotationMinimizingFrames(curve, t, normalOf(normal));
  const auto count = static_cast<Eigen::Index>(frames.size());
  Poles points(count, 3), tangents(count, 3), normals(count, 3), binormals(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const MovingFrame& frame = frames[static_cast<std::size_t>(i)];
    points.row(i) = frame.point.transpose();
    tangents.row(i) = frame.tangent.transpose();
    normals.row(i) = frame.normal.transpose();
    binormals.row(i) = frame.binormal.transpose();
  }
  py::dict dict;
  dict["parameters"] = Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(t.data(), count));
  dict["points"] = points;
  dict["tangents"] = tangents;
  dict["normals"] = normals;
  dict["binormals"] = binormals;
  return dict;
}

}  // namespace

void bindSpaceCurve(py::module_& module) {
  module.def("frenet_frame", &frenetFrameOf, py::arg("curve"), py::arg("t"),
             "The Frenet frame of a BezierCurve at t, a dict: kind (regular, inflection, cusp, "
             "point), speed, "
             "tangent, normal, binormal, curvature_per_mm, torsion_per_mm, "
             "curvature_change_per_mm2; and bounds "
             "of their errors, speed_error, tangent_error_rad, binormal_error_rad, "
             "curvature_error_per_mm, "
             "torsion_error_per_mm, curvature_change_error_per_mm2. They are those of the curve in "
             "memory, where "
             "products of weights and poles have been rounded.\n\n"
             "What there is none of is None: at an inflection normal, binormal and torsion; at a "
             "cusp all but "
             "the tangent, which is the one the curve leaves with.");
  module.def(
      "find_degeneracies", &degeneraciesOf, py::arg("curve"), py::arg("resolution") = 1e-9,
      "Where a BezierCurve has no Frenet frame, a dict: places, each with kind, first and last; "
      "straight; speed_lower, a bound of the speed.\n\n"
      "Outside the places there is certainly neither a cusp nor an inflection. A place need not "
      "hold "
      "one.");
  module.def("arc_length", &arcLengthOf, py::arg("curve"), py::arg("tolerance_mm"),
             py::arg("first") = 0, py::arg("last") = 1,
             "The length of a BezierCurve over [first, last], a dict: value_mm, certainly between "
             "lower_mm and "
             "upper_mm, and reached: whether these are as near as the tolerance.");
  module.def(
      "parameter_at_length", &parameterAtLengthOf, py::arg("curve"), py::arg("length_mm"),
      py::arg("tolerance_mm"),
      "The parameter of a BezierCurve up to which it has that length, within the tolerance.");
  module.def("rotation_minimizing_frames", &movingFramesOf, py::arg("curve"), py::arg("parameters"),
             py::arg("normal") = py::none(),
             "Frames along a BezierCurve that do not turn about its tangent, a dict of arrays: "
             "parameters (n,), "
             "points, tangents, normals and binormals (n, 3).\n\n"
             "parameters increase; normal is the direction the first one is to have, None: any. "
             "ValueError at "
             "a cusp, with the parameter.");
}

}  // namespace seamwright::python
