// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/repair_json.hpp>
#include <seamwright/plugin/report/repair_table.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <sstream>

namespace seamwright::report {

namespace {

std::string verdictOf(const occ::SeamRepair& seam) {
  const std::string result = seam.repaired          ? "repaired"
                             : seam.treated         ? "left"
                             : !seam.reason.empty() ? "not treated"
                                                    : "";
  if (!seam.sewn) return result;
  return result.empty() ? "sewn" : result + ", sewn";
}

/// A text that both reasons share is told once.
std::string reasonOf(const occ::SeamRepair& seam) {
  const std::string &reason = seam.reason.text, &not_sewn = seam.not_sewn.text;
  if (seam.not_sewn.empty()) return reason;
  if (seam.reason.empty()) return "not sewn: " + not_sewn;
  if (reason.find(not_sewn) != std::string::npos) return reason + "; therefore not sewn";
  return reason + "; not sewn: " + not_sewn;
}

/// Of a row: seams that are left, untreated ones, those that are sewn alone, repaired ones.
int placeOf(const occ::SeamRepair& seam) {
  if (seam.repaired) return 3;
  if (seam.treated) return 0;
  return reasonOf(seam).empty() ? 2 : 1;
}

/// The seams that were to be repaired: treated or sewn, or with a reason why not, by placeOf().
std::vector<const occ::SeamRepair*> shownSeams(const occ::RepairReport& report) {
  std::vector<const occ::SeamRepair*> shown;
  for (const occ::SeamRepair& seam : report.seams)
    if (seam.treated || seam.sewn || !reasonOf(seam).empty()) shown.push_back(&seam);
  std::ranges::stable_sort(shown, {}, [](const occ::SeamRepair* seam) { return placeOf(*seam); });
  return shown;
}

std::string change(const std::string& before, const std::string& after) {
  return before == after ? before : before + " -> " + after;
}

std::vector<Column> comparedColumns(const occ::Report& report) {
  std::vector<Column> columns = figureColumns(report.tolerance);
  if (report.level < Level::G2) columns.pop_back();
  return columns;
}

Row comparedHeadings(const std::vector<Column>& columns) {
  Row row = {"result", "edge", "faces", "level"};
  for (const Column& column : columns) row.emplace_back(column.title);
  row.emplace_back("reason");
  return row;
}

Row rowOf(const occ::SeamRepair& seam, const std::vector<Column>& columns) {
  Row row = {verdictOf(seam), change(edgesText(seam.before), edgesText(seam.after)),
             change(facesText(seam.before), facesText(seam.after)),
             change(std::string(name(seam.before.verdict.level)),
                    std::string(name(seam.after.verdict.level)))};
  for (const Column& column : columns)
    row.push_back(change(cellOf(seam.before, column), cellOf(seam.after, column)));
  row.push_back(reasonOf(seam));
  return row;
}

void writeHead(std::ostream& out, const occ::RepairReport& report, const RepairSummary& summary) {
  writeModel(out, report.before);
  out << "  " << counted(report.seams.size(), "seam") << ": " << summary.treated << " treated, "
      << summary.repaired << " repaired, " << summary.left << " left";
  if (summary.sewn > 0) out << ", " << summary.sewn << " sewn";
  out << ";  " << counted(summary.defects_before, "defect") << " before, " << summary.defects_after
      << " after\n  ";
  if (!report.moves.empty())
    out << counted(report.moves.size(), "face") << " moved, by at most "
        << fmt::format("{:.3g}", summary.largest_move_mm) << " mm";
  else
    out << (report.changed() ? "no face moved" : "nothing moved");
  if (summary.worse_faces > 0) out << ", " << summary.worse_faces << " less fair than before";
  if (!report.edge_moves.empty()) {
    const double furthest_mm =
        std::ranges::max_element(report.edge_moves, {}, &occ::EdgeMove::largest_move_mm)
            ->largest_move_mm;
    out << ", " << counted(report.edge_moves.size(), "edge")
        << " got new pcurves and moved by at most " << fmt::format("{:.3g}", furthest_mm) << " mm";
  }
  if (!report.converted.empty())
    out << ", " << counted(report.converted.size(), "face") << " converted to "
        << (report.converted.size() == 1 ? "a spline" : "splines");
  out << ";  read in " << fmt::format("{:.2f}", report.before.read_s) << " s, repaired in "
      << fmt::format("{:.2f}", report.repair_s) << " s\n";
}

}  // namespace

std::string toTable(const occ::RepairReport& report, const std::optional<WrittenModel>& output) {
  std::ostringstream out;
  const RepairSummary summary = summarize(report);
  writeHead(out, report, summary);
  const std::vector<const occ::SeamRepair*> shown = shownSeams(report);
  if (!shown.empty()) {
    const std::vector<Column> columns = comparedColumns(report.before);
    std::vector<Row> rows = {comparedHeadings(columns)};
    for (const occ::SeamRepair* seam : shown) rows.push_back(rowOf(*seam, columns));
    constexpr std::size_t first_figure = 4;  // index of the first column of numbers
    out << '\n';
    writeRows(out, rows, first_figure);
  }
  if (summary.lowered > 0) {
    std::string names;
    for (const occ::SeamRepair& seam : report.seams)
      if (isLowered(seam)) names += (names.empty() ? "" : ", ") + edgesText(seam.after);
    out << '\n'
        << counted(static_cast<std::size_t>(summary.lowered), "other seam")
        << " lost a level above the target, which --keep-curvature prevents: " << names << '\n';
  }
  if (summary.wants_conversion > 0)
    out << '\n'
        << counted(static_cast<std::size_t>(summary.wants_conversion), "seam")
        << " between faces that have no poles (planes, cylinders and the like): --convert lets "
           "such "
           "faces move as splines (in Python convert_analytic=True)\n";
  for (const occ::FaceMove& move : report.moves)
    if (!move.less_fair.empty())
      out << "\nface " << move.face << " is less fair: " << move.less_fair.text << '\n';
  out << '\n';
  const std::string differences =
      output ? output->differences(countsOf(report.after, report.model)) : "";
  if (!differences.empty()) out << output->path.string() << ' ' << differences << '\n';
  const int defects = std::max(summary.defects_after, output ? output->found.defects : 0);
  out << (defects == 0 ? "PASSED: no defects"
                       : "FAILED: " + counted(static_cast<std::size_t>(defects), "defect"))
      << " at level " << name(report.after.level) << '\n';
  return out.str();
}

}  // namespace seamwright::report
