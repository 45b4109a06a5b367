// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <stdexcept>

#include <seamwright/core/fill/ring_fill.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/fill/fill_faces.hpp>
#include <seamwright/occ_adapter/fill/fill_form.hpp>

namespace seamwright::occ {

namespace {

/// Bound of the rounding between the planes of both sides of a corner, which are fitted to agree.
constexpr double plane_noise_rad = 1e-7;

/// Degree from which a fill is costly: the time grows with the sixth power of the degree, and
/// several fills are tried until one is regular.
constexpr int costly_degree = 7;

/// Highest degree of a fill with target G2.
constexpr int most_g2_degree = 9;

/// The surfaces of a fill with their figures.
struct FillSurfaces {
  std::vector<BSplineSurface> surfaces;
  std::vector<FillCorner> corners;
  bool regular = false;
  std::optional<double> curvature_jump_per_mm;
};

/// How much the degree is raised above the one that G1 needs, which is by \p more higher than the
/// largest degree of edges and cross-boundary derivatives. Nothing for target G1 in high degrees,
/// because the time grows with the sixth power of the degree.
std::optional<int> curvatureDegrees(const std::vector<FillSide>& sides, int more, Level target,
                                    const FillAttempt& attempt) {
  if (!attempt.curvature_raise) return std::nullopt;
  Eigen::Index degree = 0;
  for (const FillSide& side : sides)
    degree = std::max(
        {degree, Eigen::Index{side.edge.degree()}, side.cross ? side.cross->rows() - 1 : 0});
  degree += more;
  if (target == Level::G1 && degree >= costly_degree) return std::nullopt;
  const int most_degree = target == Level::G1 ? costly_degree - 1 : most_g2_degree;
  return std::clamp(most_degree - static_cast<int>(degree), 0, *attempt.curvature_raise);
}

/// A ring. With target G2 its patches meet each other with G2 if they are regular then.
/// \throws NotFilled if the joins of the ring contradict each other.
RingFill ringOf(const std::vector<FillSide>& sides, Level target,
                std::optional<int> curvature_degrees) {
  RingFillOptions options{.corner_tolerance_rad = plane_noise_rad,
                          .curvature_degrees = curvature_degrees};
  try {
    if (target == Level::G2) {
      options.law = SpokeLaw::G2;
      RingFill fill = ringFill(sides, options);
      if (fill.regular) return fill;
      options.law = SpokeLaw::Linear;
    }
    return ringFill(sides, options);
  } catch (const RingContradiction& contradiction) {
    throw NotFilled({.fault = FillFault::ConstructionRefused, .detail = contradiction.what()});
  }
}

FillSurfaces ringSurfaces(const std::vector<FillSide>& sides, Level target,
                          const FillAttempt& attempt) {
  const RingFill fill = ringOf(sides, target, curvatureDegrees(sides, 3, target, attempt));
  FillSurfaces result{.surfaces = {},
                      .corners = fill.corners,
                      .regular = fill.regular,
                      .curvature_jump_per_mm = fill.curvature_jump_per_mm};
  for (const BezierPatch& patch : fill.patches) result.surfaces.push_back(splineSurface(patch));
  return result;
}

/// Patches around one inner vertex. With target G2 they meet each other with G2 if they are regular
/// then. If they are not regular, they are built without regard to curvature, and then with the
/// quadratic law of the spokes.
NSidedFill starFill(const std::vector<FillSide>& sides, Level target, const FillAttempt& attempt) {
  FillOptions options{.corner_tolerance_rad = plane_noise_rad};
  if (target == Level::G2) {
    options.law = SpokeLaw::G2;
    options.curvature_degrees = curvatureDegrees(sides, 2, target, attempt);
    NSidedFill fill = nSidedFill(sides, options);
    if (fill.regular) return fill;
    options.law = SpokeLaw::Linear;
  }
  options.curvature_degrees = curvatureDegrees(sides, 1, target, attempt);
  NSidedFill fill = nSidedFill(sides, options);
  if (!fill.regular && options.curvature_degrees) {
    options.curvature_degrees.reset();
    fill = nSidedFill(sides, options);
  }
  if (!fill.regular && fill.patches.front().degreeU() < costly_degree) {
    options.law = SpokeLaw::Quadratic;
    NSidedFill other = nSidedFill(sides, options);
    if (other.regular) fill = std::move(other);
  }
  return fill;
}

FillSurfaces starSurfaces(const std::vector<FillSide>& sides, const FillHoleOptions& asked,
                          const FillAttempt& attempt) {
  const NSidedFill fill = starFill(sides, asked.target, attempt);
  return {.surfaces = withCornerKnots(fill, asked.tolerance.angle_rad / fit_share),
          .corners = fill.corners,
          .regular = fill.regular,
          .curvature_jump_per_mm = fill.curvature_jump_per_mm};
}

TopoDS_Face faceOf(const BSplineSurface& surface) {
  const bool is_patch = surface.countU() == surface.degree_u + 1;
  const opencascade::handle<Geom_Surface> geometry =
      is_patch ? opencascade::handle<Geom_Surface>(toBezierSurface(bezierPatch(surface)))
               : opencascade::handle<Geom_Surface>(geomSurface(surface));
  BRepBuilderAPI_MakeFace face(geometry, Precision::Confusion());
  if (!face.IsDone())
    throw NotFilled(
        {.fault = FillFault::OpenCascadeFailed, .detail = "OpenCASCADE made no face of a patch"});
  return face.Face();
}

FillFaces facesOf(const FillSurfaces& built, const HoleCut& cut) {
  FillFaces result{.faces = {},
                   .cut = cut,
                   .corners = built.corners,
                   .regular = built.regular,
                   .curvature_jump_per_mm = built.curvature_jump_per_mm};
  for (const BSplineSurface& surface : built.surfaces) {
    result.faces.push_back(faceOf(surface));
    result.reach = std::max(result.reach, reachOf(surface, cut.sides));
  }
  return result;
}

}  // namespace

FillFaces fillFaces(const HoleCuts& cuts, const FillHoleOptions& options,
                    const FillAttempt& attempt) {
  const HoleCut& first = cuts.cuts.front();
  if (!cuts.is_ring) return facesOf(starSurfaces(first.fillSides(), options, attempt), first);
  std::optional<FillSurfaces> of_first;
  for (const HoleCut& cut : cuts.cuts) {
    if (of_first && cut.misses > fit_share) break;
    FillSurfaces built = ringSurfaces(cut.fillSides(), options.target, attempt);
    if (built.regular) return facesOf(built, cut);
    if (!of_first) of_first = std::move(built);
  }
  return facesOf(*of_first, first);
}

}  // namespace seamwright::occ
