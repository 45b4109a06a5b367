// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <vector>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/core/fill/sheet_fill.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/fill/bounded_face.hpp>
#include <seamwright/occ_adapter/fill/fitted_edge.hpp>
#include <seamwright/occ_adapter/fill/sheet_face.hpp>
#include <seamwright/occ_adapter/fill/side_cut.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

/// A sheet has so many sides.
constexpr std::size_t sheet_sides = 4;

/// At a corner of a sheet, two directions of its plane become those of the sides.
bool hasFourCorners(const Hole& hole, double gap_mm) {
  if (!hole.has_corners || hole.sides.size() != sheet_sides) return false;
  return std::ranges::all_of(anglesOf(hole, gap_mm), [](const HoleAngle& corner) {
    return corner.angle_rad < std::numbers::pi;
  });
}

SheetSample sheetSample(const SideSample& sample) {
  const Vector3d normal = sample.beyond.cross(sample.derivative).normalized();
  return {.point = sample.point,
          .derivative = sample.derivative,
          .normal = normal,
          .bend = curvatureTensor(sample.jet, normal)};
}

SheetFillSide sheetSide(const std::shared_ptr<const SidePath>& path) {
  SheetFillSide side{
      .at = [path](double share) { return sheetSample(path->besidePoleAtShare(share, true)); },
      .joints = path->joints()};
  const std::vector<double> breaks = path->breaks();
  side.joints.insert(side.joints.end(), breaks.begin(), breaks.end());
  return side;
}

/// The sides, beginning with one along the longer direction: the equations of a long and narrow
/// sheet are solved faster along it.
std::vector<HoleSide> longFirst(std::vector<HoleSide> sides) {
  if (sides[0].length_mm + sides[2].length_mm < sides[1].length_mm + sides[3].length_mm)
    std::rotate(sides.begin(), sides.begin() + 1, sides.end());
  return sides;
}

/// The point of the parameter plane at a share of a side, see SheetFill::surface.
Vector2d placeOn(const BSplineSurface& surface, std::size_t side, double share) {
  const double u = surface.knots_u.back(), v = surface.knots_v.back();
  const std::array<Vector2d, sheet_sides + 1> corners = {
      Vector2d(0, 0), Vector2d(u, 0), Vector2d(u, v), Vector2d(0, v), Vector2d(0, 0)};
  return (1 - share) * corners[side] + share * corners[side + 1];
}

/// The farthest pole from the middle of the sides, over half the diagonal of their box.
double reachOf(const BSplineSurface& surface, const std::array<SheetFillSide, sheet_sides>& sides) {
  constexpr int count = 16;
  Eigen::AlignedBox3d box;
  for (const SheetFillSide& side : sides)
    for (int k = 0; k < count; ++k) box.extend(side.at(static_cast<double>(k) / count).point);
  double farthest_mm = 0;
  for (Eigen::Index k = 0; k < surface.poles.rows(); ++k)
    farthest_mm =
        std::max(farthest_mm, (surface.poles.row(k).head<3>().transpose() - box.center()).norm());
  return farthest_mm / (0.5 * box.diagonal().norm());
}

}  // namespace

void SheetFaces::begin() {
  begun_ = true;
  const ContinuityTolerance& tolerance = task_.options.tolerance;
  const double gap_mm = tolerance.gap_mm / fit_share;
  if (!hasFourCorners(task_.hole, gap_mm)) return;
  sides_ = longFirst(task_.hole.sides);
  for (std::size_t k = 0; k < sheet_sides; ++k)
    given_[k] = sheetSide(std::make_shared<const SidePath>(sides_[k], gap_mm));
  sheets_.emplace(
      given_,
      SheetFillOptions{.gap_mm = tolerance.gap_mm,
                       .angle_rad = task_.options.target == Level::G0 ? 0 : tolerance.angle_rad});
}

std::optional<SheetFace> SheetFaces::next(const Progress& progress) {
  if (!begun_) begin();
  if (!sheets_) return std::nullopt;
  const std::optional<SheetFill> fill = sheets_->next(progress);
  if (!fill) return std::nullopt;
  const double gap_mm = task_.options.tolerance.gap_mm / fit_share;
  std::vector<BoundaryEdge> boundary;
  for (std::size_t k = 0; k < sheet_sides; ++k) {
    double begin_mm = 0;
    const double side_mm = SidePath(sides_[k], gap_mm).length_mm();
    for (const HoleEdge& hole_edge : sides_[k].edges) {
      const SidePath path({{hole_edge}, hole_edge.length_mm}, gap_mm);
      std::optional<BoundaryEdge> edge = fittedEdge(
          hole_edge, path,
          [&](double parameter) {
            const double to_mm = begin_mm + path.length_mm() * path.shareOf(parameter);
            return placeOn(fill->surface, k, to_mm / side_mm);
          },
          gap_mm / fit_share, gap_mm);
      if (!edge) return std::nullopt;
      begin_mm += path.length_mm();
      boundary.push_back(*edge);
    }
  }
  return SheetFace{boundedFace(geomSurface(fill->surface), boundary, true).face, fill->regular,
                   reachOf(fill->surface, given_)};
}

}  // namespace seamwright::occ
