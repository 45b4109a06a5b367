// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <ostream>
#include <seamwright/plugin/report/enclosure.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/text.hpp>

namespace seamwright::report {

namespace {

/// "mm" for "MM" and "millimetre", as files of STEP and IGES spell it; other names in lower case.
std::string shortUnit(std::string name) {
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static const std::map<std::string, std::string> symbols = {
      {"millimetre", "mm"}, {"centimetre", "cm"}, {"metre", "m"}, {"kilometre", "km"},
      {"micrometre", "um"}, {"inch", "in"},       {"foot", "ft"}, {"mile", "mi"}};
  const auto found = symbols.find(name);
  return found == symbols.end() ? name : found->second;
}

}  // namespace

std::vector<Column> figureColumns(const ContinuityTolerance& tolerance) {
  return {{"gap mm", &SeamFigures::gap_mm, 1, tolerance.gap_mm},
          {"angle deg", &SeamFigures::angle_rad, degrees_per_radian,
           degrees_per_radian * tolerance.angle_rad},
          {"curvature %", &SeamFigures::curvature_rel, 100, 100 * tolerance.curvature_rel}};
}

std::string cellOf(const occ::SeamResult& seam, const Column& column) {
  const std::optional<Figure>& figure = seam.figures.*column.figure;
  return figure ? enclosureText(*figure, column.factor, column.limit) : "-";
}

std::string edgesText(const occ::SeamResult& seam) {
  std::string text;
  for (const int edge : seam.edges)
    text += (text.empty() ? "Edge" : ",Edge") + std::to_string(edge);
  return text;
}

std::string facesText(const occ::SeamResult& seam) {
  return fmt::format("{}-{}", seam.faces[0], seam.faces[1]);
}

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void writeModel(std::ostream& out, const occ::Report& report) {
  const ContinuityTolerance& tolerance = report.tolerance;
  out << (report.model.path.empty() ? "model in memory" : report.model.path) << "  ("
      << report.model.format << ", unit " << shortUnit(report.model.length_unit) << ", "
      << counted(static_cast<std::size_t>(report.model.faces), "face") << ", "
      << counted(static_cast<std::size_t>(report.model.edges), "edge") << ")\n";
  for (const std::string& note : report.model.notes) out << "  note: " << note << '\n';
  out << "  target " << name(report.level) << ": gap <= " << tolerance.gap_mm
      << " mm, angle <= " << degrees_per_radian * tolerance.angle_rad
      << " deg, curvature <= " << 100 * tolerance.curvature_rel << " %, crease above "
      << degrees_per_radian * tolerance.crease_rad << " deg\n";
}

void writeRows(std::ostream& out, const std::vector<Row>& rows, std::size_t first_number) {
  const std::size_t last = rows.front().size() - 1;
  std::vector<std::size_t> width(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], shownWidth(row[c]));
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(width[c] - shownWidth(row[c]), ' ');
      const bool is_number = c >= first_number && c < last;
      line += (c == 0 ? "" : "  ") + (is_number ? padding + row[c] : row[c] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

}  // namespace seamwright::report
