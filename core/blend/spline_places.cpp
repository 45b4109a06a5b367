// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <seamwright/core/blend/spline_places.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::match {

namespace {

/// Share of a length to which it is measured: places are a choice, so that more is not needed.
constexpr double length_share = 1e-9;

/// The parts of a curve between increasing parameters inside of 0..1.
std::vector<BezierCurve> parts(BezierCurve curve, const std::vector<double>& at) {
  std::vector<BezierCurve> result;
  double from = 0;
  for (const double t : at) {
    auto [left, right] = curve.split((t - from) / (1 - from));
    result.push_back(std::move(left));
    curve = std::move(right);
    from = t;
  }
  result.push_back(std::move(curve));
  return result;
}

}  // namespace

Measured::Measured(BezierSpline spline) : spline_(std::move(spline)), sums_{0} {
  for (int i = 0; i < spline_.segments(); ++i) {
    pieces_.push_back(segment(spline_, i));
    const double size = polygonLength(pieces_.back());
    marks_.push_back(size > 0 ? lengthMarks(pieces_.back(), length_share * size)
                              : std::vector<LengthMark>(1));
    const double length = marks_.back().back().length_mm;
    if (!(length > 0) || !(sums_.back() + length > sums_.back()))
      refuse(fmt::format("piece {} has the length {} mm", i, length));
    sums_.push_back(sums_.back() + length);
    sizes_.push_back(size);
  }
}

double Measured::shareAt(const Place& place) const {
  if (place.t == 0) return share(place.piece);
  const auto above = std::ranges::upper_bound(marks_[place.piece], place.t, {}, &LengthMark::t);
  const LengthMark& mark = *(above - 1);
  const double length =
      mark.length_mm +
      arcLength(pieces_[place.piece], length_share * sizes_[place.piece], mark.t, place.t).value_mm;
  return std::min((sums_[place.piece] + length) / sums_.back(), share(place.piece + 1));
}

Place Measured::placeAt(double share, double precision) const {
  const double length = share * sums_.back();
  const auto above = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, length);
  const auto piece = static_cast<int>(above - sums_.begin()) - 1;
  const std::vector<LengthMark>& marks = marks_[piece];
  const double inside = length - sums_[piece];
  if (!(inside > 0)) return {piece, 0.0};
  if (!(inside < marks.back().length_mm)) return {piece, 1.0};
  const LengthMark& end = *std::ranges::upper_bound(marks, inside, {}, &LengthMark::length_mm);
  const LengthMark& start = *(&end - 1);
  const double tolerance = precision * sizes_[piece];
  // What parameterAtLength() takes as the length of the part.
  const double part = arcLength(pieces_[piece], 0.25 * tolerance, start.t, end.t).value_mm;
  return {piece, parameterAtLength(pieces_[piece], std::min(inside - start.length_mm, part),
                                   tolerance, start.t, end.t)};
}

Place Measured::placeOf(double parameter) const {
  const std::vector<double>& knots = spline_.knots;
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
  const auto piece = static_cast<int>(above - knots.begin()) - 1;
  return {piece, (parameter - knots[piece]) / (knots[piece + 1] - knots[piece])};
}

Eigen::Vector3d Measured::point(const Place& place) const {
  return pieces_[place.piece].point(place.t);
}

BezierSpline dividedAt(const BezierSpline& spline, const std::vector<Place>& places) {
  std::vector<BezierCurve> pieces;
  std::vector<double> knots{spline.knots.front()};
  auto next = places.begin();
  for (int i = 0; i < spline.segments(); ++i) {
    const double begin = spline.knots[i], end = spline.knots[i + 1];
    std::vector<double> at;
    for (; next != places.end() && next->piece == i; ++next) {
      const double knot = begin + next->t * (end - begin);
      if (!(next->t < 1) || !(knot > knots.back()) || !(knot < end)) continue;
      at.push_back(next->t);
      knots.push_back(knot);
    }
    for (BezierCurve& part : parts(segment(spline, i), at)) pieces.push_back(std::move(part));
    knots.push_back(end);
  }
  return bezierSpline(pieces, knots, spline.closed);
}

BezierSpline startingAt(const BezierSpline& spline, const Place& place) {
  const BezierSpline divided = dividedAt(spline, {place});
  const bool inside = divided.segments() > spline.segments();
  const int first = place.piece + (inside ? 1 : 0), count = divided.segments();
  if (first == 0) return divided;
  std::vector<BezierCurve> pieces;
  std::vector<double> knots{spline.knots.front()};
  for (int k = 0; k < count; ++k) {
    const int i = (first + k) % count;
    pieces.push_back(segment(divided, i));
    knots.push_back(knots.back() + (divided.knots[i + 1] - divided.knots[i]));
  }
  return bezierSpline(pieces, knots, true, infinite);
}

BezierSpline runBackwards(const BezierSpline& spline) {
  BezierSpline result = spline;
  result.poles = spline.poles.colwise().reverse();
  const std::size_t last = spline.knots.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
    result.knots[i] = spline.knots.front() + (spline.knots.back() - spline.knots[last - i]);
  result.knots.back() = spline.knots.back();
  return result;
}

}  // namespace seamwright::match
