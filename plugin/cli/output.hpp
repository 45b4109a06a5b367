// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>

namespace seamwright::cli {

/// \throws std::runtime_error, in one line, if a file can't be made there: missing folder, a folder of that name, no rights.
void requireWritable(const std::filesystem::path& file);

/// Writes beside the file and renames, so that it is whole or untouched. \throws std::runtime_error
void writeFile(const std::filesystem::path& file, const std::string& text);

/// \throws std::runtime_error if standard output takes not all of it (a full disk).
void writeStandardOutput(const std::string& text);

}  // namespace seamwright::cli
