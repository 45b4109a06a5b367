// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// The file that a name stands for, through symbolic links, whether it is there or not.
std::filesystem::path withoutLinks(const std::filesystem::path& target);

/// Gives a file its content at once or not at all: the bytes go to a file beside it, to the disk,
/// and take its place. What processes that were killed left beside it for that is taken away.
///
/// \param replace a file that is there may be replaced; it hands its permissions on. Symbolic links
/// stay and are written through.
/// \param check called with the file beside when it is whole; what it throws is passed on.
/// \throws ModelError (NotAFile, TargetExists, NotWritable), Cancelled; the file beside is gone
/// then.
void replaceFile(const std::filesystem::path& target, std::string_view content, bool replace,
                 const std::function<void(const std::filesystem::path&)>& check,
                 const Progress& progress);

/// Throws now what replaceFile() could only say after the work: a folder that is missing or closed,
/// a target that is there.
void requireWritable(const std::filesystem::path& target, bool replace);

}  // namespace seamwright::occ
