// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <set>
#include <sstream>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/repair/displace.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/improve.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// Rounds in which single seams of a component at fault are given up, and those after them, which give up all seams of a face at fault; then all
/// of the component go.
constexpr int single_rounds = 12, face_rounds = 4;
/// ... and how often a seam is tried again with samples where it was missed.
constexpr int most_looks = 3;

std::string nameOf(int face) {
  return "face " + std::to_string(face);
}

/// A task while seams of it are given up.
class Rounds {
 public:
  Rounds(RepairTask task, const std::optional<Soundness>& was) : task_(std::move(task)), was_(was) {}

  const RepairTask& task() const { return task_; }
  bool isOver() const { return !task_.treatsAny(); }

  /// G2 first becomes G1, where that is wanting.
  void giveUp(const Reasons& seams) {
    for (const auto& [i, why] : seams) {
      if (!task_.isTreated(i)) continue;
      const bool has_g1 = isRepaired(task_.before[i], task_.sharp[i], task_.options.tolerance, Level::G1);
      task_.orders[i] = task_.orders[i] == 2 && !has_g1 && !task_.sharp[i] ? 1 : 0;
      std::string& reason = reasons_[i];
      reason = reason.empty() || task_.options.order == 1 ? why : reason + "; G1: " + why;
    }
  }

  void giveUpAll(const std::string& why) {
    for (std::size_t i = 0; i < task_.seams.size(); ++i)
      if (task_.isTreated(i)) reasons_[i] = why;
    std::ranges::fill(task_.orders, 0);
  }

  Proof proven(const std::vector<FaceChange>& changes, const std::vector<PathChange>& paths,
               const Progress& progress) {
    changed_ = withChanges(task_.shape, changes, task_.options.tolerance.gap_mm, paths, task_.options.jobs);
    MeasuredSeams of_paths;
    return prove(task_, changes, changed_, was_, paths.empty() ? measured_ : of_paths, progress);
  }

  Improvement kept(std::vector<FaceChange> changes, std::vector<PathChange> paths, Proof proof) const {
    return {changed_,     std::move(changes), std::move(paths),          std::move(proof.after),
            task_.orders, reasons_,           std::move(proof.soundness)};
  }

  Improvement nothing() const {
    return {task_.shape, {}, {}, task_.before, std::vector<int>(task_.seams.size(), 0), reasons_, was_};
  }

 private:
  RepairTask task_;
  std::optional<Soundness> was_;
  MeasuredSeams measured_;
  TopoDS_Shape changed_;
  Reasons reasons_;
};

bool touches(const Seam& seam, int face) {
  return seam.sides[0].face == face || seam.sides[1].face == face;
}

/// What is wrong with a way to move faces.
struct Faults {
  std::map<int, std::string> too_far, unfair;  ///< by face
  Proof proof;

  bool any() const { return !too_far.empty() || !unfair.empty() || !proof.holds(); }
};

class Moving {
 public:
  Moving(const RepairTask& task, const std::optional<Soundness>& was) : rounds_(task, was) {
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
      components_ = displaceFaces(rounds_.task(), missed_, restraints_, components_, solving);
      std::vector<FaceChange> changes;
      Reasons failures;
      for (const FairComponent& component : components_) {
        failures.insert(component.failures.begin(), component.failures.end());
        changes.insert(changes.end(), component.changes.begin(), component.changes.end());
      }
      if (!failures.empty()) {
        for (const FairComponent& component : components_)
          if (!component.failures.empty()) addAge(component, component.failures.begin()->second, failures);
        rounds_.giveUp(failures);
        continue;
      }
      if (changes.empty()) break;
      Faults faults = faultsOf(changes, proving);
      if (!faults.any()) return rounds_.kept(std::move(changes), {}, std::move(faults.proof));
      rounds_.giveUp(whatToGiveUp(faults));
    }
    rounds_.giveUpAll("no change of the faces beside it was proven");
    return rounds_.nothing();
  }

 private:
  const RepairTask& task() const { return rounds_.task(); }

  Faults faultsOf(const std::vector<FaceChange>& changes, const Progress& progress) {
    Faults faults;
    const double limit_mm = task().options.max_move_mm;
    judgeFairness(changes, partOf(progress, 0, 0.5));
    for (const FaceChange& change : changes) {
      const auto before = task().moved_mm.find(change.face);
      const double move_mm = change.largest_move_mm + (before == task().moved_mm.end() ? 0 : before->second);
      if (move_mm > limit_mm) {
        std::ostringstream text;
        text << "it would move by " << move_mm << " mm, more than " << limit_mm << " mm";
        faults.too_far[change.face] = text.str();
      } else if (const std::string& why = unfair_.at(change.surface); !why.empty()) {
        faults.unfair[change.face] = "it would be less fair: " + why;
      }
    }
    faults.proof = rounds_.proven(changes, {}, partOf(progress, 0.5, 1));
    return faults;
  }

  /// Of surfaces that were not judged before.
  void judgeFairness(const std::vector<FaceChange>& changes, const Progress& progress) {
    std::vector<const FaceChange*> unknown;
    for (const FaceChange& change : changes)
      if (unfair_.count(change.surface) == 0) unknown.push_back(&change);
    std::vector<std::string> whys(unknown.size());
    const auto judge = [&](std::size_t k) {
      const FaceChange& change = *unknown[k];
      const TopoDS_Face& face = TopoDS::Face(faces_(change.face));
      const auto spline = handle<Geom_BSplineSurface>::DownCast(change.surface);
      try {
        whys[k] = judgedMove(change.face, face, spline, change.largest_move_mm, task().options, task().needed)
                      .verdict.reason;
      } catch (const Standard_Failure& failure) {
        whys[k] = whyFailed(failure);
      }
    };
    runParallel(unknown.size(), task().options.jobs, judge, progress);
    for (std::size_t k = 0; k < unknown.size(); ++k) unfair_[unknown[k]->surface] = whys[k];
  }

  /// Of a face at fault the seam that took most effort, later all of them.
  Reasons whatToGiveUp(const Faults& faults) {
    Reasons seams;
    std::map<int, std::string> at_fault;  // by face
    bool tries_again = false;
    const auto addSides = [&](std::size_t i, const std::string& why) {
      for (const FaceUse& side : task().seams[i].sides) at_fault.emplace(side.face, why);
    };
    for (const auto& [i, why] : faults.proof.unrepaired) {
      addSides(i, why);
      if (looksAgain(i, faults.proof.after[i]))
        tries_again = true;
      else
        seams[i] = why;
    }
    for (const auto& [i, why] : faults.proof.worse) {
      addSides(i, why);
      if (looksAgain(i, faults.proof.after[i]))
        tries_again = true;
      else
        for (const FaceUse& side : task().seams[i].sides) giveUpAt(side.face, why, seams);
    }
    for (const auto& [face, why] : faults.unfair) {
      at_fault.emplace(face, why);
      if (stiffens(face))
        tries_again = true;
      else
        giveUpAt(face, nameOf(face) + ": " + why, seams);
    }
    for (const auto& [face, why] : faults.too_far) {
      at_fault.emplace(face, why);
      if (restrains(face))
        tries_again = true;
      else
        giveUpAt(face, nameOf(face) + ": " + why, seams);
    }
    for (const auto& [face, why] : faults.proof.faces) {
      at_fault.emplace(face, why);
      giveUpAt(face, nameOf(face) + ": " + why, seams);
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
          seams[i] = faults.proof.whole.empty() ? "no change was proven" : faults.proof.whole;
    return seams;
  }

  /// A component that was at fault in all its rounds is given up.
  void addAge(const FairComponent& component, const std::string& why, Reasons& seams) {
    int age = 0;
    for (const auto& [i, effort] : component.effort) age = std::max(age, ++ages_[i]);
    if (age >= single_rounds + face_rounds)
      for (const auto& [i, effort] : component.effort) seams.emplace(i, why);
  }

  /// Treated seams of a face; of one that has none, as it stays, those of the faces beside it.
  std::vector<std::size_t> treatedAt(int face) const {
    std::set<int> faces = {face};
    const auto seamsOf = [&] {
      std::vector<std::size_t> seams;
      for (std::size_t i = 0; i < task().seams.size(); ++i)
        if (task().isTreated(i) &&
            std::ranges::any_of(faces, [&](int one) { return touches(task().seams[i], one); }))
          seams.push_back(i);
      return seams;
    };
    std::vector<std::size_t> own = seamsOf();
    if (!own.empty()) return own;
    for (const Seam& seam : task().seams)
      if (touches(seam, face)) faces.insert({seam.sides[0].face, seam.sides[1].face});
    return seamsOf();
  }

  /// Of those that move with the face, and of which most is asked. What curvature spoils beside a face is not the tangent plane's fault.
  std::vector<std::size_t> mostAskedAt(int face) const {
    std::vector<std::size_t> seams = treatedAt(face);
    int most = 0;
    for (const FairComponent& component : components_)
      if (component.movers.count(face) > 0)
        for (const auto& [i, order] : component.orders) most = std::max(most, task().orders[i]);
    std::erase_if(seams, [&](std::size_t i) { return task().orders[i] < most; });
    if (!seams.empty()) return seams;
    for (const FairComponent& component : components_)
      if (component.movers.count(face) > 0)
        for (const auto& [i, order] : component.orders)
          if (task().orders[i] == most) seams.push_back(i);
    return seams;
  }

  void giveUpAt(int face, const std::string& why, Reasons& seams) const {
    const std::vector<std::size_t> treated = mostAskedAt(face);
    for (const std::size_t i : treated)
      if (const auto age = ages_.find(i); age != ages_.end() && age->second >= single_rounds)
        seams.emplace(i, why);
    const auto effort = [this](std::size_t i) { return effortOf(i); };
    if (!treated.empty()) seams.emplace(*std::ranges::max_element(treated, {}, effort), why);
  }

  double effortOf(std::size_t seam) const {
    for (const FairComponent& component : components_)
      if (const auto effort = component.effort.find(seam); effort != component.effort.end())
        return effort->second;
    return 0;
  }

  /// The next solution has samples where a figure is largest.
  bool looksAgain(std::size_t i, const SeamResult& seam) {
    if (++looks_[i] > most_looks) return false;
    for (const auto* figure : {&seam.figures.gap_mm, &seam.figures.angle_rad, &seam.figures.curvature_rel})
      if (*figure) missed_[i].insert((*figure)->at);
    return true;
  }

  /// The next solution spends less on a face.
  bool stiffens(int face) {
    constexpr double factor = 2, most = 4;
    double& stiffness = restraints_[face].stiffness;
    if (stiffness >= most) return false;
    stiffness *= factor;
    return true;
  }

  /// The next solution moves a face less, for the price of more bending.
  bool restrains(int face) {
    constexpr double factor = 0.5, least = 0.1;
    const double limit_mm = task().options.max_move_mm;
    double& move_mm = restraints_[face].move_mm;
    if (!(limit_mm > 0) || move_mm <= least * limit_mm) return false;
    move_mm = std::min(limit_mm, factor * move_mm);
    return true;
  }

  Rounds rounds_;
  TopTools_IndexedMapOfShape faces_;  ///< as given
  std::vector<FairComponent> components_;
  MissedPlaces missed_;
  Restraints restraints_;
  std::map<std::size_t, int> looks_, ages_;             ///< by seam
  std::map<handle<Geom_Surface>, std::string> unfair_;  ///< why; empty: fair enough
};

/// \throws Cancelled. What else is thrown becomes the reason of all.
template <class Work>
Improvement orNothing(const RepairTask& task, const std::optional<Soundness>& was, const Work& work) {
  Rounds none(task, was);
  try {
    return work();
  } catch (const Cancelled&) {
    throw;
  } catch (const Standard_Failure& failure) {
    none.giveUpAll(whyFailed(failure));
  } catch (const std::exception& error) {
    none.giveUpAll(error.what());
  }
  return none.nothing();
}

}  // namespace

Improvement improveByPaths(const RepairTask& task, const std::optional<Soundness>& was,
                           const Progress& progress) {
  return orNothing(task, was, [&] {
    Rounds rounds(task, was);
    JoinedPaths joined = joinPaths(task, partOf(progress, 0, 0.5));
    rounds.giveUp(joined.failures);
    while (!rounds.isOver()) {
      Proof proof = rounds.proven({}, joined.paths, partOf(progress, 0.5, 1));
      if (proof.holds()) return rounds.kept({}, std::move(joined.paths), std::move(proof));
      // New paths are of single edges: what is not repaired goes, and the rest is tried once more; else all goes.
      if (proof.unrepaired.empty()) rounds.giveUpAll("its new path would spoil another edge");
      rounds.giveUp(proof.unrepaired);
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

Improvement improveByMoves(const RepairTask& task, const std::optional<Soundness>& was,
                           const Progress& progress) {
  return orNothing(task, was, [&] { return Moving(task, was).run(progress); });
}

}  // namespace seamwright::occ
