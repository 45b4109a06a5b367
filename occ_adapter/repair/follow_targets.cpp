// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/repair/seam_target.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

enum class Role {
  Held,     ///< each side keeps what it shows
  Carried,  ///< both sides may move together
  Treated
};

/// What of a seam has to stay: its place, its tangent plane, its curvature.
int orderToKeep(const SeamResult& seam, const ContinuityTolerance& tolerance) {
  if (seam.verdict.seam_class == SeamClass::Crease) return 0;
  return seam.verdict.level >= Level::G2 && !anyCurvatureDoes(tolerance) ? 2 : 1;
}

handle<Geom_BSplineSurface> splineOf(const TopoDS_Face& face) {
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
  const auto spline = handle<Geom_BSplineSurface>::DownCast(surface);
  const bool periodic = !spline.IsNull() && (spline->IsUPeriodic() || spline->IsVPeriodic());
  if (!periodic) return clampedSpline(surface, location);
  return handle<Geom_BSplineSurface>::DownCast(spline->Transformed(location.Transformation()));
}

class Following {
 public:
  Following(const RepairTask& task, LeadReach reach, FollowedFaces& known, const Progress& progress)
      : task_(task), reach_(reach), known_(known), progress_(progress), pcurves_(task.seams.size()) {
    for (const bool treated : task.treated) roles_.push_back(treated ? Role::Treated : Role::Held);
  }

  RepairSolution run() {
    constexpr int most_passes = 8;
    for (int pass = 0; pass < most_passes; ++pass) {
      findMoving();
      makeTargets();
      if (!agreeAtVertices()) break;
    }
    if (solution_.failures.empty()) followAll();
    solution_.complete = solution_.failures.empty();
    if (!solution_.complete) solution_.changes.clear();
    return std::move(solution_);
  }

 private:
  bool isActive(std::size_t seam) const { return roles_[seam] != Role::Held; }
  bool moves(int face) const { return moving_.count(face) > 0; }
  int orderOf(std::size_t seam) const {
    if (roles_[seam] != Role::Treated) return orderToKeep(task_.before[seam], task_.options.tolerance);
    return task_.sharp[seam] ? 0 : task_.options.order;
  }

  void findMoving() {
    moving_.clear();
    for (std::size_t i = 0; i < roles_.size(); ++i)
      for (const FaceUse& side : task_.seams[i].sides)
        if (isActive(i) && task_.faces[side.face].may_move) moving_.insert(side.face);
  }

  const std::array<Pcurve, 2>& pcurvesOf(std::size_t seam) {
    for (const int side : {0, 1}) {
      const FaceUse& use = task_.seams[seam].sides[side];
      if (pcurves_[seam][side].curve.IsNull())
        pcurves_[seam][side] = pcurveOf(use.edge, use.shape, task_.options.tolerance.gap_mm);
    }
    return pcurves_[seam];
  }

  /// Also of order 1 with the curvature of its ends: where two seams of a face meet, the normals along one have to turn as the other one
  /// wants it, which a common tensor gives.
  std::shared_ptr<SeamTarget> target(std::size_t seam, const std::array<bool, 2>& stays) {
    const int order = orderOf(seam) == 0 ? 0 : 2;
    std::shared_ptr<SeamTarget>& made = made_[{seam, stays, order}];
    if (made)
      made->forgetEnds();
    else
      made = std::make_shared<SeamTarget>(task_.seams[seam], pcurvesOf(seam), stays, order, reach_);
    return made;
  }

  /// As far as it makes a difference.
  static const char* reachOf(const std::shared_ptr<SeamTarget>& target) {
    return target && target->isLedBriefly() ? "briefly " : "";
  }

  /// A side of a seam, which follows the target.
  struct PathOfSeam {
    std::size_t seam = 0;
    std::shared_ptr<SeamTarget> target;
    int side = 0;
  };

  void makeTargets() {
    targets_.clear();
    paths_.clear();
    seam_of_.clear();
    asked_.clear();
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      const auto& sides = task_.seams[i].sides;
      if (!moves(sides[0].face) && !moves(sides[1].face)) continue;
      std::shared_ptr<SeamTarget> common;
      if (isActive(i)) {
        common = target(i, {!moves(sides[0].face), !moves(sides[1].face)});
        targets_.push_back(common);
        seam_of_[common.get()] = i;
      }
      std::ostringstream asked;
      asked << i << (common ? " common " : " own ") << reachOf(common) << orderOf(i) << moves(sides[0].face)
            << moves(sides[1].face) << ';';
      asked_[i] = asked.str();
      for (const int side : {0, 1})
        if (moves(sides[side].face))
          paths_[sides[side].face].push_back({i, common ? common : target(i, {side == 0, side == 1}), side});
    }
  }

  static TopTools_IndexedMapOfShape verticesOf(const std::vector<TargetEnd>& ends) {
    TopTools_IndexedMapOfShape vertices;
    for (const TargetEnd& end : ends)
      for (const FaceUse& side : end.target->seam().sides) {
        const TopoDS_Edge edge = TopoDS::Edge(side.edge.Oriented(TopAbs_FORWARD));
        vertices.Add(end.end == 0 ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge));
      }
    return vertices;
  }

  std::vector<std::size_t> heldAt(const TopTools_IndexedMapOfShape& vertices) const {
    std::vector<std::size_t> held;
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      if (isActive(i)) continue;
      bool ends_here = false;
      for (const FaceUse& side : task_.seams[i].sides)
        ends_here = ends_here || vertices.Contains(TopExp::FirstVertex(side.edge)) ||
                    vertices.Contains(TopExp::LastVertex(side.edge));
      if (ends_here) held.push_back(i);
    }
    return held;
  }

  /// \returns whether seams were carried or given up because vertices ask for it; then once more.
  bool agreeAtVertices() {
    ContinuityTolerance tolerance = task_.options.tolerance;
    if (task_.options.order < 2) tolerance.curvature_rel = std::numeric_limits<double>::infinity();
    bool again = false;
    for (std::vector<TargetEnd>& ends : meetingEnds(targets_)) {
      for (TargetEnd& end : ends) end.order = orderOf(seam_of_.at(end.target.get()));
      const std::vector<std::size_t> held_seams = heldAt(verticesOf(ends));
      std::map<int, int> held;
      for (const std::size_t i : held_seams)
        for (const FaceUse& side : task_.seams[i].sides)
          if (moves(side.face)) {
            const auto there = held.emplace(side.face, -1).first;
            there->second = std::max(there->second, orderOf(i));
          }
      noteAsked(ends, held);
      const std::string contradiction = agreeAtVertex(ends, held, tolerance);
      if (contradiction.empty()) continue;
      if (carry(held_seams))
        again = true;
      else
        fail(ends, contradiction);
    }
    return again;
  }

  void noteAsked(const std::vector<TargetEnd>& ends, const std::map<int, int>& held) {
    std::ostringstream asked;
    for (const TargetEnd& end : ends)
      asked << seam_of_.at(end.target.get()) << ' ' << end.end << ' ' << reachOf(end.target);
    for (const auto& [face, order] : held) asked << "held " << face << ' ' << order << ' ';
    for (const TargetEnd& end : ends) asked_[seam_of_.at(end.target.get())] += asked.str() + ';';
  }

  /// Seams that can't be kept where they are but as smooth as they are. \returns whether there are any.
  bool carry(const std::vector<std::size_t>& held) {
    bool any = false;
    for (const std::size_t i : held) {
      const auto& sides = task_.seams[i].sides;
      const bool can = task_.faces[sides[0].face].may_move || task_.faces[sides[1].face].may_move;
      if (!can || task_.before[i].verdict.seam_class == SeamClass::Defect) continue;
      roles_[i] = Role::Carried;
      any = true;
    }
    return any;
  }

  void fail(const std::vector<TargetEnd>& ends, const std::string& why) {
    for (const TargetEnd& end : ends) {
      const std::size_t i = seam_of_.at(end.target.get());
      if (roles_[i] == Role::Treated) solution_.failures[i] = why;
    }
  }

  /// A face that has not followed all this before.
  struct NewFace {
    int number = 0;
    std::string asked;
    int poles = 0;
    FaceFollow follow;
    std::exception_ptr error;
  };

  void followAll() {
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(task_.shape, TopAbs_FACE, shapes);
    std::vector<NewFace> faces;
    for (const auto& [number, paths] : paths_)
      if (std::string asked = askedOf(number); known_.count(asked) == 0) {
        const auto surface = splineOf(TopoDS::Face(shapes(number)));
        faces.push_back({number, std::move(asked), surface->NbUPoles() * surface->NbVPoles(), {}, {}});
      }
    // The longest work first, so that no thread is left alone with it.
    std::ranges::stable_sort(faces, std::greater{}, &NewFace::poles);
    std::atomic<bool> cancelled = false;
    const auto work = [&](std::size_t k) {
      NewFace& face = faces[k];
      try {
        face.follow = follow(face.number, TopoDS::Face(shapes(face.number)), cancelled);
      } catch (...) {
        face.error = std::current_exception();
      }
    };
    const Progress watched = [&](double share) {
      cancelled = progress_ && !progress_(share);
      return !cancelled;
    };
    runParallel(faces.size(), task_.options.jobs, work, watched);
    for (NewFace& face : faces) {
      if (face.error) std::rethrow_exception(face.error);
      known_[face.asked] = std::move(face.follow);
    }
    for (const auto& [number, paths] : paths_) take(number, known_.at(askedOf(number)));
  }

  std::string askedOf(int face) const {
    std::string asked = std::to_string(face) + ":";
    for (const PathOfSeam& path : paths_.at(face)) asked += asked_.at(path.seam);
    return asked;
  }

  /// On a thread of its own: nothing that others read is evaluated.
  FaceFollow follow(int number, const TopoDS_Face& face, const std::atomic<bool>& cancelled) const {
    FaceTask task;
    task.surface = splineOf(face);
    task.tolerance = task_.options.tolerance;
    task.max_move_mm = task_.options.max_move_mm;
    task.is_cancelled = [&cancelled] { return cancelled.load(); };
    for (const PathOfSeam& path : paths_.at(number)) {
      const auto target = std::make_shared<const SeamTarget>(path.target->renewed());
      task.paths.push_back(followPath(target, path.side, orderOf(path.seam)));
      task.paths.back().name = "edge " + std::to_string(task_.before[path.seam].edges.front());
    }
    return followPaths(task);
  }

  void take(int number, const FaceFollow& follow) {
    const std::vector<PathOfSeam>& paths = paths_.at(number);
    for (std::size_t k = 0; k < paths.size(); ++k)
      if (follow.missed[k] && roles_[paths[k].seam] == Role::Treated)
        solution_.failures[paths[k].seam] = "face " + std::to_string(number) + ": " + follow.failure;
    if (follow.largest_move_mm > 0)
      solution_.changes.push_back({number, handle<Geom_Surface>(follow.surface), follow.largest_move_mm});
  }

  const RepairTask& task_;
  LeadReach reach_;
  FollowedFaces& known_;
  const Progress& progress_;
  std::vector<std::array<Pcurve, 2>> pcurves_;
  std::vector<Role> roles_;  ///< by seam
  std::set<int> moving_;     ///< faces
  std::map<std::tuple<std::size_t, std::array<bool, 2>, int>, std::shared_ptr<SeamTarget>>
      made_;  ///< in this and earlier passes, by seam, sides that stay and order
  std::vector<std::shared_ptr<SeamTarget>> targets_;
  std::map<const SeamTarget*, std::size_t> seam_of_;
  std::map<int, std::vector<PathOfSeam>> paths_;  ///< by face that moves
  std::map<std::size_t, std::string> asked_;      ///< by seam: all that its target depends on
  RepairSolution solution_;
};

}  // namespace

RepairSolution followTargets(const RepairTask& task, LeadReach reach, FollowedFaces& known,
                             const Progress& progress) {
  return Following(task, reach, known, progress).run();
}

}  // namespace seamwright::occ
