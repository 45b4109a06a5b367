// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/repair/displace.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

handle<Geom_BSplineSurface> splineOfFace(const TopoDS_Face& face) {
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
  const auto spline = handle<Geom_BSplineSurface>::DownCast(surface);
  const bool periodic = !spline.IsNull() && (spline->IsUPeriodic() || spline->IsVPeriodic());
  if (!periodic) return clampedSpline(surface, location);
  return handle<Geom_BSplineSurface>::DownCast(spline->Transformed(location.Transformation()));
}

bool isTreatedWhereItCloses(int face, const RepairTask& task) {
  for (std::size_t i = 0; i < task.seams.size(); ++i)
    if (const auto& sides = task.seams[i].sides;
        task.isTreated(i) && sides[0].face == face && sides[1].face == face)
      return true;
  return false;
}

/// The area of the face. A face without all pcurves can't be integrated; its area is then that of
/// its parameter rectangle.
double area_mm2(const TopoDS_Face& face, const handle<Geom_BSplineSurface>& surface,
                const std::array<double, 4>& range) {
  GProp_GProps of_face, of_range;
  BRepGProp::SurfaceProperties(face, of_face);
  if (of_face.Mass() > 0) return of_face.Mass();
  BRepGProp::SurfaceProperties(BRepBuilderAPI_MakeFace(surface, range[0], range[1], range[2],
                                                       range[3], Precision::Confusion())
                                   .Face(),
                               of_range);
  return of_range.Mass();
}

/// The faces of the task, now and as given.
class TaskFaces {
 public:
  explicit TaskFaces(const RepairTask& task) {
    TopExp::MapShapes(task.shape, TopAbs_FACE, now_);
    TopExp::MapShapes(task.given, TopAbs_FACE, given_);
  }

  int count() const { return now_.Extent(); }
  const TopoDS_Shape& operator()(int face) const { return now_(face); }
  const TopoDS_Shape& given(int face) const { return given_(face); }

 private:
  TopTools_IndexedMapOfShape now_, given_;
};

/// A moving face. Its budget is half of the variation of its mean curvature plus the variation that
/// is invisible or needed (docs/theory/repair.md, "The budget").
MovingFace moverOf(int number, const TopoDS_Face& face, const TopoDS_Face& given,
                   const RepairTask& task) {
  // Spans of the first displacement; refinement adds more where samples miss. A side within a
  // hundredth of the gap tolerance of one point becomes that point. Half of the variation is what
  // the default fairness of 1.5 allows.
  constexpr int first_spans = 4;
  constexpr double share_of_gap = 0.01, share_of_variation = 0.5;
  const handle<Geom_BSplineSurface> surface = splineOfFace(face);
  std::array<double, 4> range{};
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  const handle<Geom_BSplineSurface> first = splineOfFace(given);
  MovingFace mover{.displacement = Displacement(surface, range, first_spans,
                                                share_of_gap * task.options.tolerance.gap_mm,
                                                isTreatedWhereItCloses(number, task),
                                                std::array{first->UDegree(), first->VDegree()})};
  // Half the lines of the proof: the budget is a scale, and need not be exact.
  mover.budget_per_mm = share_of_variation * variationOf_per_mm(face, surface, {.lines = 16}) +
                        allowedVariation(number, face, task.options.tolerance, task.needed, 1);
  mover.area_mm2 = area_mm2(face, surface, range);
  mover.size_mm = sizeOf_mm(face);
  return mover;
}

/// The order up to which a seam that is not treated keeps its figures.
int orderKept(const SeamResult& seam, const RepairOptions& options) {
  if (isFold(seam, options.tolerance)) return 0;
  if (anyCurvatureDoes(options.tolerance)) return 1;
  const bool keeps_curvature = options.order > 1        ? seam.verdict.level >= Level::G1
                               : options.keep_curvature ? seam.verdict.level >= Level::G2
                                                        : false;
  return keeps_curvature ? 2 : 1;
}

Restraint restraintOf(int face, const Restraints& restraints) {
  const auto found = restraints.find(face);
  return found == restraints.end() ? Restraint{} : found->second;
}

/// Whether the edge may slide on a side whose face stays while its neighbour moves. The surface
/// must extend on both sides of the edge.
bool maySlide(const RepairTask& task, std::size_t i, int side, const Pcurve& path,
              const std::set<int>& moving, const Restraints& restraints) {
  const Seam& seam = task.seams[i];
  const Coedge &own = seam.sides[side], &other = seam.sides[1 - side];
  return seam.kind == SeamKind::Shared && moving.count(own.face) == 0 &&
         moving.count(other.face) > 0 && task.faces[own.face].may_be_trimmed &&
         !restraintOf(own.face, restraints).keeps_edges &&
         !BRep_Tool::IsClosed(own.edge, own.shape) && StayingSurface(own.shape).surrounds(path);
}

Joint jointOf(const RepairTask& task, std::size_t i, const MissedParameters& missed,
              const TurnsAtEnds& turns, const std::set<int>& moving, const Restraints& restraints) {
  Joint joint;
  joint.seam = i;
  joint.ask = task.isTreated(i) ? Ask::Join : Ask::Keep;
  joint.order = !task.isTreated(i) ? orderKept(task.before[i], task.options)
                : task.sharp[i]    ? 0
                                   : task.orders[i];
  for (const Coedge& side : task.seams[i].sides) {
    joint.sides.push_back(side);
    joint.paths.push_back(pcurveOf(side.edge, side.shape, task.options.tolerance.gap_mm));
  }
  for (const int k : {0, 1})
    joint.slides[k] = maySlide(task, i, k, joint.paths[k], moving, restraints);
  joint.turn_rad = task.options.tolerance.angle_rad + turns.at_rad(task.seams[i]);
  joint.map = task.seams[i].correspondence;
  if (const auto parameters = missed.find(i); parameters != missed.end())
    joint.also = parameters->second;
  return joint;
}

Joint outlineOf(const Coedge& use, double gap_mm) {
  Joint joint;
  joint.ask = Ask::Outline;
  joint.order = 0;
  joint.sides.push_back(use);
  joint.paths.push_back(pcurveOf(use.edge, use.shape, gap_mm));
  return joint;
}

std::set<int> facesToMove(const RepairTask& task) {
  std::set<int> faces;
  const FacesAtVertices around(task.shape);
  for (std::size_t i = 0; i < task.seams.size(); ++i) {
    if (!task.isTreated(i)) continue;
    const auto& sides = task.seams[i].sides;
    const std::set<int> moving = task.neighbours_help ? around.of(task.seams[i])
                                                      : std::set<int>{sides[0].face, sides[1].face};
    for (const int face : moving)
      if (task.faces[face].may_move) faces.insert(face);
  }
  return faces;
}

std::vector<Joint> jointsOf(const RepairTask& task, const std::vector<Coedge>& open,
                            const std::set<int>& moving, const MissedParameters& missed,
                            const Restraints& restraints) {
  const TurnsAtEnds turns(task);
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < task.seams.size(); ++i) {
    const auto& sides = task.seams[i].sides;
    if (moving.count(sides[0].face) > 0 || moving.count(sides[1].face) > 0)
      joints.push_back(jointOf(task, i, missed, turns, moving, restraints));
  }
  for (const Coedge& use : open)
    if (moving.count(use.face) > 0) joints.push_back(outlineOf(use, task.options.tolerance.gap_mm));
  return joints;
}

/// Movers that joints connect, with all joints of them.
struct Part {
  std::set<int> faces;
  std::vector<Joint> joints;
};

std::vector<Part> connectedParts(const std::set<int>& moving, std::vector<Joint> joints,
                                 int faces) {
  DisjointSets groups(faces + 1);
  for (const Joint& joint : joints)
    if (joint.sides.size() == 2 && moving.count(joint.sides[0].face) > 0 &&
        moving.count(joint.sides[1].face) > 0)
      groups.unite(joint.sides[0].face, joint.sides[1].face);
  std::map<int, Part> parts;
  for (const int face : moving) parts[groups.of(face)].faces.insert(face);
  for (Joint& joint : joints) {
    const auto mover = std::ranges::find_if(
        joint.sides, [&](const Coedge& side) { return moving.count(side.face) > 0; });
    parts[groups.of(mover->face)].joints.push_back(std::move(joint));
  }
  std::vector<Part> list;
  for (auto& [first, part] : parts) list.push_back(std::move(part));
  return list;
}

std::string keyOf(const Part& part, const Restraints& restraints) {
  std::ostringstream key;
  // Digits enough to tell any two doubles apart.
  key.precision(17);
  for (const int face : part.faces) {
    const Restraint restraint = restraintOf(face, restraints);
    key << face << '*' << restraint.stiffness << '<' << restraint.move_mm << ' ';
  }
  for (const Joint& joint : part.joints) {
    key << joint.seam << ':' << static_cast<int>(joint.ask) << joint.order << joint.slides[0]
        << joint.slides[1];
    for (const double s : joint.also) key << '@' << s;
    key << ' ';
  }
  return key.str();
}

/// Whether the target of a seam of the part fell from G2 to G1.
bool getsLower(const Part& part, const FairComponent& component) {
  return std::ranges::any_of(part.joints, [&component](const Joint& joint) {
    const auto order = component.orders.find(joint.seam);
    return joint.ask == Ask::Join && order != component.orders.end() && joint.order < order->second;
  });
}

/// Takes a start from earlier solutions. If the target of a seam was lowered the solution starts
/// from zero: the curvature condition that could not be met has distorted the earlier
/// displacements.
FairStart startOf(const Part& part, const std::vector<FairComponent>& before,
                  const Restraints& restraints, MovingFaces& movers) {
  FairStart start;
  for (const FairComponent& component : before) {
    if (component.diverged || getsLower(part, component)) continue;
    for (const auto& [face, mover] : component.movers)
      if (part.faces.count(face) > 0) {
        movers.emplace(face, mover);
        start.is_new = false;
        if (Restraint{.stiffness = mover.stiffness, .move_mm = mover.restraint_mm} !=
            restraintOf(face, restraints))
          start.relaxed.insert(face);
      }
    for (const Joint& joint : part.joints) {
      const auto weights = component.weights.find(joint.seam);
      if (joint.ask == Ask::Outline || weights == component.weights.end()) continue;
      const auto order = component.orders.find(joint.seam);
      const int was = order == component.orders.end() ? 0 : order->second;
      if (was == (joint.ask == Ask::Join ? joint.order : 0))
        start.weights.insert(*weights);
      else
        for (const Coedge& side : joint.sides) start.relaxed.insert(side.face);
    }
  }
  return start;
}

/// The seams that miss most, from half of the worst miss on. The others may miss only because of
/// these.
/// \param with_curvature consider the seams with target G2; otherwise the others.
Reasons failuresOf(const Part& part, const std::vector<double>& missed, bool with_curvature,
                   double limit_mm) {
  constexpr double share_of_worst = 0.5;
  double worst = 0;
  const auto counts = [&](std::size_t j) {
    return part.joints[j].ask == Ask::Join && (part.joints[j].order > 1) == with_curvature;
  };
  for (std::size_t j = 0; j < missed.size(); ++j)
    if (counts(j)) worst = std::max(worst, missed[j]);
  Reasons failures;
  for (std::size_t j = 0; j < missed.size(); ++j)
    if (counts(j) && missed[j] >= share_of_worst * worst)
      failures[part.joints[j].seam] = why::missesTolerance(missed[j], limit_mm);
  return failures;
}

/// New pcurves of the edges that slide. An edge of a seam to be repaired may slide although no face
/// moves, because only the edge may stray.
std::vector<PathChange> slidPaths(const Part& part, const RepairTask& task,
                                  const std::vector<FaceChange>& changes) {
  std::vector<PathChange> paths;
  for (const Joint& joint : part.joints)
    for (const int k : {0, 1}) {
      if (!joint.slides[k]) continue;
      const Coedge &stays = joint.sides[k], &moves = joint.sides[1 - k];
      const auto change = std::ranges::find(changes, moves.face, &FaceChange::face);
      const bool is_moved = change != changes.end();
      if (!is_moved && joint.ask != Ask::Join) continue;
      const handle<Geom_Surface> surface =
          is_moved ? change->surface : BRep_Tool::Surface(moves.shape);
      if (auto path = slidPath(task.seams[joint.seam].edges.front(), stays, moves, surface,
                               task.options.tolerance.gap_mm))
        paths.push_back(*std::move(path));
    }
  return paths;
}

FairComponent solved(const RepairTask& task, const Part& part, std::string key,
                     const TaskFaces& faces, const std::vector<FairComponent>& before,
                     const Restraints& restraints, const Progress& progress) {
  FairComponent component;
  component.asked = std::move(key);
  const FairStart start = startOf(part, before, restraints, component.movers);
  for (const int face : part.faces)
    if (component.movers.count(face) == 0)
      component.movers.emplace(
          face, moverOf(face, TopoDS::Face(faces(face)), TopoDS::Face(faces.given(face)), task));
  for (auto& [face, mover] : component.movers) {
    const Restraint restraint = restraintOf(face, restraints);
    mover.stiffness = restraint.stiffness;
    mover.restraint_mm = restraint.move_mm;
  }
  FairResult result =
      fairSolve(part.joints, task.options.tolerance, start, component.movers, progress);
  component.weights = std::move(result.weights);
  // No later solution starts from one that misses by more tolerances.
  constexpr double far = 10;
  double most_missed = 1;
  int most_asked = 0;
  for (std::size_t j = 0; j < part.joints.size(); ++j)
    if (const Joint& joint = part.joints[j]; joint.ask == Ask::Join) {
      most_missed = std::max(most_missed, result.missed[j]);
      most_asked = std::max(most_asked, joint.order);
      component.orders[joint.seam] = joint.order;
      double& effort = component.effort[joint.seam];
      for (const auto& [s, weight] : component.weights[joint.seam])
        effort = std::max(effort, weight);
    }
  if (most_missed > 1) {
    double limit_mm = std::numeric_limits<double>::infinity();
    for (const auto& [face, mover] : component.movers)
      if (std::isfinite(mover.restraint_mm)) limit_mm = std::min(limit_mm, task.limits_mm.at(face));
    component.failures = failuresOf(part, result.missed, most_asked > 1, limit_mm);
  }
  component.diverged = most_missed > far;
  for (const auto& [face, mover] : component.movers) {
    if (mover.displacement.coefficients().isZero(0)) continue;
    const Displacement::Moved moved = mover.displacement.moved();
    component.changes.push_back({face, handle<Geom_Surface>(moved.surface), moved.largest_move_mm});
  }
  component.paths = slidPaths(part, task, component.changes);
  return component;
}

/// The result for a part whose solution failed. The other parts continue without it.
FairComponent failed(const Part& part, std::string key, const RepairReason& why) {
  FairComponent component;
  component.asked = std::move(key);
  component.diverged = true;
  for (const Joint& joint : part.joints)
    if (joint.ask == Ask::Join) {
      component.orders[joint.seam] = joint.order;
      component.effort[joint.seam] = 0;
      component.failures[joint.seam] = why;
    }
  return component;
}

}  // namespace

std::vector<FairComponent> displaceFaces(const RepairTask& task, const std::vector<Coedge>& open,
                                         const MissedParameters& missed,
                                         const Restraints& restraints,
                                         const std::vector<FairComponent>& before,
                                         const Progress& progress) {
  const TaskFaces faces(task);
  const std::set<int> moving = facesToMove(task);
  const std::vector<Part> parts =
      connectedParts(moving, jointsOf(task, open, moving, missed, restraints), faces.count());
  std::vector<FairComponent> components(parts.size());
  std::atomic<bool> is_cancelled = false;
  const Progress goes_on = [&is_cancelled](double) { return !is_cancelled; };
  const auto solve = [&](std::size_t k) {
    std::string key = keyOf(parts[k], restraints);
    const auto known = std::ranges::find(before, key, &FairComponent::asked);
    if (known != before.end()) {
      components[k] = *known;
      return;
    }
    try {
      components[k] = solved(task, parts[k], key, faces, before, restraints, goes_on);
    } catch (const Standard_Failure& failure) {
      components[k] = failed(parts[k], std::move(key), why::failed(failure));
    }
  };
  runParallel(parts.size(), task.options.jobs, solve, [&](double share) {
    if (progress && !progress(share)) is_cancelled = true;
    return !is_cancelled;
  });
  return components;
}

}  // namespace seamwright::occ
