// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <seamwright/occ_adapter/convert/adaptor_jet.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>

namespace seamwright::occ {

SurfaceJet jetOn(const Adaptor3d_Surface& surface, double u, double v) {
  gp_Pnt p;
  gp_Vec along_u, along_v, uu, vv, uv;
  surface.D2(u, v, p, along_u, along_v, uu, vv, uv);
  SurfaceJet jet;
  jet.p = vector(p);
  jet.u = vector(along_u);
  jet.v = vector(along_v);
  jet.uu = vector(uu);
  jet.uv = vector(uv);
  jet.vv = vector(vv);
  return jet;
}

}  // namespace seamwright::occ
