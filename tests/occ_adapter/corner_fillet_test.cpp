// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners that become solids. Beside OpenCASCADE's checks: its own fillets, cross-sections known in
// closed form, normals evaluated by OpenCASCADE.
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <array>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <map>
#include <numbers>

#include "corner_solids.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>

namespace seamwright::test {
namespace {

using Eigen::Vector3d;
using occ::CornerFillet;
using occ::cornerFillet;
using occ::CornerFilletOptions;
using occ::CornerSeam;
using occ::Model;
using occ::modelFromShape;
using std::numbers::pi;

/// Radii of the edges in their order about the vertex, counter-clockwise; begun again where there
/// are more edges.
CornerFilletOptions withRadii(const Model& model, int vertex, const std::vector<double>& radii_mm) {
  CornerFilletOptions options;
  std::size_t k = 0;
  for (const int edge : occ::cornerEdges(model, vertex))
    options.radii_mm[edge] = radii_mm[k++ % radii_mm.size()];
  return options;
}

CornerFillet rounded(const TopoDS_Shape& shape, const Vector3d& corner,
                     const std::vector<double>& radii_mm) {
  const Model model = modelFromShape(shape);
  const int vertex = vertexAt(shape, corner);
  return cornerFillet(model, vertex, withRadii(model, vertex, radii_mm));
}

TopoDS_Shape box(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

TopTools_IndexedMapOfShape parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map;
}

gp_Dir normalAt(const TopoDS_Edge& edge, const TopoDS_Face& face, double share) {
  double first = 0, last = 0;
  const opencascade::handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const gp_Pnt2d at = path->Value(first + share * (last - first));
  gp_Pnt p;
  gp_Vec u, v;
  BRepAdaptor_Surface(face, false).D1(at.X(), at.Y(), p, u, v);
  const gp_Dir normal(u ^ v);
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

/// The largest angle between the outward normals of the two sides of a new seam, at many points.
double denseAngle_rad(const TopoDS_Shape& shape, const CornerSeam& seam) {
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE),
                                   faces = parts(shape, TopAbs_FACE);
  const TopoDS_Edge& edge = TopoDS::Edge(edges(seam.result.edges.front()));
  const TopoDS_Face &a = TopoDS::Face(faces(seam.result.faces[0])),
                    &b = TopoDS::Face(faces(seam.result.faces[1]));
  double largest = 0;
  for (int k = 0; k <= 100; ++k)
    largest = std::max(largest, normalAt(edge, a, k / 100.0).Angle(normalAt(edge, b, k / 100.0)));
  return largest;
}

struct Case {
  const char* name;
  TopoDS_Shape shape;
  Vector3d corner;
  std::vector<double> radii_mm;
  bool native = true;  ///< BRepFilletAPI_MakeFillet of OpenCASCADE 7.6 makes a valid solid of it
};

std::ostream& operator<<(std::ostream& stream, const Case& of) {
  return stream << of.name;
}

std::vector<Case> cases() {
  const Vector3d ten(0, 0, 10), twenty(0, 0, 20), origin(0, 0, 0), mixed(10, 5, 5), inner(5, 5, 5);
  return {{"CubeEqual", box(10, 10, 10), origin, {1}},
          {"CubeOneTwoThree", box(10, 10, 10), origin, {1, 2, 3}},
          {"CubeThreeTwoOne", box(10, 10, 10), origin, {3, 2, 1}},
          {"CubeOfSplines", linesAsSplines(box(10, 10, 10)), origin, {1, 2, 3}},
          {"CubeFortyfold", box(10, 10, 10), origin, {0.1, 2, 4}},
          {"PyramidOfThree", regularPyramid(3, 10), ten, {0.5, 1}},
          {"PyramidOfFour", regularPyramid(4, 10), ten, {0.5, 1}},
          {"PyramidOfFive", regularPyramid(5, 10), ten, {0.2, 1, 1}},
          {"PyramidOfSix", regularPyramid(6, 10), ten, {1}},
          {"FlatPyramidOfSix", regularPyramid(6, 2), {0, 0, 2}, {2}},
          {"ObliquePyramid",
           pyramid({{10, 0, 0}, {1, 9, 0}, {-8, 2, 0}, {-3, -9, 0}}, {3, 1, 9}),
           {3, 1, 9},
           {0.8, 0.3, 0.5}},
          {"NotchMixed", notchedCube(), mixed, {0.5, 1, 2}},
          {"NotchMixedEqual", notchedCube(), mixed, {1}},
          {"NotchInner", notchedCube(), inner, {0.5, 1, 2}},
          {"NotchInnerUnequal", notchedCube(), inner, {1, 1, 0.1}, false},
          {"SteepPyramidOfThree", regularPyramid(3, 20), twenty, {0.1, 0.5, 1}, false},
          {"SteepPyramidOfSix", regularPyramid(6, 20), twenty, {0.2, 1, 1}, false}};
}

/// Those of which OpenCASCADE makes a fillet too.
std::vector<Case> casesOfBoth() {
  std::vector<Case> both = cases();
  std::erase_if(both, [](const Case& one) { return !one.native; });
  return both;
}

class Corners : public testing::TestWithParam<Case> {};
class CornersOfBoth : public testing::TestWithParam<Case> {};

TEST_P(Corners, BecomeValidSolidsOfSmoothSeams) {
  const auto& [name, shape, corner, radii_mm, native] = GetParam();
  const CornerFillet result = rounded(shape, corner, radii_mm);
  EXPECT_TRUE(result.met()) << result.shortfall.text;
  EXPECT_TRUE(BRepCheck_Analyzer(result.model.shape).IsValid());
  EXPECT_TRUE(result.fill.regular);
  const std::size_t edges = result.edges.size();
  EXPECT_EQ(result.seams.size(), 8 * edges);
  EXPECT_EQ(result.model.faceCount(),
            modelFromShape(shape).faceCount() + static_cast<int>(3 * edges));

  EXPECT_LT(result.largestAngle_rad(), 0.01 * degree);
  EXPECT_LT(result.largestGap_mm(), 2e-6);
  double dense = 0;
  for (const CornerSeam& seam : result.seams)
    dense = std::max(dense, denseAngle_rad(result.model.shape, seam));
  EXPECT_LT(dense, 0.01 * degree);

  const occ::Report report = occ::analyze(result.model);
  EXPECT_TRUE(report.open.empty());
  EXPECT_TRUE(report.non_manifold.empty());
}

/// Ours is set back further and takes, or adds, some more: little beside a ball's way through three
/// edges, more where theirs is a plate.
TEST_P(CornersOfBoth, DifferLittleFromOpenCascadesOwn) {
  const auto& [name, shape, corner, radii_mm, native] = GetParam();
  const CornerFillet result = rounded(shape, corner, radii_mm);
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
  BRepFilletAPI_MakeFillet fillet(shape);
  for (const occ::CornerFilletEdge& edge : result.edges)
    fillet.Add(edge.radius_mm, TopoDS::Edge(edges(edge.edge)));
  fillet.Build();
  ASSERT_TRUE(fillet.IsDone());
  double size_mm3 = 0;
  for (const occ::CornerFilletEdge& edge : result.edges)
    size_mm3 += edge.contact_mm * edge.contact_mm * edge.setback_mm;
  EXPECT_NEAR(volume_mm3(result.model.shape), volume_mm3(fillet.Shape()),
              (result.edges.size() == 3 ? 0.1 : 0.35) * size_mm3);
}

/// Identity (1).
TEST_P(Corners, HaveCylindersThatTouchBothFaces) {
  const auto& [name, shape, corner, radii_mm, native] = GetParam();
  const CornerFillet result = rounded(shape, corner, radii_mm);
  const TopTools_IndexedMapOfShape faces = parts(result.model.shape, TopAbs_FACE);
  int contacts = 0;
  for (const CornerSeam& seam : result.seams) {
    if (seam.kind != occ::CornerSeamKind::Contact) continue;
    BRepAdaptor_Surface a(TopoDS::Face(faces(seam.result.faces[0]))),
        b(TopoDS::Face(faces(seam.result.faces[1])));
    if (a.GetType() != GeomAbs_Cylinder) std::swap(a, b);
    ASSERT_EQ(a.GetType(), GeomAbs_Cylinder);
    ASSERT_EQ(b.GetType(), GeomAbs_Plane);
    const gp_Ax1 axis = a.Cylinder().Axis();
    EXPECT_NEAR(b.Plane().Distance(axis.Location()), a.Cylinder().Radius(), 1e-9);
    EXPECT_NEAR(axis.Direction().Dot(b.Plane().Axis().Direction()), 0, 1e-12);
    ++contacts;
  }
  EXPECT_EQ(contacts, 2 * static_cast<int>(result.edges.size()));
}

std::string nameOf(const testing::TestParamInfo<Case>& of) {
  return of.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, Corners, testing::ValuesIn(cases()), nameOf);
INSTANTIATE_TEST_SUITE_P(All, CornersOfBoth, testing::ValuesIn(casesOfBoth()), nameOf);

/// The corner of equal radii that a ball makes is an octant of a sphere. Ours leaves it by a share
/// of the radius that does not depend on the radius, and comes near it with its setback.
TEST(CornerFillet, OfACubeIsNearTheOctantOfABall) {
  const TopoDS_Shape cube = box(10, 10, 10);
  const Model model = modelFromShape(cube);
  const int vertex = vertexAt(cube, {0, 0, 0});
  const std::map<double, double> bounds = {{1.05, 0.12}, {1.2, 0.17}, {1.5, 0.25}};
  for (const double r : {0.5, 2.0})
    for (const auto& [setback, bound] : bounds) {
      CornerFilletOptions options = withRadii(model, vertex, {r});
      for (const auto& [edge, radius_mm] : options.radii_mm)
        options.setbacks_mm[edge] = setback * r;
      const CornerFillet result = cornerFillet(model, vertex, options);
      EXPECT_TRUE(result.met()) << result.shortfall.text;
      double furthest = 0;
      for (const BezierPatch& patch : result.fill.patches)
        for (int i = 0; i <= 10; ++i)
          for (int j = 0; j <= 10; ++j) {
            const Vector3d q = (patch.point(i / 10.0, j / 10.0).array() - r).min(0).matrix();
            furthest = std::max(furthest, std::abs(q.norm() - r));  // |q| = r on the ball's cube
          }
      EXPECT_LT(furthest, bound * r) << setback;
    }
}

/// Of x . n over a patch, n towards where the partial by u is left of that by v; by Gauss and
/// Legendre.
double flux_mm3(const BezierPatch& patch) {
  constexpr std::array<double, 5> nodes = {0, 0.5384693101056831, -0.5384693101056831,
                                           0.9061798459386640, -0.9061798459386640};
  constexpr std::array<double, 5> weights = {0.5688888888888889, 0.4786286704993665,
                                             0.4786286704993665, 0.2369268850561891,
                                             0.2369268850561891};
  constexpr int cells = 8;
  double sum = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t b = 0; b < nodes.size(); ++b) {
          const SurfaceJet jet =
              patch.jet((i + (1 + nodes[a]) / 2) / cells, (j + (1 + nodes[b]) / 2) / cells);
          sum += weights[a] * weights[b] * jet.p.dot(jet.u.cross(jet.v)) / (4 * cells * cells);
        }
  return sum;
}

/// The solid's volume is what the planes, cylinders and patches enclose, by Gauss's theorem about
/// the corner: planes through it have no part in it.
TEST(CornerFillet, OfACubeHoldsWhatItsSurfacesEnclose) {
  for (const std::vector<double>& radii_mm :
       {std::vector<double>{1}, std::vector<double>{1, 2, 3}, std::vector<double>{0.1, 2, 4}}) {
    const CornerFillet result = rounded(box(10, 10, 10), {0, 0, 0}, radii_mm);
    double cut_mm3 = 0, patches_mm3 = 0;
    for (const occ::CornerFilletEdge& edge : result.edges) {
      const double section_mm2 = (1 - pi / 4) * edge.radius_mm * edge.radius_mm;
      cut_mm3 += section_mm2 * (10 - edge.setback_mm) + section_mm2 * edge.setback_mm / 3;
    }
    for (const BezierPatch& patch : result.fill.patches) patches_mm3 += flux_mm3(patch);
    cut_mm3 += std::abs(patches_mm3) / 3;
    EXPECT_NEAR(volume_mm3(result.model.shape), 1000 - cut_mm3, 2e-5) << radii_mm.size();
  }
}

/// Identity (2): what a box grows by when it gets longer is its cross-section, rounded.
TEST(CornerFillet, TakesTheSectionOfEachFillet) {
  const std::vector<double> radii_mm = {1, 2, 3};
  const CornerFillet cube = rounded(box(10, 10, 10), {0, 0, 0}, radii_mm);
  const double volume = volume_mm3(cube.model.shape);
  for (int axis = 0; axis < 3; ++axis) {
    Vector3d sides(10, 10, 10);
    sides(axis) = 13;
    const CornerFillet longer = rounded(box(sides.x(), sides.y(), sides.z()), {0, 0, 0}, radii_mm);
    double radius_mm = 0;
    for (const occ::CornerFilletEdge& edge : longer.edges) {
      const TopTools_IndexedMapOfShape own =
          parts(box(sides.x(), sides.y(), sides.z()), TopAbs_EDGE);
      const TopoDS_Edge& at = TopoDS::Edge(own(edge.edge));
      if (BRep_Tool::Pnt(TopExp::FirstVertex(at)).Distance(BRep_Tool::Pnt(TopExp::LastVertex(at))) >
          12)
        radius_mm = edge.radius_mm;
    }
    ASSERT_GT(radius_mm, 0);
    const double section_mm2 = 100 - (1 - pi / 4) * radius_mm * radius_mm;
    EXPECT_NEAR(volume_mm3(longer.model.shape) - volume, 3 * section_mm2, 1e-5);
  }
}

/// Identity (3).
TEST(CornerFillet, MovesWithTheSolid) {
  std::mt19937 random(testSeed());
  for (const Case& of : cases()) {
    if (std::string(of.name) != "NotchMixed" && std::string(of.name) != "ObliquePyramid") continue;
    const CornerFillet here = rounded(of.shape, of.corner, of.radii_mm);
    for (const double scale : {1.0, 0.1, 20.0}) {
      gp_Trsf motion = randomMotion(random), size;
      size.SetScaleFactor(scale);
      motion.Multiply(size);
      const TopoDS_Shape moved = transformed(of.shape, motion);
      const Model model = modelFromShape(moved);
      CornerFilletOptions options;
      options.section_mm *= scale;
      for (const occ::CornerFilletEdge& edge : here.edges)
        options.radii_mm[edge.edge] = scale * edge.radius_mm;
      const CornerFillet there = cornerFillet(model, vertexAt(of.shape, of.corner), options);
      EXPECT_TRUE(there.met()) << of.name << ' ' << scale << ": " << there.shortfall.text;
      EXPECT_NEAR(volume_mm3(there.model.shape), std::pow(scale, 3) * volume_mm3(here.model.shape),
                  1e-6 * std::pow(scale, 3));
    }
  }
}

TEST(CornerFillet, LeavesTheRestOfAnAssemblyAlone) {
  gp_Trsf aside;
  aside.SetTranslation(gp_Vec(30, 0, 0));
  const TopoDS_Shape cube = box(10, 10, 10), other = located(cube, aside);
  BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, cube);
  builder.Add(both, other);
  Model model = modelFromShape(both);
  model.attributes = {{TopAbs_FACE, 1, "touched", {}, {}}, {TopAbs_FACE, 7, "far", {}, {}}};

  const int vertex = vertexAt(both, {30, 0, 0});
  const CornerFillet result = cornerFillet(model, vertex, withRadii(model, vertex, {1, 2, 3}));
  EXPECT_TRUE(result.met()) << result.shortfall.text;
  EXPECT_TRUE(BRepCheck_Analyzer(result.model.shape).IsValid());
  EXPECT_TRUE(parts(result.model.shape, TopAbs_SOLID)(1).IsSame(cube));
  EXPECT_NEAR(volume_mm3(result.model.shape) - 1000,
              volume_mm3(rounded(cube, {0, 0, 0}, {1, 2, 3}).model.shape), 1e-6);
  ASSERT_EQ(result.model.attributes.size(), 2U);
  EXPECT_EQ(result.model.attributes[0].index, 1);
  EXPECT_EQ(result.model.attributes[1].index, 7);
}

/// A second corner of the result of the first.
TEST(CornerFillet, RoundsOneCornerAfterAnother) {
  const CornerFillet first = rounded(box(20, 20, 20), {0, 0, 0}, {1, 2, 3});
  ASSERT_TRUE(first.met());
  const int opposite = vertexAt(first.model.shape, {20, 20, 20});
  const CornerFillet second =
      cornerFillet(first.model, opposite, withRadii(first.model, opposite, {2, 1, 1.5}));
  EXPECT_TRUE(second.met()) << second.shortfall.text;
  EXPECT_TRUE(BRepCheck_Analyzer(second.model.shape).IsValid());
  EXPECT_LT(volume_mm3(second.model.shape), volume_mm3(first.model.shape));
}

}  // namespace
}  // namespace seamwright::test
