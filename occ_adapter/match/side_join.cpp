// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <set>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/convert/surface_kind.hpp>
#include <seamwright/occ_adapter/match/face_deformation.hpp>
#include <seamwright/occ_adapter/match/kept_edges.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/side_join.hpp>
#include <seamwright/occ_adapter/match/zone.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/surface_difference.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// A copy of the surface, placed in space. Periodic surfaces stay periodic, so that loops around
/// them have no end.
handle<Geom_BSplineSurface> splineOf(const TopoDS_Face& face) {
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
  const auto spline = handle<Geom_BSplineSurface>::DownCast(surface);
  if (!spline.IsNull() && (spline->IsUPeriodic() || spline->IsVPeriodic()))
    return handle<Geom_BSplineSurface>::DownCast(surface->Transformed(location.Transformation()));
  return clampedSpline(surface, location);
}

Level levelOfOrder(int order) {
  return static_cast<Level>(static_cast<int>(Level::G0) + order);
}

AnalyzeOptions analyzeOptionsOf(const SideMatchOptions& options, int order) {
  AnalyzeOptions analyze;
  analyze.tolerance = options.tolerance;
  analyze.level = levelOfOrder(order);
  analyze.match_mm = options.match_mm;
  return analyze;
}

RepairOptions repairOptionsOf(const SideMatchOptions& options, int order) {
  RepairOptions repair;
  repair.order = std::max(1, order);
  repair.tolerance = options.tolerance;
  repair.match_mm = options.match_mm;
  repair.fairness = options.fairness;
  repair.jobs = options.jobs;
  return repair;
}

/// The same part of a seam in a shape with the same numbers.
Seam seamIn(const TopoDS_Shape& shape, Seam seam) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE),
                                   edges = partsOf(shape, TopAbs_EDGE);
  for (const int which : {0, 1}) {
    Coedge& side = seam.sides[which];
    const int edge = seam.edges.size() == 1 ? seam.edges[0] : seam.edges[which];
    side.shape = TopoDS::Face(faces(side.face).Oriented(TopAbs_FORWARD));
    side.edge = TopoDS::Edge(edges(edge).Oriented(side.edge.Orientation()));
  }
  return seam;
}

/// The largest tolerance of the edges of a face.
double edgeTolerance_mm(const TopoDS_Shape& face) {
  double largest = 0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  return largest;
}

/// Whether the face turns back at one of the pieces.
bool folds(const std::vector<MoverPiece>& pieces) {
  // Points of a seam: a fold is one all along it, or nearly.
  constexpr int points = 16;
  return std::ranges::any_of(pieces, [](const MoverPiece& piece) {
    int folded = 0;
    for (int k = 0; k < points; ++k) {
      const PiecePoint both = piece.strips->at((k + 0.5) / points);
      if (measurePair(both.own, both.other).fold) ++folded;
    }
    return piece.order > 0 && 2 * folded > points;
  });
}

bool mayBeDeeper(MatchFault fault) {
  return fault == MatchFault::LessFair || fault == MatchFault::FoldsOver ||
         fault == MatchFault::MissesTolerance || fault == MatchFault::StillMisses ||
         fault == MatchFault::DepthTooSmall || fault == MatchFault::EdgesStray;
}

bool isFolded(const Mover& mover, const handle<Geom_BSplineSurface>& after) {
  std::array<double, 4> range{}, whole{};
  BRepTools::UVBounds(mover.face, range[0], range[1], range[2], range[3]);
  after->Bounds(whole[0], whole[1], whole[2], whole[3]);
  for (const int i : {0, 2}) {
    const bool is_periodic = i == 0 ? after->IsUPeriodic() : after->IsVPeriodic();
    if (is_periodic) continue;
    range[i] = std::max(range[i], whole[i]);
    range[i + 1] = std::min(range[i + 1], whole[i + 1]);
  }
  return differenceOf(mover.spline, after, range).folded_at.has_value();
}

/// How far a change may reach, in the order of the attempts: other edges stay within the gap
/// tolerance if they can, and otherwise where the proof accepts them.
std::vector<Reachable> attemptsOf(const SideMatchOptions& options, const TopoDS_Face& face,
                                  const std::vector<SeamResult>& seams) {
  double length_mm = 0;
  for (const SeamResult& seam : seams) length_mm += seam.length_mm;
  const double width_mm = meanWidth_mm(face, length_mm);
  std::vector<std::optional<double>> depths = {options.depth_mm};
  if (!options.depth_mm) depths = {std::nullopt, width_mm / 2, width_mm};
  // Shares of the gap tolerance: an edge runs halfway between its faces, and may be twice the
  // tolerance from them.
  constexpr std::array strays = {0.8, 3.2};
  std::vector<Reachable> all;
  for (const double stray : strays)
    for (const std::optional<double>& depth_mm : depths)
      all.push_back({depth_mm, stray * options.tolerance.gap_mm});
  return all;
}

bool reaches(const SideJoin& join, const SeamResult& seam, int order) {
  return certainlyReaches(seam.figures, join.options.tolerance, levelOfOrder(order));
}

bool isPiece(const SideJoin& join, const Seam& seam) {
  return std::ranges::any_of(join.pieces, [&](const SidePiece& piece) {
    return std::ranges::count(piece.seam.edges, seam.edges[0]) > 0;
  });
}

/// Where two faces move, they must not leave one another at free edges that lay side by side.
/// \param graph with the shared edges of the given shape alone.
MatchReason whyApart(const SideJoin& join, SeamGraph graph, const std::vector<FaceChange>& changes,
                     const TopoDS_Shape& changed, const MatchReason& how) {
  if (changes.size() < 2) return {};
  const auto moved = [&](int face) {
    return std::ranges::count(changes, face, &FaceChange::face) > 0;
  };
  const double gap_mm = join.options.tolerance.gap_mm;
  matchFreeEdges({.match_mm = join.options.match_mm, .gap_mm = gap_mm}, graph, {});
  const AnalyzeOptions options = analyzeOptionsOf(join.options, 0);
  for (const Seam& seam : graph.seams) {
    if (seam.kind != SeamKind::Matched || !moved(seam.sides[0].face) ||
        !moved(seam.sides[1].face) || isPiece(join, seam))
      continue;
    const std::optional<Figure> before = measureSeam(seam, options).figures.gap_mm,
                                after = measureSeam(seamIn(changed, seam), options).figures.gap_mm;
    if (before && after && after->lower > std::max(gap_mm, before->upper.value_or(0)))
      return match_why::neighboursApart(how, seam.edges, after->lower);
  }
  return {};
}

class SideJoiner {
 public:
  SideJoiner(const SideJoin& join, const Progress& progress)
      : join_(join),
        progress_(progress),
        graph_(findSeams(join.shape)),
        faces_(partsOf(join.shape, TopAbs_FACE)) {}

  SideJoinResult run() {
    result_.shape = join_.shape;
    bool has_levels = true;
    for (const SidePiece& piece : join_.pieces) {
      result_.before.push_back(
          measureSeam(piece.seam, analyzeOptionsOf(join_.options, piece.order)));
      has_levels = has_levels && reaches(join_, result_.before.back(), piece.order);
    }
    result_.after = result_.before;
    announce(0.1);
    if (has_levels) {
      result_.remarks = {match_why::hasLevel()};
      return result_;
    }
    result_.failure = addMovers();
    if (!result_.failure.empty()) return result_;
    if (folds(movers_.front().pieces)) {
      result_.failure = match_why::facesFold();
      return result_;
    }
    const std::vector<Reachable> attempts =
        attemptsOf(join_.options, faceOf(join_.face), result_.before);
    const std::size_t first_round = attempts.size() / 2;
    std::vector<bool> keeps_edges;
    for (std::size_t i = 0; i < attempts.size(); ++i) {
      // What no kept edge bounds comes out as before.
      if (i >= first_round && !keeps_edges[i - first_round]) continue;
      keeps_edges_ = false;
      MatchReason failure = tried(attempts[i]);
      keeps_edges.push_back(keeps_edges_);
      announce(0.1 + 0.9 * static_cast<double>(i + 1) / static_cast<double>(attempts.size()));
      // Deeper changes are fairer, and bend less; what else is wrong stays so.
      if (failure.empty()) {
        result_.failure = {};
        return result_;
      }
      const bool tells_most =
          failure.fault == MatchFault::LessFair || failure.fault == MatchFault::NeighboursApart;
      if (i == 0 || tells_most) result_.failure = failure;
      if (!mayBeDeeper(failure.fault)) break;
    }
    return result_;
  }

 private:
  void announce(double share) const {
    if (progress_ && !progress_(std::min(share, 1.0))) throw Cancelled();
  }

  TopoDS_Face faceOf(int number) const {
    return TopoDS::Face(faces_(number).Oriented(TopAbs_FORWARD));
  }

  MatchReason addMovers() {
    for (const SidePiece& piece : join_.pieces) {
      const auto strips =
          std::make_shared<const PieceStrips>(piece.seam, join_.options.tolerance.gap_mm);
      MatchReason fault = addMover(join_.face, {strips, true, piece.order});
      if (fault.empty() && join_.options.average)
        fault = addMover(piece.seam.sides[1].face, {strips, false, piece.order});
      if (!fault.empty()) return fault;
    }
    return {};
  }

  MatchReason addMover(int number, MoverPiece piece) {
    auto found = std::ranges::find(movers_, number, &Mover::number);
    if (found == movers_.end()) {
      Mover mover{number, faceOf(number), splineOf(faceOf(number)), {}};
      if (mover.spline.IsNull())
        return match_why::onFace(nameOf(join_, number), match_why::hasNoPoles(kindOf(mover.face)));
      movers_.push_back(std::move(mover));
      found = std::prev(movers_.end());
    }
    found->pieces.push_back(std::move(piece));
    return {};
  }

  MatchReason tried(const Reachable& reachable) {
    std::vector<FaceChange> changes;
    std::vector<PathChange> paths;
    result_.moves.clear();
    double depth = 0;
    for (const Mover& mover : movers_) {
      const FaceDeformation made = deformedFace(join_, mover, graph_, reachable);
      keeps_edges_ = keeps_edges_ || made.keeps_edges;
      if (!made.failure.empty()) return made.failure;
      if (made.move_mm > join_.options.max_move_mm)
        return match_why::movesTooFar(made.move_mm, join_.options.max_move_mm);
      if (isFolded(mover, made.after))
        return match_why::foldsOver(match_why::joinedInZone(made.depth_mm),
                                    nameOf(join_, mover.number));
      changes.push_back({mover.number, handle<Geom_Surface>(made.after), made.move_mm});
      if (join_.options.hold == HeldEdges::None)
        for (PathChange& path : slidPaths(join_, mover, graph_, made.after))
          paths.push_back(std::move(path));
      depth = std::max(depth, made.depth_mm);
      announce(0.1);
    }
    if (MatchReason unfair = judged(changes); !unfair.empty()) return unfair;
    return proven(changes, paths, depth);
  }

  MatchReason judged(const std::vector<FaceChange>& changes) {
    const std::vector<bool> treated(result_.before.size(), true);
    const bool to_curvature =
        std::ranges::any_of(join_.pieces, [](const SidePiece& piece) { return piece.order > 1; });
    const NeededVariation needed =
        neededVariation(join_.shape, result_.before, treated, join_.options.depth_mm, to_curvature);
    MatchReason unfair;
    for (const FaceChange& change : changes) {
      FaceMove move = judgedMove(change.face, faceOf(change.face),
                                 handle<Geom_BSplineSurface>::DownCast(change.surface),
                                 change.largest_move_mm, repairOptionsOf(join_.options, 2), needed);
      if (!move.less_fair.empty() && unfair.empty())
        unfair = match_why::lessFair(nameOf(join_, change.face), move);
      result_.moves.push_back(std::move(move));
    }
    return unfair;
  }

  MatchReason proven(const std::vector<FaceChange>& changes, const std::vector<PathChange>& paths,
                     double depth_mm) {
    const MatchReason how = match_why::joinedInZone(depth_mm);
    const TopoDS_Shape changed = withChanges(join_.shape, changes, join_.options.tolerance.gap_mm,
                                             paths, join_.options.jobs);
    std::vector<Seam> seams;
    for (const SidePiece& piece : join_.pieces) seams.push_back(seamIn(changed, piece.seam));
    std::vector<SeamResult> after;
    for (std::size_t i = 0; i < seams.size(); ++i) {
      const int order = join_.pieces[i].order;
      after.push_back(measureSeam(seams[i], analyzeOptionsOf(join_.options, order)));
      if (!reaches(join_, after.back(), order))
        return match_why::stillMisses(how, figuresText(after.back()));
    }
    if (MatchReason fault = whyDamaged(changes, changed, how); !fault.empty()) return fault;
    if (MatchReason fault = whyApart(join_, graph_, changes, changed, how); !fault.empty())
      return fault;
    result_.remarks = {how};
    if (join_.names.empty()) addWorse(changes, changed);
    result_.after = std::move(after);
    result_.shape = changed;
    result_.depth_mm = depth_mm;
    return {};
  }

  MatchReason whyDamaged(const std::vector<FaceChange>& changes, const TopoDS_Shape& changed,
                         const MatchReason& how) const {
    const TopTools_IndexedMapOfShape after = partsOf(changed, TopAbs_FACE);
    for (const FaceChange& change : changes) {
      const double now_mm = edgeTolerance_mm(after(change.face)),
                   given_mm = std::max(edgeTolerance_mm(faces_(change.face)),
                                       join_.options.tolerance.gap_mm);
      // Twice: curves on a moved surface are fitted again and need a little more than they had.
      if (now_mm > 2 * given_mm) return match_why::edgesStray(how, now_mm);
    }
    const Validity before = validityOf(join_.shape, join_.options.jobs),
                   now = validityOf(changed, join_.options.jobs);
    for (int face = 1; face <= faces_.Extent(); ++face)
      if (before.faces[face] && !now.faces[face]) return match_why::checksFail(how);
    return before.whole && !now.whole ? match_why::checksFail(how) : MatchReason{};
  }

  /// Names the other seams of the moved faces that lost a level.
  void addWorse(const std::vector<FaceChange>& changes, const TopoDS_Shape& changed) {
    const SeamGraph now = findSeams(changed);
    std::vector<int> worse;
    for (const Seam& seam : graph_.seams) {
      const bool is_beside = std::ranges::any_of(changes, [&](const FaceChange& change) {
        return seam.sides[0].face == change.face || seam.sides[1].face == change.face;
      });
      if (!is_beside || isPiece(join_, seam)) continue;
      const auto found = std::ranges::find(now.seams, seam.edges, &Seam::edges);
      if (found == now.seams.end()) continue;
      const AnalyzeOptions options = analyzeOptionsOf(join_.options, 2);
      if (measureSeam(*found, options).verdict.level < measureSeam(seam, options).verdict.level)
        worse.push_back(seam.edges[0]);
    }
    if (!worse.empty()) result_.remarks.push_back(match_why::otherSeamsWorse(worse));
  }

  const SideJoin& join_;
  const Progress& progress_;
  SeamGraph graph_;
  TopTools_IndexedMapOfShape faces_;
  std::vector<Mover> movers_;
  SideJoinResult result_;
  bool keeps_edges_ = false;  ///< of the last attempt: FaceDeformation::keeps_edges of a mover
};

}  // namespace

SideJoinResult joinSides(const SideJoin& join, const Progress& progress) {
  return SideJoiner(join, progress).run();
}

}  // namespace seamwright::occ
