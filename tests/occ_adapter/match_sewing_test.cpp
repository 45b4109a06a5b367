// SPDX-License-Identifier: LGPL-2.1-or-later
// Seams of faces that share no edge, compared with what OpenCASCADE's sewing finds.
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopoDS_Edge.hxx>
#include <functional>

#include <seamwright/occ_adapter/model/read.hpp>

#include "files.hpp"
#include "matched_seams.hpp"
#include "repair_trials.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

namespace seamwright::test {
namespace {

using occ::Report;

double lengthOfEdges(int count, const std::function<TopoDS_Edge(int)>& edge) {
  double length = 0;
  for (int i = 1; i <= count; ++i)
    length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge(i)));
  return length;
}

/// Loose faces: matched seams against the edges that sewing joins. \param edges, length: by how
/// much of their number and their length they may differ.
void expectWhatSewingFinds(const TopoDS_Shape& shape, double match_mm, double edges,
                           double length) {
  BRepBuilderAPI_Sewing sewing(match_mm);
  sewing.Add(shape);
  sewing.Perform();
  const double sewn =
      lengthOfEdges(sewing.NbContigousEdges(), [&](int i) { return sewing.ContigousEdge(i); });
  const Report report = analyzedMatched(shape, match_mm);
  double matched_length = 0;
  for (const double one : lengths(report)) matched_length += one;
  const double expected = sewing.NbContigousEdges();
  EXPECT_NEAR(static_cast<double>(lengths(report).size()), expected, edges * expected);
  EXPECT_NEAR(matched_length, sewn, length * sewn);
}

TEST(Match, BearingAgreesWithSewing) {
  expectWhatSewingFinds(occ::readModel(occtModel("iges/bearing.iges")).shape, 1e-4, 0.01, 1e-3);
}

TEST(Match, HammerAgreesWithSewing) {
  expectWhatSewingFinds(occ::readModel(occtModel("iges/hammer.iges")).shape, 10, 0.01, 1e-3);
}

/// Faces that were one shell: sewing and the seams of the shell.
TEST(Match, NetsAgreeWithSewingAndWithWhatTheyWere) {
  for (const NetKind& kind : netKinds()) {
    SCOPED_TRACE(kind.name);
    const TopoDS_Shape shell = brokenModel({kind.name, 0.001, testSeed()});
    const TopoDS_Shape faces = compoundOf(apart(shell));
    expectWhatSewingFinds(faces, 0.05, 0, 1e-3);
    EXPECT_EQ(lengths(analyzedMatched(faces, 0.05)).size(), occ::findSeams(shell).seams.size());
  }
}

}  // namespace
}  // namespace seamwright::test
