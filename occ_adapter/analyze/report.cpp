// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <sstream>

#include <seamwright/occ_adapter/analyze/report.hpp>

namespace seamwright::occ {

namespace {

struct Candidate {
  const char* quantity;
  std::optional<double> at;
};

std::optional<double> placeOf(const std::optional<Figure>& figure) {
  return figure ? std::optional(figure->at) : std::nullopt;
}

}  // namespace

std::optional<WorstPoint> worstPoint(const SeamFigures& figures, Level level,
                                     const std::function<Eigen::Vector3d(double at)>& point_at) {
  const std::array<Candidate, 4> candidates = {
      {{"gap", placeOf(figures.gap_mm)},
       {"angle", figures.fold_at ? figures.fold_at : placeOf(figures.angle_rad)},
       {"curvature", placeOf(figures.curvature_rel)},
       {"curvature_change", placeOf(figures.curvature_change_rel)}}};
  const std::size_t deciding = std::min(static_cast<std::size_t>(level), candidates.size() - 1);
  for (std::size_t i = deciding + 1; i-- > 0;)
    if (const auto [quantity, at] = candidates[i]; at)
      return WorstPoint{quantity, *at, point_at(*at)};
  return std::nullopt;
}

std::string figuresText(const SeamResult& seam) {
  std::ostringstream text;
  const auto add = [&](const char* name, const std::optional<Figure>& figure, double factor,
                       const char* unit) {
    if (figure)
      text << ", " << name << ' ' << factor * figure->upper.value_or(figure->lower) << unit;
  };
  text << "level " << name(seam.verdict.level);
  add("gap", seam.figures.gap_mm, 1, " mm");
  add("angle", seam.figures.angle_rad, 57.295779513082323, " degrees");
  add("relative curvature difference", seam.figures.curvature_rel, 1, "");
  if (!seam.figures.uncertified.empty()) text << ", not enclosed: " << seam.figures.uncertified;
  if (!seam.note.empty()) text << ", " << seam.note;
  return text.str();
}

}  // namespace seamwright::occ
