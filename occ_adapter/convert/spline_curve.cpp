// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom_BezierCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/bspline/knot_curve.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_curve.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// What Geom_BSplineCurve is made of.
struct Numbers {
  int degree;
  std::vector<double> knots;  ///< each once
  std::vector<int> multiplicities;
  HomogeneousPoles poles;
};

void requireApart(const std::vector<double>& knots) {
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i] - knots[i - 1] <= Epsilon(std::abs(knots[i - 1])))
      throw std::invalid_argument(
          "distinct knots " + std::to_string(i - 1) + " and " + std::to_string(i) + " are both " +
          std::to_string(knots[i]) +
          " to OpenCASCADE, which distinguishes knots by one part in 10^16");
}

handle<Geom_BSplineCurve> geomCurve(const Numbers& numbers, bool periodic) {
  requireApart(numbers.knots);
  const auto count = static_cast<int>(numbers.poles.rows()),
             breaks = static_cast<int>(numbers.knots.size());
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal weights(1, count), knots(1, breaks);
  TColStd_Array1OfInteger multiplicities(1, breaks);
  for (int i = 0; i < count; ++i) {
    const double w = numbers.poles(i, 3);
    poles(i + 1) =
        gp_Pnt(numbers.poles(i, 0) / w, numbers.poles(i, 1) / w, numbers.poles(i, 2) / w);
    weights(i + 1) = w;
  }
  std::ranges::copy(numbers.knots, knots.begin());
  std::ranges::copy(numbers.multiplicities, multiplicities.begin());
  try {
    return new Geom_BSplineCurve(poles, weights, knots, multiplicities, numbers.degree, periodic);
  } catch (const Standard_Failure& failure) {
    throw std::invalid_argument(std::string("OpenCASCADE takes no such spline curve: ") +
                                failure.GetMessageString());
  }
}

/// A closed spline with segments from its end put before its beginning, until they carry as many
/// knots as the degree.
BezierSpline unrolled(const BezierSpline& spline, int before) {
  BezierSpline result = spline;
  result.closed = false;
  const double period = spline.knots.back() - spline.knots.front();
  const int n = spline.degree, segments = spline.segments();
  result.poles.resize(spline.poles.rows() + static_cast<Eigen::Index>(before) * n, 4);
  result.poles.bottomRows(spline.poles.rows()) = spline.poles;
  for (int i = 1; i <= before; ++i) {
    const int turns = (i + segments - 1) / segments, from = turns * segments - i;
    result.knots.insert(result.knots.begin(), spline.knots[from] - turns * period);
    result.poles.middleRows(static_cast<Eigen::Index>(before - i) * n, n) =
        spline.poles.middleRows(static_cast<Eigen::Index>(from) * n, n);
  }
  return result;
}

/// Pole 1 of a periodic curve belongs to the knots that end with the last copy of the first one.
handle<Geom_BSplineCurve> periodicCurve(const BezierSpline& spline, int order) {
  if (const int around = continuity(spline, true); around < order)
    throw std::invalid_argument("the spline is C" + std::to_string(order) + " at its knots and " +
                                (spline.closed ? around < 0 ? std::string("has other weights")
                                                            : "C" + std::to_string(around)
                                               : std::string("not closed")) +
                                " at its seam: a periodic curve is as smooth at its seam");
  const int multiplicity = spline.degree - order,
            before = (spline.degree + multiplicity - 1) / multiplicity;
  const BSplineCurve whole = bsplineCurve(unrolled(spline, before), order);
  const Eigen::Index count = static_cast<Eigen::Index>(spline.segments()) * multiplicity;
  return geomCurve(
      {spline.degree, spline.knots, std::vector<int>(spline.knots.size(), multiplicity),
       whole.poles.middleRows(static_cast<Eigen::Index>(before) * multiplicity, count)},
      true);
}

KnotCurve numbersOf(const Geom_BSplineCurve& curve) {
  const TColStd_Array1OfReal& knots = curve.Knots();
  const TColStd_Array1OfInteger& multiplicities = curve.Multiplicities();
  KnotCurve result{curve.Degree(),
                   {knots.begin(), knots.end()},
                   {multiplicities.begin(), multiplicities.end()},
                   HomogeneousPoles(curve.NbPoles(), 4),
                   curve.IsPeriodic()};
  for (int i = 1; i <= curve.NbPoles(); ++i) {
    const gp_Pnt pole = curve.Pole(i);
    const double w = curve.Weight(i);
    result.poles.row(i - 1) << w * pole.X(), w * pole.Y(), w * pole.Z(), w;
  }
  return result;
}

BSplineCurve coreCurve(const Geom_Curve& curve, double first, double last) {
  if (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(&curve))
    return coreCurve(*trimmed->BasisCurve(), first, last);
  if (const auto* spline = dynamic_cast<const Geom_BSplineCurve*>(&curve))
    return clampedCurve(numbersOf(*spline), first, last);
  const auto* bezier = dynamic_cast<const Geom_BezierCurve*>(&curve);
  if (!bezier)
    throw std::domain_error(std::string(curve.DynamicType()->Name()) +
                            " is not a Bezier or B-spline curve");
  const BSplineCurve whole = splineCurve(bezierCurve(curve));
  const int ends = whole.degree + 1;
  return clampedCurve({whole.degree, {0, 1}, {ends, ends}, whole.poles}, first, last);
}

}  // namespace

handle<Geom_BSplineCurve> toBSplineCurve(const BSplineCurve& curve) {
  requireValid(curve);
  Numbers numbers{curve.degree, {}, {}, curve.poles};
  for (const double knot : curve.knots) {
    if (numbers.knots.empty() || knot > numbers.knots.back()) {
      numbers.knots.push_back(knot);
      numbers.multiplicities.push_back(0);
    }
    ++numbers.multiplicities.back();
  }
  return geomCurve(numbers, false);
}

handle<Geom_BSplineCurve> toBSplineCurve(const BezierSpline& spline, bool periodic) {
  const int order = continuity(spline);
  return periodic ? periodicCurve(spline, order) : toBSplineCurve(bsplineCurve(spline, order));
}

BSplineCurve coreCurve(const Geom_Curve& curve) {
  return coreCurve(curve, curve.FirstParameter(), curve.LastParameter());
}

}  // namespace seamwright::occ
