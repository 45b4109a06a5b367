// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/match_json.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/repair_json.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <sstream>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

std::string changed(const std::string& before, const std::string& after) {
  return before == after ? before : before + " -> " + after;
}

Row rowOf(const occ::MatchedSeam& seam, const std::vector<Column>& columns) {
  Row row = {seam.side, std::string(name(seam.level)),
             changed(std::string(name(seam.before.verdict.level)),
                     std::string(name(seam.after.verdict.level))),
             edgesText(seam.before), facesText(seam.before)};
  for (const Column& column : columns)
    row.push_back(changed(cellOf(seam.before, column), cellOf(seam.after, column)));
  return row;
}

std::string moveText(const occ::FaceMove& move) {
  std::string text =
      fmt::format("Face{} moved by at most {:.3g} mm", move.face, move.largest_move_mm);
  if (move.surface)
    text +=
        fmt::format("; its mean curvature varied by {:.3g} per mm along a line, now {:.3g}",
                    move.surface->before.variation_per_mm, move.surface->after.variation_per_mm);
  return text;
}

}  // namespace

Judge judgeOf(int face, int order, const occ::SideMatchOptions& options) {
  return [face, order, options](const occ::Model& model, const occ::Progress& progress) {
    occ::AnalyzeOptions asked;
    asked.tolerance = options.tolerance;
    asked.level = static_cast<Level>(static_cast<int>(Level::G0) + std::max(order, 1));
    asked.match_mm = options.match_mm;
    if (face <= model.faceCount()) asked.faces = {face};
    return countsOf(occ::analyze(model, asked, progress), model);
  };
}

ordered_json seamsJson(const occ::SideMatchReport& match, const ContinuityTolerance& tolerance) {
  ordered_json seams = ordered_json::array();
  for (const occ::MatchedSeam& seam : match.seams) {
    const auto measured = [&](const occ::SeamResult& result) {
      return result.edges.empty() ? ordered_json(nullptr) : toJson(result, tolerance);
    };
    seams.push_back({{"side", seam.side},
                     {"target", name(seam.level)},
                     {"before", measured(seam.before)},
                     {"after", measured(seam.after)}});
  }
  return seams;
}

ordered_json movesJson(const std::vector<occ::FaceMove>& moves) {
  ordered_json json = ordered_json::array();
  for (const occ::FaceMove& move : moves) json.push_back(toJson(move));
  return json;
}

ordered_json toJson(const occ::SideMatchReport& match, int face,
                    const occ::SideMatchOptions& options, const occ::ModelFacts& given,
                    const std::optional<WrittenModel>& output) {
  ordered_json json = headJson("seamwright.match/1", given);
  json["gap_mm"] = options.tolerance.gap_mm;
  json["angle_deg"] = givenDegrees(options.tolerance.angle_rad);
  json["curvature_rel"] = options.tolerance.curvature_rel;
  json["fairness"] = options.fairness;
  json["face"] = face;
  json["matched"] = match.matched;
  json["reason"] = match.text();
  json["reason_code"] = match.code();
  json["remedy"] = match.remedy();
  json["depth_mm"] = match.depth_mm;
  json["output"] = toJson(output);
  json["seams"] = seamsJson(match, options.tolerance);
  json["moves"] = movesJson(match.moves);
  return json;
}

std::string toTable(const occ::SideMatchReport& match, const ContinuityTolerance& tolerance,
                    const ModelCounts& memory, const std::optional<WrittenModel>& output) {
  const std::vector<Column> columns = figureColumns(tolerance);
  std::vector<Row> rows = {{"side", "target", "level", "edge", "faces"}};
  for (const Column& column : columns) rows[0].emplace_back(column.title);
  for (const occ::MatchedSeam& seam : match.seams)
    if (!seam.before.edges.empty()) rows.push_back(rowOf(seam, columns));
  std::ostringstream out;
  constexpr std::size_t first_number = 5;
  writeRows(out, rows, first_number);
  for (const occ::FaceMove& move : match.moves) out << moveText(move) << '\n';
  if (const std::string text = match.text(); !text.empty()) out << text << '\n';
  if (output) out << output->path.string() << ": " << name(output->format) << '\n';
  const std::string differences = output ? output->differences(memory) : "";
  if (!differences.empty()) out << output->path.string() << ' ' << differences << '\n';
  const bool matched = match.matched && (!output || output->isAsGoodAs(memory));
  out << (matched ? "MATCHED: every seam has its target" : "NOT MATCHED") << '\n';
  if (!match.matched) out << "try: " << match.remedy() << '\n';
  return out.str();
}

}  // namespace seamwright::report
