// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes across smooth joints of different surfaces: no single surface closes them.
#include <gmock/gmock.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "across_models.hpp"
#include "fill_checks.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/fill/fill.hpp>

namespace seamwright::test {
namespace {

using occ::FillHoleReport;
using occ::Hole;
using occ::modelFromShape;

FillHoleReport filled(const TopoDS_Shape& shape) {
  const std::vector<Hole> holes = occ::findHoles(shape).holes;
  return occ::fillHole(modelFromShape(shape), *std::ranges::min_element(holes, {}, &Hole::length_mm));
}

TEST(HolesAcross, Survey) {
  struct Outline {
    const char* name;
    TopoDS_Wire wire;
  };
  std::vector<Outline> all;
  for (double turn : {0.0, 0.4}) {
    all.push_back({"rect 24x14 r4", roundedRectangle(24, 14, 4, turn)});
    all.push_back({"slot 28x8", roundedRectangle(28, 8, 4, turn)});
    all.push_back({"ellipse 1:2", ellipse(24, 12, turn)});
    all.push_back({"ellipse 1:3", ellipse(30, 10, turn)});
    all.push_back({"ellipse 1:4", ellipse(32, 8, turn)});
    all.push_back({"D", halfDisc(10, turn)});
    all.push_back({"L", elbow(24, turn)});
  }
  for (int sheet = 0; sheet < 2; ++sheet)
    for (const Outline& one : all) {
      const auto start = std::chrono::steady_clock::now();
      const FillHoleReport r = filled(cutThrough(sheet ? quarteredSheet() : bentPlate(), one.wire));
      std::printf("%s %-14s %s %.1fs faces %zu angle %.5f deg gap %.2g: %s\n", sheet ? "sheet" : "plate",
                  one.name, r.reached ? "REACHED" : "no",
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                  r.faces.size(), r.largestAngle_rad().value_or(-1) / degree, r.largestGap_mm().value_or(-1),
                  r.reason.c_str());
      for (const auto& s : r.sides)
        std::printf("      %zu edges deg %d %d gap %.2g angle %.2g\n", s.edges.size(), s.edge_degree,
                    s.cross_degree, s.gap_mm, s.angle_rad / degree);
      std::fflush(stdout);
    }
}

TEST(HolesAcross, OpenBox) {
  const TopoDS_Shape box = without(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), {1});
  for (const bool anyway : {false, true}) {
    const occ::Holes found = occ::findHoles(box, {.corner_rad = 179 * degree});
    for (const Hole& hole : found.holes) {
      const FillHoleReport r = occ::fillHole(modelFromShape(box), hole, {.keep_anyway = anyway, .corner_rad = 179 * degree});
      std::printf("box %d: corners %d sides %zu: %d %s\n", anyway, hole.has_corners, hole.sides.size(), r.filled, r.reason.c_str());
      const FillHoleReport p = occ::fillHole(modelFromShape(box), hole, {.keep_anyway = anyway, .continue_surface=false, .corner_rad = 179 * degree});
      std::printf("  patches: %d %s\n", p.filled, p.reason.c_str());
    }
  }
}

}  // namespace
}  // namespace seamwright::test
