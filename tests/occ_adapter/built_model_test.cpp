// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <functional>
#include <random>

#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/natural_face.hpp>
#include <seamwright/occ_adapter/repair/sewn_model.hpp>
#include <seamwright/occ_adapter/topology/built_model.hpp>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using ::testing::HasSubstr;
using Map = std::function<Eigen::Vector3d(double, double)>;

/// A bicubic patch with the poles map(i / 3, j / 3).
BezierPatch bicubic(const Map& map) {
  Poles poles(16, 3);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) poles.row(4 * i + j) = map(i / 3.0, j / 3.0);
  return {3, 3, poles};
}

BezierPatch wavy(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return bicubic([&](double u, double v) {
    return Eigen::Vector3d(10 * u + normal(random), 10 * v + normal(random), normal(random));
  });
}

Eigen::VectorXd someWeights(Eigen::Index count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> weight(0.3, 3);
  return Eigen::VectorXd::NullaryExpr(count, [&] { return weight(random); });
}

/// How many edges are points.
int pointsOf(const TopoDS_Shape& shape) {
  int count = 0;
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i)
    count += BRep_Tool::Degenerated(TopoDS::Edge(edges(i))) ? 1 : 0;
  return count;
}

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

std::string builtComplaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(BuiltModel, SurfacesAndCurvesComeBack) {  // identity (1)
  std::mt19937_64 random(testSeed());
  const BezierPatch patch = wavy(random);
  const BezierPatch rational(3, 3, wavy(random).poles(), someWeights(16, random));
  BSplineSurface spline = splineSurface(wavy(random));
  spline = withKnot(withKnot(spline, SurfaceDirection::U, 0.3), SurfaceDirection::V, 0.7);
  const BezierCurve curve(wavy(random).poles().topRows(5));
  const occ::Model model = occ::builtModel({{.geometry = patch, .name = "a"},
                                            {.geometry = spline},
                                            {.geometry = rational, .name = "c"},
                                            {.geometry = curve, .name = "d"}});
  EXPECT_EQ(occ::faceSurface(model, 1), splineSurface(patch));
  EXPECT_EQ(occ::faceSurface(model, 2), spline);
  const HomogeneousPoles back = occ::faceSurface(model, 3).poles,
                         given = splineSurface(rational).poles;
  EXPECT_LT((back - given).cwiseAbs().maxCoeff(), 1e-14 * given.cwiseAbs().maxCoeff());
  EXPECT_EQ(occ::edgeCurve(model, model.edgeCount()).poles, splineCurve(curve).poles);
  ASSERT_EQ(model.attributes.size(), 3u);
  EXPECT_EQ(model.attributes[1].index, 3);
  EXPECT_EQ(model.attributes[1].name, "c");
  EXPECT_EQ(model.attributes[2].kind, TopAbs_EDGE);
  EXPECT_EQ(model.attributes[2].index, 13);
}

/// A face with sides that are points or coincide.
struct Collapsed {
  const char* name;
  Map map;
  int edges, points, vertices;
};

TEST(BuiltModel, SidesMayBePointsOrCoincide) {  // identity (2)
  using V = Eigen::Vector3d;
  const auto loop = [](double v) {
    return v == 0 || v == 1 ? V(0, 0, 0) : V(1, v < 0.5 ? -1 : 1, 0);
  };
  const std::vector<Collapsed> cases = {
      {"u0", [](double u, double v) { return V(u, u * v, u * u * v); }, 4, 1, 3},
      {"u1", [](double u, double v) { return V(u, (1 - u) * v, u * v * (1 - u)); }, 4, 1, 3},
      {"v0", [](double u, double v) { return V(u * v, v, u * v * v); }, 4, 1, 3},
      {"v1", [](double u, double v) { return V(u * (1 - v), v, 0); }, 4, 1, 3},
      {"u0, u1", [](double u, double v) { return V(u, u * (1 - u) * v, 0); }, 4, 2, 2},
      {"u0, v0", [](double u, double v) { return V(u * v * (1 + u), u * v * (1 + v), 0); }, 4, 2,
       2},
      {"u1, v0",
       [](double u, double v) { return V((1 - u) * v * (2 - u), (1 - u) * v * (1 + v), 0); }, 4, 2,
       2},
      {"u1, v1",
       [](double u, double v) { return V((1 - u) * (1 - v) * (2 - u), (1 - u) * (1 - v * v), 0); },
       4, 2, 2},
      {"tube", [&](double u, double v) { return V(loop(v) + V(0, 0, u)); }, 3, 0, 2},
      {"tube across", [&](double u, double v) { return V(loop(u) + V(0, 0, v)); }, 3, 0, 2},
      {"cone", [&](double u, double v) { return V(u * loop(v) + V(0, 0, u)); }, 3, 1, 2},
      {"lemon", [&](double u, double v) { return V(u * (1 - u) * loop(v) + V(0, 0, u)); }, 3, 2, 2},
      {"torus",
       [&](double u, double v) { return V(loop(v) + V(3 * loop(u).x(), 0, 3 * loop(u).y())); }, 2,
       0, 1}};
  for (const Collapsed& face : cases) {
    SCOPED_TRACE(face.name);
    const TopoDS_Face made = occ::naturalFace(occ::toBezierSurface(bicubic(face.map)));
    EXPECT_TRUE(BRepCheck_Analyzer(made).IsValid());
    EXPECT_EQ(partsOf(made, TopAbs_EDGE).Extent(), face.edges);
    EXPECT_EQ(pointsOf(made), face.points);
    EXPECT_EQ(partsOf(made, TopAbs_VERTEX).Extent(), face.vertices);
  }
}

TEST(BuiltModel, ToleranceDecidesWhatIsAPoint) {  // identity (2)
  const BezierPatch near =
      bicubic([](double u, double v) { return Eigen::Vector3d(u, (u + 1e-5) * v, u * v); });
  for (const double tolerance_mm : {1e-7, 1e-4}) {
    const occ::Model model = occ::builtModel({{.geometry = near}}, tolerance_mm);
    EXPECT_TRUE(BRepCheck_Analyzer(model.shape).IsValid());
    EXPECT_EQ(pointsOf(model.shape), tolerance_mm > 1e-5 ? 1 : 0);
    EXPECT_EQ(occ::faceSurface(model, 1), splineSurface(near));
    double largest_mm = 0;
    const TopTools_IndexedMapOfShape vertices = partsOf(model.shape, TopAbs_VERTEX);
    for (int i = 1; i <= vertices.Extent(); ++i)
      largest_mm = std::max(largest_mm, BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))));
    EXPECT_NEAR(largest_mm, tolerance_mm > 1e-5 ? 1e-5 : 1e-7, 1e-16);
  }
}

TEST(BuiltModel, TrianglesHaveThreeFaces) {  // identity (3)
  Poles poles(6, 3);
  poles << 0, 0, 0, 0, 5, 1, 0, 10, 0, 5, 0, 1, 5, 5, 2, 10, 0, 0;
  const BezierTriangle triangle(poles);
  const occ::Model model = occ::builtModel({{.geometry = triangle}});
  ASSERT_EQ(model.faceCount(), 3);
  EXPECT_EQ(model.edgeCount(), 9);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape).IsValid());
  const std::array<BezierPatch, 3> patches = regularPatches(triangle);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(occ::faceSurface(model, k + 1), splineSurface(patches[k]));
  occ::AnalyzeOptions options;
  options.level = Level::G2;
  for (const occ::SeamResult& seam : analyzed(model.shape, options).seams)
    EXPECT_EQ(seam.verdict.level, Level::G2);
}

TEST(BuiltModel, AnEdgeOfATriangleMayBeAPoint) {  // identity (2)
  // A sector: the edge from P0 to P1, P1 to P2 or P2 to P0 is a point.
  Poles poles(6, 3);
  poles << 0, 0, 0, 5, 0, 0, 10, 0, 0, 0, 0, 0, 7, 7, 0, 0, 0, 0;
  const BezierTriangle sector(poles);
  double area = 0;
  for (const std::array<int, 3>& order :
       {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 0, 1}, std::array{0, 2, 1}}) {
    const TopoDS_Shell shell = occ::toShell(sector.permuted(order));
    EXPECT_TRUE(BRepCheck_Analyzer(shell).IsValid());
    EXPECT_EQ(pointsOf(shell), 2);
    // Seven points of a triangle, of which three are one.
    EXPECT_EQ(partsOf(shell, TopAbs_VERTEX).Extent(), 5);
    if (area == 0) area = areaOf(shell);
    EXPECT_NEAR(areaOf(shell), area, 1e-6 * area);
  }
}

TEST(BuiltModel, CurvesMayBeClosed) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 1e-9;
  const occ::Model model = occ::builtModel({{.geometry = BezierCurve(poles)}});
  EXPECT_EQ(model.faceCount(), 0);
  EXPECT_EQ(partsOf(model.shape, TopAbs_VERTEX).Extent(), 1);
  EXPECT_TRUE(BRepCheck_Analyzer(model.shape).IsValid());
  EXPECT_EQ(occ::edgeCurve(model, 1).poles, splineCurve(BezierCurve(poles)).poles);
}

TEST(BuiltModel, SewnFacesShareTheirEdgeAndKeepTheirSurface) {
  const BezierPatch whole = bicubic(
      [](double u, double v) { return Eigen::Vector3d(10 * u, 10 * v, 2 * u * u * u + v * v); });
  const auto [first, second] = whole.splitU(0.5);
  const occ::Model apart =
      occ::builtModel({{.geometry = first, .name = "left"}, {.geometry = second, .name = "right"}});
  EXPECT_TRUE(occ::analyze(apart).seams.empty());
  const occ::Model sewn = occ::sewnModel(apart, {.sew_mm = 1e-4});
  EXPECT_EQ(sewn.edgeCount(), 7);
  EXPECT_TRUE(sewn.notes.empty());
  EXPECT_TRUE(BRepCheck_Analyzer(sewn.shape).IsValid());
  EXPECT_EQ(occ::faceSurface(sewn, 1), splineSurface(first));
  EXPECT_EQ(occ::faceSurface(sewn, 2), splineSurface(second));
  ASSERT_EQ(sewn.attributes.size(), 2u);
  EXPECT_EQ(sewn.attributes[1].name, "right");
  occ::AnalyzeOptions options;
  options.level = Level::G2;
  const occ::Report report = occ::analyze(sewn, options);
  ASSERT_EQ(report.seams.size(), 1u);
  EXPECT_EQ(report.seams[0].verdict.level, Level::G2);
}

TEST(BuiltModel, ComplaintsNameTheItem) {
  const BezierPatch good = bicubic([](double u, double v) { return Eigen::Vector3d(u, v, 0); });
  const BezierPatch line = bicubic([](double u, double v) { return Eigen::Vector3d(u + v, 0, 0); });
  const BezierPatch point = bicubic([](double, double) { return Eigen::Vector3d(1, 2, 3); });
  const auto with = [&good](const occ::BuiltGeometry& bad) {
    return [&good, bad] { occ::builtModel({{.geometry = good}, {.geometry = bad}}); };
  };
  EXPECT_THAT(builtComplaint(with(line)),
              HasSubstr("item 1: all poles are within 1e-07 mm of a line"));
  EXPECT_THAT(builtComplaint(with(point)), HasSubstr("of a point, (1, 2, 3)"));
  EXPECT_THAT(builtComplaint(with(BezierCurve(Poles::Ones(3, 3)))), HasSubstr("no length"));
  EXPECT_THAT(builtComplaint(with(BezierCurve(Poles::Random(27, 3)))), HasSubstr("degree 26"));
  EXPECT_THAT(builtComplaint([] { occ::builtModel({}); }), HasSubstr("no surfaces"));
  EXPECT_THAT(builtComplaint([&] { occ::builtModel({{.geometry = good}}, 0); }),
              HasSubstr("is 0 mm"));
  const occ::Model model = occ::builtModel({{.geometry = good}});
  EXPECT_THAT(builtComplaint([&] { occ::sewnModel(model, {.sew_mm = -1}); }),
              HasSubstr("is -1 mm"));
  EXPECT_THAT(builtComplaint([&] { occ::faceSurface(model, 2); }), HasSubstr("face 2"));
  EXPECT_THAT(builtComplaint([&] { occ::edgeCurve(model, 0); }), HasSubstr("edge 0"));
}

TEST(BuiltModel, OtherKindsAreNamed) {
  const occ::Model block = occ::modelFromShape(box());
  EXPECT_THAT(builtComplaint([&] { occ::faceSurface(block, 1); }), HasSubstr("Face1 has a plane"));
  EXPECT_THAT(builtComplaint([&] { occ::edgeCurve(block, 1); }), HasSubstr("Edge1: Geom_Line"));
  const occ::Model cone = occ::builtModel(
      {{.geometry = bicubic([](double u, double v) { return Eigen::Vector3d(u, u * v, 0); })}});
  EXPECT_THAT(builtComplaint([&] { occ::edgeCurve(cone, 4); }), HasSubstr("Edge4 has no curve"));
}

}  // namespace
}  // namespace seamwright::test
