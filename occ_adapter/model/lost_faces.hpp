// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <XSControl_Reader.hxx>

#include <seamwright/occ_adapter/model/model.hpp>

namespace seamwright::occ {

/// Compares the faces that a STEP or IGES file names with those of the shape that was made from it,
/// and adds a note to the model if some are missing.
///
/// STEP names faces as entities and as entries of shells. IGES names them as trimmed and bounded
/// surfaces (types 144 and 143), as faces of solids (510), and as surfaces that no face of the file
/// uses.
/// \param reader has read and transferred the file.
/// \param model has the shape that the reader made.
void noteLostFaces(const XSControl_Reader& reader, Model& model);

}  // namespace seamwright::occ
