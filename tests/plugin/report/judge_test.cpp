// SPDX-License-Identifier: LGPL-2.1-or-later
// What is counted in the file of a repaired model.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <gp_Pnt.hxx>

#include <seamwright/plugin/report/repair_json.hpp>

#include "shapes.hpp"

namespace seamwright::report {
namespace {

using test::compoundOf;
using test::plate;

TopoDS_Face polygon(const std::vector<std::array<double, 2>>& corners) {
  BRepBuilderAPI_MakePolygon loop;
  for (const auto& [x, y] : corners) loop.Add(gp_Pnt(x, y, 0));
  loop.Close();
  return BRepBuilderAPI_MakeFace(loop.Wire());
}

/// Two faces with an edge in common, that goes on as two that part.
occ::Model partingFaces() {
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(polygon({{0, 0}, {10, 0}, {10, 10}, {9.98, 20}, {0, 20}}));
  sewing.Add(polygon({{10, 0}, {20, 0}, {20, 20}, {10.03, 20}, {10, 10}}));
  sewing.Perform();
  return occ::modelFromShape(sewing.SewedShape());
}

occ::SeamResult between(int one, int other, occ::SeamKind kind) {
  occ::SeamResult seam;
  seam.kind = kind;
  seam.faces = {one, other};
  return seam;
}

occ::RepairOptions matching(double match_mm) {
  occ::RepairOptions options;
  options.match_mm = match_mm;
  return options;
}

TEST(JudgeOfRepair, EdgesThatPartAfterOneThatWasSewnAreNoSeam) {
  const occ::RepairOptions options = matching(0.1);
  occ::RepairReport report;
  const Judge judge = judgeOf(report, options);
  EXPECT_EQ(judge(partingFaces(), {}).seams, 1);
  EXPECT_EQ(judge(partingFaces(), {}).defects, 0);
}

TEST(JudgeOfRepair, EdgesThatPartAreCountedWhereMemoryHasThemWhateverTheNumbers) {
  const occ::RepairOptions options = matching(0.1);
  occ::RepairReport report;
  report.after.seams = {between(7, 3, occ::SeamKind::Shared),
                        between(3, 7, occ::SeamKind::Matched)};
  const Judge judge = judgeOf(report, options);
  EXPECT_EQ(judge(partingFaces(), {}).seams, 2);
  EXPECT_EQ(judge(partingFaces(), {}).defects, 1);
}

TEST(JudgeOfRepair, LooseFacesAreCounted) {
  const occ::Model model =
      occ::modelFromShape(compoundOf({plate(0, 10, 0, 20), plate(10.05, 20, 0, 20),
                                      plate(0, 10, 40, 60), plate(10.05, 20, 40, 60)}));
  const occ::RepairOptions options = matching(0.1);
  occ::RepairReport report;
  EXPECT_EQ(judgeOf(report, options)(model, {}).seams, 2);
  EXPECT_EQ(judgeOf(report, options)(model, {}).defects, 2);
}

}  // namespace
}  // namespace seamwright::report
