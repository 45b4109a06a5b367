// SPDX-License-Identifier: LGPL-2.1-or-later
#include "match_pairs.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "dense_oracle.hpp"

#include <seamwright/occ_adapter/model/model.hpp>

namespace seamwright::test {

double random(std::mt19937& generator, double size) {
  return std::uniform_real_distribution<double>(-size, size)(generator);
}

Spline splineOf(const TColgp_Array2OfPnt& poles, int degree_u, int degree_v) {
  const auto knots = [](int count, int degree_along) {
    TColStd_Array1OfReal values(1, count - degree_along + 1);
    for (int i = 1; i <= values.Length(); ++i) values(i) = (i - 1.0) / (values.Length() - 1);
    return values;
  };
  const auto multiplicities = [](int count, int degree_along) {
    TColStd_Array1OfInteger values(1, count - degree_along + 1);
    values.Init(1);
    values(1) = values(values.Length()) = degree_along + 1;
    return values;
  };
  const int rows = poles.ColLength(), columns = poles.RowLength();
  return new Geom_BSplineSurface(poles, knots(rows, degree_u), knots(columns, degree_v),
                                 multiplicities(rows, degree_u), multiplicities(columns, degree_v),
                                 degree_u, degree_v);
}

Spline sheet(std::mt19937& generator, int rows, int columns, int degree_u, int degree_v) {
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      const double x = 60.0 * (i - 1) / (rows - 1), y = 40.0 * (j - 1) / (columns - 1);
      const double jitter = 4.0 / std::max(rows, columns);
      poles(i, j) =
          gp_Pnt(x + random(generator, jitter), y + random(generator, jitter),
                 6 * std::sin(x / 25) + 4 * std::cos(y / 20) + random(generator, jitter / 4));
    }
  return splineOf(poles, degree_u, degree_v);
}

std::array<Spline, 2> cutInTwo(const Spline& whole) {
  std::array<Spline, 2> parts;
  for (const int which : {0, 1}) {
    parts[which] = Spline::DownCast(whole->Copy());
    parts[which]->Segment(which == 0 ? 0 : 0.4, which == 0 ? 0.4 : 1, 0, 1);
  }
  return parts;
}

void disturb(const Spline& surface, std::mt19937& generator, int rows, double size) {
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= surface->NbVPoles(); ++j) {
      gp_Pnt pole = surface->Pole(i, j);
      pole.Translate(
          gp_Vec(random(generator, size), random(generator, size), random(generator, size)));
      surface->SetPole(i, j, pole);
    }
}

namespace {

/// Turned so that what was the side u = first (or last) becomes that side: 0: v first, 1: u last,
/// 2: v last, 3: u first.
Polygon withSide(const Spline& surface, bool at_last, int side) {
  const Spline turned = Spline::DownCast(surface->Copy());
  if (side == 0 || side == 2) turned->ExchangeUV();
  const bool wanted_last = side == 1 || side == 2;
  if (wanted_last != at_last) {
    if (side == 1 || side == 3)
      turned->UReverse();
    else
      turned->VReverse();
  }
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  turned->Bounds(u0, u1, v0, v1);
  const handle<Geom_Surface> placed(turned.get());
  return {placed, beginningWith(side, rectangle(u0, u1, v0, v1))};
}

}  // namespace

TopoDS_Shape withTolerance(const TopoDS_Shape& shape, double mm) {
  const BRep_Builder builder;
  for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_VERTEX}) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, kind, parts);
    for (int i = 1; i <= parts.Extent(); ++i)
      if (kind == TopAbs_EDGE)
        builder.UpdateEdge(TopoDS::Edge(parts(i)), mm);
      else
        builder.UpdateVertex(TopoDS::Vertex(parts(i)), mm);
  }
  return shape;
}

TopoDS_Shape joinedSheets(const std::array<Spline, 2>& parts, int side_a, int side_b) {
  return withTolerance(joined(withSide(parts[0], true, side_a), withSide(parts[1], false, side_b)),
                       0.3);
}

std::array<Spline, 2> disturbedSheets(std::mt19937& generator, double noise_mm) {
  std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
  disturb(parts[1], generator, 3, noise_mm);
  return parts;
}

TopoDS_Face face(const TopoDS_Shape& shape, int number) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return TopoDS::Face(faces(number));
}

namespace {

std::string bytesOf(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  occ::writeBinaryShape(shape, stream);
  return stream.str();
}

}  // namespace

void expectTolerancesHold(const TopoDS_Shape& shape) {
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      const TopoDS_Face& on = TopoDS::Face(faces.Current());
      double first = 0, last = 0, path_first = 0, path_last = 0, worst = 0;
      const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
      const handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(edge, on, path_first, path_last);
      ASSERT_FALSE(curve.IsNull() || path.IsNull());
      const handle<Geom_Surface> surface = BRep_Tool::Surface(on);
      for (int k = 0; k <= 700; ++k) {
        const double share = k / 700.0;
        const gp_Pnt2d uv = path->Value(path_first + share * (path_last - path_first));
        worst = std::max(
            worst,
            surface->Value(uv.X(), uv.Y()).Distance(curve->Value(first + share * (last - first))));
      }
      EXPECT_LE(worst, BRep_Tool::Tolerance(edge));
      for (const bool at_start : {true, false}) {
        const TopoDS_Vertex vertex =
            at_start ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
        EXPECT_LE(curve->Value(at_start ? first : last).Distance(BRep_Tool::Pnt(vertex)),
                  BRep_Tool::Tolerance(vertex));
      }
    }
}

void expectMatched(const MatchReport& report, const FaceMatchOptions& options,
                   const std::string& what) {
  SCOPED_TRACE(what + ": " + report.text());
  ASSERT_TRUE(report.matched);
  EXPECT_TRUE(BRepCheck_Analyzer(report.shape).IsValid());
  EXPECT_EQ(report.after.faces, (std::array<int, 2>{1, 2}));
  // A change near a boundary keeps the edges: free ones stay free, and those of the face that stays
  // keep their tolerances.
  if (report.depth_mm > 0 && report.after.kind == occ::SeamKind::Matched) return;
  if (report.depth_mm == 0) expectTolerancesHold(report.shape);
  EXPECT_EQ(report.shape.ShapeType(), TopAbs_SHELL);
  EXPECT_EQ(report.after.kind, occ::SeamKind::Shared);
  ASSERT_EQ(report.after.edges.size(), 1);
  const auto sides = denseSides(report.shape, report.after.edges[0], {1, 2});
  ASSERT_TRUE(sides);
  const DenseMaxima dense = denseMaxima(*sides, 1001, options.tolerance);
  EXPECT_LE(dense.gap_mm.sure(), options.tolerance.gap_mm);
  ASSERT_TRUE(dense.angle_rad);
  EXPECT_LE(dense.angle_rad->sure(), options.tolerance.angle_rad);
  EXPECT_FALSE(dense.fold);
  if (options.order == 2) {
    EXPECT_LE(dense.curvature_rel.sure(), options.tolerance.curvature_rel);
  }
  // Enclosures hold what was seen.
  EXPECT_GE(*report.after.figures.gap_mm->upper, dense.gap_mm.sure());
  EXPECT_GE(*report.after.figures.angle_rad->upper, dense.angle_rad->sure());
  if (report.exact) {
    EXPECT_LE(dense.gap_mm.sure(), 1e-11);
    EXPECT_LE(dense.angle_rad->sure(), 1e-11);
    if (options.order == 2) {
      EXPECT_LE(dense.curvature_rel.sure(), 1e-7);
    }
  }
}

MatchReport matchedPair(const TopoDS_Shape& shape, const FaceMatchOptions& options,
                        const std::string& what) {
  const std::string before = bytesOf(shape);
  const MatchReport report = matchFaces(shape, 1, 2, options);
  EXPECT_EQ(bytesOf(shape), before) << what;
  expectMatched(report, options, what);
  return report;
}

TopoDS_Shape loose(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  builder.Add(compound, a);
  builder.Add(compound, b);
  return compound;
}

handle<Geom2d_BSplineCurve> curvedPath(const std::vector<gp_Pnt2d>& points) {
  const int count = static_cast<int>(points.size());
  TColgp_Array1OfPnt2d poles(1, count);
  for (int i = 1; i <= count; ++i) poles(i) = points[i - 1];
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(count);
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, count - 1);
}

TopoDS_Face trimmedFace(const handle<Geom_Surface>& surface,
                        const handle<Geom2d_BSplineCurve>& path, const gp_Vec2d& shift) {
  const auto edge = [&](const handle<Geom2d_Curve>& curve, double last) {
    return BRepBuilderAPI_MakeEdge(curve, surface, 0, last).Edge();
  };
  const handle<Geom2d_BSplineCurve> far =
      handle<Geom2d_BSplineCurve>::DownCast(path->Translated(shift));
  far->Reverse();
  const auto line = [&](const gp_Pnt2d& p, const gp_Pnt2d& q) { return curvedPath({p, q}); };
  BRepBuilderAPI_MakeWire wire;
  wire.Add(edge(path, 1));
  wire.Add(edge(line(path->EndPoint(), far->StartPoint()), 1));
  wire.Add(edge(far, 1));
  wire.Add(edge(line(far->EndPoint(), path->StartPoint()), 1));
  TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, wire.Wire(), true).Face();
  BRepLib::BuildCurves3d(face);
  return face;
}

Spline stripBeside(const handle<Geom_Surface>& surface, const handle<Geom2d_BSplineCurve>& path,
                   const gp_Vec2d& shift, int points, std::mt19937& generator, double noise_mm) {
  constexpr int rows = 4;
  std::vector<handle<Geom_BSplineCurve>> curves;
  for (int r = 0; r < rows; ++r) {
    const handle<TColgp_HArray1OfPnt> through = new TColgp_HArray1OfPnt(1, points);
    const handle<TColStd_HArray1OfReal> at = new TColStd_HArray1OfReal(1, points);
    for (int k = 0; k < points; ++k) {
      const double t = static_cast<double>(k) / (points - 1);
      const gp_Pnt2d uv = path->Value(t).Translated(shift * (r / 3.0));
      gp_Pnt p = surface->Value(uv.X(), uv.Y());
      if (r == rows - 1) p.Translate(gp_Vec(0.5, 0.3, 1.0));
      p.Translate(gp_Vec(random(generator, noise_mm), random(generator, noise_mm),
                         random(generator, noise_mm)));
      through->SetValue(k + 1, p);
      at->SetValue(k + 1, t);
    }
    GeomAPI_Interpolate interpolation(through, at, false, 1e-9);
    interpolation.Perform();
    curves.push_back(interpolation.Curve());
  }
  const int columns = curves[0]->NbPoles();
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int r = 0; r < rows; ++r)
    for (int j = 1; j <= columns; ++j) poles(r + 1, j) = curves[r]->Pole(j);
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(rows);
  return new Geom_BSplineSurface(poles, knots, curves[0]->Knots(), multiplicities,
                                 curves[0]->Multiplicities(), rows - 1, 3);
}

TopoDS_Face wholeFace(const Spline& surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

std::vector<Trimmed> trimmedKinds() {
  const handle<Geom2d_BSplineCurve> on_plane =
      curvedPath({{0, 0}, {10, 3}, {20, -4}, {30, 2}, {40, 0}});
  const handle<Geom2d_BSplineCurve> on_round =
      curvedPath({{0, 0}, {0.3, 0.1}, {0.6, -0.15}, {0.9, 0.05}});
  const handle<Geom2d_BSplineCurve> on_cylinder =
      curvedPath({{0, 0}, {0.3, 3}, {0.6, -4}, {0.9, 2}});
  return {{"plane", new Geom_Plane(gp::XOY()), on_plane, gp_Vec2d(0, -20), gp_Vec2d(0, 15)},
          {"cylinder", new Geom_CylindricalSurface(gp::XOY(), 30), on_cylinder, gp_Vec2d(0, -20),
           gp_Vec2d(0, 12)},
          {"sphere", new Geom_SphericalSurface(gp::XOY(), 40), on_round, gp_Vec2d(0, -0.5),
           gp_Vec2d(0, 0.3)}};
}

FaceMatchOptions ofOrder(int order) {
  FaceMatchOptions options;
  options.order = order;
  return options;
}

FaceMatchOptions strict(int order) {
  FaceMatchOptions options = ofOrder(order);
  options.tolerance.gap_mm = 1e-4;
  options.tolerance.angle_rad = 0.001 * degree;
  options.tolerance.curvature_rel = 1e-3;
  return options;
}

int edgeNear(const TopoDS_Shape& shape, const gp_Pnt& point) {
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  int nearest = 0;
  double least = HUGE_VAL;
  for (int i = 1; i <= edges.Extent(); ++i) {
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(TopoDS::Edge(edges(i)), first, last);
    if (curve.IsNull()) continue;
    const double distance = curve->Value((first + last) / 2).Distance(point);
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace seamwright::test
