// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/match/candidate.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

void addReason(std::string& reasons, const std::string& reason) {
  if (reason.empty() || reasons.find(reason) != std::string::npos) return;
  if (!reasons.empty()) reasons += "; ";
  reasons += reason;
}

std::array<TopoDS_Face, 2> facesOf(const TopoDS_Shape& model, int face_a, int face_b) {
  TopTools_IndexedMapOfShape faces;
  if (!model.IsNull()) TopExp::MapShapes(model, TopAbs_FACE, faces);
  for (const int face : {face_a, face_b})
    if (face < 1 || face > faces.Extent())
      throw std::invalid_argument("face " + std::to_string(face) + ": the model has faces 1 to " +
                                  std::to_string(faces.Extent()));
  if (face_a == face_b)
    throw std::invalid_argument("face " + std::to_string(face_a) +
                                " is given twice: two faces are needed");
  return {TopoDS::Face(faces(face_a)), TopoDS::Face(faces(face_b))};
}

void report(const Progress& progress, double share) {
  if (progress && !progress(share)) throw Cancelled();
}

bool reaches(const SeamFigures& figures, const FaceMatchOptions& options) {
  return surelyReaches(figures, options.tolerance, options.order == 1 ? Level::G1 : Level::G2);
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

/// One call of matchFaces().
class Matching {
 public:
  Matching(const std::array<TopoDS_Face, 2>& faces, const std::array<int, 2>& numbers,
           const FaceMatchOptions& options, const Progress& progress)
      : faces_(faces), numbers_(numbers), options_(options), progress_(progress) {}

  MatchReport run(const TopoDS_Shape& model) {
    result_.shape = pairOf(faces_);
    try {
      if (const std::string why = attempt(model); !result_.matched) addReason(result_.reason, why);
    } catch (const Cancelled&) {
      throw;
    } catch (const Standard_Failure& failure) {
      addReason(result_.reason, std::string("OpenCASCADE failed: ") +
                                    failure.DynamicType()->Name() + " " +
                                    failure.GetMessageString());
    } catch (const std::runtime_error& error) {
      addReason(result_.reason, error.what());
    }
    report(progress_, 1);
    return std::move(result_);
  }

 private:
  /// \returns why the faces were not matched.
  std::string attempt(const TopoDS_Shape& model) {
    CommonBoundary boundary = commonBoundary(model, faces_, options_, partOf(progress_, 0, 0.1));
    result_.reason = boundary.note;
    if (!boundary.seam) return {};
    Seam seam = *boundary.seam;
    for (const int which : {0, 1}) seam.sides[which].face = numbers_[which];
    result_.before = result_.after = measureSeam(seam, analyzeOptions(options_));
    report(progress_, 0.2);
    if (seam.kind == SeamKind::Shared && reaches(result_.before.figures, options_))
      return leave(seam);
    for (const int which : {0, 1})
      pair_.sides[which] = matchSide(faces_[which], seam.sides[which], options_);
    pair_.options = options_;
    if (const std::string why = chooseMoves(); !why.empty()) return why;
    return prepareAndJoin(seam);
  }

  std::string leave(const Seam& seam) {
    result_.matched = true;
    const TopoDS_Shell shell = shellOf(faces_);
    result_.shape = shell;
    result_.after = measured(shell, seam.sides[0].edge, options_);
    addReason(result_.reason, "the faces have the level already; nothing had to move");
    return {};
  }

  std::string cannotMove(int which) const {
    return "face " + std::to_string(numbers_[which]) + " " + pair_.sides[which].cannot_move;
  }

  std::string chooseMoves() {
    for (const MatchSide& side : pair_.sides)
      if (isClosedLoop(side, options_.tolerance.gap_mm))
        return "the common boundary is a closed loop, or no longer than the gap tolerance, which "
               "is not "
               "handled";
    const std::array<bool, 2> wanted = {options_.moves != MatchMoves::Second,
                                        options_.moves != MatchMoves::First};
    for (const int which : {0, 1})
      pair_.moves[which] = wanted[which] && pair_.sides[which].isNatural();
    if (pair_.moves[0] || pair_.moves[1]) {
      pair_.driver = pair_.moves[1] ? 1 : 0;
      for (const int which : {0, 1})
        if (wanted[which] && !pair_.moves[which])
          addReason(result_.reason, cannotMove(which) + ", so it stays");
      return {};
    }
    std::string why;
    for (const int which : {0, 1})
      if (wanted[which])
        addReason(why, cannotMove(which));
      else if (pair_.sides[which].isNatural())
        addReason(why, "face " + std::to_string(numbers_[which]) + " could move");
    return why;
  }

  std::string prepareAndJoin(const Seam& seam) {
    const EdgeRows driver(pair_.sides[pair_.driver].spline, pair_.sides[pair_.driver].edge);
    pair_.path = referencePath(driver, pair_.other(), options_);
    report(progress_, 0.3);
    if (pair_.path.ends_apart_mm > 2 * std::max(options_.match_mm, options_.tolerance.gap_mm)) {
      std::ostringstream text;
      text << "the ends of the boundaries are " << pair_.path.ends_apart_mm
           << " mm apart: only boundaries that run side by side over their whole length can be "
              "joined";
      return text.str();
    }
    if (const std::string why = whyApart(seam, options_); !why.empty()) return why;
    return join();
  }

  /// Both ways where both are open, the better one proven first.
  std::string join() {
    std::string why;
    Candidate exact, follower;
    exact.failure = follower.failure = "-";
    if (pair_.other().isNatural()) exact = joinInPoles(pair_);
    report(progress_, 0.5);
    const bool can_follow = !(pair_.moves[0] && pair_.moves[1]) && pair_.path.failure.empty();
    constexpr double first_limit = 0.8;
    if (can_follow) follower = joinToTolerance(pair_, first_limit);
    report(progress_, 0.7);
    const bool exact_first =
        exact.failure.empty() &&
        !(follower.failure.empty() && 2 * follower.largest_move_mm < exact.largest_move_mm);
    if (exact_first && prove(exact, why)) return {};
    if (can_follow && proveFollower(follower, first_limit, why)) return {};
    if (!exact_first && exact.failure.empty() && prove(exact, why)) return {};
    for (const std::string& failure : {exact.failure, follower.failure, pair_.path.failure})
      if (failure != "-") addReason(why, failure);
    return why;
  }

  /// Samples can miss what enclosures see; then once more, nearer.
  bool proveFollower(Candidate& follower, double limit, std::string& why) {
    constexpr int attempts = 3;
    for (int attempt = 0; attempt < attempts && follower.failure.empty(); ++attempt) {
      std::string attempt_failed;
      if (prove(follower, attempt_failed)) return true;
      if (attempt + 1 == attempts || attempt_failed.starts_with(needs_a_move)) {
        addReason(why, attempt_failed);
        return false;
      }
      limit /= 2;
      follower = joinToTolerance(pair_, limit);
    }
    return false;
  }

  bool prove(const Candidate& candidate, std::string& why) {
    std::ostringstream text;
    if (candidate.largest_move_mm > options_.max_move_mm) {
      text << needs_a_move << candidate.largest_move_mm << " mm, more than " << options_.max_move_mm
           << " mm";
      addReason(why, text.str());
      return false;
    }
    if (const std::string moved = movedSides(candidate.plan); !moved.empty()) {
      addReason(why, moved);
      return false;
    }
    for (const int which : {0, 1}) {
      const MovedSurface& moved = candidate.moved[which];
      const PatchEdge edge = pair_.sides[which].edge;
      if (!moved.after.IsNull() &&
          isTurnedOver(EdgeRows(moved.before, edge), EdgeRows(moved.after, edge), options_.order)) {
        addReason(why,
                  candidate.how + ": face " + std::to_string(numbers_[which]) + " would fold over");
        return false;
      }
    }
    const RebuiltPair rebuilt = rebuild(candidate.plan);
    const SeamResult after = measured(rebuilt.shell, rebuilt.seam, options_);
    report(progress_, 0.9);
    if (!reaches(after.figures, options_)) {
      addReason(why, candidate.how + ", but then " + figuresText(after));
      return false;
    }
    const double tolerance_mm = largestTolerance_mm(rebuilt.shell);
    if (tolerance_mm >
        2 * std::max(largestTolerance_mm(pairOf(faces_)), options_.tolerance.gap_mm)) {
      text << candidate.how << ", but then edges are " << tolerance_mm
           << " mm away from their faces";
      addReason(why, text.str());
      return false;
    }
    if (!BRepCheck_Analyzer(rebuilt.shell).IsValid()) {
      addReason(why, candidate.how + ", but OpenCASCADE's checks do not pass");
      return false;
    }
    accept(candidate, rebuilt.shell, after);
    return true;
  }

  /// Sides that should be held are held as lines of the surface; trimmed ones run through poles
  /// that move.
  std::string movedSides(const SeamPlan& plan) const {
    if (!options_.hold_sides) return {};
    for (const int which : {0, 1}) {
      const double move_mm = largestSideMove_mm(plan.faces[which], options_.tolerance.gap_mm);
      if (move_mm <= options_.tolerance.gap_mm / 100) continue;
      std::ostringstream text;
      text << "a boundary of face " << numbers_[which] << " that ends at the seam would move by "
           << move_mm << " mm: it is trimmed, and only whole sides of a surface can be held";
      return text.str();
    }
    return {};
  }

  void accept(const Candidate& candidate, const TopoDS_Shell& shell, const SeamResult& after) {
    result_.matched = true;
    result_.exact = candidate.exact;
    result_.shape = shell;
    result_.after = after;
    result_.largest_move_mm = candidate.largest_move_mm;
    addReason(result_.reason, candidate.how);
    for (const int which : {0, 1})
      addReason(result_.reason, pointText(which, candidate.moved[which]));
    for (const Seam& seam : findSeams(shell).seams)
      if (seam.kind == SeamKind::Shared && seam.edges != after.edges)
        addReason(result_.reason, gapeText(seam));
  }

  std::string pointText(int which, const MovedSurface& moved) const {
    if (moved.after.IsNull()) return {};
    const EdgeRows rows(moved.after, pair_.sides[which].edge);
    if (!isCollapsed(rows, 0) && !isCollapsed(rows, rows.columns() - 1)) return {};
    return "face " + std::to_string(numbers_[which]) +
           " ends in a point at the seam, where its curvature may have become very large";
  }

  /// Of another edge that the faces have in common.
  std::string gapeText(const Seam& seam) const {
    const SeamFigures figures = measureSeam(seam, analyzeOptions(options_)).figures;
    if (!figures.gap_mm || figures.gap_mm->lower <= options_.tolerance.gap_mm) return {};
    std::ostringstream text;
    text << "at another edge that the faces share they are " << figures.gap_mm->lower
         << " mm apart now";
    return text.str();
  }

  static constexpr const char* needs_a_move = "the join needs a move of ";

  const std::array<TopoDS_Face, 2>& faces_;
  std::array<int, 2> numbers_;
  const FaceMatchOptions& options_;
  const Progress& progress_;
  PairToMatch pair_;
  MatchReport result_;
};

void requireNotNegative(const char* what, double mm, bool may_be_infinite) {
  if (mm >= 0 && (may_be_infinite || std::isfinite(mm))) return;
  std::ostringstream text;
  text << what << " is " << mm << " mm: it must be zero or larger";
  throw std::invalid_argument(text.str());
}

}  // namespace

void FaceMatchOptions::validate() const {
  tolerance.validate();
  if (order != 1 && order != 2)
    throw std::invalid_argument("order is " + std::to_string(order) + ": it must be 1 or 2");
  requireNotNegative("largest move", max_move_mm, true);
  requireNotNegative("distance to match", match_mm, false);
  if (edge < 0)
    throw std::invalid_argument("edge is " + std::to_string(edge) + ": edges count from 1");
}

MatchReport matchFaces(const TopoDS_Shape& model, int face_a, int face_b,
                       const FaceMatchOptions& options, const Progress& progress) {
  options.validate();
  const std::array<TopoDS_Face, 2> faces = facesOf(model, face_a, face_b);
  const UnusableParts unusable(model);
  for (const int face : {face_a, face_b})
    if (const std::string why = unusable.whyLeftOut(face); !why.empty()) {
      MatchReport report;
      report.shape = pairOf(faces);
      report.reason = "face " + std::to_string(face) + " " + why;
      return report;
    }
  return Matching(faces, {face_a, face_b}, options, progress).run(model);
}

}  // namespace seamwright::occ
