// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/tridiagonal.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

using std::numbers::pi;

/// The polygon of the points: chords and the turns between them.
struct Polygon {
  bool closed = false;
  Eigen::VectorXd chords_mm, chord_directions_rad;  ///< by segment
  Eigen::VectorXd turns_rad;                        ///< by point; 0 at open ends

  Index points() const { return turns_rad.size(); }
  Index segments() const { return chords_mm.size(); }
  Index next(Index point) const { return (point + 1) % points(); }
};

Eigen::Vector2d vectorAt(const PlanarPoints& points, Index i) {
  return points.row(i).transpose();
}

void requireDistinct(const PlanarPoints& points, bool closed) {
  const Index least = closed ? 3 : 2;
  if (points.rows() < least)
    refuse(fmt::format("{} points: at least {} are needed", points.rows(), least));
  for (Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) refuse(fmt::format("point {} is not finite", i));
    const Index next = (i + 1) % points.rows();
    if ((closed || next > 0) && points.row(i) == points.row(next))
      refuse(
          fmt::format("points {} and {} are equal: ({}, {})", i, next, points(i, 0), points(i, 1)));
  }
}

Polygon polygonOf(const PlanarPoints& points, bool closed) {
  requireDistinct(points, closed);
  const Index segments = points.rows() - (closed ? 0 : 1);
  Polygon polygon{.closed = closed,
                  .chords_mm = Eigen::VectorXd(segments),
                  .chord_directions_rad = Eigen::VectorXd(segments),
                  .turns_rad = Eigen::VectorXd::Zero(points.rows())};
  for (Index s = 0; s < segments; ++s) {
    const Eigen::Vector2d chord = vectorAt(points, (s + 1) % points.rows()) - vectorAt(points, s);
    polygon.chords_mm(s) = chord.norm();
    polygon.chord_directions_rad(s) = directionOf(chord);
  }
  for (Index i = closed ? 0 : 1; i < segments; ++i) {
    const Index before = (i + segments - 1) % segments;
    polygon.turns_rad(i) =
        wrapped(polygon.chord_directions_rad(i) - polygon.chord_directions_rad(before));
    // The sense of a turn by pi is rounding. The margin is far above the rounding of a direction
    // (some 1e-16), and far below any turn that is meant.
    constexpr double reversal_rad = pi - 1e-9;
    if (std::abs(polygon.turns_rad(i)) > reversal_rad)
      throw std::domain_error(fmt::format("the polygon reverses its direction at ({:.6g}, {:.6g})",
                                          points(i, 0), points(i, 1)));
  }
  return polygon;
}

/// The unknowns are the angles alpha at the points: from the tangent at a point to the chord after
/// it; at the last point of an open curve to the chord before it, so it is -beta there.
TridiagonalEquations equationsOf(const Polygon& polygon) {
  return TridiagonalEquations(polygon.points(), polygon.closed);
}

/// The quadratic form a (alpha^2 + beta^2) + b (alpha - beta)^2 of a segment.
struct SegmentForm {
  double size = 0;        ///< a
  double difference = 0;  ///< b
};

SegmentForm formOf(const TangentOptions& options, double chord_mm) {
  if (options.rule == TangentRule::NearCircles) return {.size = 0, .difference = 1};
  return {.size = 1 / chord_mm, .difference = options.lambda / chord_mm};
}

/// The angle at the start against the chord p to q, of the circle through p, q and r.
double circleAngle(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
  return angleFromTo(p - r, q - r);
}

/// The alpha of an end that is given, or that the rule takes from a circle.
struct EndAngles {
  std::optional<double> start, end;
};

EndAngles endAngles(const PlanarPoints& points, const Polygon& polygon,
                    const TangentOptions& options) {
  if (polygon.closed) return {};
  EndAngles angles;
  const Index last = polygon.segments() - 1, n = points.rows() - 1;
  if (options.start_direction_rad)
    angles.start = wrapped(polygon.chord_directions_rad(0) - *options.start_direction_rad);
  else if (options.rule == TangentRule::NearCircles)
    angles.start =
        n > 1 ? circleAngle(vectorAt(points, 0), vectorAt(points, 1), vectorAt(points, 2)) : 0;
  if (options.end_direction_rad)
    angles.end = wrapped(polygon.chord_directions_rad(last) - *options.end_direction_rad);
  else if (options.rule == TangentRule::NearCircles)
    angles.end =
        n > 1 ? circleAngle(vectorAt(points, n), vectorAt(points, n - 1), vectorAt(points, n - 2))
              : 0;
  return angles;
}

/// The minimum of a sum of quadratic forms of the segments. With the turn D at the end of a segment
/// beta = D - alpha of the next point.
Eigen::VectorXd linearAngles(const PlanarPoints& points, const Polygon& polygon,
                             const TangentOptions& options) {
  TridiagonalEquations equations = equationsOf(polygon);
  for (Index s = 0; s < polygon.segments(); ++s) {
    const auto [size, difference] = formOf(options, polygon.chords_mm(s));
    const Index next = polygon.next(s);
    const double turn = polygon.turns_rad(next);
    equations.add(s, 0, size + difference, difference, difference * turn);
    equations.add(next, difference, size + difference, 0, (size + difference) * turn);
  }
  const EndAngles ends = endAngles(points, polygon, options);
  if (ends.start) equations.give(0, *ends.start);
  if (ends.end) equations.give(polygon.points() - 1, *ends.end);
  return std::move(equations).solve();
}

/// k sqrt(s) of the arcs of a biarc with equal chords on a chord of length 1, and derivatives by
/// alpha and beta: the squares add up to its bending energy.
struct ArcResiduals {
  Eigen::Vector2d value;
  Eigen::Matrix2d derivative;  ///< row: arc; column: alpha, beta
};

ArcResiduals residualsOf(double alpha, double beta) {
  // Each arc turns by t and has the chord q = 1 / (2 cos(sigma / 2)), sigma = (alpha + beta) / 2.
  const double sigma = (alpha + beta) / 2;
  const double inverse_root = std::sqrt(2 * std::cos(sigma / 2));       // 1 / sqrt(q)
  const double root_slope = -std::sin(sigma / 2) / (4 * inverse_root);  // by alpha, and by beta
  const auto arc = [&](double t) {
    const double root = std::sqrt(sinc(t / 2));
    const double slope = root + t * sincSlope(t / 2) / (4 * root);
    return std::pair(t * root, slope);
  };
  const auto [first, first_slope] = arc((3 * alpha - beta) / 2);
  const auto [second, second_slope] = arc((3 * beta - alpha) / 2);
  ArcResiduals result;
  result.value << first * inverse_root, second * inverse_root;
  result.derivative << 1.5 * first_slope * inverse_root + first * root_slope,
      -0.5 * first_slope * inverse_root + first * root_slope,
      -0.5 * second_slope * inverse_root + second * root_slope,
      1.5 * second_slope * inverse_root + second * root_slope;
  return result;
}

/// beta of a segment.
double endAngle(const Polygon& polygon, const Eigen::VectorXd& alpha, Index s) {
  const Index next = polygon.next(s);
  return polygon.turns_rad(next) - alpha(next);
}

void requireSmallAngles(const PlanarPoints& points, const Polygon& polygon,
                        const Eigen::VectorXd& alpha) {
  // A choice: a tangent farther from its chord gives a loop rather than a curve along the points.
  constexpr double largest_rad = 2 * pi / 3;
  for (Index s = 0; s < polygon.segments(); ++s)
    for (const double angle : {alpha(s), endAngle(polygon, alpha, s)})
      if (std::abs(angle) > largest_rad)
        throw std::domain_error(fmt::format(
            "a tangent between the points ({:.6g}, {:.6g}) and ({:.6g}, {:.6g}) is {:.0f} degrees "
            "off their chord, more than {:.0f}: insert a point",
            points(s, 0), points(s, 1), points(polygon.next(s), 0), points(polygon.next(s), 1),
            std::abs(angle) * degrees_per_radian, largest_rad * degrees_per_radian));
}

double energyOf(const Polygon& polygon, const Eigen::VectorXd& alpha) {
  double sum = 0;
  for (Index s = 0; s < polygon.segments(); ++s)
    sum += residualsOf(alpha(s), endAngle(polygon, alpha, s)).value.squaredNorm() /
           polygon.chords_mm(s);
  return sum;
}

/// The change of the angles in one Gauss-Newton step.
Eigen::VectorXd energyStep(const Polygon& polygon, const Eigen::VectorXd& alpha,
                           const EndAngles& ends) {
  TridiagonalEquations equations = equationsOf(polygon);
  for (Index s = 0; s < polygon.segments(); ++s) {
    const ArcResiduals arcs = residualsOf(alpha(s), endAngle(polygon, alpha, s));
    Eigen::Matrix2d by_angles = arcs.derivative;
    by_angles.col(1) *= -1;  // beta falls as alpha of the next point grows
    const Eigen::Matrix2d normal = by_angles.transpose() * by_angles / polygon.chords_mm(s);
    const Eigen::Vector2d right = -by_angles.transpose() * arcs.value / polygon.chords_mm(s);
    equations.add(s, 0, normal(0, 0), normal(0, 1), right(0));
    equations.add(polygon.next(s), normal(1, 0), normal(1, 1), 0, right(1));
  }
  if (ends.start) equations.give(0, 0);
  if (ends.end) equations.give(polygon.points() - 1, 0);
  return std::move(equations).solve();
}

/// Gauss-Newton steps, each halved until the energy does not grow by more than rounding.
int minimiseEnergy(const Polygon& polygon, const EndAngles& ends, Eigen::VectorXd& alpha) {
  // Bounds against endless loops: steps may converge only linearly, since residuals do not vanish,
  // and 20 halvings leave a millionth of a step. What is reached at the bounds is a usable result.
  constexpr int most_steps = 50, most_halvings = 20;
  // Angles have a rounding of some 2e-16, which sums over neighbours raise; the energy is a sum of
  // squares with some roundings each.
  constexpr double smallest_step_rad = 1e-13, rounding = 16 * machine_epsilon;
  double energy = energyOf(polygon, alpha);
  for (int taken = 0; taken < most_steps; ++taken) {
    Eigen::VectorXd step = energyStep(polygon, alpha, ends);
    if (step.cwiseAbs().maxCoeff() < smallest_step_rad) return taken;
    int halvings = 0;
    while (!(energyOf(polygon, alpha + step) <= energy * (1 + rounding))) {
      if (++halvings > most_halvings) return taken;
      step /= 2;
    }
    alpha += step;
    energy = energyOf(polygon, alpha);
  }
  return most_steps;
}

void requireOptions(const TangentOptions& options) {
  if (!(options.lambda >= 0 && std::isfinite(options.lambda)))
    refuse(
        fmt::format("the weight of the variation (lambda) is {}: it must be finite and at least 0",
                    options.lambda));
  for (const std::optional<double>& direction :
       {options.start_direction_rad, options.end_direction_rad}) {
    if (!direction) continue;
    if (options.closed) refuse("a closed curve has no end directions");
    if (!std::isfinite(*direction)) refuse(fmt::format("an end direction is {}", *direction));
  }
}

}  // namespace

Tangents tangentsAt(const PlanarPoints& points, const TangentOptions& options) {
  requireOptions(options);
  const Polygon polygon = polygonOf(points, options.closed);
  Eigen::VectorXd alpha = linearAngles(points, polygon, options);
  requireSmallAngles(points, polygon, alpha);
  Tangents result;
  if (options.rule == TangentRule::Energy) {
    result.steps = minimiseEnergy(polygon, endAngles(points, polygon, options), alpha);
    requireSmallAngles(points, polygon, alpha);
  }
  for (Index i = 0; i < polygon.points(); ++i) {
    const Index segment = std::min(i, polygon.segments() - 1);
    result.directions_rad.push_back(wrapped(polygon.chord_directions_rad(segment) - alpha(i)));
  }
  return result;
}

BiarcSpline biarcSpline(const PlanarPoints& points, const TangentOptions& options, BiarcRule rule) {
  BiarcSpline spline;
  spline.directions_rad = tangentsAt(points, options).directions_rad;
  spline.closed = options.closed;
  const Index count = points.rows();
  for (Index s = 0; s < count - (options.closed ? 0 : 1); ++s) {
    const Index next = (s + 1) % count;
    const Biarc arcs = biarc(HermiteEnds{.start = vectorAt(points, s),
                                         .start_direction_rad = spline.directions_rad[s],
                                         .end = vectorAt(points, next),
                                         .end_direction_rad = spline.directions_rad[next]},
                             rule);
    spline.arcs.push_back(arcs.first);
    spline.arcs.push_back(arcs.second);
  }
  spline.energy_per_mm = bendingEnergy_per_mm(spline.arcs);
  return spline;
}

double bendingEnergy_per_mm(const std::vector<PlanarArc>& arcs) {
  double sum = 0;
  for (const PlanarArc& arc : arcs)
    sum += arc.curvature_per_mm * arc.curvature_per_mm * arc.length_mm;
  return sum;
}

BezierSpline bezierSpline(const std::vector<PlanarArc>& arcs, bool closed, double gap_mm) {
  std::vector<BezierCurve> segments;
  std::vector<double> knots = {0};
  for (const PlanarArc& arc : arcs) {
    const std::vector<BezierCurve> pieces = bezierCurves(arc);
    const double before_mm = knots.back();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      segments.push_back(pieces[i]);
      knots.push_back(before_mm + arc.length_mm * static_cast<double>(i + 1) /
                                      static_cast<double>(pieces.size()));
    }
  }
  return bezierSpline(segments, knots, closed, gap_mm);
}

}  // namespace seamwright
