// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBndLib.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <vector>

#include <seamwright/occ_adapter/fill/clearance.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

namespace {

bool shareVertex(const TopTools_IndexedMapOfShape& some, const TopTools_IndexedMapOfShape& others) {
  for (int k = 1; k <= others.Extent(); ++k)
    if (some.Contains(others(k))) return true;
  return false;
}

/// Close around the face, which takes a while.
Bnd_Box tightBox(const TopoDS_Shape& face) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(face, box, false, false);
  return box;
}

}  // namespace

std::optional<std::pair<int, int>> touchingFaces(const TopoDS_Shape& shape, const std::set<int>& fresh) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  std::vector<Bnd_Box> boxes(static_cast<std::size_t>(faces.Extent()) + 1);
  for (int f = 1; f <= faces.Extent(); ++f) BRepBndLib::Add(faces(f), boxes[f], false);
  for (const int a : fresh) {
    const TopTools_IndexedMapOfShape vertices = partsOf(faces(a), TopAbs_VERTEX);
    for (int b = 1; b <= faces.Extent(); ++b) {
      if (b == a || (b < a && fresh.count(b) > 0) || boxes[a].IsOut(boxes[b]) ||
          shareVertex(vertices, partsOf(faces(b), TopAbs_VERTEX)) ||
          tightBox(faces(a)).IsOut(tightBox(faces(b))))
        continue;
      const BRepExtrema_DistShapeShape distance(faces(a), faces(b));
      if (distance.IsDone() && distance.Value() <= Precision::Confusion()) return std::pair{a, b};
    }
  }
  return std::nullopt;
}

}  // namespace seamwright::occ
