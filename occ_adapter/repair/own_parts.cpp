// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <map>
#include <set>

#include <seamwright/occ_adapter/repair/own_parts.hpp>

namespace seamwright::occ {

namespace {

/// How many of the shapes, each in one place, are instances of the same.
std::map<const TopoDS_TShape*, int> instancesOf(const TopTools_IndexedMapOfShape& shapes) {
  std::map<const TopoDS_TShape*, int> instances;
  for (int i = 1; i <= shapes.Extent(); ++i) ++instances[shapes(i).TShape().get()];
  return instances;
}

void addAssembled(const TopoDS_Shape& shape, TopTools_IndexedMapOfShape& parts) {
  if (shape.ShapeType() != TopAbs_COMPOUND) {
    parts.Add(shape);
    return;
  }
  for (TopoDS_Iterator it(shape); it.More(); it.Next()) addAssembled(it.Value(), parts);
}

class Parting {
 public:
  explicit Parting(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape all, assembled;
    TopExp::MapShapes(shape, all);
    instances_ = instancesOf(all);
    addAssembled(shape, assembled);
    const std::map<const TopoDS_TShape*, int> parts = instancesOf(assembled);
    for (int i = 1; i <= assembled.Extent(); ++i)
      if (parts.at(assembled(i).TShape().get()) > 1) keep(assembled(i));
  }

  TopoDS_Shape own(const TopoDS_Shape& placed) {
    if (kept_.count(placed.TShape().get()) > 0) return placed;
    if (done_.IsBound(placed)) return done_.Find(placed).Oriented(placed.Orientation());
    bool is_new = placed.ShapeType() >= TopAbs_FACE && instances_.at(placed.TShape().get()) > 1;
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
  void keep(const TopoDS_Shape& part) {
    TopTools_IndexedMapOfShape within;
    TopExp::MapShapes(part, within);
    for (int i = 1; i <= within.Extent(); ++i) kept_.insert(within(i).TShape().get());
  }

  BRep_Builder builder_;
  std::map<const TopoDS_TShape*, int> instances_;
  std::set<const TopoDS_TShape*> kept_;
  TopTools_DataMapOfShapeShape done_;
};

}  // namespace

TopoDS_Shape withOwnParts(const TopoDS_Shape& shape) {
  return Parting(shape).own(shape);
}

}  // namespace seamwright::occ
