// SPDX-License-Identifier: LGPL-2.1-or-later
// What is repaired and sewn has the same verdicts in its file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include "files.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/model/write.hpp>

namespace seamwright::test {
namespace {

using occ::RepairReport;

/// Of each seam its faces and what it is, in any order: edges may be numbered otherwise in a file.
using Verdicts = std::vector<std::tuple<int, int, occ::SeamKind, SeamClass>>;

Verdicts verdictsOf(const occ::Report& report) {
  Verdicts verdicts;
  for (const occ::SeamResult& seam : report.seams) {
    if (seam.kind == occ::SeamKind::Matched) continue;
    const auto [low, high] = std::minmax(seam.faces[0], seam.faces[1]);
    verdicts.emplace_back(low, high, seam.kind, seam.verdict.seam_class);
  }
  std::ranges::sort(verdicts);
  return verdicts;
}

/// What is written is read and analysed without matching: what was sewn is one edge there.
occ::Report expectSameInFile(const RepairReport& report, const std::filesystem::path& path) {
  SCOPED_TRACE(path.extension());
  occ::writeModel(report.model, path);
  const occ::Report found = occ::analyze(occ::readModel(path));
  EXPECT_EQ(verdictsOf(found), verdictsOf(report.after));
  EXPECT_EQ(found.model.faces, report.after.model.faces);
  return found;
}

/// Degree 2 by 2; pole (i, j) at u = i / 2, v = j / 2.
TopoDS_Shape patch(const std::function<gp_Pnt(int i, int j)>& pole) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) poles.SetValue(i + 1, j + 1, pole(i, j));
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Shape();
}

/// z = 0.002 x^2 on both sides of x = 0; for x > 0 a triangle whose tip is an end of the seam,
/// shifted by so much over the other.
TopoDS_Shape sheetAndTip(double shifted_mm) {
  constexpr double bend = 0.002, width = 30, length = 40;
  const auto square = [&](int i, int j) {
    return gp_Pnt(-width * (1 - i / 2.0), length * j / 2, i == 0 ? bend * width * width : 0);
  };
  const auto triangle = [&](int i, int j) {
    return gp_Pnt(width * (i / 2.0) * (1 - j / 2.0) - shifted_mm, length * j / 2,
                  i == 2 && j == 0 ? bend * width * width : 0);
  };
  return compoundOf({patch(square), patch(triangle)});
}

TEST(ReadBack, SewnBesideATip) {
  const Folder folder;
  // States 1e-7 mm.
  writeStep(sheetAndTip(1e-4), folder / "loose.step");
  const RepairReport report = repair(occ::readModel(folder / "loose.step"), matching(0.001));
  ASSERT_EQ(sewnSeams(report), 1) << reasonsOf(report);
  ASSERT_EQ(report.seams[0].after.verdict.seam_class, SeamClass::Smooth);
  for (const char* name : {"sewn.step", "sewn.igs", "sewn.brep", "sewn.bin"}) {
    const occ::Report found = expectSameInFile(report, folder / name);
    ASSERT_EQ(found.seams.size(), 1) << name;
    EXPECT_LE(found.seams[0].figures.gap_mm->lower, 1.01e-4) << name;
    EXPECT_LE(angleDeg(found.seams[0]), 0.01) << name;
  }
}

/// Trimmed surfaces: faces that share no edges.
void writeLooseIges(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  IGESControl_Controller::Init();
  IGESControl_Writer writer("MM", 0);
  writer.AddShape(shape);
  writer.ComputeModel();
  ASSERT_TRUE(writer.Write(path.c_str()));
}

TEST(ReadBack, IgesKeepsWhatWasSewn) {
  const Folder folder;
  writeLooseIges(box(), folder / "loose.igs");
  const occ::Model model = occ::readModel(folder / "loose.igs");
  ASSERT_EQ(model.edgeCount(), 24);
  const RepairReport report = repair(model, matching(0.1));
  ASSERT_EQ(sewnSeams(report), 12) << reasonsOf(report);
  const occ::Report found = expectSameInFile(report, folder / "sewn.igs");
  EXPECT_EQ(found.model.edges, 12);
  EXPECT_TRUE(found.open.empty());
}

/// No more defects and free edges than these, and the same in each file.
void expectSameWhenReadBack(const occ::Model& model, const occ::RepairOptions& options,
                            int most_defects, std::size_t most_open) {
  const RepairReport report = repair(model, options);
  EXPECT_LE(std::ranges::count_if(report.after.seams,
                                  [](const occ::SeamResult& seam) {
                                    return seam.verdict.seam_class == SeamClass::Defect;
                                  }),
            most_defects);
  // What still matches without being sewn is open where nothing is matched.
  const std::size_t open = occ::analyze(report.model).open.size();
  EXPECT_LE(open, most_open);
  const Folder folder;
  for (const char* name : {"a.step", "a.igs", "a.brep"})
    EXPECT_EQ(expectSameInFile(report, folder / name).open.size(), open) << name;
}

TEST(ReadBack, VerdictsOfAFileOfAnotherProgramAreTheSame) {
  expectSameWhenReadBack(occ::readModel(occtModel("step/linkrods.step")), {}, 0, 0);
}

class ReadBackNets : public testing::TestWithParam<std::string> {};

TEST_P(ReadBackNets, VerdictsOfSewnFacesAreTheSame) {
  const TopoDS_Shape shell = brokenModel({GetParam(), 0.0005, testSeed()});
  const Folder folder;
  writeStep(compoundOf(apart(shell)), folder / "loose.step");
  expectSameWhenReadBack(occ::readModel(folder / "loose.step"), matching(0.05), 0,
                         occ::findSeams(shell).open.size());
}

INSTANTIATE_TEST_SUITE_P(Kinds, ReadBackNets, testing::Values("sheet", "trimmed triangles"),
                         [](const auto& kind) {
                           std::string name = kind.param;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace seamwright::test
