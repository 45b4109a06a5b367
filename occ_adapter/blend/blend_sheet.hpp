// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/blend/lateral_sheet.hpp>
#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/occ_adapter/blend/blend_side.hpp>
#include <seamwright/occ_adapter/blend/lateral_curve.hpp>
#include <seamwright/occ_adapter/blend/lateral_pace.hpp>

/// The spline surface on one or two sides. Not a public header.
namespace seamwright::occ {

/// A given lateral boundary, and how the lines across run along it at the sides.
struct BlendLateral {
  LateralSide side = LateralSide::First;
  std::shared_ptr<const LateralCurve> curve;  ///< from start to end
  LateralPace pace;
  double longer_mm = 0;                ///< than the straight line between its ends
  std::array<LineBend, 2> bends = {};  ///< at start and end
  /// The face beside at a share of the length: for an order of 1 and above its unit normal, for 2
  /// its curvature tensor for that normal.
  std::function<Eigen::Vector3d(double share)> normal = nullptr;
  std::function<Eigen::Matrix3d(double share)> curvature = nullptr;
};

/// (1 - u)^3 beside the boundary u = 0, u^3 beside u = 1.
double weightBeside(LateralSide side, double u);

/// The sides, one or two, and what the surface does there.
struct BlendTask {
  std::vector<BlendSide> sides;
  std::vector<BlendEnd> ends;
  std::vector<BlendLateral> laterals = {};
  double length_mm = 0;  ///< of an extension, which has one side
  /// Whether both sides meet at the shares 0 and 1, so that the boundary there is a point.
  std::array<bool, 2> meets = {};
  SplineClosure closure = SplineClosure::Open;
  int degree = 5;  ///< along the sides; 3 where knots of cubic splines make third derivatives jump
  ContinuityTolerance tolerance;
  /// What the fit of each side is near to, if that may be less than the tolerance; empty: that.
  std::vector<ContinuityTolerance> aims = {};
  bool has_near_aims = false;  ///< some are nearer than is worth any number of spans

  const ContinuityTolerance& aim(int side) const { return aims.empty() ? tolerance : aims[side]; }
  int count() const { return static_cast<int>(sides.size()); }
  /// Lateral boundaries, corners and G3 need more derivatives.
  bool mayBeCubic() const;
};

/// Inner knots along the sides, by their multiplicity.
class SheetKnots {
 public:
  /// Those where curvatures of the sides jump, and halves between them: no span is longer than a
  /// quarter.
  explicit SheetKnots(const BlendTask& task);
  /// Those given, and halves between them.
  SheetKnots(int degree, const std::map<double, int>& inner);

  void halve(double from, double to) { multiplicities_[0.5 * (from + to)] = 1; }
  /// Halves the span, or makes knots of the breaks in it if it is short. A cubic span is divided at
  /// a break near its middle, if there is one.
  void refine(double from, double to);
  /// Places inside of the span where only higher derivatives of the sides jump.
  std::vector<double> breaksWithin(double from, double to) const;
  /// Halves spans that are much longer than one beside them.
  void grade();
  const std::map<double, int>& multiplicities() const { return multiplicities_; }
  int spans() const { return static_cast<int>(multiplicities_.size()) - 1; }
  /// Of a spline over the knots.
  int poles() const { return static_cast<int>(flat().size()) - degree_ - 1; }
  std::vector<double> flat() const;

 private:
  void add(double at, int multiplicity);
  void divide(double from, double to);
  void fill();

  int degree_;
  std::map<double, int> multiplicities_;
  std::vector<double> breaks_;  ///< that are no knots yet
};

/// The sheet with the fewest knots.
BSplineSurface firstSheet(const BlendTask& task);

struct RefinedSheet {
  BSplineSurface surface;
  /// Of the samples in spans that are left beyond their share, because they are too short or too
  /// many, the largest figure over its aim; 0: there is none.
  double left_excess = 0;
};

/// Halves spans until no sample is beyond that share of its aim, or no span can be halved, or there
/// are as many spans or poles along the sides as that.
/// \throws GeometryError where a side can't be continued, and for sides that touch; Cancelled.
RefinedSheet refinedSheet(const BlendTask& task, double share_of_aim, int max_spans,
                          SheetKnots& knots, const Progress& progress,
                          int max_poles = std::numeric_limits<int>::max());

/// The place nearest to the start where the sheet turns over, if it does so anywhere.
std::optional<SheetFold> foldOf(const BSplineSurface& sheet);

}  // namespace seamwright::occ
