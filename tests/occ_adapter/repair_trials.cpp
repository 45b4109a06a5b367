// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair_trials.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "shapes.hpp"

namespace seamwright::test {

namespace {

NetShape sheetOf(Division division, int columns, int rows) {
  NetShape shape;
  shape.division = division;
  shape.columns = columns;
  shape.rows = rows;
  return shape;
}

NetShape trimmed(NetShape shape) {
  shape.bend = 0.12;
  shape.overhang = 0.5;
  return shape;
}

NetShape ring(NetShape shape) {
  shape.closed = true;
  return shape;
}

NetKind pieces(const std::string& name, const NetShape& shape) {
  return {name, [shape](std::mt19937& random) { return piecesOfOne(shape, random); }};
}

NetKind blobOf(const std::string& name, Polyhedron polyhedron) {
  return {name, [polyhedron](std::mt19937& random) { return blob(polyhedron, 100, random); }};
}

}  // namespace

const std::vector<NetKind>& netKinds() {
  static const std::vector<NetKind> kinds = [] {
    NetShape refitted = trimmed(sheetOf(Division::Quads, 3, 3));
    refitted.refitted = true;
    NetShape mixed = sheetOf(Division::Quads, 3, 3);
    mixed.overhang = 0.5;
    mixed.alternate = true;
    return std::vector<NetKind>{
        pieces("sheet", sheetOf(Division::Quads, 3, 3)),
        pieces("ring", ring(sheetOf(Division::Quads, 8, 4))),
        blobOf("blob 6", Polyhedron::Cube),
        blobOf("blob 24", Polyhedron::CubeOfFour),
        blobOf("blob 30", Polyhedron::Triacontahedron),
        pieces("mixed sheet", mixed),
        pieces("trimmed bricks", trimmed(sheetOf(Division::Bricks, 3, 3))),
        pieces("trimmed quads", trimmed(sheetOf(Division::Quads, 3, 3))),
        pieces("trimmed triangles", trimmed(sheetOf(Division::Triangles, 2, 3))),
        pieces("refitted quads", refitted),
        pieces("ring of bricks", ring(trimmed(sheetOf(Division::Bricks, 4, 4)))),
        pieces("ring of quads", ring(trimmed(sheetOf(Division::Quads, 8, 4)))),
        pieces("ring of triangles", ring(trimmed(sheetOf(Division::Triangles, 8, 4)))),
    };
  }();
  return kinds;
}

const NetKind& netKind(const std::string& name) {
  const auto kind = std::ranges::find(netKinds(), name, &NetKind::name);
  if (kind == netKinds().end()) throw std::out_of_range("no kind of net is called " + name);
  return *kind;
}

RepairCounts& RepairCounts::operator+=(const RepairCounts& other) {
  seams += other.seams;
  treated += other.treated;
  repaired += other.repaired;
  largest_gap_mm = std::max(largest_gap_mm, other.largest_gap_mm);
  largest_angle_deg = std::max(largest_angle_deg, other.largest_angle_deg);
  largest_curvature_rel = std::max(largest_curvature_rel, other.largest_curvature_rel);
  largest_move = std::max(largest_move, other.largest_move);
  largest_on_face = std::max(largest_on_face, other.largest_on_face);
  analyze_s += other.analyze_s;
  repair_s += other.repair_s;
  for (const auto& [why, count] : other.reasons) reasons[why] += count;
  return *this;
}

occ::RepairOptions trialOptions(const RepairTrial& trial) {
  constexpr double least_mm = 0.5, most_over_noise = 20;
  occ::RepairOptions options;
  options.order = trial.order;
  options.tolerance.gap_mm = 0.001 / trial.strictness;
  options.tolerance.angle_rad = 0.01 * degree / trial.strictness;
  options.tolerance.curvature_rel = 0.02 / trial.strictness;
  options.max_move_mm = std::max(least_mm, most_over_noise * trial.noise_mm);
  return options;
}

TopoDS_Shape brokenModel(const RepairTrial& trial) {
  std::mt19937 random(trial.seed);
  Net net = netKind(trial.kind).make(random);
  if (trial.noise_mm > 0) disturb(net, trial.noise_mm, random);
  return shapeOf(net);
}

RepairCounts countsOf(const occ::RepairReport& report, double noise_mm) {
  RepairCounts counts;
  counts.seams = static_cast<int>(report.seams.size());
  for (const occ::SeamRepair& seam : report.seams) {
    counts.treated += seam.treated ? 1 : 0;
    counts.repaired += seam.repaired ? 1 : 0;
    if (!seam.reason.empty()) ++counts.reasons[seam.reason.text];
    if (!seam.repaired || seam.after.verdict.seam_class == SeamClass::Crease) continue;
    const SeamFigures& figures = seam.after.figures;
    counts.largest_gap_mm = std::max(counts.largest_gap_mm, upper(figures.gap_mm));
    counts.largest_angle_deg =
        std::max(counts.largest_angle_deg, upper(figures.angle_rad) / degree);
    if (report.after.level == Level::G2)
      counts.largest_curvature_rel =
          std::max(counts.largest_curvature_rel, upper(figures.curvature_rel));
  }
  for (const occ::FaceMove& move : report.moves) {
    counts.largest_move = std::max(counts.largest_move, move.largest_move_mm / noise_mm);
    if (move.surface)
      counts.largest_on_face =
          std::max(counts.largest_on_face, move.surface->move_mm.lower / noise_mm);
  }
  counts.analyze_s = report.before.analyze_s;
  counts.repair_s = report.repair_s;
  return counts;
}

RepairCounts countsOf(const RepairTrial& trial) {
  const occ::RepairReport report =
      occ::repair(occ::modelFromShape(brokenModel(trial)), trialOptions(trial));
  return countsOf(report, trial.noise_mm);
}

std::string tableHead() {
  return "kind               noise_mm  seams treated repaired  gap_mm  angle_deg  curvature  "
         "move/noise  on "
         "face  "
         "analysis_s  repair_s";
}

std::string tableLine(const std::string& name, double noise_mm, const RepairCounts& counts) {
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(),
                "%-18s %8g %6d %7d %8d %8.2g %10.2g %10.2g %11.2f %8.2f %11.2f %9.2f", name.c_str(),
                noise_mm, counts.seams, counts.treated, counts.repaired, counts.largest_gap_mm,
                counts.largest_angle_deg, counts.largest_curvature_rel, counts.largest_move,
                counts.largest_on_face, counts.analyze_s, counts.repair_s);
  return line.data();
}

}  // namespace seamwright::test
