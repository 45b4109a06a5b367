// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
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
#include <filesystem>
#include <functional>
#include <numbers>
#include <sstream>

#include "dense_oracle.hpp"
#include "files.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/match/match.hpp>
#include <seamwright/occ_adapter/model/read.hpp>

namespace seamwright::test {
namespace {

using occ::FaceMatchOptions;
using occ::matchFaces;
using occ::MatchMoves;
using occ::MatchReport;
using opencascade::handle;
using Spline = handle<Geom_BSplineSurface>;

double random(std::mt19937& generator, double size = 1) {
  return std::uniform_real_distribution<double>(-size, size)(generator);
}

Spline splineOf(const TColgp_Array2OfPnt& poles, int degree_u, int degree_v) {
  const auto knots = [](int count, int degree) {
    TColStd_Array1OfReal values(1, count - degree + 1);
    for (int i = 1; i <= values.Length(); ++i) values(i) = (i - 1.0) / (values.Length() - 1);
    return values;
  };
  const auto multiplicities = [](int count, int degree) {
    TColStd_Array1OfInteger values(1, count - degree + 1);
    values.Init(1);
    values(1) = values(values.Length()) = degree + 1;
    return values;
  };
  const int rows = poles.ColLength(), columns = poles.RowLength();
  return new Geom_BSplineSurface(poles, knots(rows, degree_u), knots(columns, degree_v),
                                 multiplicities(rows, degree_u), multiplicities(columns, degree_v), degree_u,
                                 degree_v);
}

/// A gently curved sheet of 60 mm by 40 mm.
Spline sheet(std::mt19937& generator, int rows, int columns, int degree_u, int degree_v) {
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      const double x = 60.0 * (i - 1) / (rows - 1), y = 40.0 * (j - 1) / (columns - 1);
      const double jitter = 4.0 / std::max(rows, columns);
      poles(i, j) = gp_Pnt(x + random(generator, jitter), y + random(generator, jitter),
                           6 * std::sin(x / 25) + 4 * std::cos(y / 20) + random(generator, jitter / 4));
    }
  return splineOf(poles, degree_u, degree_v);
}

/// The sheet cut at u = 0.4: two surfaces that join smoothly, and share nothing.
std::array<Spline, 2> cutInTwo(const Spline& whole) {
  std::array<Spline, 2> parts;
  for (const int which : {0, 1}) {
    parts[which] = Spline::DownCast(whole->Copy());
    parts[which]->Segment(which == 0 ? 0 : 0.4, which == 0 ? 0.4 : 1, 0, 1);
  }
  return parts;
}

/// Moves the poles of the first rows behind u = first.
void disturb(const Spline& surface, std::mt19937& generator, int rows, double size) {
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= surface->NbVPoles(); ++j) {
      gp_Pnt pole = surface->Pole(i, j);
      pole.Translate(gp_Vec(random(generator, size), random(generator, size), random(generator, size)));
      surface->SetPole(i, j, pole);
    }
}

/// Turned so that what was the side u = first (or last) becomes that side: 0: v first, 1: u last, 2: v last, 3: u first.
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

/// The edges keep what the gap needs, as those of valid models do.
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

TopoDS_Shape joinedSheets(const std::array<Spline, 2>& parts, int side_a = 1, int side_b = 3) {
  return withTolerance(joined(withSide(parts[0], true, side_a), withSide(parts[1], false, side_b)), 0.3);
}

TopoDS_Face face(const TopoDS_Shape& shape, int number) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return TopoDS::Face(faces(number));
}

std::string bytesOf(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  occ::writeBinaryShape(shape, stream);
  return stream.str();
}

/// Every path lies within the tolerance of its edge from the curve in space, and the ends of the curve within that of their vertices.
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
            worst, surface->Value(uv.X(), uv.Y()).Distance(curve->Value(first + share * (last - first))));
      }
      EXPECT_LE(worst, BRep_Tool::Tolerance(edge));
      for (const bool at_start : {true, false}) {
        const TopoDS_Vertex vertex = at_start ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
        EXPECT_LE(curve->Value(at_start ? first : last).Distance(BRep_Tool::Pnt(vertex)),
                  BRep_Tool::Tolerance(vertex));
      }
    }
}

/// What is promised of a pair that is matched, seen by plain evaluation.
void expectMatched(const MatchReport& report, const FaceMatchOptions& options, const std::string& what) {
  SCOPED_TRACE(what + ": " + report.reason);
  ASSERT_TRUE(report.matched);
  EXPECT_TRUE(BRepCheck_Analyzer(report.shape).IsValid());
  EXPECT_EQ(report.shape.ShapeType(), TopAbs_SHELL);
  expectTolerancesHold(report.shape);
  EXPECT_EQ(report.after.faces, (std::array<int, 2>{1, 2}));
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

MatchReport matchedPair(const TopoDS_Shape& shape, const FaceMatchOptions& options, const std::string& what) {
  const std::string before = bytesOf(shape);
  const MatchReport report = matchFaces(shape, 1, 2, options);
  EXPECT_EQ(bytesOf(shape), before) << what;
  expectMatched(report, options, what);
  return report;
}

/// Two loose faces.
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

/// The part of a surface between a curved path and the same path shifted.
TopoDS_Face trimmedFace(const handle<Geom_Surface>& surface, const handle<Geom2d_BSplineCurve>& path,
                        const gp_Vec2d& shift) {
  const auto edge = [&](const handle<Geom2d_Curve>& curve, double last) {
    return BRepBuilderAPI_MakeEdge(curve, surface, 0, last).Edge();
  };
  const handle<Geom2d_BSplineCurve> far = handle<Geom2d_BSplineCurve>::DownCast(path->Translated(shift));
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

/// A strip of degree 3 by 3 whose rows run through points of a surface over a path that is shifted away more and more: it nearly
/// continues the surface. Row 4 leaves it.
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
      p.Translate(
          gp_Vec(random(generator, noise_mm), random(generator, noise_mm), random(generator, noise_mm)));
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

struct Trimmed {
  std::string name;
  handle<Geom_Surface> surface;
  handle<Geom2d_BSplineCurve> path;
  gp_Vec2d into, away;
};

std::vector<Trimmed> trimmedKinds() {
  const handle<Geom2d_BSplineCurve> on_plane = curvedPath({{0, 0}, {10, 3}, {20, -4}, {30, 2}, {40, 0}});
  const handle<Geom2d_BSplineCurve> on_round = curvedPath({{0, 0}, {0.3, 0.1}, {0.6, -0.15}, {0.9, 0.05}});
  const handle<Geom2d_BSplineCurve> on_cylinder = curvedPath({{0, 0}, {0.3, 3}, {0.6, -4}, {0.9, 2}});
  return {
      {"plane", new Geom_Plane(gp::XOY()), on_plane, gp_Vec2d(0, -20), gp_Vec2d(0, 15)},
      {"cylinder", new Geom_CylindricalSurface(gp::XOY(), 30), on_cylinder, gp_Vec2d(0, -20),
       gp_Vec2d(0, 12)},
      {"sphere", new Geom_SphericalSurface(gp::XOY(), 40), on_round, gp_Vec2d(0, -0.5), gp_Vec2d(0, 0.3)}};
}

FaceMatchOptions ofOrder(int order) {
  FaceMatchOptions options;
  options.order = order;
  return options;
}

/// So that noise of 0.001 mm is a defect.
FaceMatchOptions strict(int order) {
  FaceMatchOptions options = ofOrder(order);
  options.tolerance.gap_mm = 1e-4;
  options.tolerance.angle_rad = 0.001 * degree;
  options.tolerance.curvature_rel = 1e-3;
  return options;
}

TEST(MatchFaces, SheetsThatWereOneAreJoinedInPolesOnAllSides) {
  std::mt19937 generator(2);
  const double noises[] = {0.001, 0.01, 0.1};
  for (int side_a = 0; side_a < 4; ++side_a)
    for (int side_b = 0; side_b < 4; ++side_b) {
      const int order = 1 + (side_a + side_b) % 2, degree_v = 3 + side_b % 2;
      std::array<Spline, 2> parts =
          cutInTwo(sheet(generator, 9, 4 + 2 * side_a, 5, std::min(degree_v, 3 + 2 * side_a)));
      disturb(parts[1], generator, 3, noises[(side_a + 2 * side_b) % 3]);
      const std::string what =
          std::to_string(side_a) + "-" + std::to_string(side_b) + " G" + std::to_string(order);
      const MatchReport report = matchedPair(joinedSheets(parts, side_a, side_b), strict(order), what);
      EXPECT_TRUE(report.exact) << what << report.reason;
    }
}

TEST(MatchFaces, AStripFollowsATrimmedFace) {
  std::mt19937 generator(1);
  for (const Trimmed& kind : trimmedKinds())
    for (const int order : {1, 2}) {
      const TopoDS_Shape pair =
          loose(trimmedFace(kind.surface, kind.path, kind.into),
                wholeFace(stripBeside(kind.surface, kind.path, kind.away, 9, generator, 0.01)));
      const MatchReport report = matchedPair(pair, ofOrder(order), kind.name + " G" + std::to_string(order));
      EXPECT_FALSE(report.exact);
      EXPECT_EQ(report.before.kind, occ::SeamKind::Matched);
    }
}

/// Two sheets that were one, disturbed.
std::array<Spline, 2> disturbedSheets(std::mt19937& generator, double noise_mm) {
  std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
  disturb(parts[1], generator, 3, noise_mm);
  return parts;
}

/// A point in the middle of a face and its normal out of it.
std::pair<gp_Pnt, gp_Vec> middle(const TopoDS_Face& face) {
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face);
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  gp_Pnt p;
  gp_Vec u, v;
  surface->D1((u0 + u1) / 2, (v0 + v1) / 2, p, u, v);
  const gp_Vec normal = u.Crossed(v).Normalized();
  return {p, face.Orientation() == TopAbs_REVERSED ? -normal : normal};
}

TEST(MatchFaces, PlacedMirroredAndReversedFacesKeepTheirSense) {
  std::mt19937 generator(3);
  gp_Trsf mirror, scale;
  mirror.SetMirror(gp_Ax2(gp_Pnt(3, 4, 5), gp_Dir(1, 2, 3)));
  scale.SetScale(gp_Pnt(1, 1, 1), 0.5);
  for (int order = 1; order <= 2; ++order)
    for (int k = 0; k < 4; ++k) {
      const std::array<gp_Trsf, 4> by = {randomMotion(generator), mirror * randomMotion(generator),
                                         scale * mirror, randomMotion(generator)};
      TopoDS_Shape pair = located(joinedSheets(disturbedSheets(generator, 0.02)), by[k]);
      if (k == 3) pair = facesSwappedAndReversed(pair);
      const std::string what = std::to_string(k) + " G" + std::to_string(order);
      const MatchReport report = matchedPair(pair, ofOrder(order), what);
      for (int number = 1; number <= 2; ++number) {
        const auto [before, out_before] = middle(face(pair, number));
        const auto [after, out_after] = middle(face(report.shape, number));
        EXPECT_LT(before.Distance(after), 0.1) << what;
        EXPECT_GT(out_before.Dot(out_after), 0.99) << what;
      }
      EXPECT_LT(middle(face(pair, 1)).first.Distance(middle(face(report.shape, 1)).first), 1e-12)
          << "the first face stays";
    }
}

TEST(MatchFaces, EitherFaceOrBothMove) {
  std::mt19937 generator(4);
  for (const int order : {1, 2}) {
    const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
    std::array<double, 3> moves{};
    for (const MatchMoves which : {MatchMoves::First, MatchMoves::Second, MatchMoves::Both}) {
      FaceMatchOptions options = ofOrder(order);
      options.moves = which;
      const MatchReport report = matchedPair(pair, options, "both");
      moves[static_cast<std::size_t>(which)] = report.largest_move_mm;
      for (const int number : {1, 2}) {
        const bool stays = which == (number == 1 ? MatchMoves::Second : MatchMoves::First);
        const bool same =
            BRep_Tool::Surface(face(pair, number)) == BRep_Tool::Surface(face(report.shape, number));
        EXPECT_EQ(same, stays);
      }
      EXPECT_TRUE(which != MatchMoves::Both || report.exact);
    }
    EXPECT_LT(moves[2], moves[0]);
    EXPECT_LT(moves[2], moves[1]);
  }
}

/// A spline of that degree and number of rows behind the last row of poles of a surface.
Spline behind(const Spline& surface, int rows, int degree_u) {
  TColgp_Array2OfPnt poles(1, rows, 1, 6);
  for (int i = 0; i < rows; ++i)
    for (int j = 1; j <= 6; ++j) {
      const double share = static_cast<double>(i) / (rows - 1);
      poles(i + 1, j) =
          surface->Pole(surface->NbUPoles(), j).Translated(gp_Vec(20 * share, share, (1 + 0.1 * j) * share));
    }
  return splineOf(poles, degree_u, 3);
}

TEST(MatchFaces, TheOppositeSideAndWhatLiesBeyondStay) {
  std::mt19937 generator(5);
  struct Net {
    int rows, degree_u;
  };
  for (const int order : {1, 2})
    for (const Net& net : {Net{2, 1}, Net{4, 2}, Net{4, 3}, Net{5, 1}, Net{8, 3}}) {
      std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
      parts[1] = behind(parts[0], net.rows, net.degree_u);
      disturb(parts[1], generator, 1, 0.02);
      const MatchReport report = matchedPair(joinedSheets(parts), ofOrder(order), "opposite");
      const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
      ASSERT_FALSE(after.IsNull());
      double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
      after->Bounds(u0, u1, v0, v1);
      for (double v = v0; v <= v1; v += 0.05) {
        gp_Pnt p, q;
        gp_Vec pu, pv, qu, qv;
        parts[1]->D1(u1, v, p, pu, pv);
        after->D1(u1, v, q, qu, qv);
        EXPECT_LT(p.Distance(q), 1e-11);
        EXPECT_LT((pu - qu).Magnitude(), 1e-9);
      }
    }
}

TEST(MatchFaces, SidesThatAreHeldStay) {
  std::mt19937 generator(6);
  FaceMatchOptions options;
  options.hold_sides = true;
  for (const int order : {1, 2}) {
    options.order = order;
    std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 7, 3, 3));
    for (int i = 1; i <= 3; ++i)
      for (int j = 2; j <= 6; ++j)
        parts[1]->SetPole(i, j, parts[1]->Pole(i, j).Translated(gp_Vec(0, 0, random(generator, 0.05))));
    const MatchReport report = matchedPair(joinedSheets(parts), options, "held");
    const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
    for (double u = 0.4; u <= 1; u += 0.01)
      for (const double v : {0.0, 1.0}) {
        EXPECT_LT(parts[1]->Value(u, v).Distance(after->Value(u, v)), 1e-11);
      }
  }
  const MatchReport refused = matchFaces(joinedSheets(disturbedSheets(generator, 0.09)), 1, 2, options);
  EXPECT_FALSE(refused.matched);
  EXPECT_NE(refused.reason.find("a side ends"), std::string::npos) << refused.reason;
}

TEST(MatchFaces, SidesOfAFollowerAreHeld) {
  std::mt19937 generator(18);
  const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp::XOY(), 30);
  const handle<Geom2d_BSplineCurve> line = curvedPath({{0.1, 5}, {1.2, 5}});
  const Spline strip = stripBeside(cylinder, line, gp_Vec2d(0, 8), 7, generator, 0);
  for (int i = 1; i <= 3; ++i)
    for (int j = 2; j < strip->NbVPoles(); ++j)
      strip->SetPole(
          i, j, strip->Pole(i, j).Translated(gp_Vec(random(generator, 0.03), 0, random(generator, 0.03))));
  const TopoDS_Shape pair = loose(trimmedFace(cylinder, line, gp_Vec2d(0, -10)), wholeFace(strip));
  FaceMatchOptions options;
  options.hold_sides = true;
  options.tolerance.angle_rad = 0.02 * degree;
  for (const int order : {1, 2}) {
    options.order = order;
    const MatchReport report = matchedPair(pair, options, "held");
    const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
    for (double u = 0; u <= 1; u += 0.01)
      for (const double v : {0.0, 1.0}) {
        EXPECT_LT(strip->Value(u, v).Distance(after->Value(u, v)), 1e-11);
      }
  }
  // A side that leaves the cylinder's line with another curvature.
  strip->SetPole(3, 1, strip->Pole(3, 1).Translated(gp_Vec(1, 0.1, 0)));
  const MatchReport refused =
      matchFaces(loose(trimmedFace(cylinder, line, gp_Vec2d(0, -10)), wholeFace(strip)), 1, 2, options);
  EXPECT_FALSE(refused.matched);
  EXPECT_NE(refused.reason.find("a side ends with a normal curvature of"), std::string::npos)
      << refused.reason;
}

TEST(MatchFaces, RationalSurfacesJoinAndFollow) {
  std::mt19937 generator(19);
  const auto weigh = [&](const Spline& surface) {
    for (int i = 1; i <= surface->NbUPoles(); ++i)
      for (int j = 1; j <= surface->NbVPoles(); ++j) surface->SetWeight(i, j, 1 + random(generator, 0.3));
  };
  for (const Trimmed& kind : trimmedKinds())
    for (const int order : {1, 2}) {
      const Spline strip = stripBeside(kind.surface, kind.path, kind.away, 9, generator, 0.01);
      // On the boundary equal weights, so that it stays where it is.
      weigh(strip);
      for (int j = 1; j <= strip->NbVPoles(); ++j) strip->SetWeight(1, j, 1);
      matchedPair(loose(trimmedFace(kind.surface, kind.path, kind.into), wholeFace(strip)), ofOrder(order),
                  "rational " + kind.name);
    }
  for (const int order : {1, 2}) {
    const Spline whole = sheet(generator, 9, 6, 3, 3);
    weigh(whole);
    const std::array<Spline, 2> parts = cutInTwo(whole);
    disturb(parts[1], generator, 3, 0.02);
    EXPECT_TRUE(matchedPair(joinedSheets(parts), ofOrder(order), "rational sheets").exact);
  }
}

TEST(MatchFaces, ALargerMoveThanAllowedIsRefused) {
  std::mt19937 generator(7);
  const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
  FaceMatchOptions options;
  const double needed = matchedPair(pair, options, "free").largest_move_mm;
  options.max_move_mm = needed / 2;
  const MatchReport refused = matchFaces(pair, 1, 2, options);
  EXPECT_FALSE(refused.matched);
  EXPECT_NE(refused.reason.find("needs a move of"), std::string::npos) << refused.reason;
  EXPECT_EQ(refused.largest_move_mm, 0);
  EXPECT_TRUE(face(refused.shape, 2).IsPartner(face(pair, 2)));
  EXPECT_EQ(refused.after.verdict.level, refused.before.verdict.level);
  options.max_move_mm = 1.001 * needed;
  expectMatched(matchFaces(pair, 1, 2, options), options, "just enough");
}

TEST(MatchFaces, WhatJoinsAlreadyIsLeftAlone) {
  std::mt19937 generator(8);
  const std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 5, 3));
  for (const int order : {1, 2}) {
    const TopoDS_Shape pair = joinedSheets(parts);
    const MatchReport report = matchFaces(pair, 1, 2, ofOrder(order));
    EXPECT_TRUE(report.matched);
    EXPECT_EQ(report.largest_move_mm, 0);
    EXPECT_NE(report.reason.find("nothing had to move"), std::string::npos);
    for (const int number : {1, 2}) EXPECT_TRUE(face(report.shape, number).IsPartner(face(pair, number)));
    EXPECT_EQ(report.after.faces, (std::array<int, 2>{1, 2}));
    // Matched once, a pair stays.
    const MatchReport first =
        matchFaces(joinedSheets(disturbedSheets(generator, 0.05)), 1, 2, ofOrder(order));
    const MatchReport second = matchFaces(first.shape, 1, 2, ofOrder(order));
    EXPECT_TRUE(second.matched);
    EXPECT_EQ(second.largest_move_mm, 0);
  }
}

TEST(MatchFaces, ACylinderStaysAndIsNotMoved) {
  std::mt19937 generator(9);
  const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp::XOY(), 30);
  const handle<Geom2d_BSplineCurve> line = curvedPath({{0.1, 5}, {1.2, 5}});
  const TopoDS_Shape pair = loose(trimmedFace(cylinder, line, gp_Vec2d(0, -10)),
                                  wholeFace(stripBeside(cylinder, line, gp_Vec2d(0, 8), 7, generator, 0.02)));
  for (const int order : {1, 2}) {
    const MatchReport report = matchedPair(pair, ofOrder(order), "fillet");
    EXPECT_FALSE(report.exact);
    FaceMatchOptions options = ofOrder(order);
    options.moves = MatchMoves::First;
    const MatchReport refused = matchFaces(pair, 1, 2, options);
    EXPECT_FALSE(refused.matched);
    EXPECT_EQ(refused.reason, "face 1 is a cylinder, which has no poles to move; face 2 could move");
    options.moves = MatchMoves::Both;
    const MatchReport one = matchedPair(pair, options, "both, of which one stays");
    EXPECT_NE(one.reason.find("so it stays"), std::string::npos) << one.reason;
  }
}

TEST(MatchFaces, ASideInsideItsSurfaceIsCutOffThere) {
  std::mt19937 generator(10);
  const Spline whole = sheet(generator, 9, 6, 3, 3);
  const Spline other = Spline::DownCast(whole->Copy());
  disturb(other, generator, 9, 0.02);
  const handle<Geom_Surface> a(whole.get()), b(other.get());
  const TopoDS_Shape pair = withTolerance(joined({a, beginningWith(1, rectangle(0, 0.4, 0.1, 0.9))},
                                                 {b, beginningWith(3, rectangle(0.4, 0.95, 0.1, 0.9))}),
                                          0.3);
  for (const int order : {1, 2}) {
    const MatchReport report = matchedPair(pair, ofOrder(order), "inside");
    EXPECT_TRUE(report.exact) << report.reason;
  }
}

TEST(MatchFaces, AnotherSpeedAlongTheBoundaryIsFollowed) {
  // The same boundary, run through at another speed by the second surface: y = v against y = v^2 (3 - v) / 2 and the like.
  std::mt19937 generator(11);
  TColgp_Array2OfPnt poles_a(1, 4, 1, 4), poles_b(1, 4, 1, 4);
  const double slow[] = {0, 4, 20, 30}, even[] = {0, 10, 20, 30};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      poles_a(i + 1, j + 1) = gp_Pnt(10.0 * i - 30, even[j], 0.3 * (i - 3) * (i - 3));
      poles_b(i + 1, j + 1) = gp_Pnt(10.0 * i, slow[j], (i == 0 ? 0 : 0.2 * i * j) + random(generator, 0.01));
    }
  const Spline a = splineOf(poles_a, 3, 3), b = splineOf(poles_b, 3, 3);
  for (const int order : {1, 2})
    for (int turns = 0; turns < 4; ++turns) {
      const Spline turned_a = Spline::DownCast(a->Copy()), turned_b = Spline::DownCast(b->Copy());
      if (turns & 1) turned_a->VReverse();
      if (turns & 2) turned_b->VReverse();
      const MatchReport report = matchedPair(loose(wholeFace(turned_a), wholeFace(turned_b)), ofOrder(order),
                                             "speed " + std::to_string(turns));
      EXPECT_LT(report.largest_move_mm, 4) << report.reason;
    }
}

/// Two half tubes of spline surfaces that share two edges.
TopoDS_Shape halfTubes(std::mt19937& generator, double noise_mm) {
  const auto half = [&](double from) {
    TColgp_Array2OfPnt poles(1, 7, 1, 4);
    for (int i = 1; i <= 7; ++i)
      for (int j = 1; j <= 4; ++j) {
        const double angle = from + std::numbers::pi * (i - 1) / 6, radius = i == 2 || i == 6 ? 10.4 : 10;
        gp_Pnt pole(radius * std::cos(angle), radius * std::sin(angle), 8.0 * j);
        if (i > 1 && i < 7)
          pole.Translate(gp_Vec(random(generator, noise_mm), random(generator, noise_mm), 0));
        poles(i, j) = pole;
      }
    return splineOf(poles, 3, 3);
  };
  BRepBuilderAPI_Sewing sewing(1e-4);
  sewing.Add(wholeFace(half(0)));
  sewing.Add(wholeFace(half(std::numbers::pi)));
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(MatchFaces, OfSeveralCommonEdgesOneIsTaken) {
  std::mt19937 generator(12);
  const TopoDS_Shape tube = halfTubes(generator, 0.1);
  const MatchReport longest = matchedPair(tube, ofOrder(1), "longest");
  EXPECT_NE(longest.reason.find("of the common edges"), std::string::npos) << longest.reason;
  const int taken = longest.before.edges.at(0);
  int other = 0;
  for (const occ::SeamResult& seam : analyzed(tube).seams)
    if (seam.edges.at(0) != taken) other = seam.edges.at(0);
  FaceMatchOptions options;
  options.edge = other;
  EXPECT_EQ(matchedPair(tube, options, "other").before.edges, std::vector<int>{other});
  options.edge = 77;
  EXPECT_THROW(matchFaces(tube, 1, 2, options), std::invalid_argument);
}

TEST(MatchFaces, ClosedAndMissingBoundariesAreRefusedWithReasons) {
  const auto ring = [](double z) {
    const handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, z), gp::DZ()), 10);
    return BRepBuilderAPI_MakeFace(cylinder, 0, 2 * std::numbers::pi, 0, 5, 1e-7).Face();
  };
  const auto spline_ring = [&](double z) {
    const handle<Geom_Surface> trimmed =
        new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, z), gp::DZ()), 10),
                                           0.0, 2 * std::numbers::pi, 0.0, 5.0);
    return wholeFace(GeomConvert::SurfaceToBSplineSurface(trimmed));
  };
  const MatchReport closed = matchFaces(loose(ring(0), spline_ring(5)), 1, 2);
  EXPECT_FALSE(closed.matched);
  EXPECT_NE(closed.reason.find("closed loop"), std::string::npos) << closed.reason;
  const MatchReport apart = matchFaces(loose(ring(0), spline_ring(8)), 1, 2);
  EXPECT_FALSE(apart.matched);
  EXPECT_NE(apart.reason.find("3 mm apart"), std::string::npos) << apart.reason;
  EXPECT_EQ(apart.before.id, 0);
}

TEST(MatchFaces, OnlyAWholeSideCanBeJoined) {
  std::mt19937 generator(13);
  const std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
  const handle<Geom_Surface> a(parts[0].get());
  const TopoDS_Shape half =
      loose(BRepBuilderAPI_MakeFace(a, 0, 0.4, 0, 0.5, 1e-7).Face(), wholeFace(parts[1]));
  const MatchReport report = matchFaces(half, 1, 2);
  EXPECT_FALSE(report.matched);
  EXPECT_NE(report.reason.find("the ends of the boundaries are"), std::string::npos) << report.reason;
}

TEST(MatchFaces, ATriangularFaceKeepsItsCorner) {
  std::mt19937 generator(14);
  std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
  disturb(parts[1], generator, 3, 0.02);
  const gp_Pnt corner = parts[1]->Pole(1, 1);
  for (int i = 1; i <= parts[1]->NbUPoles(); ++i) parts[1]->SetPole(i, 1, corner);
  const MatchReport report = matchFaces(joinedSheets(parts), 1, 2);
  ASSERT_TRUE(report.matched) << report.reason;
  const Spline after = Spline::DownCast(BRep_Tool::Surface(face(report.shape, 2)));
  for (double u = 0.4; u <= 1; u += 0.1) EXPECT_LT(after->Value(u, 0).Distance(after->Value(0.4, 0)), 1e-9);
}

TEST(MatchFaces, AKnifeEdgeIsRefused) {
  // Both sheets lie on the same side of the line x = 0, y = 0..30 and meet in it at 0.5 degrees.
  TColgp_Array2OfPnt below(1, 4, 1, 4), above(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      below(i + 1, j + 1) = gp_Pnt(-30 + 10.0 * i, 10.0 * j, 0.02 * i * j * (3 - i));
      above(i + 1, j + 1) = gp_Pnt(-10.0 * i, 10.0 * j, 0.1 * i);
    }
  const TopoDS_Shape pair = loose(wholeFace(splineOf(below, 3, 3)), wholeFace(splineOf(above, 3, 3)));
  for (const int order : {1, 2}) {
    const MatchReport report = matchFaces(pair, 1, 2, ofOrder(order));
    EXPECT_FALSE(report.matched);
    EXPECT_NE(report.reason.find("fold"), std::string::npos) << report.reason;
  }
}

TEST(MatchFaces, BadArgumentsAreNamed) {
  std::mt19937 generator(15);
  const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
  const auto refused = [&](int a, int b,
                           const std::function<void(FaceMatchOptions&)>& change) -> std::string {
    FaceMatchOptions options;
    change(options);
    try {
      matchFaces(pair, a, b, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "not refused";
  };
  const auto nothing = [](FaceMatchOptions&) {};
  EXPECT_EQ(refused(0, 1, nothing), "face 0: the model has faces 1 to 2");
  EXPECT_EQ(refused(1, 3, nothing), "face 3: the model has faces 1 to 2");
  EXPECT_EQ(refused(2, 2, nothing), "face 2 is given twice: two faces are needed");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.order = 3; }), "order is 3: it must be 1 or 2");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.max_move_mm = -1; }),
            "largest move is -1 mm: it must be zero or larger");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.match_mm = std::nan(""); }),
            "distance to match is nan mm: it must be zero or larger");
  EXPECT_EQ(refused(1, 2, [](FaceMatchOptions& o) { o.edge = -2; }), "edge is -2: edges count from 1");
  EXPECT_NE(refused(1, 2, [](FaceMatchOptions& o) { o.tolerance.gap_mm = -1; }), "not refused");
  EXPECT_THROW(matchFaces(TopoDS_Shape(), 1, 2), std::invalid_argument);
}

TEST(MatchFaces, ProgressGrowsAndCanStopIt) {
  std::mt19937 generator(16);
  const TopoDS_Shape pair = joinedSheets(disturbedSheets(generator, 0.05));
  std::vector<double> shares;
  matchFaces(pair, 1, 2, {}, [&](double share) {
    shares.push_back(share);
    return true;
  });
  ASSERT_GE(shares.size(), 4);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.back(), 1);
  for (const double stop : shares)
    EXPECT_THROW(matchFaces(pair, 1, 2, {}, [&](double share) { return share < stop; }), occ::Cancelled);
}

/// Seams of a model that fall short and are matched at their second face: how many are, and of these how many exactly. Figures of all that
/// are matched are looked at again by plain evaluation.
struct Tally {
  int tried = 0, matched = 0, exact = 0;
};

Tally tallyOf(const std::filesystem::path& path, int order, double max_move_mm) {
  const occ::Model model = occ::readModel(path);
  occ::AnalyzeOptions analyze;
  analyze.level = order == 1 ? Level::G1 : Level::G2;
  Tally tally;
  for (const occ::SeamResult& seam : occ::analyze(model, analyze).seams) {
    if (seam.verdict.seam_class != SeamClass::Defect || seam.kind != occ::SeamKind::Shared) continue;
    FaceMatchOptions options = ofOrder(order);
    options.edge = seam.edges[0];
    options.max_move_mm = max_move_mm;
    const MatchReport report = matchFaces(model.shape, seam.faces[0], seam.faces[1], options);
    ++tally.tried;
    EXPECT_FALSE(report.reason.empty());
    if (!report.matched) continue;
    ++tally.matched;
    tally.exact += report.exact ? 1 : 0;
    EXPECT_LE(report.largest_move_mm, max_move_mm);
    expectMatched(report, options, path.filename().string() + " edge " + std::to_string(seam.edges[0]));
  }
  return tally;
}

TEST(MatchFaces, SeamsOfModelsFromOtherHandsAreMatched) {
  struct Case {
    const char* name;
    int order;
    double max_move_mm;
    int matched, exact;
  };
  const Case cases[] = {{"freeform/hammer.brep", 1, 100, 7, 7},
                        {"freeform/linkrods.step", 1, 1, 4, 2},
                        {"freeform/Silk_Demo_02_sewn.step", 2, 5, 5, 3}};
  int found = 0;
  for (const Case& each : cases) {
    const std::filesystem::path path = furtherModel(each.name);
    if (path.empty()) continue;
    ++found;
    const Tally tally = tallyOf(path, each.order, each.max_move_mm);
    EXPECT_GE(tally.matched, each.matched) << each.name;
    EXPECT_GE(tally.exact, each.exact) << each.name;
  }
  if (found == 0) GTEST_SKIP() << "none of the models is here";
}

/// A sheet with a round hole near its first side.
TopoDS_Face sheetWithHole(const Spline& surface) {
  const handle<Geom_Surface> geometry(surface.get());
  const handle<Geom2d_Curve> circle = new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(0.47, 0.5), gp_Dir2d(1, 0)), 0.05);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, geometry, 0, 2 * std::numbers::pi).Edge();
  BRepLib::BuildCurve3d(edge);
  BRepBuilderAPI_MakeFace face(wholeFace(surface));
  face.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(edge).Wire().Reversed()));
  return face.Face();
}

TEST(MatchFaces, TrimmingIsKeptAndItsEdgesFollow) {
  std::mt19937 generator(17);
  for (const int order : {1, 2}) {
    std::array<Spline, 2> parts = cutInTwo(sheet(generator, 9, 6, 3, 3));
    disturb(parts[1], generator, 3, 0.05);
    const TopoDS_Shape pair = loose(wholeFace(parts[0]), sheetWithHole(parts[1]));
    ASSERT_TRUE(BRepCheck_Analyzer(pair).IsValid());
    FaceMatchOptions options = ofOrder(order);
    options.match_mm = 0.3;
    const MatchReport report = matchedPair(pair, options, "hole");
    int wires = 0;
    for (TopExp_Explorer it(face(report.shape, 2), TopAbs_WIRE); it.More(); it.Next()) ++wires;
    EXPECT_EQ(wires, 2);
    for (TopExp_Explorer it(report.shape, TopAbs_EDGE); it.More(); it.Next())
      EXPECT_LT(BRep_Tool::Tolerance(TopoDS::Edge(it.Current())), 2e-5) << "curves follow, not tolerances";
    EXPECT_TRUE(report.exact);
    EXPECT_EQ(report.before.kind, occ::SeamKind::Matched);
  }
}

}  // namespace
}  // namespace seamwright::test
