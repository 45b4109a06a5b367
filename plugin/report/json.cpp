// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Version.hxx>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/numbers.hpp>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

ordered_json intervalsJson(const LeftOut& left_out) {
  ordered_json intervals = ordered_json::array();
  for (const Interval& interval : left_out.intervals)
    intervals.push_back({interval.lower, interval.upper});
  return intervals;
}

ordered_json leftOutJson(const SeamFigures& figures) {
  const ordered_json curvature = intervalsJson(figures.curvature_left_out);
  return {{"angle_deg", intervalsJson(figures.angle_left_out)},
          {"curvature_per_mm", curvature},
          {"curvature_rel", curvature}};
}

ordered_json worstJson(const std::optional<occ::WorstPoint>& worst) {
  if (!worst) return nullptr;
  return {{"quantity", worst->quantity},
          {"at", worst->at},
          {"point", {worst->point.x(), worst->point.y(), worst->point.z()}}};
}

ordered_json toleranceJson(const occ::Report& report) {
  const ContinuityTolerance& tolerance = report.tolerance;
  return {{"gap_mm", tolerance.gap_mm},
          {"angle_deg", givenDegrees(tolerance.angle_rad)},
          {"curvature_rel", tolerance.curvature_rel},
          {"flat_radius_mm", tolerance.flat_radius_mm},
          {"crease_deg", givenDegrees(tolerance.crease_rad)},
          {"level", name(report.level)}};
}

ordered_json summaryJson(const occ::Report& report) {
  const Summary summary = summarize(report);
  ordered_json by_level;
  for (const auto& [level, count] : summary.by_level) by_level[std::string(name(level))] = count;
  return {{"seams", report.seams.size()},
          {"matched_seams", summary.matched},
          {"open_edges", report.open.size()},
          {"non_manifold_edges", report.non_manifold.size()},
          {"by_level", by_level},
          {"smooth", summary.smooth},
          {"defects", summary.defects},
          {"creases", summary.creases},
          {"uncertified", summary.uncertified},
          {"max_gap_mm", summary.max_gap_mm},
          {"max_angle_deg", degrees_per_radian * summary.max_angle_rad},
          {"passed", report.passed()}};
}

}  // namespace

ordered_json figureJson(const std::optional<Figure>& figure, double factor) {
  if (!figure) return nullptr;
  return {{"lower", factor * figure->lower},
          {"upper", figure->upper ? ordered_json(factor * *figure->upper) : ordered_json(nullptr)},
          {"at", figure->at}};
}

ordered_json modelJson(const occ::ModelFacts& model) {
  return {{"path", model.path},   {"format", model.format}, {"length_unit", model.length_unit},
          {"faces", model.faces}, {"edges", model.edges},   {"notes", model.notes}};
}

ordered_json toJson(const occ::SeamResult& seam, const ContinuityTolerance& tolerance) {
  return {{"id", seam.id},
          {"kind", name(seam.kind)},
          {"edges", seam.edges},
          {"faces", seam.faces},
          {"length_mm", seam.length_mm},
          {"gap_mm", figureJson(seam.figures.gap_mm)},
          {"angle_deg", figureJson(seam.figures.angle_rad, degrees_per_radian)},
          {"curvature_per_mm", figureJson(seam.figures.curvature_per_mm)},
          {"curvature_rel", figureJson(seam.figures.curvature_rel)},
          {"curvature_change_per_mm2", figureJson(seam.figures.curvature_change_per_mm2)},
          {"curvature_change_rel", figureJson(seam.figures.curvature_change_rel)},
          {"left_out", leftOutJson(seam.figures)},
          {"level", name(seam.verdict.level)},
          {"class", name(seam.verdict.seam_class)},
          {"certified", seam.verdict.certain},
          {"worst", worstJson(seam.worst)},
          {"note", noteOf(seam, tolerance)}};
}

ordered_json toJson(const occ::Report& report) {
  ordered_json seams = ordered_json::array();
  for (const occ::SeamResult& seam : report.seams) seams.push_back(toJson(seam, report.tolerance));
  ordered_json open = ordered_json::array();
  for (const occ::NonSeamEdge& edge : report.open)
    open.push_back({{"edge", edge.edge}, {"face", edge.faces.front()}});
  ordered_json non_manifold = ordered_json::array();
  for (const occ::NonSeamEdge& edge : report.non_manifold)
    non_manifold.push_back({{"edge", edge.edge}, {"faces", edge.faces}});
  ordered_json json = headJson("seamwright.analysis/1", report);
  json["summary"] = summaryJson(report);
  json["time_s"] = {{"read", report.read_s}, {"analyze", report.analyze_s}};
  json["seams"] = std::move(seams);
  json["open"] = std::move(open);
  json["non_manifold"] = std::move(non_manifold);
  return json;
}

ordered_json headJson(const std::string& schema, const occ::ModelFacts& model) {
  return {
      {"schema", schema},
      {"generator",
       {{"name", "seamwright"}, {"version", SEAMWRIGHT_VERSION}, {"occt", OCC_VERSION_COMPLETE}}},
      {"model", modelJson(model)}};
}

ordered_json headJson(const std::string& schema, const occ::Report& report) {
  ordered_json json = headJson(schema, report.model);
  json["tolerance"] = toleranceJson(report);
  return json;
}

std::string toLine(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string toJsonLine(const occ::Report& report) {
  return toLine(toJson(report));
}

}  // namespace seamwright::report
