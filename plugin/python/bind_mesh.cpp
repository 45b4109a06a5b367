// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <seamwright/occ_adapter/display/mesh.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

/// An array of shape (rows, columns) from contiguous rows of numbers.
template <class Number, class Row>
py::array_t<Number> tableOf(const std::vector<Row>& rows) {
  constexpr std::size_t columns = sizeof(Row) / sizeof(Number);
  static_assert(columns * sizeof(Number) == sizeof(Row));
  py::array_t<Number> table({rows.size(), columns});
  const auto* first = reinterpret_cast<const Number*>(rows.data());
  if (!rows.empty()) std::copy(first, first + rows.size() * columns, table.mutable_data());
  return table;
}

template <class Number>
py::array_t<Number> arrayFrom(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array_t<double> combined(const occ::DisplayMesh& mesh,
                             double (*combine)(const occ::NodeCurvature&)) {
  std::vector<double> values(mesh.curvatures.size());
  std::ranges::transform(mesh.curvatures, values.begin(), combine);
  return arrayFrom(values);
}

occ::DisplayMesh meshOf(const occ::Model& model, const py::object& curvatures,
                        const py::object& before, const py::object& moved_faces,
                        const py::object& rough_mm, const py::object& jobs,
                        const py::object& progress) {
  occ::DisplayMeshOptions options;
  options.curvatures = flagOf("curvatures", curvatures);
  options.jobs = wholeNumber("jobs", jobs);
  occ::MovedFaces moved;
  moved.faces = wholeNumbers("moved_faces", moved_faces);
  if (before.is_none() && !moved.faces.empty())
    throw py::value_error("moved_faces is given without before");
  if (!before.is_none())
    moved.before = objectOf<occ::Model>("before", before, "a Model or None").shape;
  moved.rough_mm = numberOf("rough_mm", rough_mm);
  return longCall(progress, [&](const occ::Progress& report) {
    return occ::displayMesh(model, options, moved, report);
  });
}

py::list faultsOf(const occ::DisplayMesh& mesh) {
  py::list faults;
  for (const occ::MeshFault& fault : mesh.faults) {
    py::dict entry;
    entry["face"] = fault.face;
    entry["reason"] = fault.reason;
    faults.append(resultOf("MeshFault", entry));
  }
  return faults;
}

/// Rows of numbers from an array that tableOf() made.
template <class Row, class Number = typename Row::value_type>
std::vector<Row> rowsFrom(const py::handle& array) {
  const auto table = py::cast<py::array_t<Number, py::array::c_style>>(array);
  std::vector<Row> rows(static_cast<std::size_t>(table.shape(0)));
  std::copy(table.data(), table.data() + table.size(), reinterpret_cast<Number*>(rows.data()));
  return rows;
}

py::tuple meshState(const occ::DisplayMesh& mesh) {
  py::list faults;
  for (const occ::MeshFault& fault : mesh.faults)
    faults.append(py::make_tuple(fault.face, fault.reason));
  return py::make_tuple(tableOf<double>(mesh.points), tableOf<double>(mesh.normals),
                        tableOf<double>(mesh.parameters), tableOf<double>(mesh.curvatures),
                        arrayFrom(mesh.moves_mm), tableOf<int>(mesh.triangles), mesh.first_nodes,
                        mesh.first_triangles, faults);
}

occ::DisplayMesh meshFrom(const py::tuple& state) {
  occ::DisplayMesh mesh;
  mesh.points = rowsFrom<Eigen::Vector3d>(state[0]);
  mesh.normals = rowsFrom<Eigen::Vector3d>(state[1]);
  mesh.parameters = rowsFrom<Eigen::Vector2d>(state[2]);
  mesh.curvatures = rowsFrom<occ::NodeCurvature, double>(state[3]);
  mesh.moves_mm = state[4].cast<std::vector<double>>();
  mesh.triangles = rowsFrom<std::array<int, 3>>(state[5]);
  mesh.first_nodes = state[6].cast<std::vector<std::size_t>>();
  mesh.first_triangles = state[7].cast<std::vector<std::size_t>>();
  for (const py::handle item : state[8].cast<py::list>()) {
    const auto fault = item.cast<py::tuple>();
    mesh.faults.push_back({fault[0].cast<int>(), fault[1].cast<std::string>()});
  }
  return mesh;
}

void bindDisplayMesh(py::module_& module) {
  using Mesh = occ::DisplayMesh;
  py::class_<Mesh>(module, "DisplayMesh", py::module_local(),
                   "Triangles of all faces of a model with what its surfaces are at the nodes. "
                   "Each attribute is "
                   "a new array.")
      .def_property_readonly(
          "points", [](const Mesh& mesh) { return tableOf<double>(mesh.points); },
          "Shape (n, 3), in mm.")
      .def_property_readonly(
          "normals", [](const Mesh& mesh) { return tableOf<double>(mesh.normals); },
          "Shape (n, 3): unit normals of the faces.")
      .def_property_readonly(
          "parameters", [](const Mesh& mesh) { return tableOf<double>(mesh.parameters); },
          "Shape (n, 2): u and v.")
      .def_property_readonly(
          "triangles", [](const Mesh& mesh) { return tableOf<int>(mesh.triangles); },
          "Shape (m, 3): nodes from 0.")
      .def_property_readonly(
          "first_nodes", [](const Mesh& mesh) { return arrayFrom(mesh.first_nodes); },
          "The nodes of face i + 1 are first_nodes[i] to first_nodes[i + 1] - 1.")
      .def_property_readonly(
          "first_triangles", [](const Mesh& mesh) { return arrayFrom(mesh.first_triangles); },
          "The same of triangles.")
      .def_property_readonly(
          "principal_curvatures", [](const Mesh& mesh) { return tableOf<double>(mesh.curvatures); },
          "Shape (n, 2): k1 >= k2 in 1/mm, positive where the face bends towards its normal; nan "
          "at the tip "
          "of "
          "a cone. Empty unless asked for.")
      .def_property_readonly(
          "mean_curvature",
          [](const Mesh& mesh) {
            return combined(mesh, [](const occ::NodeCurvature& k) { return 0.5 * (k.k1 + k.k2); });
          },
          "Shape (n,): (k1 + k2) / 2 in 1/mm.")
      .def_property_readonly(
          "gaussian_curvature",
          [](const Mesh& mesh) {
            return combined(mesh, [](const occ::NodeCurvature& k) { return k.k1 * k.k2; });
          },
          "Shape (n,): k1 k2 in 1/mm^2.")
      .def_property_readonly(
          "moves_mm", [](const Mesh& mesh) { return arrayFrom(mesh.moves_mm); },
          "Shape (n,): how far each node moved; empty without before.")
      .def_property_readonly(
          "faults", &faultsOf,
          "Faces whose triangles are missing or do not cover them: a list of MeshFaults.")
      .def(py::pickle(&meshState, &meshFrom))
      .def("__repr__", [](const Mesh& mesh) {
        return "<DisplayMesh of " + std::to_string(mesh.triangles.size()) + " triangles>";
      });
}

constexpr const char* display_mesh_doc =
    R"(Triangles to look at, fine enough for reflections, with exact normals: a DisplayMesh.

curvatures: compute them too. before: the model before it was repaired, or None. moved_faces: the
numbers of its faces that moved, whose triangles are made small enough that the move between two
nodes is the mean of theirs up to rough_mm. jobs: threads; 0: one for each processor. Faces that
can't be triangulated are listed in the faults.)";

}  // namespace

void bindMesh(py::module_& module) {
  bindDisplayMesh(module);
  py::class_<occ::Model> model(module.attr("Model"));
  model.def("display_mesh", &meshOf, display_mesh_doc, py::kw_only(), py::arg("curvatures") = true,
            py::arg("before") = py::none(), py::arg("moved_faces") = py::tuple(),
            py::arg("rough_mm") = 0.0, py::arg("jobs") = 0, py::arg("progress") = py::none());
}

}  // namespace seamwright::python
