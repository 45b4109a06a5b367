// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair_checks.hpp"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <limits>
#include <sstream>

#include "dense_oracle.hpp"
#include "match_pairs.hpp"

#include <seamwright/occ_adapter/model/model.hpp>

namespace seamwright::test {

using occ::modelFromShape;
using occ::repair;
using occ::RepairOptions;
using occ::RepairReport;

std::string bytesOf(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  occ::writeBinaryShape(shape, stream);
  return stream.str();
}

namespace {

/// What is promised of every seam, seen by plain evaluation.
void expectSeam(const occ::SeamRepair& seam, const TopoDS_Shape& shape,
                const RepairOptions& options) {
  SCOPED_TRACE("edge " + std::to_string(seam.before.edges[0]) + " " + seam.reason.text + "\n" +
               describe(seam.before) + "\n" + describe(seam.after));
  if (seam.treated) {
    EXPECT_EQ(seam.reason.empty(), seam.repaired);
  }
  EXPECT_EQ(seam.before.edges, seam.after.edges);
  EXPECT_EQ(seam.before.faces, seam.after.faces);
  if (seam.repaired && seam.after.verdict.seam_class == SeamClass::Crease) {
    EXPECT_TRUE(options.edges.empty());
    EXPECT_GT(upper(seam.before.figures.gap_mm), options.tolerance.gap_mm);
    EXPECT_LE(upper(seam.after.figures.gap_mm), options.tolerance.gap_mm);
  } else if (seam.repaired) {
    EXPECT_GE(seam.after.verdict.level, options.level());
    EXPECT_TRUE(seam.after.figures.shares_known);
    EXPECT_LE(upper(seam.after.figures.gap_mm), options.tolerance.gap_mm);
    EXPECT_LE(upper(seam.after.figures.angle_rad), options.tolerance.angle_rad);
    if (options.order == 2) {
      EXPECT_LE(upper(seam.after.figures.curvature_rel), options.tolerance.curvature_rel);
    }
  } else {
    // Above the level asked for a seam may lose what it had, unless the user wants it kept.
    const Level kept = options.keep_curvature
                           ? seam.before.verdict.level
                           : std::min(seam.before.verdict.level, options.level());
    EXPECT_GE(seam.after.verdict.level, kept);
    EXPECT_LE(seam.after.figures.gap_mm->lower,
              std::max(options.tolerance.gap_mm, upper(seam.before.figures.gap_mm)));
  }
  if (seam.before.kind != occ::SeamKind::Shared) return;
  const auto sides = denseSides(shape, seam.after.edges[0], seam.after.faces);
  ASSERT_TRUE(sides);
  const DenseMaxima dense = denseMaxima(*sides, 501, options.tolerance);
  EXPECT_GE(upper(seam.after.figures.gap_mm), dense.gap_mm.sure());
  ASSERT_TRUE(dense.angle_rad);
  EXPECT_GE(upper(seam.after.figures.angle_rad), dense.angle_rad->sure());
}

}  // namespace

RepairReport repairedModel(const TopoDS_Shape& shape, const RepairOptions& options) {
  const std::string before = bytesOf(shape);
  const RepairReport report = repair(modelFromShape(shape), options);
  EXPECT_EQ(bytesOf(shape), before);
  const TopoDS_Shape& repaired = report.model.shape;
  EXPECT_EQ(BRepCheck_Analyzer(repaired).IsValid(), BRepCheck_Analyzer(shape).IsValid());
  expectTolerancesHold(repaired);
  for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    EXPECT_EQ(partsOf(repaired, kind).Extent(), partsOf(shape, kind).Extent());
  }
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE),
                                   faces_now = partsOf(repaired, TopAbs_FACE);
  for (int f = 1; f <= faces.Extent(); ++f) {
    const auto move = std::ranges::find(report.moves, f, &occ::FaceMove::face);
    TopLoc_Location location;
    const bool same = BRep_Tool::Surface(TopoDS::Face(faces(f)), location) ==
                      BRep_Tool::Surface(TopoDS::Face(faces_now(f)), location);
    EXPECT_EQ(same, move == report.moves.end()) << f;
    if (move == report.moves.end()) continue;
    EXPECT_GT(move->largest_move_mm, 0);
    EXPECT_LE(move->largest_move_mm,
              options.max_move_mm.value_or(std::numeric_limits<double>::infinity()));
    EXPECT_EQ(std::ranges::count(options.fixed_faces, f), 0);
  }
  EXPECT_EQ(report.changed(), !repaired.IsEqual(shape));
  // Measured again, all seams are what the report says.
  occ::AnalyzeOptions analyze;
  analyze.tolerance = options.tolerance;
  analyze.level = options.level();
  analyze.match_mm = options.match_mm;
  const occ::Report again = analyzed(repaired, analyze);
  EXPECT_EQ(again.seams.size(), report.seams.size());
  for (std::size_t i = 0; i < std::min(again.seams.size(), report.seams.size()); ++i) {
    EXPECT_EQ(upper(again.seams[i].figures.gap_mm), upper(report.after.seams[i].figures.gap_mm));
    EXPECT_EQ(again.seams[i].verdict.level, report.after.seams[i].verdict.level);
    expectSeam(report.seams[i], repaired, options);
  }
  return report;
}

int treated(const RepairReport& report) {
  return static_cast<int>(std::ranges::count(report.seams, true, &occ::SeamRepair::treated));
}
int repairedSeams(const RepairReport& report) {
  return static_cast<int>(std::ranges::count(report.seams, true, &occ::SeamRepair::repaired));
}
int sewnSeams(const RepairReport& report) {
  return static_cast<int>(std::ranges::count(report.seams, true, &occ::SeamRepair::sewn));
}
std::string reasonsOf(const RepairReport& report) {
  std::string reasons;
  for (const occ::SeamRepair& seam : report.seams)
    if (!seam.reason.empty())
      reasons += "edge " + std::to_string(seam.before.edges[0]) + ": " + seam.reason.text + "\n";
  return reasons;
}
double largestMove_mm(const RepairReport& report) {
  double largest = 0;
  for (const occ::FaceMove& move : report.moves) largest = std::max(largest, move.largest_move_mm);
  return largest;
}

RepairOptions strictRepair(int order) {
  RepairOptions options;
  options.order = order;
  options.tolerance = strict(order).tolerance;
  options.fairness =
      100;  // what is within such tolerances follows all that sides do along the seam
  return options;
}

RepairOptions matching(double match_mm) {
  RepairOptions options;
  options.match_mm = match_mm;
  return options;
}

}  // namespace seamwright::test
