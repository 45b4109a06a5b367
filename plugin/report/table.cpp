// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cstdio>
#include <seamwright/plugin/report/enclosure.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <sstream>
#include <tuple>

namespace seamwright::report {

namespace {

/// The figures of a seam, with what is accepted of each in the unit shown.
struct Column {
  const char* title;
  std::optional<Figure> SeamFigures::*figure;
  double factor;
  double limit;
};

using Row = std::vector<std::string>;

std::vector<Column> figureColumns(const occ::Report& report) {
  const ContinuityTolerance& tolerance = report.tolerance;
  std::vector<Column> columns = {
      {"gap mm", &SeamFigures::gap_mm, 1, tolerance.gap_mm},
      {"angle deg", &SeamFigures::angle_rad, degrees_per_radian, degrees_per_radian * tolerance.angle_rad},
      {"curvature %", &SeamFigures::curvature_rel, 100, 100 * tolerance.curvature_rel}};
  const auto has_change = [](const occ::SeamResult& seam) {
    return seam.figures.curvature_change_rel.has_value();
  };
  if (std::ranges::any_of(report.seams, has_change))
    columns.push_back({"change %", &SeamFigures::curvature_change_rel, 100, 100 * tolerance.curvature_rel});
  return columns;
}

std::string number(double value, const char* format) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string edgesOf(const occ::SeamResult& seam) {
  std::string text;
  for (const int edge : seam.edges) text += (text.empty() ? "Edge" : ",Edge") + std::to_string(edge);
  return text;
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
             edgesOf(seam),
             std::to_string(seam.faces[0]) + '-' + std::to_string(seam.faces[1]),
             std::string(name(seam.kind)),
             number(seam.length_mm, "%.3f")};
  for (const Column& column : columns) {
    const std::optional<Figure>& figure = seam.figures.*column.figure;
    row.push_back(figure ? enclosureText(*figure, column.factor, column.limit) : "-");
  }
  row.push_back(noteOf(seam, tolerance));
  return row;
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

/// Columns two spaces apart; the numbers, which lie between kind and note, to the right.
void writeRows(std::ostream& out, const std::vector<Row>& rows) {
  constexpr std::size_t first_number = 5;
  const std::size_t note = rows.front().size() - 1;
  std::vector<std::size_t> width(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], shownWidth(row[c]));
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(width[c] - shownWidth(row[c]), ' ');
      const bool is_number = c >= first_number && c < note;
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
  out << "  " << counted(report.seams.size(), "seam");
  if (summary.matched > 0) out << ", " << summary.matched << " of them matched";
  out << ": " << counted(summary.defects, "defect") << ", " << summary.smooth << " smooth, "
      << counted(summary.creases, "crease") << (report.seams.empty() ? "" : ";");
  for (const auto& [level, count] : summary.by_level)
    if (count > 0) out << "  " << name(level) << ' ' << count;
  out << '\n';
  out << "  " << counted(report.open.size(), "open edge") << ", "
      << counted(report.non_manifold.size(), "non-manifold edge") << ";  read in "
      << number(report.read_s, "%.2f") << " s, analysed in " << number(report.analyze_s, "%.2f") << " s\n";
}

/// How many of the verdicts hold for every value within the enclosures.
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
  if (report.seams.empty()) return out.str();
  const std::vector<Column> columns = figureColumns(report);
  std::vector<Row> rows = {headings(columns)};
  for (const occ::SeamResult* seam : worstFirst(report))
    rows.push_back(rowOf(*seam, columns, report.tolerance));
  out << '\n';
  writeRows(out, rows);
  const Summary summary = summarize(report);
  out << '\n'
      << (report.passed() ? "PASSED: no defects" : "FAILED: " + counted(summary.defects, "defect"))
      << " at level " << name(report.level) << "; " << certainty(report, summary) << '\n';
  return out.str();
}

}  // namespace seamwright::report
