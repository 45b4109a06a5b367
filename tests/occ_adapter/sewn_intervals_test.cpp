// SPDX-License-Identifier: LGPL-2.1-or-later
// Where edges are cut to be sewn: plates beside one long edge.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <numeric>

#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>
#include <seamwright/occ_adapter/topology/sewn_intervals.hpp>

namespace seamwright::test {
namespace {

using occ::Seam;
using occ::SewnInterval;
using occ::SewnIntervals;
using occ::sewnIntervals;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double gap_mm = 0.01;

struct Plate {
  double x0, x1, y0, y1;
};

/// The seams of loose plates beside the first one, by y.
std::vector<Seam> seamsOf(const std::vector<Plate>& plates) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const Plate& p : plates)
    builder.Add(compound,
                BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), p.x0, p.x1, p.y0, p.y1).Shape());
  occ::SeamGraph graph = occ::findSeams(compound);
  occ::matchFreeEdges({.match_mm = 0.1, .gap_mm = gap_mm}, graph, {});
  std::vector<Seam> seams;
  for (const Seam& seam : graph.seams)
    if (seam.sides[0].face == 1 || seam.sides[1].face == 1) seams.push_back(seam);
  return seams;
}

SewnIntervals cutUp(const std::vector<Seam>& seams, double gap = gap_mm) {
  std::vector<std::size_t> all(seams.size());
  std::iota(all.begin(), all.end(), 0);
  return sewnIntervals(seams, all, gap);
}

/// The cuts of the longest list, from either end.
std::vector<double> cutsOf(const SewnIntervals& intervals) {
  std::vector<double> cuts;
  for (const auto& [edge, own] : intervals.cuts)
    if (own.size() > cuts.size()) cuts = own;
  if (cuts.size() > 2 && cuts[1] > 1 - cuts[cuts.size() - 2]) {
    std::ranges::reverse(cuts);
    for (double& cut : cuts) cut = 1 - cut;
  }
  return cuts;
}

TEST(Intervals, ALongEdgeIsCutWhereItsNeighboursEnd) {
  // From y = -10 to 30; the neighbours end at 5, 20 and 29.
  const SewnIntervals cut =
      cutUp(seamsOf({{0, 10, -10, 30}, {10, 20, -10, 5}, {10, 20, 5, 20}, {10, 20, 20, 29}}));
  EXPECT_THAT(cut.refused, IsEmpty());
  ASSERT_EQ(cut.intervals.size(), 3);
  const std::vector<double> cuts = cutsOf(cut);
  ASSERT_EQ(cuts.size(), 5);
  const bool from_below = cuts[1] > 0.1;
  const std::vector<double> below = {0, 15 / 40.0, 30 / 40.0, 39 / 40.0, 1};
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(cuts[k], from_below ? below[k] : 1 - below[4 - k], 1e-9) << k;
  // Each neighbour's edge is one piece, the long one's pieces are all different.
  std::vector<int> pieces;
  for (const SewnInterval& interval : cut.intervals)
    for (const int side : {0, 1}) {
      const std::size_t count = cut.cuts.at(interval.edges[side]).size();
      if (count == 5)
        pieces.push_back(interval.pieces[side]);
      else
        EXPECT_EQ(count, 2);
    }
  std::ranges::sort(pieces);
  ASSERT_EQ(pieces.size(), 3);
  EXPECT_EQ(pieces[1], pieces[0] + 1);
  EXPECT_EQ(pieces[2], pieces[1] + 1);
}

TEST(Intervals, EndsWithinTheGapAreOne) {
  // One ends 0.008 mm before the next begins, and the last 0.008 mm before the edge does.
  const std::vector<Seam> seams =
      seamsOf({{0, 10, -10, 30}, {10, 20, -10, 4.992}, {10, 20, 5, 29.992}});
  EXPECT_EQ(cutsOf(cutUp(seams)).size(), 3);
  EXPECT_THAT(cutUp(seams).refused, IsEmpty());
  EXPECT_EQ(cutsOf(cutUp(seams, 0.005)).size(), 5);
}

TEST(Intervals, OneThatVanishesInTheGapIsRefused) {
  const std::vector<Seam> seams = seamsOf({{0, 10, -10, 30}, {10, 20, -10, 5}, {10, 20, 5, 29}});
  const SewnIntervals cut = cutUp(seams, 18);
  ASSERT_EQ(cut.refused.size(), 1);
  EXPECT_THAT(cut.refused.begin()->second.text, HasSubstr("is no longer than the gap tolerance"));
  EXPECT_EQ(cut.refused.begin()->second.fault, occ::SewFault::IntervalShort);
  // It is in the way of no other.
  EXPECT_EQ(cut.intervals.size(), 2);
}

TEST(Intervals, WhatOverlapsIsRefused) {
  std::vector<Seam> seams = seamsOf({{0, 10, -10, 30}, {10, 20, -10, 30}});
  ASSERT_EQ(seams.size(), 1);
  const int edge = seams[0].edges[0];
  // Once more over the middle of the first edge.
  Seam middle = seams[0];
  middle.edges[1] = 99;
  for (double& parameter : middle.correspondence.a) parameter = 0.3 + 0.3 * parameter;
  const SewnIntervals crossing = cutUp({seams[0], middle});
  EXPECT_EQ(crossing.refused.at(0).text,
            "along it another interval of edge " + std::to_string(edge) + " begins or ends");
  EXPECT_EQ(crossing.refused.at(0).fault, occ::SewFault::IntervalDivided);
  EXPECT_EQ(crossing.refused.at(0).edges, std::vector<int>{edge});
  EXPECT_EQ(crossing.refused.count(1), 0);
  // And over all of it.
  Seam twice = seams[0];
  twice.edges[1] = 99;
  const SewnIntervals same = cutUp({seams[0], twice});
  EXPECT_EQ(same.refused.count(0), 0);
  EXPECT_EQ(same.refused.at(1).text,
            "edge " + std::to_string(edge) + " lies along another edge there too");
  EXPECT_EQ(same.refused.at(1).fault, occ::SewFault::IntervalTaken);
}

}  // namespace
}  // namespace seamwright::test
