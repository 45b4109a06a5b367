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
  VectorModel uuu = {}, uuv = {}, uvv = {}, vvv = {};
};

/// A surface next to a boundary that is one point P0: the surface is P0 + tau Q. tau is the
/// distance from that boundary in the parameter across it; it is negative if the boundary is at the
/// end of the range.
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

/// A (rational) tensor-product B-spline in space that can be evaluated along a path of its
/// parameter plane. A curve is a spline of degree 0 in v.
///
/// Between two knots the spline is one polynomial, or a quotient of two. It is converted to
/// Chebyshev form, relative to its own origin, when it is first evaluated. So large
/// coordinates cost no accuracy, and a spline of many spans costs only the spans that are used.
/// Beyond the ends of the parameter range the outermost polynomials continue; a periodic spline
/// repeats.
///
/// An object must not be shared between threads: it caches the spans it has converted.
/// Source: docs/theory/enclosures.md E2.4, E5.1.
class SplineEvaluator {
 public:
  /// \param poles row by row: pole (i, j) is poles[i * count_v + j]; cartesian.
  /// \param weights empty for a polynomial spline.
  /// \throws std::invalid_argument if a number is not finite, if a weight is not positive, or if
  /// counts and knots do not match.
  SplineEvaluator(SplineDirection u, SplineDirection v, std::vector<Eigen::Vector3d> poles,
                  std::vector<double> weights);

  /// Knots strictly inside the range, in increasing order; for a periodic spline also those of
  /// other periods.
  std::vector<double> knotsInside(int direction, const Interval& range) const;

  /// Largest absolute knot. It sets the size of the rounding of this parameter.
  double parameterSize(int direction) const;

  /// The jet along (u, v) of the polynomial of the span that holds (hint_u, hint_v).
  /// \param order 0 to 3: highest derivatives wanted.
  JetModel jet(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u, double hint_v,
               int order) const;

  /// The same of order 2, but the second derivatives are only known up to tangent vectors: their
  /// products with the normal are right. That is all that the curvature needs.
  JetModel curvatureJet(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                        double hint_v) const;

  /// The jet divided by the distance from a boundary of the span whose poles all coincide, for a
  /// path that comes near that boundary. On such a boundary the partial derivatives along it
  /// vanish; those of the quotient need not vanish. Nothing if there is no such boundary near the
  /// path, or if the path goes beyond it by more than rounding.
  std::optional<CollapsedJetModel> collapsedJet(const ChebyshevModel& u, const ChebyshevModel& v,
                                                double hint_u, double hint_v, int order) const;

 private:
  /// A matrix for degrees up to 25, OpenCASCADE's largest degree, stored without allocation.
  using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                    max_spline_degree + 1, max_spline_degree + 1>;
  using SmallRow =
      Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, max_spline_degree + 1>;
  struct Span {
    int knot = 0;  ///< index of the knot at which the span begins
    double lower = 0;
    double upper = 0;
  };
  /// The matrices of one span, indexed by the order of the derivative.
  struct SpanMatrices {
    int order = 0;  ///< highest derivative
    std::array<Eigen::VectorXd, 3>
        factors;  ///< factors that turn differences of poles into poles of the next order
    std::array<Eigen::MatrixXd, 4> to_chebyshev;  ///< from poles to Chebyshev coefficients
    std::array<Eigen::RowVectorXd, 4>
        to_chebyshev_terms;  ///< sums, over each column, of the absolute values
                             ///< of the terms of its entries
    std::array<int, 4>
        roundings{};  ///< roundings of an entry times a pole, summed up, in units of 2^-53
  };
  struct Net {
    /// By coordinate. They shrink with the order of the derivative.
    std::array<Eigen::MatrixXd, 4> coefficients;  ///< that of T_i(x) T_j(y) at (i, j)
    std::array<double, 4> error{};  ///< bound of the sum of the errors of the coefficients
  };
  struct Cell {
    Eigen::Vector3d origin;
    int count = 0;             ///< number of nets that are computed
    std::array<Net, 10> nets;  ///< p, u, v, uu, uv, vv, uuu, uuv, uvv, vvv
  };
  struct Local {
    int span = 0;
    ChebyshevModel x;  ///< -1..1 over the span
  };

  const SpanMatrices& matrices(int direction, int span, int nets) const;
  SpanMatrices makeMatrices(int direction, int span, int order) const;
  Local localize(int direction, const ChebyshevModel& parameter, double hint) const;
  const Cell& cell(int span_u, int span_v, int nets) const;
  void extendCell(int span_u, int span_v, int nets, Cell& cell) const;
  struct RoundedNet;
  void addNets(const RoundedNet& poles, const RoundedNet& local, const SpanMatrices& mu,
               const SpanMatrices& mv, int coordinate, int first_net, Cell& cell) const;
  /// The poles of a span, relative to a point and multiplied by their weights; coordinate 3 is the
  /// weights.
  RoundedNet localNet(int span_u, int span_v, int coordinate, const Eigen::Vector3d& origin) const;
  /// Whether second derivatives are wanted themselves, or only up to tangent vectors.
  enum class Second { Whole, UpToTangents };
  JetModel jet(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u, double hint_v,
               int order, Second second) const;
  /// A parameter line in a cell.
  struct LineKey {
    int across = 0;  ///< the direction whose parameter is constant
    int span = 0, span_along = 0;
    double place = 0;  ///< of the constant parameter, -1..1 over its span
    auto operator<=>(const LineKey&) const = default;
  };
  struct Line {
    LineKey key;
    double radius = 0;  ///< of the place
  };
  /// The curves of a line: its points and their derivatives by u and v.
  struct LineCell {
    int order = 0;  ///< highest derivative
    Eigen::Vector3d origin;
    Eigen::MatrixXd
        coefficients;  ///< column 4 k + d: Chebyshev coefficients of coordinate d, net k
    std::array<std::array<double, 4>, 10> error{};  ///< bounds of the errors of a column's sum
    std::array<std::array<double, 4>, 10> slope{};  ///< of the error, per radius of the place
  };
  static std::optional<Line> lineOf(const std::array<Local, 2>& at);
  JetModel jetOnLine(const Line& line, const ChebyshevModel& along, int order, Second second) const;
  const LineCell& lineCell(const LineKey& line, int order) const;
  LineCell makeLineCell(const LineKey& line, int order) const;
  struct LineNet;
  LineNet lineNet(const LineKey& line, const Eigen::Vector3d& origin) const;
  int poleIndex(const LineKey& line, int i, int j) const;

  JetModel evaluated(const Cell& cell, const ChebyshevModel& x, const ChebyshevModel& y, int order,
                     Second second) const;

  /// A boundary of a span.
  struct Boundary {
    int direction = 0;  ///< the parameter that is constant on it
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
  SpanMatrices quotientMatrices(int direction, int span, int order) const;
  RoundedNet quotientNet(const RoundedNet& net, int span, const Boundary& boundary) const;
  Cell makeCollapsedCell(const CollapsedKey& key, const Eigen::Vector3d& point, int nets) const;

  std::array<SplineDirection, 2> directions_;
  std::vector<Eigen::Vector3d> poles_;
  std::vector<double> weights_;
  int count_v_ = 0;
  std::array<std::vector<Span>, 2> spans_;
  mutable std::array<std::map<int, SpanMatrices>, 2> matrices_;
  mutable std::map<std::pair<int, int>, Cell> cells_;
  mutable std::map<CollapsedKey, Cell> collapsed_cells_;
  mutable std::map<LineKey, LineCell> line_cells_;
};

}  // namespace seamwright
