// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/match/candidate.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/side_join.hpp>
#include <seamwright/occ_adapter/match/to_splines.hpp>
#include <seamwright/occ_adapter/model/coordinate_rounding.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>

namespace seamwright::occ {

namespace {

std::array<TopoDS_Face, 2> facesOf(const TopoDS_Shape& model, int face_a, int face_b) {
  TopTools_IndexedMapOfShape faces;
  if (!model.IsNull()) TopExp::MapShapes(model, TopAbs_FACE, faces);
  for (const int face : {face_a, face_b}) requireFace(face, faces.Extent());
  if (face_a == face_b)
    throw std::invalid_argument(
        fmt::format("face {} is given twice: two faces are needed", face_a));
  return {TopoDS::Face(faces(face_a)), TopoDS::Face(faces(face_b))};
}

void announce(const Progress& progress, double share) {
  if (progress && !progress(share)) throw Cancelled();
}

bool reaches(const SeamFigures& figures, const FaceMatchOptions& options) {
  return certainlyReaches(figures, options.tolerance, options.order == 1 ? Level::G1 : Level::G2);
}

AnalyzeOptions analyzeOptions(const FaceMatchOptions& options) {
  AnalyzeOptions analyze;
  analyze.tolerance = options.tolerance;
  analyze.level = options.order == 1 ? Level::G1 : Level::G2;
  analyze.match_mm = options.match_mm;
  return analyze;
}

TopoDS_Shell shellOf(const std::array<TopoDS_Face, 2>& faces) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  return shell;
}

/// The seam of a shell of two faces along that edge.
SeamResult measured(const TopoDS_Shell& shell, const TopoDS_Edge& edge,
                    const FaceMatchOptions& options) {
  for (const Seam& seam : findSeams(shell).seams)
    if (seam.sides[0].edge.IsSame(edge)) return measureSeam(seam, analyzeOptions(options));
  SeamResult nothing;
  nothing.note = "the faces do not share the new edge";
  return nothing;
}

/// Of edges and vertices.
double largestTolerance_mm(const TopoDS_Shape& shape) {
  ShapeAnalysis_ShapeTolerance tolerance;
  return std::max(tolerance.Tolerance(shape, 1, TopAbs_EDGE),
                  tolerance.Tolerance(shape, 1, TopAbs_VERTEX));
}

bool isClosedLoop(const MatchSide& side, double gap_mm) {
  const FaceStrip strip(side.use, side.pcurve);
  return (strip.trace(0).p - strip.trace(1).p).norm() <= gap_mm;
}

/// What one call of matchFaces() has to do.
struct MatchTask {
  std::array<TopoDS_Face, 2> faces;
  std::array<int, 2> numbers;  ///< of the faces in the model
  FaceMatchOptions options;
  Progress progress;
};

/// Which of the faces move.
struct ChosenMoves {
  std::array<bool, 2> moves{};
  int driver = 0;
  std::vector<MatchReason> remarks;   ///< of faces that should move and can't
  std::vector<MatchReason> failures;  ///< why none of them moves
};

ChosenMoves chooseMoves(const MatchTask& task, const std::array<MatchSide, 2>& sides) {
  ChosenMoves chosen;
  for (const MatchSide& side : sides)
    if (isClosedLoop(side, task.options.tolerance.gap_mm)) {
      chosen.failures = {match_why::closedBoundary()};
      return chosen;
    }
  const std::array<bool, 2> wanted = {task.options.moves != MatchMoves::Second,
                                      task.options.moves != MatchMoves::First};
  for (const int which : {0, 1}) chosen.moves[which] = wanted[which] && sides[which].isNatural();
  const bool any_moves = chosen.moves[0] || chosen.moves[1];
  // If both move, the second face gives the parameter of the seam.
  chosen.driver = chosen.moves[1] ? 1 : 0;
  for (const int which : {0, 1}) {
    if (wanted[which] && !chosen.moves[which]) {
      const MatchReason obstacle = match_why::onFace(task.numbers[which], sides[which].cannot_move);
      if (any_moves)
        match_why::add(chosen.remarks, match_why::faceStays(obstacle));
      else
        match_why::add(chosen.failures, obstacle);
    } else if (!any_moves && sides[which].isNatural()) {
      match_why::add(chosen.failures, match_why::faceCouldMove(task.numbers[which]));
    }
  }
  return chosen;
}

/// Why boundaries are not side by side over their whole length; empty if they are. Ends of matched
/// edges may each be as far from the other boundary as edges that match, so they may be twice as
/// far apart.
MatchReason whyNotSideBySide(const MatchTask& task, const Seam& seam, const ReferencePath& path) {
  const double near_mm = std::max(task.options.match_mm, task.options.tolerance.gap_mm);
  if (path.ends_apart_mm > 2 * near_mm) return match_why::endsApart(path.ends_apart_mm);
  return whyApart(seam, task.options);
}

/// Why a side that has to stay would move; empty if none does. Sides that are held are lines of the
/// surface; the edges of trimmed ones run through poles that move.
MatchReason whySideIsNotHeld(const MatchTask& task, const SeamPlan& plan) {
  if (!task.options.hold_sides) return {};
  const double gap_mm = task.options.tolerance.gap_mm;
  for (const int which : {0, 1}) {
    const double move_mm = largestSideMove_mm(plan.faces[which], gap_mm);
    // The same hundredth within which a boundary counts as a side: see matchSide().
    if (move_mm > gap_mm / 100) return match_why::sideMoves(task.numbers[which], move_mm);
  }
  return {};
}

/// Why a candidate need not be built; empty if there is no such reason.
MatchReason whyNotBuilt(const MatchTask& task, const PairToMatch& pair,
                        const Candidate& candidate) {
  if (candidate.largest_move_mm > task.options.max_move_mm)
    return match_why::movesTooFar(candidate.largest_move_mm, task.options.max_move_mm);
  if (MatchReason moved = whySideIsNotHeld(task, candidate.plan); !moved.empty()) return moved;
  for (const int which : {0, 1}) {
    const MovedSurface& moved = candidate.moved[which];
    const PatchEdge edge = pair.sides[which].edge;
    if (!moved.after.IsNull() &&
        isTurnedOver(EdgeRows(moved.before, edge), EdgeRows(moved.after, edge), task.options.order))
      return match_why::foldsOver(candidate.how, task.numbers[which]);
  }
  return {};
}

/// The faces that a candidate makes, and what is wrong with them.
struct PairProof {
  MatchReason failure;  ///< empty: the faces are as they should be
  TopoDS_Shell shell;
  SeamResult after;  ///< with numbers of the shell
};

PairProof prove(const MatchTask& task, const PairToMatch& pair, const Candidate& candidate) {
  PairProof proof;
  proof.failure = whyNotBuilt(task, pair, candidate);
  if (!proof.failure.empty()) return proof;
  const RebuiltPair rebuilt = rebuild(candidate.plan);
  proof.shell = rebuilt.shell;
  proof.after = measured(rebuilt.shell, rebuilt.seam, task.options);
  announce(task.progress, 0.9);  // share of the progress bar, as are the others below
  const double tolerance_mm = largestTolerance_mm(rebuilt.shell);
  const double given_mm =
      std::max(largestTolerance_mm(pairOf(task.faces)), task.options.tolerance.gap_mm);
  // Twice: curves on a moved surface are fitted again and need a little more than they had.
  if (!reaches(proof.after.figures, task.options))
    proof.failure = match_why::stillMisses(candidate.how, figuresText(proof.after));
  else if (tolerance_mm > 2 * given_mm)
    proof.failure = match_why::edgesStray(candidate.how, tolerance_mm);
  else if (!BRepCheck_Analyzer(rebuilt.shell).IsValid())
    proof.failure = match_why::checksFail(candidate.how);
  return proof;
}

/// A candidate and what came of its proof.
struct Attempt {
  Candidate candidate;
  std::optional<PairProof> proof;  ///< nothing if there was no candidate

  bool isProven() const { return proof && proof->failure.empty(); }
};

/// Samples of a fitted join have to meet this share of the tolerance, so that what lies between
/// them meets the whole.
constexpr double first_share = 0.8;

/// Proves a fitted join. Enclosures see what lies between samples, so a join that fails is fitted
/// again to half the share, twice at most. A join that moves too far is not: a nearer one does not
/// move less.
Attempt proveFitted(const MatchTask& task, const PairToMatch& pair, Candidate candidate) {
  constexpr int attempts = 3;
  double share = first_share;
  for (int attempt = 1;; ++attempt) {
    if (!candidate.failure.empty()) return {std::move(candidate), std::nullopt};
    PairProof proof = prove(task, pair, candidate);
    if (proof.failure.empty() || proof.failure.fault == MatchFault::MovesTooFar ||
        attempt == attempts)
      return {std::move(candidate), std::move(proof)};
    share /= 2;
    candidate = joinToTolerance(pair, share);
  }
}

/// A proven join, or why there is none.
struct Join {
  std::optional<Attempt> proven;
  std::vector<MatchReason> failures;
};

bool isMade(const std::optional<Candidate>& candidate) {
  return candidate && candidate->failure.empty();
}

/// Joins in poles and to the tolerance, if both can be. The exact join is proven first, unless it
/// moves more than twice as far: then both boundaries are run through at different speeds, and
/// poles would have to slide along them.
Join join(const MatchTask& task, const PairToMatch& pair) {
  std::optional<Candidate> exact, fitted;
  if (pair.other().isNatural()) exact = joinInPoles(pair);
  announce(task.progress, 0.5);
  const bool both_move = pair.moves[0] && pair.moves[1];
  if (!both_move && pair.path.failure.empty()) fitted = joinToTolerance(pair, first_share);
  announce(task.progress, 0.7);
  const bool exact_first =
      isMade(exact) && !(isMade(fitted) && 2 * fitted->largest_move_mm < exact->largest_move_mm);
  Join result;
  for (const bool is_exact : {exact_first, !exact_first}) {
    std::optional<Candidate>& candidate = is_exact ? exact : fitted;
    if (!isMade(candidate)) continue;
    Attempt attempt = is_exact ? Attempt{*candidate, prove(task, pair, *candidate)}
                               : proveFitted(task, pair, *candidate);
    if (attempt.isProven()) return {std::move(attempt), {}};
    if (attempt.proof) match_why::add(result.failures, attempt.proof->failure);
    candidate = std::move(attempt.candidate);
  }
  for (const std::optional<Candidate>& candidate : {exact, fitted})
    if (candidate) match_why::add(result.failures, candidate->failure);
  match_why::add(result.failures, pair.path.failure);
  return result;
}

bool endsInPoint(const MovedSurface& moved, PatchEdge edge) {
  if (moved.after.IsNull()) return false;
  const EdgeRows rows(moved.after, edge);
  return isCollapsed(rows, 0) || isCollapsed(rows, rows.columns() - 1);
}

/// How the faces were joined, and what the user should know about them.
std::vector<MatchReason> remarksOn(const Attempt& proven, const MatchTask& task,
                                   const PairToMatch& pair) {
  std::vector<MatchReason> remarks = {proven.candidate.how};
  for (const int which : {0, 1})
    if (endsInPoint(proven.candidate.moved[which], pair.sides[which].edge))
      match_why::add(remarks, match_why::endsInPoint(task.numbers[which]));
  for (const Seam& seam : findSeams(proven.proof->shell).seams) {
    if (seam.kind != SeamKind::Shared || seam.edges == proven.proof->after.edges) continue;
    const SeamFigures figures = measureSeam(seam, analyzeOptions(task.options)).figures;
    if (figures.gap_mm && figures.gap_mm->lower > task.options.tolerance.gap_mm)
      match_why::add(remarks, match_why::otherEdgeApart(figures.gap_mm->lower));
  }
  return remarks;
}

void addAll(std::vector<MatchReason>& reasons, const std::vector<MatchReason>& added) {
  for (const MatchReason& reason : added) match_why::add(reasons, reason);
}

void reportLeft(const MatchTask& task, const Seam& seam, MatchReport& report) {
  const TopoDS_Shell shell = shellOf(task.faces);
  report.matched = true;
  report.shape = shell;
  report.after = measured(shell, seam.sides[0].edge, task.options);
  match_why::add(report.remarks, match_why::hasLevel());
}

/// Judges the moved surfaces as a repair does. Worse ones are named, and stay.
void judgeMoves(const MatchTask& task, const Candidate& candidate, MatchReport& report) {
  RepairOptions options;
  options.tolerance = task.options.tolerance;
  options.fairness = task.options.fairness;
  // The faces as a model of their own, numbered 1 and 2.
  SeamResult seam = report.before;
  seam.faces = {1, 2};
  const TopoDS_Shape pair = pairOf(task.faces);
  const NeededVariation needed =
      neededVariation(pair, {seam}, {true}, std::nullopt, task.options.order > 1);
  for (const int which : {0, 1}) {
    const MovedSurface& moved = candidate.moved[which];
    if (moved.after.IsNull()) continue;
    FaceMove move = judgedMove(which + 1, task.faces[which], moved.after, moved.largest_move_mm,
                               options, needed);
    move.face = task.numbers[which];
    if (!move.less_fair.empty())
      match_why::add(report.remarks, match_why::isLessFair(move.face, move));
    report.moves.push_back(std::move(move));
  }
}

void reportJoined(const MatchTask& task, const PairToMatch& pair, const Attempt& proven,
                  MatchReport& report) {
  report.matched = true;
  report.exact = proven.candidate.exact;
  report.shape = proven.proof->shell;
  report.after = proven.proof->after;
  report.largest_move_mm = proven.candidate.largest_move_mm;
  addAll(report.remarks, remarksOn(proven, task, pair));
  judgeMoves(task, proven.candidate, report);
}

/// Joins whole sides of surfaces. Adds to the report why that can't be.
void matchWholeSides(const MatchTask& task, const Seam& seam, MatchReport& report) {
  PairToMatch pair;
  pair.options = task.options;
  for (const int which : {0, 1})
    pair.sides[which] = matchSide(task.faces[which], seam.sides[which], task.options);
  const ChosenMoves chosen = chooseMoves(task, pair.sides);
  addAll(report.remarks, chosen.remarks);
  addAll(report.failures, chosen.failures);
  if (!chosen.failures.empty()) return;
  pair.moves = chosen.moves;
  pair.driver = chosen.driver;
  const MatchSide& driver = pair.sides[pair.driver];
  pair.path = referencePath(EdgeRows(driver.spline, driver.edge), pair.other(), task.options);
  announce(task.progress, 0.3);
  match_why::add(report.failures, whyNotSideBySide(task, seam, pair.path));
  if (!report.failures.empty()) return;
  const Join joined = join(task, pair);
  addAll(report.failures, joined.failures);
  if (joined.proven) reportJoined(task, pair, *joined.proven, report);
}

/// The face that moves, first, and the other one: the one that should move, unless it has no poles
/// and the other one may move too.
std::array<int, 2> moverAndOther(const MatchTask& task) {
  if (task.options.moves == MatchMoves::First) return {0, 1};
  if (task.options.moves == MatchMoves::Second) return {1, 0};
  return hasPoles(task.faces[1]) ? std::array{1, 0} : std::array{0, 1};
}

/// The two faces, numbered 1 and 2, and their seam, with the moving face first.
SideJoin pairJoin(const MatchTask& task, const Seam& seam) {
  const auto [mover, other] = moverAndOther(task);
  SideJoin join;
  join.shape =
      seam.kind == SeamKind::Shared ? TopoDS_Shape(shellOf(task.faces)) : pairOf(task.faces);
  join.face = mover + 1;
  join.names = {task.numbers[0], task.numbers[1]};
  Seam numbered = seam;
  const TopTools_IndexedMapOfShape edges = partsOf(join.shape, TopAbs_EDGE);
  for (const int which : {0, 1}) numbered.sides[which].face = which + 1;
  for (std::size_t k = 0; k < numbered.edges.size(); ++k)
    numbered.edges[k] = edges.FindIndex(seam.sides[k].edge);
  join.pieces = {{withFirst(numbered, join.face), task.options.order}};
  join.options.tolerance = task.options.tolerance;
  join.options.depth_mm = task.options.depth_mm;
  join.options.hold = task.options.hold_sides ? HeldEdges::Position : HeldEdges::None;
  join.options.average = task.options.moves == MatchMoves::Both && hasPoles(task.faces[mover]) &&
                         hasPoles(task.faces[other]);
  join.options.max_move_mm = task.options.max_move_mm;
  join.options.match_mm = task.options.match_mm;
  join.options.fairness = task.options.fairness;
  return join;
}

/// Joins the faces by a change near any boundary. It replaces the failures in the report.
void matchInZone(const MatchTask& task, const Seam& seam, MatchReport& report) {
  const SideJoinResult joined = joinSides(pairJoin(task, seam), partOf(task.progress, 0.7, 1));
  report.moves = joined.moves;
  for (FaceMove& move : report.moves)
    move.face = task.numbers[static_cast<std::size_t>(move.face - 1)];
  if (!joined.failure.empty()) {
    report.failures = {joined.failure};
    return;
  }
  report.failures.clear();
  addAll(report.remarks, joined.remarks);
  report.matched = true;
  report.shape = joined.shape;
  report.after = joined.after.front();
  report.depth_mm = joined.depth_mm;
  for (const FaceMove& move : joined.moves)
    report.largest_move_mm = std::max(report.largest_move_mm, move.largest_move_mm);
  if (report.after.faces[0] == 1) return;
  std::swap(report.after.faces[0], report.after.faces[1]);
  std::ranges::reverse(report.after.edges);
}

/// The faces that should move, if they may become splines.
std::vector<int> facesToConvert(const MatchTask& task) {
  std::vector<int> faces;
  if (!task.options.convert) return faces;
  if (task.options.moves != MatchMoves::Second) faces.push_back(task.numbers[0]);
  if (task.options.moves != MatchMoves::First) faces.push_back(task.numbers[1]);
  return faces;
}

/// Whether a change near the boundary may do what whole sides can't.
bool mayJoinInZone(const MatchReport& report) {
  constexpr std::array no_help = {MatchFault::BoundariesApart,   MatchFault::FaceWithoutPoles,
                                  MatchFault::FaceBeyondSurface, MatchFault::FacesFold,
                                  MatchFault::MovesTooFar,       MatchFault::SideEndsAway,
                                  MatchFault::SideEndsTilted,    MatchFault::SideEndsCurved};
  return std::ranges::none_of(report.failures, [&](const MatchReason& failure) {
    return std::ranges::count(no_help, failure.fault) > 0;
  });
}

/// Fills in the report as far as it gets, so that what is known before OpenCASCADE fails stays.
void match(const TopoDS_Shape& model, const MatchTask& task, MatchReport& report) {
  const CommonBoundary boundary =
      commonBoundary(model, task.faces, task.options, partOf(task.progress, 0, 0.1));
  match_why::add(report.remarks, boundary.remark);
  match_why::add(report.failures, boundary.failure);
  if (!boundary.seam) return;
  Seam seam = *boundary.seam;
  for (const int which : {0, 1}) seam.sides[which].face = task.numbers[which];
  report.before = report.after = measureSeam(seam, analyzeOptions(task.options));
  announce(task.progress, 0.2);
  if (seam.kind == SeamKind::Shared && reaches(report.before.figures, task.options))
    return reportLeft(task, seam, report);
  if (!task.options.depth_mm) matchWholeSides(task, seam, report);
  if (report.matched || !mayJoinInZone(report)) return;
  matchInZone(task, seam, report);
}

void requireNotNegative(const char* what, double mm, bool may_be_infinite) {
  if (mm >= 0 && (may_be_infinite || std::isfinite(mm))) return;
  throw std::invalid_argument(fmt::format("{} is {:.6g} mm: it must be zero or larger", what, mm));
}

}  // namespace

void FaceMatchOptions::validate() const {
  tolerance.validate();
  SurfaceTolerance{fairness, 0}.validate();
  if (depth_mm && !(*depth_mm > 0 && std::isfinite(*depth_mm)))
    throw std::invalid_argument(
        fmt::format("the depth is {:.6g} mm: it must be positive and finite", *depth_mm));
  if (order != 1 && order != 2)
    throw std::invalid_argument(fmt::format("order is {}: it must be 1 or 2", order));
  requireNotNegative("largest move", max_move_mm, true);
  requireNotNegative("distance to match", match_mm, false);
  if (edge < 0) throw std::invalid_argument(fmt::format("edge is {}: edges count from 1", edge));
}

std::string MatchReport::code() const {
  if (failures.empty()) return {};
  const auto decides = [](const MatchReason& failure) {
    return failure.fault != MatchFault::NoExactJoin && failure.fault != MatchFault::JoinRefused;
  };
  const auto found = std::ranges::find_if(failures, decides);
  return codeOf((found == failures.end() ? failures.begin() : found)->fault);
}

std::string MatchReport::remedy() const {
  const auto found = std::ranges::find(
      failures, code(), [](const MatchReason& failure) { return codeOf(failure.fault); });
  return found == failures.end() ? std::string() : remedyOf(found->fault);
}

std::string MatchReport::text() const {
  return match_why::textOf(remarks, failures);
}

MatchReport matchFaces(const TopoDS_Shape& model, int face_a, int face_b,
                       const FaceMatchOptions& options, const Progress& progress) {
  options.validate();
  requireAboveRounding("gap tolerance", options.tolerance.gap_mm, model);
  if (options.match_mm > 0) requireAboveRounding("distance to match", options.match_mm, model);
  MatchTask task{facesOf(model, face_a, face_b), {face_a, face_b}, options, progress};
  MatchReport report;
  report.shape = pairOf(task.faces);
  const UnusableParts unusable(model);
  for (const int face : {face_a, face_b})
    if (const std::string fault = unusable.whyLeftOut(face); !fault.empty()) {
      report.failures = {match_why::faceUnusable(face, fault)};
      return report;
    }
  try {
    const ConvertedModel splines =
        withSplines(model, facesToConvert(task), options.tolerance.gap_mm);
    task.faces = facesOf(splines.shape, face_a, face_b);
    match(splines.shape, task, report);
    if (!report.matched) report.shape = pairOf(facesOf(model, face_a, face_b));
    if (report.matched) addAll(report.remarks, splines.remarks);
  } catch (const Cancelled&) {
    throw;
  } catch (const Standard_Failure& failure) {
    match_why::add(report.failures, match_why::openCascadeFailed(failure));
  } catch (const GeometryError& error) {
    match_why::add(report.failures, match_why::failed(error.what()));
  }
  announce(progress, 1);
  return report;
}

}  // namespace seamwright::occ
