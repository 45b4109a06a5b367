// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <seamwright/core/fair/matrix_curve.hpp>
#include <seamwright/occ_adapter/repair/sewn_model.hpp>
#include <seamwright/occ_adapter/topology/built_model.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::python {

namespace {

/// Values of results that are surfaces, lists of them, or a curve.
constexpr std::array geometry_keys = {"patches", "triangles", "members", "surface", "curve"};

/// The geometry of a value of a bound class; nothing for other values.
std::optional<occ::BuiltGeometry> geometryOf(const py::object& value) {
  if (py::isinstance<BezierPatch>(value)) return value.cast<const BezierPatch&>();
  if (py::isinstance<BezierTriangle>(value)) return value.cast<const BezierTriangle&>();
  if (py::isinstance<BSplineSurface>(value)) return value.cast<const BSplineSurface&>();
  if (py::isinstance<BezierCurve>(value)) return value.cast<const BezierCurve&>();
  if (py::isinstance<BSplineCurve>(value)) return value.cast<const BSplineCurve&>();
  if (py::isinstance<BezierSpline>(value)) return value.cast<const BezierSpline&>();
  if (py::isinstance<MatrixCurve>(value)) return bsplineCurve(value.cast<const MatrixCurve&>());
  return std::nullopt;
}

bool isList(const py::object& value) {
  return py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
}

/// What an item is called: by the user, and in errors.
struct ItemTexts {
  std::string name;
  std::string label;
};

void appendValue(const py::object& value, const ItemTexts& texts,
                 std::vector<occ::BuiltItem>& all) {
  std::optional<occ::BuiltGeometry> geometry = geometryOf(value);
  if (!geometry)
    throw py::type_error(texts.label + " is " + shown(value) +
                         ": a surface, a curve, or a result that has surfaces or a curve, is "
                         "needed");
  all.push_back({.geometry = std::move(*geometry), .name = texts.name, .label = texts.label});
}

/// Appends a surface, a curve, or those of a result in their order.
void appendGeometry(const py::object& value, ItemTexts texts, std::vector<occ::BuiltItem>& all) {
  for (const char* key : geometry_keys) {
    const py::object found = itemOrSelf(value, key);
    if (found.is(value)) continue;
    texts.label += std::string(".") + key;
    if (!isList(found)) return appendValue(found, texts, all);
    const auto list = py::reinterpret_borrow<py::sequence>(found);
    for (std::size_t i = 0; i < list.size(); ++i)
      appendValue(list[i],
                  {.name = texts.name, .label = texts.label + '[' + std::to_string(i) + ']'}, all);
    return;
  }
  appendValue(value, texts, all);
}

/// A name for each item, empty for None.
std::vector<std::string> namesOf(const py::object& names, std::size_t count) {
  std::vector<std::string> all(count);
  if (names.is_none()) return all;
  if (!isList(names))
    throw py::type_error("names is " + shown(names) + ": a list of texts or None is needed");
  const auto list = py::reinterpret_borrow<py::sequence>(names);
  if (list.size() != count)
    throw py::value_error("names has " + std::to_string(list.size()) + " names for " +
                          std::to_string(count) + (count == 1 ? " item" : " items"));
  for (std::size_t i = 0; i < count; ++i) {
    const py::object name = list[i];
    if (name.is_none()) continue;
    if (!py::isinstance<py::str>(name))
      throw py::type_error("names[" + std::to_string(i) + "] is " + shown(name) +
                           ": a text or None is needed");
    all[i] = name.cast<std::string>();
  }
  return all;
}

std::vector<occ::BuiltItem> itemsOf(const py::object& items, const py::object& names) {
  const py::sequence list =
      isList(items) ? py::sequence(items) : py::sequence(py::make_tuple(items));
  const std::vector<std::string> texts = namesOf(names, list.size());
  std::vector<occ::BuiltItem> all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string label = isList(items) ? "items[" + std::to_string(i) + ']' : "items";
    appendGeometry(list[i], {.name = texts[i], .label = label}, all);
  }
  return all;
}

occ::Model modelFromPatches(const py::object& items, const py::object& names,
                            const py::object& tolerance_mm, const py::object& sew_mm,
                            const py::object& jobs, const py::object& progress) {
  const std::vector<occ::BuiltItem> all = itemsOf(items, names);
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  const std::optional<double> sew = optionalNumber("sew_mm", sew_mm);
  const int threads = wholeNumber("jobs", jobs);
  return longCall(progress, [&](const occ::Progress& report) {
    occ::Model model = occ::builtModel(all, tolerance);
    if (!sew) return model;
    return occ::sewnModel(model, {.sew_mm = *sew, .jobs = threads}, report);
  });
}

constexpr const char* from_patches_doc =
    R"(A model of surfaces and curves: a face for each patch, an edge for each curve.

items: a list of BezierPatch, BezierTriangle (three faces), BSplineSurface, BezierCurve,
BSplineCurve, BezierSpline, MatrixCurve, and of results that have them (Umbrella, fills, FrameLoft);
or one of these. Poles, weights and knots stay as they are. names: for each item its name, or None.
tolerance_mm: a side whose poles are no further apart is a point, and opposite sides that coincide
are one edge. sew_mm: free edges that are no further apart become one edge, where that can be
proven; notes say what is left; None: every item has edges of its own, and match_mm of analyze()
finds those side by side. jobs: threads; 0: one for each processor. progress: as for analyze().
ValueError and TypeError name the item, counted from 0.)";

}  // namespace

void bindBuiltModel(py::module_& module) {
  py::class_<occ::Model> model(module.attr("Model"));
  model.def_static("from_patches", &modelFromPatches, from_patches_doc, py::arg("items"),
                   py::arg("names") = py::none(), py::kw_only(), py::arg("tolerance_mm") = 1e-7,
                   py::arg("sew_mm") = py::none(), py::arg("jobs") = 0,
                   py::arg("progress") = py::none());
  model.def(
      "surface",
      [](const occ::Model& self, const py::object& face) {
        return occ::faceSurface(self, wholeNumber("face", face));
      },
      py::arg("face"),
      "The Bézier or B-spline surface of a face, numbered from 1: a BSplineSurface with the same "
      "poles, weights and knots. A trimmed face has the whole surface. ValueError for a surface of "
      "another kind, with the kind.");
  model.def(
      "curve",
      [](const occ::Model& self, const py::object& edge) {
        return occ::edgeCurve(self, wholeNumber("edge", edge));
      },
      py::arg("edge"),
      "The Bézier or B-spline curve of an edge, numbered from 1, over the range of the edge: a "
      "BSplineCurve. ValueError for a curve of another kind, and for an edge that is a point.");
}

}  // namespace seamwright::python
