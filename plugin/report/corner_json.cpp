// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/plugin/report/corner_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/reason_json.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <sstream>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

const char* kindName(occ::CornerSeamKind kind) {
  switch (kind) {
    case occ::CornerSeamKind::Spoke:
      return "spoke";
    case occ::CornerSeamKind::Section:
      return "section";
    case occ::CornerSeamKind::Spring:
      return "spring";
    case occ::CornerSeamKind::Contact:
      return "contact";
    case occ::CornerSeamKind::Fillets:
      return "fillets";
  }
  return "";
}

ordered_json edgeJson(const occ::CornerFilletEdge& edge) {
  return {{"edge", edge.edge},
          {"rounded", edge.rounded},
          {"convex", edge.convex},
          {"angle_deg", degrees_per_radian * edge.angle_rad},
          {"radius_mm", edge.radius_mm},
          {"contact_mm", edge.contact_mm},
          {"setback_mm", edge.setback_mm > 0 ? ordered_json(edge.setback_mm) : nullptr}};
}

/// Null if no bound is known.
ordered_json bound(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

std::string boundText(double value, const char* unit) {
  return std::isfinite(value) ? fmt::format("{:.3g} {}", value, unit) : "unknown";
}

/// "filled by patches", or "filled by OpenCASCADE, worst angle 0.01 degrees; no patches: " and why.
std::string filledText(const occ::CornerFillet& fillet) {
  if (fillet.filler == occ::CornerFiller::Patches) return "filled by patches";
  return fmt::format("filled by OpenCASCADE, worst angle {}; not by patches: {}",
                     boundText(degrees_per_radian * fillet.largestAngle_rad(), "degrees"),
                     fillet.patches_shortfall.text);
}

}  // namespace

const char* fillerName(occ::CornerFiller filler) {
  switch (filler) {
    case occ::CornerFiller::Patches:
      return "patches";
    case occ::CornerFiller::OpenCascade:
      return "opencascade";
  }
  return "";
}

Judge judgeOf(const occ::CornerFillet& fillet, const occ::CornerFilletOptions& options) {
  return [&fillet, &options](const occ::Model& model, const occ::Progress& progress) {
    occ::AnalyzeOptions asked;
    asked.tolerance = options.tolerance;
    asked.jobs = options.jobs;
    if (model.faceCount() == fillet.model.faceCount()) asked.faces = fillet.faces;
    return countsOf(occ::analyze(model, asked, progress), model);
  };
}

ordered_json toJson(const occ::CornerFillet& fillet, const ContinuityTolerance& tolerance,
                    int vertex, const occ::ModelFacts& given,
                    const std::optional<WrittenModel>& output) {
  ordered_json json = headJson("seamwright.corner/1", given);
  json["vertex"] = vertex;
  json["gap_mm"] = tolerance.gap_mm;
  json["angle_deg"] = givenDegrees(tolerance.angle_rad);
  json["met"] = fillet.met();
  json["shortfall"] = fillet.shortfall.text;
  json["shortfall_code"] = codeOf(fillet.shortfall.fault);
  json["shortfall_facts"] = factsJson(fillet.shortfall);
  json["filled_by"] = fillerName(fillet.filler);
  json["patches_shortfall"] = fillet.patches_shortfall.text;
  json["patches_shortfall_code"] = codeOf(fillet.patches_shortfall.fault);
  json["valid"] = fillet.valid;
  json["regular"] = fillet.filler == occ::CornerFiller::Patches ? ordered_json(fillet.fill.regular)
                                                                : ordered_json(nullptr);
  json["largest_gap_mm"] = bound(fillet.largestGap_mm());
  json["largest_angle_deg"] = bound(degrees_per_radian * fillet.largestAngle_rad());
  json["output"] = toJson(output);
  json["faces"] = fillet.faces;
  json["edges"] = ordered_json::array();
  for (const occ::CornerFilletEdge& edge : fillet.edges) json["edges"].push_back(edgeJson(edge));
  json["seams"] = ordered_json::array();
  for (const occ::CornerSeam& seam : fillet.seams) {
    json["seams"].push_back(toJson(seam.result, tolerance));
    json["seams"].back()["between"] = kindName(seam.kind);
  }
  return json;
}

std::string toTable(const occ::CornerFillet& fillet, const ModelCounts& memory,
                    const std::optional<WrittenModel>& output) {
  std::vector<Row> rows = {{"edge", "kind", "angle deg", "radius mm", "contact mm", "setback mm"}};
  for (const occ::CornerFilletEdge& edge : fillet.edges)
    rows.push_back({"Edge" + std::to_string(edge.edge),
                    !edge.rounded ? "smooth"
                    : edge.convex ? "convex"
                                  : "concave",
                    fmt::format("{:.4g}", degrees_per_radian * edge.angle_rad),
                    fmt::format("{:.4g}", edge.radius_mm), fmt::format("{:.4g}", edge.contact_mm),
                    edge.setback_mm > 0 ? fmt::format("{:.4g}", edge.setback_mm) : "-"});
  std::ostringstream out;
  constexpr std::size_t first_number = 2;  // index of the first column of numbers
  writeRows(out, rows, first_number);
  out << filledText(fillet) << '\n';
  out << counted(fillet.seams.size(), "new seam") << ": gap at most "
      << boundText(fillet.largestGap_mm(), "mm") << ", angle "
      << boundText(degrees_per_radian * fillet.largestAngle_rad(), "degrees") << '\n';
  const std::string differences = output ? output->differences(memory) : "";
  if (!differences.empty()) out << output->path.string() << ' ' << differences << '\n';
  const bool reached = fillet.met() && (!output || output->isAsGoodAs(memory));
  out << (reached ? "REACHED G1" : "NOT REACHED G1")
      << (fillet.met() ? "" : ": " + fillet.shortfall.text) << '\n';
  return out.str();
}

}  // namespace seamwright::report
