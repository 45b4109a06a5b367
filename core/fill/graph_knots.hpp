// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include <seamwright/core/bspline/basis.hpp>

/// The knots of a spline graph; not a public header.
namespace seamwright::fill {

/// Third derivatives of splines of this degree are quadratic on each span.
inline constexpr int graph_degree = 5;

/// The knots of one direction.
class GraphKnots {
 public:
  /// \param bends knots at which second derivatives may jump.
  GraphKnots(double first, double last, int spans, std::vector<double> bends)
      : bends_(std::move(bends)) {
    for (int k = 0; k < spans; ++k) knots_.push_back(first + k * (last - first) / spans);
    knots_.push_back(last);
    // A span much shorter than its neighbours only makes more of them short.
    const double near = 0.3 * (last - first) / spans;
    for (const double bend : bends_)
      std::erase_if(knots_, [&](double knot) {
        return knot != first && knot != last && std::abs(knot - bend) < near;
      });
    knots_.insert(knots_.end(), bends_.begin(), bends_.end());
    std::ranges::sort(knots_);
    halve({});
  }

  int spans() const { return static_cast<int>(knots_.size()) - 1; }
  int poles() const { return static_cast<int>(flat_.size()) - graph_degree - 1; }
  const std::vector<double>& bends() const { return bends_; }
  double begin(int span) const { return knots_[static_cast<std::size_t>(span)]; }
  double width(int span) const { return begin(span + 1) - begin(span); }
  const std::vector<double>& flat() const { return flat_; }

  int spanAt(double t) const {
    const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t);
    return static_cast<int>(after - knots_.begin()) - 1;
  }

  /// The first of the functions that do not vanish on a span.
  int firstPole(int span) const { return last_[static_cast<std::size_t>(span)] - graph_degree; }

  /// Row k holds the k-th derivatives of the functions of the span.
  Eigen::MatrixXd basis(int span, double t, int order) const {
    return bspline::basisDerivatives(graph_degree, flat_, last_[static_cast<std::size_t>(span)], t,
                                     order);
  }

  /// Halves the spans that are marked, and those more than \p most_ratio times as long as one
  /// beside them.
  void halve(std::vector<bool> marked) {
    constexpr double most_ratio = 3;  // a choice
    marked.resize(static_cast<std::size_t>(spans()), false);
    bool any = true;
    while (any) {
      std::vector<double> finer = {knots_.front()};
      for (int k = 0; k < spans(); ++k) {
        if (marked[static_cast<std::size_t>(k)]) finer.push_back(begin(k) + 0.5 * width(k));
        finer.push_back(begin(k + 1));
      }
      knots_ = std::move(finer);
      marked.assign(static_cast<std::size_t>(spans()), false);
      any = false;
      for (int k = 0; k < spans(); ++k)
        for (const int beside : {k - 1, k + 1})
          if (beside >= 0 && beside < spans() && width(k) > most_ratio * width(beside))
            marked[static_cast<std::size_t>(k)] = any = true;
    }
    flatten();
  }

 private:
  void flatten() {
    flat_.assign(graph_degree, knots_.front());
    last_.clear();
    for (std::size_t k = 0; k < knots_.size(); ++k) {
      const bool bends = std::ranges::find(bends_, knots_[k]) != bends_.end();
      flat_.insert(flat_.end(), bends ? graph_degree - 1 : 1, knots_[k]);
      last_.push_back(static_cast<int>(flat_.size()) - 1);
    }
    flat_.insert(flat_.end(), graph_degree, knots_.back());
  }

  std::vector<double> bends_, knots_, flat_;
  std::vector<int> last_;  ///< by span: the index of the flat knot where it begins
};

}  // namespace seamwright::fill
