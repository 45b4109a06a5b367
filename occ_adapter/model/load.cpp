// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_BasicEditor.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <NCollection_DataMap.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <fstream>
#include <map>

#include <seamwright/occ_adapter/model/load.hpp>
#include <seamwright/occ_adapter/model/lost_faces.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

/// Collects names, colours and layers of a document for the parts of one shape.
class AttributeCollector {
 public:
  AttributeCollector(const TopoDS_Shape& shape,
                     const opencascade::handle<TDocStd_Document>& document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        layers_(XCAFDoc_DocumentTool::LayerTool(document->Main())) {
    for (const TopAbs_ShapeEnum kind :
         {TopAbs_COMPOUND, TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE})
      addParts(shape, kind);
  }

  std::vector<ShapeAttribute> collect() {
    TDF_LabelSequence labels;
    shapes_->GetShapes(labels);
    for (const TDF_Label& label : labels) {
      take(label);
      TDF_LabelSequence parts;
      shapes_->GetSubShapes(label, parts);
      for (const TDF_Label& part : parts) take(part);
    }
    std::vector<ShapeAttribute> result;
    for (auto& [number, attribute] : found_) result.push_back(std::move(attribute));
    return result;
  }

 private:
  using PartNumber = std::pair<TopAbs_ShapeEnum, int>;

  void addParts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, kind, map);
    for (int i = 1; i <= map.Extent(); ++i)
      parts_.emplace(map(i).TShape().get(), PartNumber(kind, i));
  }

  void take(const TDF_Label& label) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (shape.IsNull()) return;
    const std::string name = nameOf(label);
    const std::optional<std::array<double, 3>> color = colorOf(label);
    const std::vector<std::string> layers = layersOf(label);
    if (name.empty() && !color && layers.empty()) return;
    const auto [begin, end] = parts_.equal_range(shape.TShape().get());
    for (auto it = begin; it != end; ++it) {
      const PartNumber& number = it->second;
      ShapeAttribute& attribute = found_[number];
      attribute.kind = number.first;
      attribute.index = number.second;
      if (!name.empty()) attribute.name = name;
      if (color) attribute.color = color;
      if (!layers.empty()) attribute.layers = layers;
    }
  }

  static std::string nameOf(const TDF_Label& label) {
    opencascade::handle<TDataStd_Name> name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
    return TCollection_AsciiString(name->Get()).ToCString();
  }

  std::optional<std::array<double, 3>> colorOf(const TDF_Label& label) const {
    Quantity_Color color;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv})
      if (colors_->GetColor(label, type, color))
        return std::array<double, 3>{color.Red(), color.Green(), color.Blue()};
    return std::nullopt;
  }

  std::vector<std::string> layersOf(const TDF_Label& label) const {
    std::vector<std::string> names;
    opencascade::handle<TColStd_HSequenceOfExtendedString> layers;
    if (!layers_->GetLayers(label, layers)) return names;
    for (const TCollection_ExtendedString& layer : *layers)
      names.emplace_back(TCollection_AsciiString(layer).ToCString());
    std::sort(names.begin(), names.end());
    return names;
  }

  opencascade::handle<XCAFDoc_ShapeTool> shapes_;
  opencascade::handle<XCAFDoc_ColorTool> colors_;
  opencascade::handle<XCAFDoc_LayerTool> layers_;
  std::multimap<const void*, PartNumber> parts_;
  std::map<PartNumber, ShapeAttribute> found_;
};

void requireParts(const TopoDS_Shape& shape, const std::filesystem::path& path, Needed needed) {
  if (shape.IsNull()) throw ModelError(ModelErrc::NoShapes, path, "holds no shapes");
  if (needed == Needed::Faces && !TopExp_Explorer(shape, TopAbs_FACE).More())
    throw ModelError(ModelErrc::NoShapes, path, "holds no faces, so it has no seams");
  if (needed == Needed::Edges && !TopExp_Explorer(shape, TopAbs_EDGE).More())
    throw ModelError(ModelErrc::NoShapes, path, "holds no edges");
}

/// A length unit that was read without a fault: an unknown prefix would silently become none.
bool isLengthUnit(const opencascade::handle<Interface_InterfaceModel>& entities, int i) {
  if (entities->IsErrorEntity(i)) return false;
  const opencascade::handle<Standard_Transient> entity = entities->Value(i);
  if (const auto si = opencascade::handle<StepBasic_SiUnitAndLengthUnit>::DownCast(entity);
      !si.IsNull())
    return si->Name() == StepBasic_sunMetre;
  return entity->IsKind(STANDARD_TYPE(StepBasic_ConversionBasedUnitAndLengthUnit));
}

/// The name of the unit that the shapes are given in.
std::string stepLengthUnit(STEPControl_Reader& reader, const std::filesystem::path& path) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  const opencascade::handle<Interface_InterfaceModel> entities = reader.Model();
  const bool understood = !lengths.IsEmpty() && !lengths.First().IsEmpty();
  for (int i = 1; understood && i <= entities->NbEntities(); ++i)
    if (isLengthUnit(entities, i)) return lengths.First().ToCString();
  throw ModelError(ModelErrc::UnknownUnits, path,
                   "names no length unit that is understood: sizes would be a guess");
}

LoadedDocument loadStep(const std::filesystem::path& path, const Message_ProgressRange& range,
                        Needed needed) {
  LoadedDocument loaded;
  Model& model = loaded.model;
  const auto owner = std::make_shared<STEPCAFControl_Reader>();
  STEPCAFControl_Reader& reader = *owner;
  loaded.reader = owner;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(true);
  reader.SetSHUOMode(true);
  // Since 7.8 OpenCASCADE opens only files whose names are UTF-8.
  std::ifstream file(path, std::ios::binary);
  if (reader.ChangeReader().ReadStream(path.c_str(), file) != IFSelect_RetDone)
    throw ModelError(ModelErrc::Malformed, path, "is malformed STEP: OpenCASCADE can't read it");
  const bool transferred = reader.Transfer(loaded.document, range);
  if (transferred) model.shape = reader.ChangeReader().OneShape();
  requireParts(model.shape, path, needed);
  model.length_unit = stepLengthUnit(reader.ChangeReader(), path);
  noteLostFaces(reader.ChangeReader(), model);
  model.attributes = AttributeCollector(model.shape, loaded.document).collect();
  loaded.entities = reader.ChangeReader().Model();
  return loaded;
}

void requireIgesLengthUnit(const IGESData_GlobalSection& global,
                           const std::filesystem::path& path) {
  const int flag = global.UnitFlag();
  const opencascade::handle<TCollection_HAsciiString> unit = global.UnitName();
  const bool named = !unit.IsNull() && IGESData_BasicEditor::UnitNameFlag(unit->ToCString()) > 0;
  if (flag >= 1 && flag <= 11 && (flag != 3 || named)) return;
  throw ModelError(ModelErrc::UnknownUnits, path,
                   "has length unit " + std::to_string(flag) +
                       (unit.IsNull() ? "" : " '" + std::string(unit->ToCString()) + "'") +
                       ", which IGES does not define: sizes would be a guess");
}

LoadedDocument loadIges(const std::filesystem::path& path, const Message_ProgressRange& range,
                        Needed needed) {
  LoadedDocument loaded;
  Model& model = loaded.model;
  const auto owner = std::make_shared<IGESCAFControl_Reader>();
  IGESCAFControl_Reader& reader = *owner;
  loaded.reader = owner;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(true);
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw ModelError(ModelErrc::Malformed, path, "is malformed IGES: OpenCASCADE can't read it");
  const IGESData_GlobalSection& global = reader.IGESModel()->GlobalSection();
  requireIgesLengthUnit(global, path);
  model.length_unit = IGESData_BasicEditor::UnitFlagName(global.UnitFlag());
  if (reader.Transfer(loaded.document, range)) model.shape = reader.OneShape();
  requireParts(model.shape, path, needed);
  noteLostFaces(reader, model);
  model.attributes = AttributeCollector(model.shape, loaded.document).collect();
  loaded.entities = reader.IGESModel();
  return loaded;
}

/// Beyond the end of a file OpenCASCADE goes on reading, with whatever is in memory and as often as
/// a count says; so the stream throws where there is nothing to read.
std::ifstream strictStream(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  file.exceptions(std::ios::failbit | std::ios::badbit);
  return file;
}

/// What \p read makes of the file; a null shape if the file ends too soon.
template <class Read>
TopoDS_Shape readStream(const std::filesystem::path& path, const Read& read) {
  std::ifstream file = strictStream(path);
  try {
    return read(file);
  } catch (const std::ios::failure&) {
    return {};
  }
}

TopoDS_Shape loadBrep(const std::filesystem::path& path, const Message_ProgressRange& range) {
  return readStream(path, [&range](std::istream& file) {
    TopoDS_Shape shape;
    BRepTools::Read(shape, file, BRep_Builder(), range);
    return shape;
  });
}

TopoDS_Shape loadBinaryBrep(const std::filesystem::path& path, const Message_ProgressRange& range) {
  const TopoDS_Shape plain = readStream(path, [&range](std::istream& file) {
    TopoDS_Shape shape;
    try {
      BinTools::Read(shape, file, range);
    } catch (const Standard_Failure&) {
      shape.Nullify();
    }
    return shape;
  });
  // What FreeCAD writes under the same heading ends in another way.
  return plain.IsNull() ? readStream(path, readBinaryShape) : plain;
}

}  // namespace

LoadedDocument loadDocument(const std::filesystem::path& path, const std::string& format,
                            const Progress& progress, Needed needed) {
  const opencascade::handle<Reporter> reporter = new Reporter(progress);
  LoadedDocument loaded = format == "STEP" ? loadStep(path, reporter->Start(), needed)
                                           : loadIges(path, reporter->Start(), needed);
  loaded.model.format = format;
  return loaded;
}

Model loadModel(const std::filesystem::path& path, const std::string& format,
                const Progress& progress, Needed needed) {
  Model model;
  if (format == "STEP" || format == "IGES") {
    model = loadDocument(path, format, progress, needed).model;
    noteUnusableParts(model);
    return model;
  }
  model.format = format;
  model.length_unit = "mm (assumed)";
  const opencascade::handle<Reporter> reporter = new Reporter(progress);
  const Message_ProgressRange range = reporter->Start();
  model.shape = format == "BREP" ? loadBrep(path, range) : loadBinaryBrep(path, range);
  if (model.shape.IsNull())
    throw ModelError(ModelErrc::Malformed, path,
                     "is malformed or truncated " + format + ": OpenCASCADE can't read it");
  requireParts(model.shape, path, needed);
  noteUnusableParts(model);
  return model;
}

}  // namespace seamwright::occ
