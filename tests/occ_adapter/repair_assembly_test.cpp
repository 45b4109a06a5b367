// SPDX-License-Identifier: LGPL-2.1-or-later
// What a file says of its parts comes through a repair: names, colours, layers, unit, order and
// positions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Bnd_Box.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <stdexcept>

#include "files.hpp"
#include "grids.hpp"
#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/occt_version.hpp>

namespace seamwright::test {
namespace {

/// A sheet of four patches with broken seams and a box that stands twice, in inches.
void writeAssembly(const std::filesystem::path& path) {
  std::mt19937 generator(testSeed(1));
  const Patches patches = cutUp(sheet(generator, 9, 9, 3, 3), {0, 0.5, 1}, {0, 0.5, 1});
  // Only inside: the sides stay where they meet.
  for (const auto& row : patches)
    for (const Spline& patch : row)
      for (int i = 2; i < patch->NbUPoles(); ++i)
        for (int j = 2; j < patch->NbVPoles(); ++j)
          patch->SetPole(i, j, patch->Pole(i, j).Translated(gp_Vec(0, 0, random(generator, 0.05))));
  const opencascade::handle<TDocStd_Document> document = new TDocStd_Document("BinXCAF");
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto layers = XCAFDoc_DocumentTool::LayerTool(document->Main());
  const TopoDS_Shape grid = gridOf(patches, 1e-6), box = BRepPrimAPI_MakeBox(5, 6, 7).Shape();
  const TDF_Label skin = shapes->AddShape(grid, false), block = shapes->AddShape(box, false);
  TDataStd_Name::Set(skin, "skin");
  TDataStd_Name::Set(block, "block");
  colors->SetColor(block, Quantity_Color(0.25, 0.5, 0.75, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  const TDF_Label patch = shapes->AddSubShape(skin, partsOf(grid, TopAbs_FACE)(2));
  colors->SetColor(patch, Quantity_Color(1, 0, 0, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  layers->SetLayer(skin, "outside");
  const TDF_Label whole = shapes->NewShape();
  TDataStd_Name::Set(whole, "whole");
  for (const double z : {-100.0, -50.0}) {
    gp_Trsf away;
    away.SetTranslation(gp_Vec(0, 0, z));
    shapes->AddComponent(whole, block, TopLoc_Location(away));
  }
  shapes->AddComponent(whole, skin, TopLoc_Location());
  shapes->UpdateAssemblies();
  Interface_Static::SetCVal("write.step.unit", "INCH");  // taken note of when the writer is made
  STEPCAFControl_Writer writer;
  occ::keepLengthUnit(writer.ChangeWriter());
  Interface_Static::SetCVal("write.step.unit", "MM");
  if (!writer.Transfer(document, STEPControl_AsIs) ||
      writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("not written");
}

void expectSameParts(const occ::Model& a, const occ::Model& b) {
  EXPECT_EQ(a.length_unit, b.length_unit);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    const occ::ShapeAttribute &one = a.attributes[i], &other = b.attributes[i];
    EXPECT_EQ(one.kind, other.kind);
    EXPECT_EQ(one.index, other.index);
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.color, other.color);
    EXPECT_EQ(one.layers, other.layers);
  }
  const TopTools_IndexedMapOfShape faces = partsOf(a.shape, TopAbs_FACE),
                                   others = partsOf(b.shape, TopAbs_FACE);
  ASSERT_EQ(faces.Extent(), others.Extent());
  for (int f = 1; f <= faces.Extent(); ++f) {
    Bnd_Box one, other;
    BRepBndLib::AddOptimal(faces(f), one, false, false);
    BRepBndLib::AddOptimal(others(f), other, false, false);
    EXPECT_LT(one.CornerMin().Distance(other.CornerMin()), 0.1) << f;
    EXPECT_LT(one.CornerMax().Distance(other.CornerMax()), 0.1) << f;
  }
}

TEST(RepairAssembly, KeepsWhatTheFileSaysOfItsParts) {
  const Folder folder;
  writeAssembly(folder / "whole.step");
  const occ::Model model = occ::readModel(folder / "whole.step");
  ASSERT_EQ(model.faceCount(), 16);
  ASSERT_GE(model.attributes.size(), 4);
  const occ::RepairReport report = occ::repair(model);
  EXPECT_EQ(repairedSeams(report), 4) << reasonsOf(report);
  expectSameParts(model, report.model);
  const occ::WriteReport written = occ::writeModel(report.model, folder / "out.step");
  EXPECT_TRUE(written.followed_source);
  const occ::Model back = occ::readModel(folder / "out.step");
  expectSameParts(model, back);
  EXPECT_TRUE(analyzed(back.shape).passed());
  EXPECT_FALSE(analyzed(model.shape).passed());
  const auto uses = [&](const std::string& name) {
    const std::string text = contentOf(folder / name), entity = "NEXT_ASSEMBLY_USAGE_OCCURRENCE(";
    int count = 0;
    for (std::size_t at = text.find(entity); at != std::string::npos;
         at = text.find(entity, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(uses("whole.step"), 3);
  EXPECT_EQ(uses("out.step"), 3);
}

}  // namespace
}  // namespace seamwright::test
