// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <seamwright/core/differential/path_length.hpp>

namespace seamwright {

namespace {

/// The sum of the coefficients times Chebyshev polynomials, by Clenshaw's recursion.
template <std::size_t Count>
double chebyshevSum(const std::array<double, Count>& coefficients, double x) {
  double next = 0, after = 0;
  for (std::size_t k = Count - 1; k > 0; --k) {
    const double here = coefficients[k] + 2 * x * next - after;
    after = next;
    next = here;
  }
  return coefficients[0] + x * next - after;
}

/// cos(pi k (i + 1/2) / Count): Chebyshev polynomial k at node i.
template <std::size_t Count>
std::array<std::array<double, Count>, Count> chebyshevTable() {
  std::array<std::array<double, Count>, Count> table{};
  for (std::size_t k = 0; k < Count; ++k)
    for (std::size_t i = 0; i < Count; ++i)
      table[k][i] = std::cos(std::numbers::pi * static_cast<double>(k) *
                             (static_cast<double>(i) + 0.5) / static_cast<double>(Count));
  return table;
}

/// The last coefficients over the largest.
template <std::size_t Count>
double tailOf(const std::array<double, Count>& coefficients) {
  double largest = 0;
  for (const double c : coefficients) largest = std::max(largest, std::abs(c));
  // The very last one belongs to no node.
  const double last =
      std::max(std::abs(coefficients[Count - 2]), std::abs(coefficients[Count - 3]));
  return largest > 0 ? last / largest : 0;
}

}  // namespace

PathLength::Piece PathLength::interpolant(const std::function<double(double)>& speed_mm,
                                          double from, double to) {
  static const auto table = chebyshevTable<nodes>();
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  std::array<double, nodes> speeds{};
  for (int i = 0; i < nodes; ++i) speeds[i] = speed_mm(middle + half * table[1][i]);
  Piece piece{.from = from, .to = to};
  for (int k = 0; k < nodes; ++k) {
    double sum = 0;
    for (int i = 0; i < nodes; ++i) sum += speeds[i] * table[k][i];
    piece.speed[k] = (k == 0 ? 1.0 : 2.0) * sum / nodes;
  }
  const auto speed = [&](int k) { return k > nodes ? 0 : (k == 0 ? 2.0 : 1.0) * piece.speed[k]; };
  double at_begin = 0;
  for (int k = 1; k <= nodes; ++k) {
    piece.length[k] = half * (speed(k - 1) - speed(k + 1)) / (2 * k);
    at_begin += k % 2 == 0 ? piece.length[k] : -piece.length[k];
  }
  piece.length[0] = -at_begin;
  return piece;
}

void PathLength::add(const std::function<double(double)>& speed_mm, double from, double to,
                     double tail, int stalled) {
  // Choices: nearer to rounding than any fit to the path. A tail below the second one that does not
  // fall is noise of the speeds. A shorter interval has a kink.
  constexpr double enough = 1e-12, noise = 1e-7, shortest = 1.0 / 1024;
  constexpr int most_stalled = 2;
  Piece piece = interpolant(speed_mm, from, to);
  const double own_tail = tailOf(piece.speed);
  if (own_tail < noise && own_tail > 0.5 * tail) ++stalled;
  if (own_tail > enough && to - from > shortest && stalled < most_stalled) {
    const double middle = 0.5 * (from + to);
    add(speed_mm, from, middle, own_tail, stalled);
    add(speed_mm, middle, to, own_tail, stalled);
    return;
  }
  piece.begin_mm = length_mm_;
  length_mm_ += chebyshevSum(piece.length, 1);
  pieces_.push_back(piece);
}

PathLength::PathLength(const std::function<double(double)>& speed_mm,
                       const std::vector<double>& breaks) {
  std::vector<double> limits = breaks;
  limits.push_back(1);
  std::ranges::sort(limits);
  constexpr double apart = 1e-12;  // breaks that differ only by rounding are one
  double from = 0;
  for (const double limit : limits) {
    if (!(limit > from + apart) || limit > 1) continue;
    const double to = limit > 1 - apart ? 1 : limit;
    add(speed_mm, from, to, std::numeric_limits<double>::infinity(), 0);
    from = to;
  }
}

double PathLength::lengthTo(double parameter) const {
  const auto after =
      std::upper_bound(pieces_.begin() + 1, pieces_.end(), parameter,
                       [](double value, const Piece& piece) { return value < piece.from; });
  const Piece& piece = *std::prev(after);
  const double x = (2 * parameter - piece.from - piece.to) / (piece.to - piece.from);
  return piece.begin_mm + chebyshevSum(piece.length, x);
}

double PathLength::parameterAt(double length_mm) const {
  const auto after =
      std::upper_bound(pieces_.begin() + 1, pieces_.end(), length_mm,
                       [](double value, const Piece& piece) { return value < piece.begin_mm; });
  const Piece& piece = *std::prev(after);
  return std::clamp(parameterIn(piece, length_mm - piece.begin_mm), 0.0, 1.0);
}

double PathLength::parameterIn(const Piece& piece, double rest_mm) const {
  const double half = 0.5 * (piece.to - piece.from), whole_mm = chebyshevSum(piece.length, 1);
  // Newton's method, kept between bounds: the path may stand still.
  double low = -1, high = 1, x = std::clamp(2 * rest_mm / whole_mm - 1, low, high);
  constexpr double rounding = 1e-14;
  constexpr int most_steps = 60;  // halvings to the last bit
  for (int step = 0; step < most_steps && high > low; ++step) {
    const double beyond_mm = chebyshevSum(piece.length, x) - rest_mm;
    if (!(std::abs(beyond_mm) > rounding * length_mm_)) break;
    (beyond_mm > 0 ? high : low) = x;
    const double next = x - beyond_mm / (half * chebyshevSum(piece.speed, x));
    x = next > low && next < high ? next : 0.5 * (low + high);
  }
  return 0.5 * (piece.from + piece.to) + half * x;
}

}  // namespace seamwright
