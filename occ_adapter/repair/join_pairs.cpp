// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/match/candidate.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

namespace seamwright::occ {

namespace {

FaceMatchOptions matchOptions(const RepairOptions& options) {
  FaceMatchOptions match;
  match.order = options.order;
  match.max_move_mm = options.max_move_mm;
  match.match_mm = options.match_mm;
  match.tolerance = options.tolerance;
  return match;
}

/// Joins one pair of faces after the other, each in the shape as the ones before left it.
class PairSolver {
 public:
  PairSolver(const RepairTask& task, JoinedPairs& known, const Progress& progress)
      : task_(task), known_(known), progress_(progress), shape_(task.shape), seams_(task.seams) {}

  RepairSolution run() {
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < task_.treated.size(); ++i)
      if (task_.treated[i]) waiting.push_back(i);
    const auto all = static_cast<double>(waiting.size());
    while (!waiting.empty()) {
      const double done = 1 - static_cast<double>(waiting.size()) / all;
      const std::vector<std::size_t> next = takeIndependent(waiting);
      attempt(next, partOf(progress_, done, 1 - static_cast<double>(waiting.size()) / all));
    }
    for (const auto& [face, change] : changes_) solution_.changes.push_back(change);
    return std::move(solution_);
  }

 private:
  /// Seams that have no face in common with one another or with one that waits before them: what comes of them does not depend on
  /// their order.
  std::vector<std::size_t> takeIndependent(std::vector<std::size_t>& waiting) const {
    std::set<int> faces;
    std::vector<std::size_t> independent;
    std::erase_if(waiting, [&](std::size_t i) {
      bool is_first = true;
      for (const FaceUse& side : task_.seams[i].sides) is_first = is_first && faces.count(side.face) == 0;
      for (const FaceUse& side : task_.seams[i].sides) faces.insert(side.face);
      if (is_first) independent.push_back(i);
      return is_first;
    });
    return independent;
  }

  std::array<std::size_t, 3> asked(std::size_t i) {
    const auto& sides = task_.seams[i].sides;
    return {i, state_[sides[0].face], state_[sides[1].face]};
  }

  void attempt(const std::vector<std::size_t>& independent, const Progress& progress) {
    std::vector<std::size_t> unknown;
    for (const std::size_t i : independent)
      if (known_.count(asked(i)) == 0) unknown.push_back(i);
    std::vector<JoinedPair> pairs(unknown.size());
    for (std::size_t k = 0; k < unknown.size(); ++k)
      pairs[k].why_not = reasonOf([&] { return bringUpToDate(unknown[k]); });
    // Nothing that others read is changed.
    const auto tryToJoin = [&](std::size_t k) {
      JoinedPair& pair = pairs[k];
      if (pair.why_not.empty()) pair.why_not = reasonOf([&] { return join(unknown[k], pair.changes); });
    };
    runParallel(unknown.size(), task_.options.jobs, tryToJoin, progress);
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      pairs[k].state = known_.size() + 1;
      known_[asked(unknown[k])] = std::move(pairs[k]);
    }
    for (const std::size_t i : independent) {
      const JoinedPair& pair = known_.at(asked(i));
      if (pair.why_not.empty())
        accept(pair);
      else
        solution_.failures[i] = pair.why_not;
    }
  }

  /// What the work returns, or throws.
  template <class Work>
  static std::string reasonOf(const Work& work) {
    try {
      return work();
    } catch (const Standard_Failure& failure) {
      return std::string("OpenCASCADE failed: ") + failure.DynamicType()->Name() + " " +
             failure.GetMessageString();
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  /// The shape as the pairs before left it, if they changed a face of the seam.
  std::string bringUpToDate(std::size_t i) {
    const bool is_changed = std::ranges::any_of(
        task_.seams[i].sides, [this](const FaceUse& side) { return changed_since_.count(side.face) > 0; });
    if (!is_changed) return {};
    std::vector<FaceChange> changes;
    for (const auto& [face, change] : changed_since_) changes.push_back(change);
    shape_ = withChanges(shape_, changes, task_.options.tolerance.gap_mm);
    seams_ = seamsIn(shape_, seams_);
    changed_since_.clear();
    return {};
  }

  std::string join(std::size_t i, std::vector<FaceChange>& changes) const {
    if (task_.sharp[i]) return "it is sharp";
    const Seam& seam = seams_[i];
    if (seam.sides[0].face == seam.sides[1].face) return "the face meets itself there, which is not handled";
    PairToMatch pair;
    pair.options = matchOptions(task_.options);
    std::array<bool, 2> can_move{};
    std::string why;
    for (const int which : {0, 1}) {
      const int number = seam.sides[which].face;
      pair.sides[which] = matchSide(seam.sides[which].shape, seam.sides[which], pair.options);
      can_move[which] = pair.sides[which].isNatural() && task_.faces[number].may_move;
      if (can_move[which]) continue;
      why += (why.empty() ? "face " : "; face ") + std::to_string(number) + " " +
             (task_.faces[number].may_move ? pair.sides[which].cannot_move : task_.faces[number].cannot_move);
    }
    if (!can_move[0] && !can_move[1]) return why;
    pair.options.hold_sides = hasNeighboursAtEnds(i);
    why.clear();
    for (const std::array<bool, 2> moves :
         {std::array{true, true}, std::array{false, true}, std::array{true, false}}) {
      if ((moves[0] && !can_move[0]) || (moves[1] && !can_move[1])) continue;
      const Candidate candidate = joined(pair, moves);
      if (candidate.failure.empty() && candidate.largest_move_mm <= task_.options.max_move_mm) {
        changes = changesOf(seam, candidate);
        return {};
      }
      if (!why.empty()) continue;
      std::ostringstream text;
      if (candidate.failure.empty())
        text << "it needs a move of " << candidate.largest_move_mm << " mm, more than "
             << task_.options.max_move_mm << " mm";
      else
        text << candidate.failure;
      why = text.str();
    }
    return why;
  }

  /// Another seam ends where this one does.
  bool hasNeighboursAtEnds(std::size_t i) const {
    TopTools_IndexedMapOfShape ends;
    TopExp::MapShapes(seams_[i].sides[0].edge, TopAbs_VERTEX, ends);
    TopExp::MapShapes(seams_[i].sides[1].edge, TopAbs_VERTEX, ends);
    for (std::size_t other = 0; other < seams_.size(); ++other) {
      if (other == i) continue;
      for (const FaceUse& side : seams_[other].sides)
        if (ends.Contains(TopExp::FirstVertex(side.edge)) || ends.Contains(TopExp::LastVertex(side.edge)))
          return true;
    }
    return false;
  }

  static Candidate joined(PairToMatch& pair, const std::array<bool, 2>& moves) {
    pair.moves = moves;
    pair.driver = moves[1] ? 1 : 0;
    pair.path = followedPath(EdgeRows(pair.sides[pair.driver].spline, pair.sides[pair.driver].edge),
                             pair.other(), pair.options);
    Candidate candidate;
    candidate.failure = pair.path.failure;
    if (pair.other().isNatural()) candidate = joinInPoles(pair);
    constexpr double share = 0.5;
    const bool can_follow = !(moves[0] && moves[1]) && pair.path.failure.empty();
    const bool may_follow =
        !candidate.failure.empty() || candidate.largest_move_mm > pair.options.max_move_mm;
    if (!can_follow || !(may_follow || !pair.other().isNatural())) return candidate;
    Candidate follower = joinToTolerance(pair, share);
    return follower.failure.empty() || candidate.failure.empty() ? follower : candidate;
  }

  static std::vector<FaceChange> changesOf(const Seam& seam, const Candidate& candidate) {
    std::vector<FaceChange> changes;
    for (const int which : {0, 1}) {
      const MovedSurface& moved = candidate.moved[which];
      if (!moved.after.IsNull())
        changes.push_back(
            {seam.sides[which].face, opencascade::handle<Geom_Surface>(moved.after), moved.largest_move_mm});
    }
    return changes;
  }

  void accept(const JoinedPair& pair) {
    for (const FaceChange& step : pair.changes) {
      FaceChange& sum = changes_[step.face];
      sum = {step.face, step.surface, sum.largest_move_mm + step.largest_move_mm};
      changed_since_[step.face] = step;
      state_[step.face] = pair.state;
    }
  }

  const RepairTask& task_;
  JoinedPairs& known_;
  const Progress& progress_;
  TopoDS_Shape shape_;
  std::vector<Seam> seams_;                  ///< of that shape
  std::map<int, FaceChange> changes_;        ///< by face, all since the task's shape
  std::map<int, FaceChange> changed_since_;  ///< by face, since shape_
  std::map<int, std::size_t> state_;         ///< of a face: the pair that left it so; 0: as in the task
  RepairSolution solution_;
};

}  // namespace

RepairSolution joinPairs(const RepairTask& task, JoinedPairs& known, const Progress& progress) {
  return PairSolver(task, known, progress).run();
}

}  // namespace seamwright::occ
