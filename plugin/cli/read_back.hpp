// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <string>

namespace seamwright::cli {

/// What is counted in the model of a file.
using Judge = std::function<report::ModelCounts(const occ::Model&, const occ::Progress&)>;

/// Reads a new file back, which waits beside its place \p output, and judges it.
/// \throws occ::ModelError where it can't be read back: it is not to take its place then.
report::WrittenModel readBack(const std::filesystem::path& waiting, const std::string& output,
                              const Judge& judge);

}  // namespace seamwright::cli
