// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/blend.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::python {

namespace {

using InOmega = KeyInterpolation::Continuity;

constexpr NamedValue<InOmega> continuities[] = {
    {"C0", InOmega::C0}, {"C1", InOmega::C1}, {"C2", InOmega::C2}};

const char* plainCaseName(PlainBlendCase kind) {
  switch (kind) {
    case PlainBlendCase::EqualBetas:
      return "equal betas";
    case PlainBlendCase::ParallelTangents:
      return "parallel tangents";
    case PlainBlendCase::EqualBeta1:
      return "equal beta_1";
    case PlainBlendCase::Straight:
      return "straight";
    case PlainBlendCase::None:
      return "none";
  }
  return "";
}

const char* faultName(BalanceFault::Kind kind) {
  switch (kind) {
    case BalanceFault::Kind::NoRatio:
      return "no ratio";
    case BalanceFault::Kind::FarPoint:
      return "far point";
    case BalanceFault::Kind::LostTangent:
      return "lost tangent";
    case BalanceFault::Kind::NegativeBeta:
      return "negative beta";
    case BalanceFault::Kind::Weights:
      return "weights";
  }
  return "";
}

py::list faultsOf(const std::vector<BalanceFault>& faults) {
  py::list list;
  for (const BalanceFault& fault : faults) {
    py::dict dict;
    dict["kind"] = faultName(fault.kind);
    dict["level"] = fault.level;
    dict["index"] = fault.index;
    dict["value"] = fault.value;
    list.append(resultOf("BalanceFault", dict));
  }
  return list;
}

py::object shortestResult(const ShortestBlend& shortest) {
  py::dict dict;
  dict["omega"] = shortest.omega;
  dict["length_mm"] = shortest.length_mm;
  dict["rounding_mm"] = shortest.rounding_mm;
  dict["vanishes"] = shortest.vanishes();
  return resultOf("ShortestBlend", dict);
}

/// Two curves, a and b, the end of the first being the beginning of the second.
JointFrame jointFrameOf(const std::string& name, const py::object& value) {
  const bool is_pair =
      (py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value)) && py::len(value) == 2;
  if (!is_pair)
    throw py::value_error(name + " is " + shown(value) +
                          ": a pair of curves, the one that arrives and the one that leaves, is "
                          "needed");
  const auto pair = py::reinterpret_borrow<py::sequence>(value);
  return {bezierCurveOf(name + "[0]", pair[0]), bezierCurveOf(name + "[1]", pair[1])};
}

/// The keywords of JointBlendOptions.
struct JointArguments {
  const py::object& order;
  const py::object& frame_tolerance;
  const py::object& most_defect;
  const py::object& max_degree;
  const py::object& least_tangent;
  const py::object& most_departure;
  const py::object& free_betas;

  JointBlendOptions options() const {
    JointBlendOptions result;
    result.order = wholeNumber("order", order);
    result.frame_tolerance = numberOf("frame_tolerance", frame_tolerance);
    result.most_defect = numberOf("most_defect", most_defect);
    result.max_degree = wholeNumber("max_degree", max_degree);
    result.least_tangent = numberOf("least_tangent", least_tangent);
    result.most_departure = numberOf("most_departure", most_departure);
    result.free_betas = flagOf("free_betas", free_betas);
    return result;
  }
};

py::tuple optionState(const JointBlendOptions& o) {
  return py::make_tuple(o.order, o.frame_tolerance, o.most_defect, o.max_degree, o.least_tangent,
                        o.most_departure, o.free_betas);
}

JointBlendOptions optionsOfState(const py::tuple& state) {
  JointBlendOptions options;
  options.order = state[0].cast<int>();
  options.frame_tolerance = state[1].cast<double>();
  options.most_defect = state[2].cast<double>();
  options.max_degree = state[3].cast<int>();
  options.least_tangent = state[4].cast<double>();
  options.most_departure = state[5].cast<double>();
  options.free_betas = state[6].cast<bool>();
  return options;
}

py::object plainBlendOf(const py::object& first, const py::object& second, const py::object& order,
                        const py::object& tolerance, const py::object& omegas) {
  const PlainBlend blend =
      plainBlend(jointFrameOf("first", first), jointFrameOf("second", second),
                 wholeNumber("order", order), numberOf("tolerance", tolerance));
  py::dict dict;
  dict["kind"] = plainCaseName(blend.kind);
  dict["keeps"] = blend.keeps();
  dict["betas_defect"] = blend.betas_defect;
  dict["beta1_defect"] = blend.beta1_defect;
  dict["angle_rad"] = blend.angle_rad;
  dict["ratio"] = blend.ratio;
  dict["bend"] = blend.bend;
  dict["tangent_a"] = shortestResult(blend.tangent_a);
  dict["tangent_b"] = shortestResult(blend.tangent_b);
  py::list betas;
  for (const double omega : listOf("omegas", omegas)) {
    if (!(omega >= 0 && omega <= 1))
      throw py::value_error("omegas[" + std::to_string(py::len(betas)) + "] is " +
                            shown(py::float_(omega)) + ": 0 to 1 is needed");
    betas.append(blend.beta(omega));
  }
  dict["betas"] = betas;
  return resultOf("PlainBlend", dict);
}

KeyedJointBlend makeJointBlend(const py::object& first, const py::object& second,
                               const py::object& order, const py::object& frame_tolerance,
                               const py::object& most_defect, const py::object& max_degree,
                               const py::object& least_tangent, const py::object& most_departure,
                               const py::object& free_betas) {
  const JointArguments given{order,         frame_tolerance, most_defect, max_degree,
                             least_tangent, most_departure,  free_betas};
  return {jointFrameOf("first", first), jointFrameOf("second", second), given.options()};
}

py::object blendedJointResult(const BlendedJoint& joint) {
  py::dict dict;
  dict["a"] = joint.a;
  dict["b"] = joint.b;
  dict["order"] = joint.order;
  dict["beta"] = joint.beta;
  dict["defects"] = joint.defects;
  dict["remedy"] = nameOf(joint.remedy);
  dict["moved_mm"] = joint.moved_mm;
  dict["faults"] = faultsOf(joint.faults);
  return resultOf("BlendedJoint", dict);
}

py::object jointAt(const KeyedJointBlend& keyed, const py::object& omega) {
  return blendedJointResult(keyed.blend.at(numberOf("omega", omega)));
}

py::object blendJointOf(const py::object& first, const py::object& second, const py::object& omega,
                        const py::object& order, const py::object& frame_tolerance,
                        const py::object& most_defect, const py::object& max_degree,
                        const py::object& least_tangent, const py::object& most_departure,
                        const py::object& free_betas) {
  return jointAt(makeJointBlend(first, second, order, frame_tolerance, most_defect, max_degree,
                                least_tangent, most_departure, free_betas),
                 omega);
}

/// 0..1 for None.
std::vector<double> keyOmegasOf(const py::object& value, std::size_t keys) {
  if (!value.is_none()) return listOf("omegas", value);
  std::vector<double> omegas;
  for (std::size_t i = 0; i < keys; ++i)
    omegas.push_back(keys < 2 ? 0 : static_cast<double>(i) / static_cast<double>(keys - 1));
  return omegas;
}

KeyedSplineBlend makeSplineBlend(const py::object& keys, const py::object& omegas,
                                 const py::object& order, const py::object& continuity,
                                 const py::object& keep_lower_orders,
                                 const py::object& frame_tolerance, const py::object& most_defect,
                                 const py::object& max_degree, const py::object& least_tangent,
                                 const py::object& most_departure, const py::object& free_betas) {
  std::vector<BezierSpline> curves = bezierSplinesOf("keys", keys);
  std::vector<double> at = keyOmegasOf(omegas, curves.size());
  const JointArguments given{order,         frame_tolerance, most_defect, max_degree,
                             least_tangent, most_departure,  free_betas};
  SplineBlendOptions options;
  options.joint = given.options();
  options.continuity = choiceOf("continuity", continuity, continuities);
  options.keep_lower_orders = flagOf("keep_lower_orders", keep_lower_orders);
  const py::gil_scoped_release release;
  return {std::move(curves), std::move(at), options};
}

py::object splineJointResult(const SplineJoint& joint) {
  py::dict dict;
  dict["knot"] = joint.knot;
  dict["order"] = joint.order;
  dict["beta"] = joint.beta;
  dict["defects"] = joint.defects;
  dict["remedy"] = nameOf(joint.remedy);
  dict["moved_mm"] = joint.moved_mm;
  dict["faults"] = faultsOf(joint.faults);
  return resultOf("SplineJoint", dict);
}

py::object frameAtOf(const KeyedSplineBlend& keyed, const py::object& omega) {
  const double at = numberOf("omega", omega);
  const SplineFrame frame = [&] {
    const py::gil_scoped_release release;
    return keyed.blend.frameAt(at);
  }();
  py::dict dict;
  dict["curve"] = frame.spline;
  py::list joints;
  for (const SplineJoint& joint : frame.joints) joints.append(splineJointResult(joint));
  dict["joints"] = joints;
  return resultOf("SplineFrame", dict);
}

std::vector<std::string> remedyNames(const SplineBlend& blend) {
  std::vector<std::string> names;
  for (const BlendRemedy remedy : blend.remedies()) names.push_back(nameOf(remedy));
  return names;
}

BalanceRatios ratiosOf(const py::object& beta, const py::object& degree_a,
                       const py::object& degree_b) {
  return balanceRatios(numbersOf("beta", itemOrSelf(beta, "beta")),
                       wholeNumber("degree_a", degree_a), wholeNumber("degree_b", degree_b));
}

py::object balanceRatiosOf(const py::object& beta, const py::object& degree_a,
                           const py::object& degree_b) {
  const BalanceRatios ratios = ratiosOf(beta, degree_a, degree_b);
  py::dict dict;
  dict["delta"] = ratios.delta;
  dict["faults"] = faultsOf(ratios.faults);
  dict["least_pivot"] = ratios.least_pivot;
  dict["can_cut"] = ratios.canCut();
  dict["can_solve"] = ratios.canSolve();
  return resultOf("BalanceRatios", dict);
}

Eigen::MatrixXd balanceRelationsOf(const py::object& beta, const py::object& degree_a,
                                   const py::object& degree_b) {
  return balanceRelations(numbersOf("beta", itemOrSelf(beta, "beta")),
                          wholeNumber("degree_a", degree_a), wholeNumber("degree_b", degree_b));
}

py::object auxiliaryPointsOf(const py::object& poles, const py::object& beta,
                             const py::object& degree_a, const py::object& degree_b) {
  const AuxiliaryPoints found =
      auxiliaryPoints(ratiosOf(beta, degree_a, degree_b), rowsOf("poles", poles, "(2n + 1, 3)"));
  py::dict dict;
  dict["points"] = Poles(found.points);
  dict["residual_mm"] = found.residual;
  return resultOf("AuxiliaryPoints", dict);
}

Poles balancedPolesOf(const py::object& points, const py::object& beta, const py::object& degree_a,
                      const py::object& degree_b) {
  return balancedPoles(ratiosOf(beta, degree_a, degree_b), rowsOf("points", points, "(n + 1, 3)"));
}

void bindJointBlendClass(py::module_& module) {
  const JointBlendOptions usual;
  py::class_<KeyedJointBlend>(
      module, "JointBlend", py::module_local(),
      R"(Blends two joints such that each curve between is G^order at its joint.

first, second: pairs (a, b) of curves of one segment; a ends where b begins. Poles beside the joint
are adjusted, the others are blended linearly. frame_tolerance: a frame whose defects are above is
refused. most_defect: largest defect of a result. max_degree: curves are raised up to it if that
makes the balanced construction possible. least_tangent: share of the shorter tangent of the frames.
most_departure: farthest a balanced pole may move from linear blending, in units of the joint's
length. free_betas: the smallest move looks for its betas. ValueError, with index and value, for
curves that do not meet or are not G^order.)")
      .def(py::init(&makeJointBlend), py::arg("first"), py::arg("second"), py::kw_only(),
           py::arg("order") = usual.order, py::arg("frame_tolerance") = usual.frame_tolerance,
           py::arg("most_defect") = usual.most_defect, py::arg("max_degree") = usual.max_degree,
           py::arg("least_tangent") = usual.least_tangent,
           py::arg("most_departure") = usual.most_departure,
           py::arg("free_betas") = usual.free_betas)
      .def("at", &jointAt, py::arg("omega"), "The joint at omega, 0 to 1: a BlendedJoint.")
      .def_property_readonly(
          "remedy", [](const KeyedJointBlend& k) { return nameOf(k.blend.remedy()); },
          "How joints are made G^order: 'plain', 'balanced', 'smallest move', 'intermediate "
          "frame' or 'intrinsic'. At single omegas a later one may be needed.")
      .def_property_readonly(
          "degree_a", [](const KeyedJointBlend& k) { return k.blend.degreeA(); },
          "Of the curves that arrive, after raising.")
      .def_property_readonly(
          "degree_b", [](const KeyedJointBlend& k) { return k.blend.degreeB(); },
          "Of the curves that leave, after raising.")
      .def(py::pickle(
          [](const KeyedJointBlend& k) {
            return py::make_tuple(k.first.a, k.first.b, k.second.a, k.second.b,
                                  optionState(k.options));
          },
          [](const py::tuple& state) {
            const auto curve = [&](std::size_t i) { return state[i].cast<BezierCurve>(); };
            return KeyedJointBlend({curve(0), curve(1)}, {curve(2), curve(3)},
                                   optionsOfState(state[4].cast<py::tuple>()));
          }))
      .def("__repr__", [](const KeyedJointBlend& k) {
        return "<JointBlend of order " + std::to_string(k.options.order) + ", " +
               nameOf(k.blend.remedy()) + ">";
      });
}

void bindSingleJoints(py::module_& module) {
  const JointBlendOptions usual;
  module.def("blend_joint", &blendJointOf, py::arg("first"), py::arg("second"), py::arg("omega"),
             py::kw_only(), py::arg("order") = usual.order,
             py::arg("frame_tolerance") = usual.frame_tolerance,
             py::arg("most_defect") = usual.most_defect, py::arg("max_degree") = usual.max_degree,
             py::arg("least_tangent") = usual.least_tangent,
             py::arg("most_departure") = usual.most_departure,
             py::arg("free_betas") = usual.free_betas,
             R"(The joint at one omega, 0 to 1, between two joints: a BlendedJoint.

Arguments are those of JointBlend, which is faster for several omegas.)");
  module.def("plain_blend", &plainBlendOf, py::arg("first"), py::arg("second"),
             py::arg("order") = 2, py::kw_only(), py::arg("tolerance") = 1e-11,
             py::arg("omegas") = py::tuple(),
             R"(Whether linear blending of all poles keeps a joint G1 or G2: a PlainBlend.

first, second: pairs (a, b) of polynomial curves of one segment; a ends where b begins. tolerance:
the largest dimensionless defect that counts as 0. omegas: of the betas. The conditions are
necessary and sufficient. ValueError, with index and value, for curves that do not meet or have no
tangent.)");
}

void bindSplineBlend(py::module_& module) {
  const SplineBlendOptions usual;
  py::class_<KeyedSplineBlend>(
      module, "SplineBlend", py::module_local(),
      R"(Blends curves such that each curve between is G^order at every joint.

keys: two or more curves of any class with the same degree and number of segments, all open or all
closed; segment i of one corresponds to segment i of the others. omegas: one a key, increasing;
None: even from 0 to 1. continuity: 'C0', 'C1' or 'C2', by omega at the inner keys.
keep_lower_orders: a joint keeps the order that all keys have there; else one that is not G^order is
refused. Further arguments are those of JointBlend. ValueError, with index and value, for keys that
do not correspond.)")
      .def(py::init(&makeSplineBlend), py::arg("keys"), py::arg("omegas") = py::none(),
           py::kw_only(), py::arg("order") = usual.joint.order, py::arg("continuity") = "C0",
           py::arg("keep_lower_orders") = usual.keep_lower_orders,
           py::arg("frame_tolerance") = usual.joint.frame_tolerance,
           py::arg("most_defect") = usual.joint.most_defect,
           py::arg("max_degree") = usual.joint.max_degree,
           py::arg("least_tangent") = usual.joint.least_tangent,
           py::arg("most_departure") = usual.joint.most_departure,
           py::arg("free_betas") = usual.joint.free_betas)
      .def("frame_at", &frameAtOf, py::arg("omega"), "The curve at omega: a SplineFrame.")
      .def_property_readonly(
          "omegas", [](const KeyedSplineBlend& k) { return k.omegas; }, "Of the keys.")
      .def_property_readonly(
          "degree", [](const KeyedSplineBlend& k) { return k.blend.degree(); }, "Of the frames.")
      .def_property_readonly(
          "orders", [](const KeyedSplineBlend& k) { return k.blend.orders(); },
          "n of the G^n that each joint keeps.")
      .def_property_readonly(
          "remedies", [](const KeyedSplineBlend& k) { return remedyNames(k.blend); },
          "How each joint is made G^n: see JointBlend.remedy.")
      .def(py::pickle(
          [](const KeyedSplineBlend& k) {
            return py::make_tuple(k.keys, k.omegas, static_cast<int>(k.options.continuity),
                                  k.options.keep_lower_orders, optionState(k.options.joint));
          },
          [](const py::tuple& state) {
            SplineBlendOptions options;
            options.continuity = static_cast<InOmega>(state[2].cast<int>());
            options.keep_lower_orders = state[3].cast<bool>();
            options.joint = optionsOfState(state[4].cast<py::tuple>());
            return KeyedSplineBlend(state[0].cast<std::vector<BezierSpline>>(),
                                    state[1].cast<std::vector<double>>(), options);
          }))
      .def("__repr__", [](const KeyedSplineBlend& k) {
        return "<SplineBlend of " + std::to_string(k.keys.size()) + " curves of degree " +
               std::to_string(k.blend.degree()) + ">";
      });
}

void bindBalance(py::module_& module) {
  module.def("balance_ratios", &balanceRatiosOf, py::arg("beta"), py::arg("degree_a"),
             py::arg("degree_b"),
             R"(The ratios by which auxiliary points are cut down to the poles of a G^n joint.

beta: beta_1 .. beta_n, or a result that has them. degree_a, degree_b: of the curves that arrive and
leave, n or more. Returns BalanceRatios.)");
  module.def("balance_relations", &balanceRelationsOf, py::arg("beta"), py::arg("degree_a"),
             py::arg("degree_b"),
             R"(The relations of the poles -n..n of a G^n joint: an array (n, 2n + 1).

The joint has these betas iff the array times the poles is 0. Arguments as for balance_ratios().)");
  module.def("auxiliary_points", &auxiliaryPointsOf, py::arg("poles"), py::arg("beta"),
             py::arg("degree_a"), py::arg("degree_b"),
             R"(The auxiliary points of a G^n joint: AuxiliaryPoints.

poles: (2n + 1, 3), those of a joint in mm from P_(-n) of the curve that arrives to P_n of the one
that leaves. ValueError where a ratio is missing or far.)");
  module.def("balanced_poles", &balancedPolesOf, py::arg("points"), py::arg("beta"),
             py::arg("degree_a"), py::arg("degree_b"),
             R"(The poles (2n + 1, 3) of a G^n joint that auxiliary points are cut down to.

points: (n + 1, 3) in mm, any. The inverse of auxiliary_points().)");
}

}  // namespace

void bindBlend(py::module_& module) {
  bindJointBlendClass(module);
  bindSingleJoints(module);
  bindSplineBlend(module);
  bindBalance(module);
}

}  // namespace seamwright::python
