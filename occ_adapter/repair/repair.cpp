// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <seamwright/occ_adapter/repair/convert_faces.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/displace.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/core/surface/judge.hpp>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <BRepBndLib.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <Geom_BSplineSurface.hxx>
#include <cstdio>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
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
    now_.shape = model_.shape;
    now_.after = result_.before;
    Choice choice = choose(model_, result_.before, options_);
    now_.reasons = std::move(choice.reasons);
    sharp_ = std::move(choice.sharp);
    const std::vector<bool> wanted = choice.treated;
    now_.open = wanted;
    if (std::ranges::count(wanted, true) > 0) {
      now_.seams = seamsOf(model_.shape, options_, {});
      const double all = options_.match_mm > 0 && options_.sew ? share_before_sewing : 1;
      const Progress part = partOf(progress_, share_of_analysis, all);
      now_.to_keep = result_.before.seams;
      if (options_.order == 1 || anyCurvatureDoes(options_.tolerance))
        repair(choice.faces, toG1(), part);
      else
        repairToG2(choice.faces, part);
    }
    if (std::getenv("SW_FAIR")) {
      TopTools_IndexedMapOfShape was, is;
      TopExp::MapShapes(model_.shape, TopAbs_FACE, was);
      TopExp::MapShapes(now_.shape, TopAbs_FACE, is);
      int worse = 0, count = 0;
      for (const auto& [face, move] : now_.moves) {
        TopLoc_Location where;
        const auto placed = BRep_Tool::Surface(TopoDS::Face(is(face)), where);
        const auto spline = opencascade::handle<Geom_BSplineSurface>::DownCast(placed->Transformed(where.Transformation()));
        if (spline.IsNull() || !(move > 0)) continue;
        const double size = 1;
        (void)size;
        Bnd_Box box;
        BRepBndLib::Add(was(face), box);
        const double visible = visibleVariation(options_.tolerance, std::sqrt(box.SquareExtent()));
        const SurfaceChange change = measureChange(TopoDS::Face(was(face)), spline, move, visible);
        const SurfaceVerdict verdict = judgeSurface(change, {1.5, visible});
        ++count;
        worse += verdict.worse;
        std::fprintf(stderr, "FACE %d move %.4g normal %.3g tangential %.3g turn %.3g curv %.3g TV %.4g -> %.4g (visible %.3g) extrema %d -> %d infl %d -> %d lines %d %s\n", face, move, change.normal_move_mm, change.tangential_move_mm, change.turn_rad, change.curvature_change_per_mm,
                     change.before.variation_per_mm, change.after.variation_per_mm, visible, change.before.extrema, change.after.extrema, change.before.inflections, change.after.inflections, change.after.lines, verdict.worse ? "WORSE" : "");
      }
      int before = 0, after = 0;
      for (std::size_t i = 0; i < now_.after.seams.size(); ++i) {
        before += result_.before.seams[i].verdict.seam_class == SeamClass::Defect;
        after += now_.after.seams[i].verdict.seam_class == SeamClass::Defect;
      }
      std::fprintf(stderr, "SUM defects %d -> %d changed %d worse %d time %.2f\n", before, after, count, worse, secondsSince(start));
    }
    result_.model.shape = now_.shape;
    result_.after = now_.after;
    if (options_.match_mm > 0 && options_.sew) sew();
    tell(wanted);
    result_.repair_s = secondsSince(start);
    if (progress_) progress_(1);
    return std::move(result_);
  }

 private:
  /// Says less than what a way before has found.
  static constexpr const char* nothing_moved = "nothing was moved";
  static constexpr double share_of_analysis = 0.2, share_before_sewing = 0.9;
  static constexpr int most_rounds = 12;
  /// From then on what is connected with a culprit is given up with it.
  static constexpr int rounds_for_culprits_alone = 6;

  using Solver = std::function<RepairSolution(const RepairTask&, const Progress&)>;
  using Reasons = std::map<std::size_t, std::string>;

  /// The model on its way.
  struct State {
    TopoDS_Shape shape;
    Report after;
    std::vector<Seam> seams;
    std::vector<bool> open;            ///< by seam: to be repaired, and not yet
    std::vector<SeamResult> to_keep;   ///< what no seam may be worse than: as given, or as repaired
    std::vector<std::string> reasons;  ///< by seam
    std::map<int, double> moves;       ///< by face
    std::map<int, double> edge_moves;  ///< by edge
    std::optional<Soundness> was;      ///< of the shape, once known
  };

  enum class Which { All, Dear, NotDear };
  struct Way {
    Solver solver;
    Which which = Which::All;
    bool gives_curvature = true;  ///< false: hardly ever, and as slowly as the others together
  };

  RepairOptions toG1() const {
    RepairOptions options = options_;
    options.order = 1;
    return options;
  }

  bool hasG1(const State& state, std::size_t i) const {
    return isRepaired(state.after.seams[i], sharp_[i], toG1());
  }

  /// Seams that can't have one curvature get one tangent plane, if they lack that too; what was repaired stays so. What one plane alone
  /// would have got it has got it then: where the curvature of others is in the way, planes come first.
  void repairToG2(const std::vector<FaceChoice>& faces, const Progress& progress) {
    const State given = now_;
    const std::vector<bool>& wanted = given.open;
    repair(faces, options_, partOf(progress, 0, 0.5));
    std::vector<std::string> of_g2 = now_.reasons;
    // Of these the gap alone was to be closed.
    for (std::size_t i = 0; i < wanted.size(); ++i) now_.open[i] = now_.open[i] && !sharp_[i];
    repairToG1(faces, partOf(progress, 0.5, 0.7));
    std::vector<std::string> of_g1 = now_.reasons;
    const auto lacks = [&](const State& state, std::size_t i) { return wanted[i] && !hasG1(state, i); };
    const auto some = [&](const auto& holds) {
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (holds(i)) return true;
      return false;
    };
    if (some([&](std::size_t i) { return lacks(now_, i); })) {
      State curved = std::exchange(now_, given);
      repairToG1(faces, partOf(progress, 0.7, 0.85));
      if (some([&](std::size_t i) { return lacks(curved, i) && !lacks(now_, i); })) {
        of_g1 = now_.reasons;
        repairAgain(curved, faces, of_g2, partOf(progress, 0.85, 1));
      } else {
        now_ = std::move(curved);
      }
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (wanted[i] && !sharp_[i] && !hasG1(given, i))
        now_.reasons[i] = hasG1(now_, i) ? "G1 reached; G2: " + of_g2[i] : of_g2[i] + "; G1: " + of_g1[i];
      else if (wanted[i])
        now_.reasons[i] = of_g2[i];
  }

  /// Open seams that lack one tangent plane.
  void repairToG1(const std::vector<FaceChoice>& faces, const Progress& progress) {
    const RepairOptions options = toG1();
    now_.to_keep = judged(std::move(now_.to_keep), options);
    for (std::size_t i = 0; i < now_.open.size(); ++i) {
      now_.open[i] = now_.open[i] && !hasG1(now_, i);
      if (now_.open[i]) now_.reasons[i].clear();
    }
    repair(faces, options, progress);
  }

  /// Seams that got one curvature in another state. \param of_g2 why seams have none.
  void repairAgain(const State& curved, const std::vector<FaceChoice>& faces, std::vector<std::string>& of_g2,
                   const Progress& progress) {
    const auto has = [this](const State& state, std::size_t i) {
      return isRepaired(state.after.seams[i], sharp_[i], options_);
    };
    now_.to_keep = judged(std::move(now_.to_keep), options_);
    for (std::size_t i = 0; i < now_.open.size(); ++i) {
      now_.open[i] = has(curved, i) && !has(now_, i);
      if (now_.open[i]) now_.reasons[i].clear();
    }
    const std::vector<bool> tried = now_.open;
    repair(faces, options_, progress);
    for (std::size_t i = 0; i < tried.size(); ++i)
      if (tried[i]) of_g2[i] = now_.reasons[i];
  }

  static std::vector<SeamResult> judged(std::vector<SeamResult> seams, const RepairOptions& options) {
    for (SeamResult& seam : seams) seam.verdict = judge(seam.figures, options.tolerance, options.level());
    return seams;
  }

  /// What one way leaves the next one tries, in the shape as it is then; what an exact join moves far, first by following.
  /// \param options with the order that is tried.
  void repair(const std::vector<FaceChoice>& faces, const RepairOptions& options, const Progress& progress) {
    followed_.clear();
    JoinedPairs pairs;
    DearSeams dear;
    const auto network = [](DearSeams* left) {
      return [left](const RepairTask& task, const Progress& part) { return joinNetwork(task, left, part); };
    };
    const Solver pairwise = [&pairs](const RepairTask& task, const Progress& part) {
      return joinPairs(task, pairs, part);
    };
    const auto follow = [this](LeadReach reach) {
      return [this, reach](const RepairTask& task, const Progress& part) {
        return followTargets(task, reach, followed_, part);
      };
    };
    const std::array<Way, 7> ways = {{{joinPaths, Which::All},
                                      {network(&dear), Which::All},
                                      {pairwise, Which::NotDear},
                                      {follow(LeadReach::Spans), Which::All},
                                      {follow(LeadReach::Half), Which::All, false},
                                      {network(nullptr), Which::Dear, false},
                                      {pairwise, Which::Dear}}};
    double done = 0;
    for (std::size_t k = 0; k < ways.size(); ++k) {
      if (k == 1) displace(faces, options, progress);
      if (std::getenv("SW_ONLY") && k > 0) break;
      const double next = done + (1 - done) / static_cast<double>(ways.size() - k);
      const TopoDS_Shape shape = now_.shape;
      const std::vector<SeamResult> before = judged(now_.after.seams, options);
      RepairTask task{shape,  now_.seams, now_.to_keep, before,          faces,
                      sharp_, now_.open,  options,      options_.level()};
      for (std::size_t i = 0; i < now_.open.size(); ++i)
        if (ways[k].which != Which::All && (dear.count(i) > 0) != (ways[k].which == Which::Dear))
          task.treated[i] = false;
      if (options.order > 1 && !ways[k].gives_curvature) task.treated.assign(now_.open.size(), false);
      pairs.clear();
      says_why_ = ways[k].which != Which::Dear;
      if (std::ranges::count(task.treated, true) > 0)
        improve(std::move(task), ways[k].solver, partOf(progress, done, next));
      done = next;
    }
  }

  struct Fairness {
    std::map<int, std::string> worse;
  };

  std::map<int, std::string> unfair(const std::vector<FaceChange>& changes) const {
    std::map<int, std::string> found;
    TopTools_IndexedMapOfShape was;
    TopExp::MapShapes(model_.shape, TopAbs_FACE, was);
    for (const FaceChange& change : changes) {
      const auto spline = opencascade::handle<Geom_BSplineSurface>::DownCast(change.surface);
      if (spline.IsNull()) continue;
      Bnd_Box box;
      BRepBndLib::Add(was(change.face), box);
      const double visible = visibleVariation(options_.tolerance, std::sqrt(box.SquareExtent()));
      const SurfaceChange measured = measureChange(TopoDS::Face(was(change.face)), spline, change.largest_move_mm, visible);
      const SurfaceVerdict verdict = judgeSurface(measured, {1.5, visible});
      if (verdict.worse) found[change.face] = verdict.reason;
    }
    return found;
  }

  void displace(const std::vector<FaceChoice>& faces, const RepairOptions& options, const Progress& progress) {
    constexpr int rounds = 12, most_looks = 3;
    const bool debug = std::getenv("SW_DEBUG") != nullptr;
    const TopoDS_Shape shape = now_.shape;
    const std::vector<SeamResult> before = judged(now_.after.seams, options);
    RepairTask task{shape, now_.seams, now_.to_keep, before, faces, sharp_, now_.open, options, options_.level()};
    MissedPlaces missed;
    SolvedComponents known;
    MeasuredSeams measured;
    std::map<std::size_t, int> looks;
    const auto lookAgain = [&](std::size_t i, const SeamResult& seam) {
      if (++looks[i] > most_looks) return false;
      for (const auto* figure : {&seam.figures.gap_mm, &seam.figures.angle_rad, &seam.figures.curvature_rel})
        if (*figure) missed[i].insert((*figure)->at);
      return true;
    };
    for (int round = 0; round < rounds && std::ranges::count(task.treated, true) > 0; ++round) {
      FairSolution fair = displaceFaces(task, missed, known, progress);
      if (!fair.solution.complete) {
        if (debug) std::fprintf(stderr, "round %d: %zu fail\n", round, fair.solution.failures.size());
        giveUp(fair.solution.failures, task);
        continue;
      }
      if (fair.solution.changes.empty()) return;
      Proof proof;
      TopoDS_Shape changed;
      proof.too_far = movedTooFar(task, fair.solution.changes);
      if (proof.holds()) {
        changed = withChanges(task.shape, fair.solution.changes, options_.tolerance.gap_mm, {}, options_.jobs);
        proof = prove(task, fair.solution.changes, changed, now_.was, measured, {});
      }
      std::map<int, std::string> spoilt = unfair(fair.solution.changes);
      if (debug)
        std::fprintf(stderr, "round %d: unrepaired %zu worse %zu far %zu faces %zu unfair %zu whole %s\n", round, proof.unrepaired.size(), proof.worse.size(), proof.too_far.size(), proof.faces.size(), spoilt.size(), proof.whole.c_str());
      if (proof.holds() && spoilt.empty()) {
        keep(task, fair.solution, changed, proof);
        return;
      }
      Reasons given_up;
      for (const auto& [i, why] : proof.unrepaired)
        if (!lookAgain(i, proof.after[i])) given_up[i] = why;
      for (const auto& [i, why] : proof.worse)
        if (!lookAgain(i, proof.after[i]))
          for (std::size_t k = 0; k < task.seams.size(); ++k)
            if (task.treated[k] && (task.seams[k].sides[0].face == task.seams[i].sides[0].face || task.seams[k].sides[1].face == task.seams[i].sides[0].face ||
                                    task.seams[k].sides[0].face == task.seams[i].sides[1].face || task.seams[k].sides[1].face == task.seams[i].sides[1].face))
              given_up.emplace(k, why);
      spoilt.insert(proof.faces.begin(), proof.faces.end());
      spoilt.insert(proof.too_far.begin(), proof.too_far.end());
      for (const auto& [face, why] : spoilt) {
        std::optional<std::size_t> hardest;
        for (std::size_t k = 0; k < task.seams.size(); ++k)
          if (task.treated[k] && (task.seams[k].sides[0].face == face || task.seams[k].sides[1].face == face))
            if (!hardest || fair.effort[k] > fair.effort[*hardest]) hardest = k;
        if (hardest) given_up.emplace(*hardest, "face " + std::to_string(face) + ": " + why);
      }
      if (given_up.empty() && proof.unrepaired.empty() && proof.worse.empty()) given_up = everything(task, proof.whole.empty() ? "no way" : proof.whole);
      giveUp(given_up, task);
    }
  }

  void improve(RepairTask task, const Solver& solver, const Progress& progress) {
    MeasuredSeams measured;
    double done = 0;
    for (int round = 0; round < most_rounds && std::ranges::count(task.treated, true) > 0; ++round) {
      const double next = done + (1 - done) / 3;
      const Progress part = partOf(progress, done, next);
      done = next;
      const Reasons given_up = attempt(task, solver, measured, round >= rounds_for_culprits_alone, part);
      if (given_up.empty()) return;
      giveUp(given_up, task);
    }
    giveUp(everything(task, "no change was proven in " + std::to_string(most_rounds) + " rounds"), task);
  }

  /// Gives up what fails until the solver knows how all the rest is met.
  RepairSolution solve(RepairTask& task, const Solver& solver, const Progress& progress) {
    double done = 0;
    for (;;) {
      const double next = done + (1 - done) / 2;
      RepairSolution solution = solver(task, partOf(progress, done, next));
      if (solution.complete) return solution;
      giveUp(solution.failures, task);
      done = next;
    }
  }

  /// \returns seams to give up; none if the change was kept or all were given up.
  Reasons attempt(RepairTask& task, const Solver& solver, MeasuredSeams& measured, bool with_connected,
                  const Progress& progress) {
    try {
      RepairSolution solution = solve(task, solver, partOf(progress, 0, 0.5));
      if (std::ranges::count(task.treated, true) == 0) return {};
      RepairTask rest = task;
      giveUp(solution.failures, rest);
      if (solution.changes.empty() && solution.paths.empty()) return everything(task, nothing_moved);
      for (FaceChange& change : solution.changes) change.largest_move_mm += now_.moves[change.face];
      Proof proof;
      TopoDS_Shape changed;
      proof.too_far = movedTooFar(rest, solution.changes);
      if (proof.holds()) {
        changed = withChanges(task.shape, solution.changes, options_.tolerance.gap_mm, solution.paths,
                              options_.jobs);
        // Figures known are of edges with the paths that they have in the shape.
        MeasuredSeams of_paths;
        MeasuredSeams& known = solution.paths.empty() ? measured : of_paths;
        proof = prove(rest, solution.changes, changed, now_.was, known, partOf(progress, 0.5, 1));
      }
      if (!proof.holds()) {
        Reasons given_up = culprits(rest, solution, proof, with_connected);
        given_up.merge(solution.failures);
        return given_up;
      }
      keep(rest, solution, changed, proof);
      return {};
    } catch (const Cancelled&) {
      throw;
    } catch (const Standard_Failure& failure) {
      return everything(task, std::string("OpenCASCADE failed: ") + failure.DynamicType()->Name() + " " +
                                  failure.GetMessageString());
    } catch (const std::exception& error) {
      return everything(task, error.what());
    }
  }

  static Reasons everything(const RepairTask& task, const std::string& why) {
    Reasons all;
    for (std::size_t i = 0; i < task.treated.size(); ++i)
      if (task.treated[i]) all[i] = why;
    return all;
  }

  void giveUp(const Reasons& seams, RepairTask& task) {
    for (const auto& [i, why] : seams) {
      task.treated[i] = false;
      const bool tells = says_why_ && why != nothing_moved;
      if (tells || now_.reasons[i].empty()) now_.reasons[i] = why;
    }
  }

  void keep(const RepairTask& task, const RepairSolution& solution, const TopoDS_Shape& changed,
            const Proof& proof) {
    now_.shape = changed;
    followed_.clear();
    now_.was = proof.soundness;
    now_.after.seams = judged(proof.after, options_);
    now_.seams = seamsIn(changed, now_.seams);
    for (const FaceChange& change : solution.changes) now_.moves[change.face] = change.largest_move_mm;
    for (const PathChange& change : solution.paths) now_.edge_moves[change.edge] = change.largest_move_mm;
    for (std::size_t i = 0; i < task.treated.size(); ++i) {
      if (now_.open[i] && isRepaired(proof.after[i], sharp_[i], task.options))
        now_.to_keep[i] = proof.after[i];
      if (!task.treated[i]) continue;
      now_.open[i] = false;
      now_.reasons[i].clear();
    }
  }

  void sew() {
    if (now_.seams.empty()) now_.seams = seamsOf(model_.shape, options_, {});
    const TopoDS_Shape shape = result_.model.shape;
    const std::vector<SeamResult> before = result_.after.seams;
    const RepairTask task{shape, now_.seams, result_.before.seams, before, {}, sharp_, now_.open, options_};
    const std::vector<Seam> seams = seamsAfter(task, shape, {});
    SewSolution solution =
        sewLoose({shape, seams, before, options_}, partOf(progress_, share_before_sewing, 1));
    not_sewn_ = std::move(solution.reasons);
    if (solution.sewn.shape.IsNull()) return;
    result_.model.shape = solution.sewn.shape;
    result_.model.attributes = attributesAfter(model_.attributes, shape, solution.sewn);
    result_.after.seams = std::move(solution.after);
    result_.after.open = std::move(solution.open);
    result_.after.non_manifold = std::move(solution.non_manifold);
    result_.after.model.edges = result_.model.edgeCount();
    result_.faces_now = std::move(solution.sewn.faces);
    result_.edges_now = std::move(solution.sewn.edges);
  }

  void tell(const std::vector<bool>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      SeamRepair seam{
          result_.before.seams[i], result_.after.seams[i], wanted[i], false, now_.reasons[i], false, {}};
      seam.sewn = seam.before.kind == SeamKind::Matched && seam.after.kind != SeamKind::Matched;
      if (const auto why = not_sewn_.find(i); why != not_sewn_.end()) seam.not_sewn = why->second;
      seam.repaired = wanted[i] && isRepaired(seam.after, sharp_[i], options_);
      if (seam.repaired)
        seam.reason.clear();
      else if (wanted[i] && now_.open[i] && seam.before.kind == SeamKind::Matched &&
               !seam.before.note.empty())
        seam.reason = seam.before.note + "; " + seam.reason;
      result_.seams.push_back(std::move(seam));
    }
    for (const auto& [face, move_mm] : now_.moves)
      if (move_mm > 0) result_.moves.push_back({face, move_mm});
    for (const auto& [edge, move_mm] : now_.edge_moves) result_.edge_moves.push_back({edge, move_mm});
  }

  const Model& model_;
  const RepairOptions& options_;
  const Progress& progress_;
  State now_;
  std::vector<bool> sharp_;  ///< by seam, see Choice
  bool says_why_ = true;     ///< the way at work, also where one before did
  FollowedFaces followed_;   ///< in the shape as it is
  Reasons not_sewn_;
  RepairReport result_;
};

}  // namespace

AnalyzeOptions analyzeOptions(const RepairOptions& options) {
  AnalyzeOptions analyze;
  analyze.tolerance = options.tolerance;
  analyze.level = options.level();
  analyze.match_mm = options.match_mm;
  analyze.jobs = options.jobs;
  return analyze;
}

void RepairOptions::validate() const {
  analyzeOptions(*this).validate();
  if (order != 1 && order != 2)
    throw std::invalid_argument("order is " + std::to_string(order) + ": it must be 1 or 2");
  SurfaceTolerance{fairness, 0}.validate();
  if (!(max_move_mm >= 0)) {
    std::ostringstream text;
    text << "largest move is " << max_move_mm << " mm: it must be zero or larger";
    throw std::invalid_argument(text.str());
  }
}

RepairReport repair(const Model& model, const RepairOptions& options, const Progress& progress) {
  options.validate();
  const auto plain = [](const Model& of, const RepairOptions& how, const Progress& part) {
    return Repairing(of, how, part).run();
  };
  constexpr double share_before_judging = 0.97;
  const Progress repairing = partOf(progress, 0, share_before_judging);
  RepairReport report = options.convert_analytic ? repairConverting(model, options, plain, repairing)
                                                 : plain(model, options, repairing);
  judgeMoves(model.shape, report.model.shape, report.faces_now, options, report.moves,
             partOf(progress, share_before_judging, 1));
  return report;
}

}  // namespace seamwright::occ
