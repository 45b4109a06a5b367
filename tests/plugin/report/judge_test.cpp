// SPDX-License-Identifier: LGPL-2.1-or-later
// What is counted in the file of a repaired model.
#include <gtest/gtest.h>

#include <seamwright/plugin/report/repair_json.hpp>

#include "shapes.hpp"

namespace seamwright::report {
namespace {

using test::compoundOf;
using test::plate;

TEST(JudgeOfRepair, MatchedSeamsAreThoseOfMemory) {
  // Two pairs of loose plates, 0.05 mm apart.
  const occ::Model model = occ::modelFromShape(compoundOf(
      {plate(0, 10, 0, 20), plate(10.05, 20, 0, 20), plate(0, 10, 40, 60), plate(10.05, 20, 40, 60)}));
  occ::RepairOptions options;
  options.match_mm = 0.1;
  occ::RepairReport report;
  const Judge judge = judgeOf(report, options);
  EXPECT_EQ(judge(model, {}).seams, 0);
  EXPECT_EQ(judge(model, {}).defects, 0);
  occ::SeamResult seam;
  seam.kind = occ::SeamKind::Matched;
  seam.faces = {4, 3};
  report.after.seams = {seam};
  EXPECT_EQ(judge(model, {}).seams, 1);
  EXPECT_EQ(judge(model, {}).defects, 1);
  seam.faces = {1, 2};
  seam.kind = occ::SeamKind::Shared;
  report.after.seams.push_back(seam);
  EXPECT_EQ(judge(model, {}).seams, 1);
  EXPECT_EQ(judge(model, {}).faces, 4);
}

}  // namespace
}  // namespace seamwright::report
