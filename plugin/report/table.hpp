// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>

namespace seamwright::report {

/// The report as text: a head with the verdict, then every seam, defects first and the worst of
/// each class first.
std::string toTable(const occ::Report& report);

}  // namespace seamwright::report
