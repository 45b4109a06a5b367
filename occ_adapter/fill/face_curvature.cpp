// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/fill/face_curvature.hpp>

namespace seamwright::occ {

namespace {

/// The larger principal curvature.
double largestOf(BRepLProp_SLProps& at) {
  return std::max(std::abs(at.MaxCurvature()), std::abs(at.MinCurvature()));
}

}  // namespace

std::optional<double> largestCurvatureAlong_per_mm(const TopoDS_Edge& edge,
                                                   const TopoDS_Face& face) {
  constexpr int count = 16;  // a choice: a figure for people
  std::optional<double> largest;
  try {
    const BRepAdaptor_Curve2d path(edge, face);
    BRepLProp_SLProps at(BRepAdaptor_Surface(face), 2, Precision::Confusion());
    for (int i = 0; i < count; ++i) {
      const double share = (i + 0.5) / count;
      const gp_Pnt2d uv =
          path.Value((1 - share) * path.FirstParameter() + share * path.LastParameter());
      at.SetParameters(uv.X(), uv.Y());
      if (at.IsCurvatureDefined()) largest = std::max(largest.value_or(0), largestOf(at));
    }
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
  return largest;
}

std::optional<Bends> bendsOf(const std::vector<TopoDS_Shape>& faces) {
  constexpr int count = 16;  // a choice, in each direction: a figure for people
  std::optional<Bends> bends;
  try {
    for (const TopoDS_Shape& shape : faces) {
      const TopoDS_Face face = TopoDS::Face(shape);
      const double sense = face.Orientation() == TopAbs_REVERSED ? -1 : 1;
      double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
      BRepTools::UVBounds(face, u0, u1, v0, v1);
      const BRepTopAdaptor_FClass2d inside(face, Precision::PConfusion());
      BRepLProp_SLProps at(BRepAdaptor_Surface(face), 2, Precision::Confusion());
      for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
          const double u = u0 + (i + 0.5) / count * (u1 - u0),
                       v = v0 + (j + 0.5) / count * (v1 - v0);
          if (inside.Perform(gp_Pnt2d(u, v)) != TopAbs_IN) continue;
          at.SetParameters(u, v);
          if (!at.IsCurvatureDefined()) continue;
          if (!bends) bends = Bends{};
          const double mean = sense * at.MeanCurvature();
          bends->largest_per_mm = std::max(bends->largest_per_mm, largestOf(at));
          bends->mean_per_mm = {std::min(bends->mean_per_mm.lower, mean),
                                std::max(bends->mean_per_mm.upper, mean)};
        }
    }
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
  return bends;
}

}  // namespace seamwright::occ
