// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Reads a model file in this process; only the reading program calls it.
/// \param format "STEP", "IGES", "BREP" or "binary BREP", as detectFormat() told.
/// \throws ModelError, Standard_Failure
Model loadModel(const std::filesystem::path& path, const std::string& format, const Progress& progress);

}  // namespace seamwright::occ
