// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <compare>
#include <map>
#include <optional>
#include <vector>

#include <seamwright/core/enclosure/vector_model.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

/// Point and partial derivatives of a surface along a path, as models.
struct JetModel {
  VectorModel p, u, v, uu, uv, vv;
};

/// A surface next to a boundary that is one point P0: P0 + tau Q, with tau the distance in its
/// parameter from that boundary, negative before one at the end of the range.
struct CollapsedJetModel {
  Eigen::Vector3d point;  ///< P0
  JetModel quotient;      ///< Q and its partial derivatives
  ChebyshevModel tau;
  int direction = 0;  ///< tau is along u (0) or v (1)
  double side = 1;    ///< the sign of tau in the surface
};

/// One parameter of a spline.
struct SplineDirection {
  int degree = 0;
  std::vector<double>
      knots;          ///< each repeated by its multiplicity; clamped: degree + 1 times at both ends
  double period = 0;  ///< 0: none
};

/// A (rational) tensor-product B-spline in space, for evaluation along a path of its parameter
/// plane. A curve is one of degree 0 in v.
///
/// Between two knots the spline is one polynomial (or a quotient of two), which is converted to
/// Chebyshev form, about a point of its own, when first met; so large coordinates cost no accuracy,
/// and a spline of many pieces costs what is used of it. Beyond the ends of the parameter range the
/// outermost polynomials go on, or the spline repeats if it is periodic.
///
/// Not to be shared between threads: pieces met are kept.
/// Source: docs/theory/enclosures.md E2.4, E5.1.
class SplineEvaluator {
 public:
  /// \param poles row by row: pole (i, j) is poles[i * count_v + j]; cartesian. \param weights
  /// empty: polynomial.
  /// \throws std::invalid_argument if a number is not finite, a weight not positive, or counts and
  /// knots do not fit.
  SplineEvaluator(SplineDirection u, SplineDirection v, std::vector<Eigen::Vector3d> poles,
                  std::vector<double> weights);

  /// Knots strictly inside the range, those of other periods too, increasing.
  std::vector<double> knotsInside(int direction, const Interval& range) const;

  /// Largest absolute knot: the size by which places in this parameter can be told apart.
  double parameterSize(int direction) const;

  /// The jet along (u, v), of the polynomial of the span that holds hint_u and hint_v. \param order
  /// 0, 1 or 2: highest derivatives wanted.
  JetModel jet(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u, double hint_v,
               int order) const;

  /// The same divided by the distance from a boundary of the span all of whose poles coincide, for
  /// a path that comes near it: there the partial derivatives along the boundary vanish, those of
  /// the quotient need not. Nothing if there is no such boundary near the path, or if the path goes
  /// beyond it by more than rounding.
  std::optional<CollapsedJetModel> collapsedJet(const ChebyshevModel& u, const ChebyshevModel& v,
                                                double hint_u, double hint_v, int order) const;

 private:
  /// Of a degree up to 25, OpenCASCADE's largest, kept without allocation.
  using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                    max_spline_degree + 1, max_spline_degree + 1>;
  struct Span {
    int knot = 0;  ///< the span begins at this one
    double lower = 0;
    double upper = 0;
  };
  /// By order of the derivative.
  struct SpanMatrices {
    std::array<Eigen::VectorXd, 2>
        factors;  ///< of differences of poles, which give those of the next order
    std::array<SmallMatrix, 3> to_chebyshev;  ///< from poles to Chebyshev coefficients
    std::array<SmallMatrix, 3>
        to_chebyshev_terms;  ///< absolute values of what its entries are summed from
    std::array<int, 3>
        roundings{};  ///< in such a term, times a pole and summed up, in units of 2^-53
  };
  struct Net {
    std::array<Eigen::VectorXd, 4>
        coefficients;               ///< of T_i(x) T_j(y) at i + j (degree_u + 1), by coordinate
    std::array<double, 4> error{};  ///< bound of the sum of their errors
  };
  struct Cell {
    Eigen::Vector3d origin;
    int count = 0;            ///< of nets that are made
    std::array<Net, 6> nets;  ///< p, u, v, uu, uv, vv
  };
  struct Local {
    int span = 0;
    ChebyshevModel x;  ///< -1..1 over the span
  };

  const SpanMatrices& matrices(int direction, int span) const;
  SpanMatrices makeMatrices(int direction, int span) const;
  Local localize(int direction, const ChebyshevModel& parameter, double hint) const;
  const Cell& cell(int span_u, int span_v, int nets) const;
  Cell makeCell(int span_u, int span_v, int nets) const;
  struct RoundedNet;
  void addNets(const RoundedNet& poles, const RoundedNet& local, const SpanMatrices& mu,
               const SpanMatrices& mv, int coordinate, Cell& cell) const;
  /// The poles of a span, relative to a point and times their weights; coordinate 3: the weights.
  RoundedNet localNet(int span_u, int span_v, int coordinate, const Eigen::Vector3d& origin) const;
  JetModel evaluated(const Cell& cell, const ChebyshevModel& x, const ChebyshevModel& y,
                     int order) const;

  /// A boundary of a span.
  struct Boundary {
    int direction = 0;  ///< of the parameter that is constant on it
    bool at_end = false;
    auto operator<=>(const Boundary&) const = default;
  };
  struct CollapsedKey {
    int span_u = 0, span_v = 0;
    Boundary boundary;
    auto operator<=>(const CollapsedKey&) const = default;
  };
  std::optional<Eigen::Vector3d> collapsedPoint(int span_u, int span_v,
                                                const Boundary& boundary) const;
  SpanMatrices quotientMatrices(int direction, int span) const;
  RoundedNet quotientNet(const RoundedNet& net, int span, const Boundary& boundary) const;
  Cell makeCollapsedCell(const CollapsedKey& key, const Eigen::Vector3d& point, int nets) const;

  std::array<SplineDirection, 2> directions_;
  std::vector<Eigen::Vector3d> poles_;
  std::vector<double> weights_;
  int count_v_ = 0;
  std::array<std::vector<Span>, 2> spans_;
  /// By lowering of the degree: from Bezier points to Chebyshev coefficients.
  std::array<std::array<SmallMatrix, 3>, 2> bezier_to_chebyshev_;
  mutable std::array<std::map<int, SpanMatrices>, 2> matrices_;
  mutable std::map<std::pair<int, int>, Cell> cells_;
  mutable std::map<CollapsedKey, Cell> collapsed_cells_;
};

}  // namespace seamwright
