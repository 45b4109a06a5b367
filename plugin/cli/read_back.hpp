// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <seamwright/plugin/report/written.hpp>
#include <string>

namespace seamwright::cli {

/// report::readBack() under a progress bar.
report::WrittenModel readBack(const std::filesystem::path& waiting, const std::string& output,
                              const report::Judge& judge);

}  // namespace seamwright::cli
