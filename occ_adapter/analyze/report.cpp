// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <array>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>

namespace seamwright::occ {

namespace {

struct Candidate {
  const char* quantity;
  std::optional<double> at;
};

std::optional<double> parameterOf(const std::optional<Figure>& figure) {
  return figure ? std::optional(figure->at) : std::nullopt;
}

}  // namespace

std::optional<WorstPoint> worstPoint(const SeamFigures& figures, Level level,
                                     const std::function<Eigen::Vector3d(double at)>& point_at) {
  const std::array<Candidate, 4> candidates = {
      {{"gap", parameterOf(figures.gap_mm)},
       {"angle", figures.fold_at ? figures.fold_at : parameterOf(figures.angle_rad)},
       {"curvature", parameterOf(figures.curvature_rel)},
       {"curvature_change", parameterOf(figures.curvature_change_rel)}}};
  const std::size_t deciding = std::min(static_cast<std::size_t>(level), candidates.size() - 1);
  for (std::size_t i = deciding + 1; i-- > 0;)
    if (const auto [quantity, at] = candidates[i]; at)
      return WorstPoint{quantity, *at, point_at(*at)};
  return std::nullopt;
}

std::string figuresText(const SeamResult& seam) {
  std::string text = fmt::format("level {}", name(seam.verdict.level));
  const auto add = [&](const char* name, const std::optional<Figure>& figure, double factor,
                       const char* unit) {
    if (figure)
      text +=
          fmt::format(", {} {:.6g}{}", name, factor * figure->upper.value_or(figure->lower), unit);
  };
  add("gap", seam.figures.gap_mm, 1, " mm");
  add("angle", seam.figures.angle_rad, degrees_per_radian, " degrees");
  add("curvature", seam.figures.curvature_rel, 100, " %");
  if (!seam.figures.uncertified.empty()) text += ", not enclosed: " + seam.figures.uncertified;
  if (!seam.note.empty()) text += ", " + seam.note;
  return text;
}

}  // namespace seamwright::occ
