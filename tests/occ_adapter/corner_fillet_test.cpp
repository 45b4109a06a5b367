// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <iostream>

#include "corner_solids.hpp"

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>

namespace seamwright::test {
namespace {

using namespace occ;

void show(const char* what, const TopoDS_Shape& shape, int v, std::vector<double> r) {
  const Model model = modelFromShape(shape);
  CornerFilletOptions o;
  try {
    int k = 0;
    for (int e : cornerEdges(model, v)) o.radii_mm[e] = r[k++ % r.size()];
    const CornerFillet f = cornerFillet(model, v, o);
    std::cout << what << " valid " << f.valid << " met " << f.met << " regular " << f.fill.regular << " gap "
              << f.largestGap_mm() << " angle deg " << f.largestAngle_rad() * 57.29578 << " vol "
              << volume_mm3(shape) << " -> " << volume_mm3(f.model.shape) << " err " << f.section_error_mm
              << " deg " << f.fill.patches[0].degreeU() << " spoke " << f.fill.spoke_scale.value_or(0)
              << "\n";
    for (auto& e : f.edges)
      std::cout << "   edge " << e.edge << (e.convex ? " convex" : " concave") << " r " << e.radius_mm
                << " d " << e.contact_mm << " s " << e.setback_mm << "\n";
  } catch (const std::exception& x) {
    std::cout << what << " : " << x.what() << "\n";
  }
}

TEST(CornerFillet, Look) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  show("cube 1 1 1", box, vertexAt(box, {0, 0, 0}), {1, 1, 1});
  show("cube 1 2 3", box, vertexAt(box, {0, 0, 0}), {1, 2, 3});
  show("cube 0.1 2 4", box, vertexAt(box, {0, 0, 0}), {0.1, 2, 4});
  for (int m = 3; m <= 6; ++m) {
    const TopoDS_Shape p = regularPyramid(m, 10);
    show("pyramid", p, vertexAt(p, {0, 0, 10}), {1, 1, 1});
    show("pyramid 12", p, vertexAt(p, {0, 0, 10}), {0.5, 1});
    show("pyramid flat", regularPyramid(m, 2), vertexAt(regularPyramid(m, 2), {0, 0, 2}), {2});
  }
  const TopoDS_Shape n = notchedCube();
  show("notch inner", n, vertexAt(n, {5, 5, 5}), {1, 0.5, 0.7});
  show("notch mixed", n, vertexAt(n, {10, 5, 5}), {1, 0.5, 0.7});
  show("notch mixed 1", n, vertexAt(n, {10, 5, 5}), {1});
}

}  // namespace
}  // namespace seamwright::test
