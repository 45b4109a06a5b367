// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// What a model needs to be of use.
enum class Needed {
  Faces,  ///< faces, whose seams are measured
  Edges   ///< edges are enough: a file of curves
};

/// Reads a STEP, IGES or BREP file, with names, colours and units. The content decides the format.
///
///     const Model model = readModel("part.step");
///     for (const std::string& note : model.notes) warn(note);
///
/// OpenCASCADE reads in a process of its own, because a damaged file may crash it or overwrite its
/// memory. This is the program seamwright-read-occtX.Y in libexec beside this library or in its
/// prefix, or the one that the environment variable SEAMWRIGHT_READER names. Its time and memory
/// are limited (ReaderBounds); the time that progress takes does not count. The process ends with
/// the thread that called, even if that is killed. Progress can stop it at any time.
///
/// Faces that the file names and OpenCASCADE could not make are counted in Model::notes, and so are
/// faces and edges that can't be computed with: numbers that are not finite, or 1e100 and more.
/// \throws ModelError (its code says which kind; Malformed also if no face has finite numbers);
/// Cancelled; std::invalid_argument if an environment variable of the limits is not a positive
/// number.
Model readModel(const std::filesystem::path& path, const Progress& progress = {},
                Needed needed = Needed::Faces);

}  // namespace seamwright::occ
