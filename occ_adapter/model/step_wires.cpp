// SPDX-License-Identifier: LGPL-2.1-or-later
#include <STEPConstruct.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_CompositeCurve.hxx>
#include <StepGeom_CompositeCurveSegment.hxx>
#include <StepGeom_HArray1OfCompositeCurveSegment.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepShape_GeometricCurveSet.hxx>
#include <StepShape_GeometricSetSelect.hxx>
#include <StepShape_HArray1OfGeometricSetSelect.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <set>

#include <seamwright/occ_adapter/model/step_wires.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;
using Segments = std::vector<handle<StepGeom_CompositeCurveSegment>>;

/// What has a colour or a layer of its own.
std::set<const Standard_Transient*> styledItems(const StepData_StepModel& model) {
  std::set<const Standard_Transient*> result;
  for (int i = 1; i <= model.NbEntities(); ++i)
    if (const auto styled = handle<StepVisual_StyledItem>::DownCast(model.Value(i));
        !styled.IsNull())
      result.insert(styled->Item().get());
  return result;
}

/// Whether each edge of the wire begins, in its own direction, where the one before ends.
bool runsForward(const TopoDS_Shape& wire) {
  TopoDS_Vertex last;
  for (TopoDS_Iterator part(wire); part.More(); part.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(part.Value());
    const TopoDS_Vertex start = TopExp::FirstVertex(edge);
    if (edge.Orientation() != TopAbs_FORWARD || start.IsNull()) return false;
    if (!last.IsNull() && !last.IsSame(start)) return false;
    last = TopExp::LastVertex(edge);
  }
  return !last.IsNull();
}

/// The curves of the set as segments of one curve; none if it holds something else.
Segments segmentsOf(const StepShape_GeometricCurveSet& set, int edges,
                    const std::set<const Standard_Transient*>& styled) {
  Segments result;
  if (set.NbElements() != edges) return {};
  for (int i = 1; i <= edges; ++i) {
    const auto curve = handle<StepGeom_TrimmedCurve>::DownCast(set.ElementsValue(i).Value());
    if (curve.IsNull() || styled.contains(curve.get())) return {};
    const handle<StepGeom_CompositeCurveSegment> segment = new StepGeom_CompositeCurveSegment;
    // What is known of a vertex is that the edges meet.
    segment->Init(StepGeom_tcContinuous, true, curve);
    result.push_back(segment);
  }
  return result;
}

handle<StepGeom_CompositeCurve> joined(const Segments& segments) {
  const auto count = static_cast<int>(segments.size());
  const handle<StepGeom_HArray1OfCompositeCurveSegment> list =
      new StepGeom_HArray1OfCompositeCurveSegment(1, count);
  for (int i = 1; i <= count; ++i) list->SetValue(i, segments[i - 1]);
  const handle<StepGeom_CompositeCurve> result = new StepGeom_CompositeCurve;
  result->Init(new TCollection_HAsciiString(""), list, StepData_LFalse);
  return result;
}

void replaceElements(StepShape_GeometricCurveSet& set,
                     const handle<StepGeom_CompositeCurve>& curve) {
  const handle<StepShape_HArray1OfGeometricSetSelect> elements =
      new StepShape_HArray1OfGeometricSetSelect(1, 1);
  StepShape_GeometricSetSelect element;
  element.SetValue(curve);
  elements->SetValue(1, element);
  set.SetElements(elements);
}

}  // namespace

void keepWires(STEPControl_Writer& writer, const std::vector<TopoDS_Shape>& shapes) {
  const handle<StepData_StepModel> model = writer.Model();
  const handle<Transfer_FinderProcess> process = writer.WS()->TransferWriter()->FinderProcess();
  const std::set<const Standard_Transient*> styled = styledItems(*model);
  for (const TopoDS_Shape& shape : shapes)
    for (TopExp_Explorer wire(shape, TopAbs_WIRE, TopAbs_FACE); wire.More(); wire.Next()) {
      const auto set = handle<StepShape_GeometricCurveSet>::DownCast(
          STEPConstruct::FindEntity(process, wire.Current()));
      if (set.IsNull() || !runsForward(wire.Current())) continue;
      const Segments segments = segmentsOf(*set, wire.Current().NbChildren(), styled);
      if (segments.empty()) continue;
      const handle<StepGeom_CompositeCurve> curve = joined(segments);
      replaceElements(*set, curve);
      model->AddWithRefs(curve);
    }
}

}  // namespace seamwright::occ
