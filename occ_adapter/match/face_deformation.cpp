// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/match/face_deformation.hpp>
#include <seamwright/occ_adapter/match/kept_edges.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/pole_moves.hpp>
#include <seamwright/occ_adapter/match/zone.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

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

  /// Points into the face, so that at a knot the polynomials of the face's side count.
  Eigen::Vector2d into() const {
    return face_on_left ? Eigen::Vector2d(-along[1], along[0])
                        : Eigen::Vector2d(along[1], -along[0]);
  }
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
    const SurfaceJet jet = jetOf(basis.at(place.uv, place.into()), poles);
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

/// Whether the face does not cross the knot line, so that nothing there is seen.
bool isBeyond(const ClosingPoints& points, const Zone& zone) {
  const int direction = points.direction;
  const bool is_periodic =
      direction == 0 ? zone.surface->IsUPeriodic() : zone.surface->IsVPeriodic();
  if (is_periodic || points.uv != points.other_uv) return false;
  const double low = zone.low[direction], high = zone.high[direction],
               near = Precision::PConfusion() * (high - low), at = points.uv[direction];
  return at <= low + near || at >= high - near;
}

/// Makes the change of one face.
class Deformer {
 public:
  Deformer(const SideJoin& join, const Mover& mover, const SeamGraph& graph)
      : join_(join), mover_(mover), graph_(graph) {}

  FaceDeformation made(const Reachable& reachable) const {
    // Errors fall by a power of the length of a span: what 32 parts do not reach is a
    // contradiction.
    constexpr int most_refinements = 5;
    ZoneMaker maker(mover_.face, mover_.spline, zoneSides(),
                    {largestOrder(), join_.options.tolerance.gap_mm, reachable.depth_mm});
    KeptEdges kept;
    if (join_.options.hold == HeldEdges::None) kept = keptEdges(join_, mover_, graph_);
    FaceDeformation made;
    for (int refined = 0; refined <= most_refinements; ++refined) {
      const Zone zone = maker.zone();
      if (zone.poles.empty()) {
        made.failure = match_why::depthTooSmall(nameOf(join_, mover_.number),
                                                reachable.depth_mm.value_or(zone.depth_mm));
        return made;
      }
      const std::vector<Eigen::Vector2d> missed =
          solve(zone, most_refinements - refined, reachable.stray_mm, kept, made);
      made.keeps_edges = kept.weight > 0;
      if (missed.empty()) return made;
      if (refined == most_refinements || !maker.refine(missed)) break;
    }
    // Between the limit and the tolerance the proof decides.
    if (made.worst > 1) made.failure = match_why::missesTolerance(most_refinements, made.worst);
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

  /// Moves the poles of the zone. Kept edges weigh more until they stray no further than allowed.
  /// \returns where more knots are needed.
  std::vector<Eigen::Vector2d> solve(const Zone& zone, int refinements_left, double stray_mm,
                                     KeptEdges& kept, FaceDeformation& made) const {
    // The other face of an averaged seam adds its own error.
    const double limit = join_.options.average ? 0.25 : 0.5;
    const bool is_last = refinements_left == 0;
    const Nearness nearness{.limit = limit, .most_growth = is_last ? 30.0 : 3.0};
    constexpr double first_weight = 100, growth = 10, most_weight = 1e8;
    std::vector<Place> places;
    for (const MoverPiece& piece : mover_.pieces)
      for (Place& place : placesOn(piece, *zone.surface, join_.options.average))
        places.push_back(std::move(place));
    const std::size_t own = places.size();
    addHeld(*zone.surface, places);
    const std::vector<Station> stations = stationsOf(places, *zone.surface);
    std::vector<ClosingPoints> closing = closingPoints(*zone.surface, std::max(1, largestOrder()));
    std::erase_if(closing, [&zone](const ClosingPoints& points) { return isBeyond(points, zone); });
    kept.size_mm = zone.depth_mm;
    made.depth_mm = zone.depth_mm;
    made.worst = std::numeric_limits<double>::infinity();
    PoleSolver solver(zone, stations, closing, kept);
    std::vector<double> shares;
    const auto worstOf = [&](const std::vector<SurfaceJet>& jets) {
      shares = sharesOf(jets, stations, own);
      return *std::ranges::max_element(shares);
    };
    for (bool is_first = true;; is_first = false) {
      const PoleMoves moved = solver.solved(kept.weight, worstOf, nearness);
      const double now = worstOf(solver.jetsOf(polesOf(*moved.after))),
                   now_mm = strayOf_mm(kept, *zone.surface, *moved.after);
      // What edges keep must not cost the join, unless more knots may give both.
      const bool conflicts = !is_first && now > limit && now > made.worst;
      if (conflicts && is_last) break;
      made.after = moved.after;
      made.move_mm = moved.largest_mm;
      made.worst = now;
      const bool is_met = now <= limit || is_last;
      if (conflicts || !is_met || now_mm <= stray_mm || kept.weight >= most_weight) break;
      kept.weight = std::max(first_weight, kept.weight * std::max(growth, now_mm / stray_mm));
    }
    worstOf(solver.jetsOf(polesOf(*made.after)));
    std::vector<Eigen::Vector2d> missed;
    for (std::size_t i = 0; i < own; ++i)
      if (shares[i] > limit) missed.push_back(stations[i].uv);
    return missed;
  }

  /// The largest figure of each of the first stations as a share of its tolerance.
  std::vector<double> sharesOf(const std::vector<SurfaceJet>& jets,
                               const std::vector<Station>& stations, std::size_t count) const {
    std::vector<double> shares;
    for (std::size_t i = 0; i < count; ++i)
      shares.push_back(
          shareOf(jets[i], stations[i].target, stations[i].order, join_.options.tolerance));
    return shares;
  }

  void addHeld(const Geom_BSplineSurface& surface, std::vector<Place>& places) const {
    if (join_.options.hold == HeldEdges::None) return;
    const int order = join_.options.hold == HeldEdges::Tangent ? 1 : 0;
    // Several in each span of a path that crosses all of them.
    const int points = std::clamp(4 * (surface.NbUKnots() + surface.NbVKnots()), 32, 400);
    for (const Coedge& use : otherEdges(join_, mover_, graph_)) {
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

}  // namespace

FaceDeformation deformedFace(const SideJoin& join, const Mover& mover, const SeamGraph& graph,
                             const Reachable& reachable) {
  return Deformer(join, mover, graph).made(reachable);
}

}  // namespace seamwright::occ
