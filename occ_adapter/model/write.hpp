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
  /// Writes the shape with Model::attributes alone, though the model has a source that could be
  /// followed.
  bool afresh = false;
  /// A STEP file that follows its source states this share of the accuracy that it would else.
  /// Readers join what is nearer than that, so a coarse one costs them short edges.
  double share_of_accuracy = 1;
  /// The model is what its file holds: a file of the same format becomes a copy of that file, byte
  /// for byte.
  bool unchanged = false;
  /// Called with the new file, whole, while it waits beside its place under another name: to read
  /// it back, say. What it throws is passed on, and nothing is written then.
  std::function<void(const std::filesystem::path&)> check = {};
};

/// What writeModel() did.
struct WriteReport {
  Format format = Format::Step;
  /// The source was read again and its structure followed; otherwise the file was made of shape and
  /// attributes.
  bool followed_source = false;
  int changed_faces = 0;  ///< where the source was followed: faces with another surface than there
  int changed_edges = 0;
  int changed_vertices = 0;
  std::vector<std::string> notes;  ///< what a user should know: what the format can't hold, ...
};

/// The format that a file of this name is written in: .step, .stp; .iges, .igs; .brep, .brp (text);
/// .bin (binary BREP). Upper case is the same. \throws ModelError (UnknownTarget)
Format targetFormat(const std::filesystem::path& path);

/// Throws now what writeModel() says of the target before its work: a name that tells no format, a
/// file that is there, the source itself, a folder that is missing or closed.
/// \param source the file that the model is read from; empty if none. \throws ModelError
void requireTarget(const std::filesystem::path& source, const std::filesystem::path& target,
                   const WriteOptions& options = {});

/// Writes a model to a STEP, IGES or BREP file, told by its extension.
///
/// A model that was read from a STEP or IGES file and has still the faces, edges and vertices of
/// that file, in the same order and places, is written by reading the file once more and carrying
/// over into it what has changed: surfaces, curves, parameter curves, points and tolerances.
/// Products, instances, names, colours, layers and order are those of the file. What has not
/// changed stays bitwise as it was read. A part that stands in several places has to be changed
/// alike in all of them; a deep copy of the shape is no change, even where it has made copies of
/// such a part.
///
/// Where the faces, edges or vertices are others (a sewn model), where the model comes from memory
/// or from BREP, or with WriteOptions::afresh, a new file is made of the shape and
/// Model::attributes; a compound whose solids have names becomes an assembly, loose faces that
/// share edges become shells. Such a file has the faces in their order, but edges within a reversed
/// face may be numbered otherwise when it is read. STEP states the largest tolerance of the shape
/// as its accuracy then, and IGES has faces that share edges, also where those of the source share
/// none.
///
/// STEP: schema (AP203, AP214 or AP242), header texts, length unit and stated accuracy of a STEP
/// source are kept, and parameter curves are written. Where edges or vertices got larger tolerances
/// than that accuracy, it becomes the largest of those, for readers throw away parameter curves
/// that miss their vertices by more. Numbers are written with the fewest digits that read back as
/// the same double, where OpenCASCADE's own writer rounds to 13 digits; beyond 1e-99 and 1e99, 16
/// digits. So in mm poles, weights, knots and points come back bit by bit; in other units the
/// conversion may move the last bit. OpenCASCADE normalises directions when it reads, which may
/// move their last bit, and it drops what it does not know (texts of faces, validation and
/// tolerance data in part). Surfaces without a topology (geometrically bounded) get one. IGES: unit
/// of an IGES or STEP source; 17 digits. A colour of a solid comes back as that of its faces too.
/// BREP: mm, no names, colours or layers. Binary keeps every number; text keeps poles and knots,
/// and 15 digits of points.
///
/// OpenCASCADE writes in the process that reads (see readModel()), under the same limits. The file
/// is written beside its place under another name, flushed to the disk and renamed: whenever the
/// work is stopped, the target is what it was before, or the new file. Only a killed process leaves
/// the file beside (.NAME.NUMBER.part). A target that is a symbolic link stays one; the file it
/// leads to is replaced.
///
/// Numbers that are not finite are written in BREP, and refused (NotWritten) in STEP and IGES,
/// which can't hold them.
///
/// \throws ModelError (its code says which kind) or Cancelled; nothing is written then.
WriteReport writeModel(const Model& model, const std::filesystem::path& path,
                       const WriteOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
