// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include <seamwright/occ_adapter/fill/corner_reasons.hpp>

namespace seamwright::occ {

namespace {

/// In the order of CornerFault.
constexpr std::array corner_codes = {"",
                                     "not_in_one_shell",
                                     "edge_count",
                                     "not_one_fan",
                                     "edge_faces",
                                     "faces_turned",
                                     "face_twice",
                                     "edge_is_loop",
                                     "no_tangent",
                                     "no_normal",
                                     "smooth_edge",
                                     "flat_angle",
                                     "section_misses",
                                     "setback_too_small",
                                     "setback_too_large",
                                     "far_end_cut",
                                     "far_edge_cut",
                                     "fillets_cross",
                                     "ball_divides_solid",
                                     "edge_not_rounded",
                                     "not_rounded",
                                     "ball_not_surrounded",
                                     "no_section",
                                     "no_path",
                                     "opencascade_failed",
                                     "hole_of_other_shape",
                                     "construction_refused",
                                     "not_filled",
                                     "checks_fail",
                                     "may_fold",
                                     "runs_into_face",
                                     "misses_target"};

CornerReason ofEdge(CornerFault fault, int edge, const std::string& what) {
  return {.fault = fault, .text = fmt::format("edge {} {}", edge, what), .edges = {edge}};
}

/// With "edge 3: " before what is wrong.
CornerReason atEdge(CornerFault fault, int edge, const std::string& what) {
  return {.fault = fault, .text = fmt::format("edge {}: {}", edge, what), .edges = {edge}};
}

CornerReason ofFace(CornerFault fault, int face, const std::string& what) {
  return {.fault = fault, .text = fmt::format("face {} {}", face, what), .faces = {face}};
}

CornerReason ofBall(CornerFault fault, double ball_mm, const std::string& what) {
  return {.fault = fault,
          .text = fmt::format("a ball of {} about the vertex: {}", corner_why::lengthText(ball_mm),
                              what),
          .numbers = {{"ball_mm", ball_mm}}};
}

std::vector<int> edgesOf(int edge, int cause) {
  return edge == cause ? std::vector<int>{edge} : std::vector<int>{edge, cause};
}

CornerReason outsideBall(const corner_why::EdgeOutside& at, const std::string& what) {
  const std::string cause =
      fmt::format("edge {}, radius {}", at.cause, corner_why::lengthText(at.cause_radius_mm));
  return {
      .fault = CornerFault::EdgeNotRounded,
      .text = fmt::format("{}, outside a ball of {} about the vertex: {}",
                          at.cause == at.edge ? cause : fmt::format("{}: edge {}", cause, at.edge),
                          corner_why::lengthText(at.ball_mm), what),
      .numbers = {{"radius_mm", at.cause_radius_mm}, {"ball_mm", at.ball_mm}},
      .edges = edgesOf(at.edge, at.cause)};
}

/// "edge 3, 10 mm long: a fillet of radius 2 mm set back by 5 mm".
std::string setBackText(const corner_why::SetBackFillet& fillet) {
  const std::string long_edge =
      fmt::format("edge {}, {} long", fillet.edge, corner_why::lengthText(fillet.edge_mm));
  const std::string radius = corner_why::lengthText(fillet.cause_radius_mm),
                    setback = corner_why::lengthText(fillet.setback_mm);
  if (fillet.cause == fillet.edge)
    return fmt::format("{}: a fillet of radius {} set back by {}", long_edge, radius, setback);
  return fmt::format("edge {}: with a radius of {} there, the fillet of {}, set back by {},",
                     fillet.cause, radius, long_edge, setback);
}

/// What the radii are to be multiplied with so that fillets do not use up a length, to which they
/// are in proportion. A thousandth of the length has to be left; another one is for the rounding of
/// texts.
double helpfulFactor(double length_mm, double used_mm) {
  return (1 - 2e-3) * length_mm / used_mm;
}

std::string faceText(int face) {
  return face == 0 ? "a new face" : fmt::format("face {}", face);
}

std::vector<int> facesOf(int face) {
  return face == 0 ? std::vector<int>() : std::vector<int>{face};
}

std::string betweenText(CornerSeamKind kind, int face) {
  switch (kind) {
    case CornerSeamKind::Spoke:
      return "two patches";
    case CornerSeamKind::Section:
      return "a patch and a fillet";
    case CornerSeamKind::Spring:
      return "a patch and " + faceText(face);
    case CornerSeamKind::Contact:
      return "a fillet and " + faceText(face);
    case CornerSeamKind::Fillets:
      return "two fillets";
  }
  return {};
}

/// \param left_mm length of the fillet beyond the setback; negative, because it has no room.
CornerReason setBack(const corner_why::SetBackFillet& fillet, double left_mm,
                     const std::string& what) {
  CornerReason reason = {.fault = CornerFault::SetbackTooLarge,
                         .text = fmt::format("{} {}", setBackText(fillet), what),
                         .numbers = {{"edge_mm", fillet.edge_mm},
                                     {"setback_mm", fillet.setback_mm},
                                     {"radius_mm", fillet.cause_radius_mm}},
                         .edges = edgesOf(fillet.edge, fillet.cause)};
  if (fillet.given) return reason;
  const double factor = helpfulFactor(fillet.edge_mm, fillet.edge_mm - left_mm);
  reason.text += fmt::format("; all radii {:.3g} times as large would have room", factor);
  reason.numbers.emplace_back("factor", factor);
  return reason;
}

}  // namespace

std::string codeOf(CornerFault fault) {
  static_assert(corner_codes.size() == static_cast<std::size_t>(CornerFault::MissesTarget) + 1);
  return corner_codes.at(static_cast<std::size_t>(fault));
}

namespace corner_why {

std::string lengthText(double length_mm) {
  return fmt::format("{:.4g} mm", length_mm);
}

CornerReason notInOneShell(int vertex, int shells) {
  return {.fault = CornerFault::NotInOneShell,
          .text = fmt::format("vertex {} is in {} of a solid: one is needed", vertex,
                              shells == 0 ? "no shell" : fmt::format("{} shells", shells)),
          .numbers = {{"vertex", vertex}, {"shells", shells}}};
}

CornerReason edgeCount(int edges, int least, int most) {
  return {
      .fault = CornerFault::EdgeCount,
      .text = fmt::format("{} edges meet at the vertex: {} to {} are needed", edges, least, most),
      .numbers = {{"edges", edges}, {"least", least}, {"most", most}}};
}

CornerReason notOneFan(int faces, int edges) {
  return {.fault = CornerFault::NotOneFan,
          .text = fmt::format(
              "the faces at the vertex are {} around {} edges: one fan of faces is needed", faces,
              edges),
          .numbers = {{"faces", faces}, {"edges", edges}}};
}

CornerReason edgeFaces(int edge, int faces) {
  CornerReason reason =
      ofEdge(CornerFault::EdgeFaces, edge, fmt::format("bounds {} faces: two are needed", faces));
  reason.numbers = {{"faces", faces}};
  return reason;
}

CornerReason facesTurned(int edge) {
  return atEdge(CornerFault::FacesTurned, edge,
                "the faces beside it are turned against each other");
}

CornerReason faceTwice(int face, int visits) {
  CornerReason reason = ofFace(CornerFault::FaceTwice, face,
                               fmt::format("touches the vertex {} times: once is needed", visits));
  reason.numbers = {{"visits", visits}};
  return reason;
}

CornerReason edgeIsLoop(int edge) {
  return ofEdge(CornerFault::EdgeIsLoop, edge, "begins and ends at the vertex");
}

CornerReason noTangent(int edge) {
  return ofEdge(CornerFault::NoTangent, edge, "has no tangent at the vertex");
}

CornerReason noNormal(int face) {
  return ofFace(CornerFault::NoNormal, face, "has no normal at the vertex");
}

CornerReason smoothEdge(int edge) {
  return ofEdge(CornerFault::SmoothEdge, edge,
                "is smooth: the faces beside it are in one plane at the vertex, and only sharp "
                "edges can be rounded");
}

CornerReason flatAngle(int face, double angle_deg) {
  CornerReason reason =
      ofFace(CornerFault::FlatAngle, face,
             fmt::format("has an angle of {:f} degrees at the vertex", angle_deg));
  reason.numbers = {{"angle_deg", angle_deg}};
  return reason;
}

CornerReason sectionMisses(int edge, double radius_mm, double sweep_deg, double error_mm,
                           double section_mm) {
  CornerReason reason = atEdge(
      CornerFault::SectionMisses, edge,
      fmt::format("a section of radius {} over {:f} degrees is met to {}, not to {}",
                  lengthText(radius_mm), sweep_deg, lengthText(error_mm), lengthText(section_mm)));
  reason.numbers = {{"radius_mm", radius_mm},
                    {"sweep_deg", sweep_deg},
                    {"error_mm", error_mm},
                    {"section_mm", section_mm}};
  return reason;
}

CornerReason setbackTooSmall(int edge, double setback_mm, double least_mm) {
  CornerReason reason =
      atEdge(CornerFault::SetbackTooSmall, edge,
             fmt::format("a setback of {} leaves no room for spring curves: more than {} is needed",
                         lengthText(setback_mm), lengthText(least_mm)));
  reason.numbers = {{"setback_mm", setback_mm}, {"least_mm", least_mm}};
  return reason;
}

CornerReason setBackTooFar(const SetBackFillet& fillet, double length_mm) {
  const std::string what =
      length_mm < 0
          ? fmt::format("would end {} before it begins on one side", lengthText(-length_mm))
          : fmt::format("would be {} long on one side", lengthText(length_mm));
  CornerReason reason = setBack(fillet, length_mm, what);
  reason.numbers.emplace_back("length_mm", length_mm);
  return reason;
}

CornerReason setBackBeyondEnd(const SetBackFillet& fillet) {
  return setBack(fillet, fillet.edge_mm - fillet.setback_mm, "would begin beyond its end");
}

CornerReason setbackOutside(int edge, double setback_mm, double from_mm, double to_mm) {
  CornerReason reason =
      atEdge(CornerFault::SetbackTooLarge, edge,
             fmt::format("a setback of {} is not within its fillet, from {} to {}",
                         lengthText(setback_mm), lengthText(from_mm), lengthText(to_mm)));
  reason.numbers = {{"setback_mm", setback_mm}, {"from_mm", from_mm}, {"to_mm", to_mm}};
  return reason;
}

CornerReason farEndCut(int edge, double radius_mm, double from_mm) {
  CornerReason reason = atEdge(
      CornerFault::FarEndCut, edge,
      fmt::format("the plane at its far end cuts the cylinder of radius {} from {} beyond the "
                  "section on: more than 0 is needed",
                  lengthText(radius_mm), lengthText(from_mm)));
  reason.numbers = {{"radius_mm", radius_mm}, {"from_mm", from_mm}};
  return reason;
}

CornerReason farEdgeCut(int edge, double length_mm, const std::vector<FarCutter>& cutters) {
  CornerReason reason = {
      .fault = CornerFault::FarEdgeCut, .numbers = {{"length_mm", length_mm}}, .edges = {edge}};
  std::vector<std::string> cuts;
  double all_mm = 0, least_mm = 0;
  for (const FarCutter& cutter : cutters) {
    cuts.push_back(fmt::format("the fillet of edge {}, radius {}, takes {} of it", cutter.edge,
                               lengthText(cutter.radius_mm), lengthText(cutter.cut_mm)));
    const std::string which = cuts.size() == 1 ? "" : "next_";
    reason.numbers.emplace_back(which + "radius_mm", cutter.radius_mm);
    reason.numbers.emplace_back(which + "cut_mm", cutter.cut_mm);
    reason.edges.push_back(cutter.edge);
    all_mm += cutter.cut_mm;
    least_mm = std::min(least_mm, cutter.cut_mm);
  }
  reason.text = fmt::format("edge {}, {} long, at a far end: {}", edge, lengthText(length_mm),
                            fmt::join(cuts, ", "));
  if (least_mm < 0) {
    reason.text += ": outside of it, at any radius";
    return reason;
  }
  const double factor = helpfulFactor(length_mm, all_mm);
  std::vector<std::string> radii;
  for (const FarCutter& cutter : cutters) radii.push_back(lengthText(factor * cutter.radius_mm));
  reason.text += fmt::format("; {} of {} or less would leave a part of it",
                             radii.size() == 1 ? "a radius" : "radii", fmt::join(radii, " and "));
  reason.numbers.emplace_back("factor", factor);
  return reason;
}

CornerReason filletsCross(const std::array<int, 2>& edges,
                          const std::array<double, 2>& setbacks_mm) {
  return {.fault = CornerFault::FilletsCross,
          .text = fmt::format("edge {} and edge {}: their fillets cross before their sections, set "
                              "back by {} and {}",
                              edges[0], edges[1], lengthText(setbacks_mm[0]),
                              lengthText(setbacks_mm[1])),
          .numbers = {{"setback_mm", setbacks_mm[0]}, {"next_setback_mm", setbacks_mm[1]}},
          .edges = {edges[0], edges[1]}};
}

CornerReason ballStays(double ball_mm) {
  return ofBall(CornerFault::OpenCascadeFailed, ball_mm, "OpenCASCADE can't cut it out");
}

CornerReason ballDividesSolid(double ball_mm) {
  return ofBall(CornerFault::BallDividesSolid, ball_mm, "the solid falls apart without it");
}

CornerReason notRounded(double ball_mm, const std::vector<int>& edges,
                        const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::string> where;
  for (const int edge : edges) where.push_back(fmt::format("along edge {}", edge));
  for (const Eigen::Vector3d& at : points)
    where.push_back(fmt::format("at ({:.4g}, {:.4g}, {:.4g})", at.x(), at.y(), at.z()));
  CornerReason reason = ofBall(
      CornerFault::NotRounded, ball_mm,
      "OpenCASCADE rounds no edges outside of it" +
          (where.empty() ? "" : fmt::format(": its fillets fail {}", fmt::join(where, ", "))));
  reason.edges = edges;
  return reason;
}

CornerReason noSolid(double ball_mm) {
  return ofBall(CornerFault::NotRounded, ball_mm, "OpenCASCADE's fillets leave no solid");
}

CornerReason ballIsGone(double ball_mm) {
  return ofBall(CornerFault::BallNotSurrounded, ball_mm,
                "nothing of it is left in the fillets of OpenCASCADE");
}

CornerReason ballNotSurrounded(double ball_mm, std::size_t edges, std::size_t of_corner) {
  CornerReason reason =
      ofBall(CornerFault::BallNotSurrounded, ball_mm,
             fmt::format("its boundary has {} edges, only {} of them on fillets and faces of the "
                         "corner",
                         edges, of_corner));
  reason.numbers.emplace_back("edges", static_cast<double>(edges));
  reason.numbers.emplace_back("of_corner", static_cast<double>(of_corner));
  return reason;
}

CornerReason filletInSeveralFaces(double ball_mm) {
  return ofBall(CornerFault::BallNotSurrounded, ball_mm, "a fillet comes to it in several faces");
}

CornerReason ballFailed(double ball_mm, const Standard_Failure& failure) {
  return ofBall(CornerFault::OpenCascadeFailed, ball_mm,
                fmt::format("OpenCASCADE stops at {} {}", failure.DynamicType()->Name(),
                            failure.GetMessageString()));
}

CornerReason edgeInParts(const EdgeOutside& at, int parts) {
  CornerReason reason = outsideBall(at, fmt::format("{} parts of it are left, not one", parts));
  reason.numbers.emplace_back("parts", parts);
  return reason;
}

CornerReason edgeContinues(const EdgeOutside& at) {
  return outsideBall(at,
                     "it continues another edge of the corner smoothly, they can't have fillets of "
                     "their own");
}

CornerReason edgeHasNoFillet(const EdgeOutside& at) {
  return outsideBall(at, "OpenCASCADE has no fillet for it");
}

CornerReason filletMissesBall(const EdgeOutside& at) {
  return outsideBall(at, "its fillet, or the face after it, does not come to the ball");
}

CornerReason openCascadeHasNone() {
  return {.fault = CornerFault::NotRounded,
          .text = "OpenCASCADE makes no fillet of all edges at the vertex"};
}

CornerReason filletApart(int edge) {
  return atEdge(CornerFault::NoSection, edge,
                "its fillet and the face beside it come to the ball apart");
}

CornerReason filletHasNoEdge(int edge) {
  return atEdge(CornerFault::NoSection, edge, "its fillet has no edge that leaves the ball");
}

CornerReason noSection(int edge) {
  return atEdge(CornerFault::NoSection, edge, "no section of its fillet runs from face to face");
}

CornerReason noSpringCurve(int edge) {
  return atEdge(CornerFault::NoPath, edge, "OpenCASCADE makes no curve on the face after it");
}

CornerReason noPath() {
  return {.fault = CornerFault::NoPath,
          .text = "OpenCASCADE finds no path on a face between two fillets"};
}

CornerReason noHole() {
  return {.fault = CornerFault::HoleOfOtherShape, .text = "no hole is left between the fillets"};
}

CornerReason holeSides(std::size_t sides, std::size_t needed) {
  return {
      .fault = CornerFault::HoleOfOtherShape,
      .text =
          fmt::format("the hole between the fillets has {} sides: {} are needed", sides, needed),
      .numbers = {{"sides", static_cast<double>(sides)}, {"needed", static_cast<double>(needed)}}};
}

CornerReason constructionRefused(const std::string& why) {
  return {.fault = CornerFault::ConstructionRefused, .text = why};
}

CornerReason notFilled(const std::string& why) {
  return {.fault = CornerFault::NotFilled, .text = "the corner between the fillets: " + why};
}

CornerReason checksFail() {
  return {.fault = CornerFault::ChecksFail,
          .text = "the new shell fails OpenCASCADE's checks: the fillets may overlap something"};
}

CornerReason mayFold() {
  return {.fault = CornerFault::MayFold,
          .text = "the patches are not proved regular: other setbacks may help"};
}

CornerReason runsIntoFace(int face) {
  return {.fault = CornerFault::RunsIntoFace,
          .text = fmt::format("a new face runs into {}: smaller radii may help", faceText(face)),
          .faces = facesOf(face)};
}

CornerReason missesTarget(CornerSeamKind kind, int face, const std::string& figures) {
  return {.fault = CornerFault::MissesTarget,
          .text = fmt::format("a seam between {}: {}", betweenText(kind, face), figures),
          .faces = facesOf(face)};
}

}  // namespace corner_why

}  // namespace seamwright::occ
