// SPDX-License-Identifier: LGPL-2.1-or-later
// Models of which some faces hold numbers that can't be computed with: the other faces are
// repaired, filled, matched and written as if these were not there, and these stay as they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <regex>

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/match/match.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

#include "files.hpp"
#include "fill_checks.hpp"
#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::Model;
using occ::modelFromShape;
using ::testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

Spline splineOf(const TopoDS_Shape& shape, int number) {
  return Spline::DownCast(BRep_Tool::Surface(face(shape, number)));
}

/// In place, so that shapes that share the surface have it too.
void damage(const TopoDS_Shape& shape, int number, double by) {
  splineOf(shape, number)->SetPole(1, 1, gp_Pnt(by, 0, 0));
}

TopoDS_Shape splineBox() {
  return BRepBuilderAPI_NurbsConvert(box(), true).Shape();
}

/// The face of a box that shares no edge with another one.
int opposite(const TopoDS_Shape& shape, int number) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE),
                                   edges = partsOf(faces(number), TopAbs_EDGE);
  for (int other = 1; other <= faces.Extent(); ++other) {
    bool meets = false;
    for (TopExp_Explorer edge(faces(other), TopAbs_EDGE); edge.More(); edge.Next())
      meets = meets || edges.Contains(edge.Current());
    if (!meets) return other;
  }
  throw std::logic_error("no face lies opposite");
}

constexpr int replaced_face = 1;

TEST(UnusableParts, AFaceIsReplacedOppositeToOne) {
  for (const double bad : {no_number, infinity, -infinity, 1e300}) {
    SCOPED_TRACE(bad);
    const TopoDS_Shape shape = splineBox();
    const int other = opposite(shape, replaced_face);
    const Spline damaged = splineOf(shape, other);
    damage(shape, other, bad);
    const occ::FillHoleReport report =
        occ::replaceFace(modelFromShape(shape), replaced_face, {.target = Level::G0});
    ASSERT_TRUE(report.filled && report.reached) << textOf(report.reason);
    const TopoDS_Shape& filled = report.model.shape;
    EXPECT_EQ(partsOf(filled, TopAbs_FACE).Extent(), 6);
    EXPECT_EQ(partsOf(filled, TopAbs_EDGE).Extent(), 12) << "closed";
    EXPECT_EQ(partsOf(filled, TopAbs_SOLID).Extent(), 1);
    bool is_there = false;
    for (int f = 1; f <= 6; ++f)
      is_there = is_there || BRep_Tool::Surface(face(filled, f)) == damaged;
    EXPECT_TRUE(is_there);
  }
}

TEST(UnusableParts, AFaceBesideOneIsNotReplaced) {
  const TopoDS_Shape shape = splineBox();
  const int other = opposite(shape, replaced_face);
  const int beside = other == 2 ? 3 : 2;
  damage(shape, beside, no_number);
  const occ::FillHoleReport report = occ::replaceFace(modelFromShape(shape), replaced_face);
  EXPECT_FALSE(report.filled);
  EXPECT_THAT(textOf(report.reason), HasSubstr("the hole can't be met at edge"));
  EXPECT_THAT(textOf(report.reason),
              HasSubstr("face " + std::to_string(beside) + " has a surface with the number nan"));
  EXPECT_TRUE(report.model.shape.IsSame(shape));
}

TEST(UnusableParts, OneIsReplacedItself) {
  const TopoDS_Shape shape = splineBox();
  damage(shape, replaced_face, no_number);
  const occ::FillHoleReport report =
      occ::replaceFace(modelFromShape(shape), replaced_face, {.target = Level::G0});
  ASSERT_TRUE(report.filled && report.reached) << textOf(report.reason);
  EXPECT_TRUE(occ::UnusableParts(report.model.shape).empty());
  EXPECT_TRUE(analyzed(report.model.shape).passed());
}

TEST(UnusableParts, HolesAreFilledUnlessTheyAreBoundedByOne) {
  const TopoDS_Shape whole = splineBox();
  const int other = opposite(whole, replaced_face);
  const TopoDS_Shape shape = without(whole, {replaced_face});
  const std::vector<occ::Hole> holes = occ::findHoles(shape).holes;
  ASSERT_EQ(holes.size(), 1u);
  damage(whole, other, infinity);
  const Model model = modelFromShape(shape);
  const occ::FillHoleReport filled = occ::fillHole(model, holes.front(), {.target = Level::G0});
  EXPECT_TRUE(filled.filled && filled.reached) << textOf(filled.reason);

  const int beside = holes.front().sides.front().edges.front().use.face;
  damage(shape, beside, no_number);
  const occ::FillHoleReport refused = occ::fillHole(model, holes.front(), {.target = Level::G0});
  EXPECT_FALSE(refused.filled);
  EXPECT_TRUE(refused.model.shape.IsSame(shape));
  const std::string fault = "face " + std::to_string(beside) + " has a surface with the number nan";
  EXPECT_THAT(textOf(refused.reason), HasSubstr(fault));
  const occ::Holes found = occ::findHoles(shape);
  EXPECT_TRUE(found.holes.empty());
  EXPECT_THAT(found.notes, ::testing::Contains(HasSubstr(fault)));
}

TEST(UnusableParts, OtherFacesAreMatched) {
  std::mt19937 random(testSeed());
  const TopoDS_Shape pair = joinedSheets(disturbedSheets(random, 0.01));
  const Spline third = Spline::DownCast(splineOf(pair, 1)->Copy());
  third->SetPole(2, 2, gp_Pnt(no_number, 0, 0));
  const TopoDS_Shape all = loose(pair, wholeFace(third));
  const occ::MatchReport report = occ::matchFaces(all, 1, 2, ofOrder(1));
  EXPECT_TRUE(report.matched) << report.text();
  for (const auto& [a, b] : {std::pair{1, 3}, std::pair{3, 1}}) {
    const occ::MatchReport refused = occ::matchFaces(all, a, b, ofOrder(1));
    EXPECT_FALSE(refused.matched);
    EXPECT_EQ(refused.text(), "face 3 has a surface with the number nan");
    EXPECT_TRUE(face(refused.shape, 1).IsSame(face(all, a)));
  }
}

/// Two plates that share an edge, the second one of splines, and a loose one 1e-4 mm beside both.
TopoDS_Shape platesAndLooseOne() {
  const opencascade::handle<Geom_Surface> plane = new Geom_Plane(gp_Ax3());
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (const int i : {1, 2})
    for (const int j : {1, 2}) poles(i, j) = gp_Pnt(10 * (i - 1), 10 * (j - 1), 0);
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0, knots(2) = 10;
  TColStd_Array1OfInteger ends(1, 2);
  ends.Init(2);
  const Spline spline = new Geom_BSplineSurface(poles, knots, knots, ends, ends, 1, 1);
  const Polygon left = {plane, beginningWith(1, rectangle(-10, 0, 0, 10))};
  const Polygon right = {opencascade::handle<Geom_Surface>(spline),
                         beginningWith(3, rectangle(0, 10, 0, 10))};
  const TopoDS_Shape both = joined(left, right);
  return compoundOf({both, plate(-10, 0, 10.0001, 20)});
}

TEST(UnusableParts, OtherFacesAreSewn) {
  for (const bool is_damaged : {false, true}) {
    SCOPED_TRACE(is_damaged);
    const TopoDS_Shape shape = platesAndLooseOne();
    int number = 0;
    for (int f = 1; f <= 3; ++f)
      if (!splineOf(shape, f).IsNull()) number = f;
    const Spline spline = splineOf(shape, number);
    if (is_damaged) spline->SetPole(2, 2, gp_Pnt(no_number, 0, 0));
    occ::RepairOptions options;
    options.match_mm = 0.01;
    const occ::RepairReport report = occ::repair(modelFromShape(shape), options);
    const auto sewn = std::ranges::find_if(report.seams, &occ::SeamRepair::sewn);
    ASSERT_NE(sewn, report.seams.end());
    EXPECT_TRUE(sewn->after.verdict.certain);
    EXPECT_EQ(BRep_Tool::Surface(face(report.model.shape, report.faces_now[number])), spline);
    EXPECT_EQ(partsOf(report.model.shape, TopAbs_SHELL).Extent(), 1);
  }
}

/// Text of a BREP file with one of its numbers behind the list of locations replaced.
std::string withOneNumber(const std::string& brep, const std::vector<std::string>& by,
                          std::mt19937& random) {
  static const std::regex number("[ \n](-?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?)(?=[ \n])");
  std::vector<std::pair<std::size_t, std::size_t>> spans;
  const std::size_t start = brep.find("Locations");
  for (std::sregex_iterator
           it(brep.begin() + static_cast<std::ptrdiff_t>(start), brep.end(), number),
       end;
       it != end; ++it)
    spans.emplace_back(start + static_cast<std::size_t>(it->position(1)), it->length(1));
  const auto [at, length] =
      spans.at(std::uniform_int_distribution<std::size_t>(0, spans.size() - 1)(random));
  return std::string(brep).replace(
      at, length, by[std::uniform_int_distribution<std::size_t>(0, by.size() - 1)(random)]);
}

/// All that changes models. \returns whether a seam was repaired
bool survives(const Model& model) {
  occ::RepairOptions options;
  options.match_mm = 0.1;
  const occ::RepairReport report = occ::repair(model, options);
  for (const occ::FaceMove& move : report.moves) EXPECT_TRUE(std::isfinite(move.largest_move_mm));
  occ::replaceFace(model, 1, {.target = Level::G0});
  occ::matchFaces(model.shape, 1, 2, {});
  return repairedSeams(report) > 0;
}

/// A sheet, and a closed solid, both with seams to repair.
TopoDS_Shape brokenShape(bool is_solid, std::mt19937& random) {
  NetShape form;
  form.columns = 3;
  form.rows = 2;
  Net net = is_solid ? blob(Polyhedron::Cube, 30, random) : piecesOfOne(form, random);
  disturb(net, 0.01, random);
  return shapeOf(net);
}

class OneUnusableNumber : public ::testing::TestWithParam<bool> {};

TEST_P(OneUnusableNumber, InAnyPlaceIsSurvived) {
  const std::vector<std::string> by = {"inf", "-inf", "nan", "-nan", "1e300"};
  const bool is_solid = GetParam();
  std::mt19937 random(testSeed());
  const Folder folder;
  writeBrep(brokenShape(is_solid, random), folder / "whole.brep");
  const std::string brep = contentOf(folder / "whole.brep");
  const char* asked = std::getenv("SEAMWRIGHT_TEST_TRIALS");
  const int trials = asked == nullptr ? 12 : std::atoi(asked);
  int read = 0, repaired = 0;
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE("trial " + std::to_string(i));
    setContent(folder / "changed.brep", withOneNumber(brep, by, random));
    const auto start = std::chrono::steady_clock::now();
    try {
      const Model model = occ::readModel(folder / "changed.brep");
      ++read;
      repaired += survives(model);
    } catch (const occ::ModelError& error) {
      EXPECT_THAT(error.what(), ::testing::Not(HasSubstr("\n")));
    } catch (const std::invalid_argument& error) {  // of a text that has fewer faces now
      EXPECT_THAT(error.what(), HasSubstr("face"));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  }
  EXPECT_GT(read, trials / 2);
  // On a cube four of six faces have an edge in common with any one, so that they stay too.
  EXPECT_GT(repaired, is_solid ? 0 : read / 2);
}

INSTANTIATE_TEST_SUITE_P(OfSheetAndSolid, OneUnusableNumber, ::testing::Bool());

TEST(UnusableParts, BrepHoldsThem) {
  const Folder folder;
  for (const double bad : {no_number, -no_number, infinity, -infinity, 1e300})
    for (const char* name : {"box.brep", "box.bin"}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(bad));
      const TopoDS_Shape shape = splineBox();
      damage(shape, 2, bad);
      occ::writeModel(modelFromShape(shape), folder / name, {.overwrite = true});
      const Model back = occ::readModel(folder / name);
      ASSERT_EQ(back.faceCount(), 6);
      for (int f = 1; f <= 6; ++f) {
        const Spline was = splineOf(shape, f), is = splineOf(back.shape, f);
        for (int i = 1; i <= was->NbUPoles(); ++i)
          for (int j = 1; j <= was->NbVPoles(); ++j)
            for (int k = 1; k <= 3; ++k) {
              const double a = was->Pole(i, j).Coord(k), b = is->Pole(i, j).Coord(k);
              EXPECT_TRUE(std::isnan(a) ? std::isnan(b) : a == b) << a << " " << b;
            }
      }
    }
}

TEST(UnusableParts, StepAndIgesHoldFiniteOnesAlone) {
  const Folder folder;
  for (const double bad : {no_number, infinity, -infinity, 1e300})
    for (const char* name : {"box.step", "box.igs"}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(bad));
      const TopoDS_Shape shape = splineBox();
      damage(shape, 2, bad);
      const Model model = modelFromShape(shape);
      if (std::isfinite(bad)) {
        occ::writeModel(model, folder / name);
        const Model back = occ::readModel(folder / name);
        ASSERT_EQ(back.faceCount(), 6);
        EXPECT_EQ(splineOf(back.shape, 2)->Pole(1, 1).X(), bad);
        continue;
      }
      try {
        occ::writeModel(model, folder / name);
        ADD_FAILURE() << "written";
      } catch (const occ::ModelError& error) {
        EXPECT_EQ(error.code(), occ::ModelErrc::NotWritten);
        EXPECT_THAT(error.what(), HasSubstr("face 2 has a surface with the number"));
        EXPECT_THAT(error.what(), HasSubstr(".brep"));
      }
      EXPECT_FALSE(std::filesystem::exists(folder / name));
    }
}

}  // namespace
}  // namespace seamwright::test
