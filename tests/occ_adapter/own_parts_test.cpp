// SPDX-License-Identifier: LGPL-2.1-or-later
// Prisms and revolutions whose ends are two instances of one face.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "dense_oracle.hpp"
#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/occ_adapter/topology/own_parts.hpp>

namespace seamwright::test {
namespace {

using occ::RepairReport;
using occ::withOwnParts;
using testing::HasSubstr;

/// In the plane y = 0: two sides are one but for the angle, at x = 30.
TopoDS_Face outline(double angle_rad) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner :
       {gp_Pnt(10, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(50, 0, 20 * std::tan(angle_rad)),
        gp_Pnt(50, 0, 20), gp_Pnt(10, 0, 20)})
    polygon.Add(corner);
  polygon.Close();
  return BRepBuilderAPI_MakeFace(polygon.Wire()).Face();
}

TopoDS_Shape prism(double angle_rad = 0.4 * degree) {
  return BRepPrimAPI_MakePrism(outline(angle_rad), gp_Vec(0, 10, 0)).Shape();
}

TopoDS_Shape partOfARing(double angle_rad = 0.4 * degree) {
  return BRepPrimAPI_MakeRevol(outline(angle_rad), gp::OZ(), 2.0).Shape();
}

TopoDS_Shape sheet() {
  return BRepPrimAPI_MakePrism(
             BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(20, 0, 0), gp_Pnt(40, 0, 0.14))
                 .Wire(),
             gp_Vec(0, 10, 0))
      .Shape();
}

TopoDS_Shape twice(const TopoDS_Shape& part) {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, part);
  gp_Trsf away;
  away.SetTranslation(gp_Vec(0, 100, 0));
  builder.Add(both, part.Moved(away));
  return both;
}

std::size_t kindsOf(const TopTools_IndexedMapOfShape& parts) {
  std::set<const TopoDS_TShape*> kinds;
  for (int i = 1; i <= parts.Extent(); ++i) kinds.insert(parts(i).TShape().get());
  return kinds.size();
}

double volume_mm3(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

TEST(OwnParts, NothingStandsTwice) {
  std::mt19937 generator(testSeed());
  for (const TopoDS_Shape& made : {prism(), partOfARing(), sheet()})
    for (const TopoDS_Shape& shape :
         {made, TopoDS_Shape(made.Reversed()), located(made, randomMotion(generator))}) {
      const TopoDS_Shape own = withOwnParts(shape);
      EXPECT_EQ(own.Orientation(), shape.Orientation());
      EXPECT_TRUE(own.Location() == shape.Location());
      EXPECT_TRUE(BRepCheck_Analyzer(own).IsValid());
      EXPECT_DOUBLE_EQ(volume_mm3(own), volume_mm3(shape));
      for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
        const TopTools_IndexedMapOfShape before = partsOf(shape, kind), after = partsOf(own, kind);
        ASSERT_EQ(after.Extent(), before.Extent());
        if (kind != TopAbs_FACE) {
          EXPECT_LT(kindsOf(before), before.Extent());
        }
        EXPECT_EQ(kindsOf(after), after.Extent());
        for (int i = 1; i <= after.Extent(); ++i) {
          EXPECT_EQ(after(i).Orientation(), before(i).Orientation());
          EXPECT_TRUE(after(i).Location() == before(i).Location());
        }
      }
    }
}

TEST(OwnParts, WhatHasItsOwnStays) {
  for (const TopoDS_Shape& shape : {planeAndCylinder(10, 20), withOwnParts(prism())})
    EXPECT_TRUE(withOwnParts(shape).IsEqual(shape));
}

TEST(OwnParts, PartsOfAnAssemblyStayInstances) {
  const TopoDS_Shape pair = twice(prism());
  EXPECT_TRUE(withOwnParts(pair).IsEqual(pair));
  // One that stands alone beside them is parted.
  const TopoDS_Shape alone = partOfARing();
  TopoDS_Shape more = pair.EmptyCopied();
  const BRep_Builder builder;
  builder.Add(more, pair);
  builder.Add(more, alone);
  const TopoDS_Shape own = withOwnParts(more);
  const TopTools_IndexedMapOfShape solids = partsOf(own, TopAbs_SOLID);
  ASSERT_EQ(solids.Extent(), 3);
  EXPECT_TRUE(solids(1).IsPartner(solids(2)));
  EXPECT_TRUE(solids(1).IsPartner(partsOf(pair, TopAbs_SOLID)(1)));
  EXPECT_EQ(kindsOf(partsOf(solids(3), TopAbs_EDGE)), partsOf(alone, TopAbs_EDGE).Extent());
}

RepairReport repaired(const TopoDS_Shape& shape, const std::vector<int>& fixed = {}) {
  occ::RepairOptions options;
  options.convert_analytic = true;
  options.fixed_faces = fixed;
  return repair(occ::modelFromShape(shape), options);
}

TEST(OwnParts, PrismsAndRevolutionsAreConverted) {
  for (const TopoDS_Shape& shape : {prism(), partOfARing(), sheet()}) {
    const RepairReport report = repaired(shape);
    const auto seam = std::ranges::find(report.seams, true, &occ::SeamRepair::treated);
    ASSERT_NE(seam, report.seams.end());
    EXPECT_TRUE(seam->repaired) << seam->reason.text;
    EXPECT_GE(report.converted.size(), 1);
    EXPECT_LE(report.converted.size(), 2);  // two share the turn
    EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
    for (const occ::SeamRepair& other : report.seams)
      EXPECT_GE(other.after.verdict.level, other.before.verdict.level) << describe(other.after);
    const auto sides = denseSides(report.model.shape, seam->after.edges[0], seam->after.faces);
    ASSERT_TRUE(sides);
    EXPECT_LE(denseMaxima(*sides, 301, {}).angle_rad->sure(), 0.1 * degree);
  }
}

TEST(OwnParts, InstancesOfAnAssemblyAreConvertedAlike) {
  const TopoDS_Shape pair = twice(prism());
  const RepairReport alone = repaired(prism()), report = repaired(pair);
  ASSERT_GE(alone.converted.size(), 1);
  EXPECT_EQ(report.converted.size(), 2 * alone.converted.size());
  int repaired_seams = 0;
  for (const occ::SeamRepair& seam : report.seams) repaired_seams += seam.repaired ? 1 : 0;
  EXPECT_EQ(repaired_seams, 2);
  const TopTools_IndexedMapOfShape solids = partsOf(report.model.shape, TopAbs_SOLID);
  ASSERT_EQ(solids.Extent(), 2);
  EXPECT_TRUE(solids(1).IsPartner(solids(2)));
  EXPECT_FALSE(solids(1).IsPartner(partsOf(pair, TopAbs_SOLID)(1)));
}

TEST(OwnParts, FacesWithEdgesThatStandElsewhereStay) {
  const TopoDS_Shape solid = prism();
  const RepairReport alone = repaired(solid);
  const int kinked =
      std::ranges::find(alone.seams, true, &occ::SeamRepair::treated)->before.edges[0];
  gp_Trsf away;
  away.SetTranslation(gp_Vec(0, 500, 0));
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, solid);
  builder.Add(both, located(partsOf(solid, TopAbs_EDGE)(kinked), away));
  const RepairReport report = repaired(both);
  EXPECT_FALSE(report.changed());
  int told = 0;
  for (const occ::SeamRepair& seam : report.seams)
    if (seam.before.verdict.seam_class == SeamClass::Defect) {
      EXPECT_THAT(seam.reason.text, HasSubstr("has edge " + std::to_string(kinked) +
                                              ", which occurs in the model 2 times"));
      ++told;
    }
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace seamwright::test
