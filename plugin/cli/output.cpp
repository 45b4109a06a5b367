// SPDX-License-Identifier: LGPL-2.1-or-later
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <seamwright/plugin/cli/output.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace fs = std::filesystem;

void requireWritable(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw std::runtime_error(file.string() + ": the folder " + folder.string() +
                             " does not exist; make it first");
  if (fs::is_directory(file, error)) throw std::runtime_error(file.string() + ": is a folder, name a file");
  if (access(folder.c_str(), W_OK) != 0)
    throw std::runtime_error(file.string() + ": no right to write in " + folder.string());
}

PendingFile::PendingFile(fs::path file, std::string text) : file_(std::move(file)), text_(std::move(text)) {
  if (fs::exists(file_) && !fs::is_regular_file(file_)) return;  // a pipe or a device can't be renamed onto
  beside_ = file_;
  beside_ += ".part" + std::to_string(getpid());
  std::ofstream out(beside_, std::ios::binary);
  if (out << text_ << std::flush) return;
  std::error_code error;
  fs::remove(beside_, error);
  throw std::runtime_error(file_.string() + ": can't be written (is the disk full?)");
}

PendingFile::~PendingFile() {
  std::error_code error;
  if (!beside_.empty()) fs::remove(beside_, error);
}

void PendingFile::takePlace() {
  if (beside_.empty()) {
    std::ofstream out(file_, std::ios::binary);
    if (!(out << text_ << std::flush)) throw std::runtime_error(file_.string() + ": can't be written");
    return;
  }
  std::error_code error;
  fs::rename(beside_, file_, error);
  if (error) throw std::runtime_error(file_.string() + ": can't be written: " + error.message());
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
