// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <HeaderSection_FileDescription.hxx>
#include <HeaderSection_FileName.hxx>
#include <HeaderSection_FileSchema.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUncertaintyAssignedContext.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include <seamwright/occ_adapter/model/carry.hpp>
#include <seamwright/occ_adapter/model/load.hpp>
#include <seamwright/occ_adapter/model/real_text.hpp>
#include <seamwright/occ_adapter/model/step_wires.hpp>
#include <seamwright/occ_adapter/model/store.hpp>
#include <seamwright/occ_adapter/occt_version.hpp>

namespace seamwright::occ {

namespace {

using Document = opencascade::handle<TDocStd_Document>;

struct LengthUnit {
  const char* name = "";  ///< as OpenCASCADE's parameters call it
  double mm = 1;
  std::array<std::string_view, 4> spellings;
};

constexpr std::array<LengthUnit, 10> length_units = {
    {{"MM", 1, {"mm", "millimetre", "millimeter", ""}},
     {"INCH", 25.4, {"in", "inch", "inches", ""}},
     {"M", 1000, {"m", "metre", "meter", ""}},
     {"CM", 10, {"cm", "centimetre", "centimeter", ""}},
     {"FT", 304.8, {"ft", "foot", "feet", ""}},
     {"UM", 1e-3, {"um", "micrometre", "micrometer", "micron"}},
     {"MIL", 0.0254, {"mil", "", "", ""}},
     {"UIN", 25.4e-6, {"uin", "microinch", "", ""}},
     {"KM", 1e6, {"km", "kilometre", "kilometer", ""}},
     {"MI", 1609344, {"mi", "mile", "", ""}}}};

/// What a file of a source says of itself beside its shapes. What it does not say is left to the
/// defaults.
struct Manner {
  std::string unit = "MM";
  std::string schema = "AP214IS";
  std::optional<double> accuracy_mm;
  opencascade::handle<HeaderSection_FileName> file_name;
  opencascade::handle<HeaderSection_FileDescription> description;
  bool iges_solids = true;  ///< solids and shells keep their topology
  std::vector<std::string> notes;
};

void chooseUnit(Manner& manner, double mm) {
  for (const LengthUnit& unit : length_units)
    // Files give a unit with seven digits or so, and no two units are so near.
    if (std::abs(unit.mm - mm) <= 1e-6 * mm) {
      manner.unit = unit.name;
      return;
    }
  manner.notes.push_back(fmt::format(
      "the length unit of the source is {:.6g} mm, which OpenCASCADE can't write: written in mm",
      mm));
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void chooseUnit(Manner& manner, const std::string& name) {
  if (name.empty() || name.starts_with("mm")) return;
  for (const LengthUnit& unit : length_units)
    if (std::count(unit.spellings.begin(), unit.spellings.end(), lowerCase(name)) > 0) {
      manner.unit = unit.name;
      return;
    }
  manner.notes.push_back("the length unit '" + name +
                         "' is not one OpenCASCADE can write: written in mm");
}

void chooseSchema(Manner& manner, const opencascade::handle<HeaderSection_FileSchema>& schema) {
  if (schema.IsNull() || schema->NbSchemaIdentifiers() < 1) return;
  const std::string name = schema->SchemaIdentifiersValue(1)->ToCString();
  if (name.starts_with("CONFIG_CONTROL_DESIGN"))
    manner.schema = "AP203";
  else if (name.starts_with("AP242"))
    manner.schema = "AP242DIS";
  else if (!name.starts_with("AUTOMOTIVE_DESIGN"))
    manner.notes.push_back("OpenCASCADE can't write schema " +
                           name.substr(0, name.find_first_of(" {")) + ": written as AP214");
}

struct Contexts {
  opencascade::handle<StepRepr_GlobalUnitAssignedContext> units;
  opencascade::handle<StepRepr_GlobalUncertaintyAssignedContext> accuracy;
};

/// Units and accuracy that a representation is given in, if the entity is a context of one.
Contexts contextsOf(const opencascade::handle<Standard_Transient>& entity) {
  using WithAccuracy = StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx;
  using WithUnits = StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext;
  if (const auto both = opencascade::handle<WithAccuracy>::DownCast(entity); !both.IsNull())
    return {both->GlobalUnitAssignedContext(), both->GlobalUncertaintyAssignedContext()};
  if (const auto units = opencascade::handle<WithUnits>::DownCast(entity); !units.IsNull())
    return {units->GlobalUnitAssignedContext(), {}};
  return {};
}

Manner mannerOfStep(const opencascade::handle<StepData_StepModel>& model) {
  Manner manner;
  const APIHeaderSection_MakeHeader header(model);
  manner.file_name = header.FnValue();
  manner.description = header.FdValue();
  chooseSchema(manner, header.FsValue());
  std::set<double> units, accuracies;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Contexts contexts = contextsOf(model->Value(i));
    STEPConstruct_UnitContext factors;
    if (contexts.units.IsNull() || !computeUnitFactors(factors, contexts.units)) continue;
    if (units.empty()) chooseUnit(manner, factors.LengthFactor());
    units.insert(factors.LengthFactor());
    if (contexts.accuracy.IsNull() || factors.ComputeTolerance(contexts.accuracy) != 0) continue;
    if (factors.HasUncertainty()) accuracies.insert(factors.Uncertainty() * factors.LengthFactor());
  }
  if (units.size() > 1)
    manner.notes.push_back("the source has several length units: written in the first");
  if (!accuracies.empty()) manner.accuracy_mm = *accuracies.begin();
  return manner;
}

/// Type numbers of IGES: manifold solid B-rep object, shell, face.
constexpr std::array brep_types = {186, 514, 510};

Manner mannerOfIges(const IGESData_IGESModel& model) {
  Manner manner;
  chooseUnit(manner, model.GlobalSection().UnitValue());
  manner.iges_solids = false;
  for (int i = 1; i <= model.NbEntities() && !manner.iges_solids; ++i)
    manner.iges_solids =
        std::count(brep_types.begin(), brep_types.end(), model.Entity(i)->TypeNumber()) > 0;
  return manner;
}

Manner mannerOf(const LoadedDocument& source) {
  if (const auto step = opencascade::handle<StepData_StepModel>::DownCast(source.entities);
      !step.IsNull())
    return mannerOfStep(step);
  return mannerOfIges(*opencascade::handle<IGESData_IGESModel>::DownCast(source.entities));
}

/// The same shape as files can hold it. A placed root would be written as an assembly of one, so
/// its placement is handed down to its parts. Loose faces would be written each with edges of its
/// own, so those that share edges get a shell.
class Writable {
 public:
  explicit Writable(const TopoDS_Shape& shape) : shape_(withShells(withoutPlacement(shape))) {}

  const TopoDS_Shape& shape() const { return shape_; }

  /// What a part was before it was made again.
  const void* origin(const TopoDS_Shape& part) const {
    const auto found = origins_.find(part.TShape().get());
    return found == origins_.end() ? part.TShape().get() : found->second;
  }

 private:
  TopoDS_Shape emptied(const TopoDS_Shape& shape) {
    TopoDS_Shape result = shape.EmptyCopied();
    const void* const before = origin(shape);
    origins_[result.TShape().get()] = before;
    return result.Oriented(TopAbs_FORWARD);
  }

  TopoDS_Shape withoutPlacement(const TopoDS_Shape& shape) {
    if (shape.Location().IsIdentity() || shape.ShapeType() > TopAbs_SHELL) return shape;
    TopoDS_Shape result = emptied(shape);
    result.Location({});
    for (TopoDS_Iterator part(shape, false, true); part.More(); part.Next())
      BRep_Builder().Add(result, part.Value());
    return result.Oriented(shape.Orientation());
  }

  TopoDS_Shape withShells(const TopoDS_Shape& shape) {
    if (shape.ShapeType() != TopAbs_COMPOUND) return shape;
    std::vector<TopoDS_Shape> parts;
    bool same = true;
    for (TopoDS_Iterator part(shape, false, false); part.More(); part.Next()) {
      parts.push_back(withShells(part.Value()));
      same = same && parts.back().IsSame(part.Value());
    }
    const std::vector<std::size_t> groups = groupsOf(parts);
    for (std::size_t i = 0; i < parts.size(); ++i) same = same && groups[i] == i;
    if (same) return shape;
    TopoDS_Shape result = emptied(shape);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (groups[i] == i) BRep_Builder().Add(result, joined(parts, groups, i));
    return result.Oriented(shape.Orientation());
  }

  /// For each part the first of those that it hangs together with, which is another one for faces
  /// only.
  static std::vector<std::size_t> groupsOf(const std::vector<TopoDS_Shape>& parts) {
    std::vector<std::size_t> group(parts.size());
    std::map<const void*, std::size_t> first;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      group[i] = i;
      if (parts[i].ShapeType() != TopAbs_FACE) continue;
      for (TopExp_Explorer edge(parts[i], TopAbs_EDGE); edge.More(); edge.Next()) {
        const std::size_t other =
            group[first.emplace(edge.Current().TShape().get(), i).first->second];
        const std::size_t low = std::min(group[i], other), high = std::max(group[i], other);
        std::replace(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(i) + 1, high, low);
      }
    }
    return group;
  }

  static TopoDS_Shape joined(const std::vector<TopoDS_Shape>& parts,
                             const std::vector<std::size_t>& groups, std::size_t group) {
    if (std::count(groups.begin(), groups.end(), group) == 1) return parts[group];
    TopoDS_Shell shell;
    BRep_Builder().MakeShell(shell);
    for (std::size_t i = group; i < parts.size(); ++i)
      if (groups[i] == group) BRep_Builder().Add(shell, parts[i]);
    shell.Closed(BRep_Tool::IsClosed(shell));
    return shell;
  }

  std::map<const void*, const void*> origins_;
  TopoDS_Shape shape_;
};

/// A document of a shape and of attributes that are identified by kind and number.
class NewDocument {
 public:
  explicit NewDocument(const Model& model)
      : model_(model),
        writable_(model.shape),
        shapes_(XCAFDoc_DocumentTool::ShapeTool(document_->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(document_->Main())),
        layers_(XCAFDoc_DocumentTool::LayerTool(document_->Main())) {
    XCAFDoc_DocumentTool::SetLengthUnit(document_, 1, UnitsMethods_LengthUnit_Millimeter);
    XCAFDoc_ShapeTool::SetAutoNaming(false);
    shapes_->AddShape(writable_.shape(), hasNamedSolids());
    findOwners();
    for (const ShapeAttribute& attribute : model.attributes) assign(attribute);
    shapes_->UpdateAssemblies();
  }

  const Document& document() const { return document_; }

 private:
  bool hasNamedSolids() const {
    return model_.shape.ShapeType() == TopAbs_COMPOUND &&
           std::any_of(model_.attributes.begin(), model_.attributes.end(),
                       [](const ShapeAttribute& attribute) {
                         return attribute.kind == TopAbs_SOLID && !attribute.name.empty();
                       });
  }

  /// Notes for each part of each shape the label that it is a part of.
  void findOwners() {
    TDF_LabelSequence labels;
    shapes_->GetShapes(labels);
    for (const TDF_Label& label : labels) {
      const TopoDS_Shape whole = XCAFDoc_ShapeTool::GetShape(label);
      if (XCAFDoc_ShapeTool::IsReference(label)) continue;
      owners_.emplace(writable_.origin(whole), Owner{label, whole});
      if (XCAFDoc_ShapeTool::IsAssembly(label)) continue;
      TopTools_IndexedMapOfShape parts;
      TopExp::MapShapes(whole, parts);
      for (int i = 1; i <= parts.Extent(); ++i)
        owners_.emplace(writable_.origin(parts(i)), Owner{label, parts(i)});
    }
  }

  TDF_Label labelOf(const TopoDS_Shape& part) {
    const auto owner = owners_.find(part.TShape().get());
    if (owner == owners_.end()) return {};
    if (XCAFDoc_ShapeTool::GetShape(owner->second.label).IsSame(owner->second.part))
      return owner->second.label;
    return shapes_->AddSubShape(owner->second.label, owner->second.part);
  }

  TopoDS_Shape partOf(const ShapeAttribute& attribute) {
    TopTools_IndexedMapOfShape& map = maps_[attribute.kind];
    if (map.IsEmpty()) TopExp::MapShapes(model_.shape, attribute.kind, map);
    return attribute.index >= 1 && attribute.index <= map.Extent() ? map(attribute.index)
                                                                   : TopoDS_Shape();
  }

  void assign(const ShapeAttribute& attribute) {
    const TopoDS_Shape part = partOf(attribute);
    const TDF_Label label = part.IsNull() ? TDF_Label() : labelOf(part);
    if (label.IsNull())
      throw ModelError(ModelErrc::NotWritten, {},
                       "has an attribute of part " + std::to_string(attribute.index) + " of kind " +
                           std::to_string(attribute.kind) + ", which its shape does not have");
    if (!attribute.name.empty())
      TDataStd_Name::Set(label, TCollection_ExtendedString(attribute.name.c_str(), true));
    if (attribute.color) {
      const auto& [red, green, blue] = *attribute.color;
      colors_->SetColor(label, Quantity_Color(red, green, blue, Quantity_TOC_RGB),
                        attribute.kind >= TopAbs_WIRE ? XCAFDoc_ColorCurv : XCAFDoc_ColorSurf);
    }
    for (const std::string& layer : attribute.layers)
      layers_->SetLayer(label, TCollection_ExtendedString(layer.c_str(), true));
  }

  struct Owner {
    TDF_Label label;
    TopoDS_Shape part;
  };

  const Model& model_;
  Writable writable_;
  Document document_ = new TDocStd_Document("BinXCAF");
  opencascade::handle<XCAFDoc_ShapeTool> shapes_;
  opencascade::handle<XCAFDoc_ColorTool> colors_;
  opencascade::handle<XCAFDoc_LayerTool> layers_;
  std::map<const void*, Owner> owners_;
  std::map<TopAbs_ShapeEnum, TopTools_IndexedMapOfShape> maps_;
};

[[noreturn]] void failToWrite(const char* format) {
  throw ModelError(ModelErrc::NotWritten, {},
                   std::string("can't be written as ") + format + ": OpenCASCADE fails");
}

/// Reals with all their digits. The writers keep them in 24 characters, which a sign and an
/// exponent of three digits would overrun; those get a digit less.
void keepAllDigits(Interface_FloatWriter& writer) {
  writer.SetFormat("%.15E");
  writer.SetFormatForRange("%.16E", 1e-99, 1e99);
}

void keepHeader(const opencascade::handle<StepData_StepModel>& model, const Manner& manner) {
  APIHeaderSection_MakeHeader header(model);
  if (const auto& old = manner.file_name; !old.IsNull()) {
    header.SetName(old->Name());
    header.SetAuthor(old->Author());
    header.SetOrganization(old->Organization());
    header.SetOriginatingSystem(old->OriginatingSystem());
    header.SetAuthorisation(old->Authorisation());
  }
  if (!manner.description.IsNull()) header.SetDescription(manner.description->Description());
}

std::vector<TopoDS_Shape> shapesOf(const Document& document) {
  TDF_LabelSequence labels;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetShapes(labels);
  std::vector<TopoDS_Shape> shapes;
  for (const TDF_Label& label : labels) shapes.push_back(XCAFDoc_ShapeTool::GetShape(label));
  return shapes;
}

std::string writeStep(const Document& document, const Manner& manner,
                      const Message_ProgressRange& range) {
  STEPCAFControl_Controller::Init();
  Interface_Static::SetCVal("write.step.schema", manner.schema.c_str());
  Interface_Static::SetCVal("write.step.unit", manner.unit.c_str());
  Interface_Static::SetIVal("write.surfacecurve.mode", 1);
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  // Where no accuracy is known, the largest tolerance of the shape: with their mean, which is
  // OpenCASCADE's way, readers bend curves to vertices that are further off.
  constexpr int largest = 1, given = 2;
  Interface_Static::SetIVal("write.precision.mode", manner.accuracy_mm ? given : largest);
  if (manner.accuracy_mm) Interface_Static::SetRVal("write.precision.val", *manner.accuracy_mm);
  STEPCAFControl_Writer writer;
  keepLengthUnit(writer.ChangeWriter());
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  writer.SetLayerMode(true);
  writer.SetSHUOMode(true);
  if (!writer.Transfer(document, STEPControl_AsIs, nullptr, range)) failToWrite("STEP");
  keepWires(writer.ChangeWriter(), shapesOf(document));
  const opencascade::handle<StepData_StepModel> model = writer.ChangeWriter().Model();
  keepHeader(model, manner);
  StepData_StepWriter text(model);
  keepAllDigits(text.FloatWriter());
  text.SendModel(
      opencascade::handle<StepData_Protocol>::DownCast(writer.ChangeWriter().WS()->Protocol()));
  std::ostringstream bytes;
  if (!text.Print(bytes)) failToWrite("STEP");
  return withShortestReals(bytes.view());
}

std::string writeIges(const Document& document, const Manner& manner,
                      const Message_ProgressRange& range) {
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("write.iges.unit", manner.unit == "UIN" ? "MM" : manner.unit.c_str());
  Interface_Static::SetIVal("write.iges.brep.mode", manner.iges_solids ? 1 : 0);
  IGESCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  writer.SetLayerMode(true);
  if (!writer.Transfer(document, range)) failToWrite("IGES");
  writer.ComputeModel();
  IGESData_IGESWriter text(writer.Model());
  keepAllDigits(text.FloatWriter());
  text.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
  std::ostringstream bytes;
  if (!text.Print(bytes)) failToWrite("IGES");
  return std::move(bytes).str();
}

/// Instances of parts, and of other assemblies, in assemblies.
int instancesOf(const Document& document) {
  TDF_LabelSequence labels;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetShapes(labels);
  int count = 0;
  for (const TDF_Label& label : labels)
    if (XCAFDoc_ShapeTool::IsAssembly(label)) count += XCAFDoc_ShapeTool::NbComponents(label);
  return count;
}

/// The document to write and how, with what was done for it.
struct Prepared {
  Document document;
  Manner manner;
  WriteReport report;
};

Prepared prepare(const Model& model, const WriteOptions& options, const Progress& progress) {
  Prepared prepared;
  const bool has_structure =
      !model.path.empty() && (model.format == "STEP" || model.format == "IGES");
  if (!has_structure || options.afresh) {
    chooseUnit(prepared.manner, model.length_unit);
    prepared.document = NewDocument(model).document();
    return prepared;
  }
  LoadedDocument source = loadDocument(model.path, model.format, progress);
  prepared.manner = mannerOf(source);
  if (const std::optional<Carried> carried = carryGeometry(model.shape, source.model.shape)) {
    prepared.document = source.document;
    prepared.report.followed_source = true;
    prepared.report.changed_faces = carried->faces;
    prepared.report.changed_edges = carried->edges;
    prepared.report.changed_vertices = carried->vertices;
    // Readers that find edges and vertices further apart than the stated accuracy make parameter
    // curves of their own.
    if (carried->largest_tolerance_mm > prepared.manner.accuracy_mm.value_or(0))
      prepared.manner.accuracy_mm = carried->largest_tolerance_mm;
    if (prepared.manner.accuracy_mm) *prepared.manner.accuracy_mm *= options.share_of_accuracy;
    return prepared;
  }
  // What the source states is about its shape, not this one: how accurate it is, and that no faces
  // share edges.
  prepared.manner.accuracy_mm.reset();
  prepared.manner.iges_solids = true;
  prepared.document = NewDocument(model).document();
  if (const int instances = instancesOf(source.document); instances > 0)
    prepared.report.notes.push_back("faces, edges or vertices are others than in " + model.path +
                                    ": written afresh, without its assembly of " +
                                    std::to_string(instances) +
                                    (instances == 1 ? " instance" : " instances"));
  return prepared;
}

}  // namespace

Stored storeModel(const Model& model, Format target, const WriteOptions& options,
                  const Progress& progress) {
  constexpr double read = 0.5;  // of the progress bar: reading takes about as long as writing
  Prepared prepared = prepare(model, options, partOf(progress, 0, read));
  const Progress rest = partOf(progress, read, 1);
  const opencascade::handle<Reporter> reporter = new Reporter(rest);
  Stored stored;
  stored.bytes = target == Format::Step
                     ? writeStep(prepared.document, prepared.manner, reporter->Start())
                     : writeIges(prepared.document, prepared.manner, reporter->Start());
  stored.report = std::move(prepared.report);
  stored.report.format = target;
  stored.report.notes.insert(stored.report.notes.end(), prepared.manner.notes.begin(),
                             prepared.manner.notes.end());
  return stored;
}

}  // namespace seamwright::occ
