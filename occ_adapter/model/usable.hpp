// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <map>
#include <string>

#include <seamwright/occ_adapter/model/model.hpp>

namespace seamwright::occ {

/// The faces and edges of a shape that can't be computed with, because of a coordinate, pole,
/// weight, knot, radius, tolerance, range or location that is not finite or is 1e100 or more, which
/// OpenCASCADE treats as infinite. The vertices of an edge and its pcurves on all faces count as
/// parts of the edge. Triangulations do not count.
///
/// Faces and edges are numbered from 1 in the order of TopExp::MapShapes. Time is linear in the
/// size of the shape.
class UnusableParts {
 public:
  explicit UnusableParts(const TopoDS_Shape& shape);

  bool empty() const { return faces_.empty() && edges_.empty(); }
  int faceCount() const { return static_cast<int>(faces_.size()); }
  bool hasFace(int face) const { return faces_.contains(face); }
  bool hasEdge(int edge) const { return edges_.contains(edge); }
  /// One clause: "face 3 has a surface with the number nan". \pre the part is one of these.
  std::string describeFace(int face) const;
  std::string describeEdge(int edge) const;
  /// Why algorithms on whole faces can't process a face, as the end of a sentence that begins with
  /// "face 3": "has a surface with the number nan", "has edge 7, which has a vertex with the number
  /// inf". Empty if they can.
  std::string whyLeftOut(int face) const;
  /// One sentence for a user; empty if there are no such parts.
  std::string note() const;

 private:
  std::map<int, std::string> faces_;  ///< what is wrong, by number
  std::map<int, std::string> edges_;
  std::map<int, int> edge_of_face_;  ///< the first such edge of a face that has one
};

/// Whether a part can be computed with, by the rules of UnusableParts.
bool isUsable(const TopoDS_Face& face);
bool isUsable(const TopoDS_Edge& edge);

/// Adds a note to the model if it has such parts.
/// \throws ModelError (Malformed) if no face can be computed with.
void noteUnusableParts(Model& model);

/// \param path of the model, for the error; may be empty.
/// \param deed what can't be done: "repaired", ...
/// \throws ModelError (Malformed) if the shape has a part that can't be computed with.
void requireUsable(const TopoDS_Shape& shape, const std::filesystem::path& path,
                   const std::string& deed);

}  // namespace seamwright::occ
