// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <map>
#include <set>
#include <utility>

#include <seamwright/occ_adapter/topology/own_parts.hpp>

namespace seamwright::occ {

namespace {

/// Collects what compounds contain, with locations.
void addAssembled(const TopoDS_Shape& shape, TopTools_IndexedMapOfShape& parts) {
  if (shape.ShapeType() != TopAbs_COMPOUND) {
    parts.Add(shape);
    return;
  }
  for (TopoDS_Iterator it(shape); it.More(); it.Next()) addAssembled(it.Value(), parts);
}

class Parting {
 public:
  explicit Parting(std::set<const TopoDS_TShape*> parted) : parted_(std::move(parted)) {}

  TopoDS_Shape own(const TopoDS_Shape& placed) {
    if (done_.IsBound(placed)) return done_.Find(placed).Oriented(placed.Orientation());
    bool is_new = parted_.count(placed.TShape().get()) > 0;
    TopTools_ListOfShape children;
    for (TopoDS_Iterator it(placed, false, true); it.More(); it.Next()) {
      children.Append(own(it.Value()));
      is_new = is_new || !children.Last().IsPartner(it.Value());
    }
    TopoDS_Shape copy = placed.Oriented(TopAbs_FORWARD);
    if (is_new) {
      copy = copy.EmptyCopied();
      for (const TopoDS_Shape& child : children) builder_.Add(copy, child);
      copy.Closed(placed.Closed());
      copy.Convex(placed.Convex());
      copy.Infinite(placed.Infinite());
      copy.Orientable(placed.Orientable());
    }
    done_.Bind(placed, copy);
    return copy.Oriented(placed.Orientation());
  }

 private:
  BRep_Builder builder_;
  /// Parts each occurrence of which becomes a part of its own.
  std::set<const TopoDS_TShape*> parted_;
  TopTools_DataMapOfShapeShape done_;
};

}  // namespace

TopoDS_Shape withOwnParts(const TopoDS_Shape& shape) {
  const std::map<const TopoDS_TShape*, int> instances = instancesIn(shape);
  TopTools_IndexedMapOfShape assembled;
  addAssembled(shape, assembled);
  std::set<const TopoDS_TShape*>
      several;  // parts that occur several times, and only in one part of the assembly
  for (int i = 1; i <= assembled.Extent(); ++i)
    for (const auto& [part, count] : instancesIn(assembled(i)))
      if (count > 1 && count == instances.at(part)) several.insert(part);
  return Parting(std::move(several)).own(shape);
}

TopoDS_Shape ownCopyOf(const TopoDS_Shape& shape) {
  std::set<const TopoDS_TShape*> all;
  for (const auto& [part, count] : instancesIn(shape)) all.insert(part);
  return Parting(std::move(all)).own(shape);
}

std::map<const TopoDS_TShape*, int> instancesIn(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(shape, all);
  std::map<const TopoDS_TShape*, int> instances;
  for (int i = 1; i <= all.Extent(); ++i) ++instances[all(i).TShape().get()];
  return instances;
}

}  // namespace seamwright::occ
