// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/repair/repair.hpp>
#include <string>

namespace seamwright::report {

/// For people: a head with counts and the largest move, then the seams that were to be repaired with their figures before and
/// after; those that were left first, with the reason.
std::string toTable(const occ::RepairReport& report);

}  // namespace seamwright::report
