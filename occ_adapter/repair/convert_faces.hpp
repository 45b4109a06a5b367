// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include <seamwright/occ_adapter/repair/repair.hpp>

/// Converts analytic faces to splines so that they may move. Not a public header.
namespace seamwright::occ {

/// A repair that converts nothing.
using PlainRepair =
    std::function<RepairReport(const Model&, const RepairOptions&, const Progress&)>;

/// Repairs a model after converting some of its analytic faces. First it converts one face beside
/// each seam that has no movable face. Then it adds the faces beside seams that were not repaired.
/// In the end only those faces stay converted that moved. A face beside a seam that got worse is
/// not converted.
/// \throws what \p repair throws.
RepairReport repairConverting(const Model& model, const RepairOptions& options,
                              const PlainRepair& repair, const Progress& progress);

}  // namespace seamwright::occ
