// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <array>

#include <seamwright/occ_adapter/topology/sew_reasons.hpp>

namespace seamwright::occ {

namespace {

/// In the order of SewFault.
constexpr std::array sew_codes = {"",
                                  "gap_too_large",
                                  "face_instances",
                                  "hollow_solid",
                                  "common_surface",
                                  "interval_divided",
                                  "interval_short",
                                  "interval_taken",
                                  "no_vertex",
                                  "points_out_of_order",
                                  "no_curve",
                                  "vertex_too_wide",
                                  "one_sided",
                                  "opencascade_failed",
                                  "checks_fail",
                                  "shell_opens",
                                  "loses_level"};

}  // namespace

std::string codeOf(SewFault fault) {
  static_assert(sew_codes.size() == static_cast<std::size_t>(SewFault::LosesLevel) + 1);
  return sew_codes.at(static_cast<std::size_t>(fault));
}

namespace why_not_sewn {

SewReason gapTooLarge(const std::string& figures) {
  return {.fault = SewFault::GapTooLarge,
          .text = "its gap is not certainly within the tolerance: " + figures};
}

SewReason faceInstances(int face, const std::string& name, int count) {
  return {.fault = SewFault::FaceInstances,
          .text = fmt::format("{} occurs in the model {} times", name, count),
          .numbers = {{"count", count}},
          .faces = {face}};
}

SewReason hollowSolid(int face, const std::string& name) {
  return {.fault = SewFault::HollowSolid,
          .text = name + " is part of a solid of several shells",
          .faces = {face}};
}

SewReason commonSurface(int face, const std::string& name, int other,
                        const std::string& other_name) {
  return {.fault = SewFault::CommonSurface,
          .text = fmt::format("{} and {} have one surface in common", name, other_name),
          .faces = {face, other}};
}

SewReason intervalDivided(int edge) {
  return {.fault = SewFault::IntervalDivided,
          .text = fmt::format("along it another interval of edge {} begins or ends", edge),
          .edges = {edge}};
}

SewReason intervalShort(int edge) {
  return {.fault = SewFault::IntervalShort,
          .text = fmt::format("its interval of edge {} is no longer than the gap tolerance", edge),
          .edges = {edge}};
}

SewReason intervalTaken(int edge) {
  return {.fault = SewFault::IntervalTaken,
          .text = fmt::format("edge {} lies along another edge there too", edge),
          .edges = {edge}};
}

SewReason noVertex(int edge) {
  return {.fault = SewFault::NoVertex, .text = "an edge ends without a vertex", .edges = {edge}};
}

SewReason pointsOutOfOrder() {
  return {.fault = SewFault::PointsOutOfOrder,
          .text = "the points of the two edges do not follow one another"};
}

SewReason noCurve(const std::string& fault) {
  return {.fault = SewFault::NoCurve, .text = fault};
}

SewReason vertexTooWide(double distance_mm, double allowed_mm) {
  return {.fault = SewFault::VertexTooWide,
          .text = fmt::format("a common vertex would be {:.6g} mm from the ends of its edges, more "
                              "than {:.6g} mm",
                              distance_mm, allowed_mm),
          .numbers = {{"distance_mm", distance_mm}, {"allowed_mm", allowed_mm}}};
}

SewReason oneSided() {
  return {.fault = SewFault::OneSided, .text = "it would close a band that has one side only"};
}

SewReason openCascadeFailed(const Standard_Failure& failure) {
  return {.fault = SewFault::OpenCascadeFailed,
          .text = fmt::format("OpenCASCADE failed: {} {}", failure.DynamicType()->Name(),
                              failure.GetMessageString())};
}

SewReason checksFailForFace(int face) {
  return {.fault = SewFault::ChecksFail,
          .text = fmt::format("OpenCASCADE's checks would not pass for face {}", face),
          .faces = {face}};
}

SewReason checksFailForShape() {
  return {.fault = SewFault::ChecksFail,
          .text = "OpenCASCADE's checks would not pass for the sewn shape"};
}

SewReason shellOpens() {
  return {.fault = SewFault::ShellOpens, .text = "a closed shell would open"};
}

SewReason losesLevel(const std::string& after, const std::string& before) {
  return {.fault = SewFault::LosesLevel,
          .text = fmt::format("as one edge it would have {}; before {}", after, before)};
}

}  // namespace why_not_sewn

}  // namespace seamwright::occ
