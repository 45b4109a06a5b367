// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <StdFail_NotDone.hxx>

#include <seamwright/occ_adapter/topology/sew_reasons.hpp>

#include "reason_rows.hpp"

namespace seamwright::test {
namespace {

using occ::SewFault;
using occ::SewReason;
using Rows = std::vector<ReasonRow<SewReason>>;

namespace why = occ::why_not_sewn;

Rows rowsOfFacesAndEdges() {
  return {
      {"gap_too_large",
       why::gapTooLarge("gap 0.5 mm"),
       {.says = "not certainly within the tolerance: gap 0.5 mm", .foreign = {0.5}}},
      {"face_instances",
       why::faceInstances(7, "face 7", 3),
       {.says = "face 7 occurs in the model 3 times", .numbers = {{"count", 3}}, .faces = {7}}},
      {"hollow_solid",
       why::hollowSolid(7, "face 7"),
       {.says = "face 7 is part of a solid of several shells", .faces = {7}}},
      {"common_surface",
       why::commonSurface(7, "face 7", 9, "face 9"),
       {.says = "face 7 and face 9 have one surface", .faces = {7, 9}}},
      {"interval_divided",
       why::intervalDivided(11),
       {.says = "another interval of edge 11 begins or ends", .edges = {11}}},
      {"interval_short",
       why::intervalShort(11),
       {.says = "its interval of edge 11 is no longer than the gap", .edges = {11}}},
      {"interval_taken",
       why::intervalTaken(11),
       {.says = "edge 11 lies along another edge", .edges = {11}}},
      {"no_vertex",
       why::noVertex(11),
       {.says = "ends without a vertex", .edges = {11}, .silent = {11}}},
  };
}

Rows rowsOfResults() {
  return {
      {"points_out_of_order", why::pointsOutOfOrder(), {.says = "do not follow one another"}},
      {"no_curve", why::noCurve("no path runs along both"), {.says = "no path runs along both"}},
      {"vertex_too_wide",
       why::vertexTooWide(0.5, 0.25),
       {.says = "0.5 mm from the ends of its edges, more than 0.25 mm",
        .numbers = {{"distance_mm", 0.5}, {"allowed_mm", 0.25}}}},
      {"one_sided", why::oneSided(), {.says = "a band that has one side only"}},
      {"opencascade_failed",
       why::openCascadeFailed(StdFail_NotDone("a test")),
       {.says = "OpenCASCADE failed: StdFail_NotDone a test"}},
      {"checks_fail",
       why::checksFailForFace(7),
       {.says = "checks would not pass for face 7", .faces = {7}}},
      {"checks_fail",
       why::checksFailForShape(),
       {.says = "checks would not pass for the sewn shape"}},
      {"shell_opens", why::shellOpens(), {.says = "a closed shell would open"}},
      {"loses_level",
       why::losesLevel("gap 0.5 mm", "gap 0.25 mm"),
       {.says = "would have gap 0.5 mm; before gap 0.25 mm", .foreign = {0.5, 0.25}}},
  };
}

TEST(SewReasons, EachHasItsCodeNumbersAndLocation) {
  std::set<std::string> codes = expectRows(rowsOfFacesAndEdges());
  codes.merge(expectRows(rowsOfResults()));
  expectEveryCode<SewFault>(codes);
}

}  // namespace
}  // namespace seamwright::test
