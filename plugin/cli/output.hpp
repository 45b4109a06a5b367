// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>

namespace seamwright::cli {

/// \throws std::runtime_error, in one line, if a file cannot be made there: missing folder, a
/// folder of that name, no permission.
void requireWritable(const std::filesystem::path& file);

/// A text in a temporary file beside its target, already on the disk. The destructor removes the
/// temporary file unless it replaced the target. A target that is not a regular file, such as a
/// pipe or a device, and the target of standard output are written to instead of replaced. Symbolic
/// links stay.
class PendingFile {
 public:
  /// \throws std::runtime_error
  PendingFile(const std::filesystem::path& file, std::string text);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  /// Does nothing a second time. \throws std::runtime_error; the file then stays as it was.
  void takePlace();
  /// A pipe, a device or standard output is written to now, since it may not take the text; a file
  /// waits for takePlace(). \throws std::runtime_error
  void writeStraight();

 private:
  void removeBeside();

  std::filesystem::path file_;
  std::filesystem::path beside_;  ///< the temporary file; empty: none
  std::string text_;
  bool done_ = false;
};

/// Writes a temporary file beside the target and renames it, so that the target is complete or
/// unchanged. \throws std::runtime_error
void writeFile(const std::filesystem::path& file, const std::string& text);

/// \throws std::runtime_error if standard output does not accept the whole text (a full disk).
void writeStandardOutput(const std::string& text);

}  // namespace seamwright::cli
