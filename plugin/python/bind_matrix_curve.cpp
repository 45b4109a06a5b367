// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/fair/fair_hermite.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/fairness.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

constexpr const char* points_shape = "(count, 3)";

/// One number for each pole.
std::vector<double> poleNumbers(const char* name, const py::object& value, Eigen::Index count) {
  const std::vector<double> numbers = each(name, value, count);
  if (static_cast<Eigen::Index>(numbers.size()) != count)
    throw py::value_error(std::string(name) + " has " + std::to_string(numbers.size()) +
                          " numbers for " + std::to_string(count) + " points");
  return numbers;
}

MatrixCurve makeMatrixCurve(const py::object& degree, const py::object& knots,
                            const py::object& points, const py::object& tangents,
                            const py::object& weights, const py::object& stiffness) {
  const Poles rows = rowsOf("points", points, points_shape);
  const Poles along = tangents.is_none() ? Poles(Poles::Zero(rows.rows(), 3))
                                         : rowsOf("tangents", tangents, points_shape);
  if (along.rows() != rows.rows())
    throw py::value_error("tangents are " + std::to_string(along.rows()) + " for " +
                          std::to_string(rows.rows()) + " points");
  const std::vector<double> factors = poleNumbers("weights", weights, rows.rows());
  const std::vector<double> stiff = poleNumbers("stiffness", stiffness, rows.rows());
  MatrixCurve curve;
  curve.degree = wholeNumber("degree", degree);
  curve.knots = listOf("knots", knots);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    curve.poles.push_back({.point = rows.row(i).transpose(),
                           .tangent = along.row(i).transpose(),
                           .weight = factors[static_cast<std::size_t>(i)],
                           .stiffness = stiff[static_cast<std::size_t>(i)]});
  requireValid(curve);
  return curve;
}

Poles pointRows(const MatrixCurve& curve, Eigen::Vector3d MatrixPole::*member) {
  Poles rows(static_cast<Eigen::Index>(curve.poles.size()), 3);
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = (curve.poles[i].*member).transpose();
  return rows;
}

Eigen::VectorXd poleValues(const MatrixCurve& curve, double MatrixPole::*member) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(curve.poles.size()));
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    values(static_cast<Eigen::Index>(i)) = curve.poles[i].*member;
  return values;
}

/// What a curve can do.
void bindMatrixMembers(py::class_<MatrixCurve>& type) {
  type.def(
          "point",
          [](const MatrixCurve& c, const py::object& t) {
            const Parameters at("t", t);
            return valuesOf(at.shape(), {3}, [&](py::ssize_t i) {
              return Eigen::RowVector3d(pointAndTangent(c, at[i]).row(0));
            });
          },
          py::arg("t"), "The point (3,); for an array of shape s, points s + (3,).")
      .def(
          "derivative",
          [](const MatrixCurve& c, const py::object& t) {
            const Parameters at("t", t);
            return valuesOf(at.shape(), {3}, [&](py::ssize_t i) {
              return Eigen::RowVector3d(pointAndTangent(c, at[i]).row(1));
            });
          },
          py::arg("t"), "dX/dt (3,); for an array of shape s, an array of shape s + (3,).")
      .def(
          "bezier_spline", [](const MatrixCurve& c) { return bezierSpline(c); },
          R"(The same points as a rational BezierSpline with positive weights.

The degree is 3 times that of the curve, 2 times in the plane z = 0. ValueError above degree 25, and
for weights that differ by many orders of magnitude. Source: docs/theory/planar.md P13.2.
)")
      .def(
          "to_bspline", [](const MatrixCurve& c) { return bsplineCurve(c); },
          R"(The same points as a rational BSplineCurve.

ValueError as of bezier_spline(). Source: docs/theory/planar.md P13.2.
)")
      .def(py::pickle(
          [](const MatrixCurve& c) {
            return py::make_tuple(c.degree, c.knots, pointRows(c, &MatrixPole::point),
                                  pointRows(c, &MatrixPole::tangent),
                                  poleValues(c, &MatrixPole::weight),
                                  poleValues(c, &MatrixPole::stiffness));
          },
          [](const py::tuple& state) {
            return makeMatrixCurve(state[0], state[1], state[2], state[3], state[4], state[5]);
          }))
      .def("__repr__", [](const MatrixCurve& c) {
        return "<MatrixCurve of degree " + std::to_string(c.degree) + " with " +
               std::to_string(c.poles.size()) + " poles>";
      });
  bindEquality(type);
}

void bindMatrixCurveClass(py::module_& module) {
  py::class_<MatrixCurve> type(module, "MatrixCurve", py::module_local(),
                               R"(A B-spline curve whose weights are matrices.

knots: flat, as of a BSplineCurve. points: (count, 3) in mm. tangents: (count, 3) of any length;
None: without stiffness. weights, stiffness: a number, or one for each point. A pole draws the curve
to its point with its weight, and across its tangent with 1 + stiffness times the weight. With
stiffness 0 it is the rational B-spline of the weights. It is accepted where a curve is, as its
to_bspline(). ValueError for counts that do not match, weights that are not positive, a stiffness
outside of 0 .. 1e8, and tangents that are 0. Source: docs/theory/planar.md P13.1; [Yang2016].
)");
  type.def(py::init(&makeMatrixCurve), py::arg("degree"), py::arg("knots"), py::arg("points"),
           py::arg("tangents") = py::none(), py::arg("weights") = 1.0, py::arg("stiffness") = 0.0)
      .def_property_readonly(
          "degree", [](const MatrixCurve& c) { return c.degree; }, "Of the B-spline basis.")
      .def_property_readonly(
          "knots", [](const MatrixCurve& c) { return c.knots; },
          "Flat: each is repeated by its multiplicity.")
      .def_property_readonly(
          "points", [](const MatrixCurve& c) { return pointRows(c, &MatrixPole::point); },
          "(count, 3), in mm.")
      .def_property_readonly(
          "tangents", [](const MatrixCurve& c) { return pointRows(c, &MatrixPole::tangent); },
          "(count, 3), as given.")
      .def_property_readonly(
          "weights", [](const MatrixCurve& c) { return poleValues(c, &MatrixPole::weight); },
          "(count,).")
      .def_property_readonly(
          "stiffness", [](const MatrixCurve& c) { return poleValues(c, &MatrixPole::stiffness); },
          "(count,).");
  bindMatrixMembers(type);
}

HermitePoints hermitePointsOf(const py::object& points, const py::object& tangents) {
  return {.points = rowsOf("points", points, points_shape),
          .tangents = rowsOf("tangents", tangents, points_shape)};
}

MatrixFitOptions fitOptionsOf(const py::object& degree, const py::object& stiffness) {
  return {.degree = wholeNumber("degree", degree), .stiffness = numberOf("stiffness", stiffness)};
}

py::object matrixFitResult(const MatrixFit& fit) {
  py::dict dict;
  dict["curve"] = fit.curve;
  dict["parameters"] = fit.parameters;
  dict["missed_mm"] = fit.missed_mm;
  dict["missed_tangent_rad"] = fit.missed_tangent_rad;
  return resultOf("MatrixFit", dict);
}

py::object fitHermiteOf(const py::object& points, const py::object& tangents,
                        const py::object& degree, const py::object& stiffness) {
  const HermitePoints data = hermitePointsOf(points, tangents);
  const MatrixFitOptions options = fitOptionsOf(degree, stiffness);
  return matrixFitResult([&] {
    const py::gil_scoped_release release;
    return fitHermite(data, options);
  }());
}

py::object fairHermiteOf(const py::object& points, const py::object& tangents,
                         const py::object& tolerance_mm, const py::object& most_passes,
                         const py::object& fair_tangents, const py::object& degree,
                         const py::object& stiffness) {
  const HermitePoints data = hermitePointsOf(points, tangents);
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  const HermiteFairingOptions options{.most_passes = wholeNumber("most_passes", most_passes),
                                      .fair_tangents = flagOf("fair_tangents", fair_tangents),
                                      .fit = fitOptionsOf(degree, stiffness)};
  const FairedHermite faired = [&] {
    const py::gil_scoped_release release;
    return fairHermite(data, tolerance, options);
  }();
  py::dict dict;
  dict["points_mm"] = faired.data.points;
  dict["tangents"] = faired.data.tangents;
  dict["fit"] = matrixFitResult(faired.fit);
  dict["curve"] = faired.fit.curve;
  dict["moved_mm"] = faired.moved_mm;
  dict["before"] = curvatureVariationResult(faired.before);
  dict["after"] = curvatureVariationResult(faired.after);
  dict["passes"] = faired.passes;
  dict["added_extrema"] = faired.addedExtrema();
  dict["added_inflections"] = faired.addedInflections();
  return resultOf("FairedHermite", dict);
}

py::object matrixPassOf(const py::object& points, const py::object& tangents,
                        const py::object& stiffness, const py::object& fair_tangents) {
  const HermitePoints found =
      matrixPass(hermitePointsOf(points, tangents), numberOf("stiffness", stiffness),
                 flagOf("fair_tangents", fair_tangents));
  py::dict dict;
  dict["points_mm"] = found.points;
  dict["tangents"] = found.tangents;
  return resultOf("HermitePoints", dict);
}

py::object curvatureVariationOf(const py::object& curve) {
  return curvatureVariationResult(variationOf(bezierSplineOf("curve", curve)));
}

}  // namespace

void bindMatrixCurve(py::module_& module) {
  bindMatrixCurveClass(module);
  module.def(
      "fit_hermite", &fitHermiteOf, py::arg("points"), py::arg("tangents"), py::kw_only(),
      py::arg("degree") = 3, py::arg("stiffness") = 1.0,
      R"(A MatrixCurve through points, whose poles have the tangents of the points: a MatrixFit.

points, tangents: (count, 3), points in mm, tangents of any length. Points are met up to rounding,
tangents approximately. stiffness: 0 ignores the tangents; with 1 points of circles are met best.
ValueError for fewer points than degree + 1, equal neighbours, and tangents that are 0. Source:
docs/theory/planar.md P13.3; [Yang2016].
)");
  module.def("fair_hermite", &fairHermiteOf, py::arg("points"), py::arg("tangents"),
             py::arg("tolerance_mm"), py::kw_only(), py::arg("most_passes") = 10,
             py::arg("fair_tangents") = true, py::arg("degree") = 3, py::arg("stiffness") = 1.0,
             R"(Points with tangents made fair by matrix weights: a FairedHermite.

points, tangents, degree, stiffness: as of fit_hermite(). Each pass moves the points between the
ends, and unless fair_tangents is False turns the tangents. The energy does not grow, no point moves
by more than tolerance_mm, and a tolerance of 0 changes nothing. ValueError for a tolerance that is
negative or not finite, and as of fit_hermite(). Source: docs/theory/planar.md P13.5; [Yang2016].
)");
  module.def("matrix_pass", &matrixPassOf, py::arg("points"), py::arg("tangents"), py::kw_only(),
             py::arg("stiffness") = 1.0, py::arg("fair_tangents") = true,
             R"(One pass of fair_hermite() without a tolerance: HermitePoints.

points, tangents, stiffness, fair_tangents: as of fair_hermite(). Tangents that change get the
length 1; the ends stay. ValueError for equal neighbours, tangents that are 0, and a stiffness
outside of 0 .. 1e8. Source: docs/theory/planar.md P13.5; [Yang2016].
)");
  module.def("curvature_variation", &curvatureVariationOf, py::arg("curve"),
             R"(How much the curvature of a curve of any class varies: a CurvatureVariation.

The energy is 0 for arcs and lines; Gauss' quadrature finds it. ValueError for a segment that is a
point. Source: docs/theory/planar.md P13.4.
)");
}

}  // namespace seamwright::python
