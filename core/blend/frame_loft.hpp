// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/progress.hpp>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// The frame at a parameter omega. All frames have the same degree, the same number of segments,
/// and all or none are closed; each has knots of its own.
using FrameFunction = std::function<BezierSpline(double omega)>;

/// |d^order P / d omega^order| <= size for every pole P of the segments of the frames, between two
/// neighbouring kinks. The size is in mm by omega^order.
struct FrameDerivativeBound {
  int order = 4;  ///< 1 to 8
  double size = 0;
};

struct FrameLoftOptions {
  /// n, 0 to 4: the surface is G^n across the lines of joints.
  int order = 2;
  /// The order of each joint, up to \p order, as measureJoints() has them: corners of the frames
  /// stay corners. Empty: \p order at all joints.
  std::vector<int> joint_orders = {};
  /// A span is halved while the distance of a frame from its iso-curve is > tolerance_mm.
  double tolerance_mm = 1e-3;
  /// The iso-curves at these omegas, and those at the ends, are the frames except for rounding.
  std::vector<double> stations = {};
  /// Omegas across which the frames, and so the surface, are continuous only.
  std::vector<double> kinks = {};
  /// The last frame is the first one, and the surface is C^2 across it (C^0 if there are kinks).
  bool closed = false;
  int first_spans = 4;  ///< the least number of spans between stations to begin with
  /// Work limit: spans are not halved beyond this number; the time grows with its third power.
  int max_spans = 256;
  int checks = 4;  ///< frames in each span whose distance is measured, 1 or more
  /// With a bound the distance is proven between the checks, too; there are then \p order checks.
  std::optional<FrameDerivativeBound> derivative_bound = {};
  Progress progress = {};
};

struct FrameLoft {
  /// U runs along the frames, v is omega. The lines of joints are those of the inner knots of u,
  /// each of them the mean of the knots of the frames.
  BSplineSurface surface;
  /// All frames are C^n by equal knots, and the surface is the plain loft, C^n in u.
  bool smooth_frames = false;
  int spans = 0;   ///< in omega
  int frames = 0;  ///< evaluated
  /// The largest distance of poles of the frames and of the iso-curves, over all frames checked. It
  /// is a bound of the distance of points of equal parameters in their segment.
  double distance_mm = 0;
  double distance_at = 0;  ///< omega of that frame
  /// The same within the zones of the ends of a sheet, which distance_mm leaves out.
  double zone_distance_mm = 0;
  /// With a derivative bound and for frames without weights: a bound over all omega outside of
  /// these zones.
  std::optional<double> proven_mm;
  /// The distance (the proven one with a derivative bound) is within the tolerance.
  bool reached = false;
  /// Proven: the ratio of speeds at all joints is positive for all omega. If not, the surface may
  /// fold at a line of joints.
  bool ratios_positive = true;
};

/// The B-spline surface whose iso-curves omega = const are the frames, within the tolerance, and
/// which is G^n across the lines of joints exactly: not by a small tolerance, but by construction.
///
///     const FrameLoft loft = frameLoft(frame, {0, 1}, {.order = 2, .tolerance_mm = 1e-3});
///
/// If all frames are C^n by equal knots, the poles of their B-spline curves are interpolated by C^2
/// cubic splines of omega: every iso-curve is C^n. Otherwise not the poles are interpolated, but
/// numbers that determine G^n curves: at each joint a common jet W_0..W_n and the changes of
/// parameter that make the derivatives of the two sides of it. The poles at the joint are then
/// polynomials of degree 3 (n + 1) in omega, and 3 where all frames have the same changes. The
/// degree along the frames is raised to 2 n + 1 if it is lower. The surface is C^2 in omega
/// except at kinks.
///
/// Between two stations a span is halved where the distance is above the tolerance. The distance is
/// measured at the checks; that it holds between them is proven only with a derivative bound
/// (S7.4).
///
/// Identities (each has a test of its number):
///   (1) At the stations and both ends the iso-curves are the frames.
///   (2) The joint lines are certified G^n by encloseKnotLines(), up to rounding.
///   (3) Frames that are cubic in omega, with equal changes at the joints, are met for all omega.
///   (4) Rigid motion and scale (of the tolerance too) move the surface with the frames. Frames run
///       backwards, and omega run backwards, give the same surface with u, or v, backwards.
/// \throws std::invalid_argument for invalid options (with the value), a range that is empty or
/// not finite, a frame that requireValid() refuses or that differs in structure from the first one
/// (with its omega), ends that differ if closed, rational frames that are not C^n by equal knots or
/// whose weights vary, and a joint without tangents or with a negative ratio (with omega and
/// joint). Also for n > 0 if a degree above 25 would be needed.
/// \throws Cancelled if the progress returns false.
/// Source: docs/theory/surfaces.md S7.1 to S7.4.
FrameLoft frameLoft(const FrameFunction& frame, const Interval& omegas,
                    const FrameLoftOptions& options = {});

/// The iso-curve v = omega as Bézier segments over the knots of u. \throws std::invalid_argument as
/// requireValid() does, and for an omega outside of the range.
BezierSpline isoCurve(const BSplineSurface& surface, double omega, bool closed = false);

/// The parts of a surface between some lines of its knots, exactly: with the poles of the surface
/// between them, and a common row of poles at each line.
///   (6) Points of the parts are points of the surface at the same parameters, bitwise at the
///   poles.
/// \param lines increasing inner knots of that direction, of a multiplicity of the degree.
/// \throws std::invalid_argument for other lines.
std::vector<BSplineSurface> partsBetween(const BSplineSurface& surface, SurfaceDirection direction,
                                         const std::vector<double>& lines);

/// A line of a knot, and how the parts of the surface on its two sides meet there.
struct KnotLine {
  double knot = 0;
  SeamFigures figures;
};

/// Encloses gap, angle and curvature difference along each inner knot line of a direction; with \p
/// closed also along the line where the end meets the beginning, as the last one. At each line the
/// surface is divided exactly, by insertion of knots.
///   (5) For a knot of multiplicity degree - n all figures up to order n are rounding only.
/// \throws std::invalid_argument as requireValid() and encloseSeam() do.
std::vector<KnotLine> encloseKnotLines(const BSplineSurface& surface, SurfaceDirection direction,
                                       const ContinuityTolerance& tolerance, bool closed = false,
                                       const EncloseOptions& options = {});

}  // namespace seamwright
