// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepExtrema_SelfIntersection.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Compound.hxx>
#include <array>

#include <seamwright/occ_adapter/fill/self_contact.hpp>

namespace seamwright::occ {

namespace {

constexpr int blocks = 8, cells_of_block = 8, cells = blocks * cells_of_block;

/// The rectangle of a surface, divided into equal cells.
class Grid {
 public:
  explicit Grid(const Handle(Geom_Surface) & surface) : surface_(surface) {
    surface_->Bounds(u_[0], u_[1], v_[0], v_[1]);
  }

  /// The triangles of one block of cells, as a face without a surface.
  TopoDS_Face block(int row, int column) const {
    constexpr int points = cells_of_block + 1;
    const Handle(Poly_Triangulation) triangles = new Poly_Triangulation(
        points * points, 2 * cells_of_block * cells_of_block, /*UVNodes=*/false);
    for (int i = 0; i < points; ++i)
      for (int j = 0; j < points; ++j)
        triangles->SetNode(i * points + j + 1,
                           at(row * cells_of_block + i, column * cells_of_block + j));
    int count = 0;
    for (int i = 0; i < cells_of_block; ++i)
      for (int j = 1; j <= cells_of_block; ++j) {
        const int a = i * points + j, b = a + points;
        triangles->SetTriangle(++count, Poly_Triangle(a, b, b + 1));
        triangles->SetTriangle(++count, Poly_Triangle(a, b + 1, a + 1));
      }
    TopoDS_Face face;
    BRep_Builder().MakeFace(face, triangles);
    return face;
  }

 private:
  gp_Pnt at(int i, int j) const {
    return surface_->Value(u_[0] + i * (u_[1] - u_[0]) / cells,
                           v_[0] + j * (v_[1] - v_[0]) / cells);
  }

  Handle(Geom_Surface) surface_;
  std::array<double, 2> u_{}, v_{};
};

}  // namespace

bool meetThemselves(const std::vector<TopoDS_Face>& faces) {
  // OpenCASCADE compares the triangles of different faces, so each block is a face.
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Face& face : faces) {
    const Grid grid(BRep_Tool::Surface(face));
    for (int row = 0; row < blocks; ++row)
      for (int column = 0; column < blocks; ++column) builder.Add(all, grid.block(row, column));
  }
  BRepExtrema_SelfIntersection contact(all);
  contact.Perform();
  return !contact.OverlapElements().IsEmpty();
}

}  // namespace seamwright::occ
