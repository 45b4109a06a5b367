// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>
#include <optional>

#include <seamwright/core/differential/jet.hpp>
#include <seamwright/occ_adapter/display/mesh.hpp>

namespace seamwright::occ {

/// The surface of a face in space, with the normals of the face. Not a public header.
///
/// Not thread-safe: OpenCASCADE's adaptors cache.
class DisplaySurface {
 public:
  /// \throws Standard_Failure if the face has no surface.
  explicit DisplaySurface(const TopoDS_Face& face);

  /// Sets the range of parameters in use. It determines where the inside is, seen from a pole, and
  /// the size of a small step.
  void setRange(const Eigen::Vector2d& low, const Eigen::Vector2d& high);

  struct Sample {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;  ///< unit; zero where the surface has none
  };
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  Sample at(const Eigen::Vector2d& uv) const;
  Eigen::Vector3d pointAt(const Eigen::Vector2d& uv) const;
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  NodeCurvature curvatureAt(const Eigen::Vector2d& uv) const;

 private:
  std::optional<Eigen::Vector3d> normalOf(const Eigen::Vector3d& du,
                                          const Eigen::Vector3d& dv) const;
  std::optional<Eigen::Vector3d> normalAt(const Eigen::Vector2d& uv) const;
  std::optional<NodeCurvature> regularCurvature(const Eigen::Vector2d& uv) const;
  std::optional<Eigen::Vector2d> stepOffPole(const Eigen::Vector2d& uv) const;
  Eigen::Vector3d inSpace(const Eigen::Vector3d& local_normal) const;

  GeomAdaptor_Surface surface_;
  gp_Trsf location_;
  double sign_;   ///< -1 for a reversed face
  double scale_;  ///< of the location, positive
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d range_ = Eigen::Vector2d::Ones();
};

}  // namespace seamwright::occ
