// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/convert/surface_kind.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/choose.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/topology/own_parts.hpp>

namespace seamwright::occ {

namespace {

void requireSeams(const std::vector<int>& edges, const Report& report) {
  for (const int edge : edges) {
    const bool is_seam = std::ranges::any_of(report.seams, [edge](const SeamResult& seam) {
      return std::ranges::count(seam.edges, edge) > 0;
    });
    if (!is_seam)
      throw std::invalid_argument("edge " + std::to_string(edge) +
                                  " is not a seam: it does not have a face on both sides");
  }
}

/// By face: its first non-manifold edge.
std::map<int, const NonSeamEdge*> crowdedEdges(const Report& report) {
  std::map<int, const NonSeamEdge*> edges;
  for (const NonSeamEdge& edge : report.non_manifold)
    for (const int face : edge.faces) edges.emplace(face, &edge);
  return edges;
}

/// Tells why a face stays because it, or one of its edges, has several instances; empty if none
/// has.
class Instances {
 public:
  explicit Instances(const TopoDS_Shape& shape) : own_(withOwnParts(shape)) {
    TopExp::MapShapes(own_, TopAbs_FACE, faces_);
    TopExp::MapShapes(own_, TopAbs_EDGE, edges_);
    for (const TopTools_IndexedMapOfShape* parts : {&faces_, &edges_})
      for (int i = 1; i <= parts->Extent(); ++i) ++counts_[(*parts)(i).TShape().get()];
  }

  RepairReason whyNot(int face) const {
    if (const int count = countOf(faces_(face)); count > 1) return why::hasInstances(count);
    TopTools_IndexedMapOfShape within;
    TopExp::MapShapes(faces_(face), TopAbs_EDGE, within);
    for (int i = 1; i <= within.Extent(); ++i)
      if (const int count = countOf(within(i)); count > 1)
        return why::hasEdgeWithInstances(edges_.FindIndex(within(i)), count);
    return {};
  }

 private:
  int countOf(const TopoDS_Shape& part) const { return counts_.at(part.TShape().get()); }

  TopoDS_Shape own_;
  TopTools_IndexedMapOfShape faces_, edges_;
  std::map<const TopoDS_TShape*, int> counts_;
};

/// Tells why a face stays because it can't be computed with, or shares an edge with such a face.
/// The position of such an edge is not known.
class Unmovable {
 public:
  explicit Unmovable(const TopoDS_Shape& shape) : unusable_(shape) {
    if (unusable_.empty()) return;
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge_);
  }

  RepairReason whyNot(int face) const {
    if (unusable_.empty()) return {};
    if (const std::string fault = unusable_.whyLeftOut(face); !fault.empty())
      return why::isUnusable(fault);
    for (TopExp_Explorer edge(faces_(face), TopAbs_EDGE); edge.More(); edge.Next())
      for (const TopoDS_Shape& beside : faces_of_edge_.FindFromKey(edge.Current()))
        if (const int other = faces_.FindIndex(beside); unusable_.hasFace(other))
          return why::hasUnusableNeighbour(edges_.FindIndex(edge.Current()), other,
                                           unusable_.whyLeftOut(other));
    return {};
  }

 private:
  UnusableParts unusable_;
  TopTools_IndexedMapOfShape faces_, edges_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge_;
};

std::vector<FaceChoice> chooseFaces(const TopoDS_Shape& shape, const Report& before,
                                    const RepairOptions& options) {
  const std::map<int, const NonSeamEdge*> crowded = crowdedEdges(before);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  const Instances instances(shape);
  const Unmovable unmovable(shape);
  std::vector<FaceChoice> choices(static_cast<std::size_t>(faces.Extent()) + 1);
  for (int f = 1; f <= faces.Extent(); ++f) {
    const TopoDS_Face& face = TopoDS::Face(faces(f));
    TopLoc_Location location;
    const RepairReason of_instances = instances.whyNot(f);
    const RepairReason of_numbers = unmovable.whyNot(f);
    RepairReason& obstacle = choices[f].cannot_move;
    if (std::ranges::count(options.fixed_faces, f) > 0)
      obstacle = why::isFixed();
    else if (std::ranges::count(options.held_faces, f) > 0)
      obstacle = why::isHeld();
    else if (!of_numbers.empty())
      obstacle = of_numbers;
    else if (!of_instances.empty())
      obstacle = of_instances;
    else if (const auto edge = crowded.find(f); edge != crowded.end())
      obstacle =
          why::hasNonManifoldEdge(edge->second->edge, static_cast<int>(edge->second->faces.size()));
    else if (clampedSpline(BRep_Tool::Surface(face, location)).IsNull()) {
      obstacle = why::hasNoPoles(kindOf(face));
      choices[f].convertible = true;
    }
    choices[f].may_move = obstacle.empty();
    choices[f].may_be_trimmed = obstacle.empty() || choices[f].convertible;
  }
  return choices;
}

bool isWanted(const SeamResult& seam, const std::vector<int>& edges) {
  if (edges.empty()) return seam.verdict.seam_class == SeamClass::Defect;
  return std::ranges::any_of(seam.edges,
                             [&edges](int edge) { return std::ranges::count(edges, edge) > 0; });
}

bool isSharp(const SeamResult& seam, const RepairOptions& options) {
  if (seam.verdict.seam_class != SeamClass::Defect || !options.edges.empty()) return false;
  SeamFigures closed = seam.figures;
  closed.gap_mm = Figure{0, 0, 0};
  return judge(closed, options.tolerance, options.level()).seam_class == SeamClass::Crease;
}

/// Whether no face of the seam can move, but one could as a spline.
bool mayMoveAsSplines(const std::array<int, 2>& faces, const std::vector<FaceChoice>& choices) {
  const auto any = [&](bool FaceChoice::*is) {
    return std::ranges::any_of(faces, [&](int face) { return choices[face].*is; });
  };
  return !any(&FaceChoice::may_move) && any(&FaceChoice::convertible);
}

RepairReason whyNot(const SeamResult& seam, const std::vector<FaceChoice>& faces, bool sharp,
                    const RepairOptions& options) {
  if (!seam.figures.gap_mm) return why::notMeasured(seam.note);
  if (certainlyReaches(seam.figures, options.tolerance, options.level())) return why::hasLevel();
  if (const RepairReason reason = whyNoneMoves(seam.faces, faces); !reason.empty()) {
    const bool may_be_trimmed =
        std::ranges::any_of(seam.faces, [&faces](int face) { return faces[face].may_be_trimmed; });
    return may_be_trimmed && isOfGapAlone(seam, sharp, options.tolerance, options.level())
               ? RepairReason()
               : reason;
  }
  return seam.figures.fold_at && !sharp ? why::facesFold(*seam.figures.fold_at) : RepairReason();
}

}  // namespace

RepairReason whyNoneMoves(const std::array<int, 2>& faces, const std::vector<FaceChoice>& choices) {
  if (std::ranges::any_of(faces, [&choices](int face) { return choices[face].may_move; }))
    return {};
  std::vector<std::pair<int, RepairReason>> obstacles = {{faces[0], choices[faces[0]].cannot_move}};
  if (faces[1] != faces[0]) obstacles.emplace_back(faces[1], choices[faces[1]].cannot_move);
  return why::facesStay(obstacles);
}

bool isOfGapAlone(const SeamResult& seam, bool sharp, const ContinuityTolerance& tolerance,
                  Level level) {
  if (seam.kind != SeamKind::Shared || seam.faces[0] == seam.faces[1]) return false;
  if (seam.verdict.level != Level::None) return false;
  SeamFigures closed = seam.figures;
  closed.gap_mm = Figure{0, 0, 0};
  return sharp || judge(closed, tolerance, Level::G1).level >= level;
}

Choice choose(const Model& model, const Report& before, const RepairOptions& options) {
  for (const int face : options.fixed_faces) requireFace(face, model.faceCount());
  for (const int face : options.held_faces) requireFace(face, model.faceCount());
  for (const int edge : options.edges) requireEdge(edge, model.edgeCount());
  requireSeams(options.edges, before);
  Choice choice{{}, {}, {}, {}, chooseFaces(model.shape, before, options)};
  for (const SeamResult& seam : before.seams) {
    const bool wanted = isWanted(seam, options.edges);
    const bool sharp = isSharp(seam, options);
    const RepairReason reason =
        wanted ? whyNot(seam, choice.faces, sharp, options) : RepairReason();
    choice.treated.push_back(wanted && reason.empty());
    choice.sharp.push_back(sharp);
    choice.reasons.push_back(reason);
    choice.wants_conversion.push_back(
        wanted && seam.figures.gap_mm &&
        !certainlyReaches(seam.figures, options.tolerance, options.level()) &&
        mayMoveAsSplines(seam.faces, choice.faces));
  }
  return choice;
}

namespace {

/// The jump of a side's unit normal at a parameter of its pcurve; zero where it has no normal.
Eigen::Vector3d turnAt(const FaceStrip& strip, double s) {
  // Step to either side of the parameter, which runs over 0..1.
  constexpr double beside = 1e-7;
  std::array<Eigen::Vector3d, 2> normals;
  for (const int k : {0, 1}) {
    const SidePoint at = strip.firstOrderAt(k == 0 ? s - beside : s + beside);
    const auto normal = unitNormal(at.jet, at.noise);
    if (!normal) return Eigen::Vector3d::Zero();
    normals[k] = *normal;
  }
  return normals[1] - normals[0];
}

}  // namespace

RepairReason whyKinked(const Seam& seam, const ContinuityTolerance& tolerance) {
  // One side of the kink misses by at least half of its angle: more than twice the tolerance can't
  // be met. The margin of 0.1 is for the turn of the normals beside the kink.
  constexpr double certain = 2.1;
  if (seam.kind != SeamKind::Shared) return {};
  std::vector<FaceStrip> strips;
  for (const Coedge& side : seam.sides)
    strips.emplace_back(side, pcurveOf(side.edge, side.shape, tolerance.gap_mm));
  const auto normalOf = [&strips](std::size_t k, double s) {
    const SidePoint at = strips[k].firstOrderAt(s);
    return unitNormal(at.jet, at.noise);
  };
  for (const std::size_t k : {0, 1})
    for (const double s : strips[k].breaks()) {
      const auto a = normalOf(0, s), b = normalOf(1, s);
      if (!a || !b) continue;
      const double sense = a->dot(*b) < 0 ? -1 : 1;
      const double turn_rad = (turnAt(strips[0], s) - sense * turnAt(strips[1], s)).norm();
      if (turn_rad <= certain * tolerance.angle_rad) continue;
      return why::surfaceKink(seam.sides[k].face, turn_rad * degrees_per_radian, s);
    }
  return {};
}

bool isRepaired(const SeamResult& after, bool sharp, const ContinuityTolerance& tolerance,
                Level level) {
  if (!sharp) return certainlyReaches(after.figures, tolerance, level);
  const auto& gap = after.figures.gap_mm;
  return after.verdict.seam_class == SeamClass::Crease && gap && gap->upper &&
         *gap->upper <= tolerance.gap_mm;
}

}  // namespace seamwright::occ
