// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// What the reading program said, put together. Which parts there are depends on what it was asked.
struct Answer {
  Model model;  ///< without its shape
  std::optional<std::string> shape;
  std::optional<std::string> file;
  WriteReport report;
};

/// A question to the reading program, see reader_main.cpp.
struct Question {
  std::filesystem::path model;  ///< the file that errors speak of
  std::uintmax_t bytes = 0;     ///< size of all files that the program is given
  std::string deed;             ///< what can't be done where the program fails: "read", "written"
  std::vector<std::string> arguments;  ///< of the program
  int input = -1;                      ///< descriptor of its standard input; -1: none
};

/// Runs the reading program until it ends.
/// \throws ModelError where it says so, dies, answers with no sense or does not end in time
/// (readerBounds); std::invalid_argument from readerBounds; Cancelled.
Answer askReader(const Question& question, const Progress& progress);

/// The shape that the reading program sent. \throws ModelError, about the file \p path
TopoDS_Shape decodeShape(std::string bytes, const std::filesystem::path& path);

}  // namespace seamwright::occ
