// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/plugin/report/enclosure.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <sstream>

namespace seamwright::report {

namespace {

/// "angle is 0.09..0.12 deg, with 0.1 deg as its limit" where an enclosure holds the limit; else empty.
std::string doubt(const std::string& what, const std::optional<Figure>& figure, double factor, double limit,
                  const std::string& unit) {
  if (!figure || !figure->upper || figure->lower > limit || *figure->upper <= limit) return {};
  std::ostringstream text;
  text << what << " is " << rangeText(*figure, factor) << ' ' << unit << ", with " << factor * limit << ' '
       << unit << " as its limit";
  return text.str();
}

/// The first enclosure that leaves a verdict open; empty if there is none.
std::string firstDoubt(const SeamFigures& figures, const ContinuityTolerance& tolerance) {
  std::string text = doubt("gap", figures.gap_mm, 1, tolerance.gap_mm, "mm");
  for (const double limit : {tolerance.angle_rad, tolerance.crease_rad})
    if (text.empty()) text = doubt("angle", figures.angle_rad, degrees_per_radian, limit, "deg");
  if (text.empty()) text = doubt("curvature", figures.curvature_rel, 100, tolerance.curvature_rel, "%");
  if (text.empty())
    text = doubt("change of curvature", figures.curvature_change_rel, 100, tolerance.curvature_rel, "%");
  return text;
}

}  // namespace

std::string_view name(occ::SeamKind kind) {
  switch (kind) {
    case occ::SeamKind::Shared:
      return "shared";
    case occ::SeamKind::Closed:
      return "closed";
    case occ::SeamKind::Matched:
      return "matched";
  }
  return "";
}

Summary summarize(const occ::Report& report) {
  Summary summary;
  for (const Level level : {Level::None, Level::G0, Level::G1, Level::G2, Level::G3})
    summary.by_level[level] = 0;
  for (const occ::SeamResult& seam : report.seams) {
    ++summary.by_level[seam.verdict.level];
    summary.smooth += seam.verdict.seam_class == SeamClass::Smooth;
    summary.defects += seam.verdict.seam_class == SeamClass::Defect;
    summary.creases += seam.verdict.seam_class == SeamClass::Crease;
    summary.uncertified += !seam.verdict.certain;
    summary.matched += seam.kind == occ::SeamKind::Matched;
    if (seam.figures.gap_mm) summary.max_gap_mm = std::max(summary.max_gap_mm, seam.figures.gap_mm->lower);
    if (seam.figures.angle_rad)
      summary.max_angle_rad = std::max(summary.max_angle_rad, seam.figures.angle_rad->lower);
  }
  return summary;
}

std::string noteOf(const occ::SeamResult& seam, const ContinuityTolerance& tolerance) {
  // The change of curvature alone is sampled: its figure shows that, the same in every row.
  if (seam.verdict.certain && seam.figures.certified) return seam.note;
  std::string why = seam.figures.uncertified;
  if (why.empty() && !seam.verdict.certain) why = firstDoubt(seam.figures, tolerance);
  if (why.empty()) return seam.note;
  const std::string lead = seam.verdict.certain ? "no upper bound: " : "not certified: ";
  return (seam.note.empty() ? "" : seam.note + "; ") + lead + why;
}

}  // namespace seamwright::report
