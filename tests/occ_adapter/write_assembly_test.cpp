// SPDX-License-Identifier: LGPL-2.1-or-later
// Assemblies written and read back: the same names, colours, layers and instances.
#include <gmock/gmock.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <array>

#include "files.hpp"
#include "shapes.hpp"
#include "written.hpp"

namespace seamwright::test {
namespace {

namespace fs = std::filesystem;
using occ::Model;
using occ::ModelErrc;
using occ::readModel;
using occ::writeModel;
using occ::WriteReport;
using ::testing::HasSubstr;

/// Two blocks of one part and a rod, with names, colours and layers, in an assembly.
/// \param positions of the blocks along x.
void writeAssembly(const fs::path& path, const std::array<double, 2>& positions = {0, 50}) {
  const opencascade::handle<TDocStd_Document> document = new TDocStd_Document("BinXCAF");
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto layers = XCAFDoc_DocumentTool::LayerTool(document->Main());
  const TopoDS_Shape block = splineBox(), rod = BRepPrimAPI_MakeCylinder(2, 9).Shape();
  const TDF_Label part = shapes->AddShape(block, false), other = shapes->AddShape(rod, false);
  TDataStd_Name::Set(part, TCollection_ExtendedString("Bl\u00f6ck", true));
  TDataStd_Name::Set(other, "rod");
  colors->SetColor(part, Quantity_Color(0.25, 0.5, 0.75, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  const TDF_Label lid = shapes->AddSubShape(part, partsOf(block, TopAbs_FACE)(3));
  colors->SetColor(lid, Quantity_Color(1, 0, 0, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
  layers->SetLayer(part, "Karosserie");
  layers->SetLayer(lid, "Deckel");
  const TDF_Label assembly = shapes->NewShape();
  TDataStd_Name::Set(assembly, "whole");
  for (const double x : positions) {
    gp_Trsf away, turn;
    away.SetTranslation(gp_Vec(x, 0, 7));
    turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(1, 2, 3)), 0.3 + x);
    shapes->AddComponent(assembly, part, TopLoc_Location(away * turn));
  }
  shapes->AddComponent(assembly, other, TopLoc_Location());
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  writer.SetLayerMode(true);
  if (!writer.Transfer(document, STEPControl_AsIs) ||
      writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("not written");
}

class Assembly : public ::testing::Test {
 protected:
  Assembly() {
    writeAssembly(folder_ / "whole.step");
    model_ = readModel(folder_ / "whole.step");
  }

  void expectStructure(const fs::path& path) const {
    const std::string old = contentOf(folder_ / "whole.step"), now = contentOf(path);
    for (const char* entity :
         {"NEXT_ASSEMBLY_USAGE_OCCURRENCE(", "= PRODUCT(", "MANIFOLD_SOLID_BREP(", "ADVANCED_FACE(",
          "PRESENTATION_LAYER_ASSIGNMENT("})
      EXPECT_EQ(occurrences(now, entity), occurrences(old, entity)) << entity;
  }

  const Folder folder_;
  Model model_;
};

TEST_F(Assembly, LayersAreRead) {
  const std::string attributes = attributesOf(model_);
  EXPECT_THAT(attributes, HasSubstr("on Karosserie"));
  EXPECT_THAT(attributes, HasSubstr("on Deckel"));
  EXPECT_THAT(attributes, HasSubstr("Bl\u00f6ck"));
}

TEST_F(Assembly, ComesBackAsItWas) {
  const Model back = written(model_, folder_ / "back.step");
  expectSameModel(model_, back, 1e-9);
  expectStructure(folder_ / "back.step");
  expectSameModel(model_, written(back, folder_ / "again.step"), 1e-9);
}

TEST_F(Assembly, APartChangedInAllItsPlacesStaysOnePart) {
  Model changed = model_;
  changed.shape = copied(model_.shape);
  ASSERT_EQ(partsOf(changed.shape, TopAbs_FACE).Extent(), 6 + 6 + 3);
  bend(changed.shape, 2);
  bend(changed.shape, 8);
  const std::vector<double> numbers = numbersOf(splineOf(changed.shape, 2));
  const WriteReport report = writeModel(changed, folder_ / "bent.step");
  EXPECT_TRUE(report.followed_source);
  EXPECT_EQ(report.changed_faces, 1);
  EXPECT_EQ(report.changed_edges, 0) << "the faces' edges lie where they lay";
  EXPECT_EQ(report.changed_vertices, 0);
  const Model back = readModel(folder_ / "bent.step");
  expectStructure(folder_ / "bent.step");
  expectSameModel(changed, back, 1e-6);
  for (const int face : {2, 8}) EXPECT_EQ(numbersOf(splineOf(back.shape, face)), numbers) << face;
}

/// As in files that have a part twice by mistake: two placements with one transformation.
TEST(TwiceInOnePlace, APartIsChangedInBoth) {
  const Folder folder;
  writeAssembly(folder / "twice.step", {20, 20});
  Model changed = readModel(folder / "twice.step");
  bend(changed.shape, 2);
  const WriteReport report = writeModel(changed, folder / "bent.step");
  EXPECT_TRUE(report.followed_source);
  EXPECT_EQ(report.changed_faces, 1);
  EXPECT_EQ(numbersOf(splineOf(readModel(folder / "bent.step").shape, 2)),
            numbersOf(splineOf(changed.shape, 2)));
}

TEST_F(Assembly, APlaceChangedAloneIsAnErrorWithItsFaces) {
  TopoDS_Compound compound;
  BRep_Builder().MakeCompound(compound);
  const TopTools_IndexedMapOfShape solids = partsOf(model_.shape, TopAbs_SOLID);
  ASSERT_EQ(solids.Extent(), 3);
  // The shape of the file is a compound of its parts in their positions.
  ASSERT_EQ(model_.shape.ShapeType(), TopAbs_COMPOUND);
  for (int i = 1; i <= 3; ++i) {
    TopoDS_Shape solid = solids(i);
    if (i == 2) {
      solid = copied(solid.Located(TopLoc_Location())).Located(solid.Location());
      bend(solid, 2);
    }
    BRep_Builder().Add(compound, solid);
  }
  Model changed = model_;
  changed.shape = compound.Oriented(model_.shape.Orientation());
  const occ::ModelError error = errorOfWriting(changed, folder_ / "odd.step");
  EXPECT_EQ(error.code(), ModelErrc::UnlikeInstances);
  EXPECT_THAT(error.what(), HasSubstr("faces 2 and 8"));
  EXPECT_FALSE(fs::exists(folder_ / "odd.step"));
  const WriteReport report = writeModel(changed, folder_ / "odd.step", {.afresh = true});
  EXPECT_FALSE(report.followed_source);
  const Model back = readModel(folder_ / "odd.step");
  expectSameSeams(changed, back, 1e-6);
  EXPECT_THAT(attributesOf(back), HasSubstr("Bl\u00f6ck"));
  EXPECT_THAT(attributesOf(back), HasSubstr("on Deckel"));
}

TEST_F(Assembly, APlaceCopiedButAlikeIsNoChange) {
  Model same = model_;
  same.shape = copied(model_.shape);
  const WriteReport report = writeModel(same, folder_ / "same.step");
  EXPECT_TRUE(report.followed_source);
  EXPECT_EQ(report.changed_faces + report.changed_edges + report.changed_vertices, 0);
  expectStructure(folder_ / "same.step");
}

}  // namespace
}  // namespace seamwright::test
