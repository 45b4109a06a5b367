// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <seamwright/core/fill/fill_corners.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <stdexcept>

namespace seamwright {

namespace {

/// Each level halves the angle and adds two knots: 12 divide it by 4096. Source:
/// docs/theory/fills.md F3.2.
constexpr int most_levels = 12;

double reach(int level) {
  return std::ldexp(1.0, -level);
}

int levelsFor(const FillCorner& corner, double angle_rad) {
  const double curable = corner.angle_bound_rad - corner.plane_angle_rad;
  if (corner.exact || !(curable > angle_rad)) return 0;
  return std::min(most_levels, static_cast<int>(std::ceil(std::log2(curable / angle_rad))));
}

/// The coefficients of beta_k over these knots, as polar forms: sum_m x_m prod_(j != m) (1 - x_j).
Eigen::VectorXd bump(const std::vector<double>& knots, int degree, int level) {
  const std::size_t n = static_cast<std::size_t>(degree);
  Eigen::VectorXd coefficients =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(knots.size() - n - 1));
  for (std::size_t i = 0; i + n + 1 < knots.size(); ++i) {
    if (knots[i + n + 1] <= 1 - reach(level)) continue;
    double sum = 0;
    for (std::size_t m = 1; m <= n; ++m) {
      double product = (1 - knots[i + m]) / reach(level);
      for (std::size_t j = 1; j <= n; ++j)
        if (j != m) product *= 1 - (1 - knots[i + j]) / reach(level);
      sum += product;
    }
    coefficients(static_cast<Eigen::Index>(i)) = reach(level) * sum;
  }
  return coefficients;
}

/// Those of phi_k.
Eigen::VectorXd straightBump(const std::vector<double>& knots, int degree, int level) {
  if (level == 0) return bump(knots, degree, 0);
  return 2 * bump(knots, degree, level) - bump(knots, degree, level + 1);
}

BSplineSurface withKnots(const BezierPatch& patch, int levels) {
  BSplineSurface surface = splineSurface(patch);
  for (const SurfaceDirection direction : {SurfaceDirection::U, SurfaceDirection::V})
    for (int level = 1; level <= levels; ++level)
      for (int times = 0; times < 2; ++times)
        surface = withKnot(surface, direction, 1 - reach(level));
  return surface;
}

BSplineSurface withLevels(const BezierPatch& patch, double defect_mm, int levels) {
  if (levels == 0) return splineSurface(patch);
  BSplineSurface surface = withKnots(patch, levels + 2);
  const SurfaceJet corner = patch.jet(1, 1);
  const int degree = patch.degreeU();
  const Eigen::RowVector3d weight =
      corner.u.cross(corner.v).normalized().transpose() * (defect_mm / (4.0 * degree * degree));
  Eigen::VectorXd wide = straightBump(surface.knots_u, degree, 0);
  for (int level = 1; level <= levels + 1; ++level) {
    const Eigen::VectorXd narrow = straightBump(surface.knots_u, degree, level);
    for (int i = 0; i < surface.countU(); ++i)
      for (int j = 0; j < surface.countV(); ++j)
        surface.poles.row(i * surface.countV() + j).leftCols<3>() +=
            (narrow(i) * wide(j) - wide(i) * narrow(j)) * weight;
    wide = narrow;
  }
  return surface;
}

}  // namespace

std::vector<BSplineSurface> withCornerKnots(const NSidedFill& fill, double angle_rad) {
  if (!(angle_rad > 0))
    throw std::invalid_argument("angle " + bernstein::text(angle_rad) + " rad is not positive");
  std::vector<BSplineSurface> surfaces;
  for (std::size_t k = 0; k < fill.patches.size(); ++k)
    surfaces.push_back(withLevels(fill.patches[k], fill.corners[k].twist_defect_mm,
                                  levelsFor(fill.corners[k], angle_rad)));
  return surfaces;
}

}  // namespace seamwright
