// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Reads a STEP, IGES or BREP file, told by its content, with names, colours and units.
///
/// OpenCASCADE reads in a process of its own (the program seamwright-read-occtX.Y beside this
/// library, in libexec (also that of the prefix it was installed to), or named by the environment
/// variable SEAMWRIGHT_READER), because a bad file may crash it or overwrite its memory. That
/// process may take 60 s and 30 s for each MB of the file, and 4 GB of memory and 50 times the size
/// of the file, but not more than three quarters of the memory that is available; the environment
/// variables SEAMWRIGHT_READER_SECONDS and SEAMWRIGHT_READER_MEMORY_MB set other bounds. It ends
/// with the thread that called, however that ends. Progress can stop it at any time; the time that
/// progress takes does not count.
///
/// Faces that the file names and OpenCASCADE could not make are counted in Model::notes, and so are
/// faces and edges with numbers that can't be computed with: not finite, or 1e100 and more.
/// \throws ModelError (its code says which kind; Malformed also where no face has finite numbers),
/// Cancelled, std::invalid_argument if one of the environment variables is no positive number.
Model readModel(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace seamwright::occ
