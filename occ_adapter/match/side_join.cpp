// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/convert/surface_kind.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/pole_moves.hpp>
#include <seamwright/occ_adapter/match/side_join.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/surface_difference.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// One side of a piece, of the face that moves.
struct MoverPiece {
  std::shared_ptr<const PieceStrips> strips;
  bool is_own = true;  ///< the face is the first one of the piece
  int order = 1;

  Eigen::Vector2d uvAt(double s) const {
    const PiecePoint point = strips->at(s);
    return is_own ? point.own_uv : point.other_uv;
  }
};

/// A face that moves, and what it has to meet.
struct Mover {
  int number = 0;
  TopoDS_Face face;
  handle<Geom_BSplineSurface> spline;
  std::vector<MoverPiece> pieces;
};

/// The number of a face for the user.
int nameOf(const SideJoin& join, int face) {
  return join.names.empty() ? face : join.names.at(static_cast<std::size_t>(face - 1));
}

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

/// The largest figure of a point as a share of its tolerance.
double shareOf(const SurfaceJet& jet, const MatchTarget& target, int order,
               const ContinuityTolerance& tolerance) {
  double share = (jet.p - target.point).norm() / tolerance.gap_mm;
  if (order < 1 || !target.normal) return share;
  const std::optional<Eigen::Vector3d> normal = unitNormal(jet);
  if (!normal) return share;
  const double sine = normal->cross(*target.normal).norm();
  share = std::max(share, std::asin(std::min(1.0, sine)) / tolerance.angle_rad);
  if (order < 2) return share;
  const Eigen::Vector3d aligned = normal->dot(*target.normal) < 0 ? -*normal : *normal;
  const Eigen::Matrix3d own = curvatureTensor(jet, aligned);
  const double largest = std::max(own.norm(), target.curvature.norm());
  if (largest < 1 / tolerance.flat_radius_mm) return share;
  return std::max(share, (own - target.curvature).norm() / largest / tolerance.curvature_rel);
}

/// A station without the parts that do not depend on the surface.
struct Place {
  Eigen::Vector2d uv, along;
  bool face_on_left = true;
  MatchTarget target;
  int order = 1;
};

/// Parameters of a piece at which a surface has to meet its targets: several in each of its knot
/// spans, and between the breaks of both sides.
std::vector<double> sharesOf(const MoverPiece& piece, const Geom_BSplineSurface& surface) {
  const SurfaceBasis basis(surface);
  // Of the path: fine enough to see the knot spans that it crosses.
  constexpr int steps = 256, least = 16, most = 1200, between_breaks = 4;
  std::vector<double> crossed = {0};
  Eigen::Vector2d before = piece.uvAt(0);
  for (int k = 1; k <= steps; ++k) {
    const Eigen::Vector2d here = piece.uvAt(static_cast<double>(k) / steps),
                          middle = (before + here) / 2;
    const Eigen::Vector2d span(spanLength(basis.u(), middle[0]), spanLength(basis.v(), middle[1]));
    crossed.push_back(crossed.back() + (here - before).cwiseQuotient(span).cwiseAbs().maxCoeff());
    before = here;
  }
  // More than a polynomial of a span has coefficients.
  const int degree = std::max(surface.UDegree(), surface.VDegree());
  const int count =
      std::clamp(static_cast<int>(std::ceil((degree + 2) * crossed.back())), least, most);
  std::vector<double> shares;
  std::size_t k = 1;
  for (int i = 0; i <= count; ++i) {
    const double wanted = crossed.back() * i / count;
    while (k < crossed.size() - 1 && crossed[k] < wanted) ++k;
    const double width = crossed[k] - crossed[k - 1];
    const double within = width > 0 ? std::clamp((wanted - crossed[k - 1]) / width, 0.0, 1.0) : 0;
    shares.push_back((static_cast<double>(k - 1) + within) / steps);
  }
  const std::vector<double> breaks = piece.strips->breaks();
  if (static_cast<int>(breaks.size()) * between_breaks < most)
    for (std::size_t i = 1; i < breaks.size(); ++i)
      for (int j = 0; j < between_breaks; ++j)
        shares.push_back(breaks[i - 1] + (breaks[i] - breaks[i - 1]) * (j + 0.5) / between_breaks);
  std::ranges::sort(shares);
  return shares;
}

MatchTarget targetAt(const MoverPiece& piece, double s, bool average) {
  return average ? piece.strips->meanAt(s) : piece.strips->otherAt(s);
}

/// The step across a path into the face, as long as a knot span divided by the degree: about the
/// distance of two rows of poles. Along a parameter line it is one of the other parameter.
Eigen::Vector2d stepInto(const SurfaceBasis& basis, const SurfaceJet& jet, const Place& place) {
  const Eigen::Vector3d way = place.along[0] * jet.u + place.along[1] * jet.v;
  const Eigen::Vector3d normal = jet.u.cross(jet.v);
  const Eigen::Vector3d into = (place.face_on_left ? 1 : -1) * normal.cross(way).normalized();
  Eigen::Vector2d step = parameterStep(jet, into);
  // A path this near to a parameter line is one, with rounding.
  constexpr double line = 1e-4;
  const Eigen::Vector2d moves(std::abs(place.along[0]) * jet.u.norm(),
                              std::abs(place.along[1]) * jet.v.norm());
  for (const int direction : {0, 1})
    if (moves[direction] < line * moves[1 - direction]) step[1 - direction] = 0;
  const Eigen::Vector2d row(spanLength(basis.u(), place.uv[0]) / basis.u().degree,
                            spanLength(basis.v(), place.uv[1]) / basis.v().degree);
  const double rows = step.cwiseQuotient(row).cwiseAbs().maxCoeff();
  return step / rows;
}

/// Stations of places; those at which the surface has no tangent plane are points only.
std::vector<Station> stationsOf(const std::vector<Place>& places,
                                const Geom_BSplineSurface& surface) {
  const SurfaceBasis basis(surface);
  const PointRows poles = polesOf(surface);
  std::vector<Station> stations;
  for (const Place& place : places) {
    const SurfaceJet jet = jetOf(basis.at(place.uv), poles);
    Station station{place.uv, Eigen::Vector2d::Zero(), place.target, place.order};
    if (degeneracy(jet, noiseOf(jet, basis)) == Degeneracy::None)
      station.step = stepInto(basis, jet, place);
    if (!station.step.allFinite() || station.step.isZero()) {
      station.step.setZero();
      station.order = 0;
    }
    stations.push_back(std::move(station));
  }
  return stations;
}

/// The path's direction in the parameter plane, for differences.
Eigen::Vector2d alongAt(const std::function<Eigen::Vector2d(double)>& uv_at, double s) {
  constexpr double step = 1e-4;
  const double before = std::max(0.0, s - step), after = std::min(1.0, s + step);
  return (uv_at(after) - uv_at(before)) / (after - before);
}

std::vector<Place> placesOn(const MoverPiece& piece, const Geom_BSplineSurface& surface,
                            bool average) {
  std::vector<Place> places;
  for (const double s : sharesOf(piece, surface)) {
    const PiecePoint point = piece.strips->at(s);
    const SidePoint& side = piece.is_own ? point.own : point.other;
    places.push_back({piece.is_own ? point.own_uv : point.other_uv,
                      alongAt([&](double t) { return piece.uvAt(t); }, s), side.face_on_left,
                      targetAt(piece, s, average), piece.order});
  }
  return places;
}

/// Makes the change of one face.
class FaceDeformation {
 public:
  FaceDeformation(const SideJoin& join, const Mover& mover, const SeamGraph& graph)
      : join_(join), mover_(mover), graph_(graph) {}

  struct Made {
    MatchReason failure;
    handle<Geom_BSplineSurface> after;
    double move_mm = 0, depth_mm = 0;
  };

  Made made(const std::optional<double>& depth_mm) const {
    // Errors fall by a power of the length of a span: what 32 parts do not reach is a
    // contradiction.
    constexpr int most_refinements = 5;
    // The other face of an averaged seam adds its own error.
    const double limit = join_.options.average ? 0.25 : 0.5;
    ZoneMaker maker(mover_.face, mover_.spline, zoneSides(),
                    {largestOrder(), join_.options.tolerance.gap_mm, depth_mm});
    Made made;
    double worst = 0;
    for (int refined = 0; refined <= most_refinements; ++refined) {
      const Zone zone = maker.zone();
      if (zone.poles.empty()) {
        made.failure = match_why::depthTooSmall(nameOf(join_, mover_.number),
                                                depth_mm.value_or(zone.depth_mm));
        return made;
      }
      std::vector<Place> places;
      for (const MoverPiece& piece : mover_.pieces)
        for (Place& place : placesOn(piece, *zone.surface, join_.options.average))
          places.push_back(std::move(place));
      const std::size_t own = places.size();
      addHeld(*zone.surface, places);
      const PoleMoves moved = movedPoles(zone, stationsOf(places, *zone.surface),
                                         closingPoints(*zone.surface, std::max(1, largestOrder())));
      made.after = moved.after;
      made.move_mm = moved.largest_mm;
      made.depth_mm = zone.depth_mm;
      places.resize(own);
      const std::vector<Eigen::Vector2d> missed = missedBy(*moved.after, places, limit, worst);
      if (missed.empty()) return made;
      if (refined == most_refinements || !maker.refine(missed)) break;
    }
    // Between the limit and the tolerance the proof decides.
    if (worst > 1) made.failure = match_why::missesTolerance(most_refinements, worst);
    return made;
  }

 private:
  int largestOrder() const {
    return std::ranges::max_element(mover_.pieces, {}, &MoverPiece::order)->order;
  }

  std::vector<ZoneSide> zoneSides() const {
    // Enough to see how far cells are from a curved side.
    constexpr int points = 128;
    std::vector<ZoneSide> sides;
    for (const MoverPiece& piece : mover_.pieces) {
      ZoneSide side;
      for (int k = 0; k <= points; ++k)
        side.uv.push_back(piece.uvAt(static_cast<double>(k) / points));
      sides.push_back(std::move(side));
    }
    return sides;
  }

  std::vector<Eigen::Vector2d> missedBy(const Geom_BSplineSurface& after,
                                        const std::vector<Place>& places, double limit,
                                        double& worst) const {
    const SurfaceBasis basis(after);
    const PointRows poles = polesOf(after);
    std::vector<Eigen::Vector2d> missed;
    worst = 0;
    for (const Place& place : places) {
      const double share = shareOf(jetOf(basis.at(place.uv), poles), place.target, place.order,
                                   join_.options.tolerance);
      worst = std::max(worst, share);
      if (share > limit) missed.push_back(place.uv);
    }
    return missed;
  }

  bool isMatched(int edge) const {
    return std::ranges::any_of(join_.pieces, [&](const SidePiece& piece) {
      return std::ranges::count(piece.seam.edges, edge) > 0;
    });
  }

  /// The coedges of the face that are not matched.
  std::vector<Coedge> otherEdges() const {
    std::vector<Coedge> others;
    std::set<int> seen;
    const auto add = [&](int edge, const Coedge& use) {
      if (use.face == mover_.number && !isMatched(edge) && seen.insert(edge).second)
        others.push_back(use);
    };
    for (const Seam& seam : graph_.seams)
      if (seam.kind == SeamKind::Shared)
        for (const Coedge& use : seam.sides) add(seam.edges[0], use);
    for (std::size_t i = 0; i < graph_.open_uses.size(); ++i)
      add(graph_.open[i].edge, graph_.open_uses[i]);
    return others;
  }

  void addHeld(const Geom_BSplineSurface& surface, std::vector<Place>& places) const {
    if (join_.options.hold == HeldEdges::None) return;
    const int order = join_.options.hold == HeldEdges::Tangent ? 1 : 0;
    // Several in each span of a path that crosses all of them.
    const int points = std::clamp(4 * (surface.NbUKnots() + surface.NbVKnots()), 32, 400);
    for (const Coedge& use : otherEdges()) {
      const FaceStrip strip(use, pcurveOf(use.edge, use.shape, join_.options.tolerance.gap_mm));
      const auto uvAt = [&](double s) {
        const gp_Pnt2d uv = strip.parametersAt(s);
        return Eigen::Vector2d(uv.X(), uv.Y());
      };
      for (int k = 0; k <= points; ++k) {
        const double s = static_cast<double>(k) / points;
        const SidePoint own = strip.at(s);
        places.push_back({uvAt(s),
                          alongAt(uvAt, s),
                          own.face_on_left,
                          {own.jet.p, unitNormal(own.jet, own.noise)},
                          order});
      }
    }
  }

  const SideJoin& join_;
  const Mover& mover_;
  const SeamGraph& graph_;
};

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
         fault == MatchFault::DepthTooSmall;
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
      has_levels = has_levels && reaches(result_.before.back(), piece.order);
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
    const std::vector<std::optional<double>> depths = depthsToTry();
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double done = static_cast<double>(i) / static_cast<double>(depths.size());
      MatchReason failure = tried(depths[i]);
      announce(0.1 + 0.9 * (done + 1 / static_cast<double>(depths.size())));
      // Deeper changes are fairer, and bend less; what else is wrong stays so.
      if (failure.empty()) {
        result_.failure = {};
        return result_;
      }
      if (i == 0 || failure.fault == MatchFault::LessFair) result_.failure = failure;
      if (!mayBeDeeper(failure.fault)) break;
    }
    return result_;
  }

 private:
  void announce(double share) const {
    if (progress_ && !progress_(std::min(share, 1.0))) throw Cancelled();
  }

  bool reaches(const SeamResult& seam, int order) const {
    return certainlyReaches(seam.figures, join_.options.tolerance, levelOfOrder(order));
  }

  std::vector<std::optional<double>> depthsToTry() const {
    if (join_.options.depth_mm) return {join_.options.depth_mm};
    double length_mm = 0;
    for (const SeamResult& seam : result_.before) length_mm += seam.length_mm;
    const double width_mm = meanWidth_mm(faceOf(join_.face), length_mm);
    return {std::nullopt, width_mm / 2, width_mm};
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

  MatchReason tried(const std::optional<double>& depth_mm) {
    std::vector<FaceChange> changes;
    result_.moves.clear();
    double depth = 0;
    for (const Mover& mover : movers_) {
      const FaceDeformation::Made made = FaceDeformation(join_, mover, graph_).made(depth_mm);
      if (!made.failure.empty()) return made.failure;
      if (made.move_mm > join_.options.max_move_mm)
        return match_why::movesTooFar(made.move_mm, join_.options.max_move_mm);
      if (isFolded(mover, made.after))
        return match_why::foldsOver(match_why::joinedInZone(made.depth_mm),
                                    nameOf(join_, mover.number));
      changes.push_back({mover.number, handle<Geom_Surface>(made.after), made.move_mm});
      depth = std::max(depth, made.depth_mm);
      announce(0.1);
    }
    if (MatchReason unfair = judged(changes); !unfair.empty()) return unfair;
    return proven(changes, depth);
  }

  MatchReason judged(const std::vector<FaceChange>& changes) {
    const std::vector<bool> treated(result_.before.size(), true);
    const NeededVariation needed =
        neededVariation(join_.shape, result_.before, treated, join_.options.depth_mm);
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

  MatchReason proven(const std::vector<FaceChange>& changes, double depth_mm) {
    const MatchReason how = match_why::joinedInZone(depth_mm);
    const TopoDS_Shape changed =
        withChanges(join_.shape, changes, join_.options.tolerance.gap_mm, {}, join_.options.jobs);
    std::vector<Seam> seams;
    for (const SidePiece& piece : join_.pieces) seams.push_back(seamIn(changed, piece.seam));
    std::vector<SeamResult> after;
    for (std::size_t i = 0; i < seams.size(); ++i) {
      const int order = join_.pieces[i].order;
      after.push_back(measureSeam(seams[i], analyzeOptionsOf(join_.options, order)));
      if (!reaches(after.back(), order))
        return match_why::stillMisses(how, figuresText(after.back()));
    }
    if (MatchReason fault = whyDamaged(changes, changed, how); !fault.empty()) return fault;
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
      const bool is_piece = std::ranges::any_of(join_.pieces, [&](const SidePiece& piece) {
        return std::ranges::count(piece.seam.edges, seam.edges[0]) > 0;
      });
      if (!is_beside || is_piece) continue;
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
};

}  // namespace

SideJoinResult joinSides(const SideJoin& join, const Progress& progress) {
  return SideJoiner(join, progress).run();
}

}  // namespace seamwright::occ
