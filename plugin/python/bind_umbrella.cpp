// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <seamwright/core/umbrella/g2.hpp>
#include <seamwright/core/umbrella/twists.hpp>
#include <seamwright/core/umbrella/umbrella.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

/// Checks that the value is a sequence and returns the value itself for iteration. The iterator of
/// py::sequence releases each item before it is used, and nothing else holds the items of an array.
const py::object& sequenceOf(const char* name, const py::object& value) {
  if (!isSequence(value))
    throw py::value_error(std::string(name) + " is " + shown(value) + ": a sequence is needed");
  return value;
}

/// Curves, from a sequence of curves or of arrays of poles.
std::vector<BezierCurve> curvesOf(const char* name, const py::object& value) {
  std::vector<BezierCurve> curves;
  for (const py::handle item : sequenceOf(name, value)) {
    const std::string each = std::string(name) + "[" + std::to_string(curves.size()) + "]";
    if (py::isinstance<BezierCurve>(item) || py::isinstance<BSplineCurve>(item) ||
        py::isinstance<BezierSpline>(item))
      curves.push_back(bezierCurveOf(each, py::reinterpret_borrow<py::object>(item)));
    else
      curves.emplace_back(rowsOf(each, item, "(n+1, 3)"));
  }
  return curves;
}

std::vector<MemberKind> kindsOf(const py::object& value) {
  if (value.is_none()) return {};
  std::vector<MemberKind> kinds;
  for (const py::handle item : sequenceOf("kinds", value)) {
    const std::string kind = py::isinstance<py::str>(item) ? item.cast<std::string>() : "";
    if (kind != "patch" && kind != "triangle")
      throw py::value_error("kind " + std::to_string(kinds.size()) + " is " +
                            shown(py::reinterpret_borrow<py::object>(item)) +
                            ": 'patch' and 'triangle' are known");
    kinds.push_back(kind == "patch" ? MemberKind::Tensor : MemberKind::Triangle);
  }
  return kinds;
}

std::vector<UmbrellaMember> membersOf(const py::object& value) {
  if (value.is_none()) return {};
  std::vector<UmbrellaMember> members;
  const py::object given = itemOrSelf(value, "members");
  for (const py::handle item : sequenceOf("members", given)) {
    if (py::isinstance<BezierPatch>(item))
      members.emplace_back(item.cast<BezierPatch>());
    else if (py::isinstance<BezierTriangle>(item))
      members.emplace_back(item.cast<BezierTriangle>());
    else
      throw py::value_error("member " + std::to_string(members.size()) + " is " +
                            shown(py::reinterpret_borrow<py::object>(item)) +
                            ": a BezierPatch or a BezierTriangle is needed");
  }
  return members;
}

std::optional<Eigen::VectorXd> optionalNumbers(const char* name, const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return numbersOf(name, value);
}

std::optional<Eigen::Matrix3d> formOf(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  const Poles rows = rowsOf("form", value, "(3, 3), of the second fundamental form,");
  if (rows.rows() != 3)
    throw py::value_error("form has " + std::to_string(rows.rows()) + " rows: 3 are needed");
  const Eigen::Matrix3d form = rows;
  if ((form - form.transpose()).norm() > 1e-9 * form.norm())
    throw py::value_error("form is not symmetric");
  return form;
}

/// A connection in the form that join_condition() takes; None at an outer spoke.
py::object connectionOf(const SpokeFunctions& functions) {
  if (functions.a.size() == 0) return py::none();
  py::dict connection;
  connection["alpha"] = Eigen::VectorXd(-functions.b);
  connection["beta"] = functions.a;
  if (functions.e.size() > 0) connection["e1"] = functions.e;
  return connection;
}

/// For each member a pair of curves; None where one is free.
using CurvePairs = std::vector<std::array<std::optional<BezierCurve>, 2>>;

CurvePairs curvePairsOf(const char* name, const py::object& value) {
  CurvePairs pairs;
  if (value.is_none()) return pairs;
  for (const py::handle item : sequenceOf(name, value)) {
    const std::string each = std::string(name) + "[" + std::to_string(pairs.size()) + "]";
    auto& pair = pairs.emplace_back();
    if (item.is_none()) continue;
    std::size_t next = 0;
    for (const py::handle curve :
         sequenceOf(each.c_str(), py::reinterpret_borrow<py::object>(item))) {
      if (next == 2) throw py::value_error(each + " has more than 2 items");
      const auto object = py::reinterpret_borrow<py::object>(curve);
      const std::string place = each + "[" + std::to_string(next) + "]";
      if (py::isinstance<BezierCurve>(curve))
        pair[next] = bezierCurveOf(place, object);
      else if (!curve.is_none())
        pair[next] = BezierCurve(rowsOf(place, object, "(n+1, 3)"));
      ++next;
    }
  }
  return pairs;
}

std::vector<MemberBoundary> boundaryOf(const py::object& boundary, const py::object& across) {
  const CurvePairs edges = curvePairsOf("boundary", boundary),
                   fields = curvePairsOf("across", across);
  if (!fields.empty() && fields.size() != edges.size())
    throw py::value_error("across has " + std::to_string(fields.size()) + " items, boundary " +
                          std::to_string(edges.size()));
  std::vector<MemberBoundary> result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    result.push_back({edges[i][0], edges[i][1], {}, {}});
    if (fields.empty()) continue;
    result.back().across_first = fields[i][0];
    result.back().across_second = fields[i][1];
  }
  return result;
}

py::object umbrellaResult(const Umbrella& umbrella) {
  py::list members, connections;
  for (const UmbrellaMember& member : umbrella.members)
    members.append(std::visit([](const auto& surface) { return py::cast(surface); }, member));
  for (const SpokeFunctions& functions : umbrella.functions)
    connections.append(connectionOf(functions));
  py::dict dict;
  dict["members"] = members;
  dict["spokes"] = umbrella.spokes;
  dict["connections"] = connections;
  dict["normal"] = umbrella.vertex.normal;
  dict["angles_rad"] = umbrella.vertex.angles_rad;
  dict["condition"] = umbrella.vertex.condition;
  dict["crossing"] = umbrella.vertex.isRegular();
  dict["spoke_move_mm"] = umbrella.largest_spoke_move_mm;
  dict["second_change_mm"] = umbrella.largest_second_change;
  dict["slope_change"] = umbrella.largest_lambda_change;
  dict["member_move_mm"] = umbrella.largest_member_move_mm;
  dict["free_vectors"] = umbrella.free_vectors;
  return resultOf("Umbrella", dict);
}

py::object umbrellaOf(const py::object& spokes, const py::object& closed, const py::object& kinds,
                      const py::object& members, const py::object& degree, const py::object& slopes,
                      const py::object& cross_slopes, const py::object& form,
                      const py::object& boundary, const py::object& across,
                      const py::object& gap_mm, const py::object& flat_rad) {
  const std::vector<BezierCurve> curves = curvesOf("spokes", spokes);
  UmbrellaOptions options;
  options.closed = flagOf("closed", closed);
  options.kinds = kindsOf(kinds);
  options.members = membersOf(members);
  options.degree = optionalWhole("degree", degree);
  options.lambda = optionalNumbers("slopes", slopes);
  options.mu = optionalNumbers("cross_slopes", cross_slopes);
  options.form = formOf(form);
  options.boundary = boundaryOf(boundary, across);
  options.gap_mm = numberOf("gap_mm", gap_mm);
  options.vertex.flat_rad = numberOf("flat_rad", flat_rad);
  const auto built = [&] {
    const py::gil_scoped_release unlocked;
    return umbrellaAround(curves, options);
  };
  return umbrellaResult(built());
}

py::object umbrellaInsideOf(const py::object& sides, const py::object& spoke_degree,
                            const py::object& degree, const py::object& gap_mm) {
  const std::vector<BezierCurve> curves = curvesOf("sides", sides);
  UmbrellaInsideOptions options;
  options.spoke_degree = wholeNumber("spoke_degree", spoke_degree);
  options.degree = optionalWhole("degree", degree);
  options.gap_mm = numberOf("gap_mm", gap_mm);
  const auto built = [&] {
    const py::gil_scoped_release unlocked;
    return umbrellaInside(curves, options);
  };
  return umbrellaResult(built());
}

/// A connection in the form that join_rows() takes; None at an outer spoke.
py::object g2ConnectionOf(const G2SpokeFunctions& functions) {
  if (functions.a.size() == 0) return py::none();
  py::dict connection;
  connection["alpha"] = Eigen::VectorXd(-functions.b);
  connection["beta"] = functions.a;
  connection["p"] = Eigen::VectorXd(-functions.p);
  connection["q"] = functions.q;
  return connection;
}

py::object g2UmbrellaResult(const G2Umbrella& umbrella) {
  py::list connections;
  for (const G2SpokeFunctions& functions : umbrella.functions)
    connections.append(g2ConnectionOf(functions));
  py::dict dict;
  dict["members"] = umbrella.members;
  dict["spokes"] = umbrella.spokes;
  dict["connections"] = connections;
  dict["normal"] = umbrella.vertex.normal;
  dict["angles_rad"] = umbrella.vertex.angles_rad;
  dict["form"] = umbrella.form;
  dict["third_order_condition"] = umbrella.third_order_condition;
  dict["regular_vertex"] = umbrella.vertex.isRegular();
  dict["spoke_move_mm"] = umbrella.largest_spoke_move_mm;
  dict["second_change_mm"] = umbrella.largest_second_change;
  dict["third_change_mm"] = umbrella.largest_third_change;
  dict["member_move_mm"] = umbrella.largest_member_move_mm;
  dict["free_vectors"] = umbrella.free_vectors;
  return resultOf("G2Umbrella", dict);
}

std::vector<BezierPatch> patchesOf(const py::object& value) {
  std::vector<BezierPatch> patches;
  for (const UmbrellaMember& member : membersOf(value)) {
    const auto* patch = std::get_if<BezierPatch>(&member);
    if (patch == nullptr)
      throw py::value_error("member " + std::to_string(patches.size()) +
                            " is a BezierTriangle: only patches join G2 here");
    patches.push_back(*patch);
  }
  return patches;
}

py::object g2UmbrellaOf(const py::object& spokes, const py::object& closed_fan,
                        const py::object& members, const py::object& degree, const py::object& form,
                        const py::object& gap_mm, const py::object& flat_rad) {
  const std::vector<BezierCurve> curves = curvesOf("spokes", spokes);
  G2UmbrellaOptions options;
  options.closed = flagOf("closed", closed_fan);
  options.members = patchesOf(members);
  options.degree = optionalWhole("degree", degree);
  options.form = formOf(form);
  options.gap_mm = numberOf("gap_mm", gap_mm);
  options.vertex.flat_rad = numberOf("flat_rad", flat_rad);
  const auto built = [&] {
    const py::gil_scoped_release unlocked;
    return g2Umbrella(curves, options);
  };
  return g2UmbrellaResult(built());
}

SpokeSeconds secondsOf(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second,
                       const py::object& slopes, const py::object& cross_slopes) {
  SpokeSeconds seconds = defaultSeconds(vertex, second);
  if (!slopes.is_none()) seconds.lambda = numbersOf("slopes", slopes);
  if (!cross_slopes.is_none()) seconds.mu = numbersOf("cross_slopes", cross_slopes);
  return seconds;
}

py::object umbrellaTwistsOf(const py::object& tangents, const py::object& second_derivatives,
                            const py::object& closed_fan, const py::object& slopes,
                            const py::object& cross_slopes, const py::object& form,
                            const py::object& flat_rad) {
  const UmbrellaVertex vertex =
      umbrellaVertex(rowsOf("tangents", tangents, "(spokes, 3)").transpose(),
                     flagOf("closed", closed_fan), {numberOf("flat_rad", flat_rad)});
  Eigen::Matrix3Xd second =
      rowsOf("second_derivatives", second_derivatives, "(spokes, 3)").transpose();
  if (second.cols() != vertex.spokes())
    throw py::value_error("second_derivatives have " + std::to_string(second.cols()) +
                          " rows for " + std::to_string(vertex.spokes()) + " tangents");
  if (const std::optional<Eigen::Matrix3d> shape = formOf(form))
    second = shapedBy(vertex, *shape, second);
  const SpokeSeconds given = secondsOf(vertex, second, slopes, cross_slopes);
  const SpokeSeconds used = closed(vertex, given);
  const TwistSolution solution = solveTwists(vertex);
  py::dict dict;
  dict["twists"] = Poles(leastTwists(vertex, used).transpose());
  dict["direction"] =
      solution.direction.size() > 0 ? py::cast(solution.direction) : py::object(py::none());
  dict["closing_defect_mm"] = Eigen::Vector3d(closingDefect(vertex, given));
  dict["second_derivatives"] = Poles(used.second.transpose());
  dict["slopes"] = used.lambda;
  dict["cross_slopes"] = used.mu;
  dict["alpha"] = vertex.alpha;
  dict["beta"] = vertex.beta;
  dict["form"] = Eigen::Matrix3d(secondForm(vertex, used.second));
  return resultOf("UmbrellaTwists", dict);
}

constexpr const char* umbrella_doc =
    R"(Patches and triangles around a point that join G1 across every spoke: an Umbrella.

spokes: BezierCurves, splines of one segment or arrays (n+1, 3), that begin at the point, in their
order around it. Member i has spoke i as its edge v0 (l1 of a triangle) and spoke i + 1 as its edge
u0 (l0, run backwards). closed: as many members as spokes; False: one less, and the outer spokes
are on the boundary.

kinds: 'patch' or 'triangle' for each member, None: patches. members: those to be changed as
little as possible, or an Umbrella; None: the fairest are built. degree: of the members, None: the
lowest that does. slopes, cross_slopes: how beta and -alpha of each connection change at the
point, None: the best, and 0. form: (3, 3), a second fundamental form that the spokes get the
curvature of. boundary: for each member None, or a pair of curves that its outer edges keep: the
edge u1, from the end of its first spoke, and v1, from the end of its second one; of a triangle the
edge from the first to the second and None; None for an edge that is free. across: pairs of curves
in the same way, whose poles are the vectors of the derivative by u across u1 and by v across v1.
Rational spokes, boundaries and members make a rational umbrella. gap_mm, flat_rad: how far the
beginnings may differ and tangents may leave their plane.

ValueError says what is wrong with which spoke or sector.)";

constexpr const char* g2_umbrella_doc =
    R"(Patches around a point that join G2 across every spoke, along its whole length: a G2Umbrella.

spokes, closed, degree, gap_mm and flat_rad are those of umbrella(). members: patches to be changed
as little as possible, or an umbrella of patches; None: the fairest are built. form: (3, 3), the
second fundamental form of all members at the point; None: the nearest to the spokes' curvatures.

Spokes keep their poles, but for the least changes that G2 requires: all curvatures along the normal
are those of the form, and where four spokes continue each other their second derivatives are equal
too. ValueError says what is wrong with which spoke or sector.)";

constexpr const char* umbrella_inside_doc =
    R"(The Umbrella inside a closed boundary of 3 to 12 polynomial BezierCurves or arrays (n+1, 3).

One patch for each corner, spokes from the fairest centre to the middles of the sides. Member i has
the corner between side i and side i + 1 at (u, v) = (1, 1).)";

constexpr const char* umbrella_twists_doc =
    R"(The twists of the members around a point, from its spokes to second order: UmbrellaTwists.

tangents, second_derivatives: (spokes, 3), of the spokes at the point, in mm. Members join G1 across
spoke i at the point with V = a C' + b U, a(0) = alpha, b(0) = beta, a'(0) = slopes, b'(0) =
cross_slopes; then X_i - beta_i X_(i-1) = alpha_i C_i'' + slopes_i C_i' + cross_slopes_i C_(i-1)'
for the twists X. A closed fan of an even number of members has twists only if an alternating sum
of these is zero: second derivatives and slopes are changed as little as makes it so. form: (3, 3),
a second fundamental form that the spokes get the curvature of. slopes, None: -alpha; cross_slopes,
None: 0. closed and flat_rad are those of umbrella().

ValueError says what is wrong with which spoke or sector.)";

}  // namespace

void bindUmbrella(py::module_& module) {
  module.def("umbrella", &umbrellaOf, umbrella_doc, py::arg("spokes"), py::kw_only(),
             py::arg("closed") = true, py::arg("kinds") = py::none(),
             py::arg("members") = py::none(), py::arg("degree") = py::none(),
             py::arg("slopes") = py::none(), py::arg("cross_slopes") = py::none(),
             py::arg("form") = py::none(), py::arg("boundary") = py::none(),
             py::arg("across") = py::none(), py::arg("gap_mm") = UmbrellaOptions{}.gap_mm,
             py::arg("flat_rad") = VertexOptions{}.flat_rad);
  module.def("g2_umbrella", &g2UmbrellaOf, g2_umbrella_doc, py::arg("spokes"), py::kw_only(),
             py::arg("closed") = true, py::arg("members") = py::none(),
             py::arg("degree") = py::none(), py::arg("form") = py::none(),
             py::arg("gap_mm") = G2UmbrellaOptions{}.gap_mm,
             py::arg("flat_rad") = VertexOptions{}.flat_rad);
  module.def("umbrella_twists", &umbrellaTwistsOf, umbrella_twists_doc, py::arg("tangents"),
             py::arg("second_derivatives"), py::kw_only(), py::arg("closed") = true,
             py::arg("slopes") = py::none(), py::arg("cross_slopes") = py::none(),
             py::arg("form") = py::none(), py::arg("flat_rad") = VertexOptions{}.flat_rad);
  module.def("umbrella_inside", &umbrellaInsideOf, umbrella_inside_doc, py::arg("sides"),
             py::kw_only(), py::arg("spoke_degree") = UmbrellaInsideOptions{}.spoke_degree,
             py::arg("degree") = py::none(), py::arg("gap_mm") = UmbrellaInsideOptions{}.gap_mm);
}

}  // namespace seamwright::python
