// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <seamwright/core/blend/common_knots.hpp>
#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

constexpr NamedValue<MatchBy> match_kinds[] = {{"length", MatchBy::Length},
                                               {"features", MatchBy::Features}};

std::vector<std::vector<double>> givenOf(const py::object& value) {
  if (!isSequence(value))
    throw py::value_error("given is " + shown(value) +
                          ": a sequence of parameters for each curve is needed");
  std::vector<std::vector<double>> given;
  for (const py::handle item : value)
    given.push_back(listOf(("given[" + std::to_string(given.size()) + "]").c_str(),
                           py::reinterpret_borrow<py::object>(item)));
  return given;
}

/// The keywords of MatchOptions.
struct MatchArguments {
  const py::object& by;
  const py::object& given;
  const py::object& find_start;
  const py::object& find_direction;
  const py::object& corner_rad;
  const py::object& prominence;
  const py::object& reach;

  MatchOptions options() const {
    MatchOptions result;
    result.by = choiceOf("by", by, match_kinds);
    if (!given.is_none()) {
      result.by = MatchBy::Given;
      result.given = givenOf(given);
    }
    result.find_start = flagOf("find_start", find_start);
    result.find_direction = flagOf("find_direction", find_direction);
    result.corner_rad = numberOf("corner_rad", corner_rad);
    result.prominence = numberOf("prominence", prominence);
    result.reach = numberOf("reach", reach);
    return result;
  }
};

py::object summaryResult(const MatchSummary& summary) {
  py::dict dict;
  dict["pieces_before"] = summary.pieces_before;
  dict["pieces_after"] = summary.pieces_after;
  dict["merged"] = summary.merged;
  dict["features"] = summary.features;
  dict["matched_features"] = summary.matched_features;
  dict["lengths_fit_better"] = summary.lengths_fit_better;
  dict["unknown_pieces"] = summary.unknown_pieces;
  dict["reversed"] = summary.reversed;
  dict["start"] = summary.start;
  dict["largest_ratio"] = summary.largest_ratio;
  return resultOf("MatchSummary", dict);
}

py::object matchPiecesOf(const py::object& keys, const py::object& by, const py::object& given,
                         const py::object& find_start, const py::object& find_direction,
                         const py::object& closeness, const py::object& corner_rad,
                         const py::object& prominence, const py::object& reach) {
  const std::vector<BezierSpline> frames = bezierSplinesOf("keys", keys);
  MatchOptions options =
      MatchArguments{by, given, find_start, find_direction, corner_rad, prominence, reach}
          .options();
  options.closeness = numberOf("closeness", closeness);
  const MatchedFrames matched = [&] {
    const py::gil_scoped_release release;
    return matchPieces(frames, options);
  }();
  py::dict dict;
  dict["curves"] = matched.frames;
  dict["summary"] = summaryResult(matched.summary);
  return resultOf("MatchedCurves", dict);
}

py::object commonKnotsOf(const py::object& keys, const py::object& tolerance_mm,
                         const py::object& by, const py::object& given,
                         const py::object& find_start, const py::object& find_direction,
                         const py::object& corner_rad, const py::object& prominence,
                         const py::object& reach, const py::object& joint_tolerance,
                         const py::object& max_segments) {
  const std::vector<BezierSpline> frames = bezierSplinesOf("keys", keys);
  CommonKnotsOptions options;
  options.match =
      MatchArguments{by, given, find_start, find_direction, corner_rad, prominence, reach}
          .options();
  options.tolerance_mm = numberOf("tolerance_mm", tolerance_mm);
  options.joint_tolerance = numberOf("joint_tolerance", joint_tolerance);
  options.max_segments = wholeNumber("max_segments", max_segments);
  const CommonKnots common = [&] {
    const py::gil_scoped_release release;
    return commonKnots(frames, options);
  }();
  py::dict dict;
  dict["curves"] = common.frames;
  dict["distance_mm"] = common.distance_mm;
  dict["reached"] = common.reached;
  dict["summary"] = summaryResult(common.summary);
  return resultOf("CommonKnots", dict);
}

}  // namespace

void bindCurveMatch(py::module_& module) {
  const MatchOptions usual;
  module.def(
      "match_pieces", &matchPiecesOf, py::arg("keys"), py::kw_only(), py::arg("by") = "length",
      py::arg("given") = py::none(), py::arg("find_start") = usual.find_start,
      py::arg("find_direction") = usual.find_direction, py::arg("closeness") = usual.closeness,
      py::arg("corner_rad") = usual.corner_rad, py::arg("prominence") = usual.prominence,
      py::arg("reach") = usual.reach,
      R"(Curves divided into corresponding pieces, exactly: MatchedCurves, keys of SplineBlend.

keys: two or more curves of any class, all open or all closed; messages call them frames. by:
'length', equal shares of the length, or 'features', corners, jumps and extrema of the curvature in
order. given: instead of by, parameters that correspond: increasing, equally many for each curve; of
closed curves the first is the start. find_start: closed curves start where they are nearest to the
first. find_direction: curves run in the direction in which they are nearer to it. closeness: shares
of the length within which joints of different curves are one. corner_rad: joints that turn by more
are corners. prominence: share of the range of the curvature by which an extremum must differ from
its neighbours. reach: share of the length beyond which features are not matched, unless all
corners, or all jumps between them, are alike in order. ValueError, with index and value, for curves
that can't be matched.)");
  const CommonKnotsOptions common;
  module.def("common_knots", &commonKnotsOf, py::arg("keys"), py::kw_only(),
             py::arg("tolerance_mm") = common.tolerance_mm, py::arg("by") = "length",
             py::arg("given") = py::none(), py::arg("find_start") = usual.find_start,
             py::arg("find_direction") = usual.find_direction,
             py::arg("corner_rad") = usual.corner_rad, py::arg("prominence") = usual.prominence,
             py::arg("reach") = usual.reach, py::arg("joint_tolerance") = common.joint_tolerance,
             py::arg("max_segments") = common.max_segments,
             R"(Curves over common knots within a tolerance: CommonKnots, keys of SplineBlend.

Corresponding points run along all curves with smooth speeds, so that curves between them are fair.
joint_tolerance: joints with larger defects keep their lower order. max_segments: a limit of the
work. Further arguments are those of match_pieces(). ValueError, with index and value, for curves
that can't be matched, and for a curve that stops.)");
}

}  // namespace seamwright::python
