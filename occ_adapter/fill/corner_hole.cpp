// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/fill/corner_hole.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// Degrees of section curves; patches are one degree higher.
constexpr int least_section_degree = 5, most_section_degree = 11;

/// The Bernstein polynomials B_0 .. B_n at t.
Eigen::RowVectorXd bernsteinRow(int n, double t) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(n + 1);
  row(0) = 1;
  for (int k = 1; k <= n; ++k)
    for (int i = k; i >= 0; --i)
      row(i) = (1 - t) * (i < k ? row(i) : 0) + t * (i > 0 ? row(i - 1) : 0);
  return row;
}

Eigen::RowVector2d onUnitArc(double sweep_rad, double t) {
  const double angle = (t - 0.5) * sweep_rad;
  return {std::cos(angle), std::sin(angle)};
}

UnitArc sectionArc(const CornerEdge& edge, const CornerStrip& strip, double section_mm) {
  UnitArc arc;
  for (int degree = least_section_degree; degree <= most_section_degree; ++degree) {
    arc = unitArc(strip.sweep_rad, degree);
    if (arc.error * strip.radius_mm <= section_mm) return arc;
  }
  throw CornerRefused(corner_why::sectionMisses(edge.number, strip.radius_mm,
                                                strip.sweep_rad * degrees_per_radian,
                                                arc.error * strip.radius_mm, section_mm));
}

/// Distances along two edges of a face, from the corner to the feet of the intersection of the
/// contact lines.
std::array<double, 2> crossing(double angle_rad, double contact_mm, double next_contact_mm) {
  const double sine = std::sin(angle_rad), cosine = std::cos(angle_rad);
  return {(next_contact_mm + contact_mm * cosine) / sine,
          (contact_mm + next_contact_mm * cosine) / sine};
}

/// The edge, of an edge and its neighbours, whose contact lines are furthest from it; the edge
/// itself if they are equal.
std::size_t widest(const Corner& corner, const std::vector<CornerStrip>& strips, std::size_t i) {
  std::size_t found = i;
  for (const std::size_t k : {corner.before(i), corner.after(i)})
    // Widths that differ by rounding are equal, whichever edge comes first.
    if (strips[k].contact_mm > (1 + 1e-9) * strips[found].contact_mm) found = k;
  return found;
}

class Roller {
 public:
  Roller(const Corner& corner, const CornerFilletOptions& options)
      : corner_(corner), options_(options) {}

  std::vector<CornerStrip> run() {
    roll();
    setBack();
    return std::move(strips_);
  }

 private:
  /// Sets the radii, and the values that depend only on these and the angles.
  void roll() {
    for (const CornerEdge& edge : corner_.edges) {
      const auto radius = options_.radii_mm.find(edge.number);
      if (radius == options_.radii_mm.end())
        throw std::invalid_argument(
            fmt::format("edge {} is at the vertex and has no radius", edge.number));
      CornerStrip& strip = strips_.emplace_back();
      strip.radius_mm = radius->second;
      strip.contact_mm = strip.radius_mm / std::tan(edge.opening_rad / 2);
      strip.sweep_rad = pi - edge.opening_rad;
    }
    requireOwn(options_.radii_mm, "a radius");
    requireOwn(options_.setbacks_mm, "a setback");
  }

  void requireOwn(const std::map<int, double>& given, const char* what) const {
    for (const auto& [number, value] : given) {
      const int asked = number;
      if (std::none_of(corner_.edges.begin(), corner_.edges.end(),
                       [asked](const CornerEdge& edge) { return edge.number == asked; }))
        throw std::invalid_argument(fmt::format("edge {} has {} of {} and is not at the vertex",
                                                number, what, corner_why::lengthText(value)));
    }
  }

  /// The smallest setback beyond which both contact lines of an edge are past their intersections
  /// with those of the neighbours.
  double leastSetback(std::size_t i) const {
    return std::max({0.0, crossingIn(corner_, strips_, i)[0],
                     crossingIn(corner_, strips_, corner_.before(i))[1]});
  }

  void setBack() {
    double mean = 0;
    for (const CornerStrip& strip : strips_)
      mean += strip.contact_mm / static_cast<double>(corner_.count());
    for (std::size_t i = 0; i < corner_.count(); ++i) {
      const double least = leastSetback(i);
      strips_[i].setback_mm =
          options_.setback_mm(corner_.edges[i].number).value_or(least + mean / 2);
      // At the least setback contact lines meet in a point. Beyond it by a millionth, they leave an
      // edge that coordinates can tell.
      if (!(strips_[i].setback_mm > least * (1 + 1e-6)))
        throw CornerRefused(
            corner_why::setbackTooSmall(corner_.edges[i].number, strips_[i].setback_mm, least));
    }
  }

  const Corner& corner_;
  const CornerFilletOptions& options_;
  std::vector<CornerStrip> strips_;
};

class HoleBuilder {
 public:
  HoleBuilder(const Corner& corner, const CornerFilletOptions& options)
      : corner_(corner), options_(options) {}

  CornerHole build() {
    hole_.strips = cornerStrips(corner_, options_);
    hole_.sides.resize(2 * corner_.count(), {BezierCurve(Poles::Zero(1, 3))});
    for (std::size_t i = 0; i < corner_.count(); ++i) placeStrip(i);
    requireRests();
    for (std::size_t i = 0; i < corner_.count(); ++i) addSection(i);
    for (std::size_t i = 0; i < corner_.count(); ++i) addSpring(i);
    return std::move(hole_);
  }

 private:
  void placeStrip(std::size_t i) {
    const CornerEdge& edge = corner_.edges[i];
    CornerStrip& strip = hole_.strips[i];
    const Vector3d foot = corner_.point + strip.setback_mm * edge.axis;
    strip.to_edge = -(edge.into[0] + edge.into[1]).normalized();
    strip.centre = foot - strip.radius_mm / std::sin(edge.opening_rad / 2) * strip.to_edge;
    const Vector3d far = corner_.point + edge.length_mm * edge.axis;
    rests_mm_.push_back(std::numeric_limits<double>::infinity());
    for (std::size_t side = 0; side < 2; ++side) {
      strip.contacts[side] = foot + strip.contact_mm * edge.into[side];
      const double length =
          edge.end_normal.dot(far - strip.contacts[side]) / edge.end_normal.dot(edge.axis);
      rests_mm_.back() = std::min(rests_mm_.back(), length);
      strip.far_contacts[side] = strip.contacts[side] + length * edge.axis;
    }
  }

  /// Requires that a part of each fillet is left beyond its setback. The refusal is about the edge
  /// that asks for the smallest radii.
  void requireRests() const {
    std::vector<double> shares;
    for (std::size_t i = 0; i < corner_.count(); ++i)
      shares.push_back(rests_mm_[i] / corner_.edges[i].length_mm);
    const auto worst = static_cast<std::size_t>(std::ranges::min_element(shares) - shares.begin());
    // A choice: a shorter rest of the fillet would be a sliver.
    if (!(shares[worst] > 1e-3))
      throw CornerRefused(corner_why::setBackTooFar(
          setBackFillet(corner_, hole_.strips, options_, worst, corner_.edges[worst].length_mm),
          rests_mm_[worst]));
  }

  void addSection(std::size_t i) {
    const CornerStrip& strip = hole_.strips[i];
    const UnitArc arc = sectionArc(corner_.edges[i], strip, options_.section_mm);
    hole_.section_error_mm = std::max(hole_.section_error_mm, arc.error * strip.radius_mm);
    const Vector3d across = (strip.contacts[1] - strip.contacts[0]).normalized();
    Poles poles = strip.radius_mm * (arc.poles.col(0) * strip.to_edge.transpose() +
                                     arc.poles.col(1) * across.transpose());
    poles.rowwise() += strip.centre.transpose();
    poles.row(0) = strip.contacts[0];
    poles.row(poles.rows() - 1) = strip.contacts[1];
    hole_.sides[2 * i] = {BezierCurve(poles), Poles(corner_.edges[i].axis.transpose())};
  }

  void addSpring(std::size_t i) {
    const std::size_t next = corner_.after(i);
    const std::array<double, 2> foot = crossingIn(corner_, hole_.strips, i);
    const std::array<double, 2> legs = {hole_.strips[i].setback_mm - foot[0],
                                        hole_.strips[next].setback_mm - foot[1]};
    const Poles poles = springCurve(hole_.strips[i].contacts[1], -corner_.edges[i].axis,
                                    hole_.strips[next].contacts[0], corner_.edges[next].axis, legs);
    Poles cross(3, 3);
    for (int k = 0; k < 3; ++k)
      cross.row(k) = Vector3d(poles.row(k + 1) - poles.row(k)).cross(corner_.faces[i].normal);
    hole_.sides[2 * i + 1] = {BezierCurve(poles), cross};
  }

  const Corner& corner_;
  const CornerFilletOptions& options_;
  CornerHole hole_;
  std::vector<double>
      rests_mm_;  ///< by edge: of its fillet beyond the setback, on its shorter side
};

}  // namespace

UnitArc unitArc(double sweep_rad, int degree) {
  const int inner = degree - 3;
  UnitArc arc;
  arc.poles.resize(degree + 1, 2);
  arc.poles.row(0) = onUnitArc(sweep_rad, 0);
  arc.poles.row(degree) = onUnitArc(sweep_rad, 1);
  const double step = sweep_rad / degree;
  arc.poles.row(1) =
      arc.poles.row(0) + step * Eigen::RowVector2d(-arc.poles(0, 1), arc.poles(0, 0));
  arc.poles.row(degree - 1) =
      arc.poles.row(degree) -
      step * Eigen::RowVector2d(-arc.poles(degree, 1), arc.poles(degree, 0));

  Eigen::MatrixXd rows(inner, degree + 1);
  Eigen::MatrixX2d values(inner, 2);
  for (int k = 0; k < inner; ++k) {
    const double t = 0.5 - 0.5 * std::cos((k + 0.5) * pi / inner);
    rows.row(k) = bernsteinRow(degree, t);
    values.row(k) = onUnitArc(sweep_rad, t) - rows.row(k).head(2) * arc.poles.topRows(2) -
                    rows.row(k).tail(2) * arc.poles.bottomRows(2);
  }
  arc.poles.middleRows(2, inner) = rows.middleCols(2, inner).partialPivLu().solve(values);

  // A choice: many samples for each extremum of the error, whose number is that of the degree.
  constexpr int samples = 200;
  for (int k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) / samples;
    arc.error =
        std::max(arc.error, (bernsteinRow(degree, t) * arc.poles - onUnitArc(sweep_rad, t)).norm());
  }
  return arc;
}

std::vector<CornerStrip> cornerStrips(const Corner& corner, const CornerFilletOptions& options) {
  return Roller(corner, options).run();
}

std::array<double, 2> crossingIn(const Corner& corner, const std::vector<CornerStrip>& strips,
                                 std::size_t i) {
  return crossing(corner.faces[i].angle_rad, strips[i].contact_mm,
                  strips[corner.after(i)].contact_mm);
}

Poles springCurve(const Vector3d& from, const Vector3d& leaving, const Vector3d& to,
                  const Vector3d& arriving, const std::array<double, 2>& legs) {
  const double turn = std::atan2(leaving.cross(arriving).norm(), leaving.dot(arriving));
  const double cosine = std::cos(turn / 4);
  const double handle = (to - from).norm() / (3 * cosine * cosine);
  Poles poles(4, 3);
  // A choice: below 1, so that handles do not reach the ends of their legs, where they would cross.
  poles << from.transpose(), (from + std::min(handle, 0.9 * legs[0]) * leaving).transpose(),
      (to - std::min(handle, 0.9 * legs[1]) * arriving).transpose(), to.transpose();
  return poles;
}

corner_why::SetBackFillet setBackFillet(const Corner& corner,
                                        const std::vector<CornerStrip>& strips,
                                        const CornerFilletOptions& options, std::size_t i,
                                        double length_mm) {
  const int edge = corner.edges[i].number;
  const std::size_t cause = options.setback_mm(edge) ? i : widest(corner, strips, i);
  return {.edge = edge,
          .edge_mm = length_mm,
          .setback_mm = strips[i].setback_mm,
          .cause = corner.edges[cause].number,
          .cause_radius_mm = strips[cause].radius_mm,
          .given = options.setback_mm(edge).has_value()};
}

CornerHole cornerHole(const Corner& corner, const CornerFilletOptions& options) {
  return HoleBuilder(corner, options).build();
}

}  // namespace seamwright::occ
