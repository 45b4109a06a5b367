// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

/// Names for fills of models that are parts or stages of the given model. Not a public header.
namespace seamwright::occ {

/// Maps numbers of parts of a reduced model to those in the whole model.
class Numbers {
 public:
  Numbers(const TopoDS_Shape& whole, const TopoDS_Shape& rest, TopAbs_ShapeEnum kind)
      : whole_(partsOf(whole, kind)), rest_(partsOf(rest, kind)) {}

  int given(int number) const { return whole_.FindIndex(rest_(number)); }

 private:
  TopTools_IndexedMapOfShape whole_, rest_;
};

/// The model with the shape withOwnParts(). All numbers stay.
Model modelOfOwnParts(Model model);

/// The hole, found in another model with the same numbers, in terms of \p model.
Hole holeIn(const Model& model, Hole hole);

/// Why a fill can't meet the face that stays at an edge of the hole's boundary; empty if it can.
FillReason whyNotMet(const UnusableParts& unusable, int edge, int face);

/// As fillHole(). \param names names of the model's faces.
FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options,
                        const FaceNames& names, const Progress& progress);

}  // namespace seamwright::occ
