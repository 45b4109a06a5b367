// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include <seamwright/core/seam/piecewise_map.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/seams/close_pieces.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>
#include <seamwright/occ_adapter/seams/rivals.hpp>

namespace seamwright::occ {

namespace {

/// Runs the step; what goes wrong in OpenCASCADE or in the geometry is a note.
void noteFailure(std::vector<std::string>& notes, const std::string& what,
                 const std::function<void()>& step) {
  try {
    step();
  } catch (const Standard_Failure& failure) {
    notes.push_back(what + ": " + failure.DynamicType()->Name() + " " + failure.GetMessageString());
  } catch (const GeometryError& error) {
    notes.push_back(what + ": " + error.what());
  }
}

/// Whether the surface of a face closes between two points of its border that are near in space.
bool surfaceClosesBetween(const EdgePath& a, const EdgePath& b, const Foot& foot) {
  const gp_Pnt2d uv_a = a.strip().parametersAt(foot.a), uv_b = b.strip().parametersAt(foot.b);
  const gp_XY middle = 0.5 * (uv_a.XY() + uv_b.XY());
  const BRepAdaptor_Surface surface(a.use().shape, false);
  const gp_Pnt between = surface.Value(middle.X(), middle.Y());
  return between.Distance(surface.Value(uv_a.X(), uv_a.Y())) >
         2 * foot.distance_mm + BRep_Tool::Tolerance(a.use().edge);
}

/// The nearest foot to a parameter of a, searched from a parameter of b.
Foot footFrom(const EdgePath& a, const EdgePath& b, double parameter_a, double start_b,
              bool against) {
  const Eigen::Vector3d p = a.strip().trace(parameter_a).p;
  const double parameter_b = b.nearest(p, start_b);
  return {parameter_a, parameter_b, (b.strip().trace(parameter_b).p - p).norm(), against};
}

class Refinement {
 public:
  Refinement(const EdgePath& a, const EdgePath& b, const MatchOptions& options)
      : a_(a), b_(b), options_(options) {}

  /// The ends and those feet between them that interpolation between the others does not give.
  std::vector<Foot> thinned(const std::vector<Foot>& feet) const;
  /// Adds feet until interpolation between them is good. \returns the largest error along b that
  /// was left, in mm, 0 if none.
  double refine(std::vector<Foot>& feet) const;
  /// Feet at the ends and the thirds of few pieces on which cubics through them are good.
  /// \returns as refine().
  double cubics(const std::vector<Foot>& feet, std::vector<Foot>& made) const;

 private:
  Foot nearFoot(const std::vector<Foot>& feet, double parameter) const;
  std::optional<double> cubicExcess_mm(const std::vector<Foot>& feet,
                                       const std::array<Foot, 4>& piece) const;
  void keepNeeded(const std::vector<Foot>& feet, std::size_t first, std::size_t last,
                  std::vector<Foot>& kept) const;
  double alongB_mm(double b, double other) const {
    return (b_.strip().trace(b).p - b_.strip().trace(other).p).norm();
  }
  /// The foot at a share of the piece between two feet.
  Foot within(const Foot& left, const Foot& right, double share) const;
  double off_mm(const Foot& left, const Foot& right, const Foot& foot, double share) const {
    return alongB_mm(left.b + share * (right.b - left.b), foot.b);
  }
  std::optional<double> excess_mm(const Foot& left, const Foot& right, const Foot& half) const;
  bool isBetween(const Foot& foot, const Foot& left, const Foot& right) const {
    return foot.b >= std::min(left.b, right.b) && foot.b <= std::max(left.b, right.b);
  }
  double allowed_mm(const Foot& foot) const {
    // A choice: half a percent is less than the two digits that reports show. The other limits are
    // for tolerances as long as the edge, and for the rounding of feet (see roundingLength()).
    const double gap_mm = std::min(options_.gap_mm, 1e-3 * b_.length_mm());
    return std::max(0.005 * std::max(gap_mm, foot.distance_mm), 1e-9 * b_.length_mm());
  }

  /// From the end of the piece before.
  struct Piece {
    Foot end;
    bool settled = false;
  };

  const EdgePath& a_;
  const EdgePath& b_;
  const MatchOptions& options_;
};

void Refinement::keepNeeded(const std::vector<Foot>& feet, std::size_t first, std::size_t last,
                            std::vector<Foot>& kept) const {
  const Foot &left = feet[first], &right = feet[last];
  std::size_t worst = first;
  double worst_excess = 1;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double share = (feet[i].a - left.a) / (right.a - left.a);
    const double excess =
        alongB_mm(left.b + share * (right.b - left.b), feet[i].b) / allowed_mm(feet[i]);
    if (excess > worst_excess) {
      worst = i;
      worst_excess = excess;
    }
  }
  if (worst == first) {
    kept.push_back(right);
    return;
  }
  keepNeeded(feet, first, worst, kept);
  keepNeeded(feet, worst, last, kept);
}

std::vector<Foot> Refinement::thinned(const std::vector<Foot>& feet) const {
  std::vector<Foot> kept = {feet.front()};
  keepNeeded(feet, 0, feet.size() - 1, kept);
  return kept;
}

Foot Refinement::within(const Foot& left, const Foot& right, double share) const {
  const double parameter = left.a + share * (right.a - left.a);
  const Foot foot = footFrom(a_, b_, parameter, left.b + share * (right.b - left.b), right.against);
  if (foot.distance_mm <= options_.match_mm) return foot;
  // A path that turns back on itself has more than one nearest point: it may have been another one.
  const auto [low, high] = std::minmax(left.b, right.b);
  std::vector<std::size_t> between(b_.pieceAt(high) - b_.pieceAt(low) + 1);
  std::iota(between.begin(), between.end(), b_.pieceAt(low));
  const Foot other = footFrom(
      a_, b_, parameter, b_.nearestOnChords(between, a_.strip().trace(parameter).p), right.against);
  return other.distance_mm < foot.distance_mm && isBetween(other, left, right) ? other : foot;
}

/// How far interpolation is off along b in mm, if that is too far; else nothing.
std::optional<double> Refinement::excess_mm(const Foot& left, const Foot& right,
                                            const Foot& half) const {
  const auto excess = [&](const Foot& foot, double share) {
    const double off = off_mm(left, right, foot, share);
    const bool needed = off > allowed_mm(foot) && isBetween(foot, left, right);
    return needed ? std::optional(off) : std::nullopt;
  };
  if (const auto off = excess(half, 0.5)) return off;
  // Of symmetric edges interpolation is right halfway, however far it is off beside. Halving a
  // piece divides its error by four, so that others are seldom that good by chance.
  constexpr double by_chance = 1.0 / 16, beside = 0.25;
  if (off_mm(left, right, half, 0.5) > by_chance * allowed_mm(half)) return std::nullopt;
  return excess(within(left, right, beside), beside);
}

double Refinement::refine(std::vector<Foot>& feet) const {
  std::vector<Piece> pieces;
  for (const Foot& foot : feet) pieces.push_back({foot, false});
  pieces.front().settled = true;
  double left_mm = 0;
  // All pieces in turn, so that none is left coarse while others take what number is allowed.
  while (std::ranges::any_of(pieces, [](const Piece& piece) { return !piece.settled; })) {
    const bool may_split = pieces.size() <= static_cast<std::size_t>(options_.most_pieces);
    std::vector<Piece> finer;
    for (const Piece& piece : pieces) {
      if (!piece.settled) {
        const Foot left = finer.back().end, half = within(left, piece.end, 0.5);
        const std::optional<double> excess = excess_mm(left, piece.end, half);
        if (excess && may_split) {
          finer.insert(finer.end(), {{half, false}, {piece.end, false}});
          continue;
        }
        left_mm = std::max(left_mm, excess.value_or(0));
      }
      finer.push_back({piece.end, true});
    }
    pieces = std::move(finer);
  }
  feet.clear();
  for (const Piece& piece : pieces) feet.push_back(piece.end);
  return left_mm;
}

/// The foot at a parameter of the first edge, near the polyline through feet.
Foot Refinement::nearFoot(const std::vector<Foot>& feet, double parameter) const {
  const auto right = std::ranges::lower_bound(feet.begin() + 1, feet.end() - 1, parameter, {},
                                              [](const Foot& foot) { return foot.a; });
  const Foot& left = *std::prev(right);
  return within(left, *right, (parameter - left.a) / (right->a - left.a));
}

/// How far the cubic is off along b in mm, if that is too far or it turns back; else nothing.
std::optional<double> Refinement::cubicExcess_mm(const std::vector<Foot>& feet,
                                                 const std::array<Foot, 4>& piece) const {
  const Foot &left = piece[0], &right = piece[3];
  const std::vector<double> a = {left.a, right.a}, b = {left.b, piece[1].b, piece[2].b, right.b};
  const PiecewiseMap cubic{a, b};
  double largest = 0;
  bool good = true;
  for (const double share : {1.0 / 6, 0.5, 5.0 / 6}) {
    const Foot foot = nearFoot(feet, left.a + share * (right.a - left.a));
    const double off_mm = alongB_mm(cubic.valueIn(0, share), foot.b);
    largest = std::max(largest, off_mm);
    good = good && off_mm <= allowed_mm(foot);
  }
  constexpr int steps = 12;
  for (int i = 0; i < steps; ++i)
    good = good && (cubic.valueIn(0, (i + 1.0) / steps) > cubic.valueIn(0, 1.0 * i / steps)) ==
                       (right.b > left.b);
  return good ? std::nullopt : std::optional(largest);
}

double Refinement::cubics(const std::vector<Foot>& feet, std::vector<Foot>& made) const {
  constexpr double shortest = 1e-5;  // of the range: there a path turns back on itself
  made = {feet.front()};
  std::vector<Foot> ends = {feet.back()};  // of pieces that are to come, the next one last
  double left_mm = 0;
  while (!ends.empty()) {
    const Foot left = made.back(), right = ends.back();
    const double third = (right.a - left.a) / 3;
    std::array<Foot, 4> piece = {left, nearFoot(feet, left.a + third),
                                 nearFoot(feet, right.a - third), right};
    const std::optional<double> excess = cubicExcess_mm(feet, piece);
    const bool may_split =
        made.size() / 3 + ends.size() <= static_cast<std::size_t>(options_.most_pieces);
    if (excess && may_split && right.a - left.a > shortest) {
      ends.push_back(nearFoot(feet, 0.5 * (left.a + right.a)));
      continue;
    }
    if (excess) {
      left_mm = std::max(left_mm, *excess);
      for (const int i : {1, 2}) piece[i].b = left.b + i * (right.b - left.b) / 3;
    }
    made.insert(made.end(), piece.begin() + 1, piece.end());
    ends.pop_back();
  }
  return left_mm;
}

/// s proportional to the arc length of a at the feet, of which each piece has so many.
Correspondence correspondenceOf(const std::vector<Foot>& feet, std::size_t of_piece,
                                const EdgePath& a) {
  Correspondence map;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    map.b.push_back(feet[i].b);
    if (i % of_piece != 0) continue;
    const double step = map.a.empty() ? 0 : a.lengthBetween_mm(map.a.back(), feet[i].a);
    map.s.push_back(map.s.empty() ? 0 : map.s.back() + step);
    map.a.push_back(feet[i].a);
  }
  const double length = map.s.back();
  for (double& s : map.s) s /= length;
  map.s.back() = 1;
  return map;
}

class Matcher {
 public:
  Matcher(const MatchOptions& options, SeamGraph& graph) : options_(options), graph_(graph) {}

  MatchSummary run(const Progress& progress);

 private:
  void makePaths(const Progress& progress);
  std::vector<EdgeInterval> walk(const Progress& progress);
  void walkPair(std::size_t a, std::size_t b, const ClosePieces& close,
                std::vector<EdgeInterval>& intervals);
  void addSeam(EdgeInterval& interval);
  bool coversWhole(std::size_t path, std::vector<std::pair<double, double>> ranges) const;
  void sortOut(const Settled& settled);
  std::string edgeName(std::size_t i) const { return "Edge" + std::to_string(graph_.open[i].edge); }

  const MatchOptions& options_;
  SeamGraph& graph_;
  EdgePaths paths_;
  MatchSummary summary_;
};

void Matcher::makePaths(const Progress& progress) {
  for (std::size_t i = 0; i < graph_.open.size(); ++i) {
    // Each 64th path: often enough for a progress bar, and rarely enough to cost nothing.
    if (progress && i % 64 == 0 &&
        !progress(static_cast<double>(i) / static_cast<double>(graph_.open.size())))
      throw Cancelled();
    paths_.emplace_back();
    noteFailure(graph_.notes, edgeName(i) + " can't be matched", [&] {
      requireUsable(graph_.open_uses[i]);
      auto path =
          std::make_unique<EdgePath>(graph_.open_uses[i], graph_.open[i].edge, options_.gap_mm);
      if (!(path->length_mm() > 0)) return;
      summary_.pieces += path->pieces().size();
      ++summary_.edges;
      paths_.back() = std::move(path);
    });
  }
}

void Matcher::walkPair(std::size_t a, std::size_t b, const ClosePieces& close,
                       std::vector<EdgeInterval>& intervals) {
  const EdgePath &path_a = *paths_[a], &path_b = *paths_[b];
  const double reach =
      std::min(reach_mm(path_a, options_.match_mm), reach_mm(path_b, options_.match_mm));
  for (std::vector<Foot>& feet : PairWalk(path_a, path_b, close, reach).intervals()) {
    const bool one_face = path_a.use().face == path_b.use().face;
    if (one_face && !surfaceClosesBetween(path_a, path_b, feet[feet.size() / 2])) continue;
    intervals.push_back({a, b, std::move(feet)});
  }
}

std::vector<EdgeInterval> Matcher::walk(const Progress& progress) {
  makePaths(partOf(progress, 0, 0.4));
  const auto close = findClosePieces(paths_, options_.match_mm, partOf(progress, 0.4, 0.5));
  std::vector<EdgeInterval> intervals;
  const Progress walked = partOf(progress, 0.5, 1);
  std::size_t done = 0;
  for (const auto& close_pair : close) {
    const auto& pair = close_pair.first;
    const auto& pieces = close_pair.second;
    if (walked && done++ % 64 == 0 &&
        !walked(static_cast<double>(done) / static_cast<double>(close.size())))
      throw Cancelled();
    summary_.close_pieces += pieces.size();
    noteFailure(graph_.notes,
                edgeName(pair.first) + " can't be matched with " + edgeName(pair.second),
                [&] { walkPair(pair.first, pair.second, pieces, intervals); });
  }
  return intervals;
}

void Matcher::addSeam(EdgeInterval& interval) {
  const EdgePath &a = *paths_[interval.path_a], &b = *paths_[interval.path_b];
  for (Foot* end : {&interval.feet.front(), &interval.feet.back()})
    *end = footFrom(a, b, end->a, end->b, end->against);
  const Refinement refinement(a, b, options_);
  double left_mm = 0;
  if (options_.cubic) {
    std::vector<Foot> made;
    left_mm = refinement.cubics(interval.feet, made);
    interval.feet = std::move(made);
  } else {
    interval.feet = refinement.thinned(interval.feet);
    left_mm = refinement.refine(interval.feet);
  }
  Seam seam;
  seam.id = static_cast<int>(graph_.seams.size()) + 1;
  seam.kind = SeamKind::Matched;
  seam.edges = {a.edge(), b.edge()};
  seam.sides = {a.use(), b.use()};
  seam.correspondence = correspondenceOf(interval.feet, options_.cubic ? 3 : 1, a);
  if (left_mm > 0)
    seam.note = fmt::format(
        "after {} pieces the points of the two edges still correspond only to {:.6g} mm",
        seam.correspondence.s.size() - 1, left_mm);
  graph_.seams.push_back(std::move(seam));
}

/// Whether nothing longer than the shortest seam is left between the ranges.
bool Matcher::coversWhole(std::size_t path, std::vector<std::pair<double, double>> ranges) const {
  ranges.emplace_back(1, 1);
  std::ranges::sort(ranges);
  double reached = 0;
  for (const auto& [low, high] : ranges) {
    if (paths_[path]->lengthTo_mm(low) - paths_[path]->lengthTo_mm(reached) >
        shortestSeam_mm(*paths_[path], options_.match_mm))
      return false;
    reached = std::max(reached, high);
  }
  return true;
}

/// Moves edges that are crowded to non_manifold and forgets those that are matched.
void Matcher::sortOut(const Settled& settled) {
  std::map<std::size_t, std::vector<std::pair<double, double>>> matched;
  for (const EdgeInterval& interval : settled.intervals) {
    const Foot &front = interval.front(), &back = interval.back();
    matched[interval.path_a].emplace_back(front.a, back.a);
    matched[interval.path_b].emplace_back(std::min(front.b, back.b), std::max(front.b, back.b));
  }
  std::vector<NonSeamEdge> open;
  std::vector<Coedge> open_uses;
  for (std::size_t i = 0; i < graph_.open.size(); ++i) {
    if (const auto crowd = settled.crowded.find(i); crowd != settled.crowded.end()) {
      graph_.non_manifold.push_back(
          {graph_.open[i].edge, {crowd->second.begin(), crowd->second.end()}});
    } else if (const auto ranges = matched.find(i);
               ranges == matched.end() || !coversWhole(i, ranges->second)) {
      open.push_back(graph_.open[i]);
      open_uses.push_back(graph_.open_uses[i]);
    }
  }
  graph_.open = std::move(open);
  graph_.open_uses = std::move(open_uses);
  std::ranges::sort(graph_.non_manifold, {}, &NonSeamEdge::edge);
}

MatchSummary Matcher::run(const Progress& progress) {
  Settled settled = settleRivals(walk(progress), paths_, options_.match_mm);
  std::ranges::sort(settled.intervals, {}, [](const EdgeInterval& interval) {
    return std::tuple(interval.path_a, interval.path_b, interval.front().a);
  });
  std::erase_if(settled.intervals, [&](EdgeInterval& interval) {
    const std::size_t before = graph_.seams.size();
    noteFailure(graph_.notes,
                edgeName(interval.path_a) + " can't be matched with " + edgeName(interval.path_b),
                [&] { addSeam(interval); });
    return graph_.seams.size() == before;
  });
  sortOut(settled);
  return summary_;
}

}  // namespace

MatchSummary matchFreeEdges(const MatchOptions& options, SeamGraph& graph,
                            const Progress& progress) {
  return Matcher(options, graph).run(progress);
}

}  // namespace seamwright::occ
