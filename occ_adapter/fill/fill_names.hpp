// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

/// Fills of models that are parts or stages of what the user gave; not a public header.
namespace seamwright::occ {

/// What the parts of the rest of a model are called in the whole.
class Numbers {
 public:
  Numbers(const TopoDS_Shape& whole, const TopoDS_Shape& rest, TopAbs_ShapeEnum kind)
      : whole_(partsOf(whole, kind)), rest_(partsOf(rest, kind)) {}

  int given(int number) const { return whole_.FindIndex(rest_(number)); }

 private:
  TopTools_IndexedMapOfShape whole_, rest_;
};

/// As withOwnParts(): all numbers stay.
Model modelOfOwnParts(Model model);

/// A hole of another model with the same numbers.
Hole holeIn(const Model& model, Hole hole);

/// Why a hole can't be met at an edge of its border, with a face beside it that stays; empty if it
/// can.
std::string whyNotMet(const UnusableParts& unusable, int edge, int face);

/// As fillHole(); \param names of the model's faces.
FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options,
                        const FaceNames& names, const Progress& progress);

}  // namespace seamwright::occ
