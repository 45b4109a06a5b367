// SPDX-License-Identifier: LGPL-2.1-or-later
#include "files.hpp"

#include <unistd.h>

#include <BRepTools.hxx>
#include <BinTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <seamwright/occ_adapter/occt_version.hpp>

namespace seamwright::test {

namespace fs = std::filesystem;

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

fs::path furtherModel(const std::string& name) {
  const fs::path path = fs::path(SEAMWRIGHT_TEST_MODELS) / name;
  return fs::exists(path) ? path : fs::path();
}

}  // namespace seamwright::test
