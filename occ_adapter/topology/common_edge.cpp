// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <functional>

#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/seam_strips.hpp>
#include <seamwright/occ_adapter/topology/common_edge.hpp>
#include <seamwright/occ_adapter/topology/sew_reasons.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

double between(const ParameterRange& range, double s) {
  return range[0] + s * (range[1] - range[0]);
}

double parameter(const PlanarPath& path, double share) {
  return path.first + share * (path.last - path.first);
}

handle<Geom2d_BSplineCurve> lineBetween(const gp_Pnt2d& from, const gp_Pnt2d& to) {
  TColgp_Array1OfPnt2d poles(1, 2);
  poles(1) = from;
  poles(2) = to;
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

/// A copy of a line, a B-spline or a Bezier curve between two parameters, with the same
/// parametrisation up to a constant factor; null for other curves.
handle<Geom2d_BSplineCurve> splineBetween(const handle<Geom2d_Curve>& curve, double from,
                                          double to) {
  if (const auto trimmed = handle<Geom2d_TrimmedCurve>::DownCast(curve); !trimmed.IsNull())
    return splineBetween(trimmed->BasisCurve(), from, to);
  if (curve->IsKind(STANDARD_TYPE(Geom2d_Line)))
    return lineBetween(curve->Value(from), curve->Value(to));
  handle<Geom2d_BSplineCurve> spline;
  if (curve->IsKind(STANDARD_TYPE(Geom2d_BSplineCurve)))
    spline = handle<Geom2d_BSplineCurve>::DownCast(curve->Copy());
  else if (curve->IsKind(STANDARD_TYPE(Geom2d_BezierCurve)))
    spline = Geom2dConvert::CurveToBSplineCurve(curve);
  if (spline.IsNull() || spline->IsPeriodic()) return {};
  const auto [low, high] = std::minmax(from, to);
  spline->Segment(std::max(low, spline->FirstParameter()), std::min(high, spline->LastParameter()));
  if (from > to) spline->Reverse();
  return spline;
}

void setRange(Geom2d_BSplineCurve& spline, double first, double last) {
  TColStd_Array1OfReal knots(1, spline.NbKnots());
  spline.Knots(knots);
  const double start = knots.First(), length = knots.Last() - start;
  for (double& knot : knots) knot = first + (knot - start) / length * (last - first);
  knots.ChangeLast() = last;
  spline.SetKnots(knots);
}

/// The parameters of the second side that correspond to those of the first.
class Along {
 public:
  Along(const Seam& seam, const std::array<Pcurve, 2>& pcurves,
        const std::array<ParameterRange, 2>& ranges)
      : a_(seam.sides[0], pcurves[0]), b_(seam.sides[1], pcurves[1]), ranges_(ranges), seam_(seam) {
    for (const int end : {0, 1}) off_[end] = ranges[1][end] - nearest(end);
  }

  /// The parameter of the second side at s in 0..1 of the interval. At the ends it is the given
  /// parameter, which may differ a little from that of the nearest point.
  double at(double s) const {
    if (s == 0 || s == 1) return ranges_[1][s == 0 ? 0 : 1];
    const auto [low, high] = std::minmax(ranges_[1][0], ranges_[1][1]);
    return std::clamp(nearest(s) + between(off_, s), low, high);
  }

  Eigen::Vector3d pointAt(double parameter) const { return b_.trace(parameter).p; }

 private:
  double nearest(double s) const {
    const auto [low, high] = std::minmax(ranges_[1][0], ranges_[1][1]);
    return nearestParameter(b_, a_.trace(between(ranges_[0], s)).p, guess(s), low, high);
  }

  /// A start value from the correspondence, whose ends may differ a little from those of the
  /// interval.
  double guess(double s) const {
    const std::vector<double>& a = seam_.correspondence.a;
    const std::vector<double>& b = seam_.correspondence.b;
    const double on_a = std::clamp(between(ranges_[0], s), a.front(), a.back());
    const auto right = std::lower_bound(a.begin() + 1, a.end() - 1, on_a) - a.begin();
    const double share =
        a[right] > a[right - 1] ? (on_a - a[right - 1]) / (a[right] - a[right - 1]) : 0;
    return b[right - 1] + share * (b[right] - b[right - 1]);
  }

  FaceStrip a_, b_;
  std::array<ParameterRange, 2> ranges_;
  const Seam& seam_;
  ParameterRange off_{};
};

bool isLinear(const Along& along, const ParameterRange& range, double near_mm) {
  // A choice, as the correspondence of parameters is smooth. The seam is measured afterwards.
  constexpr int count = 65;
  for (int k = 1; k + 1 < count; ++k) {
    const double s = static_cast<double>(k) / (count - 1);
    if ((along.pointAt(along.at(s)) - along.pointAt(between(range, s))).norm() > near_mm)
      return false;
  }
  return true;
}

/// A cubic spline through points of the pcurve. The number of points doubles from 9 until the
/// spline runs along the pcurve as \p along states, or up to 513.
handle<Geom2d_Curve> interpolated(const PlacedSurface& surface, const PlanarPath& path,
                                  const std::function<double(double)>& along, double first,
                                  double last, double near_mm) {
  // Intervals, as choices: eight cubics suffice for a smooth edge; with more than 512 the curve is
  // too large for what it gains. Then the last one is taken, and the seam is measured.
  constexpr int fewest = 8, most = 512;
  const auto on_path = [&](double s) { return path.curve->Value(parameter(path, along(s))); };
  for (int count = fewest;; count *= 2) {
    const handle<TColgp_HArray1OfPnt2d> points = new TColgp_HArray1OfPnt2d(1, count + 1);
    const handle<TColStd_HArray1OfReal> parameters = new TColStd_HArray1OfReal(1, count + 1);
    double before = along(0);
    for (int k = 0; k <= count; ++k) {
      const double s = static_cast<double>(k) / count, now = along(s);
      if (k > 0 && !((now - before) * (along(1) - along(0)) > 0))
        throw NoCommonEdge(why_not_sewn::pointsOutOfOrder());
      before = now;
      points->SetValue(k + 1, on_path(s));
      parameters->SetValue(k + 1, first + s * (last - first));
    }
    Geom2dAPI_Interpolate interpolation(points, parameters, false, Precision::PConfusion() / 1000);
    interpolation.Perform();
    if (!interpolation.IsDone()) throw GeometryError("no path runs along both edges");
    const handle<Geom2d_BSplineCurve> curve = interpolation.Curve();
    double off = 0;
    for (int k = 0; k < 2 * count; ++k) {
      const double s = (k + 0.5) / (2 * count);
      off = std::max(
          off,
          surface.at(curve->Value(first + s * (last - first))).Distance(surface.at(on_path(s))));
    }
    if (off <= near_mm || count == most) return handle<Geom2d_Curve>(curve);
  }
}

/// The pcurve over [first, last], with a linear change of the parameter.
handle<Geom2d_Curve> linear(const PlacedSurface& surface, const PlanarPath& path,
                            const ParameterRange& range, double first, double last,
                            double near_mm) {
  const double from = parameter(path, range[0]), to = parameter(path, range[1]);
  if (from == first && to == last) return path.curve;
  const handle<Geom2d_BSplineCurve> spline = splineBetween(path.curve, from, to);
  if (spline.IsNull())
    return interpolated(
        surface, path, [&range](double s) { return between(range, s); }, first, last, near_mm);
  setRange(*spline, first, last);
  return handle<Geom2d_Curve>(spline);
}

/// Whether both edges have the same curve with the same parametrisation.
bool haveOneCurve(const Seam& seam, const std::array<ParameterRange, 2>& ranges) {
  std::array<TopLoc_Location, 2> at;
  std::array<ParameterRange, 2> curve_ranges{};
  std::array<handle<Geom_Curve>, 2> curves;
  for (const int side : {0, 1})
    curves[side] = BRep_Tool::Curve(seam.sides[side].edge, at[side], curve_ranges[side][0],
                                    curve_ranges[side][1]);
  return !curves[0].IsNull() && curves[0] == curves[1] && at[0] == at[1] &&
         curve_ranges[0] == curve_ranges[1] && ranges[0] == ranges[1];
}

void store(const Seam& seam, CommonEdge& common) {
  BRep_Builder builder;
  builder.MakeEdge(common.edge, common.curve, common.tolerance_mm);
  builder.Range(common.edge, common.first, common.last);
  const PlacedSurface &a = common.sides[0].placed, &b = common.sides[1].placed;
  const handle<Geom2d_Curve>&path_a = common.sides[0].path.curve,
        &path_b = common.sides[1].path.curve;
  if (seam.sides[0].face != seam.sides[1].face) {
    builder.UpdateEdge(common.edge, path_a, a.surface, a.location, common.tolerance_mm);
    builder.UpdateEdge(common.edge, path_b, b.surface, b.location, common.tolerance_mm);
  } else if (seam.sides[0].edge.Orientation() == TopAbs_FORWARD) {
    builder.UpdateEdge(common.edge, path_a, path_b, a.surface, a.location, common.tolerance_mm);
  } else {
    builder.UpdateEdge(common.edge, path_b, path_a, a.surface, a.location, common.tolerance_mm);
  }
  builder.SameRange(common.edge, true);
  builder.SameParameter(common.edge, true);
}

}  // namespace

CommonEdge commonEdge(const Seam& seam, const std::array<ParameterRange, 2>& ranges,
                      double gap_mm) {
  // A thousandth of the gap: nothing that a seam is judged by.
  const double near_mm = gap_mm / 1000;
  CommonEdge common;
  double first = 0, last = 0;
  BRep_Tool::Range(seam.sides[0].edge, first, last);
  common.first = first + ranges[0][0] * (last - first);
  common.last = first + ranges[0][1] * (last - first);
  std::array<Pcurve, 2> pcurves;
  for (const int side : {0, 1}) {
    const Coedge& use = seam.sides[side];
    pcurves[side] = pcurveOf(use.edge, use.shape, gap_mm);
    common.sides.push_back(
        {surfaceOf(use.shape), {pcurves[side].curve, pcurves[side].first, pcurves[side].last}});
  }
  const Along along(seam, pcurves, ranges);
  const bool is_linear = isLinear(along, ranges[1], near_mm);
  for (const int side : {0, 1}) {
    auto& [placed, path] = common.sides[side];
    const handle<Geom2d_Curve> curve =
        side == 0 || is_linear
            ? linear(placed, path, ranges[side], common.first, common.last, near_mm)
            : interpolated(
                  placed, path, [&along](double s) { return along.at(s); }, common.first,
                  common.last, near_mm);
    path = {curve, common.first, common.last};
  }
  common.curve = haveOneCurve(seam, ranges)
                     ? BRep_Tool::Curve(seam.sides[0].edge, first, last)
                     : meanImage(common.sides, common.first, common.last, near_mm);
  common.tolerance_mm = std::max(
      Precision::Confusion(),
      between_points * largestDistance_mm(common.sides, *common.curve, common.first, common.last));
  store(seam, common);
  return common;
}

}  // namespace seamwright::occ
