// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Face.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <functional>
#include <random>

#include <seamwright/occ_adapter/convert/bezier_surface.hpp>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using opencascade::handle;
using ::testing::AllOf;
using ::testing::HasSubstr;

Poles randomPoles(Eigen::Index count, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Poles::NullaryExpr(count, 3, [&] { return normal(random); });
}

Eigen::VectorXd randomWeights(Eigen::Index count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> weight(0.3, 3);
  return Eigen::VectorXd::NullaryExpr(count, [&] { return weight(random); });
}

/// About the plane triangle (0, 0), (side, 0), (0, side), with poles moved by up to a share of the
/// side.
BezierTriangle triangle(int degree, bool rational, double side, double share,
                        std::mt19937_64& random) {
  Poles poles = randomPoles(BezierTriangle::row(degree, degree, 0) + 1, random);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      auto pole = poles.row(BezierTriangle::row(degree, i, j));
      pole = side / degree * (share * pole.eval() + Eigen::RowVector3d(i, j, 0));
    }
  return rational ? BezierTriangle(poles, randomWeights(poles.rows(), random))
                  : BezierTriangle(poles);
}

Eigen::Vector3d vector(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

double area(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-10);
  return properties.Mass();
}

std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BezierSurface, CurvesComeBackAsTheyWere) {
  std::mt19937_64 random(testSeed());
  for (const int degree : {1, 2, 3, 7, 25}) {
    const BezierCurve polynomial(randomPoles(degree + 1, random));
    EXPECT_EQ(occ::bezierCurve(*occ::toBezierCurve(polynomial)), polynomial);
    const BezierCurve rational(randomPoles(degree + 1, random), randomWeights(degree + 1, random));
    const handle<Geom_BezierCurve> theirs = occ::toBezierCurve(rational);
    const BezierCurve back = occ::bezierCurve(*theirs);
    EXPECT_EQ(back.weights(), rational.weights());
    EXPECT_LT((back.poles() - rational.poles()).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((vector(theirs->Value(0.3)) - rational.point(0.3)).norm(), 1e-14);
  }
}

TEST(BezierSurface, PatchesComeBackAsTheyWere) {
  std::mt19937_64 random(testSeed());
  for (const auto& [m, n] : {std::pair(1, 1), std::pair(2, 3), std::pair(5, 1), std::pair(25, 4)}) {
    const Eigen::Index rows = (m + 1) * (n + 1);
    const BezierPatch polynomial(m, n, randomPoles(rows, random));
    EXPECT_EQ(occ::bezierPatch(*occ::toBezierSurface(polynomial)), polynomial);
    const BezierPatch rational(m, n, randomPoles(rows, random), randomWeights(rows, random));
    const handle<Geom_BezierSurface> theirs = occ::toBezierSurface(rational);
    const BezierPatch back = occ::bezierPatch(*theirs);
    EXPECT_EQ(back.weights(), rational.weights());
    EXPECT_LT((back.poles() - rational.poles()).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((vector(theirs->Value(0.3, 0.8)) - rational.point(0.3, 0.8)).norm(), 1e-14);
    EXPECT_LT(
        (vector(occ::toBezierSurface(polynomial)->Value(0.3, 0.8)) - polynomial.point(0.3, 0.8))
            .norm(),
        1e-14);
  }
}

TEST(BezierSurface, SplinesOfOneSpanAreBezier) {
  std::mt19937_64 random(testSeed());
  const BezierPatch patch(3, 2, randomPoles(12, random), randomWeights(12, random));
  handle<Geom_BSplineSurface> spline =
      GeomConvert::SurfaceToBSplineSurface(occ::toBezierSurface(patch));
  spline->SetUKnot(1, -3);
  EXPECT_LT((occ::bezierPatch(*spline).homogeneousPoles() - patch.homogeneousPoles())
                .cwiseAbs()
                .maxCoeff(),
            1e-15);
  spline->InsertVKnot(0.4, 1, 1e-9);
  EXPECT_THAT(complaint([&] { occ::bezierPatch(*spline); }), AllOf(HasSubstr("2 spans in v")));

  const BezierCurve curve(randomPoles(4, random));
  handle<Geom_BSplineCurve> arc = GeomConvert::CurveToBSplineCurve(occ::toBezierCurve(curve));
  EXPECT_EQ(occ::bezierCurve(*arc), curve);
  arc->InsertKnot(0.4);
  arc->InsertKnot(0.6);
  EXPECT_THAT(complaint([&] { occ::bezierCurve(*arc); }), HasSubstr("3 spans"));

  TColgp_Array1OfPnt poles(1, 2);
  poles(2) = gp_Pnt(1, 0, 0);
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  const handle<Geom_BSplineCurve> line = new Geom_BSplineCurve(poles, knots, multiplicities, 1);
  EXPECT_EQ(occ::bezierCurve(*line).degree(), 1);
}

TEST(BezierSurface, OtherKindsAndDegreesAreNamed) {
  EXPECT_THAT(complaint([] { occ::bezierPatch(*handle<Geom_Plane>(new Geom_Plane(gp::XOY()))); }),
              HasSubstr("Geom_Plane is not a Bezier surface"));
  EXPECT_THAT(complaint([] { occ::bezierCurve(*handle<Geom_Line>(new Geom_Line(gp::OX()))); }),
              HasSubstr("Geom_Line is not a Bezier curve"));
  EXPECT_THAT(complaint([] { occ::toBezierCurve(BezierCurve(Poles::Zero(27, 3))); }),
              HasSubstr("degree 26"));
  EXPECT_THAT(complaint([] { occ::toBezierSurface(BezierPatch(0, 1, Poles::Zero(2, 3))); }),
              HasSubstr("degree 0"));
  EXPECT_THAT(complaint([] { occ::toBezierSurface(BezierPatch(1, 26, Poles::Zero(54, 3))); }),
              HasSubstr("degree 26"));
  const BezierTriangle high(Poles::Zero(BezierTriangle::row(26, 26, 0) + 1, 3));
  EXPECT_THAT(complaint([&] { occ::toBezierSurfaces(high); }), HasSubstr("degree 26"));
  EXPECT_THAT(complaint([&] { occ::toShell(high); }), HasSubstr("degree 26"));
  EXPECT_THAT(complaint([] { occ::toShell(BezierTriangle(Poles::Zero(1, 3))); }),
              HasSubstr("degree 0"));
}

TEST(BezierSurface, ATriangleIsThreeSurfaces) {
  std::mt19937_64 random(testSeed());
  for (const bool rational : {false, true}) {
    const BezierTriangle ours = triangle(4, rational, 20, 0.2, random);
    const auto surfaces = occ::toBezierSurfaces(ours);
    const Barycentric centroid = Barycentric::Constant(1.0 / 3);
    for (int k = 0; k < 3; ++k) {
      Barycentric a = Barycentric::Unit(k), b = 0.5 * (a + Barycentric::Unit((k + 1) % 3)),
                  d = 0.5 * (a + Barycentric::Unit((k + 2) % 3));
      const Barycentric l = 0.7 * 0.4 * a + 0.3 * 0.4 * b + 0.3 * 0.6 * centroid + 0.7 * 0.6 * d;
      EXPECT_LT((vector(surfaces[k]->Value(0.3, 0.6)) - ours.point(l(0), l(1))).norm(), 1e-13);
    }
  }
}

TEST(BezierSurface, AShellOfATriangleIsValid) {
  std::mt19937_64 random(testSeed());
  occ::AnalyzeOptions tight;
  tight.level = Level::G2;
  tight.tolerance = {.gap_mm = 1e-9, .angle_rad = 1e-8, .curvature_rel = 1e-6};
  for (int degree = 1; degree <= 6; ++degree)
    for (const bool rational : {false, true}) {
      const TopoDS_Shell shell = occ::toShell(triangle(degree, rational, 20, 0.2, random));
      EXPECT_TRUE(BRepCheck_Analyzer(shell).IsValid()) << degree;
      EXPECT_EQ(count(shell, TopAbs_FACE), 3);
      EXPECT_EQ(count(shell, TopAbs_EDGE), 9);
      EXPECT_EQ(count(shell, TopAbs_VERTEX), 7);
      const occ::Report report = analyzed(shell, tight);
      ASSERT_EQ(report.seams.size(), 3U);
      for (const occ::SeamResult& seam : report.seams) {
        EXPECT_EQ(seam.verdict.level, Level::G2) << describe(seam);
        EXPECT_TRUE(seam.verdict.certain) << describe(seam);
      }
    }
}

TEST(BezierSurface, AShellHasTheAreaAndTheNormalOfTheTriangle) {
  std::mt19937_64 random(testSeed());
  // Inner poles move in the plane only: any degree and weights, the same area.
  for (int degree = 1; degree <= 5; ++degree) {
    BezierTriangle flat = triangle(degree, false, 20, 0, random);
    Poles poles = flat.poles();
    for (int i = 1; i < degree; ++i)
      for (int j = 1; i + j < degree; ++j)
        poles.row(BezierTriangle::row(degree, i, j)) += Eigen::RowVector3d(0.8, -0.5, 0);
    EXPECT_NEAR(area(occ::toShell(BezierTriangle(poles))), 200, 1e-7);
  }
  const BezierTriangle ours = triangle(3, true, 20, 0.2, random);
  for (const BezierTriangle& turned : {ours, ours.permuted({0, 2, 1})})
    for (TopExp_Explorer face(occ::toShell(turned), TopAbs_FACE); face.More(); face.Next()) {
      gp_Pnt centroid;
      gp_Vec theirs;
      BRepGProp_Face(TopoDS::Face(face.Current())).Normal(1, 1, centroid, theirs);
      const SurfaceJet x = turned.jet(1.0 / 3, 1.0 / 3);
      const Eigen::Vector3d normal(theirs.X(), theirs.Y(), theirs.Z());
      EXPECT_GT(normal.normalized().dot(x.u.cross(x.v).normalized()), 1 - 1e-12);
    }
}

TEST(BezierSurface, ACollapsedTriangleMakesNoShell) {
  Poles poles(3, 3);
  poles << 0, 0, 0, 0, 0, 0, 1, 0, 0;
  EXPECT_THAT(complaint([&] { occ::toShell(BezierTriangle(poles)); }), HasSubstr("of a line"));
  // Folded: with the barycentric a, b, c it is (a^2 - b^2, (a - b) c), a point on the median a = b.
  Poles folded(6, 3);
  folded << 0, 0, 0, 0, -0.5, 0, -1, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0, 0;
  EXPECT_THAT(complaint([&] { occ::toShell(BezierTriangle(folded)); }),
              HasSubstr("is the centroid"));
}

TEST(BezierSurface, TrianglesAreRecognisedInTheirSurfaces) {
  std::mt19937_64 random(testSeed());
  for (const bool rational : {false, true}) {
    const BezierTriangle ours = triangle(3, rational, 20, 0.3, random);
    const handle<Geom_BezierSurface> surface = occ::toBezierSurface(degeneratePatch(ours));
    surface->ExchangeUV();
    for (const handle<Geom_Surface>& theirs :
         {handle<Geom_Surface>(surface),
          handle<Geom_Surface>(GeomConvert::SurfaceToBSplineSurface(surface))}) {
      const TriangleRecognition found = occ::recogniseTriangle(*theirs);
      ASSERT_TRUE(found.triangle) << found.deviation_mm;
      EXPECT_EQ(found.apex, PatchEdge::V0);
      // ExchangeUV turns the natural normal over: corners 1 and 2 are exchanged.
      EXPECT_LT((found.triangle->permuted({0, 2, 1}).poles() - ours.poles()).cwiseAbs().maxCoeff(),
                1e-12);
    }
  }
  EXPECT_FALSE(
      occ::recogniseTriangle(*occ::toBezierSurfaces(triangle(2, false, 20, 0.1, random))[0])
          .triangle);
}

}  // namespace
}  // namespace seamwright::test
