// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/plugin/report/repair_json.hpp>
#include <string>

namespace seamwright::report {

/// For people: a head with counts and the largest move, then the seams that were to be repaired
/// with their figures before and after; those that were left first, with the reason; then the
/// verdict.
/// \param output nothing where the model was not written; the verdict is on the file too.
std::string toTable(const occ::RepairReport& report,
                    const std::optional<WrittenModel>& output = {});

}  // namespace seamwright::report
