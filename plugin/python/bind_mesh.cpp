// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <seamwright/occ_adapter/display/mesh.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>

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
py::array_t<Number> listOf(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array_t<double> combined(const occ::DisplayMesh& mesh,
                             double (*combine)(const occ::NodeCurvature&)) {
  std::vector<double> values(mesh.curvatures.size());
  std::ranges::transform(mesh.curvatures, values.begin(), combine);
  return listOf(values);
}

occ::DisplayMesh meshOf(const occ::Model& model, bool curvatures, const occ::Model* before,
                        const std::vector<int>& moved_faces, double rough_mm, int jobs,
                        const py::object& progress) {
  occ::DisplayMeshOptions options;
  options.curvatures = curvatures;
  options.jobs = jobs;
  if (before == nullptr && !moved_faces.empty())
    throw std::invalid_argument("moved_faces is given without the shape before");
  occ::MovedFaces moved;
  if (before != nullptr) moved.before = before->shape;
  moved.faces = moved_faces;
  moved.rough_mm = rough_mm;
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
    faults.append(std::move(entry));
  }
  return faults;
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
          "first_nodes", [](const Mesh& mesh) { return listOf(mesh.first_nodes); },
          "The nodes of face i + 1 are first_nodes[i] to first_nodes[i + 1] - 1.")
      .def_property_readonly(
          "first_triangles", [](const Mesh& mesh) { return listOf(mesh.first_triangles); },
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
          "moves_mm", [](const Mesh& mesh) { return listOf(mesh.moves_mm); },
          "Shape (n,): how far each node moved; empty without before.")
      .def_property_readonly(
          "faults", &faultsOf,
          "Faces whose triangles are missing or do not cover them: a list of {face, reason}.");
}

}  // namespace

void bindMesh(py::module_& module) {
  bindDisplayMesh(module);
  py::class_<occ::Model> model(module.attr("Model"));
  model.def("display_mesh", &meshOf, py::kw_only(), py::arg("curvatures") = true,
            py::arg("before") = py::none(), py::arg("moved_faces") = std::vector<int>(),
            py::arg("rough_mm") = 0.0, py::arg("jobs") = 0, py::arg("progress") = py::none(),
            "Triangles to look at, fine enough for reflections, with exact normals. Returns a "
            "DisplayMesh.\n\n"
            "before: the model before it was repaired; moved_faces: the numbers of its faces that "
            "moved, whose "
            "triangles are made small enough that the move between two nodes is the mean of theirs "
            "up to rough_mm. "
            "jobs: threads; 0: one for each processor. Faces that can't be triangulated are listed "
            "in the faults.");
}

}  // namespace seamwright::python
