// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic_pair.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The C-shape on the chord from (0, 0) to (1, 0), turning to the left.
struct UnitPair {
  double alpha = 0, beta = 0;           ///< angles at start and end against the chord
  double start_edge = 0, end_edge = 0;  ///< from the ends to the apex
  double start_curvature = 0, end_curvature = 0;

  double turn() const { return alpha + beta; }
  Vector2d apex() const { return start_edge * unitVector(-alpha); }
};

/// Where the tangent at the joint cuts both edges: shares from the ends.
struct JointTangent {
  double start_share = 0, end_share = 0;

  bool inside() const {
    return start_share > 0 && start_share < 1 && end_share > 0 && end_share < 1;
  }
};

/// The tangent at which the direction has turned by \p turn. With the scale 1 the triangles it
/// cuts off are those of a biarc: the edges beside the joint are as long as the outer ones.
JointTangent jointTangent(const UnitPair& pair, double turn, double scale) {
  const double rest = pair.turn() - turn, whole = std::sin(pair.turn());
  const double edge =
      scale * (pair.start_edge + pair.end_edge) / (1 + (std::sin(turn) + std::sin(rest)) / whole);
  return {.start_share = 1 - edge * std::sin(rest) / whole / pair.start_edge,
          .end_share = 1 - edge * std::sin(turn) / whole / pair.end_edge};
}

std::array<PlanarConic, 2> conicsWith(const UnitPair& pair, const JointTangent& tangent) {
  return twoConics({.start = Vector2d::Zero(),
                    .apex = pair.apex(),
                    .end = Vector2d::UnitX(),
                    .start_curvature_per_mm = pair.start_curvature,
                    .end_curvature_per_mm = pair.end_curvature,
                    .start_share = tangent.start_share,
                    .end_share = tangent.end_share});
}

/// How good a pair is.
struct PairQuality {
  int extrema = 0;
  double unevenness = 0;  ///< the integral of the squared slope of the curvature, about
};

/// Rises and falls of the curvature along the pieces.
struct CurvatureCourse {
  PairQuality quality;
  int last_sign = 0;

  void go(int sign) {
    quality.extrema += sign * last_sign < 0;
    last_sign = sign;
  }
  void add(const PlanarConic& conic) {
    constexpr int parts = 4;
    const double part_length =
        ((conic.corner - conic.start).norm() + (conic.end - conic.corner).norm()) / parts;
    double before = conic.startCurvature_per_mm(), least = before, largest = before;
    const double start = before;
    for (int i = 1; i <= parts; ++i) {
      const double k = i == parts ? conic.endCurvature_per_mm()
                                  : conic.curvatureAt_per_mm(static_cast<double>(i) / parts);
      quality.unevenness += (k - before) * (k - before) / part_length;
      least = std::min(least, k);
      largest = std::max(largest, k);
      before = k;
    }
    // Rounding makes no extrema of a circle.
    constexpr double same = 1e-9;
    if (largest - least <= same * largest) return;
    const int trend = before > start ? 1 : -1;
    switch (curvatureKind(conic)) {
      case ConicCurvature::Monotone:
        go(trend);
        break;
      case ConicCurvature::OneMaximum:
        go(1), go(-1);
        break;
      case ConicCurvature::OneMinimum:
        go(-1), go(1);
        break;
      case ConicCurvature::MaximumAndMinimum:
        go(trend), go(-trend), go(trend);
        break;
    }
  }
};

PairQuality qualityOf(const std::array<PlanarConic, 2>& conics) {
  CurvatureCourse course;
  for (const PlanarConic& conic : conics) course.add(conic);
  return course.quality;
}

/// Whether the first pair is better by more than rounding.
bool isBetter(const PairQuality& one, const PairQuality& other) {
  constexpr double clearly = 1 - 1e-9;
  if (one.extrema != other.extrema) return one.extrema < other.extrema;
  return one.unevenness < clearly * other.unevenness;
}

/// The best of the pairs with the tangents that it is shown; the first one stays if none is better.
class BestPair {
 public:
  explicit BestPair(const UnitPair& pair) : pair_(pair) {}

  void consider(const JointTangent& tangent) {
    const std::array<PlanarConic, 2> conics = conicsWith(pair_, tangent);
    const PairQuality own = qualityOf(conics);
    if (best_ && !isBetter(own, quality_)) return;
    best_ = ConicPair{.conics = conics, .extrema = own.extrema};
    quality_ = own;
  }
  const std::optional<ConicPair>& best() const { return best_; }

 private:
  const UnitPair& pair_;
  std::optional<ConicPair> best_;
  PairQuality quality_;
};

/// Tangents that cut the edges in equal parts. There is a pair for each of them.
ConicPair bestOfShares(const UnitPair& pair) {
  constexpr int parts = 8;
  BestPair best(pair);
  for (int i = 1; i < parts; ++i)
    for (int j = 1; j < parts; ++j)
      best.consider({.start_share = static_cast<double>(i) / parts,
                     .end_share = static_cast<double>(j) / parts});
  return *best.best();
}

/// The best of a grid of tangents. It begins with the symmetric one.
ConicPair bestPair(const UnitPair& pair, PairEffort effort) {
  constexpr int turns = 24, most_scale_steps = 10;
  constexpr double scale_step = 1.1;
  std::array<double, 2 * most_scale_steps + 1> scales{};
  for (int j = -most_scale_steps; j <= most_scale_steps; ++j) {
    const int step = j <= 0 ? j + most_scale_steps : -j;  // 0, 1, ..., 10, -1, ..., -10
    scales[static_cast<std::size_t>(j + most_scale_steps)] = std::pow(scale_step, step);
  }
  BestPair best(pair);
  for (int i = 0; i < turns - 1; ++i) {
    // 12, 11, 13, 10, ..., 1, 23
    const int away = (i + 1) / 2, twelfth = turns / 2 + (i % 2 == 0 ? away : -away);
    for (const double scale : scales) {
      const JointTangent tangent = jointTangent(pair, pair.turn() * twelfth / turns, scale);
      if (tangent.inside()) best.consider(tangent);
      if (effort == PairEffort::Draft) break;
    }
  }
  // Where one angle is more than about 120 times the other one, no tangent of the grid cuts both
  // edges.
  return best.best() ? *best.best() : bestOfShares(pair);
}

/// The way back from the unit chord to the given ends.
struct UnitChord {
  HermiteEnds ends;
  bool mirrored = false, reversed = false;

  Vector2d point(const Vector2d& unit) const {
    // Both ends come back bitwise.
    if (unit == Vector2d::Zero()) return reversed ? ends.end : ends.start;
    if (unit == Vector2d::UnitX()) return reversed ? ends.start : ends.end;
    const Vector2d along = ends.end - ends.start;
    const double x = reversed ? 1 - unit.x() : unit.x();
    // A reversed curve turns to the other side; so does a mirrored one.
    const double y = mirrored ? -unit.y() : unit.y();
    return ends.start + x * along + y * Vector2d(-along.y(), along.x());
  }
  PlanarConic conic(const PlanarConic& unit) const {
    return {.start = point(unit.start),
            .corner = point(unit.corner),
            .end = point(unit.end),
            .weight = unit.weight};
  }
};

}  // namespace

double pairCurvature_per_mm(const PairAngles& angles) {
  return 2 * std::sin(angles.own_rad) / angles.chord_mm *
         std::pow(std::sin(angles.own_rad) / std::sin(angles.other_rad), pair_power);
}

ConicPair fairConics(const ConicPairEnds& given, PairEffort effort) {
  const ChordAngles angles = chordAngles(given.ends);
  const double alpha = angles.alpha_rad, beta = angles.beta_rad;
  if (!(alpha * beta > 0 && std::abs(alpha + beta) < std::numbers::pi))
    throw std::domain_error(fmt::format(
        "tangents with the angles {:.6g} and {:.6g} degrees against the chord from ({:.6g}, "
        "{:.6g}) to ({:.6g}, {:.6g}) form no C-shape that turns by less than 180 degrees",
        alpha * degrees_per_radian, beta * degrees_per_radian, given.ends.start.x(),
        given.ends.start.y(), given.ends.end.x(), given.ends.end.y()));
  const bool right = alpha < 0;
  // The curvature grows along the unit pair: so a pair and the reversed one are found alike.
  const bool falls = std::abs(given.start_curvature_per_mm) > std::abs(given.end_curvature_per_mm);
  const double sine = std::sin(std::abs(alpha + beta)), sign = right ? -1 : 1;
  UnitPair pair{.alpha = std::abs(alpha),
                .beta = std::abs(beta),
                .start_edge = std::sin(std::abs(beta)) / sine,
                .end_edge = std::sin(std::abs(alpha)) / sine,
                .start_curvature = sign * given.start_curvature_per_mm * angles.chord_mm,
                .end_curvature = sign * given.end_curvature_per_mm * angles.chord_mm};
  if (falls) {
    std::swap(pair.alpha, pair.beta);
    std::swap(pair.start_edge, pair.end_edge);
    std::swap(pair.start_curvature, pair.end_curvature);
  }
  ConicPair result = bestPair(pair, effort);
  const UnitChord back{.ends = given.ends, .mirrored = right, .reversed = falls};
  for (PlanarConic& conic : result.conics) conic = back.conic(conic);
  if (falls) result.conics = {reversed(result.conics[1]), reversed(result.conics[0])};
  return result;
}

}  // namespace seamwright
