// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <seamwright/occ_adapter/fill/fill_reason.hpp>

namespace seamwright::occ {

namespace {

/// In the order of FillFault.
constexpr std::array codes = {"",
                              "unusable_boundary",
                              "too_many_corners",
                              "cusp",
                              "corner_too_wide",
                              "corner_above_180",
                              "only_face",
                              "edge_of_one_face",
                              "no_loop",
                              "construction_refused",
                              "opencascade_failed",
                              "not_sewn",
                              "free_edges",
                              "misses_target",
                              "may_miss_target",
                              "may_fold",
                              "turns_back",
                              "reaches_too_far",
                              "too_small",
                              "runs_into_itself",
                              "runs_into_face",
                              "invalid_face",
                              "invalid_shape",
                              "sharp_turn",
                              "side_not_polynomial",
                              "position_only",
                              "neighbours_contradict"};

/// "(1, 0, -2.5) mm"; coordinates that are zero up to rounding are 0.
std::string pointText(const Eigen::Vector3d& point_mm) {
  // To a millionth of a mm. Adding 0 turns -0 into 0.
  const auto rounded = [](double x) { return std::round(1e6 * x) / 1e6 + 0.0; };
  return fmt::format("({:.3g}, {:.3g}, {:.3g}) mm", rounded(point_mm.x()), rounded(point_mm.y()),
                     rounded(point_mm.z()));
}

/// "edge 3" or "edges 3, 7".
std::string edgesText(const std::vector<int>& edges) {
  return fmt::format("{} {}", edges.size() == 1 ? "edge" : "edges", fmt::join(edges, ", "));
}

std::string cornerText(const FillReason& reason, const std::string& fault) {
  return fmt::format("corner {:.0f} of the hole, between edges {} and {} at {}: {}",
                     reason.number("corner"), reason.edges.at(0), reason.edges.at(1),
                     pointText(reason.point_mm.value()), fault);
}

std::string seamText(const FillReason& reason) {
  const std::string &one = reason.faces.at(0), &other = reason.faces.at(1);
  const std::string seam = one == other ? fmt::format("a seam inside {}", one)
                                        : fmt::format("a seam between {} and {}", one, other);
  const char* verb =
      reason.fault == FillFault::MissesTarget ? "is not" : "does not certainly reach";
  return fmt::format("{} {} G{:.0f}: {}", seam, verb, reason.number("target"), reason.detail);
}

std::string notSewnText(const FillReason& reason) {
  if (reason.edges.empty()) return "the fill can't be sewn to itself";
  return fmt::format("the fill can't be sewn to edge {} of {}", reason.edges[0],
                     reason.faces.at(0));
}

/// Of a fault of the hole; otherwise empty.
std::string holeText(const FillReason& reason) {
  switch (reason.fault) {
    case FillFault::UnusableBoundary:
      return fmt::format("the hole can't be met at edge {}: {}", reason.edges.at(0), reason.detail);
    case FillFault::ConstructionRefused:
    case FillFault::OpenCascadeFailed:
      return reason.detail;
    case FillFault::TooManyCorners:
      return fmt::format("the hole has {:.0f} corners: fills have {:.0f} at most",
                         reason.number("corners"), reason.number("most"));
    case FillFault::Cusp:
      return cornerText(reason,
                        fmt::format("it is a cusp, with an angle of {:.3g} degrees, which no "
                                    "smooth face can fill: trim the tip off, so that a short "
                                    "edge takes its place",
                                    reason.number("angle_deg")));
    case FillFault::CornerTooWide:
      return cornerText(reason,
                        fmt::format("its angle is {:.3g} degrees, fills have {:.3g} at most: "
                                    "cut the hole in two there",
                                    reason.number("angle_deg"), reason.number("most_deg")));
    case FillFault::CornerAbove180:
      return cornerText(reason,
                        fmt::format("its angle is {:.3g} degrees, above 180: a hole of more "
                                    "than {:.0f} corners has to be cut in two there, by a "
                                    "face between",
                                    reason.number("angle_deg"), reason.number("corners")));
    case FillFault::OnlyFace:
      if (reason.number("faces") == 1) return "the face is the only one of the model";
      return fmt::format("the {:.0f} faces are all of the model: a fill needs others around it",
                         reason.number("faces"));
    case FillFault::EdgeOfOneFace:
      return "the face bounds the hole on one side only: it has an edge of its own";
    case FillFault::NoLoop:
      return "the edges of the face are not one loop of edges that the neighbours keep";
    default:
      return {};
  }
}

/// Of a fault of the fill; otherwise empty.
std::string fillText(const FillReason& reason) {
  switch (reason.fault) {
    case FillFault::NotSewn:
      return notSewnText(reason);
    case FillFault::FreeEdges:
      return fmt::format(
          "{:.0f} edges of the fill lie along no edge of the hole within the gap of "
          "{:.3g} mm",
          reason.number("count"), reason.number("gap_mm"));
    case FillFault::MissesTarget:
    case FillFault::MayMissTarget:
      return seamText(reason);
    case FillFault::MayFold:
      return "the new faces are not proved regular: they may fold over";
    case FillFault::TurnsBack:
      return "the new faces turn back over themselves, as their surroundings do not";
    case FillFault::ReachesTooFar:
      return fmt::format("the new faces stand out to {:.3g} times the size of the hole",
                         reason.number("reach"));
    case FillFault::TooSmall:
      return "the hole is too small for a seam to be measured";
    case FillFault::RunsIntoItself:
      return "the fill runs into itself";
    case FillFault::RunsIntoFace:
      return fmt::format("the fill runs into {}", reason.faces.at(0));
    case FillFault::InvalidFace:
      return fmt::format("OpenCASCADE's checks would not pass for {}", reason.faces.at(0));
    case FillFault::InvalidShape:
      return "OpenCASCADE's checks would not pass for the filled shape";
    default:
      return {};
  }
}

/// Of a cause; otherwise empty.
std::string causeText(const FillReason& reason) {
  switch (reason.fault) {
    case FillFault::SharpTurn:
      return fmt::format(
          "edges {} and {} are one side, but turn by {:.3g} degrees at {}: a corner "
          "angle below that makes a corner of it",
          reason.edges.at(0), reason.edges.at(1), reason.number("turn_deg"),
          pointText(reason.point_mm.value()));
    case FillFault::SideNotPolynomial:
      return fmt::format(
          "no single polynomial follows the side near {} ({}) closer than {:.3g} mm; allow a "
          "larger gap, or put a face across the hole there first",
          pointText(reason.point_mm.value()), edgesText(reason.edges), reason.number("gap_mm"));
    case FillFault::PositionOnly:
      return fmt::format(
          "along {} the faces are met in position alone: at a corner the plane of "
          "the next edges leaves theirs by {:.3g} degrees; the target G0 closes the "
          "hole",
          edgesText(reason.edges), reason.number("turn_deg"));
    case FillFault::NeighboursContradict:
      return fmt::format(
          "where edges {} and {} meet, at {}, the faces beside them have tangent planes that "
          "differ by {:.3g} degrees, so that every fill misses one of them by half of that: repair "
          "these faces first",
          reason.edges.at(0), reason.edges.at(1), pointText(reason.point_mm.value()),
          reason.number("angle_deg"));
    default:
      return {};
  }
}

}  // namespace

double FillReason::number(const std::string& name) const {
  const auto found = std::ranges::find(numbers, name, &std::pair<std::string, double>::first);
  if (found == numbers.end()) throw std::out_of_range("a reason has no number " + name);
  return found->second;
}

std::string codeOf(FillFault fault) {
  static_assert(codes.size() == static_cast<std::size_t>(FillFault::NeighboursContradict) + 1);
  return codes.at(static_cast<std::size_t>(fault));
}

std::string textOf(const FillReason& reason) {
  std::string text = holeText(reason) + fillText(reason) + causeText(reason);
  for (const FillReason& cause : reason.causes) text += "; " + textOf(cause);
  return text;
}

}  // namespace seamwright::occ
