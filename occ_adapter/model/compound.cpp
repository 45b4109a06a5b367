// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>

#include <seamwright/occ_adapter/model/compound.hpp>

namespace seamwright::occ {

TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& parts) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& part : parts) builder.Add(compound, part);
  return compound;
}

}  // namespace seamwright::occ
