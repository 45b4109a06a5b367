// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <seamwright/core/bezier/frenet.hpp>
#include <seamwright/core/bezier/length.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/parameters.hpp>
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

/// Divides a bound of the error of a speed, where a curve runs over an interval of length \p h.
double errorOver(double error, double speed, double h) {
  if (h == 1) return error;
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  return (error / h) * (1 + 2 * rounding) + rounding * speed;
}

py::object frameAt(const CurveSegments& curve, double t) {
  const CurveSegments::Part& part = curve.at(t);
  const FrenetFrame frame = frenetFrame(part.curve, part.local(t));
  const double speed = frame.speed / part.length;
  py::dict dict;
  dict["kind"] = nameOf(frame.kind);
  dict["speed"] = speed;
  dict["speed_error"] = errorOver(frame.speed_error, speed, part.length);
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
  return resultOf("FrenetFrame", dict);
}

py::object frenetFrameOf(const py::object& given, const py::object& t) {
  const CurveSegments curve(curveOf("curve", given));
  const Parameters parameters("t", t);
  return resultsAt("FrenetFrame", parameters,
                   [&](py::ssize_t i) { return frameAt(curve, parameters[i]); });
}

/// Whether the ends of all segments lie on one line within rounding.
bool endsAreStraight(const CurveSegments& curve) {
  const Eigen::RowVector3d start = curve.parts().front().curve.poles().row(0);
  Eigen::RowVector3d farthest = start;
  for (const CurveSegments::Part& part : curve.parts()) {
    const Eigen::RowVector3d end = part.curve.poles().bottomRows<1>();
    if ((end - start).stableNorm() > (farthest - start).stableNorm()) farthest = end;
  }
  return std::ranges::all_of(curve.parts(), [&](const CurveSegments::Part& part) {
    Poles poles(4, 3);
    poles << start, farthest, part.curve.poles().row(0), part.curve.poles().bottomRows<1>();
    return findDegeneracies(BezierCurve(poles), 1).straight;
  });
}

/// Joins intervals that touch at a knot; the whole is a cusp if one of them may hold a cusp.
void append(std::vector<CurveDegeneracies::Interval>& intervals,
            const CurveDegeneracies::Interval& next) {
  if (intervals.empty() || intervals.back().last < next.first) return intervals.push_back(next);
  intervals.back().last = next.last;
  if (next.kind == CurvePoint::Cusp) intervals.back().kind = next.kind;
}

CurveDegeneracies degeneraciesOf(const CurveSegments& curve, double resolution) {
  if (curve.parts().size() == 1 && curve.parts().front().length == 1 && curve.start() == 0)
    return findDegeneracies(curve.parts().front().curve, resolution);
  CurveDegeneracies all;
  all.straight = true;
  all.speed_lower = std::numeric_limits<double>::infinity();
  for (const CurveSegments::Part& part : curve.parts()) {
    const CurveDegeneracies found = findDegeneracies(part.curve, resolution);
    for (const CurveDegeneracies::Interval& interval : found.intervals)
      append(all.intervals, {interval.kind, part.whole(interval.first), part.whole(interval.last)});
    all.straight = all.straight && found.straight;
    const double bound = found.speed_lower / part.length;
    all.speed_lower = std::min(all.speed_lower, bound > 0 ? std::nextafter(bound, 0.0) : 0);
  }
  all.straight = all.straight && endsAreStraight(curve);
  return all;
}

py::object degeneraciesResult(const py::object& curve, const py::object& resolution) {
  const CurveDegeneracies found =
      degeneraciesOf(CurveSegments(curveOf("curve", curve)), numberOf("resolution", resolution));
  py::list intervals;
  for (const CurveDegeneracies::Interval& interval : found.intervals) {
    py::dict entry;
    entry["kind"] = nameOf(interval.kind);
    entry["first"] = interval.first;
    entry["last"] = interval.last;
    intervals.append(entry);
  }
  py::dict dict;
  dict["places"] = intervals;
  dict["straight"] = found.straight;
  dict["speed_lower"] = found.speed_lower;
  return resultOf("CurveDegeneracies", dict);
}

/// The sum of lengths, its bounds rounded outward.
ArcLength plus(const ArcLength& a, const ArcLength& b, double tolerance_mm) {
  ArcLength sum;
  sum.lower_mm = std::nextafter(a.lower_mm + b.lower_mm, 0.0);
  sum.upper_mm = std::nextafter(a.upper_mm + b.upper_mm, std::numeric_limits<double>::infinity());
  sum.value_mm = std::clamp(a.value_mm + b.value_mm, sum.lower_mm, sum.upper_mm);
  sum.reached = sum.upper_mm - sum.lower_mm <= tolerance_mm;
  return sum;
}

ArcLength lengthOf(const CurveSegments& curve, double tolerance_mm, double first, double last) {
  if (curve.parts().size() == 1 && curve.parts().front().length == 1 && curve.start() == 0)
    return arcLength(curve.parts().front().curve, tolerance_mm, first, last);
  if (!(curve.start() <= first && first <= last && last <= curve.end()))
    throw py::value_error("range is " + shown(py::float_(first)) + " .. " +
                          shown(py::float_(last)) + ": " + shown(py::float_(curve.start())) +
                          " <= first <= last <= " + shown(py::float_(curve.end())) + " is needed");
  const double share = tolerance_mm / static_cast<double>(curve.parts().size());
  std::optional<ArcLength> sum;
  for (const CurveSegments::Part& part : curve.parts()) {
    const double from = std::clamp(part.local(first), 0.0, 1.0),
                 to = std::clamp(part.local(last), 0.0, 1.0);
    const ArcLength length = arcLength(part.curve, share, from, to);
    sum = sum ? plus(*sum, length, tolerance_mm) : length;
  }
  return *sum;
}

py::object lengthResult(const ArcLength& length) {
  py::dict dict;
  dict["value_mm"] = length.value_mm;
  dict["lower_mm"] = length.lower_mm;
  dict["upper_mm"] = length.upper_mm;
  dict["reached"] = length.reached;
  return resultOf("ArcLength", dict);
}

py::object arcLengthOf(const py::object& given, const py::object& tolerance_mm,
                       const py::object& first, const py::object& last) {
  const CurveSegments curve(curveOf("curve", given));
  const double tolerance = parameter("tolerance_mm", tolerance_mm);
  const ParameterPairs ends("first",
                            first.is_none() ? py::object(py::float_(curve.start())) : first, "last",
                            last.is_none() ? py::object(py::float_(curve.end())) : last);
  return resultsAt("ArcLength", ends.first, [&](py::ssize_t i) {
    return lengthResult(lengthOf(curve, tolerance, ends.first[i], ends.second[i]));
  });
}

/// The parameter at a length: within the segment in which the sum of lengths reaches it.
double parameterAt(const CurveSegments& curve, double length_mm, double tolerance_mm) {
  if (curve.parts().size() == 1) {
    const CurveSegments::Part& part = curve.parts().front();
    return part.whole(parameterAtLength(part.curve, length_mm, tolerance_mm));
  }
  // A quarter of the tolerance is for the segments before, a half for the one that is divided.
  const double share = 0.25 * tolerance_mm / static_cast<double>(curve.parts().size());
  const ArcLength whole = lengthOf(curve, 0.25 * tolerance_mm, curve.start(), curve.end());
  if (!(length_mm >= 0 && length_mm <= whole.upper_mm))
    throw py::value_error("length_mm is " + shown(py::float_(length_mm)) + ": the curve has 0 .. " +
                          shown(py::float_(whole.value_mm)) + " mm");
  double before = 0;
  for (const CurveSegments::Part& part : curve.parts()) {
    const double length = arcLength(part.curve, share).value_mm;
    if (before + length >= length_mm)
      return part.whole(parameterAtLength(part.curve, std::clamp(length_mm - before, 0.0, length),
                                          0.5 * tolerance_mm));
    before += length;
  }
  return curve.end();
}

py::object parameterAtLengthOf(const py::object& given, const py::object& length_mm,
                               const py::object& tolerance_mm) {
  const CurveSegments curve(curveOf("curve", given));
  const Parameters lengths("length_mm", length_mm);
  const double tolerance = parameter("tolerance_mm", tolerance_mm);
  if (lengths.isSingle()) return py::float_(parameterAt(curve, lengths[0], tolerance));
  return valuesOf(lengths.shape(), {}, [&](py::ssize_t i) {
    return std::array{parameterAt(curve, lengths[i], tolerance)};
  });
}

std::optional<Eigen::Vector3d> optionalVector(const char* name, const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return vectorOf(name, value);
}

void requireIncreasing(const std::vector<double>& t) {
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i - 1] < t[i]))
      throw py::value_error("parameters " + std::to_string(i - 1) + " and " + std::to_string(i) +
                            " are " + shown(py::float_(t[i - 1])) + " and " +
                            shown(py::float_(t[i])) + ": they must increase");
}

/// Frames segment by segment; each segment begins with the normal in which the one before ends.
std::vector<MovingFrame> framesAlong(const CurveSegments& curve, const std::vector<double>& t,
                                     std::optional<Eigen::Vector3d> normal) {
  if (curve.parts().size() == 1 && curve.parts().front().length == 1 && curve.start() == 0)
    return rotationMinimizingFrames(curve.parts().front().curve, t, normal);
  requireIncreasing(t);
  std::vector<MovingFrame> frames;
  std::size_t next = 0;
  for (const CurveSegments::Part& part : curve.parts()) {
    std::vector<double> local;
    std::vector<std::size_t> indices;  // in local, of the parameters within this segment
    if (!frames.empty()) local.push_back(0);
    for (; next < t.size() && &curve.at(t[next]) == &part; ++next) {
      const double s = part.local(t[next]);
      if (local.empty() || s > local.back()) local.push_back(s);
      indices.push_back(local.size() - 1);
    }
    if (local.empty()) continue;
    if (next < t.size() && local.back() < 1) local.push_back(1);
    const std::vector<MovingFrame> found = rotationMinimizingFrames(part.curve, local, normal);
    for (const std::size_t index : indices) frames.push_back(found[index]);
    if (next == t.size()) break;
    normal = found.back().normal;
  }
  return frames;
}

py::object movingFramesOf(const py::object& curve, const py::object& parameters,
                          const py::object& normal) {
  const std::vector<double> t = listOf("parameters", parameters);
  const std::vector<MovingFrame> frames =
      framesAlong(CurveSegments(curveOf("curve", curve)), t, optionalVector("normal", normal));
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
  return resultOf("MovingFrames", dict);
}

}  // namespace

void bindSpaceCurve(py::module_& module) {
  module.def("frenet_frame", &frenetFrameOf, py::arg("curve"), py::arg("t"),
             R"(The Frenet frame of a curve at t, a FrenetFrame, with bounds of the errors.

curve: a BezierCurve, BSplineCurve or BezierSpline. At a knot of a spline the frame is that of what
follows. t: a parameter, or an array of them; the values are then arrays with nan for None.

The bounds are those of the curve in memory, where products of weights and poles have been rounded;
of a spline, at the parameter of the segment, which is rounded. What does not exist is None: at an
inflection normal, binormal and torsion; at a cusp all but the tangent, which is the one the curve
leaves with. ValueError for a t that is not finite.)");
  module.def("find_degeneracies", &degeneraciesResult, py::arg("curve"),
             py::arg("resolution") = 1e-9,
             R"(Where a curve of any class has no Frenet frame: CurveDegeneracies.

Outside the intervals there is certainly neither a cusp nor an inflection within a segment. An
interval need not hold one. resolution, in 1e-12..1: of the parameter 0..1 of a segment.)");
  module.def("arc_length", &arcLengthOf, py::arg("curve"), py::arg("tolerance_mm"),
             py::arg("first") = py::none(), py::arg("last") = py::none(),
             R"(The length of a curve of any class over [first, last], an ArcLength.

tolerance_mm: upper_mm - lower_mm is at most this if rounding allows it. first, last: parameters or
arrays of them, which broadcast; None: the ends of the curve. ValueError for a range outside the
curve.)");
  module.def(
      "parameter_at_length", &parameterAtLengthOf, py::arg("curve"), py::arg("length_mm"),
      py::arg("tolerance_mm"),
      R"(The parameter up to which a curve of any class has that length, within the tolerance.

length_mm: from the beginning, a number or an array. ValueError for a length the curve does not
have.)");
  module.def("rotation_minimizing_frames", &movingFramesOf, py::arg("curve"), py::arg("parameters"),
             py::arg("normal") = py::none(),
             R"(Frames along a curve of any class that do not turn about its tangent: MovingFrames.

parameters increase; normal is the direction (3,) the first one is to have, None: any. At a joint
the normal goes on; where the tangent turns there, it is made orthogonal to the new one. ValueError
at a cusp, with the parameter.)");
}

}  // namespace seamwright::python
