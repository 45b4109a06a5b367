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

void writeFile(const fs::path& file, const std::string& text) {
  if (fs::exists(file) && !fs::is_regular_file(file)) {  // a pipe or a device can't be renamed onto
    std::ofstream out(file, std::ios::binary);
    if (!(out << text << std::flush)) throw std::runtime_error(file.string() + ": can't be written");
    return;
  }
  fs::path beside = file;
  beside += ".part" + std::to_string(getpid());
  std::error_code error;
  {
    std::ofstream out(beside, std::ios::binary);
    if (!(out << text << std::flush)) {
      fs::remove(beside, error);
      throw std::runtime_error(file.string() + ": can't be written (is the disk full?)");
    }
  }
  fs::rename(beside, file, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(beside, error);
    throw std::runtime_error(file.string() + ": can't be written: " + why);
  }
}

void writeStandardOutput(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::runtime_error("standard output can't be written (is the disk full?)");
}

}  // namespace seamwright::cli
