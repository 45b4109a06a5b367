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

/// The faces and edges of a shape whose numbers can't be computed with: coordinates, poles,
/// weights, knots, radii, tolerances, ranges of edges or locations that are no numbers, not finite,
/// or 1e100 and more, which OpenCASCADE takes for infinite. Edges answer for their vertices and for
/// their paths on all faces. Triangulations are not looked at.
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
  /// One clause, "face 3 has a surface with the number nan"; the part must be one of these.
  std::string describeFace(int face) const;
  std::string describeEdge(int edge) const;
  /// Why algorithms over whole faces can't take a face, as "face 3 ..." goes on: "has a surface
  /// with the number nan", "has edge 7, which has a vertex with the number inf". Empty if they can.
  std::string whyLeftOut(int face) const;
  /// One sentence for a user; empty if there are no such parts.
  std::string note() const;

 private:
  std::map<int, std::string> faces_;  ///< what is wrong, by number
  std::map<int, std::string> edges_;
  std::map<int, int> edge_of_face_;  ///< the first such edge of a face that has one
};

/// Whether numbers of one part can be computed with, as UnusableParts has it.
bool isUsable(const TopoDS_Face& face);
bool isUsable(const TopoDS_Edge& edge);

/// Adds a note to the model if it has such parts.
/// \throws ModelError (Malformed) if no face can be computed with
void noteUnusableParts(Model& model);

/// \param path of the model, for the error; may be empty
/// \param deed what can't be done: "repaired", ...
/// \throws ModelError (Malformed) if the shape has a part that can't be computed with
void requireUsable(const TopoDS_Shape& shape, const std::filesystem::path& path,
                   const std::string& deed);

}  // namespace seamwright::occ
