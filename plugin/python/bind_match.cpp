// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <seamwright/occ_adapter/match/match.hpp>
#include <seamwright/occ_adapter/match/match_sides.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/match_json.hpp>

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
                       const py::object& depth_mm, const py::object& convert,
                       const py::object& fairness, const py::object& profile,
                       const py::object& gap_mm, const py::object& angle_deg,
                       const py::object& curvature_rel, const py::object& flat_radius_mm,
                       const py::object& crease_deg, const py::object& progress) {
  const int face_a = argument<int>("first", first, "the number of a face");
  const int face_b = argument<int>("second", second, "the number of a face");
  occ::FaceMatchOptions options;
  options.order = targetOrder(target);
  options.moves = movesOf(moves);
  options.max_move_mm = optionalNumber("max_move_mm", max_move_mm).value_or(options.max_move_mm);
  options.hold_sides = flagOf("hold_sides", hold_sides);
  options.match_mm = numberOf("match_mm", match_mm);
  options.edge = argument<int>("edge", edge, "the number of an edge");
  options.depth_mm = optionalNumber("depth_mm", depth_mm);
  options.convert = flagOf("convert", convert);
  options.fairness = numberOf("fairness", fairness);
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
  dict["remedy"] = result.report.remedy();
  dict["exact"] = result.report.exact;
  dict["largest_move_mm"] = result.report.largest_move_mm;
  dict["depth_mm"] = result.report.depth_mm;
  dict["moves"] = plainObject(report::movesJson(result.report.moves));
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
      .def_property_readonly(
          "remedy", [](const MatchResult& result) { return result.report.remedy(); },
          "What can be done about that reason. Empty if matched.")
      .def_property_readonly("depth_mm", reported<&Report::depth_mm>(),
                             "No point farther from the boundary moved; 0 if rows of poles moved.")
      .def_property_readonly(
          "moves",
          [](const MatchResult& result) {
            return plainObject(report::movesJson(result.report.moves));
          },
          "A dict for each face that moved, with the figures of its surface: see docs/repair.md.")
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
the longest. depth_mm: how far from the boundary the face may change; None: as little as needed.
convert: a face without poles that should move becomes a spline. fairness: by what factor the
variation of a face's curvature may grow. Tolerances and progress as in analyze(). ValueError for
bad arguments, with name and value.)";

/// The result of matching sides, with the tolerances that judged it.
struct SideMatchResult {
  occ::SideMatchReport report;
  occ::Model model;
  ContinuityTolerance tolerance;
};

int sideOrder(const py::object& target) {
  const auto level = argument<std::string>("target", target, "a name");
  for (int order = 0; order <= 2; ++order)
    if (level == "G" + std::to_string(order)) return order;
  throw py::value_error("target " + shown(target) + ": known are G0, G1 and G2");
}

/// An edge, a list of edges, or a dict of edges, neighbours, target, start and end.
occ::SideMatch sideOf(const py::object& value, int order) {
  occ::SideMatch side;
  side.order = order;
  if (!py::isinstance<py::dict>(value)) {
    side.side.edges = wholeNumbersOrOne("sides", value);
    return side;
  }
  for (const auto& [key, item] : value.cast<py::dict>()) {
    const auto name = py::cast<std::string>(key);
    const auto given = py::reinterpret_borrow<py::object>(item);
    if (name == "edges")
      side.side.edges = wholeNumbersOrOne("edges", given);
    else if (name == "neighbours")
      side.neighbours = wholeNumbersOrOne("neighbours", given);
    else if (name == "target")
      side.order = sideOrder(given);
    else if (name == "start")
      side.from = numberOf("start", given);
    else if (name == "end")
      side.to = numberOf("end", given);
    else
      throw py::value_error("sides has the key '" + name +
                            "': known are edges, neighbours, target, start and end");
  }
  return side;
}

std::vector<occ::SideMatch> sidesOf(const py::object& value, int order) {
  if (!isSequence(value))
    throw py::value_error("sides is " + shown(value) +
                          ": a sequence is needed, each item an edge, a list of edges or a dict");
  std::vector<occ::SideMatch> sides;
  for (const py::handle side : value)
    sides.push_back(sideOf(py::reinterpret_borrow<py::object>(side), order));
  return sides;
}

occ::HeldEdges holdOf(const py::object& hold) {
  const auto name = argument<std::string>("hold", hold, "a name");
  if (name == "none") return occ::HeldEdges::None;
  if (name == "position") return occ::HeldEdges::Position;
  if (name == "tangent") return occ::HeldEdges::Tangent;
  throw py::value_error("hold " + shown(hold) + ": known are none, position and tangent");
}

SideMatchResult matchSides(const occ::Model& model, const py::object& face, const py::object& sides,
                           const py::object& target, const py::object& depth_mm,
                           const py::object& hold, const py::object& average,
                           const py::object& convert, const py::object& max_move_mm,
                           const py::object& match_mm, const py::object& fairness,
                           const py::object& profile, const py::object& gap_mm,
                           const py::object& angle_deg, const py::object& curvature_rel,
                           const py::object& flat_radius_mm, const py::object& crease_deg,
                           const py::object& jobs, const py::object& progress) {
  const int number = argument<int>("face", face, "the number of a face");
  std::vector<occ::SideMatch> all = sidesOf(sides, sideOrder(target));
  for (std::size_t i = 0; i < all.size() && all.size() > 1; ++i)
    all[i].side.name = "side " + std::to_string(i + 1);
  occ::SideMatchOptions options;
  options.depth_mm = optionalNumber("depth_mm", depth_mm);
  options.hold = holdOf(hold);
  options.average = flagOf("average", average);
  options.convert = flagOf("convert", convert);
  options.max_move_mm = optionalNumber("max_move_mm", max_move_mm).value_or(options.max_move_mm);
  options.match_mm = numberOf("match_mm", match_mm);
  options.fairness = numberOf("fairness", fairness);
  options.jobs = wholeNumber("jobs", jobs);
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  return longCall(progress, [&](const occ::Progress& report) {
    SideMatchResult result{occ::matchSides(model.shape, number, all, options, report), model,
                           options.tolerance};
    result.model.shape = result.report.shape;
    return result;
  });
}

py::dict sideMatchDict(const SideMatchResult& result) {
  py::dict dict;
  dict["matched"] = result.report.matched;
  dict["reason"] = result.report.text();
  dict["reason_code"] = result.report.code();
  dict["remedy"] = result.report.remedy();
  dict["depth_mm"] = result.report.depth_mm;
  dict["seams"] = plainObject(report::seamsJson(result.report, result.tolerance));
  dict["moves"] = plainObject(report::movesJson(result.report.moves));
  return dict;
}

void bindSideMatchResult(py::module_& module) {
  const std::string doc = std::string("The result of Model.match_sides().") + copies_doc;
  py::class_<SideMatchResult> type(module, "SideMatchResult", py::module_local(), doc.c_str());
  bindCopies(type);
  const auto text = [](auto member) {
    return [member](const SideMatchResult& result) { return (result.report.*member)(); };
  };
  type.def_property_readonly(
          "matched", [](const SideMatchResult& result) { return result.report.matched; },
          "All sides have the target, proven.")
      .def_property_readonly("reason", text(&occ::SideMatchReport::text),
                             "How, or why not; one line with numbers.")
      .def_property_readonly("reason_code", text(&occ::SideMatchReport::code),
                             "Code of the reason why not: see docs/match.md. Empty if matched.")
      .def_property_readonly("remedy", text(&occ::SideMatchReport::remedy),
                             "What can be done about that reason. Empty if matched.")
      .def_property_readonly(
          "depth_mm", [](const SideMatchResult& result) { return result.report.depth_mm; },
          "No point farther from the sides moved.")
      .def_property_readonly(
          "seams",
          [](const SideMatchResult& result) {
            return plainObject(report::seamsJson(result.report, result.tolerance));
          },
          "A dict for each seam: side, target, and the seam before and after.")
      .def_property_readonly(
          "moves",
          [](const SideMatchResult& result) {
            return plainObject(report::movesJson(result.report.moves));
          },
          "A dict for each face that moved, with the figures of its surface: see docs/repair.md.")
      .def_readonly("model", &SideMatchResult::model,
                    "The model with the changed faces; as it was if not matched.")
      .def("to_dict", &sideMatchDict, "All but the model as a plain dict.")
      .def("__repr__", [](const SideMatchResult& result) {
        return std::string("<SideMatchResult ") +
               (result.report.matched ? "matched" : "not matched") + ": " + result.report.text() +
               ">";
      });
}

constexpr const char* match_sides_doc =
    R"(Changes a face so that sides of it join their neighbours: a SideMatchResult.

The model is not changed.

face: the number of the face, from 1. sides: for each side an edge, the edges of a chain, or a dict
with edges and, if wanted, neighbours (the edges that it joins), target, start and end (the part
of its length, 0 to 1). target: 'G0', 'G1' or 'G2'. depth_mm: how far from the sides the face may
change; None: as little as needed. hold: what its other edges keep, 'none', 'position' or 'tangent'.
average: the neighbours move too. convert: faces without poles become splines. max_move_mm: of a
pole; None: any. match_mm: free edges no further apart meet. fairness: by what factor the variation
of a face's curvature may grow. Tolerances and progress as in analyze(). ValueError for bad
arguments, with name and value.)";

}  // namespace

void bindMatch(py::module_& module) {
  bindSideMatchResult(module);
  bindMatchResult(module);
  py::class_<occ::Model> model(module.attr("Model"));
  model.def("match_faces", &matchFaces, match_faces_doc, py::arg("first"), py::arg("second"),
            py::kw_only(), py::arg("target") = "G1", py::arg("moves") = "second",
            py::arg("max_move_mm") = py::none(), py::arg("hold_sides") = false,
            py::arg("match_mm") = 0.1, py::arg("edge") = 0, py::arg("depth_mm") = py::none(),
            py::arg("convert") = false, py::arg("fairness") = 1.5, py::arg("profile") = "default",
            py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
            py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
            py::arg("crease_deg") = py::none(), py::arg("progress") = py::none());
  model.def(
      "match_sides", &matchSides, match_sides_doc, py::arg("face"), py::arg("sides"), py::kw_only(),
      py::arg("target") = "G1", py::arg("depth_mm") = py::none(), py::arg("hold") = "none",
      py::arg("average") = false, py::arg("convert") = false, py::arg("max_move_mm") = py::none(),
      py::arg("match_mm") = 0.1, py::arg("fairness") = 1.5, py::arg("profile") = "default",
      py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
      py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
      py::arg("crease_deg") = py::none(), py::arg("jobs") = 0, py::arg("progress") = py::none());
}

}  // namespace seamwright::python
