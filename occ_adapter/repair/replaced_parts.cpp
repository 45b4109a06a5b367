// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <TopoDS_Iterator.hxx>
#include <vector>

#include <seamwright/occ_adapter/repair/changed_geometry.hpp>
#include <seamwright/occ_adapter/repair/replaced_parts.hpp>

namespace seamwright::occ {

namespace {

/// Walks through a shape. Each part is replaced once, so that instances stay instances.
class PartReplacer {
 public:
  explicit PartReplacer(const TopTools_DataMapOfShapeShape& new_parts) : new_parts_(new_parts) {}

  /// The part itself, or a copy if any of its parts is new.
  TopoDS_Shape replaced(const TopoDS_Shape& part) {
    if (done_.IsBound(part)) return done_.Find(part);
    std::vector<TopoDS_Shape> children;
    const bool is_new = new_parts_.IsBound(part);
    bool any_new = is_new;
    for (TopoDS_Iterator it(part, false, false); it.More(); it.Next()) {
      TopoDS_Shape child = replaced(bare(it.Value()));
      any_new = any_new || !child.IsPartner(it.Value());
      child.Location(it.Value().Location(), false);
      children.push_back(child.Oriented(it.Value().Orientation()));
    }
    TopoDS_Shape copy = part;
    if (any_new) {
      const BRep_Builder builder;
      copy = is_new ? new_parts_.Find(part) : part.EmptyCopied();
      for (const TopoDS_Shape& child : children) builder.Add(copy, child);
      copy.Closed(part.Closed());
      copy.Convex(part.Convex());
      copy.Infinite(part.Infinite());
      copy.Orientable(part.Orientable());
    }
    done_.Bind(part, copy);
    return copy;
  }

 private:
  const TopTools_DataMapOfShapeShape& new_parts_;
  TopTools_DataMapOfShapeShape done_;
};

}  // namespace

TopoDS_Shape withReplacedParts(const TopoDS_Shape& shape,
                               const TopTools_DataMapOfShapeShape& new_parts) {
  TopoDS_Shape replaced = PartReplacer(new_parts).replaced(bare(shape));
  replaced.Location(shape.Location(), false);
  return replaced.Oriented(shape.Orientation());
}

}  // namespace seamwright::occ
