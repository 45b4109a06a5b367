// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/seam/judge.hpp>

namespace seamwright {

namespace {

constexpr double degrees(double rad) {
  return rad * degrees_per_radian;
}

[[noreturn]] void refuse(std::string_view field, double value, std::string_view unit,
                         std::string_view why) {
  throw std::invalid_argument(fmt::format("{} is {:.6g}{}: {}", field, value, unit, why));
}

void requireNotNegative(std::string_view field, double value, std::string_view unit) {
  if (!std::isfinite(value) || value < 0)
    refuse(field, value, unit, "it must be a finite number, zero or larger");
}

/// Whether figures are taken at the lower or at the upper ends of their enclosures.
enum class End { Lower, Upper };

double valueAt(const Figure& figure, End end) {
  return end == End::Lower ? figure.lower
                           : figure.upper.value_or(std::numeric_limits<double>::infinity());
}

bool isWithin(const std::optional<Figure>& figure, double limit, End end) {
  return figure && valueAt(*figure, end) <= limit;
}

Level reachedLevel(const SeamFigures& figures, const ContinuityTolerance& tolerance, End end) {
  if (!isWithin(figures.gap_mm, tolerance.gap_mm, end)) return Level::None;
  if (!isWithin(figures.angle_rad, tolerance.angle_rad, end) || figures.fold_at) return Level::G0;
  const bool counts_left_out = end == End::Upper;  // the lower end of what is left out is 0
  if (counts_left_out && !figures.angle_left_out.isWithin(tolerance.angle_rad, tolerance))
    return Level::G0;
  if (figures.plane_share < 0.95) return Level::G0;
  if (!isWithin(figures.curvature_rel, tolerance.curvature_rel, end)) return Level::G1;
  if (counts_left_out && !figures.curvature_left_out.isWithin(tolerance.curvature_rel, tolerance))
    return Level::G1;
  if (!isWithin(figures.curvature_change_rel, tolerance.curvature_rel, end)) return Level::G2;
  const LeftOut left_out = figures.curvatureChangeLeftOut();
  const bool is_known = !counts_left_out || left_out.isWithin(tolerance.curvature_rel, tolerance);
  return is_known ? Level::G3 : Level::G2;
}

bool isCrease(const SeamFigures& figures, const ContinuityTolerance& tolerance, End end) {
  const bool sharp = figures.fold_at ||
                     (figures.angle_rad && valueAt(*figures.angle_rad, end) > tolerance.crease_rad);
  return sharp && figures.below_crease_share <= 0.5;
}

Verdict verdictAt(const SeamFigures& figures, const ContinuityTolerance& tolerance, Level required,
                  End end) {
  Verdict verdict;
  verdict.level = reachedLevel(figures, tolerance, end);
  if (verdict.level >= Level::G0 && isCrease(figures, tolerance, end))
    verdict.seam_class = SeamClass::Crease;
  else
    verdict.seam_class = verdict.level >= required ? SeamClass::Smooth : SeamClass::Defect;
  return verdict;
}

/// A remark on a sharp spot, which the class does not show: a seam that is below the crease angle
/// over more than half of its length is not a crease.
std::string sharpSpotRemark(const SeamFigures& figures, const ContinuityTolerance& tolerance) {
  if (!figures.angle_rad || figures.angle_rad->lower <= tolerance.crease_rad ||
      figures.below_crease_share <= 0.5)
    return {};
  return fmt::format(
      "sharp spot in a seam that is below the crease angle over {:.0f} % of its length",
      std::floor(100 * figures.below_crease_share));
}

}  // namespace

void ContinuityTolerance::validate() const {
  requireNotNegative("gap tolerance", gap_mm, " mm");
  requireNotNegative("angle tolerance", degrees(angle_rad), " deg");
  requireNotNegative("curvature tolerance", curvature_rel, "");
  requireNotNegative("flat radius", flat_radius_mm, " mm");
  requireNotNegative("crease angle", degrees(crease_rad), " deg");
  if (flat_radius_mm == 0)
    refuse("flat radius", flat_radius_mm, " mm", "it must be larger than zero");
  if (crease_rad > std::numbers::pi / 2)
    refuse("crease angle", degrees(crease_rad), " deg", "tangent planes meet at 90 deg at most");
  if (crease_rad < angle_rad)
    refuse("crease angle", degrees(crease_rad), " deg",
           fmt::format("it must not be smaller than the angle tolerance, {:.6g} deg",
                       degrees(angle_rad)));
}

std::string_view name(Level level) {
  static constexpr std::array<std::string_view, 5> names = {"none", "G0", "G1", "G2", "G3"};
  return names[static_cast<std::size_t>(level)];
}

std::string_view name(SeamClass seam_class) {
  static constexpr std::array<std::string_view, 3> names = {"smooth", "defect", "crease"};
  return names[static_cast<std::size_t>(seam_class)];
}

std::optional<Level> levelFromName(std::string_view text) {
  for (const Level level : {Level::G0, Level::G1, Level::G2, Level::G3})
    if (text == name(level)) return level;
  return std::nullopt;
}

Verdict judge(const SeamFigures& figures, const ContinuityTolerance& tolerance, Level required) {
  Verdict verdict = verdictAt(figures, tolerance, required, End::Lower);
  const Verdict worst = verdictAt(figures, tolerance, required, End::Upper);
  verdict.certain = worst.level == verdict.level && worst.seam_class == verdict.seam_class &&
                    (figures.shares_known || verdict.level == Level::None);
  return verdict;
}

bool certainlyReaches(const SeamFigures& figures, const ContinuityTolerance& tolerance,
                      Level level) {
  return figures.shares_known && reachedLevel(figures, tolerance, End::Upper) >= level;
}

std::string remarksOn(const SeamFigures& figures, const ContinuityTolerance& tolerance) {
  std::string remarks = sharpSpotRemark(figures, tolerance);
  const auto add = [&](const std::string& remark) {
    remarks += (remarks.empty() ? "" : "; ") + remark;
  };
  if (figures.fold_at) add("the faces fold back on one another");
  if (!figures.settled)
    add("figures still changed after " + std::to_string(figures.points) + " points");
  return remarks;
}

}  // namespace seamwright
