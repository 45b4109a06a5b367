// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Reads a STEP, IGES or BREP file, told by its content, with names, colours and units.
///
/// OpenCASCADE reads in a process of its own (the program seamwright-read-occtX.Y beside this library, in libexec (also that of the prefix it was installed to), or named by the environment variable SEAMWRIGHT_READER), because a bad file may crash it or
/// overwrite its memory. That process may use 120 s of processor time plus 60 s for each MB of the file;
/// Progress can stop it at any time.
///
/// Faces that the file names and OpenCASCADE could not make are counted in Model::notes.
/// \throws ModelError (its code says which kind), Cancelled.
Model readModel(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace seamwright::occ
