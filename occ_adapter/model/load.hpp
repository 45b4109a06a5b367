// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Interface_InterfaceModel.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <TDocStd_Document.hxx>
#include <filesystem>
#include <memory>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Passes OpenCASCADE's progress to a Progress, which may stop the work.
class Reporter : public Message_ProgressIndicator {
 public:
  explicit Reporter(const Progress& progress) : progress_(progress) {}
  void Show(const Message_ProgressScope&, bool) override {
    stopped_ = stopped_ || !progress_(GetPosition());
  }
  bool UserBreak() override { return stopped_; }

 private:
  const Progress& progress_;
  bool stopped_ = false;
};

/// A complete STEP or IGES file: the model, the document with its labels, and the entities of the
/// file. The parts of the model's shape are those of the document, not copies.
struct LoadedDocument {
  Model model;
  opencascade::handle<TDocStd_Document> document = new TDocStd_Document("BinXCAF");
  opencascade::handle<Interface_InterfaceModel> entities;
  std::shared_ptr<void> reader;  ///< clears the entities when it is destroyed
};

/// Reads a STEP or IGES file in this process; only the reading program calls it.
/// \param format "STEP" or "IGES"
/// \param needed a shape without any of them is an error
/// \throws ModelError, Standard_Failure
LoadedDocument loadDocument(const std::filesystem::path& path, const std::string& format,
                            const Progress& progress, Needed needed = Needed::Faces);

/// Reads a model file in this process; only the reading program calls it.
/// \param format "STEP", "IGES", "BREP" or "binary BREP", as detectFormat() returns it.
/// \throws ModelError, Standard_Failure
Model loadModel(const std::filesystem::path& path, const std::string& format,
                const Progress& progress, Needed needed = Needed::Faces);

}  // namespace seamwright::occ
