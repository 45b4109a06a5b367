// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/seams/match.hpp>

namespace seamwright::occ {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Seam> seamsOf(const TopoDS_Shape& shape, const RepairOptions& options, const Progress& progress) {
  SeamGraph graph = findSeams(shape);
  if (options.match_mm > 0)
    matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph, progress);
  return std::move(graph.seams);
}

/// One call of repair(): what is asked for is tried; what spoils it is given up; until what is left can be proven.
class Repairing {
 public:
  Repairing(const Model& model, const RepairOptions& options, const Progress& progress)
      : model_(model), options_(options), progress_(progress) {}

  RepairReport run() {
    const auto start = std::chrono::steady_clock::now();
    result_.model = model_;
    result_.before = analyze(model_, analyzeOptions(options_), partOf(progress_, 0, share_of_analysis));
    result_.after = result_.before;
    Choice choice = choose(model_, result_.before, options_);
    reasons_ = std::move(choice.reasons);
    const std::vector<bool> wanted = choice.treated;
    if (std::ranges::count(wanted, true) > 0) {
      seams_ = seamsOf(model_.shape, options_, {});
      repair({model_.shape, seams_, result_.before.seams, choice.faces, wanted, options_});
    }
    tell(wanted);
    result_.repair_s = secondsSince(start);
    if (progress_) progress_(1);
    return std::move(result_);
  }

 private:
  static constexpr double share_of_analysis = 0.2;
  static constexpr int most_rounds = 12;
  /// From then on what is connected with a culprit is given up with it.
  static constexpr int rounds_for_culprits_alone = 6;

  void repair(RepairTask task) {
    const Soundness was = soundnessOf(task.shape);
    double done = share_of_analysis;
    for (int round = 0; round < most_rounds; ++round) {
      const double next = done + (1 - done) / 3;
      const Progress part = partOf(progress_, done, next);
      done = next;
      const std::map<std::size_t, std::string> given_up =
          attempt(task, was, round >= rounds_for_culprits_alone, part);
      if (given_up.empty()) return;
      giveUp(given_up, task);
      if (std::ranges::count(task.treated, true) == 0) return;
    }
    std::map<std::size_t, std::string> rest;
    for (std::size_t i = 0; i < task.treated.size(); ++i)
      if (task.treated[i]) rest[i] = "no change was proven in " + std::to_string(most_rounds) + " rounds";
    giveUp(rest, task);
  }

  /// \returns seams to give up; none if the change was kept.
  std::map<std::size_t, std::string> attempt(RepairTask& task, const Soundness& was, bool with_connected,
                                             const Progress& progress) {
    const RepairSolution solution = solve(task, partOf(progress, 0, 0.5));
    giveUp(solution.failures, task);
    if (solution.changes.empty()) return everything(task, "the solver moved nothing");
    try {
      const TopoDS_Shape changed = withChanges(task.shape, solution.changes, options_.tolerance.gap_mm);
      const Proof proof = prove(task, solution.changes, changed, was, partOf(progress, 0.5, 1));
      if (!proof.holds()) return culprits(task, solution.changes, proof, with_connected);
      keep(solution.changes, changed, proof);
      return {};
    } catch (const Standard_Failure& failure) {
      return everything(task, std::string("OpenCASCADE failed: ") + failure.DynamicType()->Name() + " " +
                                  failure.GetMessageString());
    } catch (const Cancelled&) {
      throw;
    } catch (const std::runtime_error& error) {
      return everything(task, error.what());
    }
  }

  static std::map<std::size_t, std::string> everything(const RepairTask& task, const std::string& why) {
    std::map<std::size_t, std::string> all;
    for (std::size_t i = 0; i < task.treated.size(); ++i)
      if (task.treated[i]) all[i] = why;
    return all;
  }

  void giveUp(const std::map<std::size_t, std::string>& seams, RepairTask& task) {
    for (const auto& [i, why] : seams) {
      task.treated[i] = false;
      reasons_[i] = why;
    }
  }

  void keep(const std::vector<FaceChange>& changes, const TopoDS_Shape& changed, const Proof& proof) {
    result_.model.shape = changed;
    result_.after.seams = proof.after;
    for (const FaceChange& change : changes) result_.moves.push_back({change.face, change.largest_move_mm});
    std::ranges::sort(result_.moves, {}, &FaceMove::face);
  }

  void tell(const std::vector<bool>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      SeamRepair seam{result_.before.seams[i], result_.after.seams[i], wanted[i], false, reasons_[i]};
      seam.repaired = wanted[i] && seam.reason.empty();
      result_.seams.push_back(std::move(seam));
    }
  }

  const Model& model_;
  const RepairOptions& options_;
  const Progress& progress_;
  std::vector<Seam> seams_;
  std::vector<std::string> reasons_;
  RepairReport result_;
};

}  // namespace

void RepairOptions::validate() const {
  analyzeOptions(*this).validate();
  if (order != 1 && order != 2)
    throw std::invalid_argument("order is " + std::to_string(order) + ": it must be 1 or 2");
  if (!(max_move_mm >= 0)) {
    std::ostringstream text;
    text << "largest move is " << max_move_mm << " mm: it must be zero or larger";
    throw std::invalid_argument(text.str());
  }
}

RepairReport repair(const Model& model, const RepairOptions& options, const Progress& progress) {
  options.validate();
  return Repairing(model, options, progress).run();
}

}  // namespace seamwright::occ
