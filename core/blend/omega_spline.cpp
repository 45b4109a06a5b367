// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>

#include <seamwright/core/blend/omega_spline.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::loft {

namespace {

void requireData(const OmegaData& data) {
  const auto count = static_cast<Eigen::Index>(data.omegas.size());
  if (count < 2 || data.values.rows() != count)
    refuse(fmt::format("omegas {}, rows {}: the numbers must be equal, and at least 2", count,
                       data.values.rows()));
  for (std::size_t i = 0; i < data.omegas.size(); ++i)
    if (!std::isfinite(data.omegas[i]) || (i > 0 && !(data.omegas[i] > data.omegas[i - 1])))
      refuse(fmt::format("omega {} is {}: omegas must be finite and increase", i, data.omegas[i]));
}

/// Breaks and the values there; the values of added breaks are unknown.
struct Stations {
  std::vector<double> breaks;
  std::vector<Eigen::Index> row;  ///< of the value; -1: unknown
};

Stations stationsOf(const OmegaData& data) {
  Stations result;
  for (std::size_t i = 0; i < data.omegas.size(); ++i) {
    result.breaks.push_back(data.omegas[i]);
    result.row.push_back(static_cast<Eigen::Index>(i));
  }
  if (data.closed) return result;
  const bool at_start = data.start.second.has_value(), at_end = data.end.second.has_value();
  // With one interval only the two breaks have to differ.
  const double share = data.omegas.size() == 2 && at_start && at_end ? 1.0 / 3 : 0.5;
  const auto between = [&](double a, double b) { return a + share * (b - a); };
  const std::size_t last = data.omegas.size() - 1;
  const double first_break = between(data.omegas[0], data.omegas[1]),
               last_break = between(data.omegas[last], data.omegas[last - 1]);
  if (at_end) {
    result.breaks.insert(result.breaks.end() - 1, last_break);
    result.row.insert(result.row.end() - 1, -1);
  }
  if (at_start) {
    result.breaks.insert(result.breaks.begin() + 1, first_break);
    result.row.insert(result.row.begin() + 1, -1);
  }
  return result;
}

/// Linear equations of the slopes at all breaks and of the unknown values. Rows are multiplied by
/// powers of the length of their interval, so that they have one size.
class SplineEquations {
 public:
  SplineEquations(const OmegaData& data, Stations stations)
      : data_(data), stations_(std::move(stations)) {
    const auto breaks = static_cast<Eigen::Index>(stations_.breaks.size());
    Eigen::Index unknown = breaks;
    for (const Eigen::Index row : stations_.row) value_at_.push_back(row < 0 ? unknown++ : -1);
    matrix_ = Eigen::MatrixXd::Zero(unknown, unknown);
    right_ = Eigen::MatrixXd::Zero(unknown, data.values.cols());
    assemble(static_cast<int>(breaks) - 1);
  }

  OmegaSpline solve() const {
    const Eigen::MatrixXd x = linear::PivotedQr(matrix_).solve(right_);
    const auto pieces = static_cast<Eigen::Index>(stations_.breaks.size()) - 1;
    OmegaSpline result{stations_.breaks, Eigen::MatrixXd(3 * pieces + 1, right_.cols())};
    for (Eigen::Index i = 0; i <= pieces; ++i) {
      const Eigen::Index row = stations_.row[i];
      result.rows.row(3 * i) = row < 0 ? x.row(value_at_[i]) : data_.values.row(row);
    }
    for (Eigen::Index i = 0; i < pieces; ++i) {
      const double third = length(static_cast<int>(i)) / 3;
      result.rows.row(3 * i + 1) = result.rows.row(3 * i) + third * x.row(i);
      result.rows.row(3 * i + 2) = result.rows.row(3 * i + 3) - third * x.row(i + 1);
    }
    return result;
  }

 private:
  double length(int i) const { return stations_.breaks[i + 1] - stations_.breaks[i]; }

  void value(int i, double factor) {
    if (stations_.row[i] < 0)
      matrix_(next_, value_at_[i]) += factor;
    else
      right_.row(next_) -= factor * data_.values.row(stations_.row[i]);
  }
  void slope(int i, double factor) { matrix_(next_, i) += factor; }

  /// Adds factor times the second derivative of piece i at its beginning or end.
  void second(int i, bool at_end, double factor) {
    const double h = length(i), sign = at_end ? -1 : 1;
    value(i + 1, sign * 6 * factor / (h * h));
    value(i, -sign * 6 * factor / (h * h));
    slope(i, (at_end ? 2 : -4) * factor / h);
    slope(i + 1, (at_end ? 4 : -2) * factor / h);
  }
  /// Adds factor times the third derivative of piece i.
  void third(int i, double factor) {
    const double h = length(i);
    value(i + 1, -12 * factor / (h * h * h));
    value(i, 12 * factor / (h * h * h));
    slope(i, 6 * factor / (h * h));
    slope(i + 1, 6 * factor / (h * h));
  }

  void assemble(int pieces) {
    for (int i = 1; i < pieces; ++i) {
      const double size = std::min(length(i - 1), length(i));
      second(i - 1, true, size);
      second(i, false, -size);
      ++next_;
    }
    if (data_.closed) {
      const double size = std::min(length(0), length(pieces - 1));
      second(pieces - 1, true, size);
      second(0, false, -size);
      ++next_;
      slope(0, 1);
      slope(pieces, -1);
      ++next_;
      return;
    }
    end(data_.start, pieces, true);
    end(data_.end, pieces, false);
  }

  void end(const EndDerivatives& given, int pieces, bool start) {
    const int piece = start ? 0 : pieces - 1, neighbour = start ? 1 : pieces - 2;
    if (!given.first) {
      free(pieces, piece, neighbour, start);
      return;
    }
    slope(start ? 0 : pieces, 1);
    right_.row(next_++) += *given.first;
    if (!given.second) return;
    const double size = length(piece);
    second(piece, !start, size);
    right_.row(next_++) += size * *given.second;
  }

  /// The third derivative is that of the neighbour. Where there is none it is 0, and for a single
  /// piece without any derivative the second is 0, too.
  void free(int pieces, int piece, int neighbour, bool start) {
    const bool both = !data_.start.first && !data_.end.first;
    const double h = length(piece);
    if (pieces == 1 && both && !start) {
      second(piece, true, h);
    } else if (pieces == 1 || (pieces == 2 && both && !start)) {
      third(piece, h * h);
    } else {
      const double size = std::min(h, length(neighbour));
      third(piece, size * size);
      third(neighbour, -size * size);
    }
    ++next_;
  }

  const OmegaData& data_;
  Stations stations_;
  std::vector<Eigen::Index> value_at_;  ///< the unknown of a break's value; -1: given
  Eigen::MatrixXd matrix_, right_;
  Eigen::Index next_ = 0;
};

/// The pole whose blossom takes the break and its two neighbours, from the longer interval.
Row poleAcross(const std::vector<double>& breaks, std::size_t i, Eigen::Index at,
               const Eigen::MatrixXd& rows) {
  const double before = breaks[i] - breaks[i - 1], after = breaks[i + 1] - breaks[i];
  if (after <= before)
    return rows.row(at - 1) + after / before * (rows.row(at - 1) - rows.row(at - 2));
  return rows.row(at + 1) + before / after * (rows.row(at + 1) - rows.row(at + 2));
}

}  // namespace

OmegaSpline omegaSpline(const OmegaData& data) {
  requireData(data);
  return SplineEquations(data, stationsOf(data)).solve();
}

OmegaPoles omegaPoles(const std::vector<double>& breaks, const std::vector<bool>& kink, int degree,
                      const Eigen::MatrixXd& rows) {
  const std::size_t pieces = breaks.size() - 1;
  OmegaPoles result;
  std::vector<Row> poles{rows.row(0), rows.row(1)};
  result.knots.assign(static_cast<std::size_t>(degree) + 1, breaks.front());
  for (std::size_t i = 0; i < pieces; ++i) {
    const Eigen::Index first = static_cast<Eigen::Index>(i) * degree;
    for (Eigen::Index k = 2; k <= degree - 2; ++k) poles.push_back(rows.row(first + k));
    const Eigen::Index at = first + degree;
    if (i + 1 == pieces) {
      for (const Eigen::Index k : {at - 1, at}) poles.push_back(rows.row(k));
    } else if (kink[i + 1]) {
      for (const Eigen::Index k : {at - 1, at, at + 1}) poles.push_back(rows.row(k));
      result.knots.insert(result.knots.end(), static_cast<std::size_t>(degree), breaks[i + 1]);
    } else {
      poles.push_back(poleAcross(breaks, i + 1, at, rows));
      result.knots.insert(result.knots.end(), static_cast<std::size_t>(degree) - 2, breaks[i + 1]);
    }
  }
  result.knots.insert(result.knots.end(), static_cast<std::size_t>(degree) + 1, breaks.back());
  result.rows.resize(static_cast<Eigen::Index>(poles.size()), rows.cols());
  for (std::size_t i = 0; i < poles.size(); ++i)
    result.rows.row(static_cast<Eigen::Index>(i)) = poles[i];
  return result;
}

}  // namespace seamwright::loft
