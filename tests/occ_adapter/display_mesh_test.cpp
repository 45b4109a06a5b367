// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gp_Pln.hxx>
#include <map>
#include <numbers>
#include <optional>

#include <seamwright/occ_adapter/display/mesh.hpp>
#include <seamwright/occ_adapter/model/read.hpp>

#include "broken_files.hpp"
#include "files.hpp"
#include "repair_trials.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using Eigen::Vector3d;
using occ::DisplayMesh;

occ::Model modelOf(const TopoDS_Shape& shape) {
  return occ::modelFromShape(shape);
}

double exactArea(const TopoDS_Shape& face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(TopoDS::Face(face), properties, 1e-4);
  return std::abs(properties.Mass());
}

/// Twice the area of a triangle as a vector, by the order of its nodes.
Vector3d across(const DisplayMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
}

Vector3d meanNormal(const DisplayMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return mesh.normals[a] + mesh.normals[b] + mesh.normals[c];
}

/// Of the triangles of a face; those against their normals count as negative.
double meshArea(const DisplayMesh& mesh, std::size_t face) {
  double area = 0;
  for (std::size_t i = mesh.first_triangles[face]; i < mesh.first_triangles[face + 1]; ++i)
    area += std::copysign(0.5 * across(mesh, i).norm(), across(mesh, i).dot(meanNormal(mesh, i)));
  return area;
}

/// Of the faces that are not among the faults.
void expectCovers(const DisplayMesh& mesh, const TopoDS_Shape& shape, double share = 0.01) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  ASSERT_EQ(mesh.first_nodes.size(), static_cast<std::size_t>(faces.Extent()) + 1);
  ASSERT_EQ(mesh.first_triangles.size(), mesh.first_nodes.size());
  for (int i = 0; i < faces.Extent(); ++i) {
    if (std::ranges::find(mesh.faults, i + 1, &occ::MeshFault::face) != mesh.faults.end()) continue;
    const double exact = exactArea(faces(i + 1));
    EXPECT_NEAR(meshArea(mesh, i), exact, share * exact) << "face " << i + 1;
  }
}

/// Whether a node is the point of the face at its parameters, inside its outline or on it. This is
/// for surfaces with kinks, where OpenCASCADE finds no nearest point.
bool isPointOfFace(const TopoDS_Face& face, const Vector3d& p, const Eigen::Vector2d& uv) {
  const gp_Pnt on = BRep_Tool::Surface(face)->Value(uv.x(), uv.y());
  const BRepClass_FaceClassifier classifier(face, gp_Pnt2d(uv.x(), uv.y()), 1e-6);
  return on.Distance({p.x(), p.y(), p.z()}) < 1e-9 * (1 + p.norm()) &&
         classifier.State() != TopAbs_OUT;
}

double toleranceOf(const TopoDS_Face& face) {
  double tolerance = 1e-6 + BRep_Tool::Tolerance(face);
  const TopTools_IndexedMapOfShape edges = partsOf(face, TopAbs_EDGE);
  for (int k = 1; k <= edges.Extent(); ++k)
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(edges(k))));
  return tolerance;
}

/// For about \p count nodes of all faces.
void expectNodesOnFaces(const DisplayMesh& mesh, const TopoDS_Shape& shape, std::size_t count) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  const std::size_t step = std::max<std::size_t>(1, mesh.points.size() / count);
  for (std::size_t i = step / 2, face = 0; i < mesh.points.size(); i += step) {
    while (mesh.first_nodes[face + 1] <= i) ++face;
    const TopoDS_Face on = TopoDS::Face(faces(static_cast<int>(face) + 1));
    const Vector3d& p = mesh.points[i];
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex({p.x(), p.y(), p.z()}).Vertex();
    const double distance = BRepExtrema_DistShapeShape(vertex, on).Value();
    EXPECT_TRUE(distance < toleranceOf(on) || isPointOfFace(on, p, mesh.parameters[i]))
        << "face " << face + 1 << ", node " << i << ", distance " << distance;
  }
}

TopoDS_Face bump(double height_mm) {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      poles(i + 1, j + 1) =
          gp_Pnt(10.0 * i, 10.0 * j, i % 3 != 0 && j % 3 != 0 ? height_mm : 0.1 * i * j);
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face();
}

TEST(DisplayMesh, NormalsAndCurvaturesOfKnownSurfaces) {
  static constexpr double r = 5, tube = 2;
  const auto check = [](const TopoDS_Shape& shape, const auto& outward, const auto& curvature) {
    const DisplayMesh mesh = occ::displayMesh(modelOf(shape));
    ASSERT_EQ(mesh.curvatures.size(), mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      EXPECT_LT((mesh.normals[i] - outward(mesh.points[i])).norm(), 1e-8) << i;
      const auto [k1, k2] = curvature(mesh.points[i]);
      EXPECT_NEAR(mesh.curvatures[i].k1, k1, 1e-5) << i;
      EXPECT_NEAR(mesh.curvatures[i].k2, k2, 1e-5) << i;
    }
  };
  const auto away = [](const Vector3d& p) -> Vector3d { return p / r; };
  // With poles at both ends and closed.
  check(BRepPrimAPI_MakeSphere(r).Face(), away,
        [](const Vector3d&) { return std::pair(-1 / r, -1 / r); });
  check(
      BRepPrimAPI_MakeCylinder(r, 9).Face(),
      [](const Vector3d& p) -> Vector3d { return Vector3d(p.x(), p.y(), 0) / r; },
      [](const Vector3d&) { return std::pair(0.0, -1 / r); });
  check(
      BRepPrimAPI_MakeTorus(r, tube).Face(),
      [](const Vector3d& p) -> Vector3d {
        return (p - r * Vector3d(p.x(), p.y(), 0).normalized()) / tube;
      },
      [](const Vector3d& p) {
        const double ring = std::hypot(p.x(), p.y());
        return std::pair(-(ring - r) / tube / ring, -1 / tube);
      });
  check(
      BRepPrimAPI_MakeSphere(r).Face().Reversed(),
      [&](const Vector3d& p) -> Vector3d { return -away(p); },
      [](const Vector3d&) { return std::pair(1 / r, 1 / r); });
}

TEST(DisplayMesh, TheTipOfAConeHasTheNormalOfItsParameterAndNoCurvature) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(5, 0, 8).Face();
  const DisplayMesh mesh = occ::displayMesh(modelOf(cone));
  int tips = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_NEAR(mesh.normals[i].z(), 5 / std::hypot(5, 8), 1e-8);
    EXPECT_NEAR(mesh.normals[i].head<2>().dot(Eigen::Rotation2Dd(mesh.parameters[i].x()) *
                                              Eigen::Vector2d(1, 0)),
                8 / std::hypot(5, 8), 1e-8);
    if ((mesh.points[i] - Vector3d(0, 0, 8)).norm() > 1e-9) continue;
    ++tips;
    EXPECT_TRUE(std::isnan(mesh.curvatures[i].k2));
  }
  EXPECT_GT(tips, 0);
}

TEST(DisplayMesh, CoversFacesOfManyKindsAndLooksOutward) {
  const std::map<std::string, TopoDS_Shape> shapes = {
      {"box", box()},
      {"ball", BRepPrimAPI_MakeSphere(5).Shape()},
      {"cap", BRepPrimAPI_MakeSphere(5.0, 0.3, 1.2).Shape()},
      {"cone", BRepPrimAPI_MakeCone(5, 0, 8).Shape()},
      {"torus", BRepPrimAPI_MakeTorus(10, 3).Shape()},
      {"narrow bent strip", BRepPrimAPI_MakeTorus(103, 0.5, 4.7, 6.2, 1.0).Face()},
      {"reversed", bump(20).Reversed()},
      {"quarter of a cylinder", planeAndCylinder(5, 20)},
      {"folded", foldedPlanes()}};
  std::mt19937 random(testSeed());
  for (const auto& [name, shape] : shapes)
    for (const TopoDS_Shape& placed : {shape, located(shape, randomMotion(random))}) {
      SCOPED_TRACE(name);
      const DisplayMesh mesh = occ::displayMesh(modelOf(placed));
      EXPECT_THAT(mesh.faults, testing::IsEmpty());
      expectCovers(mesh, placed, 5e-3);
      expectNodesOnFaces(mesh, placed, 60);
      for (const Vector3d& normal : mesh.normals) EXPECT_NEAR(normal.norm(), 1, 1e-12);
    }
}

TEST(DisplayMesh, TheMeshOfAMirroredPlaceIsTheMirrorImage) {
  gp_Trsf mirror, larger;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 2)));
  larger.SetScale(gp_Pnt(1, 1, 1), 3);
  const TopoDS_Face given = bump(20);
  const DisplayMesh mesh = occ::displayMesh(modelOf(given));
  for (const gp_Trsf& by : {mirror, larger}) {
    const TopoDS_Shape shape = located(given, by);
    const DisplayMesh image = occ::displayMesh(modelOf(shape));
    EXPECT_NEAR(meshArea(image, 0), std::pow(by.ScaleFactor(), 2) * meshArea(mesh, 0),
                5e-3 * meshArea(image, 0));
    const double factor = std::abs(by.ScaleFactor());
    const gp_Trsf back = by.Inverted();
    for (std::size_t i = 0; i < image.points.size(); ++i) {
      const gp_Pnt p =
          gp_Pnt(image.points[i].x(), image.points[i].y(), image.points[i].z()).Transformed(back);
      const gp_Vec n = gp_Vec(image.normals[i].x(), image.normals[i].y(), image.normals[i].z())
                           .Transformed(back);
      gp_Pnt on;
      gp_Vec du, dv, duu, dvv, duv;
      BRep_Tool::Surface(given)->D2(image.parameters[i].x(), image.parameters[i].y(), on, du, dv,
                                    duu, dvv, duv);
      const gp_Vec normal = du.Crossed(dv).Normalized();
      EXPECT_LT(on.Distance(p), 1e-9);
      EXPECT_LT((normal - factor * n).Magnitude(), 1e-9);
      // Gaussian curvature is that of the second form over the first.
      const double second = duu.Dot(normal) * dvv.Dot(normal) - std::pow(duv.Dot(normal), 2);
      const double gauss = second / du.Crossed(dv).SquareMagnitude();
      EXPECT_NEAR(factor * factor * image.curvatures[i].k1 * image.curvatures[i].k2, gauss, 1e-9);
    }
  }
}

/// The angle that a graphics card's normal in a triangle, the mean of the corners', is off at its
/// centre.
TEST(DisplayMesh, NormalsBetweenNodesAreNearlyThoseOfTheSurface) {
  const TopoDS_Face face = bump(20);
  const occ::DisplayMeshOptions options;
  const DisplayMesh mesh = occ::displayMesh(modelOf(face), options);
  double worst = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Eigen::Vector2d uv = (mesh.parameters[a] + mesh.parameters[b] + mesh.parameters[c]) / 3;
    gp_Pnt p;
    gp_Vec du, dv;
    BRep_Tool::Surface(face)->D1(uv.x(), uv.y(), p, du, dv);
    const gp_Vec n = du.Crossed(dv).Normalized();
    worst = std::max(worst,
                     Vector3d(n.X(), n.Y(), n.Z()).cross(meanNormal(mesh, i).normalized()).norm());
    for (const auto& [one, other] : {std::pair(a, b), {b, c}, {c, a}})
      EXPECT_LT(mesh.normals[one].cross(mesh.normals[other]).norm(),
                std::sin(options.turn_rad) + 1e-12);
  }
  EXPECT_LT(worst, 2 * options.bend_rel * options.turn_rad);
}

TEST(DisplayMesh, FacesHaveNoGapsInsideAndMeetOnEdges) {
  const TopoDS_Shape shape = planeAndCylinder(5, 20);
  const DisplayMesh mesh = occ::displayMesh(modelOf(shape));
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  std::map<std::pair<int, int>, int> uses;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& [one, other] : {std::pair(a, b), {b, c}, {c, a}}) ++uses[{one, other}];
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    if (uses.contains({edge.second, edge.first})) continue;
    double nearest = INFINITY;  // of both ends to one edge of the shape
    for (int i = 1; i <= edges.Extent(); ++i) {
      double farthest = 0;
      for (const int node : {edge.first, edge.second}) {
        const Vector3d& p = mesh.points[node];
        const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex({p.x(), p.y(), p.z()}).Vertex();
        farthest = std::max(farthest, BRepExtrema_DistShapeShape(vertex, edges(i)).Value());
      }
      nearest = std::min(nearest, farthest);
    }
    EXPECT_LT(nearest, 1e-6);
  }
}

/// A ball and a ring that touch along a circle.
TEST(DisplayMesh, NodesOnACommonEdgeAreThoseOfBothFaces) {
  const TopoDS_Shape shape = sphereAndTorus(10, 4);
  const DisplayMesh mesh = occ::displayMesh(modelOf(shape));
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  ASSERT_EQ(faces.Extent(), 2);
  const auto onBoth = [&](std::size_t face) {
    std::vector<Vector3d> nodes;
    for (std::size_t i = mesh.first_nodes[face]; i < mesh.first_nodes[face + 1]; ++i) {
      const Vector3d& p = mesh.points[i];
      const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex({p.x(), p.y(), p.z()}).Vertex();
      if (BRepExtrema_DistShapeShape(vertex, faces(face == 0 ? 2 : 1)).Value() < 1e-6)
        nodes.push_back(p);
    }
    return nodes;
  };
  const std::vector<Vector3d> first = onBoth(0), second = onBoth(1);
  EXPECT_GT(first.size(), 8u);
  for (const auto& [these, those] : {std::pair(first, second), std::pair(second, first)})
    for (const Vector3d& p : these)
      EXPECT_LT(std::ranges::min(those, {}, [&](const Vector3d& q) { return (p - q).norm(); })
                    .
                    operator-(p)
                    .norm(),
                1e-6);
}

TEST(DisplayMesh, TheShapeKeepsItsOwnTriangles) {
  const TopoDS_Face plain = bump(20), stored = bump(20);
  const opencascade::handle<Poly_Triangulation> own = new Poly_Triangulation(3, 1, false);
  BRep_Builder().UpdateFace(stored, own);
  for (const TopoDS_Face& face : {plain, stored}) {
    TopLoc_Location location;
    const opencascade::handle<Poly_Triangulation> before = BRep_Tool::Triangulation(face, location);
    EXPECT_GT(occ::displayMesh(modelOf(face)).triangles.size(), 20u);
    EXPECT_EQ(BRep_Tool::Triangulation(face, location), before);
    EXPECT_EQ(before.IsNull(), face.IsSame(plain));
  }
}

/// A face whose outline crosses itself.
TEST(DisplayMesh, AFaceThatCannotBeTriangulatedIsReportedByNumber) {
  BRepBuilderAPI_MakePolygon eight;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {10.0, 10.0}, {10.0, 0.0}, {0.0, 10.0}})
    eight.Add(gp_Pnt(x, y, 0));
  eight.Close();
  const TopoDS_Face crossed = BRepBuilderAPI_MakeFace(gp_Pln(), eight.Wire(), true).Face();
  const DisplayMesh mesh = occ::displayMesh(modelOf(compoundOf({plate(0, 5, 0, 5, 3), crossed})));
  ASSERT_EQ(mesh.faults.size(), 1u);
  EXPECT_EQ(mesh.faults[0].face, 2);
  EXPECT_THAT(mesh.faults[0].reason, testing::HasSubstr("triangles"));
  EXPECT_NEAR(meshArea(mesh, 0), 25, 1e-9);
}

/// OpenCASCADE's triangulation of such a face takes minutes or does not end.
TEST(DisplayMesh, AFaceWithUnusableNumbersIsReportedAndTheOthersAreTriangulated) {
  const double nan = std::nan("");
  const TopoDS_Face surface = bump(3);
  const TopoDS_Shape edge = plate(10, 15, 0, 5);
  opencascade::handle<Geom_BezierSurface>::DownCast(BRep_Tool::Surface(surface))
      ->SetPole(2, 3, gp_Pnt(nan, INFINITY, 0));
  const TopoDS_Shape side = partsOf(edge, TopAbs_EDGE)(1);
  BRep_Builder().UpdateEdge(TopoDS::Edge(side), INFINITY);
  const TopoDS_Shape all =
      compoundOf({surface, plate(0, 5, 0, 5, 3), edge, plate(20, 25, 0, 5, 3)});
  const DisplayMesh mesh = occ::displayMesh(modelOf(all));
  ASSERT_EQ(mesh.faults.size(), 2u);
  EXPECT_EQ(mesh.faults[0].face, 1);
  EXPECT_THAT(mesh.faults[0].reason, testing::HasSubstr("nan"));
  EXPECT_EQ(mesh.faults[1].face, 3);
  EXPECT_THAT(mesh.faults[1].reason, testing::HasSubstr("edge"));
  EXPECT_NEAR(meshArea(mesh, 0), 0, 0);
  EXPECT_NEAR(meshArea(mesh, 1), 25, 1e-9);
  EXPECT_NEAR(meshArea(mesh, 2), 0, 0);
  EXPECT_NEAR(meshArea(mesh, 3), 25, 1e-9);
}

TEST(DisplayMesh, MovesAreThoseOfTheParameters) {
  const TopoDS_Face before = bump(20), after = bump(20.5);
  const TopoDS_Shape old = compoundOf({plate(-9, -5, 0, 5), before}),
                     now = compoundOf({plate(-9, -5, 0, 5), after});
  occ::MovedFaces moved{old, {2}, 0.01};
  const DisplayMesh mesh = occ::displayMesh(modelOf(now), {}, moved);
  ASSERT_EQ(mesh.moves_mm.size(), mesh.points.size());
  const auto bernstein = [](double t) { return 3 * t * (1 - t); };  // of both inner poles together
  const auto move = [&](const Eigen::Vector2d& uv) {
    return 0.5 * bernstein(uv.x()) * bernstein(uv.y());
  };
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    EXPECT_NEAR(mesh.moves_mm[i], i < mesh.first_nodes[1] ? 0 : move(mesh.parameters[i]), 1e-9);
  for (std::size_t i = mesh.first_triangles[1]; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Eigen::Vector2d uv = (mesh.parameters[a] + mesh.parameters[b] + mesh.parameters[c]) / 3;
    EXPECT_NEAR((mesh.moves_mm[a] + mesh.moves_mm[b] + mesh.moves_mm[c]) / 3, move(uv), 0.02);
  }
}

TEST(DisplayMesh, BadArgumentsAndStopping) {
  const occ::Model model = modelOf(box());
  EXPECT_THROW(occ::displayMesh(model, {.turn_rad = 0}), std::invalid_argument);
  EXPECT_THROW(occ::displayMesh(model, {.sag_rel = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(occ::displayMesh(model, {}, {box(), {7}}), std::invalid_argument);
  EXPECT_THROW(occ::displayMesh(model, {}, {bump(1), {}}), std::invalid_argument);
  EXPECT_THROW(occ::displayMesh(model, {}, {}, [](double) { return false; }), occ::Cancelled);
  double last = 0;
  occ::displayMesh(model, {}, {}, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return true;
  });
  EXPECT_EQ(last, 1);
}

TEST(DisplayMesh, TheNumberOfThreadsChangesNothing) {
  const occ::Model model = modelOf(BRepPrimAPI_MakeTorus(10, 3).Shape());
  const DisplayMesh one = occ::displayMesh(model, {.jobs = 1}),
                    four = occ::displayMesh(model, {.jobs = 4});
  EXPECT_EQ(one.points, four.points);
  EXPECT_EQ(one.triangles, four.triangles);
}

class DisplayMeshOfFiles : public testing::TestWithParam<const char*> {};

void expectMeshed(const occ::Model& model) {
  const DisplayMesh mesh = occ::displayMesh(model, {.curvatures = false});
  EXPECT_THAT(mesh.faults, testing::IsEmpty());
  expectCovers(mesh, model.shape);
  expectNodesOnFaces(mesh, model.shape, 30);
}

TEST_P(DisplayMeshOfFiles, CoversEveryFaceWithNodesOnIt) {
  expectMeshed(occ::readModel(occtModel(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Occt, DisplayMeshOfFiles,
                         testing::Values("step/linkrods.step", "step/screw.step",
                                         "iges/bearing.iges", "occ/bottle.brep", "occ/hammer.brep",
                                         "occ/shell1.brep", "occ/CrankArm.brep", "occ/Motor-c.brep",
                                         "occ/Pump_Nut.brep"),
                         [](const auto& file) {
                           std::string name = std::filesystem::path(file.param).stem();
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(DisplayMesh, CoversEveryFaceOfNetsWithNodesOnIt) {
  for (const NetKind& kind : netKinds()) {
    SCOPED_TRACE(kind.name);
    expectMeshed(occ::modelFromShape(brokenModel({kind.name, 0.01, testSeed()})));
  }
}

TEST(DisplayMesh, BrokenFilesThatCanBeReadAreCoveredButForTheFacesNamed) {
  const Folder folder;
  std::mt19937 random(testSeed());
  int meshed = 0;
  for (const std::filesystem::path& path : brokenFiles(folder, random)) {
    SCOPED_TRACE(path.filename().string());
    std::optional<occ::Model> model;
    try {
      model = occ::readModel(path);
    } catch (const occ::ModelError&) {
      continue;  // what can't be read has no mesh
    }
    const DisplayMesh mesh = occ::displayMesh(*model, {.curvatures = false});
    EXPECT_LT(mesh.faults.size(), mesh.first_nodes.size() - 1) << "all faces are named";
    expectCovers(mesh, model->shape);
    expectNodesOnFaces(mesh, model->shape, 30);
    ++meshed;
  }
  EXPECT_GE(meshed, 3);
}

/// One face of 310 by 321 knots.
TEST(DisplayMesh, CoversTerrain) {
  const occ::Model model = occ::readModel(occtModel("occ/terrain.brep"));
  const DisplayMesh mesh = occ::displayMesh(model, {.curvatures = false});
  EXPECT_THAT(mesh.faults, testing::IsEmpty());
  expectCovers(mesh, model.shape);
  const TopoDS_Face face = TopoDS::Face(partsOf(model.shape, TopAbs_FACE)(1));
  for (std::size_t i = 0; i < mesh.points.size(); i += 500)
    EXPECT_TRUE(isPointOfFace(face, mesh.points[i], mesh.parameters[i])) << "node " << i;
}

}  // namespace
}  // namespace seamwright::test
