// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>

namespace seamwright::report {

/// The line of column names, with a newline at the end.
std::string csvHeader();

/// One line per seam (RFC 4180 quoting, decimal point, empty field for a figure without value).
std::string csvRows(const occ::Report& report);

}  // namespace seamwright::report
