// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// The edges of a side, and the face of each.
struct SideChoice {
  std::vector<int> edges;  ///< from 1, order of TopExp::MapShapes; in any order
  /// The faces to continue, for edges that bound two faces; empty: the edges are free.
  std::vector<int> faces = {};
  std::string name = "side";  ///< in messages
};

/// How a new surface joins a side of a model.
struct BlendEnd {
  SideChoice side;
  int order = 2;  ///< 0 to 3: G0 to G3
  /// The speed at which the surface leaves the side, as a multiple of the distance between the
  /// sides.
  double tension = 1;
};

/// Curves along which the lateral boundaries of a blend run, from an end of the one side to an end
/// of the other.
struct LateralChoice {
  std::vector<int> edges = {};  ///< of one chain or of two, from 1, in any order; empty: none
  /// The faces beside them, for edges that bound two faces; empty: the edges are free, or bound
  /// faces that do not matter.
  std::vector<int> faces = {};
  int order = 0;  ///< 0 to 2: how the blend joins the faces beside, G0 to G2
  /// By an edge of a chain: the order of that boundary in place of the one above.
  std::map<int, int> orders = {};
};

struct BlendSurfaceOptions {
  ContinuityTolerance tolerance;  ///< the seams meet it: gap, angle, curvature
  int max_spans = 300;            ///< work limit: the most spans along the sides, and across
  /// The end runs in the other direction than that in which a blend is less twisted.
  bool flip = false;
  LateralChoice lateral;
};

/// A seam between the new face and a face of the model. Its second face is 0, the new one.
struct BlendSeam {
  SeamResult result;
  Level level = Level::G0;  ///< of its end: what the seam must reach
};

/// A side of a new face.
struct BlendEndReport {
  std::string name;  ///< "start", "end", or "side" of an extension
  std::vector<int> edges, faces;
  double length_mm = 0;
  double covered_mm = 0;  ///< length of the seams
  Level level = Level::G0;
  std::string reason;    ///< why the seams do not cover the side; empty: they do
  bool reached = false;  ///< the seams certainly have the level, and cover the side
};

/// A given lateral boundary of a new face.
struct BlendLateralReport {
  std::vector<int> edges;   ///< from the start to the end
  std::vector<int> faces;   ///< beside; empty: none was measured
  double length_mm = 0;     ///< of the edges
  double distance_mm = 0;   ///< the largest from the boundary to the edges that was seen
  double covered_mm = 0;    ///< length of the seams with the faces beside
  Level level = Level::G0;  ///< what these must reach
  std::string reason;       ///< why the boundary falls short; empty: it does not
};

/// Where a surface turns over: its normal jumps to the other side along a line across the sides.
struct SheetFold {
  double distance_mm = 0;  ///< from the start, along that line
  Eigen::Vector3d point_mm;
};

/// How an extension ends at a face.
struct ExtensionEnd {
  int face = 0;
  double least_mm = 0, most_mm = 0;  ///< length of the lines across
  double distance_mm = 0;            ///< largest, from the new edges to the face
};

/// A new face, and how it meets the model.
struct BlendSurfaceReport {
  BSplineSurface surface;
  TopoDS_Face face;
  TopoDS_Shape shape;  ///< the model and the new face, which is its last, in one compound
  /// With the faces of each end and beside lateral boundaries, in parts where edges join.
  std::vector<BlendSeam> seams;
  int spans = 0;                             ///< along the sides
  std::vector<BlendEndReport> ends;          ///< start and end, or the one side
  std::vector<BlendLateralReport> laterals;  ///< the given ones: those at u = 0 first
  std::optional<SheetFold> fold;   ///< the one nearest to the start, if the surface has any
  std::optional<ExtensionEnd> to;  ///< of an extension up to a face
  /// All seams certainly have the level of their end and cover the sides, lateral boundaries are
  /// within the gap tolerance of their edges, and an extension does not fold.
  bool reached = false;
};

/// A surface between two sides of a model, of edges or chains of edges of any surfaces, trimmed or
/// not: it joins each side G0 to G3. Where it begins it goes on as geodesics of the face do; these
/// are fitted by quintic splines over knots that both sides have in common, which are halved until
/// each seam is within half of the tolerance. The geodesics leave a side nearly at right angles, in
/// directions that change smoothly, and at its ends in the directions of the edges that end there.
/// Both sides are run through by shares of their lengths, in the directions in which the surface is
/// less twisted.
///
///     const BlendSurfaceReport blend = blendSurface(model, {.side = {{3}}}, {.side = {{8, 9}}});
///
/// The surface has degree 5 along the sides and m + n + 1 across for the orders m and n.
///
/// With lateral boundaries the lines across leave the ends of the sides along these curves, and the
/// surface is moved to them by splines across, which change nothing at the sides: S8.5. Each line
/// across at such a boundary begins with a speed of the tension times the length of the curve.
///
/// Where the sides share a vertex, the boundary of the surface is that point: S8.7.
/// \throws std::invalid_argument, with the end, for sides without edges, with an edge given twice
/// or in both sides, with a number that names no edge, that are no single chain, with a corner, and
/// with an edge that is not free and has not exactly one of the given faces; for orders outside of
/// 0..3, tensions that are not positive and finite, one closed side and an open one, sides that
/// meet at an angle below 5 or above 175 degrees or, for orders above 1, on different tangent
/// planes, and invalid tolerances; for lateral boundaries of closed sides, of more than two chains,
/// with a corner, that do not join ends of the sides, or that no such surface can have, with
/// figures; GeometryError for edges that can't be evaluated, and for sides that touch; Cancelled.
/// Source: docs/theory/surfaces.md S8.1 to S8.7.
BlendSurfaceReport blendSurface(const TopoDS_Shape& model, const BlendEnd& start,
                                const BlendEnd& end, const BlendSurfaceOptions& options = {},
                                const Progress& progress = {});

/// A surface that continues a side of a model over a length: its lines across are the Taylor
/// polynomials of the geodesics across the side, of the order's degree, and have the length. It
/// joins the side G1, G2 or G3; for G1 it is ruled. The tension is not used. Beyond the radius of
/// curvature the surface is far from the geodesics: a cylinder of radius R goes on as a parabola.
///
///     const BlendSurfaceReport longer = extendSurface(model, {.side = {{3}}}, 10);
///
/// \throws as blendSurface(), and std::invalid_argument for order 0 and a length that is not
/// positive and finite. Source: docs/theory/surfaces.md S8.2 to S8.4.
BlendSurfaceReport extendSurface(const TopoDS_Shape& model, const BlendEnd& side, double length_mm,
                                 const BlendSurfaceOptions& options = {},
                                 const Progress& progress = {});

/// A surface that continues a side of a model up to a face, which trims it: OpenCASCADE divides an
/// extension that is a little longer. The face is not changed.
///
///     const BlendSurfaceReport longer = extendSurfaceTo(model, {.side = {{3}}}, 7);
///
/// \throws as extendSurface(); std::invalid_argument for a number that names no face; GeometryError
/// where a line across does not meet the face, with the line, and if OpenCASCADE can't divide.
BlendSurfaceReport extendSurfaceTo(const TopoDS_Shape& model, const BlendEnd& side, int face,
                                   const BlendSurfaceOptions& options = {},
                                   const Progress& progress = {});

}  // namespace seamwright::occ
