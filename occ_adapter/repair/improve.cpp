// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/repair/displace.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/improve.hpp>
#include <seamwright/occ_adapter/repair/passed_faces.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// Number of rounds in which single seams of a component at fault are excluded. Each further round
/// excludes half of its remaining seams, which bounds the number of rounds.
constexpr int single_rounds = 12;
/// How often a seam is tried again with more samples where it missed.
constexpr int most_looks = 3;

/// A task while seams of it are excluded.
class Rounds {
 public:
  explicit Rounds(RepairTask task) : task_(std::move(task)) {}

  const RepairTask& task() const { return task_; }
  bool isOver() const { return !task_.treatsAny(); }
  const TopoDS_Shape& changed() const { return changed_; }

  /// Excludes seams. A seam with target G2 that lacks G1 gets target G1 first.
  void exclude(const Reasons& seams) {
    for (const auto& [i, why] : seams) {
      if (!task_.isTreated(i)) continue;
      const bool has_g1 =
          isRepaired(task_.before[i], task_.sharp[i], task_.options.tolerance, Level::G1);
      task_.orders[i] = task_.orders[i] == 2 && !has_g1 && !task_.sharp[i] ? 1 : 0;
      const bool lost_g2 = reasons_.count(i) > 0 && task_.options.order > 1;
      (lost_g2 ? g1_reasons_ : reasons_)[i] = why;
    }
  }

  void excludeAll(const RepairReason& why) {
    for (std::size_t i = 0; i < task_.seams.size(); ++i)
      if (task_.isTreated(i)) reasons_[i] = why;
    std::ranges::fill(task_.orders, 0);
  }

  Proof proven(const std::vector<FaceChange>& changes, const std::vector<PathChange>& paths,
               const Progress& progress) {
    changed_ = withChanges(task_.shape, changes, task_.options.tolerance.gap_mm, paths,
                           task_.options.jobs);
    // New pcurves beside a moving face are determined by its surface, so measurements can be reused
    // by surface. Without moving faces the pcurves are independent: nothing is reused.
    MeasuredSeams of_paths_alone;
    return prove(task_, changes, changed_, changes.empty() ? of_paths_alone : measured_, progress);
  }

  Improvement kept(std::vector<FaceChange> changes, std::map<int, FaceMove> judged,
                   std::vector<PathChange> paths, Proof proof) const {
    return {changed_,
            std::move(changes),
            std::move(judged),
            std::move(paths),
            std::move(proof.after),
            task_.orders,
            reasons_,
            g1_reasons_};
  }

  Improvement nothing() const {
    return {task_.shape, {},         {}, {}, task_.before, std::vector<int>(task_.seams.size(), 0),
            reasons_,    g1_reasons_};
  }

 private:
  RepairTask task_;
  MeasuredSeams measured_;
  TopoDS_Shape changed_;
  Reasons reasons_, g1_reasons_;
};

bool touches(const Seam& seam, int face) {
  return seam.sides[0].face == face || seam.sides[1].face == face;
}

/// What is wrong with a solution.
struct Faults {
  std::map<int, RepairReason> too_far, unfair;  ///< by face
  Proof proof;

  bool any() const { return !too_far.empty() || !unfair.empty() || !proof.holds(); }
};

std::set<std::pair<int, int>> besideSeams(const RepairTask& task) {
  std::set<std::pair<int, int>> pairs;
  for (const Seam& seam : task.seams)
    pairs.insert(std::minmax(seam.sides[0].face, seam.sides[1].face));
  return pairs;
}

/// What the next solution does differently from the last one.
class NextTry {
 public:
  /// \param task is kept by reference.
  explicit NextTry(const RepairTask& task) : task_(task) {}

  const MissedParameters& missed() const { return missed_; }
  const Restraints& restraints() const { return restraints_; }

  /// Adds samples to the next solution where a figure is largest, as long as such samples help.
  bool looksAgain(std::size_t i, const SeamResult& seam) {
    // More samples help if they reduce the miss by at least a tenth.
    constexpr double is_less = 0.9;
    Look& look = looks_[i];
    const double missed = missedBy(seam);
    if (++look.count > most_looks || !(missed < is_less * look.missed)) return false;
    look.missed = missed;
    for (const auto* figure :
         {&seam.figures.gap_mm, &seam.figures.angle_rad, &seam.figures.curvature_rel})
      if (*figure) missed_[i].insert((*figure)->at);
    return true;
  }

  /// Makes a face stiffer in the next solution.
  bool stiffens(int face) {
    // Two attempts, see docs/theory/repair.md, "Rounds".
    constexpr double factor = 2, most = 4;
    double& stiffness = restraints_[face].stiffness;
    if (stiffness >= most) return false;
    stiffness *= factor;
    return true;
  }

  /// Forbids edges to slide, in the next solution, on the faces around the moving faces beside this
  /// one.
  bool keepsEdges(int face, const std::vector<FairComponent>& components) {
    bool any = false;
    for (const FairComponent& component : components) {
      const bool is_beside = std::ranges::any_of(task_.seams, [&](const Seam& seam) {
        return touches(seam, face) && (component.movers.count(seam.sides[0].face) > 0 ||
                                       component.movers.count(seam.sides[1].face) > 0);
      });
      if (!is_beside) continue;
      for (const PathChange& path : component.paths)
        if (bool& keeps_edges = restraints_[path.face].keeps_edges; !keeps_edges)
          any = keeps_edges = true;
    }
    return any;
  }

  /// Makes a face move less in the next solution, at the cost of more bending.
  bool restrains(int face) {
    // The first time the allowed move costs the budget, then half of it, down to a sixteenth
    // (docs/theory/repair.md, "Rounds").
    constexpr double factor = 0.5, least = 0.1;
    const double limit_mm = task_.limits_mm.at(face);
    double& move_mm = restraints_[face].move_mm;
    if (!(limit_mm > 0) || move_mm <= least * limit_mm) return false;
    move_mm = std::min(limit_mm, factor * move_mm);
    return true;
  }

 private:
  /// The largest ratio of a figure to its tolerance.
  double missedBy(const SeamResult& seam) const {
    const ContinuityTolerance& tolerance = task_.options.tolerance;
    const auto share = [](const std::optional<Figure>& figure, double limit) {
      return figure ? figure->lower / limit : std::numeric_limits<double>::infinity();
    };
    const double g1 = std::max(share(seam.figures.gap_mm, tolerance.gap_mm),
                               share(seam.figures.angle_rad, tolerance.angle_rad));
    return task_.options.order == 1
               ? g1
               : std::max(g1, share(seam.figures.curvature_rel, tolerance.curvature_rel));
  }

  const RepairTask& task_;
  MissedParameters missed_;
  Restraints restraints_;
  /// How often a seam got more samples, and its miss the last time.
  struct Look {
    int count = 0;
    double missed = std::numeric_limits<double>::max();
  };
  std::map<std::size_t, Look> looks_;  ///< by seam
};

/// The treated seams of a face. For a face without any, since it stays, those of the faces beside
/// it.
std::vector<std::size_t> treatedAt(const RepairTask& task, int face) {
  std::set<int> faces = {face};
  const auto seamsOf = [&] {
    std::vector<std::size_t> seams;
    for (std::size_t i = 0; i < task.seams.size(); ++i)
      if (task.isTreated(i) &&
          std::ranges::any_of(faces, [&](int one) { return touches(task.seams[i], one); }))
        seams.push_back(i);
    return seams;
  };
  std::vector<std::size_t> own = seamsOf();
  if (!own.empty()) return own;
  for (const Seam& seam : task.seams)
    if (touches(seam, face)) faces.insert({seam.sides[0].face, seam.sides[1].face});
  return seamsOf();
}

/// The treated seams that move with the face and have the highest target. Seams with target G2 are
/// blamed before those with G1, because the curvature condition is the stronger one.
std::vector<std::size_t> mostAskedAt(const RepairTask& task,
                                     const std::vector<FairComponent>& components, int face) {
  std::vector<std::size_t> seams = treatedAt(task, face);
  int most = 0;
  for (const FairComponent& component : components)
    if (component.movers.count(face) > 0)
      for (const auto& [i, order] : component.orders) most = std::max(most, task.orders[i]);
  std::erase_if(seams, [&](std::size_t i) { return task.orders[i] < most; });
  if (!seams.empty()) return seams;
  for (const FairComponent& component : components)
    if (component.movers.count(face) > 0)
      for (const auto& [i, order] : component.orders)
        if (task.orders[i] == most) seams.push_back(i);
  return seams;
}

/// The solver's effort for a seam.
double effortOf(const std::vector<FairComponent>& components, std::size_t seam) {
  for (const FairComponent& component : components)
    if (const auto effort = component.effort.find(seam); effort != component.effort.end())
      return effort->second;
  return 0;
}

/// Excludes the seam of a face at fault that took most effort.
void excludeAt(const RepairTask& task, const std::vector<FairComponent>& components, int face,
               const RepairReason& why, Reasons& seams) {
  const std::vector<std::size_t> treated = mostAskedAt(task, components, face);
  const auto effort = [&components](std::size_t i) { return effortOf(components, i); };
  if (!treated.empty()) seams.emplace(*std::ranges::max_element(treated, {}, effort), why);
}

class Moving {
 public:
  explicit Moving(const RepairTask& task)
      : rounds_(task),
        next_(rounds_.task()),
        open_(findSeams(task.shape).open_uses),
        passed_(task.given, besideSeams(task), task.options.tolerance.gap_mm) {
    TopExp::MapShapes(task.given, TopAbs_FACE, faces_);
  }

  Improvement run(const Progress& progress) {
    double done = 0;
    while (!rounds_.isOver()) {
      if (progress && !progress(done)) throw Cancelled();
      const double next = done + (1 - done) / 3;
      const Progress solving = partOf(progress, done, (done + next) / 2),
                     proving = partOf(progress, (done + next) / 2, next);
      done = next;
      components_ = displaceFaces(rounds_.task(), open_, next_.missed(), next_.restraints(),
                                  components_, solving);
      std::vector<FaceChange> changes;
      std::vector<PathChange> paths;
      Reasons failures;
      for (const FairComponent& component : components_) {
        failures.insert(component.failures.begin(), component.failures.end());
        changes.insert(changes.end(), component.changes.begin(), component.changes.end());
        paths.insert(paths.end(), component.paths.begin(), component.paths.end());
      }
      if (!failures.empty()) {
        for (const FairComponent& component : components_)
          if (!component.failures.empty())
            addAge(component, component.failures.begin()->second, failures);
        rounds_.exclude(failures);
        continue;
      }
      if (changes.empty() && paths.empty()) break;
      Faults faults = faultsOf(changes, paths, proving);
      if (!faults.any()) {
        std::map<int, FaceMove> judged = judgedFaces(changes);
        return rounds_.kept(std::move(changes), std::move(judged), std::move(paths),
                            std::move(faults.proof));
      }
      rounds_.exclude(whatToExclude(faults));
    }
    rounds_.excludeAll(why::nothingProven(true));
    return rounds_.nothing();
  }

 private:
  const RepairTask& task() const { return rounds_.task(); }

  Faults faultsOf(const std::vector<FaceChange>& changes, const std::vector<PathChange>& paths,
                  const Progress& progress) {
    Faults faults;
    judgeFairness(changes, partOf(progress, 0, 0.5));
    for (const FaceChange& change : changes) {
      const auto before = task().moved_mm.find(change.face);
      const double move_mm =
          change.largest_move_mm + (before == task().moved_mm.end() ? 0 : before->second);
      if (const double limit_mm = task().limits_mm.at(change.face); move_mm > limit_mm) {
        faults.too_far[change.face] = why::movesTooFar(move_mm, limit_mm);
      } else if (const RepairReason& less_fair = judged_.at(change.surface).less_fair;
                 !less_fair.empty()) {
        faults.unfair[change.face] = why::wouldBe(less_fair);
      }
    }
    faults.proof = rounds_.proven(changes, paths, partOf(progress, 0.5, 1));
    if (!faults.any()) faults.too_far = throughOthers(changes);
    return faults;
  }

  std::map<int, RepairReason> throughOthers(const std::vector<FaceChange>& changes) {
    std::set<int> moved;
    for (const FaceChange& change : changes) moved.insert(change.face);
    std::map<int, RepairReason> through;
    for (const auto& [face, other] : passed_.in(rounds_.changed(), moved))
      through[face] = why::passesThrough(other);
    return through;
  }

  std::map<int, FaceMove> judgedFaces(const std::vector<FaceChange>& changes) const {
    std::map<int, FaceMove> judged;
    for (const FaceChange& change : changes)
      judged.emplace(change.face, judged_.at(change.surface));
    return judged;
  }

  /// Judges the surfaces that were not judged before.
  void judgeFairness(const std::vector<FaceChange>& changes, const Progress& progress) {
    std::vector<const FaceChange*> unknown;
    for (const FaceChange& change : changes)
      if (judged_.count(change.surface) == 0) unknown.push_back(&change);
    std::vector<FaceMove> moves(unknown.size());
    const auto judge = [&](std::size_t k) {
      const FaceChange& change = *unknown[k];
      const TopoDS_Face& face = TopoDS::Face(faces_(change.face));
      const auto spline = handle<Geom_BSplineSurface>::DownCast(change.surface);
      try {
        moves[k] = judgedMove(change.face, face, spline, change.largest_move_mm, task().options,
                              task().needed);
      } catch (const Standard_Failure& failure) {
        moves[k].less_fair = why::failed(failure);
      }
    };
    runParallel(unknown.size(), task().options.jobs, judge, progress);
    for (std::size_t k = 0; k < unknown.size(); ++k)
      judged_[unknown[k]->surface] = std::move(moves[k]);
  }

  /// The seams to exclude: for each face at fault the seam that took most effort, and after many
  /// rounds half of the component's seams (addAge()).
  Reasons whatToExclude(const Faults& faults) {
    Reasons seams;
    std::map<int, RepairReason> at_fault;  // by face
    bool tries_again = false;
    const auto addSides = [&](std::size_t i, const RepairReason& why) {
      for (const Coedge& side : task().seams[i].sides) at_fault.emplace(side.face, why);
    };
    for (const auto& [i, why] : faults.proof.unrepaired) {
      addSides(i, why);
      if (next_.looksAgain(i, faults.proof.after[i]))
        tries_again = true;
      else
        seams[i] = why;
    }
    for (const auto& [i, why] : faults.proof.worse) {
      addSides(i, why);
      if (next_.looksAgain(i, faults.proof.after[i]))
        tries_again = true;
      else
        for (const Coedge& side : task().seams[i].sides)
          excludeAt(task(), components_, side.face, why, seams);
    }
    for (const auto& [face, reason] : faults.unfair) {
      at_fault.emplace(face, reason);
      if (next_.stiffens(face))
        tries_again = true;
      else
        excludeAt(task(), components_, face, why::onFace(face, reason), seams);
    }
    for (const auto& [face, reason] : faults.too_far) {
      at_fault.emplace(face, reason);
      if (next_.restrains(face))
        tries_again = true;
      else
        excludeAt(task(), components_, face, why::onFace(face, reason), seams);
    }
    for (const auto& [face, reason] : faults.proof.faces) {
      at_fault.emplace(face, reason);
      if (next_.keepsEdges(face, components_))
        tries_again = true;
      else
        excludeAt(task(), components_, face, why::onFace(face, reason), seams);
    }
    for (const FairComponent& component : components_)
      for (const auto& [face, why] : at_fault)
        if (component.movers.count(face) > 0) {
          addAge(component, why, seams);
          break;
        }
    if (seams.empty() && !tries_again)
      for (std::size_t i = 0; i < task().seams.size(); ++i)
        if (task().isTreated(i))
          seams[i] = faults.proof.whole.empty() ? why::nothingProven(false) : faults.proof.whole;
    return seams;
  }

  /// Excludes seams of a component that was at fault in many rounds: of the seams with the highest
  /// target the half that took more effort.
  void addAge(const FairComponent& component, const RepairReason& why, Reasons& seams) {
    int age = 0, most = 0;
    for (const auto& [i, effort] : component.effort) {
      age = std::max(age, ++ages_[i]);
      most = std::max(most, task().orders[i]);
    }
    if (age < single_rounds) return;
    std::vector<std::size_t> asked;
    for (const auto& [i, effort] : component.effort)
      if (task().orders[i] == most) asked.push_back(i);
    std::ranges::stable_sort(asked, std::greater(),
                             [this](std::size_t i) { return effortOf(components_, i); });
    asked.resize((asked.size() + 1) / 2);
    for (const std::size_t i : asked) seams.emplace(i, why);
  }

  Rounds rounds_;
  NextTry next_;
  const std::vector<Coedge> open_;
  PassedFaces passed_;
  TopTools_IndexedMapOfShape faces_;  ///< as given
  std::vector<FairComponent> components_;
  std::map<std::size_t, int> ages_;  ///< by seam
  std::map<handle<Geom_Surface>, FaceMove> judged_;
};

/// Runs the work. What geometry can cause becomes the reason of all seams: a failure of
/// OpenCASCADE, and a curve or a surface that can't be evaluated (GeometryError,
/// std::domain_error). Other exceptions are faults of the program, and pass. \throws Cancelled.
template <class Work>
Improvement orNothing(const RepairTask& task, const Work& work) {
  Rounds none(task);
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    none.excludeAll(why::failed(failure));
  } catch (const std::domain_error& error) {
    none.excludeAll(why::failed(std::string(error.what())));
  } catch (const GeometryError& error) {
    none.excludeAll(why::failed(std::string(error.what())));
  }
  return none.nothing();
}

}  // namespace

namespace {

/// The new pcurves to exclude. Each belongs to a single edge, so a pcurve is excluded if it does
/// not repair its seam. Of the pcurves on a spoilt face, or beside a spoilt seam, the one that
/// moves its edge furthest is excluded.
Reasons pathsAtFault(const RepairTask& task, const std::vector<PathChange>& paths,
                     const Proof& proof) {
  Reasons at_fault = proof.unrepaired;
  const auto addAt = [&](int face, const RepairReason& reason) {
    std::optional<std::size_t> furthest;
    double most_mm = -1;
    for (std::size_t i = 0; i < task.seams.size(); ++i) {
      if (!task.isTreated(i) || !touches(task.seams[i], face)) continue;
      for (const PathChange& path : paths)
        if (path.edge == task.seams[i].edges.front() && path.largest_move_mm > most_mm) {
          furthest = i;
          most_mm = path.largest_move_mm;
        }
    }
    if (furthest) at_fault.emplace(*furthest, why::pathSpoils(reason));
  };
  for (const auto& [face, reason] : proof.faces) addAt(face, why::onFace(face, reason));
  for (const auto& [i, why] : proof.worse)
    for (const Coedge& side : task.seams[i].sides) addAt(side.face, why);
  return at_fault;
}

}  // namespace

Improvement improveByPaths(const RepairTask& task, const Progress& progress) {
  return orNothing(task, [&] {
    Rounds rounds(task);
    JoinedPaths joined = joinPaths(task, partOf(progress, 0, 0.5));
    rounds.exclude(joined.failures);
    while (!rounds.isOver()) {
      Proof proof = rounds.proven({}, joined.paths, partOf(progress, 0.5, 1));
      if (proof.holds()) return rounds.kept({}, {}, std::move(joined.paths), std::move(proof));
      const Reasons at_fault = pathsAtFault(rounds.task(), joined.paths, proof);
      if (at_fault.empty()) rounds.excludeAll(why::pathSpoils(proof.whole));
      rounds.exclude(at_fault);
      std::erase_if(joined.paths, [&](const PathChange& path) {
        return std::ranges::none_of(task.seams, [&](const Seam& seam) {
          return seam.edges.front() == path.edge &&
                 rounds.task().isTreated(static_cast<std::size_t>(&seam - task.seams.data()));
        });
      });
    }
    return rounds.nothing();
  });
}

Improvement improveByMoves(const RepairTask& task, const Progress& progress) {
  return orNothing(task, [&] { return Moving(task).run(progress); });
}

}  // namespace seamwright::occ
