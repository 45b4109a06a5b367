// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <seamwright/plugin/report/enclosure.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <string>

namespace seamwright::report {

namespace {

/// "angle is 0.09..0.12 deg, limit 0.1 deg" if an enclosure contains the limit; else empty.
std::string doubt(const std::string& what, const std::optional<Figure>& figure, double factor,
                  double limit, const std::string& unit) {
  if (!figure || !figure->upper || figure->lower > limit || *figure->upper <= limit) return {};
  return fmt::format("{0} is {1} {3}, limit {2:g} {3}", what, rangeText(*figure, factor),
                     factor * limit, unit);
}

/// "curvature is up to 37 % where it is left out, limit 2 %" if the bound there exceeds the limit
/// or is unknown; else empty.
std::string doubtLeftOut(const std::string& what, const std::optional<Figure>& figure,
                         const LeftOut& left_out, const ContinuityTolerance& tolerance,
                         double factor, double limit, const std::string& unit) {
  if (!figure || figure->lower > limit || left_out.isWithin(limit, tolerance)) return {};
  const std::string value =
      left_out.upper ? fmt::format("up to {:.3g} {}", factor * *left_out.upper, unit) : "unknown";
  return fmt::format("{} is {} where it is left out, limit {:.3g} {}", what, value, factor * limit,
                     unit);
}

/// The first enclosure that makes a verdict uncertain; empty if there is none.
std::string firstDoubt(const SeamFigures& figures, const ContinuityTolerance& tolerance) {
  std::string text = doubt("gap", figures.gap_mm, 1, tolerance.gap_mm, "mm");
  for (const double limit : {tolerance.angle_rad, tolerance.crease_rad})
    if (text.empty()) text = doubt("angle", figures.angle_rad, degrees_per_radian, limit, "deg");
  if (text.empty())
    text = doubtLeftOut("angle", figures.angle_rad, figures.angle_left_out, tolerance,
                        degrees_per_radian, tolerance.angle_rad, "deg");
  if (text.empty())
    text = doubt("curvature", figures.curvature_rel, 100, tolerance.curvature_rel, "%");
  if (text.empty())
    text = doubtLeftOut("curvature", figures.curvature_rel, figures.curvature_left_out, tolerance,
                        100, tolerance.curvature_rel, "%");
  if (text.empty())
    text = doubt("change of curvature", figures.curvature_change_rel, 100, tolerance.curvature_rel,
                 "%");
  if (text.empty())
    text = doubtLeftOut("change of curvature", figures.curvature_change_rel,
                        figures.curvatureChangeLeftOut(), tolerance, 100, tolerance.curvature_rel,
                        "%");
  return text;
}

/// "the first 9.54e-07", "the last 0.00049", "0.25 to 0.250001", "9.31e-10 at 0.25".
std::string intervalText(const Interval& interval) {
  if (interval.lower <= 0) return fmt::format("the first {:.3g}", interval.upper);
  if (interval.upper >= 1) return fmt::format("the last {:.3g}", 1 - interval.lower);
  const std::string from = fmt::format("{:.6g}", interval.lower),
                    to = fmt::format("{:.6g}", interval.upper);
  return from == to ? fmt::format("{:.3g} at {}", interval.width(), from) : from + " to " + to;
}

/// "the curvature leaves out the first 9.54e-07 of the seam"; empty if it leaves out nothing.
std::string leftOutText(const std::string& what, const LeftOut& left_out) {
  constexpr std::size_t most = 4;  // a choice: more would hide the rest of the note
  const std::size_t count = left_out.intervals.size();
  const std::size_t shown = count > most ? most - 1 : count;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
    text += (text.empty() ? "" : ", ") + intervalText(left_out.intervals[i]);
  if (shown < count) text += fmt::format(" and {} more intervals", count - shown);
  return text.empty() ? text : "the " + what + " leaves out " + text + " of the seam";
}

std::string joinedNotes(std::initializer_list<std::string> notes) {
  std::string text;
  for (const std::string& note : notes)
    if (!note.empty()) text += (text.empty() ? "" : "; ") + note;
  return text;
}

}  // namespace

double givenDegrees(double angle_rad) {
  return std::stod(fmt::format("{:.14g}", degrees_per_radian * angle_rad));
}

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
    if (seam.figures.gap_mm)
      summary.max_gap_mm = std::max(summary.max_gap_mm, seam.figures.gap_mm->lower);
    if (seam.figures.angle_rad)
      summary.max_angle_rad = std::max(summary.max_angle_rad, seam.figures.angle_rad->lower);
  }
  return summary;
}

std::string noteOf(const occ::SeamResult& seam, const ContinuityTolerance& tolerance) {
  const std::string note =
      joinedNotes({seam.note, leftOutText("angle", seam.figures.angle_left_out),
                   leftOutText("curvature", seam.figures.curvature_left_out)});
  if (seam.verdict.certain && seam.figures.certified) return note;
  std::string why = seam.figures.uncertified;
  if (why.empty() && !seam.verdict.certain) why = firstDoubt(seam.figures, tolerance);
  if (why.empty()) return note;
  const std::string lead = seam.verdict.certain ? "no upper bound: " : "not certified: ";
  return joinedNotes({note, lead + why});
}

}  // namespace seamwright::report
