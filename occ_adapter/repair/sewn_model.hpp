// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

struct SewModelOptions {
  /// Positive. Free edges at most this far apart become one edge; the gap has to be certain.
  double sew_mm = 0;
  int jobs = 0;  ///< threads; 0: one for each processor
};

/// The model with its matched seams sewn, as repair() sews them: surfaces stay, sewing is proven,
/// and faces that are connected become one shell, a closed one a solid. Names, colours and layers
/// follow their parts. A seam that is left is named in the notes, with the reason; without any
/// matched seam the model is the given one.
/// \throws std::invalid_argument for bad options, with the number; Cancelled.
Model sewnModel(const Model& model, const SewModelOptions& options, const Progress& progress = {});

}  // namespace seamwright::occ
