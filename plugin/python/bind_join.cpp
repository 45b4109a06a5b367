// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/join/condition/construct.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

using Function = Eigen::VectorXd ConnectionFunctions::*;
constexpr std::pair<const char*, Function> functions[] = {
    {"alpha", &ConnectionFunctions::alpha}, {"beta", &ConnectionFunctions::beta},
    {"p", &ConnectionFunctions::p},         {"q", &ConnectionFunctions::q},
    {"e0", &ConnectionFunctions::e0},       {"e1", &ConnectionFunctions::e1},
    {"e2", &ConnectionFunctions::e2}};

/// Bernstein coefficients, from one number or a sequence.
Eigen::VectorXd functionOf(const char* name, const py::object& value) {
  constexpr const char* kind = "a number or a sequence of Bernstein coefficients";
  if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value))
    return Eigen::VectorXd::Constant(1, argument<double>(name, value, kind));
  const auto values = argument<std::vector<double>>(name, value, kind);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The connection from keywords or a dict; other keys are ignored.
ConnectionFunctions connectionOf(const py::dict& keywords) {
  ConnectionFunctions connection;
  for (const auto& [name, function] : functions)
    if (keywords.contains(name))
      connection.*function = functionOf(name, py::object(keywords[name]));
  return connection;
}

/// \param others further keys that are allowed.
void requireKnown(const py::dict& keywords, std::initializer_list<const char*> others) {
  for (const auto& [key, value] : keywords) {
    const auto name = py::cast<std::string>(key);
    bool known = false;
    for (const auto& [function_name, function] : functions) known |= name == function_name;
    for (const char* other : others) known |= name == other;
    if (!known) throw py::type_error("unknown argument '" + name + "'");
  }
}

/// The connection from a dict that may contain only functions.
ConnectionFunctions givenConnectionOf(const char* name, const py::object& value) {
  if (!py::isinstance<py::dict>(value))
    throw py::value_error(std::string(name) + " is " + shown(value) +
                          ": a dict of functions is needed");
  const py::dict functions_of = value.cast<py::dict>();
  requireKnown(functions_of, {});
  return connectionOf(functions_of);
}

py::object keyword(const py::dict& keywords, const char* name) {
  return keywords.contains(name) ? py::object(keywords[name]) : py::object(py::none());
}

std::optional<int> optionalWhole(const char* name, const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return argument<int>(name, value, "a whole number");
}

std::optional<double> optionalTolerance(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return argument<double>("tolerance", value, "a number");
}

bool isReversed(const py::object& value) {
  if (!PyBool_Check(value.ptr()))
    throw py::value_error("reversed is " + shown(value) + ": True or False is needed");
  return value.cast<bool>();
}

/// The ribbon of a BezierPatch or a BezierTriangle.
Ribbon ribbonOf(const char* name, const py::object& surface, const char* edge_name,
                const py::object& edge, bool reversed, Across across) {
  if (py::isinstance<BezierPatch>(surface))
    return ribbon(surface.cast<const BezierPatch&>(), patchEdgeOf(edge_name, edge), reversed,
                  across);
  if (py::isinstance<BezierTriangle>(surface))
    return ribbon(surface.cast<const BezierTriangle&>(), triangleEdgeOf(edge_name, edge), reversed,
                  across);
  throw py::value_error(std::string(name) + " is " + shown(surface) +
                        ": a BezierPatch or a BezierTriangle is needed");
}

Ribbon givenOf(const py::object& surface, const py::object& edge, const py::dict& keywords) {
  const bool reversed = keywords.contains("reversed") && isReversed(keyword(keywords, "reversed"));
  return ribbonOf("surface", surface, "edge", edge, reversed, Across::OutOf);
}

struct TensorArguments {
  int order = 1, degree_across = 1;
  std::optional<int> degree;
};

TensorArguments tensorArguments(const py::dict& keywords, const Ribbon& given) {
  const int order = optionalWhole("order", keyword(keywords, "order")).value_or(1);
  const int across = optionalWhole("degree_across", keyword(keywords, "degree_across"))
                         .value_or(std::max(order, given.degree_across));
  return {order, across, optionalWhole("degree", keyword(keywords, "degree"))};
}

py::tuple arraysOf(const std::vector<HomogeneousPoles>& rows) {
  const auto count = static_cast<py::ssize_t>(rows.size()),
             columns = static_cast<py::ssize_t>(rows.front().rows());
  Array poles({count, columns, py::ssize_t{3}}), weights({count, columns});
  for (py::ssize_t r = 0; r < count; ++r) {
    Eigen::Map<Poles>(poles.mutable_data(r), columns, 3) =
        affinePoles(rows[static_cast<std::size_t>(r)]);
    Eigen::Map<Eigen::VectorXd>(weights.mutable_data(r), columns) =
        rows[static_cast<std::size_t>(r)].col(3);
  }
  return py::make_tuple(poles, weights);
}

py::tuple ribbonRowsOf(const py::object& surface, const py::object& edge,
                       const py::kwargs& keywords) {
  requireKnown(keywords, {"order", "degree_across", "degree", "reversed"});
  const Ribbon given = givenOf(surface, edge, keywords);
  const TensorArguments a = tensorArguments(keywords, given);
  return arraysOf(
      tensorRows(given, connectionOf(keywords), a.order, a.degree_across, a.degree).rows);
}

BezierPatch continuationOf(const py::object& surface, const py::object& edge,
                           const py::kwargs& keywords) {
  requireKnown(keywords, {"order", "degree_across", "degree", "reversed"});
  const Ribbon given = givenOf(surface, edge, keywords);
  const TensorArguments a = tensorArguments(keywords, given);
  return continuation(given, connectionOf(keywords), a.order, a.degree_across, a.degree);
}

BezierTriangle triangleContinuationOf(const py::object& surface, const py::object& edge,
                                      const py::kwargs& keywords) {
  requireKnown(keywords, {"degree", "reversed"});
  return triangleContinuation(givenOf(surface, edge, keywords), connectionOf(keywords),
                              optionalWhole("degree", keyword(keywords, "degree")));
}

py::object joinedOf(const py::object& surface, const py::object& edge, const py::object& given,
                    const py::object& given_edge, const py::kwargs& keywords) {
  requireKnown(keywords, {"order", "reversed"});
  const bool reversed = keywords.contains("reversed") && isReversed(keyword(keywords, "reversed"));
  const Ribbon from = ribbonOf("given", given, "given_edge", given_edge, false, Across::OutOf);
  const ConnectionFunctions connection = connectionOf(keywords);
  const int order = optionalWhole("order", keyword(keywords, "order")).value_or(1);
  const Ribbon old = ribbonOf("surface", surface, "edge", edge, reversed, Across::Into);
  if (py::isinstance<BezierPatch>(surface))
    return py::cast(withRows(surface.cast<const BezierPatch&>(), patchEdgeOf("edge", edge),
                             reversed, tensorRows(from, connection, order, old.degree_across)));
  if (order != 1)
    throw py::value_error("order " + std::to_string(order) + ": triangles are joined with order 1");
  JoinRows rows = triangleRows(from, connection);
  if (rows.degree_across < old.degree_across)
    rows = triangleRows(from, connection, old.degree_across);
  return py::cast(withRows(surface.cast<const BezierTriangle&>(), triangleEdgeOf("edge", edge),
                           reversed, rows));
}

BezierPatch blendOf(const py::object& a, const py::object& edge_a, const py::object& b,
                    const py::object& edge_b, const py::object& order, const py::object& reversed,
                    const py::object& to_a, const py::object& to_b) {
  return blend(ribbonOf("a", a, "edge_a", edge_a, false, Across::OutOf),
               givenConnectionOf("to_a", to_a),
               ribbonOf("b", b, "edge_b", edge_b, isReversed(reversed), Across::OutOf),
               givenConnectionOf("to_b", to_b), argument<int>("order", order, "a whole number"));
}

py::dict residualDict(const JoinResidual& residual) {
  py::dict dict;
  dict["holds"] = residual.holds;
  dict["relative"] = residual.relative;
  dict["noise"] = residual.noise;
  dict["at"] = residual.at;
  dict["coefficients"] = residual.coefficients;
  return dict;
}

py::dict connectionDict(const ConnectionFunctions& connection) {
  py::dict dict;
  for (const auto& [name, function] : functions) dict[name] = connection.*function;
  return dict;
}

struct RibbonPair {
  Ribbon a, b;
};

RibbonPair pairOf(const py::object& a, const py::object& edge_a, const py::object& b,
                  const py::object& edge_b, const py::object& reversed) {
  return {ribbonOf("a", a, "edge_a", edge_a, false, Across::OutOf),
          ribbonOf("b", b, "edge_b", edge_b, isReversed(reversed), Across::Into)};
}

py::dict joinConditionOf(const py::object& a, const py::object& edge_a, const py::object& b,
                         const py::object& edge_b, const py::object& reversed,
                         const py::object& tolerance, const py::object& connection) {
  const RibbonPair pair = pairOf(a, edge_a, b, edge_b, reversed);
  JoinConditionOptions options;
  options.tolerance = optionalTolerance(tolerance);
  if (!connection.is_none()) options.connection = givenConnectionOf("connection", connection);
  const JoinCondition condition = joinCondition(pair.a, pair.b, options);
  const bool planes = condition.verdict != JoinVerdict::Singular;
  py::dict dict;
  dict["verdict"] = name(condition.verdict);
  dict["g2"] = condition.g2();
  dict["parametric_order"] = condition.parametric_order;
  dict["gap_bound_mm"] = condition.gap_bound_mm;
  dict["angle_bound_rad"] = condition.angle_bound_rad;
  dict["singular_at"] = condition.singular_at;
  dict["position"] = residualDict(condition.position);
  dict["first"] = residualDict(condition.first);
  dict["second"] = residualDict(condition.second);
  dict["tangent_plane"] = planes ? py::object(residualDict(condition.tangent_plane)) : py::none();
  dict["curvature"] =
      condition.curvature ? py::object(residualDict(*condition.curvature)) : py::none();
  return dict;
}

py::dict fitConnectionOf(const py::object& a, const py::object& edge_a, const py::object& b,
                         const py::object& edge_b, const py::object& reversed,
                         const py::object& order, const py::object& alpha_degree,
                         const py::object& beta_degree, const py::object& p_degree,
                         const py::object& q_degree, const py::object& tolerance) {
  const RibbonPair pair = pairOf(a, edge_a, b, edge_b, reversed);
  ConnectionFitOptions options;
  options.order = argument<int>("order", order, "a whole number");
  options.alpha_degree = optionalWhole("alpha_degree", alpha_degree);
  options.beta_degree = optionalWhole("beta_degree", beta_degree);
  options.p_degree = optionalWhole("p_degree", p_degree);
  options.q_degree = optionalWhole("q_degree", q_degree);
  options.tolerance = optionalTolerance(tolerance);
  const ConnectionFit fit = fitConnection(pair.a, pair.b, options);
  py::dict dict;
  dict["found"] = fit.found;
  dict["connection"] = connectionDict(fit.connection);
  dict["residual"] = fit.residual;
  dict["noise"] = fit.noise;
  dict["condition"] = fit.condition;
  dict["note"] = fit.note;
  return dict;
}

py::tuple orientOf(const BezierPatch& a, const py::object& edge_a, const BezierPatch& b,
                   const py::object& edge_b) {
  const CanonicalPair pair =
      orient(a, patchEdgeOf("edge_a", edge_a), b, patchEdgeOf("edge_b", edge_b));
  return py::make_tuple(pair.a, pair.b, pair.reversed);
}

void bindConstructions(py::module_& module) {
  module.def(
      "join_rows", &ribbonRowsOf, py::arg("surface"), py::arg("edge"),
      "The first rows of a patch that joins a BezierPatch or BezierTriangle along an edge: poles "
      "(order+1, n+1, 3) and weights (order+1, n+1), counted from the seam.\n\n"
      "Keywords: alpha=1, beta=0 and, for order 2, p=0, q=0, each a number or the Bernstein "
      "coefficients of a polynomial along the seam: Q_s = alpha P_s + beta P_t, Q_ss = alpha^2 "
      "P_ss "
      "+ 2 alpha beta P_st + beta^2 P_tt + p P_s + q P_t; e0=1, e1=0, e2=0 scale homogeneous "
      "poles; "
      "order=1 or 2; degree_across of the new patch, None: that of the given one; degree along the "
      "seam, None: the lowest that always does; reversed=False: True runs the edge backwards. "
      "ValueError for functions that do not make a join, with their values.");
  module.def("continuation", &continuationOf, py::arg("surface"), py::arg("edge"),
             "The BezierPatch beyond an edge of a BezierPatch or BezierTriangle that joins it "
             "along u = 0, "
             "with v along the edge, and has no derivatives by u above the order. Keywords as of "
             "join_rows.");
  module.def(
      "triangle_continuation", &triangleContinuationOf, py::arg("surface"), py::arg("edge"),
      "The BezierTriangle beyond an edge of a BezierPatch or BezierTriangle that joins it G1 along "
      "its edge 'l0', P1 to P2. Keywords: alpha=1, beta=0, e0=1, e1=0 as of join_rows, degree=None "
      "and reversed=False.");
  module.def(
      "joined", &joinedOf, py::arg("surface"), py::arg("edge"), py::arg("given"),
      py::arg("given_edge"),
      "The surface, a BezierPatch or BezierTriangle, with the rows behind its edge replaced by "
      "those that join the given one; the other poles stay, unless the join needs a higher degree: "
      "then the surface is raised first. Keywords: those of the functions in join_rows, order=1, "
      "reversed=False: True runs the surface's edge backwards.");
  module.def(
      "blend", &blendOf, py::arg("a"), py::arg("edge_a"), py::arg("b"), py::arg("edge_b"),
      py::arg("order") = 1, py::kw_only(), py::arg("reversed") = false,
      py::arg("to_a") = py::dict(), py::arg("to_b") = py::dict(),
      "The BezierPatch of degree 2 order + 1 in u between two surfaces: it joins a at u = 0 and b "
      "at u = 1. to_a and to_b are dicts of the functions in join_rows; reversed runs the edge of "
      "b "
      "backwards.");
}

void bindConditions(py::module_& module) {
  module.def(
      "join_condition", &joinConditionOf, py::arg("a"), py::arg("edge_a"), py::arg("b"),
      py::arg("edge_b"), py::kw_only(), py::arg("reversed") = false,
      py::arg("tolerance") = py::none(), py::arg("connection") = py::none(),
      "Whether two surfaces join along an edge of each, from polynomials that vanish iff they do: "
      "a "
      "dict of verdict ('G1', 'fold', 'not G1', 'singular'), g2, parametric_order, bounds of gap "
      "and angle, and the residuals.\n\n"
      "tolerance is of relative residuals, None: what rounding makes of 0. connection is a dict of "
      "the functions in join_rows, None: curvature is judged without.");
  module.def(
      "fit_connection", &fitConnectionOf, py::arg("a"), py::arg("edge_a"), py::arg("b"),
      py::arg("edge_b"), py::kw_only(), py::arg("reversed") = false, py::arg("order") = 1,
      py::arg("alpha_degree") = py::none(), py::arg("beta_degree") = py::none(),
      py::arg("p_degree") = py::none(), py::arg("q_degree") = py::none(),
      py::arg("tolerance") = py::none(),
      "The functions alpha, beta, ... that connect two surfaces, as a dict of found, connection, "
      "residual, noise, condition and note. Degrees of None ascend until the residual is within "
      "the "
      "tolerance, or within noise.");
  module.def(
      "orient", &orientOf, py::arg("a"), py::arg("edge_a"), py::arg("b"), py::arg("edge_b"),
      "Two patches in common parameters: (a, b, reversed), with the seam at u = 1 of a and u = 0 "
      "of "
      "b, and v along it on both; reversed says whether the edge of b had to be run backwards.");
}

}  // namespace

void bindJoin(py::module_& module) {
  bindConstructions(module);
  bindConditions(module);
}

}  // namespace seamwright::python
