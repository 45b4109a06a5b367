// SPDX-License-Identifier: LGPL-2.1-or-later
// What is not sewn although its edges meet, and what of the parts is carried over.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Pln.hxx>
#include <numbers>
#include <vector>

#include "repair_checks.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::test {
namespace {

using occ::modelFromShape;
using occ::repair;
using occ::RepairOptions;
using occ::RepairReport;
using occ::SewSolution;
using std::numbers::pi;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> reasonsOf(const RepairReport& report) {
  std::vector<std::string> reasons;
  for (const occ::SeamRepair& seam : report.seams)
    if (!seam.not_sewn.empty()) reasons.push_back(seam.not_sewn.text);
  return reasons;
}

/// Two loose plates, the second turned up about the seam, with figures that can be altered by hand.
class LoosePair {
 public:
  explicit LoosePair(double step_mm, double turn_rad = 0) : shape_(pairOf(step_mm, turn_rad)) {
    before_ = occ::analyze(modelFromShape(shape_), occ::analyzeOptions(options_)).seams;
    occ::SeamGraph graph = occ::findSeams(shape_);
    matchFreeEdges({.match_mm = options_.match_mm, .gap_mm = options_.tolerance.gap_mm}, graph, {});
    seams_ = std::move(graph.seams);
  }

  occ::SeamResult& before() { return before_.at(0); }
  SewSolution sewn() const {
    return occ::sewFreeEdges(
        {.shape = shape_, .seams = seams_, .before = before_, .options = options_}, {});
  }

 private:
  static TopoDS_Shape pairOf(double step_mm, double turn_rad) {
    gp_Trsf up;
    up.SetRotation(gp_Ax1(gp_Pnt(10, 0, step_mm), gp::DY()), -turn_rad);
    return compoundOf({plate(0, 10, 0, 20), transformed(plate(10, 20, 0, 20, step_mm), up)});
  }

  const RepairOptions options_ = matching(0.1);
  const TopoDS_Shape shape_;
  std::vector<occ::SeamResult> before_;
  std::vector<occ::Seam> seams_;
};

TEST(SewProof, AnEdgeHasTheNumberOfItsSeam) {
  LoosePair pair(0.005);
  pair.before().id = 7;
  const SewSolution solution = pair.sewn();
  EXPECT_THAT(solution.reasons, IsEmpty());
  ASSERT_FALSE(solution.sewn.shape.IsNull());
  EXPECT_EQ(solution.after[0].id, 7);
  EXPECT_NEAR(solution.after[0].figures.gap_mm->lower, 0.005, 1e-9);
}

TEST(SewProof, NoLevelIsLost) {
  LoosePair pair(0.005, 0.3 * degree);
  ASSERT_EQ(pair.before().verdict.level, Level::G0);
  pair.before().verdict.level = Level::G1;
  pair.before().verdict.certain = false;
  EXPECT_THAT(pair.sewn().reasons, IsEmpty());
  pair.before().verdict.certain = true;
  const SewSolution solution = pair.sewn();
  EXPECT_TRUE(solution.sewn.shape.IsNull());
  EXPECT_THAT(solution.reasons.at(0).text,
              HasSubstr("as one edge it would have level G0, gap 0.005 mm"));
  EXPECT_EQ(solution.reasons.at(0).fault, occ::SewFault::LosesLevel);
}

TEST(SewProof, NoFigureThatWasWithinItsToleranceLeavesIt) {
  LoosePair apart(0.015);
  apart.before().verdict.certain = false;
  EXPECT_THAT(apart.sewn().reasons.at(0).text,
              HasSubstr("its gap is not certainly within the tolerance"));
  EXPECT_EQ(codeOf(apart.sewn().reasons.at(0).fault), "gap_too_large");
  apart.before().figures.gap_mm = Figure{0, 0.001, 0};
  EXPECT_THAT(apart.sewn().reasons.at(0).text,
              HasSubstr("as one edge it would have level none, gap 0.015 mm"));
  EXPECT_EQ(codeOf(apart.sewn().reasons.at(0).fault), "loses_level");
  LoosePair both(0.015, 0.3 * degree);
  both.before().verdict.certain = false;
  both.before().figures.gap_mm = Figure{0, 0.001, 0};
  EXPECT_THAT(both.sewn().reasons.at(0).text,
              HasSubstr("as one edge it would have level none, gap 0.015 mm"));
  EXPECT_EQ(codeOf(both.sewn().reasons.at(0).fault), "loses_level");
  LoosePair kinked(0, 0.3 * degree);
  kinked.before().verdict.certain = false;
  EXPECT_THAT(kinked.sewn().reasons, IsEmpty());
  kinked.before().figures.angle_rad = Figure{0, 0.0001, 0};
  EXPECT_THAT(kinked.sewn().reasons.at(0).text, HasSubstr("as one edge it would have level G0"));
  EXPECT_EQ(codeOf(kinked.sewn().reasons.at(0).fault), "loses_level");
}

/// Sectors of a disc, each a little higher than the one before.
TopoDS_Shape staircase(int sectors, double step_mm, double vertex_mm) {
  const BRep_Builder builder;
  std::vector<TopoDS_Shape> faces;
  for (int k = 0; k < sectors; ++k) {
    const auto out = [&](int i) {
      const double about = 2 * pi * i / sectors;
      return gp_Pnt(10 * std::cos(about), 10 * std::sin(about), k * step_mm);
    };
    const gp_Pnt middle(0, 0, k * step_mm);
    faces.push_back(BRepBuilderAPI_MakeFace(
                        BRepBuilderAPI_MakePolygon(middle, out(k), out(k + 1), true).Wire(), true)
                        .Shape());
    for (TopExp_Explorer vertex(faces.back(), TopAbs_VERTEX); vertex.More(); vertex.Next())
      builder.UpdateVertex(TopoDS::Vertex(vertex.Current()), vertex_mm);
  }
  return compoundOf(faces);
}

TEST(SewProof, NoVertexReachesFurtherThanTwiceTheGapOrWhatItDid) {
  // All but the first and the last meet within 0.009 mm, and their tips are up to 0.063 mm apart.
  const RepairReport apart = repair(modelFromShape(staircase(8, 0.009, 1e-7)), matching(0.03));
  EXPECT_FALSE(apart.changed());
  ASSERT_EQ(reasonsOf(apart).size(), 7);
  EXPECT_THAT(
      reasonsOf(apart),
      Each(HasSubstr("a common vertex would be 0.0315315 mm from the ends of its edges, more than "
                     "0.02 mm")));
  const occ::SewReason& reason = apart.seams[0].not_sewn;
  EXPECT_EQ(reason.fault, occ::SewFault::VertexTooWide);
  ASSERT_EQ(reason.numbers.size(), 2);
  EXPECT_EQ(reason.numbers[0].first, "distance_mm");
  EXPECT_NEAR(reason.numbers[0].second, 0.0315315, 1e-7);
  EXPECT_EQ(reason.numbers[1].first, "allowed_mm");
  EXPECT_DOUBLE_EQ(reason.numbers[1].second, 0.02);
  EXPECT_EQ(sewnSeams(repair(modelFromShape(staircase(8, 0.004, 1e-7)), matching(0.02))), 7);
  EXPECT_EQ(sewnSeams(repair(modelFromShape(staircase(8, 0.009, 0.016)), matching(0.03))), 7);
  EXPECT_EQ(sewnSeams(repair(modelFromShape(staircase(8, 0.009, 0.0155)), matching(0.03))), 0);
}

TEST(SewProof, AVertexKeepsTheToleranceOfItsEdges) {
  const BRep_Builder builder;
  const TopoDS_Shape shape = compoundOf({plate(0, 10, 0, 20), plate(10, 20, 0, 20)});
  for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next())
    builder.UpdateEdge(TopoDS::Edge(edge.Current()), 0.004);
  for (TopExp_Explorer vertex(shape, TopAbs_VERTEX); vertex.More(); vertex.Next())
    builder.UpdateVertex(TopoDS::Vertex(vertex.Current()), 0.004);
  const RepairReport report = repair(modelFromShape(shape), matching(0.1));
  ASSERT_EQ(sewnSeams(report), 1);
  for (TopExp_Explorer edge(report.model.shape, TopAbs_EDGE); edge.More(); edge.Next())
    for (TopExp_Explorer vertex(edge.Current(), TopAbs_VERTEX); vertex.More(); vertex.Next())
      EXPECT_GE(BRep_Tool::Tolerance(TopoDS::Vertex(vertex.Current())),
                BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
}

TEST(SewProof, OfAnEdgeThatWasCutWhatStaysLooseIsNamed) {
  for (const bool first_is_far : {false, true}) {
    const TopoDS_Shape shape =
        compoundOf({plate(0, 10, -10, 30), plate(10, 20, -10, 5, first_is_far ? 0.05 : 0.001),
                    plate(10, 20, 5, 30, first_is_far ? 0.001 : 0.05)});
    const RepairReport report = repair(modelFromShape(shape), matching(0.1));
    EXPECT_EQ(sewnSeams(report), 1);
    const occ::Report again = occ::analyze(report.model, occ::analyzeOptions(matching(0.1)));
    const auto sorted = [](std::vector<int> numbers) {
      std::ranges::sort(numbers);
      return numbers;
    };
    for (const occ::SeamRepair& seam : report.seams) {
      const bool is_there = std::ranges::any_of(again.seams, [&](const occ::SeamResult& other) {
        return sorted(other.edges) == sorted(seam.after.edges);
      });
      EXPECT_TRUE(is_there) << describe(seam.after);
    }
  }
}

/// The faces of a box but for the top.
TopoDS_Shell openBox(double x0, double size) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(x0, x0, 0), size, size, size).Shape();
  const TopTools_IndexedMapOfShape faces = partsOf(box, TopAbs_FACE);
  for (int f = 1; f <= 5; ++f) builder.Add(shell, faces(f));
  return shell;
}

TEST(SewProof, SolidsOfSeveralShellsStay) {
  const BRep_Builder builder;
  for (const bool hollow : {false, true}) {
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, openBox(0, 30));
    if (hollow) builder.Add(solid, openBox(10, 10));
    const TopoDS_Shape shape = compoundOf({solid, plate(0, 30, 0, 30, 30)});
    const RepairReport report = repair(modelFromShape(shape), matching(0.1));
    EXPECT_EQ(sewnSeams(report), hollow ? 0 : 4);
    EXPECT_EQ(reasonsOf(report).size(), hollow ? 4 : 0);
    EXPECT_THAT(reasonsOf(report), Each(HasSubstr("is part of a solid of several shells")));
    for (const occ::SeamRepair& seam : report.seams) {
      if (seam.not_sewn.empty()) continue;
      EXPECT_EQ(codeOf(seam.not_sewn.fault), "hollow_solid");
    }
  }
}

TEST(SewProof, WhatAPartHasOfItsOwnComesFirst) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, plate(10, 20, 0, 10));
  builder.Add(shell, plate(20, 30, 0, 10, 5));
  occ::Model model = modelFromShape(compoundOf({plate(0, 10, 0, 10), shell}));
  const std::array<double, 3> red = {1, 0, 0}, blue = {0, 0, 1};
  // Faces 2 and 3 are in the shell, which becomes a part of another one.
  model.attributes = {{TopAbs_SHELL, 1, "shell", red, {"of the shell"}},
                      {TopAbs_FACE, 2, "face", blue, {"of the face"}}};
  const RepairReport report = repair(model, matching(0.1));
  ASSERT_EQ(sewnSeams(report), 1);
  EXPECT_EQ(partsOf(report.model.shape, TopAbs_SHELL).Extent(), 1);
  EXPECT_EQ(partsOf(report.model.shape, TopAbs_FACE).Extent(), 3);
  const std::vector<occ::ShapeAttribute>& now = report.model.attributes;
  const auto own = std::ranges::find(now, "face", &occ::ShapeAttribute::name),
             given = std::ranges::find(now, "shell", &occ::ShapeAttribute::name);
  ASSERT_NE(own, now.end());
  EXPECT_EQ(own->kind, TopAbs_FACE);
  EXPECT_EQ(own->index, report.faces_now[2]);
  EXPECT_EQ(own->color, blue);
  EXPECT_EQ(own->layers, std::vector<std::string>{"of the face"});
  ASSERT_NE(given, now.end());
  EXPECT_EQ(given->kind, TopAbs_FACE);
  EXPECT_EQ(given->index, report.faces_now[3]);
  EXPECT_EQ(given->color, red);
  EXPECT_EQ(given->layers, std::vector<std::string>{"of the shell"});
}

TEST(SewProof, AllPiecesOfAnEdgeHaveItsName) {
  const TopoDS_Shape shape =
      compoundOf({plate(0, 10, -10, 30), plate(10, 20, -10, 5), plate(10, 20, 12, 30)});
  const RepairReport plain = repair(modelFromShape(shape), matching(0.1));
  const auto cut = std::ranges::find_if(
      plain.edges_now, [](const std::vector<int>& now) { return now.size() == 3; });
  ASSERT_NE(cut, plain.edges_now.end());
  occ::Model model = modelFromShape(shape);
  model.attributes = {
      {TopAbs_EDGE, static_cast<int>(cut - plain.edges_now.begin()), "long", {}, {}}};
  std::vector<int> named;
  for (const occ::ShapeAttribute& attribute : repair(model, matching(0.1)).model.attributes)
    if (attribute.kind == TopAbs_EDGE && attribute.name == "long") named.push_back(attribute.index);
  EXPECT_THAT(named, testing::UnorderedElementsAreArray(*cut));
}

TEST(SewProof, WiresRunFromPieceToPiece) {
  // The long edge runs both ways in its face's wire.
  for (const bool turned : {false, true}) {
    TopoDS_Shape with_long = plate(0, 10, -10, 30);
    if (turned) {
      gp_Trsf about;
      about.SetRotation(gp_Ax1(gp_Pnt(5, 10, 0), gp::DZ()), pi);
      with_long = transformed(with_long, about);
    }
    const TopoDS_Shape shape =
        compoundOf({with_long, plate(10, 20, -10, 5), plate(10, 20, 12, 30)});
    const RepairReport report = repair(modelFromShape(shape), matching(0.1));
    ASSERT_EQ(sewnSeams(report), 2) << testing::PrintToString(reasonsOf(report));
    for (TopExp_Explorer wire(report.model.shape, TopAbs_WIRE); wire.More(); wire.Next()) {
      EXPECT_TRUE(wire.Current().Closed());
      std::vector<TopoDS_Edge> edges;
      for (TopoDS_Iterator edge(wire.Current()); edge.More(); edge.Next())
        edges.push_back(TopoDS::Edge(edge.Value()));
      for (std::size_t k = 0; k < edges.size(); ++k)
        EXPECT_TRUE(TopExp::LastVertex(edges[k], true)
                        .IsSame(TopExp::FirstVertex(edges[(k + 1) % edges.size()], true)));
    }
  }
}

TEST(SewProof, NothingEmptyIsLeftBehind) {
  const TopoDS_Shape shape = compoundOf({plate(0, 10, 0, 10), compoundOf({plate(10, 20, 0, 10)})});
  const RepairReport report = repair(modelFromShape(shape), matching(0.1));
  ASSERT_EQ(sewnSeams(report), 1);
  EXPECT_EQ(report.model.shape.NbChildren(), 1);
}

TEST(SewProof, FacesOfWholeSurfacesAreSaidToBeStill) {
  const BRep_Builder builder;
  std::vector<TopoDS_Shape> plates = {plate(0, 10, 0, 10), plate(10, 20, 0, 10)};
  builder.NaturalRestriction(TopoDS::Face(plates[1]), true);
  const RepairReport report = repair(modelFromShape(compoundOf(plates)), matching(0.1));
  ASSERT_EQ(sewnSeams(report), 1);
  const TopTools_IndexedMapOfShape faces = partsOf(report.model.shape, TopAbs_FACE);
  EXPECT_FALSE(BRep_Tool::NaturalRestriction(TopoDS::Face(faces(report.faces_now[1]))));
  EXPECT_TRUE(BRep_Tool::NaturalRestriction(TopoDS::Face(faces(report.faces_now[2]))));
}

TEST(SewProof, WhatWasUnsoundElsewhereIsNoReason) {
  // A face whose boundary crosses itself.
  const TopoDS_Shape crossed =
      BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()),
                              BRepBuilderAPI_MakePolygon(gp_Pnt(50, 0, 0), gp_Pnt(60, 10, 0),
                                                         gp_Pnt(60, 0, 0), gp_Pnt(50, 10, 0), true)
                                  .Wire())
          .Shape();
  const TopoDS_Shape shape = compoundOf({plate(0, 10, 0, 20), plate(10, 20, 0, 20), crossed});
  ASSERT_FALSE(BRepCheck_Analyzer(shape).IsValid());
  EXPECT_EQ(sewnSeams(repair(modelFromShape(shape), matching(0.1))), 1);
}

}  // namespace
}  // namespace seamwright::test
