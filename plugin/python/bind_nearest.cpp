// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/join/nearest/nearest.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <variant>

namespace seamwright::python {

namespace {

using NumberArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Mask = py::array_t<bool, py::array::c_style | py::array::forcecast>;
using Surface = std::variant<BSplineSurface, BezierPatch>;

std::string shapeText(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i)
    text += (i ? ", " : "") + std::to_string(array.shape(i));
  return text + ")";
}

void requireShape(const py::array& array, py::ssize_t nu, py::ssize_t nv, const std::string& name) {
  if (array.ndim() != 2 || array.shape(0) != nu || array.shape(1) != nv)
    throw py::value_error(name + " have shape " + shapeText(array) + ": one for each pole, (" +
                          std::to_string(nu) + ", " + std::to_string(nv) + "), is needed");
}

BSplineSurface makeSurface(const NumberArray& poles, std::vector<double> knots_u,
                           std::vector<double> knots_v, int degree_u, int degree_v,
                           const std::optional<NumberArray>& weights) {
  if (poles.ndim() != 3 || poles.shape(2) != 3)
    throw py::value_error("poles have shape " + shapeText(poles) + ": (nu, nv, 3) is needed");
  if (weights) requireShape(*weights, poles.shape(0), poles.shape(1), "weights");
  BSplineSurface surface{degree_u, degree_v, std::move(knots_u), std::move(knots_v), {}};
  const py::ssize_t count = poles.shape(0) * poles.shape(1);
  const Eigen::Map<const Poles> rows(poles.data(), count, 3);
  Eigen::VectorXd w = Eigen::VectorXd::Ones(count);
  if (weights) w = Eigen::Map<const Eigen::VectorXd>(weights->data(), count);
  surface.poles.resize(count, 4);
  surface.poles << w.asDiagonal() * rows, w;
  requireValid(surface);
  if (surface.countU() != poles.shape(0) || surface.countV() != poles.shape(1))
    throw py::value_error("poles have shape " + shapeText(poles) + ", knots are for " +
                          std::to_string(surface.countU()) + " by " +
                          std::to_string(surface.countV()));
  return surface;
}

NumberArray splineNetPoles(const BSplineSurface& surface) {
  NumberArray result({surface.countU(), surface.countV(), 3});
  Eigen::Map<Poles>(result.mutable_data(), surface.poles.rows(), 3) =
      surface.poles.leftCols<3>().array().colwise() / surface.poles.col(3).array();
  return result;
}

NumberArray splineNetWeights(const BSplineSurface& surface) {
  NumberArray result({surface.countU(), surface.countV()});
  Eigen::Map<Eigen::VectorXd>(result.mutable_data(), result.size()) = surface.poles.col(3);
  return result;
}

PatchEdge edgeOf(const std::string& name) {
  const std::optional<PatchEdge> edge = patchEdgeFromName(name);
  if (!edge) throw py::value_error("edge is '" + name + "': one of u0, u1, v0, v1 is needed");
  return *edge;
}

SurfaceDirection directionOf(const std::string& name) {
  if (name == "u") return SurfaceDirection::U;
  if (name == "v") return SurfaceDirection::V;
  throw py::value_error("direction is '" + name + "': u or v is needed");
}

BSplineSurface splineOf(const Surface& surface) {
  if (const auto* patch = std::get_if<BezierPatch>(&surface)) return splineSurface(*patch);
  return std::get<BSplineSurface>(surface);
}

int degreeAlong(const JoinSide& side) {
  return along(side.edge) == SurfaceDirection::V ? side.surface.degree_v : side.surface.degree_u;
}

JoinSide sideOf(const Surface& surface, const std::string& edge,
                const std::optional<NumberArray>& weights, const std::optional<Mask>& fixed,
                const std::string& name) {
  JoinSide side{splineOf(surface), edgeOf(edge)};
  const int nu = side.surface.countU(), nv = side.surface.countV();
  if (weights) {
    requireShape(*weights, nu, nv, "weights_" + name);
    side.weights = Eigen::Map<const Eigen::VectorXd>(weights->data(), weights->size());
  }
  if (fixed) {
    requireShape(*fixed, nu, nv, "fixed_" + name);
    side.fixed.assign(fixed->data(), fixed->data() + fixed->size());
  }
  return side;
}

/// Raises a Bezier patch to \p degree along the seam.
void elevate(JoinSide& side, int degree, const Surface& given) {
  if (degreeAlong(side) >= degree || !std::holds_alternative<BezierPatch>(given)) return;
  if (side.weights.size() != 0 || !side.fixed.empty())
    throw py::value_error(
        "weights and fixed poles belong to poles: raise the degree along the seam, " +
        std::to_string(degreeAlong(side)) + ", to " + std::to_string(degree) + " first");
  while (degreeAlong(side) < degree) side.surface = elevated(side.surface, along(side.edge));
}

py::object asGiven(const BSplineSurface& surface, const Surface& given) {
  if (std::holds_alternative<BezierPatch>(given)) return py::cast(bezierPatch(surface));
  return py::cast(surface);
}

const char* statusName(NearestStatus status) {
  switch (status) {
    case NearestStatus::Joined:
      return "joined";
    case NearestStatus::Unchanged:
      return "unchanged";
    case NearestStatus::Infeasible:
      return "infeasible";
    case NearestStatus::NotConverged:
      return "not converged";
  }
  return "";
}

struct ConnectionDegrees {
  int alpha, beta, p, q;
};

py::dict nearestJoinOf(const Surface& a, const std::string& edge_a, const Surface& b,
                       const std::string& edge_b, int order, const std::string& moves,
                       bool reversed, const std::optional<NumberArray>& weights_a,
                       const std::optional<NumberArray>& weights_b,
                       const std::optional<Mask>& fixed_a, const std::optional<Mask>& fixed_b,
                       const ConnectionDegrees& degrees) {
  JoinSide side_a = sideOf(a, edge_a, weights_a, fixed_a, "a");
  JoinSide side_b = sideOf(b, edge_b, weights_b, fixed_b, "b");
  if (moves != "both" && moves != "a" && moves != "b")
    throw py::value_error("moves is '" + moves + "': both, a or b is needed");
  side_a.moves = moves != "b";
  side_b.moves = moves != "a";
  side_b.reversed = reversed;
  const int degree = std::max(degreeAlong(side_a), degreeAlong(side_b));
  elevate(side_a, degree, a);
  elevate(side_b, degree, b);
  NearestOptions options;
  options.order = order;
  options.degree_alpha = degrees.alpha;
  options.degree_beta = degrees.beta;
  options.degree_p = degrees.p;
  options.degree_q = degrees.q;
  NearestJoin join;
  {
    const py::gil_scoped_release release;
    join = nearestJoin(side_a, side_b, options);
  }
  const ConnectionFunctions& c = join.connection;
  py::dict result;
  const bool changed =
      join.status == NearestStatus::Joined || join.status == NearestStatus::NotConverged;
  result["a"] = changed && side_a.moves ? asGiven(join.a, a) : py::cast(a);
  result["b"] = changed && side_b.moves ? asGiven(join.b, b) : py::cast(b);
  result["status"] = statusName(join.status);
  result["alpha"] = c.alpha;
  result["beta"] = c.beta;
  result["p"] = c.p;
  result["q"] = c.q;
  result["e0"] = c.e0;
  result["e1"] = c.e1;
  result["e2"] = c.e2;
  result["largest_move_mm"] = join.largest_move_mm;
  result["cost"] = join.cost;
  result["residual"] = join.residual;
  result["stationarity"] = join.stationarity;
  result["iterations"] = join.iterations;
  return result;
}

void bindSurface(py::module_& module) {
  py::class_<BSplineSurface>(
      module, "BSplineSurface", py::module_local(),
      "A (rational) B-spline surface with clamped ends: poles (nu, nv, 3), flat knots, "
      "weights (nu, nv) or None.")
      .def(py::init(&makeSurface), py::arg("poles"), py::arg("knots_u"), py::arg("knots_v"),
           py::arg("degree_u"), py::arg("degree_v"), py::arg("weights") = py::none())
      .def_static("from_patch", &splineSurface, py::arg("patch"),
                  "The same patch with knots 0 and 1.")
      .def_property_readonly("degree_u", [](const BSplineSurface& s) { return s.degree_u; })
      .def_property_readonly("degree_v", [](const BSplineSurface& s) { return s.degree_v; })
      .def_property_readonly("knots_u", [](const BSplineSurface& s) { return s.knots_u; })
      .def_property_readonly("knots_v", [](const BSplineSurface& s) { return s.knots_v; })
      .def_property_readonly("poles", &splineNetPoles)
      .def_property_readonly("weights", &splineNetWeights)
      .def(
          "point", [](const BSplineSurface& s, double u, double v) { return jet(s, u, v).p; },
          py::arg("u"), py::arg("v"))
      .def(
          "jet", [](const BSplineSurface& s, double u, double v) { return jet(s, u, v); },
          py::arg("u"), py::arg("v"), "Point and partials to third order, a SurfaceJet.")
      .def(
          "with_knot",
          [](const BSplineSurface& s, const std::string& direction, double knot) {
            return withKnot(s, directionOf(direction), knot);
          },
          py::arg("direction"), py::arg("knot"), "The same surface with one more knot in u or v.")
      .def(
          "with_raised_knots",
          [](const BSplineSurface& s, const std::string& direction, int times) {
            return withRaisedKnots(s, directionOf(direction), times);
          },
          py::arg("direction"), py::arg("times") = 1,
          "The same surface, the multiplicity of each inner knot in u or v raised, to the degree "
          "at most.")
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

}  // namespace

void bindNearest(py::module_& module) {
  bindSurface(module);
  module.def(
      "nearest_join",
      [](const Surface& a, const std::string& edge_a, const Surface& b, const std::string& edge_b,
         int order, const std::string& moves, bool reversed,
         const std::optional<NumberArray>& weights_a, const std::optional<NumberArray>& weights_b,
         const std::optional<Mask>& fixed_a, const std::optional<Mask>& fixed_b, int degree_alpha,
         int degree_beta, int degree_p, int degree_q) {
        return nearestJoinOf(a, edge_a, b, edge_b, order, moves, reversed, weights_a, weights_b,
                             fixed_a, fixed_b, {degree_alpha, degree_beta, degree_p, degree_q});
      },
      py::arg("a"), py::arg("edge_a"), py::arg("b"), py::arg("edge_b"), py::arg("order") = 1,
      py::arg("moves") = "both", py::arg("reversed") = false, py::kw_only(),
      py::arg("weights_a") = py::none(), py::arg("weights_b") = py::none(),
      py::arg("fixed_a") = py::none(), py::arg("fixed_b") = py::none(), py::arg("degree_alpha") = 0,
      py::arg("degree_beta") = 1, py::arg("degree_p") = 0, py::arg("degree_q") = 1,
      "Moves poles of two surfaces (BezierPatch or BSplineSurface) as little as possible, so that "
      "they join "
      "with "
      "G1 (order 1) or G2 (order 2) exactly along the edges 'u0', 'u1', 'v0', 'v1'. moves: 'both', "
      "'a' or "
      "'b'; "
      "reversed: the edge of b runs the other way. weights_a, weights_b: the weight of the squared "
      "move of each "
      "pole; "
      "fixed_a, "
      "fixed_b: poles that stay, as boolean arrays of the shape of the poles. The result is a dict "
      "of a, b, "
      "status "
      "('joined', 'unchanged', 'infeasible', 'not converged'), the connection functions alpha, "
      "beta, p, q, "
      "e0, e1, "
      "e2, largest_move_mm, cost, residual, stationarity and iterations.");
}

}  // namespace seamwright::python
