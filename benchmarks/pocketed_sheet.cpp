// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/seams/find.hpp>

#include "pocketed_sheet.hpp"

namespace seamwright::bench {

namespace {

constexpr double cell_mm = 10;   // distance between pockets, and height of the sheet
constexpr double margin_mm = 2;  // distance of the walls of a pocket from its cell
constexpr double radius_mm = 0.5;

Bnd_Box boxOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  return box;
}

/// The shape with those edges rounded whose box \p chosen accepts.
TopoDS_Shape rounded(const TopoDS_Shape& shape, const std::function<bool(const Bnd_Box&)>& chosen) {
  BRepFilletAPI_MakeFillet fillet(shape);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i)
    if (chosen(boxOf(edges(i)))) fillet.Add(radius_mm, TopoDS::Edge(edges(i)));
  return fillet.Shape();
}

/// Whether the box lies inside its cell, away from the outer walls.
bool isInside(const Bnd_Box& box) {
  return box.CornerMin().X() > margin_mm / 4 && box.CornerMax().X() < cell_mm - margin_mm / 4;
}

bool isBelow(const Bnd_Box& box, double z_mm) {
  return box.CornerMin().Z() < z_mm;
}

/// The faces of one pocket: an open shell whose boundary lies in the plane z = cell_mm.
TopoDS_Shape makePocket() {
  const double far_mm = cell_mm - margin_mm;
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(cell_mm, cell_mm, cell_mm).Shape();
  const TopoDS_Shape tool = rounded(BRepPrimAPI_MakeBox(gp_Pnt(margin_mm, margin_mm, cell_mm / 2),
                                                        gp_Pnt(far_mm, far_mm, 2 * cell_mm))
                                        .Shape(),
                                    [](const Bnd_Box& box) { return isBelow(box, cell_mm); });
  const TopoDS_Shape solid = rounded(BRepAlgoAPI_Cut(block, tool).Shape(), [](const Bnd_Box& box) {
    return isInside(box) && !isBelow(box, cell_mm - radius_mm / 2);
  });
  TopoDS_Shell pocket;
  const BRep_Builder builder;
  builder.MakeShell(pocket);
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
    if (isInside(boxOf(faces.Current()))) builder.Add(pocket, faces.Current());
  return pocket;
}

TopoDS_Wire rimOf(const TopoDS_Shape& pocket) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(pocket, TopAbs_EDGE, edges);
  TopTools_ListOfShape rim;
  for (const occ::NonSeamEdge& open : occ::findSeams(pocket).open) rim.Append(edges(open.edge));
  BRepBuilderAPI_MakeWire wire;
  wire.Add(rim);
  return TopoDS::Wire(wire.Wire().Reversed());
}

gp_Trsf moved(int column, int row) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(column * cell_mm, row * cell_mm, 0));
  return move;
}

}  // namespace

TopoDS_Shape makePocketedSheet(int pockets) {
  if (pockets < 1)
    throw std::invalid_argument("pockets is " + std::to_string(pockets) + ": at least 1 is needed");
  const int columns = static_cast<int>(std::ceil(std::sqrt(pockets)));
  const double size_mm = columns * cell_mm;
  const TopoDS_Shape pocket = makePocket();

  BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, cell_mm), gp_Pnt(size_mm, 0, cell_mm),
                                     gp_Pnt(size_mm, size_mm, cell_mm), gp_Pnt(0, size_mm, cell_mm),
                                     true);
  BRepBuilderAPI_MakeFace sheet(gp_Pln(gp_Pnt(0, 0, cell_mm), gp::DZ()), outline);
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  for (int i = 0; i < pockets; ++i) {
    const TopoDS_Shape copy =
        BRepBuilderAPI_Transform(pocket, moved(i % columns, i / columns), true).Shape();
    for (TopExp_Explorer faces(copy, TopAbs_FACE); faces.More(); faces.Next())
      builder.Add(shell, faces.Current());
    sheet.Add(rimOf(copy));
  }
  builder.Add(shell, sheet.Face());
  return shell;
}

}  // namespace seamwright::bench
