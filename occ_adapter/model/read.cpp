// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chrono>

#include <seamwright/occ_adapter/model/format.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/reader.hpp>

namespace seamwright::occ {

Model readModel(const std::filesystem::path& path, const Progress& progress, Needed needed) {
  const auto start = std::chrono::steady_clock::now();
  const Format format = detectFormat(path);
  Answer answer = askReader({.model = path,
                             .bytes = std::filesystem::file_size(path),
                             .deed = "read",
                             .arguments = {needed == Needed::Edges ? "read-edges" : "read",
                                           std::string(name(format)), path.string()}},
                            progress);
  if (!answer.shape)
    throw ModelError(ModelErrc::ReaderDied, path,
                     "can't be read: the reading process answered with no shape");
  answer.model.shape = decodeShape(std::move(*answer.shape), path);
  answer.model.path = path.string();
  answer.model.read_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(answer.model);
}

}  // namespace seamwright::occ
