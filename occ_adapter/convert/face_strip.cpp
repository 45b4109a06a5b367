// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>

namespace seamwright::occ {

namespace {

std::vector<double> values(const TColStd_Array1OfReal& array) {
  return {array.begin(), array.end()};
}

/// Ends and inner limits of the pieces on which the surface has the continuity; by default those on
/// which it is analytic.
std::vector<double> knotsU(const BRepAdaptor_Surface& surface,
                           GeomAbs_Shape continuity = GeomAbs_CN) {
  TColStd_Array1OfReal array(1, surface.NbUIntervals(continuity) + 1);
  surface.UIntervals(array, continuity);
  return values(array);
}

std::vector<double> knotsV(const BRepAdaptor_Surface& surface,
                           GeomAbs_Shape continuity = GeomAbs_CN) {
  TColStd_Array1OfReal array(1, surface.NbVIntervals(continuity) + 1);
  surface.VIntervals(array, continuity);
  return values(array);
}

GeomAbs_Shape continuityOf(JetOrder order) {
  return order == JetOrder::Third ? GeomAbs_C3 : GeomAbs_C2;
}

template <class Curve>
std::vector<double> knots(const Curve& curve) {
  TColStd_Array1OfReal array(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(array, GeomAbs_CN);
  return values(array);
}

/// Adds the knots of the periods before and after, where paths on a periodic surface may run.
void repeatByPeriod(std::vector<double>& knots, std::vector<double>& joints, double period) {
  for (std::vector<double>* list : {&knots, &joints}) {
    const std::vector<double> once = *list;
    for (const double shift : {-period, period})
      for (const double knot : once) list->push_back(knot + shift);
    std::ranges::sort(*list);
  }
}

/// Without the ends.
std::vector<double> inner(const std::vector<double>& knots) {
  return {knots.begin() + 1, knots.end() - 1};
}

/// Mean length of the pieces, at most 1: analytic surfaces turn once in a few units of their
/// parameters. The mean, because files hold knots that only rounding tells apart.
double typicalStep(const std::vector<double>& knots) {
  return std::min(1.0, (knots.back() - knots.front()) / static_cast<double>(knots.size() - 1));
}

/// A small step off a knot to the side that \p toward points to; 0 away from knots.
double nudge(const std::vector<double>& knots, double value, double step, double toward) {
  // Files round paths and knots to ten digits or more, so a path this near runs along the knot
  // line. The nudge leaves that strip. It moves derivatives by a billionth of how they change over
  // a span, and the point, which is kept to first order, by less than rounding.
  const double near = 1e-10 * step;
  const auto knot = std::lower_bound(knots.begin(), knots.end(), value - near);
  if (toward == 0 || knot == knots.end() || *knot > value + near) return 0;
  return std::copysign(1e-9 * step, toward);
}

/// Length of the parameter range, 1 if it is infinite.
double finiteRange(const std::vector<double>& knots) {
  const double range = knots.back() - knots.front();
  return Precision::IsInfinite(range) ? 1 : range;
}

/// Where a coordinate of a path passes inner knots between the parameters t0 and t1, at which it is
/// \p from and \p to.
template <class Coordinate>
void addCrossings(const Coordinate& coordinate, double t0, double t1, double from, double to,
                  const std::vector<double>& knots, std::vector<double>& crossings) {
  const auto begin = std::upper_bound(knots.begin(), knots.end(), std::min(from, to));
  const auto end = std::lower_bound(begin, knots.end(), std::max(from, to));
  for (auto knot = begin; knot != end; ++knot) {
    double low = t0, high = t1;
    // More halvings than a double has bits: to the last bit of the parameter.
    for (int i = 0; i < 60 && low < high; ++i) {
      const double middle = 0.5 * (low + high);
      ((coordinate(middle) < *knot) == (from < *knot) ? low : high) = middle;
    }
    crossings.push_back(0.5 * (low + high));
  }
}

bool isSpline(const BRepAdaptor_Surface& surface) {
  return surface.GetType() == GeomAbs_BSplineSurface || surface.GetType() == GeomAbs_BezierSurface;
}

/// Whether poles 1 to \p count are one point.
bool areOnePoint(int count, const std::function<gp_Pnt(int i)>& pole) {
  for (int i = 2; i <= count; ++i)
    if (pole(i).SquareDistance(pole(1)) != 0) return false;
  return true;
}

/// Whether a point of the parameter plane is on a boundary of a spline all of whose poles coincide
/// exactly.
bool endsAtOnePoint(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv) {
  constexpr double rounding = 1e-9;  // of the range, of paths
  const auto look = [&](const auto& spline) {
    double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
    spline->Bounds(u1, u2, v1, v2);
    const int nu = spline->NbUPoles(), nv = spline->NbVPoles();
    const auto row = [&](int i) {
      return areOnePoint(nv, [&](int j) { return spline->Pole(i, j); });
    };
    const auto column = [&](int j) {
      return areOnePoint(nu, [&](int i) { return spline->Pole(i, j); });
    };
    const double near_u = rounding * (u2 - u1), near_v = rounding * (v2 - v1);
    return (std::abs(uv.X() - u1) <= near_u && row(1)) ||
           (std::abs(uv.X() - u2) <= near_u && row(nu)) ||
           (std::abs(uv.Y() - v1) <= near_v && column(1)) ||
           (std::abs(uv.Y() - v2) <= near_v && column(nv));
  };
  return surface.GetType() == GeomAbs_BezierSurface ? look(surface.Bezier())
                                                    : look(surface.BSpline());
}

}  // namespace

FaceStrip::FaceStrip(const Coedge& use, const Pcurve& pcurve, JetOrder order)
    : order_(order),
      pcurve_(pcurve),
      path_(pcurve_.curve, pcurve_.first, pcurve_.last),
      surface_(use.shape, false),
      forward_(use.edge.Orientation() == TopAbs_FORWARD),
      knots_u_(knotsU(surface_)),
      knots_v_(knotsV(surface_)),
      joints_u_(inner(knotsU(surface_, continuityOf(order)))),
      joints_v_(inner(knotsV(surface_, continuityOf(order)))),
      step_u_(typicalStep(knots_u_)),
      step_v_(typicalStep(knots_v_)),
      range_u_(finiteRange(knots_u_)),
      range_v_(finiteRange(knots_v_)) {
  if (surface_.IsUPeriodic()) repeatByPeriod(knots_u_, joints_u_, surface_.UPeriod());
  if (surface_.IsVPeriodic()) repeatByPeriod(knots_v_, joints_v_, surface_.VPeriod());
  for (const int end : {0, 1})
    collapsed_mm_[end] = collapsedLength(end, use.pole_tolerance_mm[end]);
}

void FaceStrip::followCurve(const TopoDS_Edge& edge) {
  curve_ = std::make_shared<const BRepAdaptor_Curve>(edge);
}

FaceStrip::Place FaceStrip::placeAt(double t) const {
  Place place;
  path_.D1(t, place.uv, place.direction);
  if (!curve_) return place;
  gp_Pnt on_curve, p;
  gp_Vec along, u, v, uu, vv, uv;
  curve_->D1(t, on_curve, along);
  // Newton's method for the foot. The pcurve is near: two steps leave rounding, and a knot line
  // between takes one or two more.
  constexpr int steps = 4;
  for (int step = 0; step <= steps; ++step) {
    surface_.D2(place.uv.X(), place.uv.Y(), p, u, v, uu, vv, uv);
    const gp_Vec off(p, on_curve);
    // The first step does without second derivatives: the pcurve may cross two knot lines that
    // nearly coincide, and between these they are of any size.
    const double bend = step == 0 ? 0 : 1;
    const double a = u * u - bend * (off * uu), b = u * v - bend * (off * uv),
                 c = v * v - bend * (off * vv);
    const double determinant = a * c - b * b;
    if (!(determinant > 0)) break;  // a pole: the pcurve has to do
    const auto solved = [&](const gp_Vec& of) {
      const double by_u = of * u, by_v = of * v;
      return gp_Vec2d((c * by_u - b * by_v) / determinant, (a * by_v - b * by_u) / determinant);
    };
    place.direction = solved(along);
    if (step < steps) place.uv.Translate(solved(off));
  }
  return place;
}

SidePoint FaceStrip::at(double s) const {
  SidePoint side = at(s, order_ == JetOrder::Third ? Derivatives::Third : Derivatives::Second);
  side.third_order = order_ == JetOrder::Third;
  return side;
}

SidePoint FaceStrip::firstOrderAt(double s) const {
  return at(s, Derivatives::First);
}

SidePoint FaceStrip::at(double s, Derivatives derivatives) const {
  const auto [uv, direction] = placeAt(parameter(s));
  SidePoint side;
  // Along a knot line derivatives may jump: those of the face's own side count. The point itself is
  // kept to first order.
  const double into = forward_ ? 1 : -1;
  const double du = nudge(joints_u_, uv.X(), step_u_, -into * direction.Y());
  const double dv = nudge(joints_v_, uv.Y(), step_v_, into * direction.X());
  side.jet = jet(uv.X() + du, uv.Y() + dv, derivatives);
  if (du != 0 || dv != 0) side.jet.p -= du * side.jet.u + dv * side.jet.v;
  side.noise = noise(side.jet, s);
  side.tangent = direction.X() * side.jet.u + direction.Y() * side.jet.v;
  side.face_on_left = forward_;
  return side;
}

PathPoint FaceStrip::trace(double s) const {
  auto [uv, direction] = placeAt(parameter(s));
  direction *= pcurve_.last - pcurve_.first;
  gp_Pnt p;
  gp_Vec du, dv;
  surface_.D1(uv.X(), uv.Y(), p, du, dv);
  return {vector(p), direction.X() * vector(du) + direction.Y() * vector(dv)};
}

SurfaceJet FaceStrip::jet(double u, double v, Derivatives derivatives) const {
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv, duuu, dvvv, duuv, duvv;
  switch (derivatives) {
    case Derivatives::First:
      surface_.D1(u, v, p, du, dv);
      break;
    case Derivatives::Second:
      surface_.D2(u, v, p, du, dv, duu, dvv, duv);
      break;
    case Derivatives::Third:
      surface_.D3(u, v, p, du, dv, duu, dvv, duv, duuu, dvvv, duuv, duvv);
      break;
  }
  SurfaceJet jet;
  jet.p = vector(p);
  jet.u = vector(du);
  jet.v = vector(dv);
  jet.uu = vector(duu);
  jet.uv = vector(duv);
  jet.vv = vector(dvv);
  jet.uuu = vector(duuu);
  jet.uuv = vector(duuv);
  jet.uvv = vector(duvv);
  jet.vvv = vector(dvvv);
  return jet;
}

double FaceStrip::collapsedLength(double s, double pole_tolerance_mm) const {
  if (pole_tolerance_mm == 0) return 0;
  const gp_Pnt2d uv = placeAt(parameter(s)).uv;
  // Derivatives of rational splines are rounding where their poles coincide.
  if (isSpline(surface_) && endsAtOnePoint(surface_, uv)) return 0;
  const SurfaceJet end = jet(uv.X(), uv.Y(), Derivatives::First);
  const double length = std::min(range_u_ * end.u.norm(), range_v_ * end.v.norm());
  return length <= pole_tolerance_mm ? length : 0;
}

bool FaceStrip::isScatteredAt(int end) const {
  const gp_Pnt2d uv = placeAt(parameter(end)).uv;
  const double rounding = roundingOf(jet(uv.X(), uv.Y(), Derivatives::First));
  return collapsed_mm_[end] > (isSpline(surface_) ? 0 : rounding);
}

double FaceStrip::poleReach(int end) const {
  const auto is_degenerate = [&](double reach) {
    const SidePoint side = at(end == 0 ? reach : 1 - reach);
    return degeneracy(side.jet, side.noise) != Degeneracy::None;
  };
  if (!is_degenerate(0)) return 0;
  double low = 0, high = 0.5;
  if (is_degenerate(high)) return high;
  // Three digits are enough: the caller leaves out a little more. The reach may be many orders of
  // magnitude below the seam, so it is first searched by tenths; below 1e-12 it is rounding of s.
  while (high - low > 1e-3 * high && high > 1e-12) {
    const double middle = low > 0 ? 0.5 * (low + high) : 0.1 * high;
    (is_degenerate(middle) ? low : high) = middle;
  }
  return high;
}

/// A partial is a difference of coordinates over a step, and each coordinate is rounded.
double FaceStrip::roundingOf(const SurfaceJet& jet) const {
  const double size =
      jet.p.lpNorm<Eigen::Infinity>() + step_u_ * jet.u.norm() + step_v_ * jet.v.norm();
  // Evaluation of a spline, with its placement, takes some ten operations on a coordinate and in
  // unfavourable order several times as many.
  return 64 * std::numeric_limits<double>::epsilon() * size;
}

JetNoise FaceStrip::noise(const SurfaceJet& jet, double s) const {
  const double rounding = roundingOf(jet);
  // At a pole the points of a parameter line should coincide and are scattered over its length l.
  // Where the line has grown to L, its direction is uncertain by l / L rad; up to a five-hundredth,
  // 0.1 degrees, it is taken.
  const double scatter = std::max(Precision::Confusion(), 500 * collapsed_mm_[s < 0.5 ? 0 : 1]);
  return {std::max(rounding / step_u_, scatter / range_u_),
          std::max(rounding / step_v_, scatter / range_v_)};
}

std::vector<double> FaceStrip::breaks() const {
  const std::vector<double> path_knots = curve_ ? knots(*curve_) : knots(path_);
  std::vector<double> at(path_knots.begin() + 1, path_knots.end() - 1);
  if (knots_u_.size() > 2 || knots_v_.size() > 2) {
    // Eight steps a piece find the crossings of a path that turns at most a few times between its
    // own knots.
    const int steps = !curve_ && path_.GetType() == GeomAbs_Line ? 1 : 8;
    for (std::size_t i = 1; i < path_knots.size(); ++i)
      addKnotCrossings(path_knots[i - 1], path_knots[i], steps, at);
  }
  const double length = pcurve_.last - pcurve_.first;
  for (double& t : at) t = (t - pcurve_.first) / length;
  return at;
}

void FaceStrip::addKnotCrossings(double first, double last, int steps,
                                 std::vector<double>& at) const {
  const double width = (last - first) / steps;
  gp_Pnt2d from = placeAt(first).uv;
  for (int k = 0; k < steps; ++k) {
    const double t0 = first + k * width;
    const double t1 = k + 1 < steps ? t0 + width : last;
    const gp_Pnt2d to = placeAt(t1).uv;
    addCrossings([&](double t) { return placeAt(t).uv.X(); }, t0, t1, from.X(), to.X(), knots_u_,
                 at);
    addCrossings([&](double t) { return placeAt(t).uv.Y(); }, t0, t1, from.Y(), to.Y(), knots_v_,
                 at);
    from = to;
  }
}

}  // namespace seamwright::occ
