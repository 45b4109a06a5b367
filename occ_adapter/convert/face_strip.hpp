// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <array>
#include <memory>
#include <vector>

#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/seam.hpp>

namespace seamwright::occ {

/// The order to which a strip is evaluated. Third order costs a little more and can fail where
/// second order does not.
enum class JetOrder { Second = 2, Third = 3 };
/// A point of a path in space, and its derivative.
struct PathPoint {
  Eigen::Vector3d p;
  Eigen::Vector3d d;  ///< derivative of p by s
};

/// One side of a seam as values of core: a surface along a path, with s in [0, 1] in the sense of
/// the edge's curve.
///
/// Locations, mirrored ones included, are applied. Not thread-safe: OpenCASCADE's adaptors cache.
class FaceStrip {
 public:
  /// \param pcurve the path of the edge on the face, see pcurveOf().
  FaceStrip(const Coedge& use, const Pcurve& pcurve, JetOrder order = JetOrder::Second);

  /// From now on the path consists of the points of the surface nearest to the edge's curve in
  /// space, which may be smooth where the pcurve is not. The pcurve is where the searches start.
  /// \pre the edge has a curve in space over the range of the pcurve.
  void followCurve(const TopoDS_Edge& edge);

  /// The jet to the given order, its noise, and the direction of the seam; lengths in mm.
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  SidePoint at(double s) const;

  /// The same without derivatives above the first.
  SidePoint firstOrderAt(double s) const;

  /// at(s).jet.p and its derivative, at a fraction of the cost.
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  PathPoint trace(double s) const;

  gp_Pnt2d parametersAt(double s) const { return placeAt(parameter(s)).uv; }

  /// Values of s in (0, 1) where the jet may not be smooth: knots of the pcurve and crossings of
  /// the surface's knot lines.
  std::vector<double> breaks() const;

  /// The share of the path, from its end 0 or 1, over which the surface has no tangent plane
  /// because a boundary of it collapses there.
  double poleReach(int end) const;

  /// Whether the parameter line that collapses at end 0 or 1 of the path is not exactly one point:
  /// the poles of a spline differ at all, or points of another surface differ by more than
  /// rounding.
  bool isScatteredAt(int end) const;

 private:
  enum class Derivatives { First, Second, Third };
  /// A point of the path in the parameter plane, and its derivative.
  struct Place {
    gp_Pnt2d uv;
    gp_Vec2d direction;
  };
  Place placeAt(double t) const;
  SidePoint at(double s, Derivatives derivatives) const;
  SurfaceJet jet(double u, double v, Derivatives derivatives) const;
  double collapsedLength(double s, double pole_tolerance_mm) const;
  double roundingOf(const SurfaceJet& jet) const;
  JetNoise noise(const SurfaceJet& jet, double s) const;
  void addKnotCrossings(double first, double last, int steps, std::vector<double>& at) const;
  double parameter(double s) const { return pcurve_.first + s * (pcurve_.last - pcurve_.first); }

  JetOrder order_;
  Pcurve pcurve_;
  Geom2dAdaptor_Curve path_;
  std::shared_ptr<const BRepAdaptor_Curve> curve_;  ///< null: the pcurve is the path
  BRepAdaptor_Surface surface_;
  bool forward_;
  std::vector<double> knots_u_;
  std::vector<double> knots_v_;
  std::vector<double> joints_u_;  ///< inner knots where the surface is less smooth than the order
  std::vector<double> joints_v_;
  std::array<double, 2> collapsed_mm_{};  ///< by end: length of the parameter line that collapses
                                          ///< there, 0 if none does
  double step_u_;                         ///< typical distance of knots, at most 1
  double step_v_;
  double range_u_;  ///< whole parameter range; 1 if infinite
  double range_v_;
};

}  // namespace seamwright::occ
