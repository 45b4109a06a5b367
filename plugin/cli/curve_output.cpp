// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <seamwright/core/angle.hpp>
#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/local_origin.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/plugin/cli/curve_drawing.hpp>
#include <seamwright/plugin/cli/curve_output.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

namespace fs = std::filesystem;

void requireFreeTarget(const std::string& input, const OutputArguments& arguments) {
  requireWritable(arguments.model);
  std::error_code error;
  if (fs::equivalent(input, arguments.model, error)) {
    if (!arguments.overwrite_source)
      throw std::runtime_error(arguments.model +
                               " is the input itself; use --overwrite-source or choose another "
                               "name");
  } else if (fs::is_regular_file(arguments.model, error) && !arguments.overwrite) {
    throw std::runtime_error(arguments.model +
                             " already exists; use --overwrite or choose another name");
  }
}

bool areArcs(const PlanarChain& chain) {
  return std::ranges::all_of(chain.curves, [](const ChainCurve& curve) {
    return std::holds_alternative<PlanarArc>(curve);
  });
}

/// The chain as arcs. Curves of other kinds become arcs within \p drawn_mm.
DrawnOutline asArcs(const MadeCurve& curve, double drawn_mm, const Progress& progress) {
  if (areArcs(curve.chain)) {
    DrawnOutline result{{{}, curve.chain.closed}, 0};
    for (const ChainCurve& arc : curve.chain.curves)
      result.outline.arcs.push_back(std::get<PlanarArc>(arc));
    return result;
  }
  const Eigen::Vector2d origin = localOrigin(curve.chain);
  const double rounding_mm = roundingAt_mm(origin);
  const double gap_mm = 1e-9 * (1 + curve.record.after.length_mm) + 2 * rounding_mm;
  ArcFit fit = fitArcs(bezierSpline(moved(curve.chain, -origin), gap_mm),
                       {.tolerance_mm = drawn_mm}, progress);
  for (PlanarArc& arc : fit.arcs) arc.start += origin;
  return {{std::move(fit.arcs), fit.closed},
          fit.distance_mm + 2 * rounding_mm + curve.chain_distance_mm};
}

/// The arcs and lines of a drawing. Those of a table stay as they are.
DrawnOutline drawn(const MadeCurve& curve, CurveFormat format, double drawn_mm,
                   const Progress& progress) {
  DrawnOutline arcs = asArcs(curve, drawn_mm, progress);
  if (format == CurveFormat::Csv) return arcs;
  DrawnOutline result = withFlatArcsStraight(std::move(arcs.outline), drawn_mm);
  result.distance_mm += arcs.distance_mm;
  return result;
}

void requireOnePlane(const std::vector<MadeCurve>& curves) {
  const PlaneFrame& first = curves.front().record.plane;
  for (const MadeCurve& curve : curves) {
    const PlaneFrame& plane = curve.record.plane;
    if (plane.origin != first.origin || plane.x != first.x || plane.y != first.y)
      throw std::runtime_error(
          "the curves lie in several planes, and a drawing or table has one: choose edges of one "
          "plane with --edge, or write .step or .brep");
  }
}

std::string clothoidsCsv(const std::vector<MadeCurve>& curves) {
  std::string text = "curve,x,y,direction_deg,curvature_per_mm,curvature_slope_per_mm2,length_mm\n";
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const Clothoid& piece : curves[i].clothoids)
      text += fmt::format("{},{},{},{},{},{},{}\n", i + 1, piece.start.x(), piece.start.y(),
                          piece.direction_rad * degrees_per_radian, piece.curvature_per_mm,
                          piece.curvature_slope_per_mm2, piece.length_mm);
  return text;
}

std::string conicsCsv(const std::vector<MadeCurve>& curves) {
  std::string text = "curve,x0,y0,corner_x,corner_y,x1,y1,weight\n";
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const ChainCurve& curve : curves[i].chain.curves) {
      const auto& conic = std::get<PlanarConic>(curve);
      text += fmt::format("{},{},{},{},{},{},{},{}\n", i + 1, conic.start.x(), conic.start.y(),
                          conic.corner.x(), conic.corner.y(), conic.end.x(), conic.end.y(),
                          conic.weight);
    }
  return text;
}

/// The points as they are in space, so that the table can be an input again.
std::string pointsCsv(const MadeCurve& curve) {
  const PlaneFrame& plane = curve.record.plane;
  const bool is_plane_of_z0 = plane.origin == Eigen::Vector3d::Zero() &&
                              plane.x == Eigen::Vector3d::UnitX() &&
                              plane.y == Eigen::Vector3d::UnitY();
  std::string text = is_plane_of_z0 ? "x,y\n" : "x,y,z\n";
  for (Eigen::Index i = 0; i < curve.points.rows(); ++i) {
    const Eigen::Vector2d p = curve.points.row(i).transpose();
    const Eigen::Vector3d q = plane.point(p);
    text += is_plane_of_z0 ? fmt::format("{},{}\n", p.x(), p.y())
                           : fmt::format("{},{},{}\n", q.x(), q.y(), q.z());
  }
  return text;
}

/// The curvature at a parameter, infinite where the segment winds up at an end.
double curvatureAt(const BezierCurve& segment, double t) {
  if (stoppedTangent(segment, t))
    return (t == 0 ? startCurvature(segment) : endCurvature(segment)).curvature_per_mm;
  const CurveDerivatives d = segment.derivatives(t, 2);
  const Eigen::Vector2d first = d.row(1).head<2>(), second = d.row(2).head<2>();
  return cross(first, second) / std::pow(first.norm(), 3);
}

/// Samples of the curves with their curvature, for a comb.
std::string samplesCsv(const std::vector<MadeCurve>& curves) {
  constexpr int samples = 16;  // of a Bézier segment
  std::string text = "curve,x,y,curvature_per_mm\n";
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const ChainCurve& curve : curves[i].chain.curves)
      for (const BezierCurve& segment : bezierCurves(curve))
        for (int k = 0; k <= samples; ++k) {
          const double t = static_cast<double>(k) / samples;
          const CurveDerivatives point = segment.derivatives(t, 2);
          text += fmt::format("{},{},{},{}\n", i + 1, point(0, 0), point(0, 1),
                              curvatureAt(segment, t));
        }
  return text;
}

std::string csvText(const std::string& method, const std::vector<MadeCurve>& curves,
                    const std::vector<ArcOutline>& outlines) {
  if (method == "arcs") return arcsCsv(outlines);
  if (method == "clothoid") return clothoidsCsv(curves);
  if (method == "conic") return conicsCsv(curves);
  return curves.front().points.rows() > 0 ? pointsCsv(curves.front()) : samplesCsv(curves);
}

}  // namespace

CurveFormat curveFormat(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".dxf") return CurveFormat::Dxf;
  if (extension == ".svg") return CurveFormat::Svg;
  if (extension == ".csv") return CurveFormat::Csv;
  if (extension == ".step" || extension == ".stp" || extension == ".iges" || extension == ".igs" ||
      extension == ".brep" || extension == ".brp" || extension == ".bin")
    return CurveFormat::Model;
  throw std::runtime_error(
      path.string() + ": can't be written: '" + extension +
      "' is not a known extension; use .step, .stp, .iges, .igs, .brep, .brp, .bin, .dxf, "
      ".svg or .csv");
}

std::string formatName(CurveFormat format, const fs::path& path) {
  if (format == CurveFormat::Model) return std::string(occ::name(occ::targetFormat(path)));
  return format == CurveFormat::Dxf ? "DXF" : format == CurveFormat::Svg ? "SVG" : "CSV";
}

void writeTexts(const std::string& text, const std::string& report,
                const OutputArguments& arguments) {
  PendingFile drawing(arguments.model, text);
  std::optional<PendingFile> json;
  if (!arguments.report.empty()) json.emplace(arguments.report, report).writeStraight();
  drawing.takePlace();
  if (json) json->takePlace();
}

std::vector<std::string> writeModel(occ::Model model, const std::string& report,
                                    const OutputArguments& arguments) {
  model.format = "memory";
  model.length_unit = "mm (assumed)";
  std::optional<PendingFile> json;
  occ::WriteOptions options = arguments.writeOptions();
  options.check = [&](const std::filesystem::path&) {
    if (!arguments.report.empty()) json.emplace(arguments.report, report).writeStraight();
  };
  const occ::WriteReport written = writeUnderBar(model, arguments.model, options);
  if (json) json->takePlace();
  return written.notes;
}

void requireCurveOutputs(const std::string& input, const OutputArguments& arguments) {
  if (curveFormat(arguments.model) == CurveFormat::Model) {
    requireOutputs(input, arguments);
    return;
  }
  requireFreeTarget(input, arguments);
  if (arguments.report.empty()) return;
  requireReportBeside(input, arguments);
}

CurveText curveText(CurveFormat format, const std::string& method,
                    const std::vector<MadeCurve>& curves, double drawn_mm,
                    const Progress& progress) {
  requireOnePlane(curves);
  CurveText result;
  std::vector<ArcOutline> outlines;
  const auto whole = static_cast<double>(curves.size());
  const bool draws = format != CurveFormat::Csv || method == "arcs";
  for (std::size_t i = 0; draws && i < curves.size(); ++i) {
    const auto done = static_cast<double>(i);
    try {
      DrawnOutline one =
          drawn(curves[i], format, drawn_mm, partOf(progress, done / whole, (done + 1) / whole));
      result.distance_mm = std::max(result.distance_mm, one.distance_mm);
      outlines.push_back(std::move(one.outline));
    } catch (const std::logic_error& error) {
      result.undrawn.push_back({.curve = i, .reason = error.what()});
    }
  }
  result.text = format == CurveFormat::Dxf   ? dxfText(outlines)
                : format == CurveFormat::Svg ? svgText(outlines)
                                             : csvText(method, curves, outlines);
  return result;
}

}  // namespace seamwright::cli
