// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <stdexcept>
#include <string>
#include <vector>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/bezier/velocity_form.hpp>

namespace seamwright {

namespace {

/// A choice: the remainder then falls with the seventh power of the length of a piece.
constexpr int nodes = 7;
/// The roots x of the Legendre polynomial of degree 7. Gauss' nodes on [0, 1] are (1 +- x) / 2.
constexpr std::array<double, nodes> legendre_roots = {
    -0.94910791234275852453, -0.74153118559939443986, -0.40584515137739716691, 0,
    0.40584515137739716691,  0.74153118559939443986,  0.94910791234275852453};

double node(int i) {
  return 0.5 * (1 + legendre_roots[i]);
}

/// The matrix from values at the nodes to the Bernstein coefficients of the polynomial through
/// them.
Eigen::Matrix<double, nodes, nodes> interpolation() {
  Eigen::Matrix<double, nodes, nodes> values;
  const Eigen::VectorXd& binomials = bernstein::binomials(nodes - 1);
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < nodes; ++j)
      values(i, j) = binomials(j) * std::pow(node(i), j) * std::pow(1 - node(i), nodes - 1 - j);
  return values.inverse();
}

/// x rounded downwards, but not below 0. \pre x is not negative.
double down(double x) {
  return x == 0 ? 0 : std::nextafter(x, 0.0);
}

/// Upper bound of a / b for a >= 0, b > 0; 0 if a is 0.
double quotientUp(double a, double b) {
  return a == 0 ? 0 : rounding::up(a / b);
}

/// The integral of the speed over a piece whose parameter runs from 0 to 1.
struct Estimate {
  Interval bracket;
  double value = 0;     ///< within the bracket
  double rounding = 0;  ///< the part of the width of the bracket that is rounding
};

/// |integral of the velocity| <= length <= integral of the norm of its control polygon, both
/// divided by the divisor. For a polynomial curve these are chord and polygon. The value is
/// Gravesen's.
Estimate chordAndPolygon(const VelocityForm& form) {
  const int m = form.velocity[0].degree();
  Eigen::Matrix3Xd c(3, m + 1);
  for (int i = 0; i < 3; ++i) c.row(i) = form.velocity[i].coefficients().transpose();
  const double chord = c.rowwise().mean().stableNorm(), polygon = c.colwise().stableNorm().mean();
  const double off =
      rounding::sumUp(padding(form.velocity), rounding::productUp(rounding::gamma(m + 8), polygon));
  const Interval divisor = form.divisorRange();
  Estimate result;
  result.bracket = {down(down(std::max(0.0, chord - off)) / divisor.upper),
                    quotientUp(rounding::sumUp(polygon, off), divisor.lower)};
  result.rounding = 2 * off / divisor.lower;
  result.value = std::clamp((2 * chord + m * polygon) / (m + 2) / divisor.middle(),
                            result.bracket.lower, result.bracket.upper);
  return result;
}

/// The speed at the nodes, with rounding.
Eigen::Matrix<double, nodes, 1> speeds(const VelocityForm& form) {
  Eigen::Matrix<double, nodes, 1> values;
  for (int i = 0; i < nodes; ++i) {
    const bernstein::Step step = bernstein::Step::at(node(i));
    Eigen::Vector3d velocity;
    for (int k = 0; k < 3; ++k)
      velocity(k) = bernstein::collapsed(form.velocity[k].coefficients(), step)(0);
    values(i) = velocity.norm() / bernstein::collapsed(form.divisor.coefficients(), step)(0);
  }
  return values;
}

/// Gauss' quadrature with its remainder. The integral of the polynomial g through the speeds at the
/// nodes is the quadrature of these speeds. With v the velocity and d the divisor,
///
///   |v| / d - g = (v.v - (g d)^2) / ((|v| + g d) d),
///
/// and the right side has Bernstein forms, which also show the effect of rounding on g. Nothing
/// where |v| + g d has no positive lower bound.
std::optional<Estimate> quadrature(const VelocityForm& form) {
  static const Eigen::Matrix<double, nodes, nodes> to_bernstein = interpolation();
  const double least_speed = lowerNorm(form.velocity);
  if (!(least_speed > 0)) return std::nullopt;
  const BernsteinPolynomial g(to_bernstein * speeds(form));
  const BernsteinPolynomial guess = g * form.divisor;
  const double denominator =
      down(down(least_speed + std::max(0.0, guess.range().lower)) * form.divisorRange().lower);
  if (!(guess.range().lower >= 0 && denominator > 0)) return std::nullopt;
  const BernsteinPolynomial residual = squaredNorm(form.velocity) - guess * guess;
  Estimate result;
  result.value = g.coefficients().mean();
  const double rounding =
      rounding::productUp(rounding::gamma(nodes + 2), g.coefficients().cwiseAbs().mean());
  const auto off = [&](double excess) {
    return rounding::sumUp(rounding, quotientUp(std::max(0.0, excess), denominator));
  };
  const Interval remainder = residual.range();
  result.bracket = {down(std::max(0.0, result.value - off(-remainder.lower))),
                    rounding::up(result.value + off(remainder.upper))};
  result.rounding = 2 * off(residual.padding());
  return result;
}

Estimate estimated(const VelocityForm& form) {
  const Estimate plain = chordAndPolygon(form);
  const std::optional<Estimate> sharp = quadrature(form);
  return sharp && sharp->bracket.width() < plain.bracket.width() ? *sharp : plain;
}

/// Sums the lengths of pieces. Pieces are halved until each is known to the tolerance, or as well
/// as rounding allows.
class LengthSum {
 public:
  explicit LengthSum(double tolerance) : tolerance_(tolerance) {}

  /// \param share the share of the range that the form covers.
  void add(const VelocityForm& form, const Estimate& estimate, double share) {
    const double width = estimate.bracket.width();
    // A bound of the recursion: such a piece is shorter than the rounding of any sum.
    constexpr double shortest = 0x1p-100;
    if (width <= tolerance_ || share < shortest || halvings_ == most) return take(estimate, share);
    ++halvings_;
    const auto [left, right] = form.halves();
    const Estimate of_left = estimated(left), of_right = estimated(right);
    // The remainder falls with the seventh power of the length; rounding falls only where the speed
    // does.
    const bool falls = of_left.bracket.width() + of_right.bracket.width() <= width;
    // The width is mostly rounding, or is below eleven digits of the length.
    const bool small = width <= 4 * estimate.rounding || width <= 0x1p-36 * estimate.bracket.upper;
    if (small && !falls) return take(estimate, share);
    add(left, of_left, 0.5 * share);
    add(right, of_right, 0.5 * share);
  }

  Interval bracket() const { return bracket_; }
  double value() const { return std::clamp(value_, bracket_.lower, bracket_.upper); }
  /// The shares and the sums at the ends of the pieces.
  const std::vector<LengthMark>& marks() const { return marks_; }

 private:
  /// A bound of the work, as a choice: the bracket stays wider if it is reached.
  static constexpr int most = 1 << 14;

  void take(const Estimate& estimate, double share) {
    bracket_.lower = down(bracket_.lower + down(share * estimate.bracket.lower));
    bracket_.upper =
        rounding::sumUp(bracket_.upper, rounding::productUp(share, estimate.bracket.upper));
    value_ += share * estimate.value;
    marks_.push_back({marks_.back().t + share, value_});
  }

  double tolerance_;
  int halvings_ = 0;
  Interval bracket_;
  double value_ = 0;
  std::vector<LengthMark> marks_ = {{}};
};

void requirePositive(double tolerance_mm) {
  if (!(tolerance_mm > 0) || !std::isfinite(tolerance_mm))
    throw std::invalid_argument("tolerance is " + bernstein::text(tolerance_mm) +
                                ": it must be positive and finite");
}

/// The degree of (g d)^2 in quadrature() is 4 n + 12 for a rational curve; v.v of a polynomial
/// curve has degree 2 n - 2.
void requireDegree(const BezierCurve& curve) {
  const int most =
      curve.isRational() ? (bernstein::kMaxDegree - 12) / 4 : (bernstein::kMaxDegree + 2) / 2;
  if (curve.degree() > most)
    throw std::invalid_argument("degree is " + std::to_string(curve.degree()) +
                                ": the length of a " +
                                (curve.isRational() ? "rational" : "polynomial") +
                                " curve is known up to degree " + std::to_string(most));
}

}  // namespace

double polygonLength(const BezierCurve& curve) {
  const Poles poles = curve.poles();
  return (poles.bottomRows(curve.degree()) - poles.topRows(curve.degree())).rowwise().norm().sum();
}

ArcLength arcLength(const BezierCurve& curve, double tolerance_mm, double first, double last) {
  requirePositive(tolerance_mm);
  if (!(0 <= first && first <= last && last <= 1))
    throw std::invalid_argument("range is " + bernstein::text(first) + " .. " +
                                bernstein::text(last) + ": 0 <= first <= last <= 1 is needed");
  requireDegree(curve);
  if (first == last) return {};
  VelocityForm form = velocityForm(curve);
  if (first > 0 || last < 1) form = form.restricted({first, last});
  const double scale = form.unit_mm * (last - first);
  LengthSum sum(tolerance_mm / scale);
  sum.add(form, estimated(form), 1);
  const Interval bracket = sum.bracket();
  ArcLength length;
  length.lower_mm = down(down(down(last - first) * bracket.lower) * form.unit_mm);
  length.upper_mm = rounding::productUp(
      rounding::productUp(rounding::up(last - first), bracket.upper), form.unit_mm);
  length.value_mm = std::clamp(scale * sum.value(), length.lower_mm, length.upper_mm);
  length.reached = length.upper_mm - length.lower_mm <= tolerance_mm;
  return length;
}

std::vector<LengthMark> lengthMarks(const BezierCurve& curve, double tolerance_mm) {
  requirePositive(tolerance_mm);
  requireDegree(curve);
  const VelocityForm form = velocityForm(curve);
  LengthSum sum(tolerance_mm / form.unit_mm);
  sum.add(form, estimated(form), 1);
  std::vector<LengthMark> marks = sum.marks();
  for (LengthMark& mark : marks) mark.length_mm *= form.unit_mm;
  return marks;
}

double parameterAtLength(const BezierCurve& curve, double length_mm, double tolerance_mm,
                         double first, double last) {
  requirePositive(tolerance_mm);
  const double accuracy = 0.25 * tolerance_mm;
  const ArcLength whole = arcLength(curve, accuracy, first, last);
  if (!(length_mm >= 0 && length_mm <= whole.upper_mm))
    throw std::invalid_argument("length is " + bernstein::text(length_mm) +
                                ": the curve has 0 .. " + bernstein::text(whole.value_mm) + " mm");
  Interval range{first, last};  // contains the result
  const double share = whole.value_mm > 0 ? std::min(1.0, length_mm / whole.value_mm) : 0;
  double t = share < 1 ? first + share * (last - first) : last;
  double nearest = t, least = std::numeric_limits<double>::infinity();
  for (int step = 1;; ++step) {
    const double length = arcLength(curve, accuracy, first, t).value_mm,
                 missing = length_mm - length;
    if (std::abs(missing) < least) {
      nearest = t;
      least = std::abs(missing);
    }
    // Of a length: some roundings of one number, as the target and the sum have them.
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    if (least <= std::max(2 * accuracy, rounding * length)) return nearest;
    (missing > 0 ? range.lower : range.upper) = t;
    if (range.middle() <= range.lower || range.middle() >= range.upper) return nearest;
    // The second of every three steps goes twice as far, so that the range closes from both sides.
    // The third halves the range, because Newton's steps may creep where the speed is about zero.
    const double speed = curve.derivatives(t, 1).row(1).stableNorm();
    const double newton = t + (step % 3 == 2 ? 2 : 1) * missing / speed;
    const bool usable = newton > range.lower && newton < range.upper && step % 3 != 0;
    t = usable ? newton : range.middle();
  }
}

}  // namespace seamwright
