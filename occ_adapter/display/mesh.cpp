// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/display/face_mesh.hpp>
#include <seamwright/occ_adapter/display/mesh.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <stdexcept>

namespace seamwright::occ {

namespace {

/// How far OpenCASCADE's triangles may be from the shape: its edges, and the inside of faces, which
/// is refined here in much less time.
struct Fineness {
  double edge_rel;    ///< of the diagonal of the box around the shape
  double inside_rel;  ///< the same
  double edge_rad;
  double inside_rad;
};
/// Coarse, since triangles are split here until they meet the options: OpenCASCADE only has to find
/// the topology of each face.
constexpr Fineness first_fineness = {
    .edge_rel = 5e-3, .inside_rel = 2e-2, .edge_rad = 0.2, .inside_rad = 0.4};
/// For a face that came out wrong, alone. A choice: at least ten times as fine in distance, which
/// one face may cost.
constexpr Fineness second_fineness = {
    .edge_rel = 5e-4, .inside_rel = 1e-3, .edge_rad = 0.1, .inside_rad = 0.1};
/// What the area of the triangles may differ by from that of the face: triangles that meet the
/// options are off by less than half of it (see sag_by_width), a missing triangle mostly by more.
constexpr double area_share = 0.01;
/// A piece of an edge is halved at most so often: into 1024 parts. A bound against endless work.
constexpr int edge_passes = 10;

/// Shares of the progress bar: OpenCASCADE's triangles, then edges, then the inside of faces.
constexpr double meshed_by = 0.4;
constexpr double edges_by = 0.6;

/// Passes on that the work is to stop; asked by OpenCASCADE from any thread.
class StopSign : public Message_ProgressIndicator {
 public:
  explicit StopSign(const std::atomic<bool>& stop) : stop_(stop) {}
  Standard_Boolean UserBreak() override { return stop_; }
  void Show(const Message_ProgressScope& /*scope*/, const Standard_Boolean /*force*/) override {}

 private:
  const std::atomic<bool>& stop_;
};

double diagonalOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

/// A copy with triangles; it shares the surfaces and curves.
TopoDS_Shape triangulated(const TopoDS_Shape& shape, const Fineness& fineness,
                          const Message_ProgressRange& range) {
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape, false, false).Shape();
  const double diagonal = diagonalOf(copy);
  if (!(diagonal > 0)) return copy;
  IMeshTools_Parameters parameters;
  parameters.Deflection = fineness.edge_rel * diagonal;
  parameters.DeflectionInterior = fineness.inside_rel * diagonal;
  parameters.Angle = fineness.edge_rad;
  parameters.AngleInterior = fineness.inside_rad;
  parameters.InParallel = true;
  BRepMesh_IncrementalMesh mesh(copy, parameters, range);
  return copy;
}

/// By integration with a fixed number of points; nothing where OpenCASCADE fails.
std::optional<double> quickAreaMm2(const TopoDS_Face& face) {
  try {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return std::abs(properties.Mass());
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

/// By integration to a hundredth of the share that the triangles are allowed.
std::optional<double> adaptiveAreaMm2(const TopoDS_Face& face) {
  try {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties, 0.01 * area_share);
    return std::abs(properties.Mass());
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

/// What is wrong with the numbers of each face or its edges; empty where nothing is. OpenCASCADE's
/// triangulation of faces with such numbers takes minutes or does not end.
std::vector<std::string> unusableNumbers(const TopoDS_Shape& shape,
                                         const TopTools_IndexedMapOfShape& faces) {
  std::vector<std::string> found(faces.Extent());
  const UnusableParts unusable(shape);
  if (unusable.empty()) return found;
  const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
  for (int i = 0; i < faces.Extent(); ++i) {
    if (unusable.hasFace(i + 1)) found[i] = unusable.describeFace(i + 1);
    for (TopExp_Explorer it(faces(i + 1), TopAbs_EDGE); it.More() && found[i].empty(); it.Next()) {
      const int edge = edges.FindIndex(it.Current());
      if (unusable.hasEdge(edge)) found[i] = unusable.describeEdge(edge);
    }
  }
  return found;
}

/// A face on its way: its triangles, or why there are none.
struct FaceWork {
  std::unique_ptr<FaceMesh> mesh;
  std::vector<EdgePiece> coarse;
  std::vector<NodeCurvature> curvatures;
  std::string reason;
  std::string fault;
};

/// Does a step for a face; a failure leaves the face without triangles.
template <class Step>
void attemptFace(FaceWork& face, const Step& step) {
  try {
    step();
  } catch (const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    face.reason = text != nullptr && *text != '\0' ? text : "its surface can't be evaluated";
    face.mesh.reset();
  }
}

/// What is wrong with the triangles of a face; empty if nothing is.
std::string areaFault(const TopoDS_Face& face, const FaceMesh& mesh) {
  const double found = mesh.areaMm2();
  double exact = 0;
  // The quick figure is off by several percent on some surfaces; then the slow one decides.
  for (const auto& area : {quickAreaMm2, adaptiveAreaMm2}) {
    const std::optional<double> given = area(face);
    if (!given) return {};  // nothing to compare with
    exact = *given;
    // A face narrower than its own tolerance has no area to speak of.
    const double allowed = area_share * exact + BRep_Tool::Tolerance(face) * mesh.sizeMm();
    if (std::abs(found - exact) <= allowed) return {};
  }
  return fmt::format("triangles of {:.4g} mm^2 on a face of {:.4g} mm^2", found, exact);
}

class DisplayMeshBuilder {
 public:
  DisplayMeshBuilder(const Model& model, const DisplayMeshOptions& options, const MovedFaces& moved)
      : faces_(partsOf(model.shape, TopAbs_FACE)),
        options_(options),
        moved_(moved),
        work_(faces_.Extent()) {
    if (moved.before.IsNull()) return;
    before_ = partsOf(moved.before, TopAbs_FACE);
    if (before_.Extent() != faces_.Extent())
      throw std::invalid_argument(fmt::format("the shape before has {} faces, the model {}",
                                              before_.Extent(), faces_.Extent()));
    for (const int face : moved.faces) requireFace(face, faces_.Extent());
  }

  DisplayMesh run(const TopoDS_Shape& shape, const Progress& progress) {
    triangulate(shape, partOf(progress, 0, meshed_by));
    refineEdges(partOf(progress, meshed_by, edges_by));
    each(partOf(progress, edges_by, 1), [this](int face) { finish(face); });
    return collected();
  }

 private:
  /// Calls step(index) for all faces in parallel.
  template <class Step>
  void each(const Progress& progress, const Step& step) {
    runParallel(
        work_.size(), options_.jobs, [&](std::size_t i) { step(static_cast<int>(i)); }, progress);
  }

  /// Sets aside the faces that can't be triangulated, and returns the others; their indices go to
  /// usable_.
  TopoDS_Shape usableFaces(const TopoDS_Shape& shape) {
    const std::vector<std::string> wrong = unusableNumbers(shape, faces_);
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 0; i < faces_.Extent(); ++i) {
      if (!wrong[i].empty()) {
        work_[i].fault = "no triangles: " + wrong[i];
        continue;
      }
      builder.Add(all, faces_(i + 1));
      usable_.push_back(i);
    }
    return all;
  }

  void triangulate(const TopoDS_Shape& shape, const Progress& progress) {
    const TopoDS_Shape usable = usableFaces(shape);
    std::atomic<bool> stop = false;
    TopoDS_Shape copy;
    std::string failure;
    const Progress watched = [&](double share) {
      if (progress && !progress(share)) stop = true;
      return !stop;
    };
    const opencascade::handle<StopSign> sign = new StopSign(stop);
    const auto mesh = [&](std::size_t) {
      try {
        copy = triangulated(usable, first_fineness, sign->Start());
      } catch (const Standard_Failure& error) {
        failure = error.GetMessageString();
      }
    };
    runParallel(1, 1, mesh, watched);
    const TopTools_IndexedMapOfShape copies = partsOf(copy, TopAbs_FACE),
                                     edges = partsOf(copy, TopAbs_EDGE);
    for (int i = 0; i < static_cast<int>(usable_.size()); ++i)
      attemptFace(work_[usable_[i]], [&] {
        if (i >= copies.Extent()) throw Standard_Failure(failure.c_str());
        start(usable_[i], TopoDS::Face(copies(i + 1)), edges);
      });
  }

  void start(int index, const TopoDS_Face& face, const TopTools_IndexedMapOfShape& edges) {
    work_[index].mesh = std::make_unique<FaceMesh>(face, edges, options_);
    if (std::ranges::find(moved_.faces, index + 1) != moved_.faces.end() && !before_.IsEmpty())
      work_[index].mesh->setMoves(TopoDS::Face(before_(index + 1)), moved_.rough_mm,
                                  moved_.longest_rel);
  }

  /// Halves pieces of edges on both of their faces until none of them wants more.
  void refineEdges(const Progress& progress) {
    for (int pass = 0; pass < edge_passes; ++pass) {
      const Progress part =
          partOf(progress, double(pass) / edge_passes, double(pass + 1) / edge_passes);
      each(partOf(part, 0, 0.5), [this](int face) { findCoarse(face); });
      std::vector<EdgePiece> pieces;
      for (const FaceWork& face : work_)
        pieces.insert(pieces.end(), face.coarse.begin(), face.coarse.end());
      if (pieces.empty()) return;
      std::ranges::sort(pieces);
      each(partOf(part, 0.5, 1), [&](int face) { splitPieces(face, pieces); });
    }
  }

  void findCoarse(int index) {
    FaceWork& face = work_[index];
    face.coarse.clear();
    if (face.mesh) attemptFace(face, [&] { face.coarse = face.mesh->coarsePieces(); });
  }

  void splitPieces(int index, const std::vector<EdgePiece>& pieces) {
    FaceWork& face = work_[index];
    if (face.mesh) attemptFace(face, [&] { face.mesh->splitPieces(pieces); });
  }

  void finish(int index) {
    FaceWork& face = work_[index];
    if (!face.fault.empty()) return;
    if (face.mesh) attemptFace(face, [&] { face.mesh->refineInside(); });
    const std::string wrong = faultOf(index);
    if (!wrong.empty()) tryAlone(index, wrong);
    if (!face.mesh) return;
    face.mesh->completeNormals();
    if (options_.curvatures) attemptFace(face, [&] { face.curvatures = face.mesh->curvatures(); });
  }

  std::string faultOf(int index) const {
    const FaceWork& face = work_[index];
    if (!face.mesh) return "no triangles: " + face.reason;
    return areaFault(TopoDS::Face(faces_(index + 1)), *face.mesh);
  }

  /// Triangulates a face by itself and finer, and keeps that if it is right.
  void tryAlone(int index, const std::string& wrong) {
    FaceWork& face = work_[index];
    FaceWork given = std::move(face);
    face = {};
    attemptFace(face, [&] {
      const TopoDS_Shape copy = triangulated(faces_(index + 1), second_fineness, {});
      start(index, TopoDS::Face(copy), partsOf(copy, TopAbs_EDGE));
      for (int pass = 0; pass < edge_passes; ++pass) {
        std::vector<EdgePiece> pieces = face.mesh->coarsePieces();
        if (pieces.empty()) break;
        std::ranges::sort(pieces);
        face.mesh->splitPieces(pieces);
      }
      face.mesh->refineInside();
    });
    if (face.mesh && faultOf(index).empty()) return;
    if (given.mesh) face = std::move(given);
    face.fault = wrong;
  }

  DisplayMesh collected() {
    DisplayMesh all;
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    for (std::size_t i = 0; i < work_.size(); ++i) {
      FaceWork& face = work_[i];
      const std::size_t first = all.points.size();
      all.first_nodes.push_back(first);
      all.first_triangles.push_back(all.triangles.size());
      if (!face.fault.empty()) all.faults.push_back({static_cast<int>(i) + 1, face.fault});
      if (!face.mesh) continue;
      append(all.points, face.mesh->points());
      append(all.normals, face.mesh->normals());
      append(all.parameters, face.mesh->parameters());
      append(all.curvatures, face.curvatures);
      if (!before_.IsEmpty()) {
        append(all.moves_mm, face.mesh->movesMm());
        all.moves_mm.resize(all.points.size(), 0.0);
      }
      for (std::array<int, 3> triangle : face.mesh->triangles()) {
        for (int& node : triangle) node += static_cast<int>(first);
        all.triangles.push_back(triangle);
      }
      face.mesh.reset();
    }
    all.first_nodes.push_back(all.points.size());
    all.first_triangles.push_back(all.triangles.size());
    return all;
  }

  TopTools_IndexedMapOfShape faces_;
  TopTools_IndexedMapOfShape before_;
  const DisplayMeshOptions& options_;
  const MovedFaces& moved_;
  std::vector<FaceWork> work_;
  std::vector<int> usable_;  ///< indices of the faces that OpenCASCADE triangulates
};

}  // namespace

void DisplayMeshOptions::validate() const {
  const auto positive = [](const char* name, double value) {
    if (!(value > 0))
      throw std::invalid_argument(
          fmt::format("{} is {:f}: a positive number is needed", name, value));
  };
  positive("turn_rad", turn_rad);
  positive("bend_rad", bend_rad);
  positive("sag_rel", sag_rel);
  positive("shortest_rel", shortest_rel);
  if (jobs < 0)
    throw std::invalid_argument(fmt::format("jobs is {}: 0 or a positive number is needed", jobs));
}

DisplayMesh displayMesh(const Model& model, const DisplayMeshOptions& options,
                        const MovedFaces& moved, const Progress& progress) {
  options.validate();
  return DisplayMeshBuilder(model, options, moved).run(model.shape, progress);
}

}  // namespace seamwright::occ
