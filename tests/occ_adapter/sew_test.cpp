// SPDX-License-Identifier: LGPL-2.1-or-later
// Loose faces that become shells. What is expected is known of the shells and solids that were
// taken apart.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gp_Pln.hxx>
#include <numbers>
#include <set>
#include <sstream>

#include "dense_oracle.hpp"
#include "files.hpp"
#include "match_pairs.hpp"
#include "repair_checks.hpp"
#include "repair_trials.hpp"
#include "shapes.hpp"
#include "support/random.hpp"

#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

namespace seamwright::test {
namespace {

using occ::modelFromShape;
using occ::repair;
using occ::RepairOptions;
using occ::RepairReport;
using std::numbers::pi;

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  return partsOf(shape, kind).Extent();
}

double volume_mm3(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

/// The kinds of the reasons of seams that were to be sewn and are not.
std::set<occ::SewFault> faultsOf(const RepairReport& report) {
  std::set<occ::SewFault> faults;
  for (const occ::SeamRepair& seam : report.seams)
    if (!seam.not_sewn.empty()) faults.insert(seam.not_sewn.fault);
  return faults;
}

std::string whyNot(const RepairReport& report) {
  std::string text;
  for (const occ::SeamRepair& seam : report.seams)
    if (!seam.not_sewn.empty()) text += describe(seam.before) + ": " + seam.not_sewn.text + "\n";
  return text;
}

std::string bytesOf(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  occ::writeBinaryShape(shape, stream);
  return stream.str();
}

/// The numbers that are told name what lies where the old part lay, on the same surfaces.
void expectNumbers(const TopoDS_Shape& before, const RepairReport& report) {
  const TopoDS_Shape& after = report.model.shape;
  const auto faces = partsOf(before, TopAbs_FACE), faces_now = partsOf(after, TopAbs_FACE);
  const auto edges = partsOf(before, TopAbs_EDGE), edges_now = partsOf(after, TopAbs_EDGE);
  ASSERT_EQ(report.faces_now.size(), faces.Extent() + 1);
  ASSERT_EQ(report.edges_now.size(), edges.Extent() + 1);
  std::set<int> taken;
  for (int f = 1; f <= faces.Extent(); ++f) {
    TopLoc_Location was, is;
    const int now = report.faces_now[f];
    ASSERT_TRUE(now >= 1 && now <= faces_now.Extent());
    EXPECT_TRUE(taken.insert(now).second);
    if (std::ranges::count(report.moves, f, &occ::FaceMove::face) == 0) {
      EXPECT_EQ(BRep_Tool::Surface(TopoDS::Face(faces(f)), was),
                BRep_Tool::Surface(TopoDS::Face(faces_now(now)), is));
      EXPECT_TRUE(was == is);
    }
  }
  std::set<int> named;
  for (int e = 1; e <= edges.Extent(); ++e) {
    ASSERT_FALSE(report.edges_now[e].empty());
    named.insert(report.edges_now[e].begin(), report.edges_now[e].end());
    for (const int now : report.edges_now[e]) ASSERT_TRUE(now >= 1 && now <= edges_now.Extent());
    if (BRep_Tool::Degenerated(TopoDS::Edge(edges(e)))) continue;
    // Lengths add up.
    const auto length = [](const TopoDS_Shape& edge) {
      GProp_GProps properties;
      BRepGProp::LinearProperties(edge, properties);
      return properties.Mass();
    };
    double sum = 0;
    for (const int now : report.edges_now[e]) sum += length(edges_now(now));
    EXPECT_NEAR(sum, length(edges(e)), 0.01 * length(edges(e)) + 0.05);
  }
  EXPECT_EQ(named.size(), edges_now.Extent());
}

/// What is promised of every repair that sews.
RepairReport sewn(const TopoDS_Shape& shape, const RepairOptions& options) {
  const std::string before = bytesOf(shape);
  RepairReport report = repair(modelFromShape(shape), options);
  EXPECT_EQ(bytesOf(shape), before);
  const TopoDS_Shape& after = report.model.shape;
  EXPECT_EQ(report.sewn(), sewnSeams(report) > 0) << whyNot(report);
  EXPECT_TRUE(BRepCheck_Analyzer(after).IsValid());
  expectTolerancesHold(after);
  if (report.sewn()) expectNumbers(shape, report);
  EXPECT_EQ(report.after.model.edges, count(after, TopAbs_EDGE));
  const TopTools_IndexedMapOfShape edges = partsOf(after, TopAbs_EDGE);
  for (const occ::SeamRepair& seam : report.seams) {
    SCOPED_TRACE(describe(seam.after));
    if (seam.before.kind == occ::SeamKind::Matched) {
      EXPECT_NE(seam.sewn, !seam.not_sewn.empty());
    }
    if (!seam.sewn) continue;
    EXPECT_EQ(seam.before.edges.size(), 2);
    EXPECT_EQ(seam.after.edges.size(), 1);
    EXPECT_LE(*seam.after.figures.gap_mm->upper, options.tolerance.gap_mm);
    EXPECT_LE(BRep_Tool::Tolerance(TopoDS::Edge(edges(seam.after.edges[0]))),
              options.tolerance.gap_mm);
    const auto sides = denseSides(after, seam.after.edges[0], seam.after.faces);
    if (sides) {
      EXPECT_GE(*seam.after.figures.gap_mm->upper,
                denseMaxima(*sides, 301, options.tolerance).gap_mm.sure());
    }
  }
  // Measured again, all that was sewn is what the report says, and what is open is open.
  occ::AnalyzeOptions analyze;
  analyze.tolerance = options.tolerance;
  analyze.match_mm = options.match_mm;
  const occ::Report again = analyzed(after, analyze);
  EXPECT_EQ(again.open.size(), report.after.open.size());
  EXPECT_EQ(again.non_manifold.size(), report.after.non_manifold.size());
  for (const occ::SeamRepair& seam : report.seams) {
    const auto sorted = [](std::vector<int> numbers) {
      std::ranges::sort(numbers);
      return numbers;
    };
    const auto same = std::ranges::find_if(again.seams, [&](const occ::SeamResult& other) {
      return sorted(other.edges) == sorted(seam.after.edges);
    });
    EXPECT_NE(same, again.seams.end()) << describe(seam.after);
    if (same == again.seams.end() || !seam.sewn) continue;
    EXPECT_EQ(same->figures.gap_mm->upper, seam.after.figures.gap_mm->upper);
    EXPECT_EQ(same->faces, seam.after.faces);
  }
  EXPECT_FALSE(repair(report.model, options).sewn());
  return report;
}

void expectSolid(const TopoDS_Shape& shape, double volume, double near) {
  ASSERT_EQ(count(shape, TopAbs_SOLID), 1);
  ASSERT_EQ(count(shape, TopAbs_SHELL), 1);
  EXPECT_TRUE(BRep_Tool::IsClosed(partsOf(shape, TopAbs_SHELL)(1)));
  EXPECT_NEAR(volume_mm3(shape), volume, near);
}

TEST(Sew, ABoxTakenApart) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape box =
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeBox(10, 20, 30).Shape()).Shape();
  for (int trial = 0; trial < 8; ++trial) {
    std::vector<TopoDS_Shape> faces = apart(box);
    std::ranges::shuffle(faces, generator);
    for (TopoDS_Shape& face : faces)
      if (generator() % 2 == 0) face.Reverse();
    const gp_Trsf motion = randomMotion(generator);
    const TopoDS_Shape shape =
        trial < 4 ? transformed(compoundOf(faces), motion) : located(compoundOf(faces), motion);
    const RepairReport report = sewn(shape, matching(0.1));
    EXPECT_EQ(sewnSeams(report), 12) << whyNot(report);
    EXPECT_EQ(count(report.model.shape, TopAbs_EDGE), 12);
    EXPECT_EQ(count(report.model.shape, TopAbs_VERTEX), 8);
    expectSolid(report.model.shape, 6000, 1e-6);
    for (int f = 1; f <= 6; ++f) EXPECT_EQ(report.faces_now[f], f);
    EXPECT_TRUE(report.moves.empty());
    EXPECT_TRUE(report.after.open.empty());
  }
}

TEST(Sew, SewsModelsOfAnySize) {
  for (const double scale : {0.01, 1.0, 100.0}) {
    gp_Trsf larger;
    larger.SetScale(gp::Origin(), scale);
    RepairOptions options = matching(0.1 * scale);
    options.tolerance.gap_mm *= scale;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    const RepairReport report = sewn(transformed(compoundOf(apart(box)), larger), options);
    EXPECT_EQ(sewnSeams(report), 12) << scale << whyNot(report);
    expectSolid(report.model.shape, 6000 * std::pow(scale, 3), 1e-6 * std::pow(scale, 3));
  }
}

TEST(Sew, FacesALittleOff) {
  std::mt19937 generator(testSeed());
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  for (const double off_mm : {1e-6, 1e-4, 2e-3}) {
    std::vector<TopoDS_Shape> faces = apart(box);
    for (TopoDS_Shape& face : faces) {
      gp_Trsf move;
      move.SetTranslation(
          gp_Vec(random(generator, off_mm), random(generator, off_mm), random(generator, off_mm)));
      face = transformed(face, move);
    }
    const RepairReport report = sewn(compoundOf(faces), matching(0.1));
    EXPECT_EQ(sewnSeams(report), 12) << whyNot(report);
    expectSolid(report.model.shape, 6000, 2200 * 2 * off_mm);
    double largest = 0;
    for (TopExp_Explorer edge(report.model.shape, TopAbs_EDGE); edge.More(); edge.Next())
      largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
    EXPECT_LE(largest, std::max(1e-7, 3 * off_mm));
  }
}

TEST(Sew, WhatIsTooFarStaysLoose) {
  std::vector<TopoDS_Shape> faces = apart(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
  gp_Trsf move;
  move.SetTranslation(gp_Vec(0.03, 0.03, 0.03));
  faces[2] = transformed(faces[2], move);
  const RepairReport report = sewn(compoundOf(faces), matching(0.1));
  EXPECT_EQ(sewnSeams(report), 8);
  EXPECT_EQ(count(report.model.shape, TopAbs_EDGE), 16);
  EXPECT_EQ(count(report.model.shape, TopAbs_SOLID), 0);
  EXPECT_NE(whyNot(report).find("gap is not certainly within the tolerance"), std::string::npos);
  EXPECT_EQ(faultsOf(report), std::set{occ::SewFault::GapTooLarge});
}

TEST(Sew, RoundSolidsTakenApart) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 25).Shape();
  const RepairReport plain = sewn(compoundOf(apart(cylinder)), matching(0.1));
  EXPECT_EQ(sewnSeams(plain), 2) << whyNot(plain);
  EXPECT_EQ(count(plain.model.shape, TopAbs_EDGE), 3);
  expectSolid(plain.model.shape, 2500 * pi, 1e-3);
  // The lids begin elsewhere.
  std::vector<TopoDS_Shape> faces = apart(cylinder);
  gp_Trsf turn;
  turn.SetRotation(gp::OZ(), 1);
  for (const int lid : {1, 2}) faces[lid] = transformed(faces[lid], turn);
  const RepairReport turned = sewn(compoundOf(faces), matching(0.1));
  EXPECT_EQ(sewnSeams(turned), 4) << whyNot(turned);
  EXPECT_EQ(count(turned.model.shape, TopAbs_EDGE), 5);
  EXPECT_EQ(count(turned.model.shape, TopAbs_VERTEX), 4);
  expectSolid(turned.model.shape, 2500 * pi, 1e-3);
}

TEST(Sew, HalvesOfASphereAndAQuarter) {
  std::vector<TopoDS_Shape> faces;
  for (const auto& [from, to] : {std::pair(0.0, 1.0), std::pair(1.0, 3.0), std::pair(3.0, 2 * pi)})
    faces.push_back(BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(gp::XOY(), 10), from, to,
                                            -pi / 2, pi / 2, 1e-7)
                        .Shape());
  const RepairReport report = sewn(compoundOf(faces), matching(0.1));
  EXPECT_EQ(sewnSeams(report), 3) << whyNot(report);
  EXPECT_EQ(count(report.model.shape, TopAbs_VERTEX), 2);
  expectSolid(report.model.shape, 4000 * pi / 3, 1e-4);
}

TEST(Sew, ALongEdgeIsCut) {
  for (const double apart_mm : {0.0, 0.004}) {
    const TopoDS_Shape shape =
        compoundOf({plate(0, 10, -10, 30), plate(10, 20, -10, 5 - apart_mm, 0.001),
                    plate(10, 20, 5, 21, 0.002), plate(10, 25, 21, 28)});
    const RepairReport report = sewn(shape, matching(0.1));
    EXPECT_EQ(sewnSeams(report), 5) << whyNot(report);
    const TopTools_IndexedMapOfShape edges = partsOf(shape, TopAbs_EDGE);
    int cut = 0;
    for (int e = 1; e <= edges.Extent(); ++e) cut += report.edges_now[e].size() == 4;
    EXPECT_EQ(cut, 1);  // three intervals and the rest
    EXPECT_EQ(count(report.model.shape, TopAbs_SHELL), 1);
  }
}

handle<Geom_BezierSurface> bezier(const std::vector<std::vector<gp_Pnt>>& rows) {
  const int n = static_cast<int>(rows.size()), m = static_cast<int>(rows[0].size());
  TColgp_Array2OfPnt poles(1, n, 1, m);
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= m; ++j) poles(i, j) = rows[i - 1][j - 1];
  return new Geom_BezierSurface(poles);
}

/// Of so many pieces, twisted by half turns.
TopoDS_Shape band(int pieces, int half_turns) {
  const auto rung = [&](int k, double sense) {
    const double about = 2 * pi * k / pieces, twist = half_turns * pi * k / pieces;
    const gp_Vec out(std::cos(about), std::sin(about), 0);
    const gp_Vec way = out * std::cos(twist) + gp_Vec(0, 0, 1) * std::sin(twist);
    return gp_Pnt(20 * out.X(), 20 * out.Y(), 0).Translated(way * (3 * sense));
  };
  std::vector<TopoDS_Shape> faces;
  for (int k = 0; k < pieces; ++k)
    faces.push_back(
        BRepBuilderAPI_MakeFace(
            bezier({{rung(k, -1), rung(k, 1)}, {rung(k + 1, -1), rung(k + 1, 1)}}), 1e-7)
            .Shape());
  return compoundOf(faces);
}

TEST(Sew, ABandWithOneSideStaysOpen) {
  for (const int half_turns : {0, 1, 2, 3}) {
    const RepairReport report = sewn(band(8, half_turns), matching(0.1));
    const bool one_sided = half_turns % 2 == 1;
    EXPECT_EQ(sewnSeams(report), one_sided ? 7 : 8) << half_turns << whyNot(report);
    EXPECT_EQ(whyNot(report).find("one side only") != std::string::npos, one_sided)
        << whyNot(report);
    EXPECT_EQ(faultsOf(report).count(occ::SewFault::OneSided), one_sided ? 1 : 0);
  }
}

/// A plate of which y is quadratic in v.
TopoDS_Shape unevenPlate(double x0, double x1, bool down) {
  std::vector<std::vector<gp_Pnt>> rows;
  for (const double x : {x0, x1}) {
    rows.emplace_back();
    for (const double at : {0.0, 0.15, 1.0})
      rows.back().emplace_back(x, 20 * (down ? 1 - at : at), 0.5 * (x - x0));
  }
  return BRepBuilderAPI_MakeFace(bezier(rows), 1e-7).Shape();
}

TEST(Sew, EdgesThatRunUnlike) {
  for (const bool down : {false, true})
    for (const bool swapped : {false, true}) {
      std::vector<TopoDS_Shape> faces = {plate(-10, 0, 0, 20), unevenPlate(0, 10, down)};
      if (swapped) std::ranges::reverse(faces);
      const RepairReport report = sewn(compoundOf(faces), matching(0.1));
      EXPECT_EQ(sewnSeams(report), 1) << whyNot(report);
      EXPECT_LE(*report.seams[0].after.figures.gap_mm->upper, 3e-4);
    }
}

TEST(Sew, SewsWhatAMoveHasBroughtTogether) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 generator(testSeed(seed));
    const auto parts = disturbedSheets(generator, 0.02);
    RepairOptions options = matching(0.5);
    options.tolerance.gap_mm = 0.001;
    options.fixed_faces = {1};
    const TopoDS_Shape shape = loose(wholeFace(parts[0]), wholeFace(parts[1]));
    const RepairReport report = sewn(shape, options);
    ASSERT_EQ(report.seams.size(), 1);
    EXPECT_TRUE(report.seams[0].repaired) << report.seams[0].reason.text;
    EXPECT_TRUE(report.seams[0].sewn) << whyNot(report);
    // Where the ends of both edges were apart along the seam, what is left of the longer one is an
    // edge of its own.
    EXPECT_LE(count(report.model.shape, TopAbs_EDGE), 9);
    EXPECT_LE(count(report.model.shape, TopAbs_VERTEX), 8);
    ASSERT_EQ(report.moves.size(), 1);
    options.sew = false;
    const RepairReport unsewn = repair(modelFromShape(shape), options);
    EXPECT_FALSE(unsewn.sewn());
    EXPECT_EQ(unsewn.model.edgeCount(), 8);
    EXPECT_TRUE(unsewn.edges_now.empty());
  }
}

/// A sheet with a kink of 1 degree whose sides part by 0.1 mm from a common corner.
TEST(Sew, WhereEdgesPartTheReasonSaysSoFirst) {
  const auto sheet = [](double x, double parted, double rise) {
    std::vector<std::vector<gp_Pnt>> rows(2);
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        rows[i].emplace_back((i == 0) == (x < 0) ? x : parted * j, 20.0 * j,
                             (i == 0) == (x < 0) ? rise : 0);
    return BRepBuilderAPI_MakeFace(bezier(rows), 1e-7).Shape();
  };
  RepairOptions options = matching(0.05);
  options.max_move_mm = 1e-4;
  const RepairReport report =
      sewn(compoundOf({sheet(-30, 0, 0), sheet(30, 0.1, 30 * std::tan(degree))}), options);
  ASSERT_EQ(report.seams.size(), 1);
  const occ::SeamRepair& seam = report.seams[0];
  EXPECT_TRUE(seam.treated && !seam.repaired && !seam.sewn);
  EXPECT_EQ(seam.before.note,
            "it ends where the edges are further apart than the distance to match, and the gap may "
            "go on growing");
  EXPECT_EQ(seam.reason.text.find(seam.before.note + "; "), 0) << seam.reason.text;
  EXPECT_GT(seam.reason.text.size(), seam.before.note.size() + 2);
}

TEST(Sew, ShellsTakeTurns) {
  // Faces of two shells one after the other: those of a shell stand together afterwards.
  const TopoDS_Shape shape =
      compoundOf({plate(0, 10, 0, 10), plate(0, 10, 0, 10, 50), plate(10, 20, 0, 10),
                  plate(10, 20, 0, 10, 50), plate(0, 10, 0, 10, 90)});
  const RepairReport report = sewn(shape, matching(0.1));
  EXPECT_EQ(report.faces_now, (std::vector<int>{0, 1, 3, 2, 4, 5}));
  EXPECT_EQ(count(report.model.shape, TopAbs_SHELL), 2);
}

TEST(Sew, OnlyPickedEdges) {
  const TopoDS_Shape shape =
      compoundOf({plate(0, 10, 0, 10), plate(10, 20, 0, 10), plate(20, 30, 0, 10)});
  const RepairReport all = sewn(shape, matching(0.1));
  ASSERT_EQ(sewnSeams(all), 2);
  RepairOptions options = matching(0.1);
  options.edges = {all.seams[1].before.edges[0]};
  const RepairReport one = repair(modelFromShape(shape), options);
  EXPECT_FALSE(one.seams[0].sewn);
  EXPECT_TRUE(one.seams[1].sewn);
  EXPECT_EQ(one.model.edgeCount(), 11);
}

TEST(Sew, ThreeFacesAtAnEdgeStayLoose) {
  gp_Trsf up;
  up.SetRotation(gp_Ax1(gp_Pnt(10, 0, 0), gp::DY()), -1);
  const TopoDS_Shape shape = compoundOf(
      {plate(0, 10, 0, 10), plate(10, 20, 0, 10), transformed(plate(10, 20, 0, 10), up)});
  const RepairReport report = sewn(shape, matching(0.1));
  EXPECT_FALSE(report.changed());
  EXPECT_TRUE(report.model.shape.IsEqual(shape));
  EXPECT_EQ(report.before.non_manifold.size(), 3);
}

TEST(Sew, InstancesStayLoose) {
  gp_Trsf away;
  away.SetTranslation(gp_Vec(10, 0, 0));
  const TopoDS_Shape one = plate(0, 10, 0, 10);
  const RepairReport report = sewn(compoundOf({one, located(one, away)}), matching(0.1));
  EXPECT_FALSE(report.changed());
  EXPECT_NE(whyNot(report).find("occurs in the model 2 times"), std::string::npos)
      << whyNot(report);
  EXPECT_EQ(faultsOf(report), std::set{occ::SewFault::FaceInstances});
}

TEST(Sew, NamesAndColoursStayWithTheirParts) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, plate(10, 20, 0, 10));
  occ::Model model = modelFromShape(
      compoundOf({plate(0, 10, 0, 10, 50), plate(0, 10, 0, 10), plate(10, 20, 0, 10, 50), shell}));
  const std::array<double, 3> red = {1, 0, 0}, blue = {0, 0, 1};
  model.attributes = {{TopAbs_COMPOUND, 1, "all", {}, {}},
                      {TopAbs_SHELL, 1, "shell", red, {"layer"}},
                      {TopAbs_FACE, 3, "upper", blue, {}}};
  const RepairReport report = repair(model, matching(0.1));
  ASSERT_TRUE(report.sewn());
  EXPECT_EQ(report.faces_now, (std::vector<int>{0, 1, 3, 2, 4}));
  const std::vector<occ::ShapeAttribute>& now = report.model.attributes;
  ASSERT_EQ(now.size(), 3);
  EXPECT_EQ(now[0].kind, TopAbs_COMPOUND);
  EXPECT_EQ(now[0].name, "all");
  EXPECT_EQ(now[1].kind, TopAbs_FACE);
  EXPECT_EQ(now[1].index, 2);
  EXPECT_EQ(now[1].name, "upper");
  EXPECT_EQ(now[1].color, blue);
  EXPECT_EQ(now[2].kind, TopAbs_FACE);
  EXPECT_EQ(now[2].index, 4);
  EXPECT_EQ(now[2].name, "shell");
  EXPECT_EQ(now[2].color, red);
  EXPECT_EQ(now[2].layers, std::vector<std::string>{"layer"});
}

TEST(Sew, FacesOfOneSurfaceStayLoose) {
  const handle<Geom_Surface> surface = new Geom_CylindricalSurface(gp::XOY(), 10);
  const TopoDS_Shape shape =
      compoundOf({BRepBuilderAPI_MakeFace(surface, 0, 1, 0, 10, 1e-7).Shape(),
                  BRepBuilderAPI_MakeFace(surface, 1, 2, 0, 10, 1e-7).Shape()});
  const RepairReport report = sewn(shape, matching(0.1));
  EXPECT_FALSE(report.changed());
  EXPECT_NE(whyNot(report).find("face 1 and face 2 have one surface in common"), std::string::npos)
      << whyNot(report);
  ASSERT_EQ(faultsOf(report), std::set{occ::SewFault::CommonSurface});
  EXPECT_EQ(report.seams[0].not_sewn.faces, (std::vector<int>{1, 2}));
}

TEST(Sew, ATubeMeetsItself) {
  const double cleft = 1e-5;
  const TopoDS_Shape tube =
      compoundOf({BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp::XOY(), 10), 0,
                                          2 * pi - cleft, 0, 30, 1e-7)
                      .Shape()});
  const RepairReport report = sewn(tube, matching(0.1));
  ASSERT_EQ(sewnSeams(report), 1) << whyNot(report);
  EXPECT_EQ(report.seams[0].after.kind, occ::SeamKind::Closed);
  EXPECT_NEAR(report.seams[0].after.figures.gap_mm->lower, 20 * std::sin(cleft / 2), 1e-9);
  EXPECT_EQ(count(report.model.shape, TopAbs_EDGE), 3);
  EXPECT_EQ(count(report.model.shape, TopAbs_VERTEX), 2);
}

TEST(Sew, WhatIsWrittenComesBackSewn) {
  const Folder folder;
  writeStep(compoundOf(apart(BRepPrimAPI_MakeBox(10, 20, 30).Shape())), folder / "loose.step");
  const occ::Model model = occ::readModel(folder / "loose.step");
  const RepairReport report = repair(model, matching(0.1));
  EXPECT_EQ(sewnSeams(report), 12) << whyNot(report);
  const occ::WriteReport written = occ::writeModel(report.model, folder / "sewn.step");
  EXPECT_FALSE(written.followed_source);
  EXPECT_EQ(written.notes.size(), 1);
  const occ::Model back = occ::readModel(folder / "sewn.step");
  EXPECT_EQ(back.edgeCount(), 12);
  expectSolid(back.shape, 6000, 1e-6);
}

struct Shell {
  const char* kind;
  double noise_mm;
  bool may_move = true;
};

void PrintTo(const Shell& shell, std::ostream* out) {
  *out << shell.kind << ", noise of " << shell.noise_mm << " mm";
}

class SewShells : public testing::TestWithParam<Shell> {};

/// The faces of a shell, taken apart, become a shell with as many edges and seams.
TEST_P(SewShells, AsTheyWere) {
  const TopoDS_Shape shell = brokenModel({GetParam().kind, GetParam().noise_mm, testSeed()});
  const occ::SeamGraph was = occ::findSeams(shell);
  const occ::Model model = modelFromShape(compoundOf(apart(shell)));
  RepairOptions options = matching(0.05);
  for (int f = 1; f <= model.faceCount() && !GetParam().may_move; ++f)
    options.fixed_faces.push_back(f);
  const RepairReport report = repair(model, options);
  EXPECT_EQ(report.model.edgeCount(), count(shell, TopAbs_EDGE));
  EXPECT_EQ(sewnSeams(report), was.seams.size()) << whyNot(report);
  EXPECT_EQ(report.after.open.size(), was.open.size());
  EXPECT_TRUE(BRepCheck_Analyzer(report.model.shape).IsValid());
  EXPECT_EQ(count(report.model.shape, TopAbs_SHELL), 1);
  expectTolerancesHold(report.model.shape);
  expectNumbers(model.shape, report);
  for (int f = 1; f <= model.faceCount(); ++f) EXPECT_EQ(report.faces_now[f], f);
  for (const occ::SeamRepair& seam : report.seams)
    EXPECT_GE(seam.after.verdict.level, std::min(seam.before.verdict.level, Level::G1))
        << describe(seam.after);
}

INSTANTIATE_TEST_SUITE_P(Nets, SewShells,
                         testing::Values(Shell{"sheet", 0.001}, Shell{"blob 24", 0.001},
                                         Shell{"trimmed bricks", 0.004, false},
                                         Shell{"trimmed triangles", 0.001},
                                         Shell{"ring of quads", 0, false}),
                         [](const auto& test) {
                           std::string name = test.param.kind;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace seamwright::test
