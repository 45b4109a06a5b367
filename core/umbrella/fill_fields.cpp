// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/umbrella/fill_fields.hpp>
#include <stdexcept>
#include <string>

namespace seamwright::fill {

namespace {

using bernstein::text;
using Eigen::Vector2d, Eigen::Vector3d;
using rows::Field;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A side with tangent planes at one of its ends: derivatives by t.
struct End {
  Vector3d edge, edge2;    // E', E''
  Vector3d cross, cross1;  // T, T'
  double noise = 0;        // of T and E', by rounding of coordinates
};

/// The scalar functions of G = p T + q E', linear and quadratic on either half.
struct Scalars {
  double p_begin = 0, p_middle = 0, p_end = 0;
  double q_begin = 0, q_end = 0;
  double q_slope_begin = 0, q_slope_end = 0;
};

/// The coefficients of the vector by the two others, least squares.
Vector2d combination(const Vector3d& first, const Vector3d& second, const Vector3d& vector) {
  Eigen::MatrixXd plane(3, 2);
  plane << first, second;
  return linear::PivotedQr(plane).solve(vector);
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The first or last coefficient.
Vector3d endOf(const Poles& coefficients, bool last) {
  return coefficients.row(last ? coefficients.rows() - 1 : 0);
}

/// Size of the coordinates: their rounding is that of everything.
double extent(const std::vector<FillSide>& sides) {
  double size = 0;
  for (const FillSide& side : sides) size = std::max(size, rows::size(side.edge.poles()));
  return size;
}

End endOfSide(const FillSide& side, bool last, double size) {
  const Poles edge1 = rows::derivative<3>(side.edge.poles());
  End end{endOf(edge1, last), endOf(rows::derivative<3>(edge1), last), endOf(*side.cross, last),
          endOf(rows::derivative<3>(*side.cross), last)};
  const double degree = std::max<double>(side.edge.degree(), rows::degree(*side.cross));
  end.noise = 64 * epsilon * (degree + 1) * (size + rows::size(*side.cross));
  return end;
}

std::string cornerName(std::size_t k) {
  return "corner " + std::to_string(k);
}

/// What both sides say of the corner between them.
class Corner {
 public:
  Corner(const std::vector<FillSide>& sides, std::size_t k, double size)
      : k_(k),
        in_(tangentAtEnd(sides[(k + sides.size() - 1) % sides.size()])),
        out_(tangentAtBegin(sides[k])) {
    const FillSide& before = sides[(k + sides.size() - 1) % sides.size()];
    if (before.cross) before_ = endOfSide(before, true, size);
    if (sides[k].cross) after_ = endOfSide(sides[k], false, size);
    noise_rad_ = 64 * epsilon * size * (before.edge.degree() + sides[k].edge.degree()) *
                 (1 / in_.norm() + 1 / out_.norm());
    if (before_) noise_rad_ += planeNoise(*before_, k == 0 ? sides.size() - 1 : k - 1);
    if (after_) noise_rad_ += planeNoise(*after_, k);
  }

  /// Angles, refused where no fill exists.
  FillCorner figures(double tolerance_rad) const {
    FillCorner corner;
    corner.plane_angle_rad = planeAngle();
    if (corner.plane_angle_rad > noise_rad_ + tolerance_rad)
      throw std::invalid_argument(cornerName(k_) + ": the tangent planes of its sides differ by " +
                                  text(corner.plane_angle_rad) + " rad, allowed are " +
                                  text(noise_rad_ + tolerance_rad));
    corner.angle_rad = interiorAngle();
    const double beyond = corner.angle_rad - std::numbers::pi;
    if (std::abs(beyond) <= noise_rad_)
      throw std::invalid_argument(cornerName(k_) + ": the angle of the hole is pi (" +
                                  text(corner.angle_rad) + " rad): merge the two sides");
    if (beyond > 0)
      throw std::invalid_argument(cornerName(k_) + ": the angle of the hole is " + text(corner.angle_rad) +
                                  " rad, it must be below pi: split the hole");
    if (corner.angle_rad <= noise_rad_)
      throw std::invalid_argument(cornerName(k_) + ": the angle of the hole is " + text(corner.angle_rad) +
                                  " rad, it must be positive");
    corner.exact = corner.plane_angle_rad <= noise_rad_;
    return corner;
  }

  const Vector3d& in() const { return in_; }
  const Vector3d& out() const { return out_; }
  const std::optional<End>& before() const { return before_; }
  const std::optional<End>& after() const { return after_; }

 private:
  double planeNoise(const End& end, std::size_t side) const {
    const double area = end.edge.cross(end.cross).norm();
    const double noise = end.noise * (end.edge.norm() + end.cross.norm());
    if (!(area > noise))
      throw std::invalid_argument(
          "side " + std::to_string(side) + ": at " + cornerName(k_) +
          " the cross field is parallel to the edge or one of them vanishes, |E' x T| is " + text(area) +
          ", rounding " + text(noise));
    return noise / area;
  }

  static Vector3d normal(const End& end) { return end.cross.cross(end.edge).normalized(); }

  /// Up where a viewer sees the hole to the left of its sides; zero where no side has a tangent plane.
  Vector3d up() const {
    Vector3d sum = Vector3d::Zero();
    if (before_) sum += normal(*before_);
    if (after_) sum += normal(*after_);
    return sum;
  }

  double planeAngle() const {
    if (before_ && after_) return angleBetween(normal(*before_), normal(*after_));
    if (before_) return std::asin(std::min(1.0, std::abs(normal(*before_).dot(out_)) / out_.norm()));
    if (after_) return std::asin(std::min(1.0, std::abs(normal(*after_).dot(in_)) / in_.norm()));
    return 0;
  }

  double interiorAngle() const {
    const Vector3d across = in_.cross(out_);
    const double sine = before_ || after_ ? std::copysign(across.norm(), across.dot(up())) : across.norm();
    const double angle = std::atan2(sine, -in_.dot(out_));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  }

  std::size_t k_;
  Vector3d in_, out_;
  std::optional<End> before_, after_;
  double noise_rad_ = 0;
};

/// Steps 1 and 2: G at the ends of a side is half the tangent of the sides next to it, p is linear on each half.
Scalars scalarsOf(const Corner& begin, const Corner& end, SpokeLaw law, int n) {
  Scalars s;
  const Vector2d first = combination(begin.after()->cross, begin.after()->edge, begin.in() / 2);
  const Vector2d last = combination(end.before()->cross, end.before()->edge, -end.out() / 2);
  s.p_begin = first(0), s.q_begin = first(1);
  s.p_end = last(0), s.q_end = last(1);
  s.p_middle = (s.p_begin + s.p_end) / (2 + slopeAtSide(law, n));
  s.q_slope_begin = s.q_slope_end = s.q_end - s.q_begin;
  return s;
}

/// Steps 3 and 6: slopes of q such that the mixed derivatives of the fill agree but for a normal part, which is the result.
Vector3d meetTwists(const Corner& corner, Scalars& before, Scalars& after, FillCorner& figures) {
  const End &b = *corner.before(), &a = *corner.after();
  const double p1_before = 2 * (before.p_end - before.p_middle),
               p1_after = 2 * (after.p_middle - after.p_begin);
  const Vector3d known = after.p_begin * a.cross1 + p1_after * a.cross + after.q_begin * a.edge2 +
                         before.p_end * b.cross1 + p1_before * b.cross + before.q_end * b.edge2;
  const Vector2d slopes = combination(a.edge, b.edge, -known);
  after.q_slope_begin = slopes(0), before.q_slope_end = slopes(1);
  const Vector3d normal = corner.in().cross(corner.out()).normalized();
  figures.twist_defect_mm = normal.dot(known);
  const double noise =
      (after.p_begin + before.p_end + std::abs(p1_after) + std::abs(p1_before)) * (a.noise + b.noise) * 4 +
      16 * (std::abs(after.q_begin) * a.noise + std::abs(before.q_end) * b.noise);
  figures.exact = figures.exact && std::abs(figures.twist_defect_mm) <= noise;
  return known + slopes(0) * a.edge + slopes(1) * b.edge;
}

/// Step 4: Bernstein coefficients of p and q on the halves; q is such that the slope of G jumps in the middle as the spoke asks for.
struct HalfScalars {
  Eigen::VectorXd p, q;
};

std::array<HalfScalars, 2> halfScalars(const Scalars& s, SpokeLaw law, int n) {
  const double left = s.q_begin + s.q_slope_begin / 4, right = s.q_end - s.q_slope_end / 4;
  const double middle = 2 * (left + right) / (4 + slopeAtSide(law, n));
  return {HalfScalars{Eigen::Vector2d(s.p_begin, s.p_middle), Vector3d(s.q_begin, left, middle)},
          HalfScalars{Eigen::Vector2d(s.p_middle, s.p_end), Vector3d(middle, right, s.q_end)}};
}

double least(const Eigen::VectorXd& polynomial) {
  const BernsteinPolynomial p(polynomial);
  return std::max(0.0, p.range(1e-3 * polynomial.cwiseAbs().maxCoeff()).lower);
}

double greatest(const Eigen::VectorXd& polynomial) {
  return std::max(0.0, BernsteinPolynomial(polynomial).range(1e-3 * polynomial.cwiseAbs().maxCoeff()).upper);
}

/// Bound of the angle between span(E', G) and span(E', G + change) on a half.
double angleBound(const Poles& field, const Poles& change, const Poles& edge1) {
  const Field<3> across = rows::cross(field, edge1);
  const double part = std::sqrt(least(rows::dot<3>(across, across)) / greatest(rows::dot<3>(edge1, edge1)));
  const double moved = std::sqrt(greatest(rows::dot<3>(change, change)));
  return part > moved ? std::asin(moved / part) : std::numbers::pi / 2;
}

/// One half of a side while it is built: what the tangent planes ask for, and what is taken.
struct Half {
  Poles edge1, wanted, taken;
};

std::array<Half, 2> halvesOf(const FillSide& side, const std::array<HalfScalars, 2>& scalars, int degree) {
  const std::array<Poles, 2> edge1 = halved(rows::derivative<3>(side.edge.poles())),
                             cross = halved(*side.cross);
  std::array<Half, 2> halves;
  for (std::size_t h = 0; h < 2; ++h) {
    const Field<3> field =
        rows::sum<3>(rows::product<3>(scalars[h].p, cross[h]), rows::product<3>(scalars[h].q, edge1[h]));
    const Poles raised = rows::elevated<3>(field, degree);
    halves[h] = {edge1[h], raised, raised};
  }
  return halves;
}

}  // namespace

std::array<Poles, 2> halved(const Poles& coefficients) {
  const auto [left, right] = BezierCurve(coefficients).split(0.5);
  return {left.poles(), right.poles()};
}

Vector3d tangentAtBegin(const FillSide& side) {
  return endOf(rows::derivative<3>(side.edge.poles()), false);
}

Vector3d tangentAtEnd(const FillSide& side) {
  return endOf(rows::derivative<3>(side.edge.poles()), true);
}

CrossFields crossFields(const std::vector<FillSide>& sides, SpokeLaw law, int degree, double tolerance_rad) {
  const std::size_t n = sides.size();
  const auto next = [n](std::size_t k) { return (k + 1) % n; };
  const double size = extent(sides);
  std::vector<Corner> corners;
  CrossFields result;
  for (std::size_t k = 0; k < n; ++k) {
    corners.emplace_back(sides, k, size);
    result.corners.push_back(corners[k].figures(tolerance_rad));
  }
  std::vector<Scalars> scalars(n);
  for (std::size_t k = 0; k < n; ++k)
    if (sides[k].cross) scalars[k] = scalarsOf(corners[k], corners[next(k)], law, static_cast<int>(n));
  std::vector<Vector3d> defects(n, Vector3d::Zero());
  for (std::size_t k = 0; k < n; ++k)
    if (corners[k].before() && corners[k].after())
      defects[k] = meetTwists(corners[k], scalars[(k + n - 1) % n], scalars[k], result.corners[k]);

  result.sides.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!sides[k].cross) continue;
    const std::array<HalfScalars, 2> functions = halfScalars(scalars[k], law, static_cast<int>(n));
    std::array<Half, 2> halves = halvesOf(sides[k], functions, degree);
    Poles &left = halves[0].taken, &right = halves[1].taken;
    left.row(0) = corners[k].in() / 2;
    right.row(degree) = -corners[next(k)].out() / 2;
    left.row(1) += (left.row(0) - halves[0].wanted.row(0)) - defects[k].transpose() / (4 * degree);
    right.row(degree - 1) +=
        (right.row(degree) - halves[1].wanted.row(degree)) + defects[next(k)].transpose() / (4 * degree);
    SideField field{{left, right}, {}};
    for (std::size_t h = 0; h < 2; ++h) {
      field.joins[h].alpha = functions[h].p;
      field.joins[h].beta = -2 * functions[h].q;
      FillCorner& corner = result.corners[h == 0 ? k : next(k)];
      if (!corner.exact)
        corner.angle_bound_rad =
            std::max(corner.angle_bound_rad,
                     angleBound(halves[h].wanted, halves[h].taken - halves[h].wanted, halves[h].edge1));
    }
    result.sides[k] = std::move(field);
  }
  return result;
}

}  // namespace seamwright::fill
