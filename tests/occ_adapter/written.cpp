// SPDX-License-Identifier: LGPL-2.1-or-later
#include "written.hpp"

#include <gmock/gmock.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <seamwright/occ_adapter/model/read.hpp>

#include "shapes.hpp"

namespace seamwright::test {

namespace fs = std::filesystem;
using occ::Model;

Spline splineOf(const TopoDS_Shape& shape, int face) {
  TopLoc_Location placement;
  return Spline::DownCast(
      BRep_Tool::Surface(TopoDS::Face(partsOf(shape, TopAbs_FACE)(face)), placement));
}

std::vector<double> numbersOf(const Spline& spline) {
  std::vector<double> numbers;
  for (int i = 1; i <= spline->NbUPoles(); ++i)
    for (int k = 1; k <= spline->NbVPoles(); ++k) {
      const gp_Pnt pole = spline->Pole(i, k);
      numbers.insert(numbers.end(), {pole.X(), pole.Y(), pole.Z(), spline->Weight(i, k)});
    }
  for (int i = 1; i <= spline->NbUKnots(); ++i) numbers.push_back(spline->UKnot(i));
  for (int i = 1; i <= spline->NbVKnots(); ++i) numbers.push_back(spline->VKnot(i));
  return numbers;
}

TopoDS_Shape roundedBox() {
  const TopoDS_Shape block = box();
  BRepFilletAPI_MakeFillet rounding(block);
  const TopTools_IndexedMapOfShape edges = partsOf(block, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) rounding.Add(2, TopoDS::Edge(edges(i)));
  return rounding.Shape();
}

TopoDS_Shape splineBox() {
  return BRepBuilderAPI_NurbsConvert(box(), true).Shape();
}

TopoDS_Shape copied(const TopoDS_Shape& shape) {
  return BRepBuilderAPI_Copy(shape, true).Shape();
}

Model written(const Model& model, const fs::path& path, const occ::WriteOptions& options) {
  occ::writeModel(model, path, options);
  return occ::readModel(path);
}

occ::ModelError errorOfWriting(const Model& model, const fs::path& path,
                               const occ::WriteOptions& options) {
  try {
    occ::writeModel(model, path, options);
  } catch (const occ::ModelError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(path.string()));
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error;
  }
  throw std::runtime_error(path.string() + " was written");
}

std::string attributesOf(const Model& model) {
  std::ostringstream text;
  for (const occ::ShapeAttribute& a : model.attributes) {
    text << a.kind << ' ' << a.index << " '" << a.name << "'";
    if (a.color)
      for (const double share : *a.color) text << ' ' << std::lround(share * 1e6);
    for (const std::string& layer : a.layers) text << " on " << layer;
    text << '\n';
  }
  return text.str();
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

void expectSameSeams(const Model& a, const Model& b, double noise) {
  const occ::Report one = occ::analyze(a), other = occ::analyze(b);
  ASSERT_EQ(one.seams.size(), other.seams.size());
  for (std::size_t i = 0; i < one.seams.size(); ++i) {
    const occ::SeamResult &x = one.seams[i], &y = other.seams[i];
    SCOPED_TRACE(describe(x) + " / " + describe(y));
    EXPECT_EQ(x.verdict.level, y.verdict.level);
    EXPECT_EQ(x.verdict.seam_class, y.verdict.seam_class);
    EXPECT_NEAR(x.length_mm, y.length_mm, noise * (1 + x.length_mm));
  }
}

void expectSameModel(const Model& a, const Model& b, double noise) {
  for (const TopAbs_ShapeEnum kind :
       {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX})
    EXPECT_EQ(partsOf(a.shape, kind).Extent(), partsOf(b.shape, kind).Extent()) << kind;
  EXPECT_EQ(attributesOf(a), attributesOf(b));
  EXPECT_EQ(a.length_unit, b.length_unit);
  expectSameSeams(a, b, noise);
}

void bend(const TopoDS_Shape& shape, int face) {
  const Spline spline = splineOf(shape, face);
  spline->IncreaseDegree(3, 3);
  spline->SetPole(2, 2, spline->Pole(2, 2).Translated(gp_Vec(0.125, 0.25, 0.5)));
}

}  // namespace seamwright::test
