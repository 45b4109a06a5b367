// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

#include <seamwright/occ_adapter/convert/surface_kind.hpp>

namespace seamwright::occ {

std::string kindOf(const TopoDS_Face& face) {
  switch (BRepAdaptor_Surface(face, false).GetType()) {
    case GeomAbs_Plane:
      return "a plane";
    case GeomAbs_Cylinder:
      return "a cylinder";
    case GeomAbs_Cone:
      return "a cone";
    case GeomAbs_Sphere:
      return "a sphere";
    case GeomAbs_Torus:
      return "a torus";
    case GeomAbs_SurfaceOfRevolution:
      return "a surface of revolution";
    case GeomAbs_SurfaceOfExtrusion:
      return "a surface of extrusion";
    case GeomAbs_OffsetSurface:
      return "an offset surface";
    default:
      return "a surface of another kind";
  }
}

}  // namespace seamwright::occ
