// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>
#include <seamwright/plugin/report/csv.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <sstream>

namespace seamwright::report {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

std::string joined(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : " ") + std::to_string(number);
  return text;
}

void writeFigure(std::ostream& out, const std::optional<Figure>& figure, double factor = 1) {
  out << ',';
  if (figure) out << factor * figure->lower;
  out << ',';
  if (figure && figure->upper) out << factor * *figure->upper;
  out << ',';
  if (figure) out << figure->at;
}

void writeWorst(std::ostream& out, const std::optional<occ::WorstPoint>& worst) {
  if (!worst) {
    out << ",,,,,";
    return;
  }
  out << ',' << worst->quantity << ',' << worst->at;
  for (const double coordinate : worst->point) out << ',' << coordinate;
}

}  // namespace

std::string csvHeader() {
  std::string header = "model,seam,kind,edges,face_a,face_b,length_mm";
  for (const std::string figure : {"gap_mm", "angle_deg", "curvature_per_mm", "curvature_rel",
                                   "curvature_change_per_mm2", "curvature_change_rel"})
    header += ',' + figure + "_lower," + figure + "_upper," + figure + "_at";
  return header + ",level,class,certified,worst,worst_at,worst_x_mm,worst_y_mm,worst_z_mm,note\n";
}

std::string csvRows(const occ::Report& report) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  for (const occ::SeamResult& seam : report.seams) {
    const SeamFigures& figures = seam.figures;
    out << quoted(report.model.path) << ',' << seam.id << ',' << name(seam.kind) << ','
        << joined(seam.edges) << ',' << seam.faces[0] << ',' << seam.faces[1] << ','
        << seam.length_mm;
    writeFigure(out, figures.gap_mm);
    writeFigure(out, figures.angle_rad, degrees_per_radian);
    writeFigure(out, figures.curvature_per_mm);
    writeFigure(out, figures.curvature_rel);
    writeFigure(out, figures.curvature_change_per_mm2);
    writeFigure(out, figures.curvature_change_rel);
    out << ',' << name(seam.verdict.level) << ',' << name(seam.verdict.seam_class) << ','
        << (seam.verdict.certain ? "true" : "false");
    writeWorst(out, seam.worst);
    out << ',' << quoted(noteOf(seam, report.tolerance)) << '\n';
  }
  return out.str();
}

}  // namespace seamwright::report
