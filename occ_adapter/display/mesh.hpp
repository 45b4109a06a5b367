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
  /// this, or bend_rel of the angle between the ends if that is more. A stripe is drawn out of
  /// place by the share.
  double bend_rad = 2e-4;
  double bend_rel = 0.02;
  /// Largest height of the face over an edge, as a share of the size of the face; less for narrow
  /// faces.
  double sag_rel = 2e-3;
  /// Edges shorter than this share of their face's size are not split for their normals: where a
  /// surface has a kink the normals differ however near they are.
  double shortest_rel = 0.01;
  /// The inside of a face with more triangles is not split any further.
  int max_face_triangles = 60000;
  bool curvatures = true;  ///< false: DisplayMesh::curvatures stays empty
  int jobs = 0;            ///< threads; 0: one for each processor

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// The shape that a model had before its faces moved. Surfaces keep their parameters when they
/// move.
struct MovedFaces {
  TopoDS_Shape before;     ///< the faces of the model in the same order; null: nothing moved
  std::vector<int> faces;  ///< those that moved, from 1
  /// Between two nodes the move may differ by this from the mean of the moves of both.
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

/// Triangles of all faces of a model with what its surfaces are at the nodes.
///
/// Faces share no nodes: a break between two faces stays a break. On an edge that two faces share,
/// the nodes of both lie at the same parameters of the edge.
struct DisplayMesh {
  std::vector<Eigen::Vector3d> points;  ///< on the surface of the face at the parameters, in mm
  /// Unit normals of the face: that of the surface, reversed for a reversed face, mirrored by a
  /// mirroring location. Zero where neither the surface nor a triangle around tells one.
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

/// Triangles of a model to look at, fine enough for reflections.
///
/// OpenCASCADE triangulates a copy of the shape that shares its surfaces; the shape and the
/// triangles stored in it are left as they are. Points, normals and curvatures are then those of
/// the surfaces at the parameters of the nodes, and triangles are split until they meet \p options.
/// Nodes on an edge lie on the edge's path on the face. At a pole of a surface the normal and the
/// curvatures are extrapolated from 1e-5 and 2e-5 of the parameter range away from it.
///
/// The area of the triangles of a face is compared with its true area. A face that has no
/// triangles, or where the two differ by more than 1 %, is triangulated once more alone and finer;
/// what remains wrong is listed in the faults. A face with numbers that are not finite, or 1e100
/// and more, in itself or in its edges, gets no triangles and is listed too.
///
/// \throws std::invalid_argument for bad options, faces the model does not have, and a shape before
/// with another number of faces; Cancelled.
DisplayMesh displayMesh(const Model& model, const DisplayMeshOptions& options = {},
                        const MovedFaces& moved = {}, const Progress& progress = {});

}  // namespace seamwright::occ
