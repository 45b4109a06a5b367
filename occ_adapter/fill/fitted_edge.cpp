// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/fitted_edge.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector2d;

constexpr int pcurve_degree = 5;

/// Knots over the edge's range with their multiplicities.
struct PcurveKnots {
  std::vector<double> places;
  std::vector<int> times;

  std::vector<double> flat() const {
    std::vector<double> result;
    for (std::size_t k = 0; k < places.size(); ++k)
      result.insert(result.end(), static_cast<std::size_t>(times[k]), places[k]);
    return result;
  }
};

/// So many spans between the places where the edge's parametrisation has no third derivative. There
/// the pcurve may have a kink, as the arc length has one in its derivatives.
PcurveKnots pcurveKnots(const BoundaryEdge& edge, int spans) {
  GeomAdaptor_Curve curve(edge.curve, edge.first, edge.last);
  TColStd_Array1OfReal breaks(1, curve.NbIntervals(GeomAbs_C3) + 1);
  curve.Intervals(breaks, GeomAbs_C3);
  PcurveKnots knots{{edge.first}, {pcurve_degree + 1}};
  for (int piece = 1; piece < breaks.Length(); ++piece) {
    const double begin = knots.places.back(),
                 end = piece + 1 == breaks.Length() ? edge.last : breaks(piece + 1);
    for (int k = 1; k <= spans; ++k) {
      knots.places.push_back(k == spans ? end : begin + k * (end - begin) / spans);
      knots.times.push_back(k == spans ? pcurve_degree : 1);
    }
  }
  knots.times.back() = pcurve_degree + 1;
  return knots;
}

/// One row for each pole.
Eigen::MatrixXd interpolated(const std::function<Eigen::VectorXd(double)>& at,
                             const PcurveKnots& knots) {
  const GrevilleInterpolation interpolation(pcurve_degree, knots.flat());
  Eigen::MatrixXd values(static_cast<Eigen::Index>(interpolation.parameters().size()),
                         at(knots.places.front()).size());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    values.row(i) = at(interpolation.parameters()[static_cast<std::size_t>(i)]).transpose();
  return interpolation.poles(values);
}

struct KnotArrays {
  TColStd_Array1OfReal places;
  TColStd_Array1OfInteger times;

  explicit KnotArrays(const PcurveKnots& knots)
      : places(1, static_cast<int>(knots.places.size())),
        times(1, static_cast<int>(knots.places.size())) {
    for (int k = 1; k <= places.Length(); ++k) {
      places(k) = knots.places[static_cast<std::size_t>(k - 1)];
      times(k) = knots.times[static_cast<std::size_t>(k - 1)];
    }
  }
};

opencascade::handle<Geom2d_BSplineCurve> planarSpline(const Eigen::MatrixXd& poles,
                                                      const PcurveKnots& knots) {
  TColgp_Array1OfPnt2d points(1, static_cast<int>(poles.rows()));
  for (int i = 1; i <= points.Length(); ++i) points(i) = gp_Pnt2d(poles(i - 1, 0), poles(i - 1, 1));
  const KnotArrays arrays(knots);
  return new Geom2d_BSplineCurve(points, arrays.places, arrays.times, pcurve_degree);
}

opencascade::handle<Geom_BSplineCurve> spaceSpline(const Eigen::MatrixXd& poles,
                                                   const PcurveKnots& knots) {
  TColgp_Array1OfPnt points(1, static_cast<int>(poles.rows()));
  for (int i = 1; i <= points.Length(); ++i)
    points(i) = gp_Pnt(poles(i - 1, 0), poles(i - 1, 1), poles(i - 1, 2));
  const KnotArrays arrays(knots);
  return new Geom_BSplineCurve(points, arrays.places, arrays.times, pcurve_degree);
}

/// Parameters inside of the spans.
std::vector<double> checksOf(const PcurveKnots& knots) {
  std::vector<double> checks;
  for (std::size_t k = 0; k + 1 < knots.places.size(); ++k)
    for (const double share : {1 / 6.0, 0.5, 5 / 6.0})
      checks.push_back(std::lerp(knots.places[k], knots.places[k + 1], share));
  return checks;
}

}  // namespace

std::optional<BoundaryEdge> fittedEdge(const HoleEdge& hole_edge, const SidePath& path,
                                       const std::function<Vector2d(double)>& at, double near,
                                       double near_mm) {
  constexpr int most_spans = 256;
  std::optional<BoundaryEdge> edge = boundaryEdge(hole_edge);
  if (!edge) return std::nullopt;
  const auto shareOf = [&](double parameter) {
    const double s = std::clamp((parameter - edge->first) / (edge->last - edge->first), 0.0, 1.0);
    return hole_edge.reversed ? 1 - s : s;
  };
  const auto planar = [&](double parameter) { return at(shareOf(parameter)); };
  const auto spatial = [&](double parameter) { return path.atParameter(shareOf(parameter)).point; };
  PcurveKnots knots;
  opencascade::handle<Geom2d_BSplineCurve> pcurve;
  for (int spans = 4;; spans *= 2) {
    knots = pcurveKnots(*edge, spans);
    pcurve = planarSpline(interpolated(planar, knots), knots);
    double miss = 0;
    for (const double t : checksOf(knots)) {
      const gp_Pnt2d found = pcurve->Value(t);
      miss = std::max(miss, (Vector2d(found.X(), found.Y()) - planar(t)).norm());
    }
    if (miss <= near || 2 * static_cast<int>(knots.places.size()) > most_spans) break;
  }
  edge->on_surface = pcurve;
  const gp_Trsf placed = edge->location.Transformation();
  for (const double t : checksOf(knots))
    if ((vector(edge->curve->Value(t).Transformed(placed)) - spatial(t)).norm() > near_mm) {
      edge->curve = spaceSpline(interpolated(spatial, knots), knots);
      edge->location = TopLoc_Location();
      break;
    }
  return edge;
}

}  // namespace seamwright::occ
