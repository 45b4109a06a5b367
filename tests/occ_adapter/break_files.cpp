// SPDX-License-Identifier: LGPL-2.1-or-later
// Breaks the smooth seams of models that are files and has them repaired.
//   break_files [--noise MM]... [--seed NUMBER] FILE...
// The poles of spline faces near seams are moved by less than the noise each. Counted are the seams
// that certainly were G1 within 0.001 mm and 0.01 degrees, and are broken by less than 5 degrees;
// those of them that are G1 again; the faces whose mean curvature then varies more than the judge
// allows over that of the broken face; and over that of the face before the noise. Reasons of seams
// that are left go to the error stream.
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "fairness.hpp"
#include "nets.hpp"
#include "shapes.hpp"

#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>

namespace {

using namespace seamwright;
using namespace seamwright::test;

/// Samples of the edges in the face's parameter plane that bound another face too.
std::vector<gp_Pnt2d> seamSamples(const TopoDS_Face& face,
                                  const TopTools_IndexedDataMapOfShapeListOfShape& faces_of_edge) {
  constexpr int points = 60;
  std::vector<gp_Pnt2d> samples;
  const TopTools_IndexedMapOfShape edges = partsOf(face, TopAbs_EDGE);
  for (int e = 1; e <= edges.Extent(); ++e) {
    double first = 0, last = 0;
    const auto path = BRep_Tool::CurveOnSurface(TopoDS::Edge(edges(e)), face, first, last);
    if (faces_of_edge.FindFromKey(edges(e)).Extent() != 2 || path.IsNull()) continue;
    for (int k = 0; k <= points; ++k)
      samples.push_back(path->Value(first + (last - first) * k / points));
  }
  return samples;
}

TopoDS_Shape broken(const TopoDS_Shape& shape, double noise_mm, unsigned seed, double gap_mm) {
  std::mt19937 random(seed);
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  std::vector<occ::FaceChange> changes;
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  for (int f = 1; f <= faces.Extent(); ++f) {
    TopLoc_Location location;
    const auto surface = BRep_Tool::Surface(TopoDS::Face(faces(f)), location);
    const auto spline = occ::clampedSpline(surface, location);
    const std::vector<gp_Pnt2d> samples = seamSamples(TopoDS::Face(faces(f)), faces_of_edge);
    if (spline.IsNull() || samples.empty()) continue;
    disturbNear(samples, noise_mm, random, *spline);
    changes.push_back({f, opencascade::handle<Geom_Surface>(spline), noise_mm});
  }
  return occ::withChanges(shape, changes, gap_mm);
}

struct Counts {
  int broken = 0, repaired = 0, moved = 0, worse = 0, worse_than_smooth = 0,
      noise_worse_than_smooth = 0;

  Counts& operator+=(const Counts& other) {
    broken += other.broken;
    repaired += other.repaired;
    moved += other.moved;
    worse += other.worse;
    worse_than_smooth += other.worse_than_smooth;
    noise_worse_than_smooth += other.noise_worse_than_smooth;
    return *this;
  }
};

opencascade::handle<Geom_Surface> surfaceOf(const TopoDS_Shape& shape, int face) {
  TopLoc_Location location;
  return occ::clampedSpline(
      BRep_Tool::Surface(TopoDS::Face(partsOf(shape, TopAbs_FACE)(face)), location), location);
}

Counts countsOf(const occ::Model& smooth, double noise_mm, unsigned seed) {
  occ::RepairOptions options;
  options.tolerance.gap_mm = 0.001;
  options.tolerance.angle_rad = 0.01 * degree;
  const occ::Report was = occ::analyze(smooth, occ::analyzeOptions(options));
  occ::Model model = smooth;
  model.shape = broken(smooth.shape, noise_mm, seed, options.tolerance.gap_mm);
  const occ::RepairReport report = occ::repair(model, options);
  Counts counts;
  for (std::size_t i = 0; i < report.seams.size(); ++i) {
    const occ::SeamRepair& seam = report.seams[i];
    const auto& angle = seam.before.figures.angle_rad;
    if (!certainlyReaches(was.seams[i].figures, options.tolerance, Level::G1) || !angle ||
        !angle->upper)
      continue;
    if (seam.before.verdict.level >= Level::G1 || *angle->upper >= 5 * degree) continue;
    ++counts.broken;
    const bool is_repaired = certainlyReaches(seam.after.figures, options.tolerance, Level::G1);
    counts.repaired += is_repaired ? 1 : 0;
    if (!is_repaired)
      std::cerr << "  Edge" << seam.before.edges.front() << ": " << seam.reason.text << "\n";
  }
  for (const FaceFairness& face : fairnessOfChanges(model.shape, report, options.tolerance)) {
    ++counts.moved;
    counts.worse += face.isWorse() ? 1 : 0;
    const TopoDS_Face shown = TopoDS::Face(partsOf(smooth.shape, TopAbs_FACE)(face.face));
    const double before_noise_per_mm =
        variationByOpenCascade(shown, surfaceOf(smooth.shape, face.face));
    const double limit_per_mm =
        1.5 * before_noise_per_mm + face.limit_per_mm - 1.5 * face.before_per_mm;
    counts.worse_than_smooth += face.after_per_mm > limit_per_mm ? 1 : 0;
    counts.noise_worse_than_smooth += face.before_per_mm > limit_per_mm ? 1 : 0;
  }
  return counts;
}

void print(const std::string& name, double noise_mm, const Counts& counts) {
  std::printf("%-40s %6g %6d %8d %6.1f %% %7d %6d %12d %12d\n", name.c_str(), noise_mm,
              counts.broken, counts.repaired,
              counts.broken > 0 ? 100.0 * counts.repaired / counts.broken : 100.0, counts.moved,
              counts.worse, counts.noise_worse_than_smooth, counts.worse_than_smooth);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::vector<double> noises_mm;
  std::vector<std::string> files;
  unsigned seed = 1;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--noise")
      noises_mm.push_back(std::stod(words.at(++i)));
    else if (words[i] == "--seed")
      seed = static_cast<unsigned>(std::stoul(words.at(++i)));
    else
      files.push_back(words[i]);
  }
  if (noises_mm.empty()) noises_mm = {0.005, 0.05};
  std::puts(
      "model                                  noise_mm broken repaired          moved  worse  less "
      "fair than "
      "before the noise: broken, repaired");
  for (const double noise_mm : noises_mm) {
    Counts all;
    for (const std::string& file : files) try {
        const Counts counts = countsOf(occ::readModel(file), noise_mm, seed);
        if (counts.broken > 0) print(std::filesystem::path(file).filename(), noise_mm, counts);
        all += counts;
      } catch (const Standard_Failure& failure) {
        std::cerr << file << ": " << failure << "\n";
      } catch (const std::exception& error) {
        std::cerr << file << ": " << error.what() << "\n";
      }
    print("all", noise_mm, all);
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
