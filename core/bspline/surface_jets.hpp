// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bspline/surface.hpp>

/// Not a public header.
namespace seamwright {

/// jet() for many points: the surface is checked once. It must outlive this and stay as it is.
class SurfaceJets {
 public:
  /// \throws std::invalid_argument as requireValid() does.
  explicit SurfaceJets(const BSplineSurface& surface);
  explicit SurfaceJets(BSplineSurface&&) = delete;

  /// \param order of the partials, up to 3; those above it are zero.
  /// \throws std::invalid_argument for a parameter that is not finite.
  SurfaceJet at(double u, double v, int order = 3) const;

 private:
  const BSplineSurface* surface_;
  bool is_rational_;
};

}  // namespace seamwright
