// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace seamwright::occ {

enum class Format { Step, Iges, BrepText, BrepBinary };

/// "STEP", "IGES", "BREP", "binary BREP".
std::string_view name(Format format);

/// Detects the format of a model file from its content; the name of the file does not matter.
///
/// \throws ModelError if the file is missing, is a folder, can't be opened, is empty, is text of
/// another kind (UTF-16, an archive and a Git LFS pointer are recognised and named), or is a STEP
/// or IGES file without its closing record.
Format detectFormat(const std::filesystem::path& path);

}  // namespace seamwright::occ
