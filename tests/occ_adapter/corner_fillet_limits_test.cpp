// SPDX-License-Identifier: LGPL-2.1-or-later
// What corner fillets refuse, and that they say why.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>

#include "corner_solids.hpp"

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>

namespace seamwright::test {
namespace {

using occ::cornerFillet;
using occ::CornerFilletOptions;
using occ::Model;
using occ::modelFromShape;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Error>
std::string messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

/// The factor of the radii that a refusal names; 0 if there is none.
double factorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const occ::CornerRefused& refused) {
    for (const auto& [name, value] : refused.reason().numbers)
      if (name == "factor") return value;
  }
  return 0;
}

/// The corner at the origin of a cube of side 10: edges 1, 4 and 9.
struct CubeCorner {
  Model model = modelFromShape(BRepPrimAPI_MakeBox(10, 10, 10).Shape());
  int vertex = vertexAt(model.shape, {0, 0, 0});
  CornerFilletOptions options;

  CubeCorner() {
    options.patches_only = true;
    for (const int edge : occ::cornerEdges(model, vertex)) options.radii_mm[edge] = 1;
  }
  template <class Error>
  std::string message() const {
    return messageOf<Error>([this] { cornerFillet(model, vertex, options); });
  }
};

TEST(CornerFilletLimits, NumbersHaveToBeLengths) {
  for (const double bad : {0.0, -1.0, nan, infinite}) {
    CubeCorner cube;
    cube.options.radii_mm.begin()->second = bad;
    const std::string edge = std::to_string(cube.options.radii_mm.begin()->first);
    EXPECT_THAT(cube.message<std::invalid_argument>(), HasSubstr("radius of edge " + edge)) << bad;
    cube = {};
    cube.options.setbacks_mm[std::stoi(edge)] = bad;
    if (bad != 0) {
      EXPECT_THAT(cube.message<std::invalid_argument>(), HasSubstr("setback of edge " + edge))
          << bad;
    }
    cube = {};
    cube.options.section_mm = bad;
    EXPECT_THAT(cube.message<std::invalid_argument>(), HasSubstr("section_mm is ")) << bad;
  }
  CubeCorner cube;
  cube.options.jobs = -1;
  EXPECT_THAT(cube.message<std::invalid_argument>(), HasSubstr("jobs is -1"));
}

TEST(CornerFilletLimits, EdgesAndVertexHaveToBelongTogether) {
  CubeCorner cube;
  const int first = cube.options.radii_mm.begin()->first;
  cube.options.radii_mm.erase(first);
  EXPECT_THAT(cube.message<std::invalid_argument>(),
              HasSubstr("edge " + std::to_string(first) + " is at the vertex and has no radius"));
  cube = {};
  cube.options.radii_mm[2] = 1;
  EXPECT_THAT(cube.message<std::invalid_argument>(),
              HasSubstr("edge 2 has a radius of 1 mm and is not at the vertex"));
  cube = {};
  cube.options.setbacks_mm[77] = 1;
  EXPECT_THAT(cube.message<std::invalid_argument>(), HasSubstr("edge 77 has a setback"));
  for (const int vertex : {-1, 0, 9}) {
    cube.vertex = vertex;
    EXPECT_THAT(cube.message<std::invalid_argument>(),
                HasSubstr("vertex " + std::to_string(vertex) + ": the model has vertices 1 to 8"));
  }
}

TEST(CornerFilletLimits, SetbacksNeedRoom) {
  CubeCorner cube;
  const int edge = cube.options.radii_mm.begin()->first;
  cube.options.setbacks_mm[edge] = 1;
  EXPECT_THAT(cube.message<std::domain_error>(), HasSubstr("more than 1 mm is needed"));
  cube.options.setbacks_mm[edge] = 1.01;
  EXPECT_EQ(cube.message<std::domain_error>(), "nothing thrown");
  cube.options.setbacks_mm[edge] = 11;
  EXPECT_THAT(cube.message<std::domain_error>(),
              HasSubstr("would end 1 mm before it begins on one side"));
  cube = {};
  for (auto& [number, radius_mm] : cube.options.radii_mm) radius_mm = 9.5;
  EXPECT_THAT(cube.message<std::domain_error>(), HasSubstr("would end 4.25 mm before it begins"));
}

/// A box of 10 by 20 by 30: a radius of 28 has no room on the edges beside its own.
TEST(CornerFilletLimits, TheEdgeWhoseRadiusIsTooLargeIsNamed) {
  const Model model = modelFromShape(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
  const int vertex = vertexAt(model.shape, {0, 0, 0});
  const std::vector<int> edges = occ::cornerEdges(model, vertex);
  for (const int large : edges) {
    CornerFilletOptions options;
    options.patches_only = true;
    for (const int edge : edges) options.radii_mm[edge] = edge == large ? 28 : 0.5;
    const std::string said =
        messageOf<std::domain_error>([&] { cornerFillet(model, vertex, options); });
    EXPECT_EQ(said.rfind("edge " + std::to_string(large) + ": with a radius of 28 mm there", 0), 0U)
        << said;
    // The numbers that the text names have room.
    const double factor = factorOf([&] { cornerFillet(model, vertex, options); });
    ASSERT_LT(factor, 1);
    for (auto& [edge, radius_mm] : options.radii_mm) radius_mm *= factor;
    EXPECT_EQ(messageOf<std::domain_error>([&] {
                cornerFillet(model, vertex, options);
              }).find("set back by"),
              std::string::npos);
    options.radii_mm[large] = 0.5;
    const std::string alone = messageOf<std::domain_error>([&] {
      options.setbacks_mm[large] = 40;
      cornerFillet(model, vertex, options);
    });
    EXPECT_EQ(alone.rfind("edge " + std::to_string(large) + ", ", 0), 0U) << alone;
  }
}

TEST(CornerFilletLimits, ASetbackOfZeroIsChosen) {
  CubeCorner cube;
  const occ::CornerFillet chosen = cornerFillet(cube.model, cube.vertex, cube.options);
  for (const auto& [edge, radius_mm] : cube.options.radii_mm) cube.options.setbacks_mm[edge] = 0;
  const int named = cube.options.radii_mm.begin()->first;
  cube.options.setbacks_mm[named] = 4;
  for (const occ::CornerFilletEdge& edge :
       cornerFillet(cube.model, cube.vertex, cube.options).edges)
    EXPECT_EQ(edge.setback_mm, edge.edge == named ? 4 : chosen.edges.front().setback_mm);
}

/// No check of single faces finds this: the void's wall and the fillet have no edge in common.
TEST(CornerFilletLimits, FilletsThatRunIntoAVoidAreNoCorners) {
  const TopoDS_Shape hollow =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 20, 20).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(0.3, 0.3, 15.7), 4, 4, 4).Shape())
          .Shape();
  const Model model = modelFromShape(hollow);
  const int vertex = vertexAt(hollow, {0, 0, 20});
  CornerFilletOptions options;
  options.patches_only = true;
  for (const int edge : occ::cornerEdges(model, vertex)) options.radii_mm[edge] = 2;
  EXPECT_THAT(cornerFillet(model, vertex, options).shortfall.text, HasSubstr("runs into face"));
  for (auto& [edge, radius_mm] : options.radii_mm) radius_mm = 0.2;
  EXPECT_EQ(cornerFillet(model, vertex, options).shortfall.text, "");
}

TEST(CornerFilletLimits, FilletsThatReachBeyondAFarEdgeAreMadeAmongCurvedFaces) {
  const TopoDS_Shape tapered = polyhedron(
      {{0, 0, 0},
       {0, 10, 0},
       {0, 10, 10},
       {0, 0, 10},
       {10, 0, 0},
       {10, 2, 0},
       {10, 2, 2},
       {10, 0, 2}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 4, 7, 3}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}});
  const Model model = modelFromShape(tapered);
  const int vertex = vertexAt(tapered, {0, 0, 0});
  CornerFilletOptions options;
  options.patches_only = true;
  for (const int edge : occ::cornerEdges(model, vertex)) options.radii_mm[edge] = 3;
  const occ::CornerFillet made = cornerFillet(model, vertex, options);
  EXPECT_TRUE(made.met()) << made.shortfall.text;
  EXPECT_LT(volume_mm3(made.model.shape), volume_mm3(tapered));
}

TEST(CornerFilletLimits, AFarEdgeThatIsTooShortNamesRadiiThatLeaveAPart) {
  const occ::CornerReason one = occ::corner_why::farEdgeCut(12, 139, {{3, 20, 141}});
  EXPECT_EQ(one.text,
            "edge 12, 139 mm long, at a far end: the fillet of edge 3, radius 20 mm, takes 141 mm "
            "of it; a radius of 19.68 mm or less would leave a part of it");
  EXPECT_EQ(one.edges, (std::vector<int>{12, 3}));
  // Cuts are in proportion to the radii.
  ASSERT_EQ(one.numbers.back().first, "factor");
  EXPECT_LT(one.numbers.back().second * 141, (1 - 1e-3) * 139);
  const occ::CornerReason two = occ::corner_why::farEdgeCut(5, 10, {{1, 4, 8}, {2, 2, 4}});
  EXPECT_THAT(two.text, HasSubstr("; radii of 3.327 mm and 1.663 mm or less would leave"));
  EXPECT_THAT(occ::corner_why::farEdgeCut(5, 10, {{1, 4, -8}}).text,
              HasSubstr("outside of it, at any radius"));
}

TEST(CornerFilletLimits, CornersOfOtherKindsAreRefused) {
  const auto refusal = [](const TopoDS_Shape& shape, const Eigen::Vector3d& corner) {
    const Model model = modelFromShape(shape);
    return messageOf<std::domain_error>([&] { occ::cornerEdges(model, vertexAt(shape, corner)); });
  };
  EXPECT_THAT(refusal(regularPyramid(7, 10), {0, 0, 10}),
              HasSubstr("7 edges meet at the vertex: 3 to 6"));
  EXPECT_THAT(refusal(BRepPrimAPI_MakeCylinder(5, 10).Shape(), {5, 0, 0}),
              HasSubstr("edges meet at the vertex"));
  TopExp_Explorer shell(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), TopAbs_SHELL);
  EXPECT_THAT(refusal(shell.Current(), {0, 0, 0}),
              HasSubstr("is in no shell of a solid: one is needed"));
}

TEST(CornerFilletLimits, SectionsThatAPolynomialCanNotFollowAreRefused) {
  // The faces of a blade meet at 2 degrees: the section is nearly half a circle.
  const TopoDS_Shape blade = pyramid({{0, 0, 0}, {4000, -70, 0}, {4000, 70, 0}}, {0, 0, 4000});
  const Model model = modelFromShape(blade);
  const int vertex = vertexAt(blade, {0, 0, 0});
  CornerFilletOptions options;
  options.patches_only = true;
  options.section_mm = 1e-9;
  for (const int edge : occ::cornerEdges(model, vertex)) options.radii_mm[edge] = 10;
  EXPECT_THAT(messageOf<std::domain_error>([&] { cornerFillet(model, vertex, options); }),
              HasSubstr("is met to "));
}

TEST(CornerFilletLimits, ARefusalHasACodeNumbersAndALocation) {
  CubeCorner cube;
  const int edge = cube.options.radii_mm.begin()->first;
  cube.options.setbacks_mm[edge] = 0.5;
  try {
    cornerFillet(cube.model, cube.vertex, cube.options);
    FAIL() << "nothing thrown";
  } catch (const occ::CornerRefused& refused) {
    const occ::CornerReason& reason = refused.reason();
    EXPECT_EQ(occ::codeOf(reason.fault), "setback_too_small");
    EXPECT_EQ(reason.text, refused.what());
    EXPECT_EQ(reason.edges, std::vector<int>{edge});
    const std::vector<std::pair<std::string, double>> numbers = {{"setback_mm", 0.5},
                                                                 {"least_mm", 1}};
    ASSERT_EQ(reason.numbers.size(), numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      EXPECT_EQ(reason.numbers[k].first, numbers[k].first);
      EXPECT_NEAR(reason.numbers[k].second, numbers[k].second, 1e-12);
    }
  }
}

TEST(CornerFilletLimits, WhatFallsShortIsSaid) {
  CubeCorner cube;
  cube.options.tolerance.angle_rad = 1e-12;
  const occ::CornerFillet strict = cornerFillet(cube.model, cube.vertex, cube.options);
  EXPECT_FALSE(strict.met());
  EXPECT_TRUE(strict.valid);
  EXPECT_EQ(strict.shortfall.fault, occ::CornerFault::MissesTarget);
  EXPECT_THAT(strict.shortfall.text, HasSubstr("a seam between a patch and a fillet: level G0, "));
}

/// A bore beside the edge: its rim and the line in which the fillet touches the face cross.
TEST(CornerFilletLimits, FilletsAcrossABoreFailTheChecks) {
  const TopoDS_Shape bore =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1.5, 5, -1), gp_Dir(0, 0, 1)), 0.6, 12).Shape();
  const Model model =
      modelFromShape(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), bore).Shape());
  const int vertex = vertexAt(model.shape, {0, 0, 0});
  CornerFilletOptions options;
  options.patches_only = true;
  for (const int edge : occ::cornerEdges(model, vertex)) options.radii_mm[edge] = 1.5;
  const occ::CornerFillet crossed = cornerFillet(model, vertex, options);
  EXPECT_FALSE(crossed.valid || crossed.met());
  EXPECT_THAT(crossed.shortfall.text, HasSubstr("OpenCASCADE's checks"));
  for (auto& [edge, radius_mm] : options.radii_mm) radius_mm = 0.5;
  EXPECT_TRUE(cornerFillet(model, vertex, options).met());
}

TEST(CornerFilletLimits, PatchesThatAreNotProvedRegularAreNotMet) {
  CubeCorner cube;
  cube.options.radii_mm.begin()->second = 4;
  for (auto radius = std::next(cube.options.radii_mm.begin());
       radius != cube.options.radii_mm.end(); ++radius)
    radius->second = 0.001;
  const occ::CornerFillet result = cornerFillet(cube.model, cube.vertex, cube.options);
  EXPECT_FALSE(result.fill.regular || result.met());
  EXPECT_TRUE(result.valid);
  EXPECT_THAT(result.shortfall.text, HasSubstr("not proved regular"));
}

TEST(CornerFilletLimits, WorkCanBeStopped) {
  CubeCorner cube;
  EXPECT_THROW(cornerFillet(cube.model, cube.vertex, cube.options, [](double) { return false; }),
               occ::Cancelled);
}

}  // namespace
}  // namespace seamwright::test
