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

}  // namespace

std::string csvHeader() {
  return "model,seam,kind,edges,face_a,face_b,length_mm,"
         "gap_mm,gap_mm_upper,gap_at,angle_deg,angle_deg_upper,angle_at,"
         "curvature_per_mm,curvature_per_mm_upper,curvature_per_mm_at,"
         "curvature_rel,curvature_rel_upper,curvature_rel_at,level,class,certified,note\n";
}

std::string csvRows(const occ::Report& report) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  for (const occ::SeamResult& seam : report.seams) {
    out << quoted(report.model.path) << ',' << seam.id << ',' << name(seam.kind) << ',' << joined(seam.edges)
        << ',' << seam.faces[0] << ',' << seam.faces[1] << ',' << seam.length_mm;
    writeFigure(out, seam.figures.gap_mm);
    writeFigure(out, seam.figures.angle_rad, degrees_per_radian);
    writeFigure(out, seam.figures.curvature_per_mm);
    writeFigure(out, seam.figures.curvature_rel);
    out << ',' << name(seam.verdict.level) << ',' << name(seam.verdict.seam_class) << ','
        << (seam.figures.certified ? "true" : "false") << ',' << quoted(seam.note) << '\n';
  }
  return out.str();
}

}  // namespace seamwright::report
