// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>

namespace seamwright::cli {

/// \throws std::runtime_error, in one line, if a file can't be made there: missing folder, a folder
/// of that name, no rights.
void requireWritable(const std::filesystem::path& file);

/// A text that waits beside its place, on the disk already; gone with the object unless it took
/// that place. What is no regular file, as a pipe or a device, and what standard output goes to is
/// written to when the text takes its place; symbolic links stay.
class PendingFile {
 public:
  /// \throws std::runtime_error
  PendingFile(const std::filesystem::path& file, std::string text);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  /// \throws std::runtime_error; the file is then what it was.
  void takePlace();

 private:
  std::filesystem::path file_;
  std::filesystem::path beside_;  ///< empty: nothing waits there
  std::string text_;
};

/// Writes beside the file and renames, so that it is whole or untouched. \throws std::runtime_error
void writeFile(const std::filesystem::path& file, const std::string& text);

/// \throws std::runtime_error if standard output takes not all of it (a full disk).
void writeStandardOutput(const std::string& text);

}  // namespace seamwright::cli
