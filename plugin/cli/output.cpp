// SPDX-License-Identifier: LGPL-2.1-or-later
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <seamwright/occ_adapter/model/target_file.hpp>
#include <seamwright/occ_adapter/model/unfinished_files.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <stdexcept>
#include <utility>

namespace seamwright::cli {

namespace fs = std::filesystem;

namespace {

/// Whether the path is the target of standard output, also under its name or as /dev/stdout.
bool isStandardOutput(const fs::path& file) {
  struct stat named {
  }, open{};
  return ::stat(file.c_str(), &named) == 0 && ::fstat(STDOUT_FILENO, &open) == 0 &&
         named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

/// Whether the path is a pipe or a device, which no file can replace.
bool isWrittenStraight(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return isStandardOutput(file) ||
         (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

}  // namespace

void requireWritable(const fs::path& named) {
  if (isWrittenStraight(named)) {
    if (access(named.c_str(), W_OK) != 0)
      throw std::runtime_error(named.string() + ": no permission to write to it");
    return;
  }
  const fs::path file = occ::withoutLinks(named);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw std::runtime_error(file.string() + ": the folder " + folder.string() + " does not exist");
  if (fs::is_directory(file, error))
    throw std::runtime_error(file.string() + ": is a folder; name a file");
  if (access(folder.c_str(), W_OK) != 0)
    throw std::runtime_error(file.string() + ": no permission to write in " + folder.string());
}

PendingFile::PendingFile(const fs::path& file, std::string text)
    : file_(file), text_(std::move(text)) {
  if (isWrittenStraight(file)) return;
  file_ = occ::withoutLinks(file);
  beside_ = file_;
  beside_ += ".part" + std::to_string(getpid());
  std::ofstream out;
  {
    const occ::UnfinishedFiles files = occ::unfinishedFiles();
    out.open(beside_, std::ios::binary);
    files.paths.insert(beside_);
  }
  if (out << text_ << std::flush) return;
  removeBeside();
  throw std::runtime_error(file_.string() + ": can't be written (is the disk full?)");
}

PendingFile::~PendingFile() {
  if (!beside_.empty()) removeBeside();
}

void PendingFile::removeBeside() {
  const occ::UnfinishedFiles files = occ::unfinishedFiles();
  std::error_code error;
  fs::remove(beside_, error);
  files.paths.erase(beside_);
}

void PendingFile::writeStraight() {
  if (beside_.empty()) takePlace();
}

void PendingFile::takePlace() {
  if (std::exchange(done_, true)) return;
  if (isStandardOutput(file_)) return writeStandardOutput(text_);
  if (beside_.empty()) {
    std::ofstream out(file_, std::ios::binary);
    if (!(out << text_ << std::flush))
      throw std::runtime_error(file_.string() + ": can't be written");
    return;
  }
  const occ::UnfinishedFiles files = occ::unfinishedFiles();
  std::error_code error;
  fs::rename(beside_, file_, error);
  if (error) throw std::runtime_error(file_.string() + ": can't be written: " + error.message());
  files.some_finished = true;
  files.paths.erase(beside_);
  beside_.clear();
}

void writeFile(const fs::path& file, const std::string& text) {
  PendingFile(file, text).takePlace();
}

void writeStandardOutput(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::runtime_error("standard output can't be written (is the disk full?)");
}

}  // namespace seamwright::cli
