// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/join/condition/construct.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/python/surfaces.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

using Function = Eigen::VectorXd ConnectionFunctions::*;
constexpr std::pair<const char*, Function> connection_functions[] = {
    {"alpha", &ConnectionFunctions::alpha}, {"beta", &ConnectionFunctions::beta},
    {"p", &ConnectionFunctions::p},         {"q", &ConnectionFunctions::q},
    {"h", &ConnectionFunctions::h},         {"k", &ConnectionFunctions::k},
    {"e0", &ConnectionFunctions::e0},       {"e1", &ConnectionFunctions::e1},
    {"e2", &ConnectionFunctions::e2},       {"e3", &ConnectionFunctions::e3}};

/// Bernstein coefficients, from one number or a sequence.
Eigen::VectorXd functionOf(const char* name, const py::object& value) {
  constexpr const char* kind = "a number or a sequence of Bernstein coefficients";
  if (isNumber(value)) return Eigen::VectorXd::Constant(1, argument<double>(name, value, kind));
  const auto values = argument<std::vector<double>>(name, value, kind);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The functions of a dict.
ConnectionFunctions connectionOf(const py::dict& items) {
  ConnectionFunctions connection;
  for (const auto& [name, function] : connection_functions)
    if (items.contains(name)) connection.*function = functionOf(name, py::object(items[name]));
  return connection;
}

void requireFunctions(const py::dict& items) {
  for (const auto& [key, value] : items) {
    const auto name = py::cast<std::string>(py::str(key));
    const auto known = [&](const auto& function) { return name == function.first; };
    if (std::ranges::none_of(connection_functions, known))
      throw py::type_error("unknown argument '" + name + "'");
  }
}

/// The connection of a dict of functions, or of a result that has one. Results hold other items
/// too.
ConnectionFunctions givenConnectionOf(const char* name, const py::object& value) {
  const py::object given = itemOrSelf(value, "connection");
  if (!py::isinstance<py::dict>(given))
    throw py::value_error(std::string(name) + " is " + shown(value) +
                          ": a dict of functions, or a result that has them, is needed");
  const auto items = py::reinterpret_borrow<py::dict>(given);
  const bool is_result = itemOrSelf(given, "alpha").ptr() != given.ptr();
  if (!is_result) requireFunctions(items);
  return connectionOf(items);
}

/// The arguments that every construction of a join has.
struct FunctionArguments {
  std::array<py::object, std::size(connection_functions)>
      values;  ///< in the order of functions; None: not given
  py::object connection;
};

/// The functions of the argument connection, replaced by those that are given one by one.
ConnectionFunctions connectionFrom(const FunctionArguments& given) {
  ConnectionFunctions connection;
  if (!given.connection.is_none()) connection = givenConnectionOf("connection", given.connection);
  for (std::size_t i = 0; i < std::size(connection_functions); ++i)
    if (!given.values[i].is_none())
      connection.*connection_functions[i].second =
          functionOf(connection_functions[i].first, given.values[i]);
  return connection;
}

std::optional<double> optionalTolerance(const py::object& value) {
  return optionalNumber("tolerance", value);
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

Ribbon givenOf(const py::object& surface, const py::object& edge, const py::object& reversed) {
  return ribbonOf("surface", surface, "edge", edge, flagOf("reversed", reversed), Across::OutOf);
}

/// The rows of a tensor-product patch that joins a ribbon.
struct TensorArguments {
  const py::object& order;
  const py::object& degree_across;
  const py::object& degree;
};

struct TensorDegrees {
  int order = 1, across = 1;
  std::optional<int> along;
};

TensorDegrees degreesOf(const TensorArguments& given, const Ribbon& ribbon) {
  const int order = optionalWhole("order", given.order).value_or(1);
  const int across = optionalWhole("degree_across", given.degree_across)
                         .value_or(std::max(order, ribbon.degree_across));
  return {.order = order, .across = across, .along = optionalWhole("degree", given.degree)};
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

py::tuple ribbonRowsOf(const py::object& surface, const py::object& edge, const py::object& alpha,
                       const py::object& beta, const py::object& p, const py::object& q,
                       const py::object& h, const py::object& k, const py::object& e0,
                       const py::object& e1, const py::object& e2, const py::object& e3,
                       const py::object& connection, const py::object& order,
                       const py::object& degree_across, const py::object& degree,
                       const py::object& reversed) {
  const Ribbon given = givenOf(surface, edge, reversed);
  const TensorDegrees d = degreesOf({order, degree_across, degree}, given);
  const ConnectionFunctions functions_of =
      connectionFrom({{alpha, beta, p, q, h, k, e0, e1, e2, e3}, connection});
  return arraysOf(tensorRows(given, functions_of, d.order, d.across, d.along).rows);
}

BezierPatch continuationOf(const py::object& surface, const py::object& edge,
                           const py::object& alpha, const py::object& beta, const py::object& p,
                           const py::object& q, const py::object& h, const py::object& k,
                           const py::object& e0, const py::object& e1, const py::object& e2,
                           const py::object& e3, const py::object& connection,
                           const py::object& order, const py::object& degree_across,
                           const py::object& degree, const py::object& reversed) {
  const Ribbon given = givenOf(surface, edge, reversed);
  const TensorDegrees d = degreesOf({order, degree_across, degree}, given);
  const ConnectionFunctions functions_of =
      connectionFrom({{alpha, beta, p, q, h, k, e0, e1, e2, e3}, connection});
  return continuation(given, functions_of, d.order, d.across, d.along);
}

BezierTriangle triangleContinuationOf(const py::object& surface, const py::object& edge,
                                      const py::object& alpha, const py::object& beta,
                                      const py::object& p, const py::object& q, const py::object& h,
                                      const py::object& k, const py::object& e0,
                                      const py::object& e1, const py::object& e2,
                                      const py::object& e3, const py::object& connection,
                                      const py::object& order, const py::object& degree,
                                      const py::object& reversed) {
  return triangleContinuation(
      givenOf(surface, edge, reversed),
      connectionFrom({{alpha, beta, p, q, h, k, e0, e1, e2, e3}, connection}),
      optionalWhole("order", order).value_or(1), optionalWhole("degree", degree));
}

BezierTriangle joinedTriangle(const BezierTriangle& triangle, const py::object& edge, bool reversed,
                              const Ribbon& from, const ConnectionFunctions& connection,
                              int order) {
  const Ribbon old = ribbon(triangle, triangleEdgeOf("edge", edge), reversed, Across::Into);
  JoinRows rows = triangleRows(from, connection, order);
  if (rows.degree_across < old.degree_across)
    rows = triangleRows(from, connection, order, old.degree_across);
  return withRows(triangle, triangleEdgeOf("edge", edge), reversed, rows);
}

py::object joinedOf(const py::object& surface, const py::object& edge, const py::object& given,
                    const py::object& given_edge, const py::object& alpha, const py::object& beta,
                    const py::object& p, const py::object& q, const py::object& h,
                    const py::object& k, const py::object& e0, const py::object& e1,
                    const py::object& e2, const py::object& e3, const py::object& connection,
                    const py::object& order, const py::object& reversed) {
  const bool backwards = flagOf("reversed", reversed);
  const Ribbon from = ribbonOf("given", given, "given_edge", given_edge, false, Across::OutOf);
  const ConnectionFunctions functions_of =
      connectionFrom({{alpha, beta, p, q, h, k, e0, e1, e2, e3}, connection});
  const int highest = optionalWhole("order", order).value_or(1);
  const Ribbon old = ribbonOf("surface", surface, "edge", edge, backwards, Across::Into);
  if (py::isinstance<BezierTriangle>(surface))
    return py::cast(joinedTriangle(surface.cast<const BezierTriangle&>(), edge, backwards, from,
                                   functions_of, highest));
  return py::cast(withRows(surface.cast<const BezierPatch&>(), patchEdgeOf("edge", edge), backwards,
                           tensorRows(from, functions_of, highest, old.degree_across)));
}

BezierPatch blendOf(const py::object& a, const py::object& edge_a, const py::object& b,
                    const py::object& edge_b, const py::object& order, const py::object& reversed,
                    const py::object& to_a, const py::object& to_b) {
  return blend(ribbonOf("a", a, "edge_a", edge_a, false, Across::OutOf),
               givenConnectionOf("to_a", to_a),
               ribbonOf("b", b, "edge_b", edge_b, flagOf("reversed", reversed), Across::OutOf),
               givenConnectionOf("to_b", to_b), wholeNumber("order", order));
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
  for (const auto& [name, function] : connection_functions) dict[name] = connection.*function;
  return dict;
}

struct RibbonPair {
  Ribbon a, b;
};

RibbonPair pairOf(const py::object& a, const py::object& edge_a, const py::object& b,
                  const py::object& edge_b, const py::object& reversed) {
  return {ribbonOf("a", a, "edge_a", edge_a, false, Across::OutOf),
          ribbonOf("b", b, "edge_b", edge_b, flagOf("reversed", reversed), Across::Into)};
}

py::object joinConditionOf(const py::object& a, const py::object& edge_a, const py::object& b,
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
  // Not judged of sides of a high degree: docs/joins.md.
  dict["g3"] = condition.g2() && !condition.curvature_change
                   ? py::object(py::none())
                   : py::object(py::bool_(condition.g3()));
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
  dict["curvature_change"] = condition.curvature_change
                                 ? py::object(residualDict(*condition.curvature_change))
                                 : py::none();
  dict["parameter"] = parameterDict(condition.parameter, condition.parameter_of_a);
  return resultOf("JoinCondition", dict);
}

py::object fitConnectionOf(const py::object& a, const py::object& edge_a, const py::object& b,
                           const py::object& edge_b, const py::object& reversed,
                           const py::object& order, const py::object& alpha_degree,
                           const py::object& beta_degree, const py::object& p_degree,
                           const py::object& q_degree, const py::object& h_degree,
                           const py::object& k_degree, const py::object& tolerance) {
  const RibbonPair pair = pairOf(a, edge_a, b, edge_b, reversed);
  ConnectionFitOptions options;
  options.order = wholeNumber("order", order);
  options.alpha_degree = optionalWhole("alpha_degree", alpha_degree);
  options.beta_degree = optionalWhole("beta_degree", beta_degree);
  options.p_degree = optionalWhole("p_degree", p_degree);
  options.q_degree = optionalWhole("q_degree", q_degree);
  options.h_degree = optionalWhole("h_degree", h_degree);
  options.k_degree = optionalWhole("k_degree", k_degree);
  options.tolerance = optionalTolerance(tolerance);
  const ConnectionFit fit = fitConnection(pair.a, pair.b, options);
  py::dict dict;
  dict["found"] = fit.found;
  dict["connection"] = connectionDict(fit.connection);
  dict["residual"] = fit.residual;
  dict["noise"] = fit.noise;
  dict["condition"] = fit.condition;
  dict["note"] = fit.note;
  dict["parameter"] = parameterDict(fit.parameter, fit.parameter_of_a);
  return resultOf("ConnectionFit", dict);
}

py::tuple orientOf(const py::object& a, const py::object& edge_a, const py::object& b,
                   const py::object& edge_b) {
  const CanonicalPair pair =
      orient(objectOf<BezierPatch>("a", a, "a BezierPatch"), patchEdgeOf("edge_a", edge_a),
             objectOf<BezierPatch>("b", b, "a BezierPatch"), patchEdgeOf("edge_b", edge_b));
  return py::make_tuple(pair.a, pair.b, pair.reversed);
}

constexpr const char* join_rows_doc =
    R"(The first rows of a patch that joins a BezierPatch or BezierTriangle along an edge.

Returns poles (order+1, n+1, 3) in mm and weights (order+1, n+1), counted from the seam.

alpha, beta, p, q, h, k: each a number or the Bernstein coefficients of a polynomial along the seam,
None: alpha 1, the others 0. Q_s = alpha P_s + beta P_t, for order 2 also Q_ss = alpha^2 P_ss + 2
alpha beta P_st + beta^2 P_tt + p P_s + q P_t, and for order 3 Q_sss = alpha^3 P_sss + 3 alpha^2
beta P_sst + 3 alpha beta^2 P_stt + beta^3 P_ttt + 3 (alpha p P_ss + (alpha q + beta p) P_st + beta
q P_tt) + h P_s + k P_t. e0 to e3, None: 1, 0, 0, 0, scale homogeneous poles.
connection: a dict of these functions, or a result that has them, as for nearest_join() or
fit_connection(); single ones replace its own.
order: 1, 2 or 3. degree_across: of the new patch, None: that of the given one. degree: along the
seam, None: the lowest that always does. reversed: the edge is run backwards.
ValueError for bad arguments, and for functions that do not make a join, with their values.)";

constexpr const char* continuation_doc =
    R"(The BezierPatch beyond an edge of a BezierPatch or BezierTriangle.

It joins along u = 0, with v along the edge, and has no derivatives by u above the order.
Arguments as for join_rows.)";

constexpr const char* triangle_continuation_doc =
    R"(The BezierTriangle beyond an edge of a BezierPatch or BezierTriangle.

It joins along its edge 'l0', P1 to P2, and has no derivatives across it above the order. Arguments
as for join_rows.)";

constexpr const char* joined_doc =
    R"(A BezierPatch or BezierTriangle with the rows behind its edge replaced by those that join
another.

The other poles stay, unless the join needs a higher degree: then the surface is raised first.
Further arguments as for join_rows; reversed: the surface's edge is run backwards.)";

void bindRows(py::module_& module) {
  module.def("join_rows", &ribbonRowsOf, join_rows_doc, py::arg("surface"), py::arg("edge"),
             py::kw_only(), py::arg("alpha") = py::none(), py::arg("beta") = py::none(),
             py::arg("p") = py::none(), py::arg("q") = py::none(), py::arg("h") = py::none(),
             py::arg("k") = py::none(), py::arg("e0") = py::none(), py::arg("e1") = py::none(),
             py::arg("e2") = py::none(), py::arg("e3") = py::none(),
             py::arg("connection") = py::none(), py::arg("order") = 1,
             py::arg("degree_across") = py::none(), py::arg("degree") = py::none(),
             py::arg("reversed") = false);
  module.def("continuation", &continuationOf, continuation_doc, py::arg("surface"), py::arg("edge"),
             py::kw_only(), py::arg("alpha") = py::none(), py::arg("beta") = py::none(),
             py::arg("p") = py::none(), py::arg("q") = py::none(), py::arg("h") = py::none(),
             py::arg("k") = py::none(), py::arg("e0") = py::none(), py::arg("e1") = py::none(),
             py::arg("e2") = py::none(), py::arg("e3") = py::none(),
             py::arg("connection") = py::none(), py::arg("order") = 1,
             py::arg("degree_across") = py::none(), py::arg("degree") = py::none(),
             py::arg("reversed") = false);
  module.def("triangle_continuation", &triangleContinuationOf, triangle_continuation_doc,
             py::arg("surface"), py::arg("edge"), py::kw_only(), py::arg("alpha") = py::none(),
             py::arg("beta") = py::none(), py::arg("p") = py::none(), py::arg("q") = py::none(),
             py::arg("h") = py::none(), py::arg("k") = py::none(), py::arg("e0") = py::none(),
             py::arg("e1") = py::none(), py::arg("e2") = py::none(), py::arg("e3") = py::none(),
             py::arg("connection") = py::none(), py::arg("order") = 1,
             py::arg("degree") = py::none(), py::arg("reversed") = false);
  module.def("joined", &joinedOf, joined_doc, py::arg("surface"), py::arg("edge"), py::arg("given"),
             py::arg("given_edge"), py::kw_only(), py::arg("alpha") = py::none(),
             py::arg("beta") = py::none(), py::arg("p") = py::none(), py::arg("q") = py::none(),
             py::arg("h") = py::none(), py::arg("k") = py::none(), py::arg("e0") = py::none(),
             py::arg("e1") = py::none(), py::arg("e2") = py::none(), py::arg("e3") = py::none(),
             py::arg("connection") = py::none(), py::arg("order") = 1, py::arg("reversed") = false);
}

void bindPatchBlend(py::module_& module) {
  module.def(
      "blend", &blendOf, py::arg("a"), py::arg("edge_a"), py::arg("b"), py::arg("edge_b"),
      py::arg("order") = 1, py::kw_only(), py::arg("reversed") = false,
      py::arg("to_a") = py::dict(), py::arg("to_b") = py::dict(),
      "The BezierPatch of degree 2 order + 1 in u between two surfaces: it joins a at u = 0 and b "
      "at u = 1. to_a and to_b are connections as in join_rows; reversed runs the edge of b "
      "backwards.");
  module.def(
      "orient", &orientOf, py::arg("a"), py::arg("edge_a"), py::arg("b"), py::arg("edge_b"),
      "Two BezierPatches in common parameters: (a, b, reversed), with the seam at u = 1 of a and "
      "u = 0 of b, and v along it on both; reversed says whether the edge of b had to be run "
      "backwards.");
}

void bindConditions(py::module_& module) {
  module.def(
      "join_condition", &joinConditionOf, py::arg("a"), py::arg("edge_a"), py::arg("b"),
      py::arg("edge_b"), py::kw_only(), py::arg("reversed") = false,
      py::arg("tolerance") = py::none(), py::arg("connection") = py::none(),
      R"(Whether two surfaces join along an edge of each, from polynomials that vanish iff they
do: a JoinCondition.

a, b: BezierPatch or BezierTriangle. tolerance: of relative residuals, None: what rounding makes
of 0.
connection: as in join_rows, None: curvature is judged without.)");
  module.def("fit_connection", &fitConnectionOf, py::arg("a"), py::arg("edge_a"), py::arg("b"),
             py::arg("edge_b"), py::kw_only(), py::arg("reversed") = false, py::arg("order") = 1,
             py::arg("alpha_degree") = py::none(), py::arg("beta_degree") = py::none(),
             py::arg("p_degree") = py::none(), py::arg("q_degree") = py::none(),
             py::arg("h_degree") = py::none(), py::arg("k_degree") = py::none(),
             py::arg("tolerance") = py::none(),
             R"(The functions alpha, beta, ... that connect two surfaces: a ConnectionFit.

Degrees of None ascend until the residual is within the tolerance, or within noise.)");
}

}  // namespace

void bindJoin(py::module_& module) {
  bindRows(module);
  bindPatchBlend(module);
  bindConditions(module);
}

}  // namespace seamwright::python
