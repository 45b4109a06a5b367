// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <functional>
#include <string>

#include <seamwright/occ_adapter/model/read.hpp>

/// Model files written for the tests by OpenCASCADE.
namespace seamwright::test {

/// A folder of its own for one test, gone with it.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Sets an environment variable while it lives.
class Environment {
 public:
  Environment(const char* name, const std::string& value);
  ~Environment();
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
};

void writeStep(const TopoDS_Shape& shape, const std::filesystem::path& path,
               const char* unit = "MM");
/// \param mode 0: trimmed surfaces; 1: solids and shells keep their topology
void writeIges(const TopoDS_Shape& shape, const std::filesystem::path& path,
               const char* unit = "MM", int mode = 1);
void writeBrep(const TopoDS_Shape& shape, const std::filesystem::path& path);
void writeBinaryBrep(const TopoDS_Shape& shape, const std::filesystem::path& path);

std::string contentOf(const std::filesystem::path& path);
void setContent(const std::filesystem::path& path, const std::string& content);
/// The text with the first \p old replaced; throws if there is none.
std::string replaced(std::string text, const std::string& old, const std::string& by);

/// The error readModel() ends with; throws if it reads the file.
occ::ModelError errorOf(const std::filesystem::path& path);

/// A model of OpenCASCADE's, as "step/screw.step". Throws if it is not installed: Debian's package
/// occt-misc has it, which `tools/debian-packages --install picture` installs.
std::filesystem::path occtModel(const std::string& name);

/// Runs the task as a user whom permissions of files bind. The superuser's runs in a thread without
/// the capabilities that override them; processes that it starts have none either.
void boundByPermissions(const std::function<void()>& task);

}  // namespace seamwright::test
