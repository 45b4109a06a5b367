// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <seamwright/core/join/nearest/nearest.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/parameters.hpp>
#include <seamwright/plugin/python/surfaces.hpp>

namespace seamwright::python {

namespace {

void requireNet(const std::string& name, const py::array& array, py::ssize_t nu, py::ssize_t nv) {
  if (array.ndim() != 2 || array.shape(0) != nu || array.shape(1) != nv)
    throw py::value_error(name + " have shape " + shapeText(array) + ": one for each pole, (" +
                          std::to_string(nu) + ", " + std::to_string(nv) + "), is needed");
}

BSplineSurface makeSurface(const py::object& given, const py::object& knots_u,
                           const py::object& knots_v, const py::object& degree_u,
                           const py::object& degree_v, const py::object& weights) {
  const Array poles = arrayOf("poles", given);
  const Poles rows = polesOf("poles", poles, 3, "(nu, nv, 3)");
  BSplineSurface surface{wholeNumber("degree_u", degree_u),
                         wholeNumber("degree_v", degree_v),
                         listOf("knots_u", knots_u),
                         listOf("knots_v", knots_v),
                         {}};
  const Eigen::VectorXd w = weightsOf(weights, poles);
  surface.poles.resize(rows.rows(), 4);
  surface.poles << w.asDiagonal() * rows, w;
  requireValid(surface);
  if (surface.countU() != poles.shape(0) || surface.countV() != poles.shape(1))
    throw py::value_error("poles have shape " + shapeText(poles) + ", knots are for " +
                          std::to_string(surface.countU()) + " by " +
                          std::to_string(surface.countV()));
  return surface;
}

Array splineNetPoles(const BSplineSurface& surface) {
  Array result({surface.countU(), surface.countV(), 3});
  Eigen::Map<Poles>(result.mutable_data(), surface.poles.rows(), 3) =
      surface.poles.leftCols<3>().array().colwise() / surface.poles.col(3).array();
  return result;
}

Array splineNetWeights(const BSplineSurface& surface) {
  Array result({surface.countU(), surface.countV()});
  Eigen::Map<Eigen::VectorXd>(result.mutable_data(), result.size()) = surface.poles.col(3);
  return result;
}

Array splinePoint(const BSplineSurface& surface, const py::object& u, const py::object& v) {
  const ParameterPairs at("u", u, "v", v);
  return valuesOf(at.first.shape(), {3},
                  [&](py::ssize_t i) { return jet(surface, at.first[i], at.second[i]).p; });
}

py::object splineJet(const BSplineSurface& surface, const py::object& u, const py::object& v) {
  const ParameterPairs at("u", u, "v", v);
  return objectsAt(at.first,
                   [&](py::ssize_t i) { return jet(surface, at.first[i], at.second[i]); });
}

SurfaceDirection directionOf(const py::object& value) {
  const auto name = argument<std::string>("direction", value, "u or v");
  if (name == "u") return SurfaceDirection::U;
  if (name == "v") return SurfaceDirection::V;
  throw py::value_error("direction is " + shown(value) + ": u or v is needed");
}

/// One boolean, or 0 or 1, for each pole.
std::vector<bool> maskOf(const std::string& name, const py::object& value, int nu, int nv) {
  const auto array = py::array::ensure(value);
  if (!array || std::string("biu").find(array.dtype().kind()) == std::string::npos) {
    PyErr_Clear();
    throw py::value_error(name + " are " + shown(value) + ": an array of booleans is needed");
  }
  requireNet(name, array, nu, nv);
  const auto mask = py::array_t<bool, py::array::c_style | py::array::forcecast>::ensure(array);
  return std::vector<bool>(mask.data(), mask.data() + mask.size());
}

/// The arguments of one side of a join.
struct SideArguments {
  std::string name;  ///< "a" or "b"
  const py::object& surface;
  const py::object& edge;
  const py::object& weights;
  const py::object& fixed;
};

JoinSide sideOf(const SideArguments& given) {
  JoinSide side{splineSurfaceOf(given.name.c_str(), given.surface),
                patchEdgeOf(("edge_" + given.name).c_str(), given.edge)};
  const int nu = side.surface.countU(), nv = side.surface.countV();
  if (!given.weights.is_none()) {
    const std::string name = "weights_" + given.name;
    const Array weights = arrayOf(name, given.weights);
    requireNet(name, weights, nu, nv);
    side.weights = Eigen::Map<const Eigen::VectorXd>(weights.data(), weights.size());
  }
  if (!given.fixed.is_none()) side.fixed = maskOf("fixed_" + given.name, given.fixed, nu, nv);
  return side;
}

/// A surface that was given as a Bezier patch as one, unless it got knots.
py::object asGiven(const BSplineSurface& surface, const SeamChange& change,
                   const py::object& given) {
  if (py::isinstance<BezierPatch>(given) && change.added_knots.empty())
    return py::cast(bezierPatch(surface));
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

void setMoves(const py::object& value, JoinSide& a, JoinSide& b) {
  const auto moves = argument<std::string>("moves", value, "both, a or b");
  if (moves != "both" && moves != "a" && moves != "b")
    throw py::value_error("moves is " + shown(value) + ": both, a or b is needed");
  a.moves = moves != "b";
  b.moves = moves != "a";
}

void setChange(const std::string& name, const SeamChange& change, py::dict& result) {
  result[("raised_degree_" + name).c_str()] = change.raised_degree;
  result[("added_knots_" + name).c_str()] = change.added_knots;
  result[("moved_knots_" + name).c_str()] = change.moved_knots;
}

py::object joinResult(const NearestJoin& join, py::dict result) {
  const ConnectionFunctions& c = join.connection;
  result["status"] = statusName(join.status);
  setChange("a", join.change_a, result);
  setChange("b", join.change_b, result);
  result["parameter"] = parameterDict(join.parameter_of_b, false);
  result["alpha"] = c.alpha;
  result["beta"] = c.beta;
  result["p"] = c.p;
  result["q"] = c.q;
  result["h"] = c.h;
  result["k"] = c.k;
  result["e0"] = c.e0;
  result["e1"] = c.e1;
  result["e2"] = c.e2;
  result["e3"] = c.e3;
  result["largest_move_mm"] = join.largest_move_mm;
  result["cost"] = join.cost;
  result["residual"] = join.residual;
  result["stationarity"] = join.stationarity;
  result["iterations"] = join.iterations;
  return resultOf("NearestJoin", result);
}

py::object nearestJoinOf(const py::object& a, const py::object& edge_a, const py::object& b,
                         const py::object& edge_b, const py::object& order, const py::object& moves,
                         const py::object& reversed, const py::object& weights_a,
                         const py::object& weights_b, const py::object& fixed_a,
                         const py::object& fixed_b, const py::object& degree_alpha,
                         const py::object& degree_beta, const py::object& degree_p,
                         const py::object& degree_q, const py::object& degree_h,
                         const py::object& degree_k) {
  JoinSide side_a = sideOf({"a", a, edge_a, weights_a, fixed_a});
  JoinSide side_b = sideOf({"b", b, edge_b, weights_b, fixed_b});
  setMoves(moves, side_a, side_b);
  side_b.reversed = flagOf("reversed", reversed);
  NearestOptions options;
  options.order = wholeNumber("order", order);
  options.degree_alpha = wholeNumber("degree_alpha", degree_alpha);
  options.degree_beta = wholeNumber("degree_beta", degree_beta);
  options.degree_p = wholeNumber("degree_p", degree_p);
  options.degree_q = wholeNumber("degree_q", degree_q);
  options.degree_h = wholeNumber("degree_h", degree_h);
  options.degree_k = wholeNumber("degree_k", degree_k);
  NearestJoin join;
  {
    const py::gil_scoped_release release;
    join = nearestJoin(side_a, side_b, options);
  }
  py::dict result;
  const bool changed =
      join.status == NearestStatus::Joined || join.status == NearestStatus::NotConverged;
  result["a"] = changed && side_a.moves ? asGiven(join.a, join.change_a, a) : a;
  result["b"] = changed && side_b.moves ? asGiven(join.b, join.change_b, b) : b;
  return joinResult(join, result);
}

py::tuple stateOf(const BSplineSurface& s) {
  return py::make_tuple(s.degree_u, s.degree_v, s.knots_u, s.knots_v, homogeneousArray(s.poles));
}

BSplineSurface surfaceFrom(const py::tuple& state) {
  BSplineSurface surface{state[0].cast<int>(), state[1].cast<int>(),
                         state[2].cast<std::vector<double>>(), state[3].cast<std::vector<double>>(),
                         homogeneousRows(state[4].cast<Array>())};
  requireValid(surface);
  return surface;
}

void bindRefinement(py::class_<BSplineSurface>& surface) {
  surface
      .def(
          "with_knot",
          [](const BSplineSurface& s, const py::object& direction, const py::object& knot) {
            return withKnot(s, directionOf(direction), numberOf("knot", knot));
          },
          py::arg("direction"), py::arg("knot"), "The same surface with one more knot in u or v.")
      .def(
          "elevated",
          [](const BSplineSurface& s, const py::object& direction) {
            return elevated(s, directionOf(direction));
          },
          py::arg("direction"),
          "The same surface with one degree more in u or v; each knot is repeated once more.")
      .def(
          "with_raised_knots",
          [](const BSplineSurface& s, const py::object& direction, const py::object& times) {
            return withRaisedKnots(s, directionOf(direction), wholeNumber("times", times));
          },
          py::arg("direction"), py::arg("times") = 1,
          "The same surface, the multiplicity of each inner knot in u or v raised, to the degree "
          "at most.");
}

void bindSurface(py::module_& module) {
  py::class_<BSplineSurface> surface(
      module, "BSplineSurface", py::module_local(),
      R"(A (rational) B-spline surface with clamped ends: poles (nu, nv, 3) in mm, flat knots,
weights (nu, nv) or None.

ValueError, with index and value, for numbers that make no surface.)");
  surface
      .def(py::init(&makeSurface), py::arg("poles"), py::arg("knots_u"), py::arg("knots_v"),
           py::arg("degree_u"), py::arg("degree_v"), py::arg("weights") = py::none())
      .def_static(
          "from_patch",
          [](const py::object& patch) {
            return splineSurface(objectOf<BezierPatch>("patch", patch, "a BezierPatch"));
          },
          py::arg("patch"), "The same patch with knots 0 and 1.")
      .def_property_readonly(
          "degree_u", [](const BSplineSurface& s) { return s.degree_u; }, "In the direction u.")
      .def_property_readonly(
          "degree_v", [](const BSplineSurface& s) { return s.degree_v; }, "In the direction v.")
      .def_property_readonly(
          "knots_u", [](const BSplineSurface& s) { return s.knots_u; },
          "In the direction u, flat: each knot is repeated by its multiplicity, degree + 1 times "
          "at both ends.")
      .def_property_readonly(
          "knots_v", [](const BSplineSurface& s) { return s.knots_v; },
          "In the direction v, flat like knots_u.")
      .def_property_readonly("poles", &splineNetPoles, "(nu, nv, 3), in mm.")
      .def_property_readonly("weights", &splineNetWeights, "(nu, nv).")
      .def("point", &splinePoint, py::arg("u"), py::arg("v"),
           "The point (3,) at (u, v); arrays broadcast to a shape s: points s + (3,).")
      .def("jet", &splineJet, py::arg("u"), py::arg("v"),
           "Point and partials to third order, a SurfaceJet; for arrays an array of them.")
      .def(py::pickle(&stateOf, &surfaceFrom))
      .def("__repr__",
           [](const BSplineSurface& s) {
             return "<BSplineSurface of degrees " + std::to_string(s.degree_u) + " by " +
                    std::to_string(s.degree_v) + " with " + std::to_string(s.countU()) + " by " +
                    std::to_string(s.countV()) + " poles>";
           })
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
  bindRefinement(surface);
}

}  // namespace

void bindNearest(py::module_& module) {
  bindSurface(module);
  module.def("nearest_join", &nearestJoinOf, py::arg("a"), py::arg("edge_a"), py::arg("b"),
             py::arg("edge_b"), py::arg("order") = 1, py::arg("moves") = "both",
             py::arg("reversed") = false, py::kw_only(), py::arg("weights_a") = py::none(),
             py::arg("weights_b") = py::none(), py::arg("fixed_a") = py::none(),
             py::arg("fixed_b") = py::none(), py::arg("degree_alpha") = 0,
             py::arg("degree_beta") = 1, py::arg("degree_p") = 0, py::arg("degree_q") = 1,
             py::arg("degree_h") = 0, py::arg("degree_k") = 1,
             R"(Moves poles of two surfaces as little as possible so that they join: a NearestJoin.

a, b: BezierPatch or BSplineSurface. They join with G1, G2 or G3 (order 1 to 3) exactly along the
edges 'u0', 'u1', 'v0', 'v1'. moves: 'both', 'a' or 'b'. reversed: the edge of b runs the other way.
A side that moves gets the degree and the knots that the other has along the edge. weights_a,
weights_b: the weight of the squared move of each given pole. fixed_a, fixed_b: poles that stay, as
boolean arrays of the shape of the poles. degree_alpha, ..: degrees of the functions that
connect the surfaces. TypeError for other surfaces; ValueError for other bad arguments.)");
}

}  // namespace seamwright::python
