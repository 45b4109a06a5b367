// SPDX-License-Identifier: LGPL-2.1-or-later
#include "files.hpp"

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <BRepTools.hxx>
#include <BinTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <array>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <seamwright/occ_adapter/occt_version.hpp>

namespace seamwright::test {

namespace fs = std::filesystem;

namespace {

/// Of the calling thread alone: capabilities belong to threads.
void dropOverride() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  bool dropped = syscall(SYS_capget, &header, sets.data()) == 0;
  for (const int capability : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH}) {
    // Else programs that the superuser starts get it back.
    dropped = dropped && prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) == 0;
    const __u32 others = ~CAP_TO_MASK(capability);
    auto& set = sets[CAP_TO_INDEX(capability)];
    set = {set.effective & others, set.permitted & others, set.inheritable & others};
  }
  if (!dropped || syscall(SYS_capset, &header, sets.data()) != 0)
    throw std::runtime_error("the superuser's capabilities can't be dropped");
}

}  // namespace

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "seamwright-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

Environment::Environment(const char* name, const std::string& value) : name_(name) {
  setenv(name, value.c_str(), 1);
}

Environment::~Environment() {
  unsetenv(name_);
}

void writeStep(const TopoDS_Shape& shape, const fs::path& path, const char* unit) {
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit);  // taken note of when the writer is made
  STEPControl_Writer writer;
  occ::keepLengthUnit(writer);
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone ||
      writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("STEP was not written");
}

void writeIges(const TopoDS_Shape& shape, const fs::path& path, const char* unit, int mode) {
  IGESControl_Controller::Init();
  IGESControl_Writer writer(unit, mode);
  writer.AddShape(shape);
  writer.ComputeModel();
  if (!writer.Write(path.c_str())) throw std::runtime_error("IGES was not written");
}

void writeBrep(const TopoDS_Shape& shape, const fs::path& path) {
  if (!BRepTools::Write(shape, path.c_str())) throw std::runtime_error("BREP was not written");
}

void writeBinaryBrep(const TopoDS_Shape& shape, const fs::path& path) {
  if (!BinTools::Write(shape, path.c_str()))
    throw std::runtime_error("binary BREP was not written");
}

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

void setContent(const fs::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::runtime_error("there is no '" + old + "' to replace");
  return text.replace(at, old.size(), by);
}

occ::ModelError errorOf(const fs::path& path) {
  try {
    occ::readModel(path);
  } catch (const occ::ModelError& error) {
    return error;
  }
  throw std::runtime_error(path.string() + " was read");
}

fs::path occtModel(const std::string& name) {
  const fs::path path = fs::path("/usr/share/opencascade/data") / name;
  if (!fs::exists(path))
    throw std::runtime_error(path.string() + " is missing: install Debian's package occt-misc");
  return path;
}

void boundByPermissions(const std::function<void()>& task) {
  if (geteuid() != 0) return task();
  std::exception_ptr error;
  std::thread([&] {
    try {
      dropOverride();
      task();
    } catch (...) {
      error = std::current_exception();
    }
  }).join();
  if (error) std::rethrow_exception(error);
}

}  // namespace seamwright::test
