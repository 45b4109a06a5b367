// SPDX-License-Identifier: LGPL-2.1-or-later
#include <TopExp_Explorer.hxx>
#include <map>
#include <set>

#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/topology/sewable.hpp>

namespace seamwright::occ {

namespace {

/// A solid of several shells has a hollow. Sewing makes one shell of one part, so it can't tell
/// which of the shells a new one replaces.
std::set<int> facesOfHollowSolids(const ShapeParts& parts) {
  std::set<int> numbers;
  for (TopExp_Explorer solid(parts.shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    int shells = 0;
    for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next()) ++shells;
    if (shells < 2) continue;
    for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next())
      numbers.insert(parts.faces.FindIndex(face.Current()));
  }
  return numbers;
}

std::map<const TopoDS_TShape*, int> countByFace(const ShapeParts& parts) {
  std::map<const TopoDS_TShape*, int> instances;
  for (int f = 1; f <= parts.faces.Extent(); ++f) ++instances[parts.faces(f).TShape().get()];
  return instances;
}

/// An edge stores its pcurves by surface, so a common edge of two faces on one surface would have
/// only one.
bool haveCommonSurface(const Seam& seam) {
  if (seam.sides[0].face == seam.sides[1].face) return false;
  const PlacedSurface a = surfaceOf(seam.sides[0].shape), b = surfaceOf(seam.sides[1].shape);
  return a.surface == b.surface && a.location == b.location;
}

}  // namespace

std::string numberedFace(int number) {
  return "face " + std::to_string(number);
}

SewReasons notSewable(const ShapeParts& parts, const std::vector<Seam>& seams,
                      const std::vector<std::size_t>& chosen, const FaceNames& names) {
  const std::map<const TopoDS_TShape*, int> instances = countByFace(parts);
  const std::set<int> in_hollow = facesOfHollowSolids(parts);
  SewReasons refused;
  for (const std::size_t i : chosen) {
    const auto& sides = seams[i].sides;
    for (const Coedge& side : sides) {
      const int count = instances.at(side.shape.TShape().get());
      if (count > 1)
        refused.emplace(i, why_not_sewn::faceInstances(side.face, names(side.face), count));
      else if (in_hollow.count(side.face) > 0)
        refused.emplace(i, why_not_sewn::hollowSolid(side.face, names(side.face)));
    }
    if (haveCommonSurface(seams[i]))
      refused.emplace(i, why_not_sewn::commonSurface(sides[0].face, names(sides[0].face),
                                                     sides[1].face, names(sides[1].face)));
  }
  return refused;
}

}  // namespace seamwright::occ
