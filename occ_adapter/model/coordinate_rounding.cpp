// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <seamwright/occ_adapter/model/coordinate_rounding.hpp>

namespace seamwright::occ {

namespace {

double coordinateRounding_mm(const TopoDS_Shape& shape) {
  double size = 0;
  for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next()) {
    const gp_XYZ point = BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).XYZ();
    for (int i = 1; i <= 3; ++i)
      if (std::isfinite(point.Coord(i)) && !Precision::IsInfinite(point.Coord(i)))
        size = std::max(size, std::abs(point.Coord(i)));
  }
  // A point of each of two sides comes from some operations on coordinates of this size.
  return 16 * std::numeric_limits<double>::epsilon() * size;
}

}  // namespace

void requireAboveRounding(const char* what, double mm, const TopoDS_Shape& shape) {
  const double rounding_mm = coordinateRounding_mm(shape);
  if (mm >= rounding_mm) return;
  throw std::invalid_argument(fmt::format(
      "{} is {:.6g} mm: it must be at least {:.6g} mm, the rounding of this model's coordinates",
      what, mm, rounding_mm));
}

}  // namespace seamwright::occ
