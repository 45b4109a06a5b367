// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include <seamwright/occ_adapter/repair/repair.hpp>

/// Analytic faces that become splines so that they may move; not a public header.
namespace seamwright::occ {

/// A repair that converts nothing.
using PlainRepair =
    std::function<RepairReport(const Model&, const RepairOptions&, const Progress&)>;

/// Repairs a model some of whose analytic faces are converted: at first one face beside each seam
/// that has none that may move; then those beside seams that were not repaired; and at last those
/// alone that moved. A face beside a seam that got worse is not converted.
/// \throws what \p repair throws.
RepairReport repairConverting(const Model& model, const RepairOptions& options,
                              const PlainRepair& repair, const Progress& progress);

}  // namespace seamwright::occ
