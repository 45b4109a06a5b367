// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/plugin/report/numbers.hpp>

namespace seamwright::report {

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
    summary.uncertified += !seam.figures.certified;
    if (seam.figures.gap_mm) summary.max_gap_mm = std::max(summary.max_gap_mm, seam.figures.gap_mm->lower);
    if (seam.figures.angle_rad)
      summary.max_angle_rad = std::max(summary.max_angle_rad, seam.figures.angle_rad->lower);
  }
  return summary;
}

}  // namespace seamwright::report
