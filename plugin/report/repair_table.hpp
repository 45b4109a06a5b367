// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/plugin/report/repair_json.hpp>
#include <string>

namespace seamwright::report {

/// The result as text: a head with counts and the largest move, then the seams that were to be
/// repaired with their figures before and after, then the verdict. Unrepaired seams come first,
/// with the reason.
/// \param output nothing if the model was not written; otherwise the verdict includes the file.
std::string toTable(const occ::RepairReport& report,
                    const std::optional<WrittenModel>& output = {});

}  // namespace seamwright::report
