// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/model/format.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

struct WriteOptions {
  bool overwrite = false;         ///< another file of that name may be replaced
  bool overwrite_source = false;  ///< the file the model was read from may be replaced
  /// Writes the shape with Model::attributes alone, even if the model has a source to follow.
  bool afresh = false;
  /// A STEP file that follows its source states this share of its accuracy. Readers join
  /// what is nearer than the stated accuracy, and so lose short edges if it is coarse.
  double share_of_accuracy = 1;
  /// The model is what its file holds. A file of the same format becomes a copy, byte for byte.
  bool unchanged = false;
  /// Called with the complete new file before it is renamed, for example to read it back. What it
  /// throws is passed on, and nothing is written then.
  std::function<void(const std::filesystem::path&)> check = {};
};

/// What writeModel() did.
struct WriteReport {
  Format format = Format::Step;
  /// The source was read again and its structure kept; false: made of shape and attributes.
  bool followed_source = false;
  int changed_faces = 0;  ///< if the source was followed: faces with another surface than there
  int changed_edges = 0;
  int changed_vertices = 0;
  std::vector<std::string> notes;  ///< what a user should know: what the format can't hold, ...
};

/// The format that a file of this name is written in: .step, .stp; .iges, .igs; .brep, .brp (text);
/// .bin (binary BREP). Upper case is the same. \throws ModelError (UnknownTarget)
Format targetFormat(const std::filesystem::path& path);

/// Checks a target as writeModel() does, before the work whose result it is to hold: its name tells
/// a format, it does not exist or may be replaced, and its folder can be written to.
/// \param source the file that the model is read from; empty if none.
/// \throws ModelError
void requireTarget(const std::filesystem::path& source, const std::filesystem::path& target,
                   const WriteOptions& options = {});

/// Writes a model to a STEP, IGES or BREP file; the extension decides the format. docs/writing.md
/// states what each format keeps.
///
///     Model model = readModel("part.step");
///     const WriteReport report = writeModel(model, "copy.step", {.overwrite = true});
///     for (const std::string& note : report.notes) warn(note);
///
/// A model from a STEP or IGES file that still has the faces, edges and vertices of that file, in
/// the same order and positions, is written by reading the file again and carrying the changes
/// over: surfaces, curves, pcurves, points and tolerances. Products, instances, names, colours,
/// layers and order are those of the file; what has not changed stays bitwise. A part with several
/// instances has to be changed alike in all of them. Otherwise, or with WriteOptions::afresh, a new
/// file is made of the shape and Model::attributes. Then edges within a reversed face may be
/// numbered otherwise when it is read.
///
///   - STEP keeps schema, header, length unit and stated accuracy of a STEP source. The accuracy
///     grows to the largest tolerance that grew, because readers discard pcurves that miss their
///     vertices by more. Numbers have the fewest digits that read back as the same double (beyond
///     1e-99 and 1e99, 16 digits). OpenCASCADE normalises directions, and drops what it does not
///     know.
///   - IGES has the unit of the source, and 17 digits. A colour of a solid is read as that of its
///     faces too.
///   - BREP is in mm, without names, colours and layers. Text keeps 15 digits of points.
///   - Numbers that are not finite are written in BREP, and refused (NotWritten) in STEP and IGES.
///
/// The process that reads also writes (see readModel()), under the same limits. The file is written
/// beside its target under another name, flushed to the disk and renamed. So the target is always
/// what it was before, or the new file; only a killed process leaves .NAME.NUMBER.part. A target
/// that is a symbolic link stays one; the file it leads to is replaced.
///
/// The model is not changed.
///
/// \throws ModelError (its code says which kind) or Cancelled; nothing is written then.
WriteReport writeModel(const Model& model, const std::filesystem::path& path,
                       const WriteOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
