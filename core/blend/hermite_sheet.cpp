// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <seamwright/core/bezier/hermite.hpp>
#include <seamwright/core/blend/hermite_sheet.hpp>
#include <seamwright/core/bspline/curve.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

void requireSheetRibbon(const char* name, const SheetRibbon& ribbon) {
  if (ribbon.derivatives.empty()) refuse(fmt::format("{}: it has no position", name));
  for (std::size_t k = 0; k < ribbon.derivatives.size(); ++k) {
    BSplineCurve curve{ribbon.degree, ribbon.knots, {}};
    curve.poles.setOnes(ribbon.derivatives[k].rows(), 4);
    curve.poles.leftCols<3>() = ribbon.derivatives[k];
    try {
      requireValid(curve);
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("{}, derivative {}: {}", name, k, error.what()));
    }
  }
}

/// The derivatives of column i of poles across the sheet.
CurveDerivatives across(const SheetRibbon& ribbon, Eigen::Index i) {
  CurveDerivatives result(ribbon.order() + 1, 3);
  for (int k = 0; k <= ribbon.order(); ++k) result.row(k) = ribbon.derivatives[k].row(i);
  return result;
}

BSplineSurface sheetOf(const SheetRibbon& along, int degree_across) {
  BSplineSurface sheet;
  sheet.degree_u = along.degree;
  sheet.knots_u = along.knots;
  sheet.degree_v = degree_across;
  sheet.knots_v.assign(degree_across + 1, 0);
  sheet.knots_v.insert(sheet.knots_v.end(), degree_across + 1, 1);
  sheet.poles.setOnes(along.derivatives[0].rows() * (degree_across + 1), 4);
  return sheet;
}

}  // namespace

BSplineSurface hermiteSheet(const SheetRibbon& start, const SheetRibbon& end) {
  requireSheetRibbon("start", start);
  requireSheetRibbon("end", end);
  if (start.degree != end.degree || start.knots != end.knots)
    refuse("the ribbons of start and end differ in degree or knots");
  const int m = start.order(), n = end.order(), degree = m + n + 1;
  BSplineSurface sheet = sheetOf(start, degree);
  for (Eigen::Index i = 0; i < start.derivatives[0].rows(); ++i) {
    auto poles = sheet.poles.middleRows(i * (degree + 1), degree + 1).leftCols<3>();
    CurveDerivatives back = across(end, i);
    for (int k = 1; k <= n; k += 2) back.row(k) *= -1;
    poles.topRows(m + 1) = polesFrom(across(start, i), degree);
    poles.bottomRows(n + 1) = polesFrom(back, degree).colwise().reverse();
  }
  return sheet;
}

BSplineSurface taylorSheet(const SheetRibbon& start) {
  requireSheetRibbon("start", start);
  const int degree = start.order();
  if (degree < 1) refuse("the ribbon has no derivative");
  BSplineSurface sheet = sheetOf(start, degree);
  for (Eigen::Index i = 0; i < start.derivatives[0].rows(); ++i)
    sheet.poles.middleRows(i * (degree + 1), degree + 1).leftCols<3>() =
        polesFrom(across(start, i), degree);
  return sheet;
}

}  // namespace seamwright
