// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners that OpenCASCADE fills because patches can't. Beside OpenCASCADE's checks: volumes in
// closed form, distances to the ball that rolls along the edges.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Eigen/Geometry>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Sphere.hxx>
#include <numbers>

#include "corner_solids.hpp"
#include "curved_corners.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

using Eigen::Vector3d;
using occ::CornerFiller;
using occ::CornerFillet;
using occ::cornerFillet;
using occ::CornerFilletOptions;
using occ::CornerSeamKind;
using occ::Model;
using occ::modelFromShape;
using std::numbers::pi;
using testing::HasSubstr;

/// The part of a cube of side r beside an edge that a fillet of radius r removes, and that beside a
/// corner of three edges, all of radius r.
double removedBesideEdge(double r) {
  return (1 - pi / 4) * r * r * r;
}
double removedAtCorner(double r) {
  return (1 - pi / 6) * r * r * r;
}

/// Patches need 1.5 r of each edge or more, OpenCASCADE's octant of a sphere only r.
constexpr double side = 10, tight_radius = 8;

CornerFillet tightCube(double radius_mm = tight_radius) {
  return rounded(box(side, side, side), {0, 0, 0}, {radius_mm});
}

TEST(CornerOfOpenCascade, IsTheResultWherePatchesHaveNoRoom) {
  const CornerFillet made = tightCube();
  EXPECT_TRUE(made.met()) << made.shortfall.text;
  EXPECT_EQ(made.filler, CornerFiller::OpenCascade);
  EXPECT_EQ(made.patches_shortfall.fault, occ::CornerFault::SetbackTooLarge);
  EXPECT_THAT(made.patches_shortfall.text, HasSubstr("set back by"));
  EXPECT_TRUE(made.fill.patches.empty());
  EXPECT_TRUE(BRepCheck_Analyzer(made.model.shape).IsValid());
  const occ::Report report = occ::analyze(made.model);
  EXPECT_TRUE(report.open.empty() && report.non_manifold.empty());
}

TEST(CornerOfOpenCascade, HasTheVolumeOfTheClosedForm) {
  for (const double r : {7.0, tight_radius}) {
    const CornerFillet made = tightCube(r);
    ASSERT_EQ(made.filler, CornerFiller::OpenCascade);
    const double removed = removedAtCorner(r) + 3 * removedBesideEdge(r) * (side - r) / r;
    EXPECT_NEAR(volume_mm3(made.model.shape), side * side * side - removed, 1e-6) << r;
  }
}

TEST(CornerOfOpenCascade, NamesItsFacesAndSeams) {
  const CornerFillet made = tightCube();
  // Three cylinders and the octant of a sphere.
  ASSERT_EQ(made.faces.size(), 4U);
  const TopTools_IndexedMapOfShape faces = parts(made.model.shape, TopAbs_FACE);
  int spheres = 0;
  for (const int face : made.faces) {
    const BRepAdaptor_Surface surface(TopoDS::Face(faces(face)));
    if (surface.GetType() == GeomAbs_Cylinder) continue;
    ASSERT_EQ(surface.GetType(), GeomAbs_Sphere);
    ++spheres;
    EXPECT_NEAR(surface.Sphere().Radius(), tight_radius, 1e-9);
    const gp_Pnt centre(tight_radius, tight_radius, tight_radius);
    EXPECT_LT(surface.Sphere().Location().Distance(centre), 1e-9);
  }
  EXPECT_EQ(spheres, 1);
  const auto count = [&made](CornerSeamKind kind) {
    return std::ranges::count(made.seams, kind, &occ::CornerSeam::kind);
  };
  EXPECT_EQ(count(CornerSeamKind::Section), 3);
  EXPECT_EQ(count(CornerSeamKind::Contact), 6);
  EXPECT_EQ(made.seams.size(), 9U);
  for (const occ::CornerFilletEdge& edge : made.edges) {
    EXPECT_NEAR(edge.contact_mm, tight_radius, 1e-9);
    EXPECT_EQ(edge.setback_mm, 0);
  }
}

/// The seams are tangent in exact arithmetic, and the figures are proven.
TEST(CornerOfOpenCascade, HasCertifiedSeams) {
  const CornerFillet made = tightCube();
  for (const occ::CornerSeam& seam : made.seams) {
    EXPECT_TRUE(seam.result.figures.angle_rad->upper.has_value());
    EXPECT_GE(seam.result.verdict.level, Level::G1);
  }
  EXPECT_LT(made.largestAngle_rad(), 1e-3 * degree);
  EXPECT_LT(made.largestGap_mm(), 1e-5);
}

TEST(CornerOfOpenCascade, KeepsTheNamesOfFaces) {
  Model model = modelFromShape(box(side, side, side));
  for (int face = 1; face <= 6; ++face)
    model.attributes.push_back({TopAbs_FACE, face, "side", {}, {}});
  const int vertex = vertexAt(model.shape, {0, 0, 0});
  const CornerFillet made = cornerFillet(model, vertex, withRadii(model, vertex, {tight_radius}));
  ASSERT_EQ(made.model.attributes.size(), 6U);
  const TopTools_IndexedMapOfShape faces = parts(made.model.shape, TopAbs_FACE);
  for (const occ::ShapeAttribute& attribute : made.model.attributes)
    EXPECT_EQ(BRepAdaptor_Surface(TopoDS::Face(faces(attribute.index))).GetType(), GeomAbs_Plane);
}

/// What is cut off the box is left in the block.
TEST(CornerOfOpenCascade, InTheWallOfAVoidIsThatOfWhatFillsIt) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -5), gp_Pnt(15, 15, 15)).Shape();
  const CornerFillet wall =
      rounded(BRepAlgoAPI_Cut(block, box(side, side, side)).Shape(), {0, 0, 0}, {tight_radius});
  EXPECT_TRUE(wall.met()) << wall.shortfall.text;
  EXPECT_EQ(wall.filler, CornerFiller::OpenCascade);
  for (const occ::CornerFilletEdge& edge : wall.edges) EXPECT_FALSE(edge.convex);
  EXPECT_NEAR(volume_mm3(wall.model.shape), 20 * 20 * 20 - volume_mm3(tightCube().model.shape),
              1e-5);
}

TEST(CornerOfOpenCascade, IsNoResultWithSetbacksOrForPatchesAlone) {
  const Model model = modelFromShape(box(side, side, side));
  const int vertex = vertexAt(model.shape, {0, 0, 0});
  CornerFilletOptions options = withRadii(model, vertex, {tight_radius});
  options.patches_only = true;
  EXPECT_THROW(cornerFillet(model, vertex, options), occ::CornerRefused);
  options.patches_only = false;
  options.setbacks_mm[options.radii_mm.begin()->first] = 0;
  EXPECT_EQ(cornerFillet(model, vertex, options).filler, CornerFiller::OpenCascade);
  options.setbacks_mm.begin()->second = 9.9;
  EXPECT_THROW(cornerFillet(model, vertex, options), occ::CornerRefused);
}

TEST(CornerOfOpenCascade, IsNotUsedWherePatchesMeetTheTarget) {
  const CornerFillet made = rounded(box(side, side, side), {0, 0, 0}, {1});
  EXPECT_EQ(made.filler, CornerFiller::Patches);
  EXPECT_TRUE(made.patches_shortfall.empty());
}

/// Neither patches nor OpenCASCADE have room: the reason of the patches is the refusal.
TEST(CornerOfOpenCascade, ThatIsNoSolidIsNoResult) {
  try {
    tightCube(15);
    FAIL() << "nothing thrown";
  } catch (const occ::CornerRefused& refused) {
    EXPECT_EQ(refused.reason().fault, occ::CornerFault::SetbackTooLarge);
  }
}

}  // namespace
}  // namespace seamwright::test
