// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <atomic>
#include <limits>
#include <sstream>
#include <thread>

#include <seamwright/occ_adapter/analyze/workers.hpp>

#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::SeamResult;
using ::testing::HasSubstr;

/// A rounded box with a spherical bite as rational B-splines, repeated in several positions.
TopoDS_Shape manySeams(int copies) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
  BRepFilletAPI_MakeFillet rounded(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next())
    rounded.Add(2, TopoDS::Edge(it.Current()));
  const TopoDS_Shape bitten =
      BRepAlgoAPI_Cut(rounded.Shape(), BRepPrimAPI_MakeSphere(gp_Pnt(20, 10, 20), 6).Shape())
          .Shape();
  const TopoDS_Shape part = BRepBuilderAPI_NurbsConvert(bitten).Shape();
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  std::mt19937 random(testSeed(1));
  for (int i = 0; i < copies; ++i) builder.Add(all, located(part, randomMotion(random)));
  return all;
}

std::string everything(const occ::Report& report) {
  std::ostringstream text;
  text.precision(17);
  const auto tell = [&](const std::optional<Figure>& figure) {
    if (figure)
      text << ' ' << figure->lower << '@' << figure->at;
    else
      text << " -";
  };
  for (const SeamResult& seam : report.seams) {
    text << seam.id << ' ' << seam.edges[0] << ' ' << seam.faces[0] << ' ' << seam.faces[1] << ' '
         << seam.length_mm << ' ' << seam.figures.points;
    tell(seam.figures.gap_mm);
    tell(seam.figures.angle_rad);
    tell(seam.figures.curvature_per_mm);
    tell(seam.figures.curvature_rel);
    text << name(seam.verdict.level) << name(seam.verdict.seam_class) << seam.note << '\n';
  }
  return text.str();
}

TEST(Analyze, TheNumberOfThreadsChangesNothing) {
  const TopoDS_Shape shape = manySeams(4);
  occ::AnalyzeOptions options;
  options.jobs = 1;
  const std::string one = everything(analyzed(shape, options));
  for (const int jobs : {2, 8, 0}) {
    options.jobs = jobs;
    EXPECT_EQ(everything(analyzed(shape, options)), one) << jobs << " jobs";
  }
}

TEST(Analyze, LeavesTheShapeAlone) {
  const TopoDS_Shape shape = manySeams(1);
  std::ostringstream before, after;
  BRepTools::Write(shape, before);
  analyzed(shape);
  BRepTools::Write(shape, after);
  EXPECT_EQ(after.str(), before.str());
}

TEST(Analyze, ProgressRisesFromZeroToOneInTheCallersThread) {
  std::vector<double> shares;
  const auto caller = std::this_thread::get_id();
  occ::analyze(occ::modelFromShape(manySeams(2)), {}, [&](double share) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    shares.push_back(share);
    return true;
  });
  ASSERT_GE(shares.size(), 2u);
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST(Analyze, ProgressCanStopIt) {
  const occ::Model model = occ::modelFromShape(manySeams(20));
  EXPECT_THROW(occ::analyze(model, {}, [](double) { return false; }), occ::Cancelled);
}

TEST(RunParallel, EachPieceOnceAndCancelledBeforeTheEnd) {
  std::vector<std::atomic<int>> counts(1000);
  occ::runParallel(counts.size(), 8, [&](std::size_t i) { ++counts[i]; }, {});
  for (const auto& count : counts) EXPECT_EQ(count, 1);
  std::atomic<int> done = 0;
  const auto slow = [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ++done;
  };
  int calls = 0;
  EXPECT_THROW(occ::runParallel(1000, 2, slow, [&](double) { return ++calls < 3; }),
               occ::Cancelled);
  EXPECT_LT(done, 200);
}

TEST(RunParallel, AnExceptionOfProgressPassesThroughAndStopsTheThreads) {
  std::atomic<int> done = 0;
  const auto slow = [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ++done;
  };
  int calls = 0;
  const auto bad = [&](double) -> bool {
    if (++calls == 3) throw std::runtime_error("no more");
    return true;
  };
  EXPECT_THROW(occ::runParallel(1000, 2, slow, bad), std::runtime_error);
  EXPECT_LT(done, 200);
}

TEST(Analyze, AFaceThatIsNotFiniteCostsItsOwnSeamsAlone) {
  const TopoDS_Shape shape =
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeBox(3, 4, 5).Shape(), true).Shape();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  const auto surface = opencascade::handle<Geom_BSplineSurface>::DownCast(
      BRep_Tool::Surface(TopoDS::Face(faces(2))));
  ASSERT_FALSE(surface.IsNull());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  surface->SetPole(1, 1, gp_Pnt(nan, nan, nan));
  const occ::Report report = analyzed(shape);
  ASSERT_EQ(report.seams.size(), 12u);
  int touched = 0;
  for (const SeamResult& seam : report.seams) {
    SCOPED_TRACE(describe(seam));
    const bool bad = seam.faces[0] == 2 || seam.faces[1] == 2;
    touched += bad;
    EXPECT_EQ(seam.figures.angle_rad.has_value(), !bad);
    EXPECT_EQ(seam.verdict.level, bad ? Level::None : Level::G0);
    EXPECT_EQ(seam.verdict.seam_class, bad ? SeamClass::Defect : SeamClass::Crease);
    EXPECT_EQ(seam.note.empty(), !bad);
  }
  EXPECT_EQ(touched, 4);
  EXPECT_LT(report.analyze_s, 5) << "no seam is worth a long search on a surface that is nowhere";
  EXPECT_FALSE(report.passed());
}

template <class Change>
void expectRefused(const Change& change, const std::string& number) {
  occ::AnalyzeOptions options;
  change(options);
  try {
    analyzed(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), options);
    FAIL() << "taken: " << number;
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(number));
  }
}

TEST(Analyze, BadOptionsAreRefusedWithTheirNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused([&](auto& o) { o.tolerance.gap_mm = nan; }, "nan");
  expectRefused([](auto& o) { o.tolerance.gap_mm = -0.25; }, "-0.25");
  expectRefused([](auto& o) { o.tolerance.angle_rad = -1 * degree; }, "-1");
  expectRefused([](auto& o) { o.tolerance.curvature_rel = -3; }, "-3");
  expectRefused([](auto& o) { o.tolerance.flat_radius_mm = 0; }, "0");
  expectRefused([](auto& o) { o.tolerance.crease_rad = 91 * degree; }, "91");
  expectRefused([](auto& o) { o.tolerance.angle_rad = 6 * degree; }, "5");
  expectRefused([](auto& o) { o.jobs = -2; }, "-2");
  expectRefused([](auto& o) { o.level = Level::None; }, "none");
  expectRefused([](auto& o) { o.tolerance.gap_mm = 1e-18; }, "1e-18");
}

TEST(Analyze, AnEdgeWithAnEmptyRangeIsNamed) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  BRep_Builder().Range(TopoDS::Edge(edges(1)), 0.25, 0.25);
  const occ::Report report = analyzed(box);
  ASSERT_EQ(report.seams.size(), 12u);
  for (const SeamResult& seam : report.seams) {
    const bool is_empty = seam.edges.front() == 1;
    EXPECT_EQ(seam.figures.gap_mm.has_value(), !is_empty);
    const std::string note = "not measured: its edge has the parameter range 0.25 to 0.25";
    EXPECT_EQ(seam.note, is_empty ? note : "");
  }
}

TEST(ModelFromShape, NullAndFacelessShapesAreRefused) {
  TopExp_Explorer edges(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), TopAbs_EDGE);
  for (const TopoDS_Shape& shape : {TopoDS_Shape(), edges.Current()}) try {
      occ::modelFromShape(shape);
      FAIL();
    } catch (const occ::ModelError& error) {
      EXPECT_EQ(error.code(), occ::ModelErrc::NoShapes);
    }
}

}  // namespace
}  // namespace seamwright::test
