// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws of corners with curved faces: symmetry, order, motion, scale and length; names; and what is
// refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <functional>
#include <gp_Cylinder.hxx>

#include "corner_solids.hpp"
#include "curved_corners.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using Eigen::Vector3d;
using occ::CornerFillet;
using occ::cornerFillet;
using occ::CornerFilletOptions;
using occ::Model;
using occ::modelFromShape;
using testing::HasSubstr;

gp_Pnt centroid(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.CentreOfMass();
}

TEST(CurvedCorner, OfASymmetricSolidIsSymmetric) {
  const CornerFillet mirrored = rounded(boxLessBall(), {10, 0, 0}, {1});
  const gp_Pnt centre = centroid(mirrored.model.shape), before = centroid(boxLessBall());
  EXPECT_NEAR(centre.Y(), centre.Z(), 1e-7);
  EXPECT_GT(centre.Distance(before), 1e-4);
  const gp_Pnt of_dome = centroid(rounded(vault(4, 35), apex(35), {1}).model.shape);
  EXPECT_NEAR(of_dome.X(), 0, 1e-6);
  EXPECT_NEAR(of_dome.Y(), 0, 1e-6);
}

/// The same solid with its faces, and so its edges, in another order.
TopoDS_Shape reordered(const TopoDS_Shape& shape) {
  const TopTools_IndexedMapOfShape faces = parts(shape, TopAbs_FACE);
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int k = faces.Extent(); k > 0; --k) sewing.Add(faces(k));
  sewing.Perform();
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TEST(CurvedCorner, DoesNotDependOnTheOrderOfTheEdges) {
  const auto roundedByLength = [](const TopoDS_Shape& shape) {
    const Model model = modelFromShape(shape);
    const int vertex = vertexAt(shape, {20, 0, 0});
    const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
    CornerFilletOptions options;
    for (const int edge : occ::cornerEdges(model, vertex)) {
      GProp_GProps properties;
      BRepGProp::LinearProperties(edges(edge), properties);
      options.radii_mm[edge] = properties.Mass() / 15;  // 20, 30 (the arc), 40 mm
    }
    return volume_mm3(cornerFillet(model, vertex, options).model.shape);
  };
  const TopoDS_Shape shape = wedge(20, 40), other = reordered(shape);
  EXPECT_NE(vertexAt(shape, {20, 0, 0}), vertexAt(other, {20, 0, 0}));
  EXPECT_NEAR(roundedByLength(shape), roundedByLength(other), 1e-5);
}

/// Identities (2) and (3) of cornerFillet(), to what OpenCASCADE's bands and the fits of the sides
/// leave.
TEST(CurvedCorner, TakesTheSectionOfEachFillet) {
  const TopoDS_Shape given = wedge(20, 30);
  const CornerFillet here = rounded(given, {20, 0, 0}, {1, 2, 3});
  const CornerFillet longer = rounded(wedge(20, 40), {20, 0, 0}, {1, 2, 3});
  int found = 0;
  for (const occ::CornerFilletEdge& edge : here.edges) {
    const TopoDS_Edge along = TopoDS::Edge(parts(given, TopAbs_EDGE)(edge.edge));
    const double height = BRep_Tool::Pnt(TopExp::LastVertex(along)).Z() +
                          BRep_Tool::Pnt(TopExp::FirstVertex(along)).Z();
    if (height < 30) continue;
    ++found;
    const double section_mm2 = volume_mm3(native(given, {edge})) / 30;
    EXPECT_NEAR(volume_mm3(longer.model.shape) - volume_mm3(here.model.shape), 10 * section_mm2,
                1e-3);
  }
  EXPECT_EQ(found, 1);
}

TEST(CurvedCorner, MovesWithTheSolid) {
  std::mt19937 random(testSeed());
  struct Case {
    TopoDS_Shape shape;
    Vector3d corner;
    std::vector<double> radii_mm;
  };
  const std::vector<Case> cases = {{wedge(20, 30), {20, 0, 0}, {1, 2, 3}},
                                   {blockOnCylinder(), {std::sqrt(375.0), 5, 15}, {1, 2, 1}}};
  for (const Case& of : cases) {
    const CornerFillet here = rounded(of.shape, of.corner, of.radii_mm);
    for (const double scale : {1.0, 0.2, 10.0}) {
      gp_Trsf motion = randomMotion(random), size;
      size.SetScaleFactor(scale);
      motion.Multiply(size);
      const TopoDS_Shape moved = transformed(of.shape, motion);
      CornerFilletOptions options;
      options.tolerance.gap_mm *= scale;
      for (const occ::CornerFilletEdge& edge : here.edges)
        options.radii_mm[edge.edge] = scale * edge.radius_mm;
      const CornerFillet there =
          cornerFillet(modelFromShape(moved), vertexAt(of.shape, of.corner), options);
      EXPECT_TRUE(there.met()) << scale << ": " << there.shortfall.text;
      EXPECT_NEAR(volume_mm3(there.model.shape) / std::pow(scale, 3), volume_mm3(here.model.shape),
                  1e-6 * volume_mm3(here.model.shape));
    }
  }
}

TEST(CurvedCorner, KeepsTheNamesOfFaces) {
  const TopoDS_Shape shape = wedge(20, 30);
  Model model = modelFromShape(shape);
  const TopTools_IndexedMapOfShape faces = parts(shape, TopAbs_FACE);
  for (int face = 1; face <= faces.Extent(); ++face) {
    const BRepAdaptor_Surface surface(TopoDS::Face(faces(face)));
    const bool curved = surface.GetType() == GeomAbs_Cylinder;
    model.attributes.push_back({TopAbs_FACE, face, curved ? "curved" : "flat", {}, {}});
  }
  const int vertex = vertexAt(shape, {20, 0, 0});
  const CornerFillet result = cornerFillet(model, vertex, withRadii(model, vertex, {1, 2, 3}));
  const TopTools_IndexedMapOfShape now = parts(result.model.shape, TopAbs_FACE);
  ASSERT_EQ(result.model.attributes.size(), model.attributes.size());
  for (const occ::ShapeAttribute& attribute : result.model.attributes) {
    const BRepAdaptor_Surface surface(TopoDS::Face(now(attribute.index)));
    if (attribute.name == "flat") {
      EXPECT_EQ(surface.GetType(), GeomAbs_Plane);
    } else {
      ASSERT_EQ(surface.GetType(), GeomAbs_Cylinder);
      EXPECT_NEAR(surface.Cylinder().Radius(), 20, 1e-9);
    }
  }
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(CurvedCorner, SaysWhatItCanNotDo) {
  const TopoDS_Shape shape = wedge(20, 30);
  const Model model = modelFromShape(shape);
  const int vertex = vertexAt(shape, {20, 0, 0});
  CornerFilletOptions options = withRadii(model, vertex, {2});
  options.patches_only = true;
  const int edge = options.radii_mm.begin()->first;
  options.setbacks_mm[edge] = 2.01;
  EXPECT_THAT(refusal([&] { cornerFillet(model, vertex, options); }),
              HasSubstr("a setback of 2.01 mm is not within its fillet"));
  options.setbacks_mm[edge] = 100;
  EXPECT_THAT(refusal([&] { cornerFillet(model, vertex, options); }),
              HasSubstr("set back by 100 mm would begin beyond its end"));
  EXPECT_THAT(refusal([&] { cornerFillet(model, vertex, withRadii(model, vertex, {25})); }),
              HasSubstr("edge "));

  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(20, 0, 30, 1.5).Shape();
  EXPECT_THAT(refusal([&] {
                occ::cornerEdges(modelFromShape(cone), vertexAt(cone, {0, 0, 30}));
              }),
              HasSubstr("are needed"));
}

}  // namespace
}  // namespace seamwright::test
