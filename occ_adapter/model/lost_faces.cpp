// SPDX-License-Identifier: LGPL-2.1-or-later
#include <IGESBasic_Group.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_UndefinedEntity.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESToBRep.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Protocol.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <unordered_set>

#include <seamwright/occ_adapter/model/lost_faces.hpp>

namespace seamwright::occ {

namespace {

using FileEntity = opencascade::handle<Standard_Transient>;

/// Faces named by entities, and how many of them the shape does not have.
struct FaceCount {
  int named = 0;
  int lost = 0;

  void add(bool is_lost) {
    ++named;
    lost += is_lost;
  }
};

/// Tells which entities ended up as faces of the shape: some are made and then dropped with the
/// shell they belong to.
class MadeFaces {
 public:
  MadeFaces(const XSControl_Reader& reader, const TopoDS_Shape& shape)
      : process_(reader.WS()->TransferReader()->TransientProcess()) {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      faces_.insert(it.Current().TShape().get());
  }

  bool has(const FileEntity& entity) const {
    const TopoDS_Shape made = TransferBRep::ShapeResult(process_, entity);
    if (made.IsNull()) return false;
    for (TopExp_Explorer it(made, TopAbs_FACE); it.More(); it.Next())
      if (faces_.contains(it.Current().TShape().get())) return true;
    return false;
  }

 private:
  opencascade::handle<Transfer_TransientProcess> process_;
  std::unordered_set<const void*> faces_;
};

/// Entities without a face, and entries of shells that lead nowhere.
FaceCount countStepFaces(const Interface_InterfaceModel& entities, const MadeFaces& made) {
  FaceCount count;
  for (int i = 1; i <= entities.NbEntities(); ++i) {
    const FileEntity& entity = entities.Value(i);
    if (entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface))) {
      count.add(!made.has(entity));
    } else if (const auto shell = opencascade::handle<StepShape_ConnectedFaceSet>::DownCast(entity);
               !shell.IsNull() && !shell->CfsFaces().IsNull()) {
      for (int k = 1; k <= shell->NbCfsFaces(); ++k)
        if (shell->CfsFacesValue(k).IsNull()) count.add(true);
    }
  }
  return count;
}

/// Also one whose parameters OpenCASCADE did not understand: its type stands in the directory of
/// the file.
bool isIgesFace(const FileEntity& entity) {
  if (entity->IsKind(STANDARD_TYPE(IGESGeom_TrimmedSurface)) ||
      entity->IsKind(STANDARD_TYPE(IGESGeom_BoundedSurface)) ||
      entity->IsKind(STANDARD_TYPE(IGESSolid_Face)))
    return true;
  const auto undefined = opencascade::handle<IGESData_UndefinedEntity>::DownCast(entity);
  if (undefined.IsNull()) return false;
  const int type = undefined->TypeNumber();
  return type == 143 || type == 144 || type == 510;
}

bool isIgesSurface(const FileEntity& entity) {
  const auto iges = opencascade::handle<IGESData_IGESEntity>::DownCast(entity);
  return !iges.IsNull() && IGESToBRep::IsBasicSurface(iges);
}

/// A surface that the file shows untrimmed, or whose face is of a type that OpenCASCADE does not
/// know.
bool isFaceByItself(const FileEntity& surface, const Interface_Graph& graph) {
  bool used_by_unknown = false, used_otherwise = false;
  Interface_EntityIterator users = graph.Sharings(surface);
  for (users.Start(); users.More(); users.Next()) {
    const FileEntity& user = users.Value();
    if (isIgesFace(user) || isIgesSurface(user)) return false;
    if (user->IsKind(STANDARD_TYPE(IGESData_UndefinedEntity)))
      used_by_unknown = true;
    else if (!user->IsKind(STANDARD_TYPE(IGESBasic_Group)))
      used_otherwise = true;
  }
  return used_by_unknown || !used_otherwise;
}

FaceCount countIgesFaces(const XSControl_Reader& reader, const MadeFaces& made) {
  const opencascade::handle<Interface_InterfaceModel> entities = reader.Model();
  const Interface_Graph graph(entities, reader.WS()->Protocol());
  FaceCount count;
  for (int i = 1; i <= entities->NbEntities(); ++i) {
    const FileEntity& entity = entities->Value(i);
    if (isIgesFace(entity) || (isIgesSurface(entity) && isFaceByItself(entity, graph)))
      count.add(!made.has(entity));
  }
  return count;
}

}  // namespace

void noteLostFaces(const XSControl_Reader& reader, Model& model) {
  const MadeFaces made(reader, model.shape);
  const opencascade::handle<Interface_InterfaceModel> entities = reader.Model();
  const bool is_iges = entities->IsKind("IGESData_IGESModel");
  const FaceCount count = is_iges ? countIgesFaces(reader, made) : countStepFaces(*entities, made);
  if (count.lost > 0)
    model.notes.push_back("the file names " + std::to_string(count.named) + " faces, " +
                          std::to_string(count.lost) + " of them could not be made");
}

}  // namespace seamwright::occ
