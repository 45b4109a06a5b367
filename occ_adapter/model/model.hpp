// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace seamwright::occ {

enum class ModelErrc {
  NotFound,        ///< no such file
  NotAFile,        ///< a folder or a device
  NotReadable,     ///< permissions, or the disk
  Empty,           ///< 0 bytes
  UnknownFormat,   ///< no STEP, IGES or BREP file
  Truncated,       ///< the closing record is missing
  Malformed,       ///< OpenCASCADE could not read it
  UnknownUnits,    ///< no length unit that is understood
  NoShapes,        ///< read, but it has no face
  ReaderDied,      ///< the reading process crashed or exceeded its time or memory
  ReaderMissing,   ///< the reading program is not installed where it belongs
  UnknownTarget,   ///< the name of the output has no known extension
  TargetExists,    ///< the output exists, or is the file that was read, and may not be replaced
  NotWritable,     ///< the output's folder is missing or closed, or the disk is full
  NotWritten,      ///< OpenCASCADE could not write it
  UnlikeInstances  ///< a part of an assembly was changed in some of its instances only
};

/// A model that can't be used. what() is one line: the file, what is wrong, what to do.
class ModelError : public std::runtime_error {
 public:
  ModelError(ModelErrc code, const std::filesystem::path& path, const std::string& what)
      : std::runtime_error(path.empty() ? "model " + what : path.string() + ": " + what),
        code_(code) {}
  ModelErrc code() const { return code_; }

 private:
  ModelErrc code_;
};

/// Name, colour and layers that the file gives to a part of the shape.
struct ShapeAttribute {
  TopAbs_ShapeEnum kind = TopAbs_SHAPE;
  int index = 0;     ///< from 1, in the order of TopExp::MapShapes for that kind
  std::string name;  ///< UTF-8, may be empty
  std::optional<std::array<double, 3>> color;  ///< red, green, blue; 0..1, linear
  std::vector<std::string> layers;             ///< UTF-8, sorted
};

/// A shape with what its file says about it. Lengths are in mm, whatever the unit of the file. A
/// copy shares the shape. Functions of this library do not modify the shape of a model that they
/// are given.
struct Model {
  TopoDS_Shape shape;
  std::string path;         ///< as given; empty for a shape from memory
  std::string format;       ///< "STEP", "IGES", "BREP", "binary BREP", "memory"
  std::string length_unit;  ///< the file's unit; "mm (assumed)" if the format has none
  std::vector<ShapeAttribute> attributes;
  std::vector<std::string> notes;  ///< what a user should know: faces that could not be read, ...
  double read_s = 0;

  int faceCount() const;
  int edgeCount() const;
};

/// A model of a shape in memory. The shape is shared, not copied, and never changed. Faces and
/// edges with numbers that are not finite, or 1e100 and more, are counted in its notes.
/// \throws ModelError if the shape is null, has no face, or has no face with finite numbers.
Model modelFromShape(const TopoDS_Shape& shape);

/// Writes the shape in OpenCASCADE's binary format, as FreeCAD does (Part.Shape.exportBinary).
/// Poles, knots and points are preserved exactly. Reading normalises axes of analytic surfaces and
/// locations again, which may change the last bit.
void writeBinaryShape(const TopoDS_Shape& shape, std::ostream& stream);
/// Reads what writeBinaryShape() or FreeCAD wrote. Returns a null shape if the stream holds none.
TopoDS_Shape readBinaryShape(std::istream& stream);
/// Writes the shape as text, which every version of OpenCASCADE reads; coordinates keep 15 digits.
void writeTextShape(const TopoDS_Shape& shape, std::ostream& stream);
/// Reads what writeTextShape() wrote. Returns a null shape if the stream holds none.
TopoDS_Shape readTextShape(std::istream& stream);

}  // namespace seamwright::occ
