// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools_ShapeSet.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <istream>
#include <ostream>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  if (!shape.IsNull()) TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

}  // namespace

int Model::faceCount() const {
  return count(shape, TopAbs_FACE);
}

int Model::edgeCount() const {
  return count(shape, TopAbs_EDGE);
}

Model modelFromShape(const TopoDS_Shape& shape) {
  if (shape.IsNull()) throw ModelError(ModelErrc::NoShapes, {}, "is a null shape");
  if (!TopExp_Explorer(shape, TopAbs_FACE).More())
    throw ModelError(ModelErrc::NoShapes, {}, "has no faces, so it has no seams");
  Model model;
  model.shape = shape;
  model.format = "memory";
  model.length_unit = "mm (assumed)";
  noteUnusableParts(model);
  return model;
}

// FreeCAD's binary format is a shape set followed by the index of the shape, the index of its
// location and its orientation.
void writeBinaryShape(const TopoDS_Shape& shape, std::ostream& stream) {
  BinTools_ShapeSet set;
  set.SetFormatNb(3);
  const int index = set.Add(shape);
  const int location = set.Locations().Index(shape.Location());
  set.Write(stream);
  BinTools::PutInteger(stream, index);
  BinTools::PutInteger(stream, location);
  BinTools::PutInteger(stream, static_cast<int>(shape.Orientation()));
}

TopoDS_Shape readBinaryShape(std::istream& stream) {
  BinTools_ShapeSet set;
  set.Read(stream);
  int index = 0;
  int location = 0;
  int orientation = 0;
  BinTools::GetInteger(stream, index);
  BinTools::GetInteger(stream, location);
  BinTools::GetInteger(stream, orientation);
  if (!stream || index < 1 || index > set.NbShapes()) return {};
  TopoDS_Shape shape = set.Shape(index);
  shape.Location(set.Locations().Location(location));
  shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
  return shape;
}

void writeTextShape(const TopoDS_Shape& shape, std::ostream& stream) {
  BRepTools_ShapeSet set(false);
  set.SetFormatNb(1);
  set.Add(shape);
  set.Write(stream);
  set.Write(shape, stream);
}

TopoDS_Shape readTextShape(std::istream& stream) {
  BRepTools_ShapeSet set(BRep_Builder{});
  set.Read(stream);
  TopoDS_Shape shape;
  if (set.NbShapes() > 0) set.Read(shape, stream);
  return shape;
}

}  // namespace seamwright::occ
