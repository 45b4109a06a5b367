// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <seamwright/core/angle.hpp>
#include <seamwright/plugin/report/blend_json.hpp>
#include <seamwright/plugin/report/enclosure.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/text.hpp>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

ordered_json keyCurveJson(const KeyCurveRecord& record) {
  return {{"input", record.input},
          {"edges", record.edges},
          {"points", record.points},
          {"omega", record.omega},
          {"segments", record.segments},
          {"gap_mm", record.gap_mm},
          {"polynomial_mm", record.polynomial_mm},
          {"refitted_mm", record.refitted_mm}};
}

ordered_json pairJson(const MatchedPairRecord& record) {
  ordered_json places = ordered_json::array();
  for (const MatchedPlaceRecord& place : record.places) {
    ordered_json json = {{"point", nullptr}, {"length_share", place.length_share}};
    if (place.point) json["point"] = *place.point;
    json["point_mm"] = {place.point_mm.x(), place.point_mm.y(), place.point_mm.z()};
    places.push_back(json);
  }
  return {{"kind", record.kind}, {"places", places}};
}

ordered_json jointJson(const BlendJointRecord& record) {
  return {{"joint", record.joint},     {"order", record.order},   {"beta", record.beta},
          {"defects", record.defects}, {"remedy", record.remedy}, {"moved_mm", record.moved_mm}};
}

ordered_json frameJson(const BlendFrameRecord& record) {
  ordered_json joints = ordered_json::array();
  for (const BlendJointRecord& joint : record.joints) joints.push_back(jointJson(joint));
  return {{"omega", record.omega}, {"length_mm", record.length_mm}, {"joints", joints}};
}

ordered_json lineJson(const LoftLineRecord& record) {
  return {{"joint", record.joint},
          {"order", record.order},
          {"gap_mm", figureJson(record.figures.gap_mm)},
          {"angle_deg", figureJson(record.figures.angle_rad, degrees_per_radian)},
          {"curvature_per_mm", figureJson(record.figures.curvature_per_mm)},
          {"curvature_rel", figureJson(record.figures.curvature_rel)},
          {"certified", record.figures.certified}};
}

ordered_json loftJson(const std::optional<BlendLoftRecord>& loft) {
  if (!loft) return nullptr;
  ordered_json lines = ordered_json::array();
  for (const LoftLineRecord& line : loft->lines) lines.push_back(lineJson(line));
  return {{"degree_u", loft->degree_u},
          {"degree_v", loft->degree_v},
          {"poles_u", loft->poles_u},
          {"poles_v", loft->poles_v},
          {"distance_mm", loft->distance_mm},
          {"reached", loft->reached},
          {"faces", loft->faces},
          {"lines", lines}};
}

/// What the joints of all frames between the key curves have in common.
struct JointSummary {
  std::size_t count = 0, short_of_order = 0;
  std::map<std::string, std::size_t> remedies;
  double defect = 0, moved_mm = 0;
};

JointSummary summaryOf(const BlendReport& report) {
  JointSummary summary;
  for (const BlendFrameRecord& frame : report.frames)
    for (const BlendJointRecord& joint : frame.joints) {
      ++summary.count;
      if (joint.order < report.order) ++summary.short_of_order;
      ++summary.remedies[joint.remedy];
      summary.moved_mm = std::max(summary.moved_mm, joint.moved_mm);
      for (const double defect : joint.defects) summary.defect = std::max(summary.defect, defect);
    }
  return summary;
}

std::string jointsText(const BlendReport& report) {
  const JointSummary summary = summaryOf(report);
  if (summary.count == 0) return "no joints\n";
  const std::size_t full = summary.count - summary.short_of_order;
  std::string text = full > 0 ? fmt::format("{} G{}", counted(full, "joint"), report.order) : "";
  if (summary.short_of_order > 0)
    text += fmt::format("{}{} of a lower order than G{}", full > 0 ? ", " : "",
                        counted(summary.short_of_order, "joint"), report.order);
  text += fmt::format(": defect at most {:.2g}", summary.defect);
  text += " (";
  bool first = true;
  for (const auto& [remedy, count] : summary.remedies) {
    text += fmt::format("{}{} {}", first ? "" : ", ", remedy, count);
    first = false;
  }
  return text + fmt::format("), poles up to {:.3g} mm from linear blending\n", summary.moved_mm);
}

double largest(const std::vector<LoftLineRecord>& lines,
               std::optional<Figure> SeamFigures::*figure) {
  double result = 0;
  for (const LoftLineRecord& line : lines)
    if (const std::optional<Figure>& found = line.figures.*figure)
      result = std::max(result, found->upper.value_or(HUGE_VAL));
  return result;
}

/// The lines at which the key curves have at least this order. Elsewhere the loft has an angle, or
/// a difference of the curvature, because the key curves do.
std::vector<LoftLineRecord> judgedLines(const std::vector<LoftLineRecord>& lines, int order) {
  std::vector<LoftLineRecord> result;
  std::ranges::copy_if(lines, std::back_inserter(result),
                       [&](const LoftLineRecord& line) { return line.order >= order; });
  return result;
}

/// How many lines a figure leaves out, and why.
std::string leftOut(std::size_t count, int order) {
  if (count == 0) return "";
  return fmt::format(" ({} left out, below G{} in the key curves)", count, order);
}

std::string linesText(const std::vector<LoftLineRecord>& lines, int order_asked_for) {
  std::string text = fmt::format("; across {} of joints: ", counted(lines.size(), "line"));
  const std::vector<LoftLineRecord> tangent = judgedLines(lines, 1), curved = judgedLines(lines, 2);
  const std::size_t corners = lines.size() - tangent.size(),
                    uncurved = lines.size() - curved.size();
  if (tangent.empty()) return text + fmt::format("no angle judged{}", leftOut(corners, 1));
  text += fmt::format("angle at most {:.2g} deg{}",
                      degrees_per_radian * largest(tangent, &SeamFigures::angle_rad),
                      leftOut(corners, 1));
  if (order_asked_for < 2) return text;
  if (curved.empty()) return text + fmt::format(", no curvature judged{}", leftOut(uncurved, 2));
  // Where a line is flat, a difference by the curvature says nothing: it is stated per mm.
  return text + fmt::format(", curvature difference at most {:.2g} /mm{}",
                            largest(curved, &SeamFigures::curvature_per_mm), leftOut(uncurved, 2));
}

std::string loftText(const BlendLoftRecord& loft, int order) {
  std::string text =
      fmt::format("loft: degree {} x {}, {} x {} poles, {:.3g} mm from the frames", loft.degree_u,
                  loft.degree_v, loft.poles_u, loft.poles_v, loft.distance_mm);
  if (loft.faces > 1) text += fmt::format(", {} faces between corners", loft.faces);
  if (!loft.lines.empty()) text += linesText(loft.lines, order);
  return text + '\n';
}

/// A place as --pair takes it, and where it is.
std::string placeText(const MatchedPlaceRecord& place) {
  const std::string name = place.point ? fmt::format("point {}", *place.point)
                                       : fmt::format("{:.4g}%", 100 * place.length_share);
  // A billionth of a mm is rounding, and +0 leaves no sign.
  const Eigen::Array3d at = (1e9 * place.point_mm.array()).round() / 1e9 + 0.0;
  return fmt::format("{} ({:.5g}, {:.5g}, {:.5g})", name, at.x(), at.y(), at.z());
}

std::string pairsText(const std::vector<MatchedPairRecord>& pairs) {
  constexpr std::size_t most_lines =
      12;  // of outlines that are drawn; sections of a mesh have more
  std::string text;
  for (std::size_t i = 0; i < std::min(pairs.size(), most_lines); ++i) {
    std::vector<std::string> places;
    for (const MatchedPlaceRecord& place : pairs[i].places) places.push_back(placeText(place));
    text += fmt::format("  {}: {}\n", pairs[i].kind, fmt::join(places, " = "));
  }
  if (pairs.size() > most_lines)
    text += fmt::format("  and {} more pairs, which --json names\n", pairs.size() - most_lines);
  return text;
}

}  // namespace

ordered_json toJson(const BlendReport& report) {
  ordered_json json = headJson("seamwright.blend/1", report.inputs.front());
  json.erase("model");
  json["models"] = ordered_json::array();
  for (const occ::ModelFacts& model : report.inputs) json["models"].push_back(modelJson(model));
  json["order"] = report.order;
  json["tolerance_mm"] = report.tolerance_mm;
  json["match"] = report.match;
  json["in_between"] = report.in_between;
  json["closed"] = report.closed;
  json["reached"] = report.reached;
  json["output"] = outputJson(report.output);
  json["key_curves"] = ordered_json::array();
  for (const KeyCurveRecord& record : report.key_curves)
    json["key_curves"].push_back(keyCurveJson(record));
  json["pairs"] = ordered_json::array();
  for (const MatchedPairRecord& record : report.pairs) json["pairs"].push_back(pairJson(record));
  json["frames"] = ordered_json::array();
  for (const BlendFrameRecord& record : report.frames) json["frames"].push_back(frameJson(record));
  json["loft"] = loftJson(report.loft);
  json["notes"] = report.notes;
  return json;
}

std::string toText(const BlendReport& report) {
  std::string text =
      fmt::format("{}{}: {} with {} each\n", counted(report.key_curves.size(), "key curve"),
                  report.closed ? ", closed" : "", counted(report.frames.size(), "frame"),
                  counted(report.frames.front().joints.size(), "joint"));
  text += jointsText(report);
  if (report.loft) text += loftText(*report.loft, report.order);
  for (const std::string& note : report.notes) text += "  " + note + '\n';
  text += pairsText(report.pairs);
  if (report.output) text += report.output->path + ": " + report.output->format + '\n';
  return text + (report.reached ? "REACHED\n" : "NOT REACHED\n");
}

}  // namespace seamwright::report
