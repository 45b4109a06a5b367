// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "match_pairs.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/blend/blend_surface.hpp>

namespace seamwright::test {
namespace {

using occ::BlendEnd;
using occ::blendSurface;
using occ::BlendSurfaceOptions;
using occ::BlendSurfaceReport;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The number of the edge whose middle is nearest to a point.
int edgeNear(const TopoDS_Shape& shape, const gp_Pnt& point) {
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  int nearest = 0;
  double least = HUGE_VAL;
  for (int i = 1; i <= edges.Extent(); ++i) {
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(TopoDS::Edge(edges(i)), first, last);
    if (curve.IsNull()) continue;
    const double distance = curve->Value((first + last) / 2).Distance(point);
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

BlendSurfaceOptions fine() {
  BlendSurfaceOptions options;
  options.tolerance.gap_mm = 1e-4;
  options.tolerance.angle_rad = 0.001 * degree;
  options.tolerance.curvature_rel = 1e-3;
  return options;
}

/// A trimmed face of each kind, moved to the left of a sheet, and their facing edges.
struct Pair {
  std::string name;
  TopoDS_Shape shape;
  int left = 0, right = 0;
};

std::vector<Pair> pairs() {
  std::vector<Pair> result;
  std::mt19937 generator(testSeed());
  for (const Trimmed& kind : trimmedKinds()) {
    const TopoDS_Face a = trimmedFace(kind.surface, kind.path, kind.into);
    const gp_Pnt2d middle = kind.path->Value(0.5);
    gp_Pnt at;
    gp_Vec u, v;
    kind.surface->D1(middle.X(), middle.Y(), at, u, v);
    // The sheet lies across the path, 25 mm away and a little higher; its side u = 0 faces it.
    gp_Trsf place, turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ()), std::numbers::pi / 2);
    place.SetTransformation(gp_Ax3(at.Translated(25 * v.Normalized()), u.Crossed(v), u), gp::XOY());
    gp_Trsf centre;
    centre.SetTranslation(gp_Vec(20, 0, 4));
    const TopoDS_Shape b = BRepBuilderAPI_Transform(wholeFace(sheet(generator, 9, 8, 5, 5)),
                                                    place * centre * turn, true);
    Pair pair{kind.name, loose(a, b)};
    pair.left = edgeNear(pair.shape, at);
    pair.right = edgeNear(pair.shape, at.Translated(25 * v.Normalized() +
                                                    4 * u.Crossed(v).Normalized()));
    result.push_back(pair);
  }
  return result;
}

TEST(BlendSurface, SidesAreMetAtEachOrderIndependently) {
  for (const Pair& pair : pairs())
    for (int m = 0; m <= 3; ++m)
      for (int n = 0; n <= 3; ++n) {
        const BlendSurfaceReport blend =
            blendSurface(pair.shape, {.side = {{pair.left}}, .order = m},
                         {.side = {{pair.right}}, .order = n}, fine());
        std::string figures;
        for (const occ::SeamResult& seam : blend.seams) figures += occ::figuresText(seam) + "; ";
        EXPECT_EQ(blend.surface.degree_v, m + n + 1);
        EXPECT_EQ(blend.seams.size(), 2U) << pair.name;
        EXPECT_TRUE(blend.reached)
            << pair.name << " G" << m << " G" << n << " spans " << blend.spans << ": " << figures;
      }
}

}  // namespace
}  // namespace seamwright::test
