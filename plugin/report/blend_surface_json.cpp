// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/plugin/report/blend_surface_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <sstream>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

/// What the seam with each face of the sides must reach.
std::map<int, Level> levelsOf(const occ::BlendSurfaceReport& blend) {
  std::map<int, Level> levels;
  for (const occ::BlendSeam& seam : blend.seams) {
    const auto [at, added] = levels.try_emplace(seam.result.faces[0], seam.level);
    at->second = std::min(at->second, seam.level);
  }
  return levels;
}

Level highest(const std::map<int, Level>& levels) {
  Level result = Level::G0;
  for (const auto& [face, level] : levels) result = std::max(result, level);
  return result;
}

/// Judges each seam of the new face by the level of its end, and drops seams with other faces.
void judgeByEnds(const std::map<int, Level>& levels, int made, occ::Report& report) {
  const auto other = [&](const occ::SeamResult& seam) {
    return seam.faces[0] == made ? seam.faces[1] : seam.faces[0];
  };
  std::erase_if(report.seams,
                [&](const occ::SeamResult& seam) { return !levels.contains(other(seam)); });
  for (occ::SeamResult& seam : report.seams)
    seam.verdict = judge(seam.figures, report.tolerance, levels.at(other(seam)));
}

ordered_json sideJson(const occ::BlendEndReport& end) {
  return {{"side", end.name},           {"edges", end.edges},           {"faces", end.faces},
          {"length_mm", end.length_mm}, {"covered_mm", end.covered_mm}, {"target", name(end.level)},
          {"reason", end.reason}};
}

/// "Edge3, Edge4": names with numbers.
std::string numberedNames(const char* kind, const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers)
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", kind, number);
  return text;
}

ordered_json lateralJson(const occ::BlendLateralReport& lateral) {
  return {{"edges", lateral.edges},           {"faces", lateral.faces},
          {"length_mm", lateral.length_mm},   {"distance_mm", lateral.distance_mm},
          {"covered_mm", lateral.covered_mm}, {"target", name(lateral.level)},
          {"reason", lateral.reason}};
}

/// A row for a side that its seams do not cover.
Row rowOf(const occ::BlendEndReport& end, std::size_t columns) {
  Row row = {std::string(name(end.level)), "none", numberedNames("Edge", end.edges),
             numberedNames("Face", end.faces),
             fmt::format("{:.3f}", end.length_mm - end.covered_mm)};
  row.resize(row.size() + columns, "-");
  row.push_back(end.name + ": " + end.reason);
  return row;
}

/// What else there is to say of the surface, a line each.
std::string remarksOf(const occ::BlendSurfaceReport& blend) {
  std::string text;
  if (blend.to)
    text +=
        fmt::format("from {:.4g} to {:.4g} mm long, up to {:.3g} mm from Face{}\n",
                    blend.to->least_mm, blend.to->most_mm, blend.to->distance_mm, blend.to->face);
  for (const occ::BlendLateralReport& lateral : blend.laterals)
    text += fmt::format("lateral boundary along {}: at most {:.3g} mm from it{}{}\n",
                        numberedNames("Edge", lateral.edges), lateral.distance_mm,
                        lateral.reason.empty() ? "" : "; ", lateral.reason);
  if (blend.fold)
    text += fmt::format("the surface folds {:.4g} mm from the {}, at ({:.6g})\n",
                        blend.fold->distance_mm, blend.ends.front().name,
                        fmt::join(blend.fold->point_mm, ", "));
  return text;
}

std::string verdictText(const occ::BlendSurfaceReport& blend, bool reached) {
  if (reached) return "REACHED: every seam has the level of its end";
  if (blend.seams.empty()) return "NOT REACHED: the surface meets no side";
  return blend.fold && blend.ends.size() == 1
             ? "NOT REACHED: the extension folds"
             : "NOT REACHED: a seam, or a part of a side, falls short";
}

std::vector<Column> columnsOf(const occ::BlendSurfaceReport& blend,
                              const ContinuityTolerance& tolerance) {
  std::vector<Column> columns = figureColumns(tolerance);
  const auto is_g3 = [](const occ::BlendSeam& seam) { return seam.level == Level::G3; };
  if (std::ranges::any_of(blend.seams, is_g3))
    columns.push_back(
        {"change %", &SeamFigures::curvature_change_rel, 100, 100 * tolerance.curvature_rel});
  return columns;
}

}  // namespace

Judge judgeOf(const occ::BlendSurfaceReport& blend, const ContinuityTolerance& tolerance,
              int faces) {
  return [&blend, tolerance, faces](const occ::Model& model, const occ::Progress& progress) {
    const std::map<int, Level> levels = levelsOf(blend);
    occ::AnalyzeOptions asked;
    asked.tolerance = tolerance;
    asked.level = highest(levels);
    asked.match_mm = 2 * tolerance.gap_mm;
    const bool same_faces = model.faceCount() == faces;
    if (same_faces) asked.faces = {faces};
    occ::Report found = occ::analyze(model, asked, progress);
    if (same_faces) judgeByEnds(levels, faces, found);
    return countsOf(found, model);
  };
}

ordered_json sidesJson(const occ::BlendSurfaceReport& blend) {
  ordered_json sides = ordered_json::array();
  for (const occ::BlendEndReport& end : blend.ends) sides.push_back(sideJson(end));
  return sides;
}

ordered_json lateralsJson(const occ::BlendSurfaceReport& blend) {
  ordered_json laterals = ordered_json::array();
  for (const occ::BlendLateralReport& lateral : blend.laterals)
    laterals.push_back(lateralJson(lateral));
  return laterals;
}

ordered_json foldJson(const occ::BlendSurfaceReport& blend) {
  if (!blend.fold) return nullptr;
  const Eigen::Vector3d& point = blend.fold->point_mm;
  return {{"distance_mm", blend.fold->distance_mm},
          {"point_mm", {point.x(), point.y(), point.z()}}};
}

ordered_json extensionJson(const occ::BlendSurfaceReport& blend) {
  if (!blend.to) return nullptr;
  return {{"face", blend.to->face},
          {"least_mm", blend.to->least_mm},
          {"most_mm", blend.to->most_mm},
          {"distance_mm", blend.to->distance_mm}};
}

ordered_json toJson(const occ::BlendSurfaceReport& blend, const ContinuityTolerance& tolerance,
                    const occ::ModelFacts& given, const std::optional<WrittenModel>& output) {
  ordered_json json = headJson("seamwright.blend_surface/1", given);
  json["gap_mm"] = tolerance.gap_mm;
  json["angle_deg"] = givenDegrees(tolerance.angle_rad);
  json["curvature_rel"] = tolerance.curvature_rel;
  json["reached"] = blend.reached;
  json["surface"] = {{"degrees", {blend.surface.degree_u, blend.surface.degree_v}},
                     {"poles", {blend.surface.countU(), blend.surface.countV()}},
                     {"spans", blend.spans}};
  json["fold"] = foldJson(blend);
  json["to"] = extensionJson(blend);
  json["output"] = toJson(output);
  json["sides"] = sidesJson(blend);
  json["laterals"] = lateralsJson(blend);
  json["seams"] = ordered_json::array();
  for (const occ::BlendSeam& seam : blend.seams) {
    json["seams"].push_back(toJson(seam.result, tolerance));
    json["seams"].back()["target"] = name(seam.level);
  }
  return json;
}

std::string toTable(const occ::BlendSurfaceReport& blend, const ContinuityTolerance& tolerance,
                    const ModelCounts& memory, const std::optional<WrittenModel>& output) {
  const std::vector<Column> columns = columnsOf(blend, tolerance);
  std::vector<Row> rows = {{"target", "level", "edge", "face", "length mm"}};
  for (const Column& column : columns) rows[0].emplace_back(column.title);
  rows[0].emplace_back("note");
  for (const occ::BlendSeam& seam : blend.seams) {
    Row row = {
        std::string(name(seam.level)),
        std::string(name(seam.result.verdict.level)) + (seam.result.verdict.certain ? "" : "?"),
        edgesText(seam.result), "Face" + std::to_string(seam.result.faces[0]),
        fmt::format("{:.3f}", seam.result.length_mm)};
    for (const Column& column : columns) row.push_back(cellOf(seam.result, column));
    row.push_back(noteOf(seam.result, tolerance));
    rows.push_back(row);
  }
  for (const occ::BlendEndReport& end : blend.ends)
    if (!end.reason.empty()) rows.push_back(rowOf(end, columns.size()));
  std::ostringstream out;
  constexpr std::size_t length = 4;  // index of the first column of numbers
  writeRows(out, rows, length);
  out << fmt::format("surface of degrees {} x {}, {} x {} poles\n", blend.surface.degree_u,
                     blend.surface.degree_v, blend.surface.countU(), blend.surface.countV());
  out << remarksOf(blend);
  if (output) out << output->path.string() << ": " << name(output->format) << '\n';
  const std::string differences = output ? output->differences(memory) : "";
  if (!differences.empty()) out << output->path.string() << ' ' << differences << '\n';
  const bool reached = blend.reached && (!output || output->isAsGoodAs(memory));
  out << verdictText(blend, reached) << '\n';
  return out.str();
}

}  // namespace seamwright::report
