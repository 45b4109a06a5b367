// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <seamwright/occ_adapter/match/match.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/report/json.hpp>

namespace seamwright::python {

namespace {

/// The result of matching two faces, with the tolerances that judged it.
struct MatchResult {
  occ::MatchReport report;
  occ::Model model;
  ContinuityTolerance tolerance;
};

occ::MatchMoves movesOf(const py::object& moves) {
  const auto name = argument<std::string>("moves", moves, "a name");
  if (name == "first") return occ::MatchMoves::First;
  if (name == "second") return occ::MatchMoves::Second;
  if (name == "both") return occ::MatchMoves::Both;
  throw py::value_error("moves " + shown(moves) + ": known are first, second and both");
}

MatchResult matchFaces(const occ::Model& model, const py::object& first, const py::object& second,
                       const py::object& target, const py::object& moves,
                       const py::object& max_move_mm, const py::object& hold_sides,
                       const py::object& match_mm, const py::object& edge,
                       const py::object& profile, const py::object& gap_mm,
                       const py::object& angle_deg, const py::object& curvature_rel,
                       const py::object& flat_radius_mm, const py::object& crease_deg,
                       const py::object& progress) {
  const int face_a = argument<int>("first", first, "the number of a face");
  const int face_b = argument<int>("second", second, "the number of a face");
  occ::FaceMatchOptions options;
  options.order = orderOf(target);
  options.moves = movesOf(moves);
  if (!max_move_mm.is_none())
    options.max_move_mm = argument<double>("max_move_mm", max_move_mm, "a number");
  options.hold_sides = flagOf("hold_sides", hold_sides);
  options.match_mm = argument<double>("match_mm", match_mm, "a number");
  options.edge = argument<int>("edge", edge, "the number of an edge");
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  return longCall(progress, [&](const occ::Progress& report) {
    MatchResult result{
        occ::matchFaces(model.shape, face_a, face_b, options, report), {}, options.tolerance};
    result.model = occ::modelFromShape(result.report.shape);
    return result;
  });
}

/// None if the faces have no common boundary.
py::object seamDict(const occ::SeamResult& seam, const ContinuityTolerance& tolerance) {
  if (seam.id == 0) return py::none();
  return plainObject(report::toJson(seam, tolerance));
}

py::dict matchDict(const MatchResult& result) {
  py::dict dict;
  dict["matched"] = result.report.matched;
  dict["reason"] = result.report.reason;
  dict["exact"] = result.report.exact;
  dict["largest_move_mm"] = result.report.largest_move_mm;
  dict["before"] = seamDict(result.report.before, result.tolerance);
  dict["after"] = seamDict(result.report.after, result.tolerance);
  return dict;
}

}  // namespace

void bindMatch(py::module_& module) {
  py::class_<MatchResult>(module, "MatchResult", py::module_local(),
                          "What came of Model.match_faces().")
      .def_property_readonly(
          "matched", [](const MatchResult& result) { return result.report.matched; },
          "The faces join at the level asked for, proven.")
      .def_property_readonly(
          "reason", [](const MatchResult& result) { return result.report.reason; },
          "How, or why not; one line with numbers.")
      .def_property_readonly(
          "exact", [](const MatchResult& result) { return result.report.exact; },
          "Joined in poles, to rounding; False: to the tolerance.")
      .def_readonly(
          "model", &MatchResult::model,
          "The two faces: a shell that shares the seam, or as they were where not matched.")
      .def_property_readonly(
          "before",
          [](const MatchResult& result) {
            return seamDict(result.report.before, result.tolerance);
          },
          "The seam as it was, a dict with the keys of the JSON and the numbers of the model; None "
          "where "
          "there is none.")
      .def_property_readonly(
          "after",
          [](const MatchResult& result) { return seamDict(result.report.after, result.tolerance); },
          "The seam as it is, with the numbers of the new model; as before where not matched.")
      .def_property_readonly(
          "largest_move_mm",
          [](const MatchResult& result) { return result.report.largest_move_mm; },
          "Of a pole; where weights change, also of points, seen on a grid.")
      .def("to_dict", &matchDict, "All but the model as a plain dict.")
      .def("__repr__", [](const MatchResult& result) {
        return std::string("<MatchResult ") + (result.report.matched ? "matched" : "not matched") +
               ": " + result.report.reason + ">";
      });
  py::class_<occ::Model> model(module.attr("Model"));
  model.def(
      "match_faces", &matchFaces, py::arg("first"), py::arg("second"), py::kw_only(),
      py::arg("target") = "G1", py::arg("moves") = "second", py::arg("max_move_mm") = py::none(),
      py::arg("hold_sides") = false, py::arg("match_mm") = 0.1, py::arg("edge") = 0,
      py::arg("profile") = "default", py::arg("gap_mm") = py::none(),
      py::arg("angle_deg") = py::none(), py::arg("curvature_rel") = py::none(),
      py::arg("flat_radius_mm") = py::none(), py::arg("crease_deg") = py::none(),
      py::arg("progress") = py::none(),
      "Moves one or both of two faces so that they join along their common boundary. Returns a "
      "MatchResult; the model is not changed.\n\n"
      "first, second: numbers of faces, from 1. target: 'G1' or 'G2'. moves: 'first', 'second' or "
      "'both'; a face that moves lies on a spline surface that ends at the boundary. max_move_mm: "
      "largest_move_mm may not be larger. hold_sides: the two other boundaries that end at the "
      "seam "
      "stay. match_mm: "
      "free edges no further apart may be the boundary. edge: which of several common edges; 0: "
      "the "
      "longest. Tolerances as in analyze().");
}

}  // namespace seamwright::python
