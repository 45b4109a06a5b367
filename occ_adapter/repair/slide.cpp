// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <algorithm>
#include <array>
#include <vector>

#include <seamwright/occ_adapter/convert/adaptor_jet.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/repair/slide.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// 1 at an end, 0 from a quarter of the edge on, with a continuous derivative.
double fade(double from_end) {
  // A choice: below a half, so that the moves of both ends do not overlap. A shorter reach bends
  // the edge more.
  constexpr double reach = 0.25;
  const double t = std::clamp(from_end / reach, 0.0, 1.0);
  return (1 - t) * (1 - t) * (1 + 2 * t);
}

/// The new position of an edge on a face that stays.
class Slide {
 public:
  Slide(const Coedge& stays, const Coedge& moves, const handle<Geom_Surface>& moved, double gap_mm)
      : surface_(stays.shape),
        path_(pcurveOf(stays.edge, stays.shape, gap_mm)),
        boundary_(pcurveOf(moves.edge, moves.shape, gap_mm)),
        moved_(moved),
        near_mm_(share_of_gap * gap_mm) {
    for (const int end : {0, 1}) at_end_[end] = old(end).XY() - foot(end).XY();
  }

  std::optional<PathChange> path() const {
    // Intervals, as choices: the looks only decide whether the edge moves at all; the first samples
    // are halved where the curve misses; beyond the last number an edge has no smooth foot, and the
    // pcurve would be too large.
    constexpr int looks = 32, fewest = 16;
    constexpr std::size_t most = 1024;
    double largest_mm = 0;
    for (int k = 0; k <= looks; ++k)
      largest_mm = std::max(largest_mm, move_mm(static_cast<double>(k) / looks));
    if (largest_mm <= near_mm_) return {};
    std::vector<double> samples;
    for (int k = 0; k <= fewest; ++k) samples.push_back(static_cast<double>(k) / fewest);
    while (samples.size() <= most) {
      const handle<Geom2d_Curve> curve = interpolated(samples);
      std::vector<double> denser = withMissed(samples, *curve);
      if (denser.size() == samples.size())
        return PathChange{.path = curve, .largest_move_mm = largest_mm};
      samples = std::move(denser);
    }
    return {};
  }

 private:
  /// Accuracy of the new pcurve as a share of the gap tolerance, see slidPath().
  static constexpr double share_of_gap = 0.02;

  double parameter(const Pcurve& path, double s) const {
    return path.first + s * (path.last - path.first);
  }
  gp_Pnt2d old(double s) const { return path_.curve->Value(parameter(path_, s)); }
  gp_Pnt2d foot(double s) const {
    const gp_Pnt2d uv = boundary_.curve->Value(parameter(boundary_, s));
    return surface_.nearest(moved_->Value(uv.X(), uv.Y()), old(s));
  }
  gp_Pnt2d at(double s) const {
    if (s <= 0 || s >= 1) return old(s);
    return {foot(s).XY() + fade(s) * at_end_[0] + fade(1 - s) * at_end_[1]};
  }
  double move_mm(double s) const { return surface_.at(old(s)).Distance(surface_.at(at(s))); }

  handle<Geom2d_Curve> interpolated(const std::vector<double>& samples) const {
    const int count = static_cast<int>(samples.size());
    const handle<TColgp_HArray1OfPnt2d> points = new TColgp_HArray1OfPnt2d(1, count);
    const handle<TColStd_HArray1OfReal> parameters = new TColStd_HArray1OfReal(1, count);
    for (int k = 0; k < count; ++k) {
      points->SetValue(k + 1, at(samples[k]));
      parameters->SetValue(k + 1, k + 1 == count ? path_.last : parameter(path_, samples[k]));
    }
    Geom2dAPI_Interpolate interpolation(points, parameters, false, 0);
    interpolation.Perform();
    return handle<Geom2d_Curve>(interpolation.Curve());
  }

  /// The parameters, with the middle between two of them added where the curve misses the foot
  /// there.
  std::vector<double> withMissed(const std::vector<double>& samples,
                                 const Geom2d_Curve& curve) const {
    std::vector<double> denser = {samples.front()};
    for (std::size_t k = 1; k < samples.size(); ++k) {
      const double s = (samples[k - 1] + samples[k]) / 2;
      if (surface_.at(curve.Value(parameter(path_, s))).Distance(surface_.at(at(s))) > near_mm_)
        denser.push_back(s);
      denser.push_back(samples[k]);
    }
    return denser;
  }

  StayingSurface surface_;
  Pcurve path_, boundary_;
  handle<Geom_Surface> moved_;
  double near_mm_;
  std::array<gp_XY, 2> at_end_;
};

bool keepsAway(double value, double first, double last, bool is_periodic) {
  // Margin at the ends of the parameters as a share of their range.
  constexpr double share = 0.02;
  if (is_periodic || Precision::IsInfinite(first) || Precision::IsInfinite(last)) return true;
  const double margin = share * (last - first);
  return value > first + margin && value < last - margin;
}

}  // namespace

gp_Pnt2d StayingSurface::nearest(const gp_Pnt& point, const gp_Pnt2d& start) const {
  // Steps converge linearly, by the product of distance and curvature, so a few are enough for the
  // small moves of a repair. The seam is measured afterwards.
  constexpr int most_steps = 10;
  // Length of the last step in mm, far below any tolerance.
  constexpr double near = 1e-10;
  gp_Pnt2d uv = start;
  for (int k = 0; k < most_steps; ++k) {
    gp_Pnt at;
    gp_Vec du, dv;
    surface_.D1(uv.X(), uv.Y(), at, du, dv);
    const gp_Vec to(at, point);
    const Eigen::Matrix2d metric{{du.Dot(du), du.Dot(dv)}, {du.Dot(dv), dv.Dot(dv)}};
    const Eigen::Vector2d step = metric.ldlt().solve(Eigen::Vector2d(to.Dot(du), to.Dot(dv)));
    if (!step.allFinite()) return uv;
    uv.SetXY(uv.XY() + gp_XY(step[0], step[1]));
    if (step.dot(metric * step) <= near * near) break;
  }
  return uv;
}

gp_Pnt2d StayingSurface::within(const gp_Pnt2d& uv) const {
  const auto clamped = [](double value, double first, double last, bool is_periodic) {
    return is_periodic ? value : std::clamp(value, first, last);
  };
  return {clamped(uv.X(), surface_.FirstUParameter(), surface_.LastUParameter(),
                  surface_.IsUPeriodic()),
          clamped(uv.Y(), surface_.FirstVParameter(), surface_.LastVParameter(),
                  surface_.IsVPeriodic())};
}

SurfaceJet StayingSurface::jet(const gp_Pnt2d& uv) const {
  return jetOn(surface_, uv.X(), uv.Y());
}

bool StayingSurface::surrounds(const Pcurve& path) const {
  // A choice: a look each 3 % of the path. The margin of 2 % is for what the path does between
  // them.
  constexpr int looks = 32;
  for (int k = 0; k <= looks; ++k) {
    const gp_Pnt2d uv = path.curve->Value(path.first + (path.last - path.first) * k / looks);
    if (!keepsAway(uv.X(), surface_.FirstUParameter(), surface_.LastUParameter(),
                   surface_.IsUPeriodic()) ||
        !keepsAway(uv.Y(), surface_.FirstVParameter(), surface_.LastVParameter(),
                   surface_.IsVPeriodic()))
      return false;
  }
  return true;
}

std::optional<PathChange> slidPath(int edge, const Coedge& stays, const Coedge& moves,
                                   const handle<Geom_Surface>& moved, double gap_mm) {
  std::optional<PathChange> change = Slide(stays, moves, moved, gap_mm).path();
  if (change) {
    change->edge = edge;
    change->face = stays.face;
  }
  return change;
}

}  // namespace seamwright::occ
