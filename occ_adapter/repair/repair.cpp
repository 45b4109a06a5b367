// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <seamwright/occ_adapter/repair/convert_faces.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/improve.hpp>
#include <seamwright/occ_adapter/repair/instances.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
#include <seamwright/occ_adapter/repair/time_limit.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

std::vector<Seam> seamsOf(const TopoDS_Shape& shape, const RepairOptions& options,
                          const Progress& progress) {
  SeamGraph graph = findSeams(shape);
  if (options.match_mm > 0)
    matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph,
                   progress);
  return std::move(graph.seams);
}

/// Why a seam does not reach its target.
struct LeftReason {
  RepairReason target;   ///< why not the target
  RepairReason g1 = {};  ///< why not even G1, where that was tried after G2
  bool has_g1 = false;   ///< it got G1 instead of G2

  /// Both in one, with the fault of the target.
  RepairReason whole() const {
    RepairReason reason = target;
    if (has_g1)
      reason.text = "G1 reached; G2: " + target.text;
    else if (!g1.empty())
      reason.text = target.text + "; G1: " + g1.text;
    return reason;
  }
};

/// The model between stages.
struct RepairState {
  TopoDS_Shape shape;
  Report after;
  std::vector<Seam> seams;
  std::vector<SeamResult> to_keep;   ///< what no seam may be worse than: as given, or as repaired
  std::vector<LeftReason> reasons;   ///< by seam
  std::map<int, double> moves;       ///< by face
  std::map<int, FaceMove> judged;    ///< by face that moved
  std::map<int, double> edge_moves;  ///< by edge

  /// Keeps the result of a stage.
  /// \param asked order that the stage tried, by seam. \param sharp see Choice.
  void keep(const std::vector<int>& asked, const RepairOptions& options,
            const std::vector<bool>& sharp, Improvement done);

 private:
  void addEdgeMoves(const std::vector<PathChange>& paths);
};

void RepairState::keep(const std::vector<int>& asked, const RepairOptions& options,
                       const std::vector<bool>& sharp, Improvement done) {
  for (const auto& [i, why] : done.reasons)
    (asked[i] < options.order && !reasons[i].target.empty() ? reasons[i].g1 : reasons[i].target) =
        why;
  for (const auto& [i, why] : done.g1_reasons) reasons[i].g1 = why;
  if (done.changes.empty() && done.paths.empty()) return;
  shape = done.shape;
  after.seams = std::move(done.after);
  seams = seamsIn(done.shape, seams);
  for (const FaceChange& change : done.changes) moves[change.face] += change.largest_move_mm;
  for (auto& [face, move] : done.judged) judged[face] = std::move(move);
  addEdgeMoves(done.paths);
  for (std::size_t i = 0; i < done.orders.size(); ++i) {
    // The accepted turn of a fold depends on the seams beside it and has been judged, so the new
    // angle is the one to keep.
    if (SeamResult& kept = to_keep[i]; isFold(kept, options.tolerance))
      kept.figures.angle_rad = after.seams[i].figures.angle_rad;
    if (done.orders[i] == 0) continue;
    to_keep[i] = after.seams[i];
    if (done.orders[i] == options.order || sharp[i])
      reasons[i] = {};
    else
      reasons[i].has_g1 = true;
  }
}

/// Adds moves of edges. For an edge with new pcurves on both faces the larger move counts.
void RepairState::addEdgeMoves(const std::vector<PathChange>& paths) {
  std::map<int, double> by_edge;
  for (const PathChange& change : paths)
    by_edge[change.edge] = std::max(by_edge[change.edge], change.largest_move_mm);
  for (const auto& [edge, move_mm] : by_edge) edge_moves[edge] += move_mm;
}

/// Chooses seams whose moving faces are distinct and do not meet.
std::vector<std::size_t> apart(const RepairState& now, const std::set<std::size_t>& seams,
                               bool neighbours_help) {
  std::vector<std::size_t> order(seams.begin(), seams.end());
  const auto angle = [&now](std::size_t i) {
    const auto& figure = now.after.seams[i].figures.angle_rad;
    return figure ? figure->lower : 0;
  };
  std::ranges::stable_sort(order, {}, angle);
  const FacesAtVertices around(now.shape);
  std::map<int, std::set<int>> beside;
  for (const Seam& seam : now.seams) {
    beside[seam.sides[0].face].insert(seam.sides[1].face);
    beside[seam.sides[1].face].insert(seam.sides[0].face);
  }
  std::set<int> taken;
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) {
    const auto& sides = now.seams[i].sides;
    const std::set<int> moving =
        neighbours_help ? around.of(now.seams[i]) : std::set<int>{sides[0].face, sides[1].face};
    if (std::ranges::any_of(moving, [&taken](int face) { return taken.count(face) > 0; })) continue;
    chosen.push_back(i);
    for (const int face : moving) {
      taken.insert(face);
      taken.insert(beside[face].begin(), beside[face].end());
    }
  }
  return chosen;
}

/// The faces around the ends of wanted seams, as far as they can be computed with.
std::set<int> facesAround(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                          const std::vector<bool>& wanted, const UnusableParts& unusable) {
  const FacesAtVertices around(shape);
  std::set<int> faces;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i]) faces.merge(around.of(seams[i]));
  std::erase_if(faces, [&unusable](int face) { return unusable.hasFace(face); });
  return faces;
}

/// Leaves seams at kinks of a surface unrepaired.
void leaveKinks(const std::vector<bool>& sharp, const ContinuityTolerance& tolerance,
                RepairState& now, std::vector<bool>& wanted) {
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i] || sharp[i]) continue;
    try {
      now.reasons[i].target = whyKinked(now.seams[i], tolerance);
    } catch (const Standard_Failure& failure) {
      now.reasons[i].target = why::failed(failure);
    }
    wanted[i] = now.reasons[i].target.empty();
  }
}

/// Seams that are to lose their angle.
std::vector<bool> turned(std::vector<bool> wanted, const std::vector<bool>& sharp) {
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = wanted[i] && !sharp[i];
  return wanted;
}

/// \param shape that was sewn
void takeSewn(const Model& given, const TopoDS_Shape& shape, SewSolution solution,
              RepairReport& report) {
  report.model.shape = solution.sewn.shape;
  report.model.attributes = attributesAfter(given.attributes, shape, solution.sewn);
  report.after.seams = std::move(solution.after);
  report.after.open = std::move(solution.open);
  report.after.non_manifold = std::move(solution.non_manifold);
  report.after.model.edges = report.model.edgeCount();
  report.faces_now = std::move(solution.sewn.faces);
  report.edges_now = std::move(solution.sewn.edges);
}

/// Puts the moves into the report.
void tellMoves(const RepairState& now, RepairReport& report) {
  for (const auto& [face, move_mm] : now.moves) {
    if (!(move_mm > 0)) continue;
    FaceMove move = now.judged.at(face);
    move.largest_move_mm = move_mm;
    if (move.surface) move.surface->move_mm.upper = std::max(move.surface->move_mm.lower, move_mm);
    report.moves.push_back(std::move(move));
  }
  for (const auto& [edge, move_mm] : now.edge_moves) report.edge_moves.push_back({edge, move_mm});
}

/// One call of repair(). First edges get new pcurves, then faces move, then seams that meet are
/// sewn.
class Repairing {
 public:
  Repairing(const Model& model, const RepairOptions& options, const Progress& progress)
      : model_(model),
        options_(options),
        progress_(progress),
        unusable_(model.shape),
        time_(options.max_time_s) {}

  RepairReport run() {
    result_.model = model_;
    result_.before =
        analyze(model_, analyzeOptions(options_), partOf(progress_, 0, share_of_analysis));
    Choice choice = choose(model_, result_.before, options_);
    now_ = {model_.shape, result_.before, {}, result_.before.seams, {}, {}, {}, {}};
    for (RepairReason& reason : choice.reasons) now_.reasons.push_back({std::move(reason)});
    sharp_ = std::move(choice.sharp);
    wants_conversion_ = std::move(choice.wants_conversion);
    std::vector<bool> wanted = std::move(choice.treated);
    if (std::ranges::count(wanted, true) > 0) {
      now_.seams = seamsOf(model_.shape, options_, {});
      leaveKinks(sharp_, options_.tolerance, now_, wanted);
    }
    if (std::ranges::count(wanted, true) > 0) {
      needed_ = neededVariation(model_.shape, result_.before.seams, turned(wanted, sharp_));
      limits_mm_ =
          moveLimits(model_.shape, result_.before.seams,
                     facesAround(model_.shape, now_.seams, wanted, unusable_), wanted, options_);
      const double all = options_.match_mm > 0 && options_.sew ? share_before_sewing : 1;
      repair(wanted, choice.faces, partOf(progress_, share_of_analysis, all));
    }
    result_.model.shape = now_.shape;
    result_.after = now_.after;
    if (options_.match_mm > 0 && options_.sew) sew();
    tell(wanted);
    result_.repair_s = time_.spent_s();
    if (progress_) progress_(1);
    return std::move(result_);
  }

 private:
  /// Progress at the ends of the stages.
  static constexpr double share_of_analysis = 0.2, share_of_paths = 0.1, share_of_moves = 0.6,
                          share_of_g1 = 0.7, share_before_sewing = 0.9;
  /// Shares of the time limit after which a stage is stopped. They leave time for the stages that
  /// repair single seams, each of which is quick.
  static constexpr double time_of_paths = 0.5, time_of_g2 = 0.6, time_of_moves = 0.9;

  void repair(const std::vector<bool>& wanted, const std::vector<FaceChoice>& faces,
              const Progress& progress) {
    const int order = anyCurvatureDoes(options_.tolerance) ? 1 : options_.order;
    std::vector<int> orders(wanted.size());
    std::ranges::transform(wanted, orders.begin(),
                           [order](bool is_wanted) { return is_wanted ? order : 0; });
    keepInTime(orders, time_of_paths, partOf(progress, 0, share_of_paths),
               [&](const Progress& part) { return improveByPaths(taskOf(faces, orders), part); });
    for (std::size_t i = 0; i < orders.size(); ++i) {
      if (isRepaired(now_.after.seams[i], sharp_[i], options_.tolerance, levelOf(order)))
        orders[i] = 0;
      if (orders[i] == 0) continue;
      if (const RepairReason obstacle = whyNoneMoves(now_.after.seams[i].faces, faces);
          !obstacle.empty()) {
        RepairReason& reason = now_.reasons[i].target;
        reason = why::joined(obstacle, reason.empty() && out_of_time_ ? why::timeLimit() : reason);
        orders[i] = 0;
      } else {
        now_.reasons[i] = {};
      }
    }
    const auto move = [&](const Progress& part) {
      return improveByMoves(taskOf(faces, orders), part);
    };
    keepInTime(orders, order > 1 ? time_of_g2 : time_of_moves,
               partOf(progress, share_of_paths, share_of_moves), move);
    const std::vector<int> asked = orders;
    for (int& left : orders) left = std::min(left, 1);
    for (std::size_t i = 0; i < orders.size(); ++i)
      if (isRepaired(now_.after.seams[i], sharp_[i], options_.tolerance, Level::G1)) orders[i] = 0;
    if (order > 1)
      keepInTime(orders, time_of_moves, partOf(progress, share_of_moves, share_of_g1), move);
    const double alone = order > 1 ? (share_of_g1 + 1) / 2 : 1;
    repairAlone(orders, Level::G1, faces, partOf(progress, share_of_g1, alone));
    if (order > 1) repairAlone(asked, Level::G2, faces, partOf(progress, alone, 1));
  }

  /// Repairs seams that are still below the level one by one, from the smallest angle on. They may
  /// have failed only because of seams that were solved together with them. Seams that fail again
  /// are tried once more, with the faces around their ends moving too.
  void repairAlone(const std::vector<int>& orders, Level level,
                   const std::vector<FaceChoice>& faces, const Progress& progress) {
    for (const bool neighbours_help : {false, true})
      repairAlone(orders, level, faces, neighbours_help,
                  partOf(progress, neighbours_help ? 0.5 : 0, neighbours_help ? 1 : 0.5));
  }

  /// Repairs several seams at a time, as long as no face of one is next to a face of another.
  void repairAlone(const std::vector<int>& orders, Level level,
                   const std::vector<FaceChoice>& faces, bool neighbours_help,
                   const Progress& progress) {
    constexpr int most_batches = 8;
    std::set<std::size_t> left;
    for (std::size_t i = 0; i < orders.size(); ++i)
      if (orders[i] > 0 && !isRepaired(now_.after.seams[i], sharp_[i], options_.tolerance, level))
        left.insert(i);
    for (int batch = 0; batch < most_batches && !left.empty(); ++batch) {
      std::vector<int> of_batch(orders.size(), 0);
      for (const std::size_t i : apart(now_, left, neighbours_help)) {
        of_batch[i] = orders[i];
        left.erase(i);
      }
      keepInTime(
          of_batch, 1,
          partOf(progress, static_cast<double>(batch) / most_batches, (batch + 1.0) / most_batches),
          [&](const Progress& part) {
            return improveByMoves(taskOf(faces, of_batch, neighbours_help), part);
          });
    }
  }

  RepairTask taskOf(const std::vector<FaceChoice>& faces, std::vector<int> orders,
                    bool neighbours_help = false) const {
    return {now_.shape,   now_.seams, now_.to_keep,      now_.after.seams, faces,
            sharp_,       options_,   unusable_,         needed_,          limits_mm_,
            model_.shape, now_.moves, std::move(orders), neighbours_help};
  }

  /// Runs a stage and keeps its result.
  /// \param asked order that the stage tries, by seam. \param share share of the time limit after
  /// which the stage is stopped, without effect.
  template <class Stage>
  void keepInTime(const std::vector<int>& asked, double share, const Progress& progress,
                  const Stage& stage) {
    std::optional<Improvement> done = time_.within(share, progress, stage);
    if (done)
      now_.keep(asked, options_, sharp_, std::move(*done));
    else
      out_of_time_ = true;
  }

  void sew() {
    if (now_.seams.empty()) now_.seams = seamsOf(model_.shape, options_, {});
    const TopoDS_Shape shape = result_.model.shape;
    const std::vector<SeamResult> before = result_.after.seams;
    const std::vector<FaceChoice> no_faces;
    const RepairTask task{shape,
                          now_.seams,
                          result_.before.seams,
                          before,
                          no_faces,
                          sharp_,
                          options_,
                          unusable_,
                          needed_,
                          limits_mm_,
                          model_.shape,
                          now_.moves,
                          std::vector<int>(before.size(), 0)};
    const std::vector<Seam> seams = seamsAfter(task, shape, {});
    SewSolution solution =
        sewFreeEdges({.shape = shape, .seams = seams, .before = before, .options = options_},
                     partOf(progress_, share_before_sewing, 1));
    not_sewn_ = std::move(solution.reasons);
    if (solution.sewn.shape.IsNull()) return;
    takeSewn(model_, shape, std::move(solution), result_);
  }

  void tell(const std::vector<bool>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      SeamRepair seam;
      seam.before = result_.before.seams[i];
      seam.after = result_.after.seams[i];
      seam.treated = wanted[i];
      if (wanted[i] && out_of_time_ && now_.reasons[i].target.empty())
        now_.reasons[i].target = why::timeLimit();
      seam.reason = now_.reasons[i].whole();
      seam.sewn = seam.before.kind == SeamKind::Matched && seam.after.kind != SeamKind::Matched;
      if (const auto why = not_sewn_.find(i); why != not_sewn_.end()) seam.not_sewn = why->second;
      seam.repaired =
          wanted[i] && isRepaired(seam.after, sharp_[i], options_.tolerance, options_.level());
      seam.wants_conversion = wants_conversion_[i] && !seam.repaired;
      if (seam.repaired)
        seam.reason = {};
      else if (wanted[i] && seam.before.kind == SeamKind::Matched && !seam.before.note.empty())
        seam.reason = why::afterNote(seam.before.note, std::move(seam.reason));
      result_.seams.push_back(std::move(seam));
    }
    tellMoves(now_, result_);
  }

  const Model& model_;
  const RepairOptions& options_;
  const Progress& progress_;
  const UnusableParts unusable_;
  const TimeLimit time_;
  bool out_of_time_ = false;  ///< a stage was stopped, or not begun
  RepairState now_;
  std::vector<bool> sharp_, wants_conversion_;  ///< by seam, see Choice
  NeededVariation needed_;                      ///< by face
  MoveLimits limits_mm_;
  SewReasons not_sewn_;
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
  const auto requirePositive = [](const char* name, double value, const char* unit) {
    if (value > 0) return;
    std::ostringstream text;
    text << name << " is " << value << " " << unit << ": it must be larger than zero";
    throw std::invalid_argument(text.str());
  };
  if (max_move_mm) requirePositive("largest move", *max_move_mm, "mm");
  requirePositive("time limit", max_time_s, "s");
}

RepairReport repair(const Model& model, const RepairOptions& options, const Progress& progress) {
  options.validate();
  const auto plain = [](const Model& of, const RepairOptions& how, const Progress& part) {
    return Repairing(of, how, part).run();
  };
  const auto converting = [&plain](const Model& of, const RepairOptions& how,
                                   const Progress& part) {
    return how.convert_analytic ? repairConverting(of, how, plain, part) : plain(of, how, part);
  };
  return repairInstances(model, options, converting, progress);
}

}  // namespace seamwright::occ
