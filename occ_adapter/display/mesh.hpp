// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// How fine a mesh is. A triangle is split where one of its edges exceeds a limit.
struct DisplayMeshOptions {
  /// Largest angle between the normals at the two ends of an edge.
  double turn_rad = 0.2;
  /// Largest angle between the normal in the middle of an edge and the mean of those at its ends:
  /// this, or bend_rel times the angle between the ends if that is more. The share is also the
  /// error in the position of a stripe.
  double bend_rad = 2e-4;
  double bend_rel = 0.02;
  /// Largest height of the face over an edge, as a share of the size of the face; less for narrow
  /// faces.
  double sag_rel = 2e-3;
  /// Edges shorter than this share of their face's size are not split because of their normals: at
  /// a kink of a surface normals differ however near they are.
  double shortest_rel = 0.01;
  /// The inside of a face with more triangles is not split any further.
  int max_face_triangles = 60000;
  bool curvatures = true;  ///< false: DisplayMesh::curvatures stays empty
  int jobs = 0;            ///< threads; 0: one for each processor

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// The shape of a model before its faces moved. Moved surfaces have kept their parameters.
struct MovedFaces {
  TopoDS_Shape before;     ///< the faces of the model in the same order; null: nothing moved
  std::vector<int> faces;  ///< those that moved, from 1
  /// Largest accepted difference of the move between two nodes from the mean of the moves at both.
  double rough_mm = 0;
  /// Longest edge of a face that moved, as a share of the size of the face.
  double longest_rel = 0.06;
};

/// A face whose triangles are missing or do not cover it.
struct MeshFault {
  int face = 0;        ///< from 1, in the order of TopExp::MapShapes
  std::string reason;  ///< one line, with figures
};

/// The principal curvatures at a node in 1/mm, k1 >= k2, positive where the face bends towards its
/// normal. NaN where the surface has none (the tip of a cone).
struct NodeCurvature {
  double k1 = 0;
  double k2 = 0;
};

/// Triangles of all faces of a model, with the properties of the surfaces at the nodes.
///
/// Faces share no nodes, so a break between two faces stays visible. On an edge that two faces
/// share, the nodes of both are at the same parameters of the edge.
struct DisplayMesh {
  std::vector<Eigen::Vector3d> points;  ///< on the surface of the face at the parameters, in mm
  /// Unit normals of the face: those of the surface, reversed for a reversed face, mirrored by a
  /// mirroring location. Zero if neither the surface nor a triangle at the node has one.
  std::vector<Eigen::Vector3d> normals;
  std::vector<Eigen::Vector2d> parameters;  ///< (u, v)
  std::vector<NodeCurvature> curvatures;    ///< empty unless asked for
  std::vector<double> moves_mm;             ///< how far each node moved; empty where nothing moved
  std::vector<std::array<int, 3>>
      triangles;  ///< nodes, counter-clockwise seen from where the normals point
  std::vector<std::size_t> first_nodes;  ///< by face, and the number of all nodes at the end
  std::vector<std::size_t>
      first_triangles;            ///< by face, and the number of all triangles at the end
  std::vector<MeshFault> faults;  ///< by face
};

/// Triangulates a model for display, finely enough for reflections.
///
///     const DisplayMesh mesh = displayMesh(model, {.turn_rad = 0.1});
///
/// OpenCASCADE triangulates a copy of the shape that shares its surfaces; the shape and the
/// triangles stored in it are not changed. Points, normals and curvatures are those of the surfaces
/// at the parameters of the nodes. Triangles are split until they meet \p options. Nodes on an edge
/// are on the image of its pcurve. At a pole of a surface the normal and the curvatures are
/// extrapolated from 1e-5 and 2e-5 of the parameter range away from it.
///
/// A face that has no triangles, or whose triangles differ from its area by more than 1 %, is
/// triangulated once more alone and finer; what is still wrong is listed in the faults. A face with
/// numbers that are not finite, or 1e100 and more, in itself or in its edges, has no triangles and
/// is listed too.
///
/// \throws std::invalid_argument for invalid options, faces that the model does not have, and a
/// shape before with another number of faces; Cancelled.
DisplayMesh displayMesh(const Model& model, const DisplayMeshOptions& options = {},
                        const MovedFaces& moved = {}, const Progress& progress = {});

}  // namespace seamwright::occ
