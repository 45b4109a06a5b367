// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include <seamwright/occ_adapter/model/write.hpp>

namespace seamwright::occ {

/// The bytes of a written file and the report on it.
struct Stored {
  std::string bytes;
  WriteReport report;
};

/// Writes a model as STEP or IGES in this process, see writeModel(); only the reading program calls
/// it.
/// \param options only those of the content count: afresh, share_of_accuracy.
/// \throws ModelError, Standard_Failure
Stored storeModel(const Model& model, Format target, const WriteOptions& options,
                  const Progress& progress);

}  // namespace seamwright::occ
