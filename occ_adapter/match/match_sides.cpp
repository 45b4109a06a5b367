// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <seamwright/occ_adapter/blend/blend_side.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/side_join.hpp>
#include <seamwright/occ_adapter/match/to_splines.hpp>
#include <seamwright/occ_adapter/model/coordinate_rounding.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

Level levelOfMatch(int order) {
  return static_cast<Level>(static_cast<int>(Level::G0) + order);
}

/// A side with the seams that it has.
struct FoundSide {
  std::vector<Seam> seams;  ///< the face is the first side
  double length_mm = 0;     ///< of the part that has to join
  double covered_mm = 0;    ///< of the seams
};

/// Lengths of an edge's parameters on its face.
class EdgeLengths {
 public:
  EdgeLengths(const Coedge& use, double gap_mm)
      : EdgeLengths(FaceStrip(use, pcurveOf(use.edge, use.shape, gap_mm))) {}

  double length_mm() const { return arc_.length_mm(); }
  double parameterAt(double length_mm) const {
    return arc_.parameterAt(std::clamp(length_mm, 0.0, arc_.length_mm()));
  }
  double between_mm(double from, double to) const {
    return std::abs(arc_.lengthTo(to) - arc_.lengthTo(from));
  }

 private:
  explicit EdgeLengths(const FaceStrip& strip)
      : arc_([&](double parameter) { return strip.trace(parameter).d.norm(); }, strip.breaks()) {}

  PathLength arc_;
};

class SideFinder {
 public:
  SideFinder(const TopoDS_Shape& model, int face, const SideMatchOptions& options,
             const Progress& progress)
      : model_(model), face_(face), options_(options), graph_(findSeams(model)) {
    matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph_,
                   progress);
  }

  FoundSide find(const SideMatch& match) const {
    bool closed = false;
    const HoleSide side = chosenSide(
        model_, {.edges = match.side.edges, .faces = {face_}, .name = match.side.name}, closed);
    std::vector<EdgeLengths> lengths;
    double whole_mm = 0;
    for (const HoleEdge& edge : side.edges) {
      lengths.emplace_back(edge.use, options_.tolerance.gap_mm);
      whole_mm += lengths.back().length_mm();
    }
    FoundSide found;
    found.length_mm = (match.to - match.from) * whole_mm;
    double begin_mm = 0;
    for (std::size_t k = 0; k < side.edges.size(); ++k) {
      const HoleEdge& edge = side.edges[k];
      double low_mm = match.from * whole_mm - begin_mm, high_mm = match.to * whole_mm - begin_mm;
      begin_mm += lengths[k].length_mm();
      if (edge.reversed) {
        std::swap(low_mm, high_mm);
        low_mm = lengths[k].length_mm() - low_mm;
        high_mm = lengths[k].length_mm() - high_mm;
      }
      if (high_mm <= 0 || low_mm >= lengths[k].length_mm()) continue;
      addSeams(edge, match, lengths[k].parameterAt(low_mm), lengths[k].parameterAt(high_mm),
               lengths[k], found);
    }
    return found;
  }

 private:
  void addSeams(const HoleEdge& edge, const SideMatch& match, double from, double to,
                const EdgeLengths& lengths, FoundSide& found) const {
    for (const Seam& any : graph_.seams) {
      if (any.kind == SeamKind::Closed || std::ranges::count(any.edges, edge.edge) == 0) continue;
      if (any.sides[0].face != face_ && any.sides[1].face != face_) continue;
      if (any.sides[0].face == any.sides[1].face) continue;
      const Seam own = withFirst(any, face_);
      if (own.edges.front() != edge.edge) continue;
      const bool is_wanted =
          match.neighbours.empty() || std::ranges::any_of(own.edges, [&](int number) {
            return std::ranges::count(match.neighbours, number) > 0;
          });
      if (!is_wanted) continue;
      const std::optional<Seam> part = partOfSeam(own, from, to);
      if (!part) continue;
      const std::vector<double>& shares = part->correspondence.a;
      found.covered_mm +=
          shares.empty() ? lengths.length_mm() : lengths.between_mm(shares.front(), shares.back());
      found.seams.push_back(*part);
    }
  }

  const TopoDS_Shape& model_;
  int face_;
  const SideMatchOptions& options_;
  SeamGraph graph_;
};

/// What one call has to do.
struct Found {
  std::vector<SidePiece> pieces;
  std::vector<MatchedSeam> seams;
  std::vector<MatchReason> remarks, failures;
};

Found found(const TopoDS_Shape& model, int face, const std::vector<SideMatch>& sides,
            const SideMatchOptions& options, const Progress& progress) {
  const SideFinder finder(model, face, options, progress);
  Found all;
  std::set<int> edges;
  for (const SideMatch& side : sides) {
    for (const int edge : side.side.edges)
      if (!edges.insert(edge).second)
        throw std::invalid_argument(fmt::format("edge {} is in two sides", edge));
    const FoundSide there = finder.find(side);
    if (there.seams.empty()) {
      match_why::add(all.failures, match_why::sideIsFree(side.side.edges, options.match_mm));
      continue;
    }
    // What is shorter is not a seam by itself, and may be left out.
    const double left_out_mm = 4 * options.match_mm;
    if (there.covered_mm < there.length_mm - left_out_mm)
      match_why::add(all.remarks,
                     match_why::sidePartlyMet(side.side.edges, there.covered_mm, there.length_mm));
    for (const Seam& seam : there.seams) {
      all.pieces.push_back({seam, side.order});
      all.seams.push_back({side.side.name, {}, {}, levelOfMatch(side.order)});
    }
  }
  return all;
}

/// The faces that have to move.
std::vector<int> moversOf(int face, const std::vector<SidePiece>& pieces, bool average) {
  std::set<int> movers = {face};
  if (average)
    for (const SidePiece& piece : pieces) movers.insert(piece.seam.sides[1].face);
  return {movers.begin(), movers.end()};
}

/// The largest number of places in the model of a face, or of an edge of it.
int placesOf(const TopoDS_Shape& model, int face) {
  int most = 0;
  for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE}) {
    const TopTools_IndexedMapOfShape all = partsOf(model, kind),
                                     own = partsOf(partsOf(model, TopAbs_FACE)(face), kind);
    for (int i = 1; i <= own.Extent(); ++i) {
      int places = 0;
      for (int k = 1; k <= all.Extent(); ++k)
        if (all(k).IsPartner(own(i))) ++places;
      most = std::max(most, places);
    }
  }
  return most;
}

void match(const TopoDS_Shape& model, int face, const std::vector<SideMatch>& sides,
           const SideMatchOptions& options, const Progress& progress, SideMatchReport& report) {
  Found all = found(model, face, sides, options, partOf(progress, 0, 0.1));
  report.remarks = all.remarks;
  report.failures = all.failures;
  report.seams = all.seams;
  for (const int mover : moversOf(face, all.pieces, options.average))
    if (const int places = placesOf(model, mover); places > 1)
      match_why::add(report.failures, match_why::faceInstances(mover, places));
  if (!report.failures.empty()) return;
  SideJoin join{model, face, {}, all.pieces, options};
  std::vector<MatchReason> converted;
  if (options.convert) {
    ConvertedModel splines =
        withSplines(model, moversOf(face, all.pieces, options.average), options.tolerance.gap_mm);
    converted = std::move(splines.remarks);
    join.shape = splines.shape;
    if (!converted.empty()) join.pieces = found(join.shape, face, sides, options, {}).pieces;
  }
  const SideJoinResult joined = joinSides(join, partOf(progress, 0.1, 1));
  for (std::size_t i = 0; i < joined.before.size() && i < report.seams.size(); ++i) {
    report.seams[i].before = joined.before[i];
    report.seams[i].after = joined.after[i];
  }
  report.moves = joined.moves;
  report.depth_mm = joined.depth_mm;
  report.matched = joined.failure.empty();
  match_why::add(report.failures, joined.failure);
  if (!report.matched) return;
  for (const MatchReason& remark : joined.remarks) match_why::add(report.remarks, remark);
  // Nothing had to move: the given faces stay.
  if (joined.moves.empty()) return;
  for (const MatchReason& remark : converted) match_why::add(report.remarks, remark);
  report.shape = joined.shape;
}

void requirePositive(const char* what, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw std::invalid_argument(
        fmt::format("{} is {:.6g} mm: it must be positive and finite", what, value));
}

void validate(const SideMatch& side) {
  if (side.order < 0 || side.order > 2)
    throw std::invalid_argument(fmt::format("order is {}: it must be 0 to 2", side.order));
  if (!(side.from >= 0 && side.from < side.to && side.to <= 1))
    throw std::invalid_argument(
        fmt::format("the part of the side is {:.6g} to {:.6g}: it must be a part of 0 to 1",
                    side.from, side.to));
}

}  // namespace

void SideMatchOptions::validate() const {
  tolerance.validate();
  SurfaceTolerance{fairness, 0}.validate();
  if (depth_mm) requirePositive("the depth", *depth_mm);
  requirePositive("the distance to match", match_mm);
  if (!(max_move_mm >= 0))
    throw std::invalid_argument(
        fmt::format("largest move is {:.6g} mm: it must be zero or larger", max_move_mm));
}

std::string SideMatchReport::code() const {
  return failures.empty() ? std::string() : codeOf(failures.front().fault);
}

std::string SideMatchReport::remedy() const {
  return failures.empty() ? std::string() : remedyOf(failures.front().fault);
}

std::string SideMatchReport::text() const {
  return match_why::textOf(remarks, failures);
}

SideMatchReport matchSides(const TopoDS_Shape& model, int face, const std::vector<SideMatch>& sides,
                           const SideMatchOptions& options, const Progress& progress) {
  options.validate();
  requireAboveRounding("gap tolerance", options.tolerance.gap_mm, model);
  if (options.match_mm > 0) requireAboveRounding("distance to match", options.match_mm, model);
  requireFace(face, model.IsNull() ? 0 : partsOf(model, TopAbs_FACE).Extent());
  if (sides.empty()) throw std::invalid_argument("a match needs a side");
  for (const SideMatch& side : sides) validate(side);
  SideMatchReport report;
  report.shape = model;
  if (const std::string fault = UnusableParts(model).whyLeftOut(face); !fault.empty()) {
    report.failures = {match_why::faceUnusable(face, fault)};
    return report;
  }
  try {
    match(model, face, sides, options, progress, report);
  } catch (const Standard_Failure& failure) {
    match_why::add(report.failures, match_why::openCascadeFailed(failure));
  } catch (const GeometryError& error) {
    match_why::add(report.failures, match_why::failed(error.what()));
  }
  if (progress && !progress(1)) throw Cancelled();
  return report;
}

}  // namespace seamwright::occ
