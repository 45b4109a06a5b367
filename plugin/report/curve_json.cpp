// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <seamwright/plugin/report/curve_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/text.hpp>

namespace seamwright::report {

namespace {

using nlohmann::ordered_json;

ordered_json orNull(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json vectorJson(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

ordered_json figuresJson(const CurveFigures& figures) {
  return {{"length_mm", figures.length_mm},
          {"energy_per_mm", orNull(figures.energy_per_mm)},
          {"variation_per_mm3", orNull(figures.variation_per_mm3)},
          {"extrema", figures.extrema},
          {"inflections", figures.inflections}};
}

ordered_json recordJson(const CurveRecord& record) {
  return {{"edges", record.edges},
          {"points", record.points},
          {"closed", record.closed},
          {"plane",
           {{"origin", vectorJson(record.plane.origin)},
            {"x", vectorJson(record.plane.x)},
            {"y", vectorJson(record.plane.y)}}},
          {"off_plane_mm", record.off_plane_mm},
          {"pieces", record.pieces},
          {"lines", record.lines},
          {"corners", record.corners},
          {"distance_mm", orNull(record.distance_mm)},
          {"moved_mm", orNull(record.moved_mm)},
          {"before", figuresJson(record.before)},
          {"after", figuresJson(record.after)},
          {"notes", record.notes},
          {"reached", record.reached}};
}

std::string nameOf(const CurveRecord& record) {
  if (record.points > 0) return counted(static_cast<std::size_t>(record.points), "point");
  return namesOf(record.edges);
}

std::string piecesText(const std::string& method, const CurveRecord& record) {
  const auto pieces = static_cast<std::size_t>(record.pieces);
  if (method == "clothoid") return counted(pieces, "clothoid");
  if (method == "conic") return counted(pieces, "conic");
  if (method == "fair")
    return record.points > 0 ? counted(pieces, "point") : counted(pieces, "span");
  const auto lines = static_cast<std::size_t>(record.lines);
  return counted(pieces - lines, "arc") + " and " + counted(lines, "line");
}

std::string changeText(const char* what, int before, int after) {
  return fmt::format(", {} {} -> {}", what, before, after);
}

std::string energyText(const CurveRecord& record) {
  if (record.before.variation_per_mm3 && record.after.variation_per_mm3)
    return fmt::format(", variation {:.4g} -> {:.4g} /mm3", *record.before.variation_per_mm3,
                       *record.after.variation_per_mm3);
  if (record.before.energy_per_mm && record.after.energy_per_mm)
    return fmt::format(", energy {:.4g} -> {:.4g} /mm", *record.before.energy_per_mm,
                       *record.after.energy_per_mm);
  return "";
}

std::string line(const std::string& method, const CurveRecord& record) {
  std::string text = nameOf(record) + (record.closed ? ", closed: " : ": ");
  text += piecesText(method, record);
  if (record.corners > 0)
    text += ", " + counted(static_cast<std::size_t>(record.corners), "corner");
  text += fmt::format(", {:.6g} mm long", record.after.length_mm);
  const char* what = record.points > 0 && method != "arcs" ? "points within" : "distance at most";
  if (record.distance_mm) text += fmt::format(", {} {:.3g} mm", what, *record.distance_mm);
  if (record.moved_mm) text += fmt::format(", moved by at most {:.3g} mm", *record.moved_mm);
  text += energyText(record);
  text += changeText("extrema", record.before.extrema, record.after.extrema);
  text += changeText("inflections", record.before.inflections, record.after.inflections) + '\n';
  for (const std::string& note : record.notes) text += "  " + note + '\n';
  return text;
}

}  // namespace

std::string namesOf(const std::vector<int>& edges) {
  constexpr std::size_t shown = 4;
  std::string names;
  for (std::size_t i = 0; i < std::min(shown, edges.size()); ++i)
    names += fmt::format("{}Edge{}", i > 0 ? "," : "", edges[i]);
  if (edges.size() > shown) names += fmt::format(" and {} more", edges.size() - shown);
  return names;
}

ordered_json outputJson(const std::optional<CurveOutput>& output) {
  if (!output) return nullptr;
  return {{"path", output->path}, {"format", output->format}, {"distance_mm", output->distance_mm}};
}

bool CurveReport::reached() const {
  return refused.empty() && std::ranges::all_of(curves, &CurveRecord::reached);
}

bool CurveReport::withReservations() const {
  return std::ranges::any_of(curves, &CurveRecord::with_reservations);
}

ordered_json toJson(const CurveReport& report) {
  ordered_json json = headJson("seamwright.curve/1", report.input);
  json["method"] = report.method;
  json["tolerance_mm"] = report.tolerance_mm;
  json["reached"] = report.reached();
  json["output"] = outputJson(report.output);
  json["curves"] = ordered_json::array();
  for (const CurveRecord& record : report.curves) json["curves"].push_back(recordJson(record));
  json["refused"] = ordered_json::array();
  for (const RefusedCurve& curve : report.refused)
    json["refused"].push_back({{"edges", curve.edges}, {"reason", curve.reason}});
  return json;
}

std::string toText(const CurveReport& report) {
  std::string text;
  for (const CurveRecord& record : report.curves) text += line(report.method, record);
  for (const RefusedCurve& curve : report.refused)
    text += namesOf(curve.edges) + ": not done: " + curve.reason + '\n';
  if (report.output)
    text += report.output->path + ": " + report.output->format +
            (report.output->distance_mm > 0
                 ? fmt::format(", within {:.3g} mm of the result", report.output->distance_mm)
                 : std::string()) +
            '\n';
  text += !report.reached()           ? "NOT REACHED\n"
          : report.withReservations() ? "REACHED WITH RESERVATIONS\n"
                                      : "REACHED\n";
  return text;
}

}  // namespace seamwright::report
