// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>

namespace seamwright::report {

/// The line of column names, ended by a newline.
std::string csvHeader();

/// One line a seam (RFC 4180 quoting, decimal point, empty field for a figure without value).
std::string csvRows(const occ::Report& report);

}  // namespace seamwright::report
