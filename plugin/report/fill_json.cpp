// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/model/degenerate_edges.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>
#include <seamwright/plugin/report/fill_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/reason_json.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <sstream>
#include <utility>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

double degrees(double rad) {
  return rad * degrees_per_radian;
}

ordered_json maybe(const std::optional<double>& value, double factor = 1) {
  return value ? ordered_json(*value * factor) : ordered_json(nullptr);
}

ordered_json sideJson(const occ::FilledSide& side) {
  return {{"edges", side.edges},
          {"position_only", side.position_only},
          {"edge_degree", side.edge_degree},
          {"cross_degree", side.cross_degree},
          {"gap_mm", side.gap_mm},
          {"angle_deg", degrees(side.angle_rad)},
          {"corner_deg", {degrees(side.corner_rad[0]), degrees(side.corner_rad[1])}}};
}

ordered_json causeJson(const occ::FillReason& cause) {
  ordered_json point_mm = nullptr;
  if (const auto& point = cause.point_mm) point_mm = {point->x(), point->y(), point->z()};
  return {{"code", codeOf(cause.fault)},
          {"numbers", numbersJson(cause.numbers)},
          {"edges", cause.edges},
          {"point_mm", std::move(point_mm)}};
}

ordered_json cornerJson(const FillCorner& corner) {
  return {{"angle_deg", degrees(corner.angle_rad)},
          {"twist_defect_mm", corner.twist_defect_mm},
          {"exact", corner.exact}};
}

ordered_json aroundJson(const std::optional<occ::RepairedAround>& around) {
  if (!around) return nullptr;
  ordered_json left = ordered_json::array();
  for (const occ::LeftSeam& seam : around->left)
    left.push_back({{"edges", seam.edges},
                    {"reason_code", codeOf(seam.reason.fault)},
                    {"reason", seam.reason.text}});
  return {{"edges", around->edges},
          {"treated", around->treated},
          {"repaired", around->repaired},
          {"left", left},
          {"largest_move_mm", around->largest_move_mm},
          {"used", around->used}};
}

std::string aroundText(const occ::RepairedAround& around) {
  if (around.treated == 0) return "no seam that ends at the hole needs a repair\n";
  std::string text =
      fmt::format("{} of {} that end at the hole repaired first, faces moved by up to {:.3g} mm\n",
                  around.repaired, counted(around.treated, "seam"), around.largest_move_mm);
  for (const occ::LeftSeam& seam : around.left)
    text += fmt::format("left: Edge{}: {}\n", fmt::join(seam.edges, ", Edge"), seam.reason.text);
  if (!around.used)
    text += "with these repairs no fill reaches the target, without them one does: left out\n";
  return text;
}

ordered_json seamsJson(const std::vector<occ::SeamResult>& seams,
                       const ContinuityTolerance& tolerance) {
  ordered_json all = ordered_json::array();
  for (const occ::SeamResult& seam : seams) all.push_back(toJson(seam, tolerance));
  return all;
}

/// Seams that do not certainly reach the target.
std::vector<occ::SeamResult> missed(std::vector<occ::SeamResult> seams,
                                    const occ::FillHoleOptions& options) {
  std::erase_if(seams, [&options](const occ::SeamResult& seam) {
    return certainlyReaches(seam.figures, options.tolerance, options.target);
  });
  return seams;
}

void setDefects(std::vector<occ::SeamResult> seams, ModelCounts& counts) {
  counts.defects = static_cast<int>(seams.size());
  counts.defect_seams = std::move(seams);
}

std::string textOf(const std::optional<double>& value, const char* unit, double factor = 1) {
  return value ? fmt::format("{:.3g} {}", factor * *value, unit) : "unknown";
}

/// "face 3, the fill"; between new faces "the fill".
std::string betweenText(const occ::SeamResult& seam, const occ::FillHoleReport& report) {
  const std::string& one = report.faceName(seam.faces[0]);
  const std::string& other = report.faceName(seam.faces[1]);
  return one == other ? one : one + ", " + other;
}

/// A row for each new seam, those that miss the target first. Without the fill the model has no
/// edges of new seams.
std::vector<Row> rowsOf(const occ::FillHoleReport& report, const occ::FillHoleOptions& options) {
  const std::vector<Column> columns = figureColumns(options.tolerance);
  std::vector<Row> rows(1, {"result", "edge", "between"}), met;
  for (const Column& column : columns) rows.front().emplace_back(column.title);
  rows.front().emplace_back("note");
  for (const auto* seams : {&report.outer, &report.inner})
    for (const occ::SeamResult& seam : *seams) {
      const bool reaches = certainlyReaches(seam.figures, options.tolerance, options.target);
      Row row = {reaches ? "met" : "missed", report.filled ? edgesText(seam) : "-",
                 betweenText(seam, report)};
      for (const Column& column : columns) row.push_back(cellOf(seam, column));
      row.push_back(noteOf(seam, options.tolerance));
      (reaches ? met : rows).push_back(std::move(row));
    }
  rows.insert(rows.end(), met.begin(), met.end());
  return rows;
}

}  // namespace

ordered_json toJson(const occ::Hole& hole) {
  ordered_json sides = ordered_json::array();
  for (const occ::HoleSide& side : hole.sides) {
    ordered_json edges = ordered_json::array(), faces = ordered_json::array();
    for (const occ::HoleEdge& edge : side.edges) {
      edges.push_back(edge.edge);
      faces.push_back(edge.use.face);
    }
    sides.push_back({{"edges", edges}, {"faces", faces}, {"length_mm", side.length_mm}});
  }
  return {{"id", hole.id},
          {"length_mm", hole.length_mm},
          {"centre_mm", {hole.centre.x(), hole.centre.y(), hole.centre.z()}},
          {"has_corners", hole.has_corners},
          {"longest", hole.longest},
          {"sides", sides}};
}

ModelCounts countsOf(const occ::FillHoleReport& report, const occ::FillHoleOptions& options) {
  ModelCounts counts{.edges = report.model.edgeCount(),
                     .faces = report.model.faceCount(),
                     .open_edges = static_cast<int>(occ::findSeams(report.model.shape).open.size()),
                     .seams = static_cast<int>(report.outer.size() + report.inner.size()),
                     .without_length = occ::degenerateEdges(report.model)};
  std::vector<occ::SeamResult> seams = report.outer;
  seams.insert(seams.end(), report.inner.begin(), report.inner.end());
  setDefects(missed(std::move(seams), options), counts);
  return counts;
}

ModelCounts countsOf(const occ::Report& found, const occ::Model& model,
                     const occ::FillHoleOptions& options) {
  ModelCounts counts = countsOf(found, model);
  setDefects(missed(found.seams, options), counts);
  return counts;
}

Judge judgeOf(const occ::FillHoleReport& report, const occ::FillHoleOptions& options) {
  return [&report, &options](const occ::Model& model, const occ::Progress& progress) {
    occ::AnalyzeOptions asked;
    asked.tolerance = options.tolerance;
    asked.level = options.target;
    asked.jobs = options.jobs;
    if (report.filled && model.faceCount() == report.model.faceCount()) asked.faces = report.faces;
    return countsOf(occ::analyze(model, asked, progress), model, options);
  };
}

ordered_json toJson(const occ::FillHoleReport& report, const occ::FillHoleOptions& options,
                    const occ::ModelFacts& given, const std::optional<WrittenModel>& output) {
  ordered_json json = headJson("seamwright.fill/1", given);
  json["target"] = name(options.target);
  json["gap_mm"] = options.tolerance.gap_mm;
  json["angle_deg"] = givenDegrees(options.tolerance.angle_rad);
  json["curvature_rel"] = options.tolerance.curvature_rel;
  json["corner_deg"] = givenDegrees(options.corner_rad);
  json["filled"] = report.filled;
  json["reached"] = report.reached;
  json["reason"] = textOf(report.reason);
  json["reason_code"] = codeOf(report.reason.fault);
  json["method"] = name(report.method);
  json["causes"] = ordered_json::array();
  for (const occ::FillReason& cause : report.reason.causes)
    json["causes"].push_back(causeJson(cause));
  json["around"] = aroundJson(report.around);
  json["largest_gap_mm"] = maybe(report.largestGap_mm());
  json["largest_angle_deg"] = maybe(report.largestAngle_rad(), degrees(1));
  json["largest_curvature_rel"] = maybe(report.largestCurvature_rel());
  json["curvature_jump_per_mm"] = maybe(report.curvature_jump_per_mm);
  json["curvature_per_mm"] = maybe(report.curvature_per_mm);
  json["around_curvature_per_mm"] = maybe(report.around_curvature_per_mm);
  json["both_ways_per_mm"] = maybe(report.both_ways_per_mm);
  json["waves"] = maybe(report.waves());
  json["removed_curvature_per_mm"] = maybe(report.removed_curvature_per_mm);
  json["output"] = toJson(output);
  json["faces"] = report.faces;
  json["regular"] = report.regular;
  json["sides"] = ordered_json::array();
  for (const occ::FilledSide& side : report.sides) json["sides"].push_back(sideJson(side));
  json["corners"] = ordered_json::array();
  for (const FillCorner& corner : report.corners) json["corners"].push_back(cornerJson(corner));
  json["outer"] = seamsJson(report.outer, options.tolerance);
  json["inner"] = seamsJson(report.inner, options.tolerance);
  json["time_s"] = {
      {"build", report.build_s}, {"sew", report.sew_s}, {"measure", report.measure_s}};
  return json;
}

std::string shortly(const occ::Hole& hole) {
  std::string centre;
  for (const double coordinate : hole.centre)
    centre += (centre.empty() ? "" : ", ") +
              fmt::format("{:.4g}", std::abs(coordinate) < 1e-9 ? 0 : coordinate);
  return "Hole" + std::to_string(hole.id) + ": " +
         (hole.has_corners ? counted(hole.sides.size(), "side") : std::string("no corner")) + ", " +
         fmt::format("{:.4g}", hole.length_mm) + " mm around (" + centre + ")";
}

std::string toTable(const occ::FillHoleReport& report, const occ::FillHoleOptions& options,
                    const std::optional<WrittenModel>& output) {
  std::ostringstream out;
  if (report.around) out << aroundText(*report.around);
  if (report.filled)
    out << "filled with " << counted(report.faces.size(), "face");
  else
    out << "not filled";
  if (!report.outer.empty()) {
    const std::optional<double> angle = report.largestAngle_rad(),
                                curvature = report.largestCurvature_rel();
    out << "; " << counted(report.outer.size(), "seam") << " to the neighbours, "
        << report.inner.size() << " inside: gap at most " << textOf(report.largestGap_mm(), "mm")
        << ", angle " << textOf(angle, "degrees", degrees(1)) << ", curvature "
        << textOf(curvature, "%", 100) << "\n\n";
    constexpr std::size_t first_number = 3;  // index of the first column of numbers
    writeRows(out, rowsOf(report, options), first_number);
  }
  if (const std::optional<double> times = report.waves())
    out << fmt::format(
        "the fill bends both ways, {:.2g} times as strongly as the faces around it: look at its "
        "stripes for dents or waves\n",
        *times);
  out << '\n';
  const ModelCounts memory = countsOf(report, options);
  const std::string differences = output ? output->differences(memory) : "";
  if (!differences.empty()) out << output->path.string() << ' ' << differences << '\n';
  const bool reached = report.reached && (!output || output->isAsGoodAs(memory));
  out << (reached ? "REACHED " : "NOT REACHED ") << name(options.target)
      << (report.reason.empty() ? "" : ": " + textOf(report.reason)) << '\n';
  return out.str();
}

}  // namespace seamwright::report
