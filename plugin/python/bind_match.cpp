// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <seamwright/occ_adapter/match/match.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
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
  options.order = targetOrder(target);
  options.moves = movesOf(moves);
  options.max_move_mm = optionalNumber("max_move_mm", max_move_mm).value_or(options.max_move_mm);
  options.hold_sides = flagOf("hold_sides", hold_sides);
  options.match_mm = numberOf("match_mm", match_mm);
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
py::object seamOrNone(const occ::SeamResult& seam, const ContinuityTolerance& tolerance) {
  if (seam.id == 0) return py::none();
  return resultOf("Seam", plainObject(report::toJson(seam, tolerance)));
}

py::object seamBefore(const MatchResult& result) {
  return seamOrNone(result.report.before, result.tolerance);
}

py::object seamAfter(const MatchResult& result) {
  return seamOrNone(result.report.after, result.tolerance);
}

py::object plainOrNone(const py::object& seam) {
  return seam.is_none() ? seam : py::object(seam.attr("to_dict")());
}

py::dict matchDict(const MatchResult& result) {
  py::dict dict;
  dict["matched"] = result.report.matched;
  dict["reason"] = result.report.text();
  dict["reason_code"] = result.report.code();
  dict["exact"] = result.report.exact;
  dict["largest_move_mm"] = result.report.largest_move_mm;
  dict["before"] = plainOrNone(seamBefore(result));
  dict["after"] = plainOrNone(seamAfter(result));
  return dict;
}

/// A property that reads a member of the report.
template <auto Member>
auto reported() {
  return [](const MatchResult& result) { return result.report.*Member; };
}

void bindMatchResult(py::module_& module) {
  using Report = occ::MatchReport;
  const std::string doc = std::string("The result of Model.match_faces().") + copies_doc;
  py::class_<MatchResult> type(module, "MatchResult", py::module_local(), doc.c_str());
  bindCopies(type);
  type.def_property_readonly("matched", reported<&Report::matched>(),
                             "The faces join at the level asked for, proven.")
      .def_property_readonly(
          "reason", [](const MatchResult& result) { return result.report.text(); },
          "How, or why not; one line with numbers.")
      .def_property_readonly(
          "reason_code", [](const MatchResult& result) { return result.report.code(); },
          "Code of the reason why not: see docs/match.md. Empty if matched.")
      .def_property_readonly("exact", reported<&Report::exact>(),
                             "Joined in poles, to rounding; False: to the tolerance.")
      .def_readonly("model", &MatchResult::model,
                    "The two faces: a shell that shares the seam, or as they were where not "
                    "matched.")
      .def_property_readonly("before", &seamBefore,
                             "The seam as it was, a Seam with the numbers of the model; None where "
                             "there is none.")
      .def_property_readonly(
          "after", &seamAfter,
          "The seam as it is, with the numbers of the new model; as before where "
          "not matched.")
      .def_property_readonly("largest_move_mm", reported<&Report::largest_move_mm>(),
                             "Of a pole; where weights change, also of points, seen on a grid.")
      .def("to_dict", &matchDict, "All but the model as a plain dict.")
      .def("__repr__", [](const MatchResult& result) {
        return std::string("<MatchResult ") + (result.report.matched ? "matched" : "not matched") +
               ": " + result.report.text() + ">";
      });
}

constexpr const char* match_faces_doc =
    R"(Moves one or both of two faces so that they join along their common boundary: a MatchResult.

The model is not changed.

first, second: numbers of faces, from 1. target: 'G1' or 'G2'. moves: 'first', 'second' or 'both';
a face that moves lies on a spline surface that ends at the boundary. max_move_mm: largest_move_mm
may not be larger; None: any. hold_sides: the two other boundaries that end at the seam stay.
match_mm: free edges no further apart may be the boundary. edge: which of several common edges; 0:
the longest. Tolerances and progress as in analyze(). ValueError for bad arguments, with name and
value.)";

}  // namespace

void bindMatch(py::module_& module) {
  bindMatchResult(module);
  py::class_<occ::Model> model(module.attr("Model"));
  model.def("match_faces", &matchFaces, match_faces_doc, py::arg("first"), py::arg("second"),
            py::kw_only(), py::arg("target") = "G1", py::arg("moves") = "second",
            py::arg("max_move_mm") = py::none(), py::arg("hold_sides") = false,
            py::arg("match_mm") = 0.1, py::arg("edge") = 0, py::arg("profile") = "default",
            py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
            py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
            py::arg("crease_deg") = py::none(), py::arg("progress") = py::none());
}

}  // namespace seamwright::python
