// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact_seam.hpp"

#include <BRep_Tool.hxx>
#include <Eigen/Dense>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace seamwright::test {

namespace {

using opencascade::handle;
__extension__ using Quad = __float128;
using Vec = std::array<Quad, 3>;
using Tensor = std::array<Vec, 3>;

Vec operator+(const Vec& a, const Vec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec operator*(Quad f, const Vec& a) {
  return {f * a[0], f * a[1], f * a[2]};
}
Quad dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Quad squareRoot(Quad x) {
  if (x <= 0) return 0;
  Quad root = static_cast<Quad>(std::sqrt(static_cast<long double>(x)));
  for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
  return root;
}

Vec exact(const gp_XYZ& p) {
  return {p.X(), p.Y(), p.Z()};
}

/// Values, first and second derivatives of the basis functions of a span at x.
struct Basis {
  int first = 0;  ///< pole of the first one, from 0
  std::array<std::vector<Quad>, 3> d;
};

std::vector<Quad> basisValues(const std::vector<double>& knots, int span, int degree, Quad x) {
  std::vector<Quad> n = {1};
  for (int d = 1; d <= degree; ++d) {
    std::vector<Quad> next(d + 1, 0);
    for (int j = 0; j < d; ++j) {
      const Quad left = knots[span + 1 - d + j], right = knots[span + 1 + j];
      next[j] += (right - x) / (right - left) * n[j];
      next[j + 1] += (x - left) / (right - left) * n[j];
    }
    n = next;
  }
  return n;
}

/// From the coefficients of derivatives of a lower degree to those of the next.
std::vector<Quad> raised(const std::vector<double>& knots, int span, int degree,
                         const std::vector<Quad>& lower) {
  std::vector<Quad> result(degree + 1, 0);
  for (int j = 0; j < degree; ++j) {
    const Quad factor = degree / (Quad(knots[span + 1 + j]) - Quad(knots[span + 1 - degree + j]));
    result[j] -= factor * lower[j];
    result[j + 1] += factor * lower[j];
  }
  return result;
}

/// \param hint a point of the span that is meant.
Basis basisAt(const std::vector<double>& knots, int degree, Quad x, double hint) {
  int span = degree;
  for (int k = degree; k + degree + 1 < static_cast<int>(knots.size()); ++k)
    if (knots[k] < knots[k + 1] && knots[k] <= hint) span = k;
  if (hint < knots[degree])
    span = static_cast<int>(std::upper_bound(knots.begin(), knots.end(), knots[degree]) -
                            knots.begin()) -
           1;
  Basis basis;
  basis.first = span - degree;
  basis.d[0] = basisValues(knots, span, degree, x);
  basis.d[1] = basis.d[2] = std::vector<Quad>(degree + 1, 0);
  if (degree > 0) basis.d[1] = raised(knots, span, degree, basisValues(knots, span, degree - 1, x));
  if (degree > 1)
    basis.d[2] = raised(knots, span, degree,
                        raised(knots, span, degree - 1, basisValues(knots, span, degree - 2, x)));
  return basis;
}

std::vector<double> flat(const TColStd_Array1OfReal& knots) {
  return {knots.begin(), knots.end()};
}

struct PathPoint2d {
  Quad u = 0, v = 0;
  double du = 0, dv = 0;
};

std::optional<PathPoint2d> pathAt(handle<Geom2d_Curve> curve, Quad t) {
  while (const auto trimmed = handle<Geom2d_TrimmedCurve>::DownCast(curve))
    curve = trimmed->BasisCurve();
  if (const auto line = handle<Geom2d_Line>::DownCast(curve)) {
    const gp_Pnt2d p = line->Location();
    const gp_Dir2d d = line->Direction();
    return PathPoint2d{p.X() + t * d.X(), p.Y() + t * d.Y(), d.X(), d.Y()};
  }
  const auto spline = handle<Geom2d_BSplineCurve>::DownCast(curve);
  if (spline.IsNull() || spline->IsPeriodic()) return std::nullopt;
  const Basis basis =
      basisAt(flat(spline->KnotSequence()), spline->Degree(), t, static_cast<double>(t));
  std::array<Quad, 3> h{}, d{};
  for (int i = 0; i <= spline->Degree(); ++i) {
    const gp_Pnt2d pole = spline->Pole(basis.first + i + 1);
    const Quad weight = spline->Weight(basis.first + i + 1);
    const std::array<Quad, 3> p = {weight * pole.X(), weight * pole.Y(), weight};
    for (int c = 0; c < 3; ++c) h[c] += basis.d[0][i] * p[c], d[c] += basis.d[1][i] * p[c];
  }
  const Quad u = h[0] / h[2], v = h[1] / h[2];
  return PathPoint2d{u, v, static_cast<double>((d[0] - d[2] * u) / h[2]),
                     static_cast<double>((d[1] - d[2] * v) / h[2])};
}

struct ExactJet {
  Vec p, u, v, uu, uv, vv;
};

ExactJet splineJet(const Geom_BSplineSurface& surface, const PathPoint2d& at, double hint_u,
                   double hint_v) {
  const Basis bu = basisAt(flat(surface.UKnotSequence()), surface.UDegree(), at.u, hint_u);
  const Basis bv = basisAt(flat(surface.VKnotSequence()), surface.VDegree(), at.v, hint_v);
  constexpr std::array<std::array<int, 2>, 6> orders = {
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  std::array<Vec, 6> h{};
  std::array<Quad, 6> w{};
  // About a pole, so that what cancels is small.
  const Vec origin = exact(surface.Pole(bu.first + 1, bv.first + 1).XYZ());
  for (int i = 0; i <= surface.UDegree(); ++i)
    for (int j = 0; j <= surface.VDegree(); ++j) {
      const Quad weight = surface.Weight(bu.first + i + 1, bv.first + j + 1);
      const Vec pole =
          exact(surface.Pole(bu.first + i + 1, bv.first + j + 1).XYZ()) + Quad(-1) * origin;
      for (int k = 0; k < 6; ++k) {
        const Quad factor = bu.d[orders[k][0]][i] * bv.d[orders[k][1]][j] * weight;
        h[k] = h[k] + factor * pole;
        w[k] += factor;
      }
    }
  ExactJet jet = {};
  const Quad inverse = 1 / w[0];
  jet.p = inverse * h[0];
  jet.u = inverse * (h[1] + -w[1] * jet.p);
  jet.v = inverse * (h[2] + -w[2] * jet.p);
  jet.uu = inverse * (h[3] + -2 * w[1] * jet.u + -w[3] * jet.p);
  jet.uv = inverse * (h[4] + -w[1] * jet.v + -w[2] * jet.u + -w[4] * jet.p);
  jet.vv = inverse * (h[5] + -2 * w[2] * jet.v + -w[5] * jet.p);
  jet.p = jet.p + origin;
  return jet;
}

/// Off a knot that the path runs along, to the side of the face.
double hintAt(const std::vector<double>& knots, double value, double into) {
  const double range = knots.back() - knots.front();
  for (const double knot : knots)
    if (std::abs(value - knot) < 1e-10 * range && into != 0)
      return knot + std::copysign(1e-9 * range, into);
  return value;
}

std::optional<ExactJet> jetOf(const occ::Coedge& use, const occ::Pcurve& pcurve, double s) {
  TopLoc_Location location;
  handle<Geom_Surface> surface = BRep_Tool::Surface(use.shape, location);
  while (const auto trimmed = handle<Geom_RectangularTrimmedSurface>::DownCast(surface))
    surface = trimmed->BasisSurface();
  const auto at =
      pathAt(pcurve.curve, pcurve.first + Quad(s) * (Quad(pcurve.last) - Quad(pcurve.first)));
  if (!location.IsIdentity() || !at) return std::nullopt;
  if (const auto plane = handle<Geom_Plane>::DownCast(surface)) {
    const gp_Ax3 frame = plane->Position();
    const Vec x = exact(frame.XDirection().XYZ()), y = exact(frame.YDirection().XYZ());
    return ExactJet{exact(frame.Location().XYZ()) + at->u * x + at->v * y, x, y, {}, {}, {}};
  }
  if (!handle<Geom_BezierSurface>::DownCast(surface).IsNull())
    surface = GeomConvert::SurfaceToBSplineSurface(surface);
  const auto spline = handle<Geom_BSplineSurface>::DownCast(surface);
  if (spline.IsNull() || spline->IsUPeriodic() || spline->IsVPeriodic()) return std::nullopt;
  const double into = use.edge.Orientation() == TopAbs_FORWARD ? 1 : -1;
  // Only along a line of constant u (or v) does the side count.
  const bool along_v = std::abs(at->du) < 1e-9 * std::abs(at->dv),
             along_u = std::abs(at->dv) < 1e-9 * std::abs(at->du);
  return splineJet(*spline, *at,
                   hintAt(flat(spline->UKnotSequence()), static_cast<double>(at->u),
                          along_v ? -into * at->dv : 0),
                   hintAt(flat(spline->VKnotSequence()), static_cast<double>(at->v),
                          along_u ? into * at->du : 0));
}

struct Side {
  Vec normal;
  Tensor tensor;
};

Tensor operator*(Quad f, const Tensor& k) {
  return {f * k[0], f * k[1], f * k[2]};
}
Tensor operator+(const Tensor& a, const Tensor& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Tensor product(const Vec& a, const Vec& b) {
  return {a[0] * b, a[1] * b, a[2] * b};
}

std::optional<Side> sideOf(const ExactJet& jet) {
  const Vec c = cross(jet.u, jet.v);
  const Quad length = squareRoot(dot(c, c));
  if (length == 0) return std::nullopt;
  const Vec n = (1 / length) * c;
  const Vec a = (1 / length) * cross(jet.v, n), b = (1 / length) * cross(n, jet.u);
  const Quad l = dot(n, jet.uu), m = dot(n, jet.uv), k = dot(n, jet.vv);
  return Side{n, l * product(a, a) + m * (product(a, b) + product(b, a)) + k * product(b, b)};
}

double norm(const Tensor& k) {
  Quad largest = 0;
  for (const Vec& row : k)
    for (const Quad x : row) largest = std::max(largest, x < 0 ? -x : x);
  if (largest == 0) return 0;
  Eigen::Matrix3d scaled;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scaled(i, j) = static_cast<double>(k[i][j] / largest);
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scaled).eigenvalues();
  return static_cast<double>(largest) * values.cwiseAbs().maxCoeff();
}

/// The tensor turned by the rotation that takes b to a.
Tensor turned(const Tensor& k, const Vec& b, const Vec& a) {
  const Vec s = a + b;
  const Quad factor = 1 / (1 + dot(a, b));
  Tensor rotation{};  // I - s s^T / (1 + a.b) + 2 a b^T
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      rotation[i][j] = Quad(i == j ? 1 : 0) - factor * s[i] * s[j] + 2 * a[i] * b[j];
  Tensor result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int p = 0; p < 3; ++p)
        for (int q = 0; q < 3; ++q) result[i][j] += rotation[i][p] * k[p][q] * rotation[j][q];
  return result;
}

}  // namespace

std::optional<ExactMeasure> exactMeasure(const occ::Seam& seam,
                                         const std::array<occ::Pcurve, 2>& pcurves, double s,
                                         double flat_radius_mm) {
  std::array<std::optional<Side>, 2> sides;
  for (const int i : {0, 1}) {
    const std::optional<ExactJet> jet = jetOf(seam.sides[i], pcurves[i], s);
    if (jet) sides[i] = sideOf(*jet);
    if (!sides[i]) return std::nullopt;
  }
  const Side& a = *sides[0];
  const Quad sense = dot(a.normal, sides[1]->normal) < 0 ? -1 : 1;
  const Side b = {sense * sides[1]->normal, sense * sides[1]->tensor};
  const Vec sine = cross(a.normal, b.normal);
  ExactMeasure measure;
  measure.angle_rad = std::atan2(static_cast<double>(squareRoot(dot(sine, sine))),
                                 static_cast<double>(dot(a.normal, b.normal)));
  const Tensor tensor_b = turned(b.tensor, b.normal, a.normal);
  measure.curvature_per_mm = norm(tensor_b + Quad(-1) * a.tensor);
  measure.curvature_rel = relativeDifference(
      {measure.curvature_per_mm, norm(a.tensor), norm(b.tensor)}, flat_radius_mm);
  return measure;
}

}  // namespace seamwright::test
