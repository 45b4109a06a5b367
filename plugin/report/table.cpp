// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cstdio>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <sstream>
#include <tuple>

namespace seamwright::report {

namespace {

constexpr std::size_t column_count = 10;
using Row = std::array<std::string, column_count>;

std::string number(double value, const char* format) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// Three significant digits; plain notation where people read it easily.
std::string brief(double value) {
  const double size = value < 0 ? -value : value;
  return number(value, size == 0 || (size >= 1e-3 && size < 1e5) ? "%.3g" : "%.1e");
}

std::string brief(const std::optional<Figure>& figure, double factor = 1) {
  return figure ? brief(factor * figure->lower) : "-";
}

Row rowOf(const occ::SeamResult& seam) {
  const std::string faces = std::to_string(seam.faces[0]) + '-' + std::to_string(seam.faces[1]);
  return {std::string(name(seam.verdict.seam_class)),
          std::string(name(seam.verdict.level)),
          "Edge" + std::to_string(seam.edges.front()),
          faces,
          std::string(name(seam.kind)),
          number(seam.length_mm, "%.3f"),
          brief(seam.figures.gap_mm),
          brief(seam.figures.angle_rad, degrees_per_radian),
          brief(seam.figures.curvature_rel),
          seam.note};
}

/// Defects, then smooth seams, then creases; in each the largest angle first, then the largest gap.
std::vector<const occ::SeamResult*> worstFirst(const occ::Report& report) {
  std::vector<const occ::SeamResult*> order;
  for (const occ::SeamResult& seam : report.seams) order.push_back(&seam);
  const auto key = [](const occ::SeamResult* seam) {
    constexpr std::array<int, 3> place = {1, 0, 2};  // smooth, defect, crease
    const auto value = [](const std::optional<Figure>& figure) { return figure ? figure->lower : 1e300; };
    return std::tuple(place[static_cast<std::size_t>(seam->verdict.seam_class)],
                      -value(seam->figures.angle_rad), -value(seam->figures.gap_mm), seam->id);
  };
  std::ranges::sort(order, {}, key);
  return order;
}

void writeRows(std::ostream& out, const std::vector<Row>& rows) {
  std::array<std::size_t, column_count> width{};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < column_count; ++c) width[c] = std::max(width[c], row[c].size());
  constexpr std::size_t first_number = 5;
  constexpr std::size_t last_number = 8;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < column_count; ++c) {
      const std::string padding(width[c] - row[c].size(), ' ');
      const bool is_number = c >= first_number && c <= last_number;
      line += (c == 0 ? "" : "  ") + (is_number ? padding + row[c] : row[c] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

void writeHead(std::ostream& out, const occ::Report& report) {
  const Summary summary = summarize(report);
  const ContinuityTolerance& tolerance = report.tolerance;
  out << (report.model.path.empty() ? "model in memory" : report.model.path) << "  (" << report.model.format
      << ", unit " << report.model.length_unit << ", " << report.model.faces << " faces, "
      << report.model.edges << " edges)\n";
  for (const std::string& note : report.model.notes) out << "  note: " << note << '\n';
  out << "  asked for " << name(report.level) << ": gap <= " << tolerance.gap_mm
      << " mm, angle <= " << degrees_per_radian * tolerance.angle_rad
      << " deg, curvature <= " << 100 * tolerance.curvature_rel << " %, crease above "
      << degrees_per_radian * tolerance.crease_rad << " deg\n";
  out << "  " << counted(report.seams.size(), "seam") << ": " << counted(summary.defects, "defect") << ", "
      << summary.smooth << " smooth, " << counted(summary.creases, "crease") << ";  ";
  for (const auto& [level, count] : summary.by_level)
    if (count > 0) out << name(level) << ' ' << count << "  ";
  out << '\n';
  out << "  " << counted(report.open.size(), "open edge") << ", "
      << counted(report.non_manifold.size(), "non-manifold edge") << ";  read in "
      << number(report.read_s, "%.2f") << " s, analysed in " << number(report.analyze_s, "%.2f") << " s\n";
}

}  // namespace

std::string toTable(const occ::Report& report) {
  std::ostringstream out;
  writeHead(out, report);
  if (report.seams.empty()) return out.str();
  std::vector<Row> rows = {{"class", "level", "edge", "faces", "kind", "length mm", "gap mm", "angle deg",
                            "curvature rel", "note"}};
  for (const occ::SeamResult* seam : worstFirst(report)) rows.push_back(rowOf(*seam));
  out << '\n';
  writeRows(out, rows);
  const Summary summary = summarize(report);
  if (report.passed())
    out << "\nPASSED: no defects at level " << name(report.level);
  else
    out << "\nFAILED: " << counted(summary.defects, "defect") << " at level " << name(report.level);
  out << " (sampled, not certified)\n";
  return out.str();
}

}  // namespace seamwright::report
