// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/reason_json.hpp>
#include <seamwright/plugin/report/repair_json.hpp>
#include <set>
#include <utility>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

/// A number; null: any distance; "auto": by the sizes of faces.
ordered_json maxMoveJson(const std::optional<double>& max_move_mm) {
  if (!max_move_mm) return "auto";
  return std::isfinite(*max_move_mm) ? ordered_json(*max_move_mm) : ordered_json(nullptr);
}

ordered_json optionsJson(const occ::RepairOptions& options) {
  return {{"target", name(options.level())},
          {"max_move_mm", maxMoveJson(options.max_move_mm)},
          {"fairness", options.fairness},
          {"keep_curvature", options.keep_curvature},
          {"max_time_s", std::isfinite(options.max_time_s) ? ordered_json(options.max_time_s)
                                                           : ordered_json(nullptr)},
          {"edges", options.edges},
          {"fixed_faces", options.fixed_faces},
          {"match_mm", options.match_mm},
          {"sew", options.sew},
          {"convert_analytic", options.convert_analytic}};
}

/// Numbers in the repaired model by numbers in the given model, from 1; null if nothing was sewn,
/// so that both are the same.
ordered_json numbersJson(const occ::RepairReport& report) {
  if (!report.sewn()) return nullptr;
  ordered_json faces = report.faces_now, edges = report.edges_now;
  faces.erase(0);
  edges.erase(0);
  return {{"faces", std::move(faces)}, {"edges", std::move(edges)}};
}

template <class Item>
ordered_json arrayOf(const std::vector<Item>& items) {
  ordered_json array = ordered_json::array();
  for (const Item& item : items) array.push_back(toJson(item));
  return array;
}

std::set<FacePair> facesWithCommonEdge(const occ::Report& report) {
  std::set<FacePair> faces;
  for (const occ::SeamResult& seam : report.seams)
    if (seam.kind != occ::SeamKind::Matched) faces.insert(facesOf(seam));
  return faces;
}

/// Whether the seam is matched although its faces have a common edge.
bool isBeside(const occ::SeamResult& seam, const std::set<FacePair>& common) {
  return seam.kind == occ::SeamKind::Matched && common.count(facesOf(seam)) > 0;
}

bool hasMatchedBesideCommon(const occ::Report& report) {
  const std::set<FacePair> common = facesWithCommonEdge(report);
  return std::ranges::any_of(report.seams,
                             [&](const occ::SeamResult& seam) { return isBeside(seam, common); });
}

}  // namespace

Judge judgeOf(const occ::RepairReport& report, const occ::RepairOptions& options) {
  return [&report, &options](const occ::Model& model, const occ::Progress& progress) {
    occ::Report found = occ::analyze(model, occ::analyzeOptions(options), progress);
    if (!hasMatchedBesideCommon(report.after))
      std::erase_if(found.seams,
                    [common = facesWithCommonEdge(found)](const occ::SeamResult& seam) {
                      return isBeside(seam, common);
                    });
    return countsOf(found, model);
  };
}

bool isLowered(const occ::SeamRepair& seam) {
  return !seam.treated && !seam.sewn && seam.after.verdict.level < seam.before.verdict.level;
}

RepairSummary summarize(const occ::RepairReport& report) {
  RepairSummary summary;
  summary.seams = static_cast<int>(report.seams.size());
  summary.changed = report.changed();
  summary.passed = report.after.passed();
  for (const occ::SeamRepair& seam : report.seams) {
    summary.treated += seam.treated;
    summary.repaired += seam.repaired;
    summary.sewn += seam.sewn;
    summary.left += seam.treated && !seam.repaired;
    summary.wants_conversion += seam.wants_conversion;
    summary.lowered += isLowered(seam);
  }
  summary.defects_before = summarize(report.before).defects;
  summary.defects_after = summarize(report.after).defects;
  for (const occ::FaceMove& move : report.moves) {
    summary.largest_move_mm = std::max(summary.largest_move_mm, move.largest_move_mm);
    summary.worse_faces += !move.less_fair.empty();
  }
  return summary;
}

ordered_json toJson(const RepairSummary& summary) {
  return {{"seams", summary.seams},
          {"treated", summary.treated},
          {"repaired", summary.repaired},
          {"left", summary.left},
          {"wants_conversion", summary.wants_conversion},
          {"sewn", summary.sewn},
          {"lowered", summary.lowered},
          {"defects_before", summary.defects_before},
          {"defects_after", summary.defects_after},
          {"largest_move_mm", summary.largest_move_mm},
          {"worse_faces", summary.worse_faces},
          {"changed", summary.changed},
          {"passed", summary.passed}};
}

ordered_json toJson(const occ::SeamRepair& seam, const ContinuityTolerance& tolerance) {
  return {{"before", toJson(seam.before, tolerance)},
          {"after", toJson(seam.after, tolerance)},
          {"treated", seam.treated},
          {"repaired", seam.repaired},
          {"reason", seam.reason.text},
          {"reason_code", codeOf(seam.reason.fault)},
          {"reason_facts", factsJson(seam.reason)},
          {"wants_conversion", seam.wants_conversion},
          {"sewn", seam.sewn},
          {"not_sewn", seam.not_sewn.text},
          {"not_sewn_code", codeOf(seam.not_sewn.fault)},
          {"not_sewn_facts", factsJson(seam.not_sewn)}};
}

namespace {

ordered_json surfaceJson(const occ::FaceMove& move) {
  if (!move.surface) return nullptr;
  const SurfaceChange& change = *move.surface;
  const auto compared = [](const auto& before, const auto& after) {
    return ordered_json{{"before", before}, {"after", after}};
  };
  return {
      {"move_mm", {{"lower", change.move_mm.lower}, {"upper", change.move_mm.upper}}},
      {"normal_move_mm", change.normal_move_mm},
      {"tangential_move_mm", change.tangential_move_mm},
      {"turn_deg", change.turn_rad * degrees_per_radian},
      {"curvature_change_per_mm", change.curvature_change_per_mm},
      {"variation_per_mm", compared(change.before.variation_per_mm, change.after.variation_per_mm)},
      {"extrema", compared(change.before.extrema, change.after.extrema)},
      {"inflections", compared(change.before.inflections, change.after.inflections)},
      {"lines", change.after.lines},
      {"worse", !move.less_fair.empty()},
      {"reason", move.less_fair.text},
      {"reason_code", codeOf(move.less_fair.fault)}};
}

}  // namespace

ordered_json toJson(const occ::FaceMove& move) {
  return {{"face", move.face},
          {"largest_move_mm", move.largest_move_mm},
          {"surface", surfaceJson(move)}};
}

ordered_json toJson(const occ::EdgeMove& move) {
  return {{"edge", move.edge}, {"largest_move_mm", move.largest_move_mm}};
}

ordered_json toJson(const occ::FaceConversion& conversion) {
  return {{"face", conversion.face}, {"kind", conversion.kind}, {"error_mm", conversion.error_mm}};
}

ordered_json toJson(const occ::RepairReport& report, const occ::RepairOptions& options,
                    const std::optional<WrittenModel>& output) {
  ordered_json json = headJson("seamwright.repair/1", report.before);
  json["options"] = optionsJson(options);
  json["summary"] = toJson(summarize(report));
  if (output && output->found.defects > 0) json["summary"]["passed"] = false;
  json["time_s"] = {{"read", report.before.read_s}, {"repair", report.repair_s}};
  json["output"] = toJson(output);
  json["seams"] = ordered_json::array();
  for (const occ::SeamRepair& seam : report.seams)
    json["seams"].push_back(toJson(seam, report.before.tolerance));
  json["moves"] = arrayOf(report.moves);
  json["edge_moves"] = arrayOf(report.edge_moves);
  json["converted"] = arrayOf(report.converted);
  json["numbers_now"] = numbersJson(report);
  return json;
}

}  // namespace seamwright::report
