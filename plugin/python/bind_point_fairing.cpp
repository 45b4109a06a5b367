// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

py::object pointFairnessResult(const PointFairness& fairness) {
  py::dict dict;
  dict["energy_per_mm3"] = fairness.energy_per_mm3;
  dict["rounding_per_mm3"] = fairness.rounding_per_mm3;
  dict["extrema"] = fairness.extrema;
  dict["inflections"] = fairness.inflections;
  return resultOf("PointFairness", dict);
}

const char* statusName(PointFairingStatus status) {
  switch (status) {
    case PointFairingStatus::Converged:
      return "converged";
    case PointFairingStatus::EnergyGrows:
      return "energy grows";
    case PointFairingStatus::NotConverged:
      break;
  }
  return "not converged";
}

py::object fairedPointsResult(const FairedPoints& faired) {
  py::dict dict;
  dict["points_mm"] = faired.points;
  dict["before"] = pointFairnessResult(faired.before);
  dict["after"] = pointFairnessResult(faired.after);
  dict["moved_mm"] = faired.moved_mm;
  dict["most_moved"] = faired.most_moved;
  dict["steps"] = faired.steps;
  dict["status"] = statusName(faired.status);
  dict["converged"] = faired.status == PointFairingStatus::Converged;
  return resultOf("FairedPoints", dict);
}

Eigen::VectorXd pointCurvaturesOf(const py::object& points, const py::object& closed) {
  return pointCurvatures_per_mm(planarPointsOf("points", points), flagOf("closed", closed));
}

std::vector<Eigen::Index> isolatedInflectionsOf(const py::object& points,
                                                const py::object& closed) {
  return isolatedInflections(planarPointsOf("points", points), flagOf("closed", closed));
}

py::object pointFairnessOf(const py::object& points, const py::object& closed) {
  return pointFairnessResult(
      fairnessOf(planarPointsOf("points", points), flagOf("closed", closed)));
}

py::object fairPointsOf(const py::object& points, const py::object& tolerance_mm,
                        const py::object& closed, const py::object& ends_fixed,
                        const py::object& max_steps) {
  const PlanarPoints rows = planarPointsOf("points", points);
  const Eigen::VectorXd tolerances =
      arrayOfNumbers(each("tolerance_mm", tolerance_mm, rows.rows()));
  const PointFairingOptions options{.closed = flagOf("closed", closed),
                                    .ends_fixed = flagOf("ends_fixed", ends_fixed),
                                    .max_steps = wholeNumber("max_steps", max_steps)};
  return fairedPointsResult([&] {
    const py::gil_scoped_release release;
    return fairPoints(rows, tolerances, options);
  }());
}

py::object filterCurvatureOf(const py::object& points, const py::object& tolerance_mm,
                             const py::object& closed, const py::object& strength,
                             const py::object& max_passes) {
  const PlanarPoints rows = planarPointsOf("points", points);
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  const CurvatureFilterOptions options{.closed = flagOf("closed", closed),
                                       .strength = numberOf("strength", strength),
                                       .max_passes = wholeNumber("max_passes", max_passes)};
  return fairedPointsResult([&] {
    const py::gil_scoped_release release;
    return filterCurvature(rows, tolerance, options);
  }());
}

}  // namespace

void bindPointFairing(py::module_& module) {
  module.def("point_curvatures", &pointCurvaturesOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = false,
             R"(The curvature in 1/mm of the circle through each point and its neighbours: an array.

points: (count, 2) in mm; above 0 the polygon turns to the left. closed: (count,); open: (count -
2,), without the end points. ValueError for fewer than 3 points, numbers that are not finite, and
two of three neighbours that are equal or apart by less than 1e-30 mm or more than 1e30 mm, with the
indices. Source: docs/theory/planar.md P10.1.
)");
  module.def("isolated_inflections", &isolatedInflectionsOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = false,
             R"(Indices of points whose curvature has another sign than that of both neighbours.

points: (count, 2) in mm. Such a point is most often a misread digit. ValueError as for
point_curvatures(). Source: docs/theory/planar.md P10.2.
)");
  module.def("point_fairness", &pointFairnessOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = false,
             R"(How fair a sequence of points is: a PointFairness.

points: (count, 2) in mm. ValueError as for point_curvatures(). Source: docs/theory/planar.md P10.1.
)");
  module.def("fair_points", &fairPointsOf, py::arg("points"), py::arg("tolerance_mm"),
             py::kw_only(), py::arg("closed") = false, py::arg("ends_fixed") = true,
             py::arg("max_steps") = 200,
             R"(The fairest points within tolerances, those of least energy: FairedPoints.

points: (count, 2) in mm. tolerance_mm: a number or one for each point, 0 fixes a point. ends_fixed:
the first and the last point of an open sequence stay. The energy approximates the integral of
(dk/ds)^2 and never grows; each point moves along the normal of the chord of its neighbours. The
time of a step is linear in count. ValueError for tolerances that are negative or not finite, with
the index, and as for point_curvatures(). Source: docs/theory/planar.md P10.3.
)");
  module.def("filter_curvature", &filterCurvatureOf, py::arg("points"), py::arg("tolerance_mm"),
             py::kw_only(), py::arg("closed") = false, py::arg("strength") = 0.25,
             py::arg("max_passes") = 100,
             R"(Points after a low-pass filter of the curvature: FairedPoints.

points: (count, 2) in mm. No point moves by more than tolerance_mm. strength, above 0 and at most
1/4: 1/4 extinguishes the shortest waves in one pass. It minimises nothing; fair_points() finds
fairer points. ValueError for a bad tolerance or strength, and as for planar_tangents(). Source:
docs/theory/planar.md P10.4.
)");
}

}  // namespace seamwright::python
