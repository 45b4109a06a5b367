// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// The file that a name refers to, with symbolic links resolved, whether it exists or not.
std::filesystem::path withoutLinks(const std::filesystem::path& target);

/// Gives a file its new content at once or not at all. The bytes are written to a file beside it
/// and flushed to the disk; then that file is renamed. Files that killed processes left beside the
/// target are removed.
///
/// \param replace an existing file may be replaced; the new one gets its permissions. Symbolic
/// links stay, and the file that they lead to is replaced.
/// \param check called with the complete file before it is renamed; what it throws is passed on.
/// \throws ModelError (NotAFile, TargetExists, NotWritable), Cancelled; the file beside is removed
/// then.
void replaceFile(const std::filesystem::path& target, std::string_view content, bool replace,
                 const std::function<void(const std::filesystem::path&)>& check,
                 const Progress& progress);

/// Checks the target as replaceFile() does, before the work whose result it is to hold.
/// \throws ModelError if its folder is missing or not writable, or if it exists.
void requireWritable(const std::filesystem::path& target, bool replace);

}  // namespace seamwright::occ
