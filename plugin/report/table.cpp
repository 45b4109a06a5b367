// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <sstream>
#include <tuple>

namespace seamwright::report {

namespace {

std::vector<Column> columnsOf(const occ::Report& report) {
  std::vector<Column> columns = figureColumns(report.tolerance);
  const auto has_change = [](const occ::SeamResult& seam) {
    return seam.figures.curvature_change_rel.has_value();
  };
  if (std::ranges::any_of(report.seams, has_change))
    columns.push_back({"change %", &SeamFigures::curvature_change_rel, 100,
                       100 * report.tolerance.curvature_rel});
  return columns;
}

Row headings(const std::vector<Column>& columns) {
  Row row = {"class", "level", "edge", "faces", "kind", "length mm"};
  for (const Column& column : columns) row.emplace_back(column.title);
  row.emplace_back("note");
  return row;
}

Row rowOf(const occ::SeamResult& seam, const std::vector<Column>& columns,
          const ContinuityTolerance& tolerance) {
  Row row = {std::string(name(seam.verdict.seam_class)) + (seam.verdict.certain ? "" : "?"),
             std::string(name(seam.verdict.level)),
             edgesText(seam),
             facesText(seam),
             std::string(name(seam.kind)),
             fmt::format("{:.3f}", seam.length_mm)};
  for (const Column& column : columns) row.push_back(cellOf(seam, column));
  row.push_back(noteOf(seam, tolerance));
  return row;
}

/// Defects, then smooth seams, then creases; in each class by angle, then by gap, the largest
/// first. Seams without a figure come before those with one.
std::vector<const occ::SeamResult*> worstFirst(const occ::Report& report) {
  std::vector<const occ::SeamResult*> order;
  for (const occ::SeamResult& seam : report.seams) order.push_back(&seam);
  const auto key = [](const occ::SeamResult* seam) {
    constexpr std::array<int, 3> rank = {1, 0, 2};  // smooth, defect, crease
    const auto value = [](const std::optional<Figure>& figure) {
      return figure ? figure->lower : 1e300;
    };
    return std::tuple(rank[static_cast<std::size_t>(seam->verdict.seam_class)],
                      -value(seam->figures.angle_rad), -value(seam->figures.gap_mm), seam->id);
  };
  std::ranges::sort(order, {}, key);
  return order;
}

void writeHead(std::ostream& out, const occ::Report& report) {
  const Summary summary = summarize(report);
  writeModel(out, report);
  out << "  " << counted(report.seams.size(), "seam");
  if (summary.matched > 0) out << ", " << summary.matched << " of them matched";
  out << ": " << counted(summary.defects, "defect") << ", " << summary.smooth << " smooth, "
      << counted(summary.creases, "crease") << (report.seams.empty() ? "" : ";");
  for (const auto& [level, count] : summary.by_level)
    if (count > 0) out << "  " << name(level) << ' ' << count;
  out << '\n';
  out << "  " << counted(report.open.size(), "free edge") << ", "
      << counted(report.non_manifold.size(), "non-manifold edge")
      << fmt::format(";  read in {:.2f} s, analysed in {:.2f} s\n", report.read_s,
                     report.analyze_s);
}

/// The number of verdicts that hold for every value within the enclosures.
std::string certainty(const occ::Report& report, const Summary& summary) {
  const std::size_t certain = report.seams.size() - static_cast<std::size_t>(summary.uncertified);
  const std::string share =
      std::to_string(certain) + " of " + counted(report.seams.size(), "verdict") + " certain";
  return summary.uncertified > 0 ? share + ", the others are marked ?" : share;
}

}  // namespace

std::string toTable(const occ::Report& report) {
  std::ostringstream out;
  writeHead(out, report);
  if (report.seams.empty()) {
    out << "\nNO VERDICT: the model has no seam\n";
    return out.str();
  }
  const std::vector<Column> columns = columnsOf(report);
  std::vector<Row> rows = {headings(columns)};
  for (const occ::SeamResult* seam : worstFirst(report))
    rows.push_back(rowOf(*seam, columns, report.tolerance));
  out << '\n';
  constexpr std::size_t length = 5;  // index of the first column of numbers
  writeRows(out, rows, length);
  const Summary summary = summarize(report);
  out << '\n'
      << (report.passed() ? "PASSED: no defects" : "FAILED: " + counted(summary.defects, "defect"))
      << " at level " << name(report.level) << "; " << certainty(report, summary) << '\n';
  return out.str();
}

}  // namespace seamwright::report
