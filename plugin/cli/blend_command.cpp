// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <seamwright/core/angle.hpp>
#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/blend/common_knots.hpp>
#include <seamwright/core/blend/frame_fault.hpp>
#include <seamwright/core/blend/frame_loft.hpp>
#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/blend/spline_blend.hpp>
#include <seamwright/core/blend/spline_places.hpp>
#include <seamwright/occ_adapter/convert/natural_face.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/curves/space_spline.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/repair/sewn_model.hpp>
#include <seamwright/occ_adapter/topology/built_model.hpp>
#include <seamwright/plugin/cli/blend_command.hpp>
#include <seamwright/plugin/cli/blend_drawing.hpp>
#include <seamwright/plugin/cli/curve_output.hpp>
#include <seamwright/plugin/cli/key_curves.hpp>
#include <seamwright/plugin/cli/loft_start.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/rounding.hpp>
#include <seamwright/plugin/report/blend_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

using report::BlendReport;

const std::map<std::string, KeyInterpolation::Continuity>& continuities() {
  using enum KeyInterpolation::Continuity;
  static const std::map<std::string, KeyInterpolation::Continuity> names = {
      {"C0", C0}, {"C1", C1}, {"C2", C2}};
  return names;
}

constexpr const char* by_features = "features";
constexpr const char* by_length = "length";

/// The key curves at omega 0..1.
std::vector<double> evenOmegas(std::size_t count) {
  std::vector<double> omegas;
  for (std::size_t i = 0; i < count; ++i)
    omegas.push_back(static_cast<double>(i) / static_cast<double>(count - 1));
  return omegas;
}

/// Curves with given pairs keep their start and direction.
MatchOptions matchOptions(const KeyCurves& input, const BlendArguments& arguments, bool closed) {
  if (!arguments.pairs.empty())
    return {.by = MatchBy::Given,
            .closeness = arguments.closeness,
            .given = pairParameters(input, arguments.pairs)};
  return {.by = arguments.match == by_features ? MatchBy::Features : MatchBy::Length,
          .closeness = arguments.closeness,
          .find_start = closed,
          .find_direction = true};
}

/// As "2 corners and 1 jump of the curvature correspond".
std::string featuresText(const std::vector<MatchedPlaces>& pairs) {
  std::string result;
  const auto add = [&](MatchedKind kind, const char* one, const char* several) {
    const auto count = std::ranges::count(pairs, kind, &MatchedPlaces::kind);
    if (count == 0) return;
    result +=
        fmt::format("{}{} {}", result.empty() ? "" : " and ", count, count == 1 ? one : several);
  };
  add(MatchedKind::Corner, "corner", "corners");
  add(MatchedKind::Jump, "jump of the curvature", "jumps of the curvature");
  add(MatchedKind::Extremum, "extremum of the curvature", "extrema of the curvature");
  return result;
}

std::string matchNote(const MatchSummary& summary, MatchBy by) {
  const auto [fewest, most] = std::ranges::minmax(summary.pieces_before);
  const std::string before = fewest == most ? fmt::format("{} piece{}", most, most == 1 ? "" : "s")
                                            : fmt::format("{} to {} pieces", fewest, most);
  const auto hasSome = [](int features) { return features > 0; };
  std::string note = fmt::format("matched: {} each became {}", before, summary.pieces_after);
  if (const auto count = summary.matched_features; count > 0 && by == MatchBy::Given)
    note += fmt::format(", {} given pair{}", count, count == 1 ? " corresponds" : "s correspond");
  else if (count > 0)
    note += fmt::format(", {} correspond{}", featuresText(summary.pairs), count == 1 ? "s" : "");
  else if (by == MatchBy::Features && !summary.lengths_fit_better &&
           std::ranges::any_of(summary.features, hasSome))
    note +=
        ", equal shares of the length correspond: no corners, jumps or extrema of the curvature "
        "do; --pair can name places that correspond";
  if (summary.lengths_fit_better)
    note += fmt::format(
        ", by equal shares of the length{} jumps and extrema of the curvature the tangents at "
        "corresponding points would differ more",
        summary.matched_features > 0 ? " between these: with other" : ": with");
  if (const auto reversed = std::ranges::count(summary.reversed, true))
    note += fmt::format(", {} run{} in the other direction", reversed, reversed == 1 ? "s" : "");
  return note;
}

void addMatch(const KeyCurves& input, const MatchSummary& summary, MatchBy by,
              const std::string& more, BlendReport& report) {
  report.notes.push_back(matchNote(summary, by) + more);
  report.pairs = pairRecords(input, summary.pairs);
  if (summary.lengths_fit_better) report.match = by_length;
}

std::vector<BezierSpline> splinesOf(const KeyCurves& input) {
  std::vector<BezierSpline> result;
  for (const KeyCurve& key : input.curves) result.push_back(key.curve);
  return result;
}

/// The key curves, divided into corresponding pieces.
std::vector<BezierSpline> dividedCurves(const KeyCurves& input, const MatchOptions& options,
                                        BlendReport& report) {
  MatchedFrames matched = matchPieces(splinesOf(input), options);
  addMatch(input, matched.summary, options.by,
           fmt::format("; shares of the length differ up to {:.3g} times",
                       matched.summary.largest_ratio),
           report);
  return std::move(matched.frames);
}

/// The key curves over common knots, within the tolerance.
std::vector<BezierSpline> refittedCurves(const KeyCurves& input, const MatchOptions& options,
                                         double tolerance_mm, BlendReport& report) {
  CommonKnots common =
      commonKnots(splinesOf(input), {.match = options, .tolerance_mm = tolerance_mm});
  addMatch(input, common.summary, options.by, "", report);
  for (std::size_t i = 0; i < input.curves.size(); ++i)
    report.key_curves[i].refitted_mm = common.distance_mm[i];
  report.reached = common.reached;
  return std::move(common.frames);
}

SplineBlend blendOf(const std::vector<BezierSpline>& curves, const BlendArguments& arguments) {
  SplineBlendOptions options;
  options.joint.order = arguments.order;
  options.continuity = continuities().at(arguments.in_between);
  options.keep_lower_orders = true;
  return SplineBlend(curves, evenOmegas(curves.size()), options);
}

SplineBlend blendOf(const KeyCurves& input, const BlendArguments& arguments, BlendReport& report) {
  const MatchOptions match = matchOptions(input, arguments, report.closed);
  const std::vector<BezierSpline> matched =
      arguments.exact ? dividedCurves(input, match, report)
                      : refittedCurves(input, match, arguments.tolerance_mm, report);
  SplineBlend blend = blendOf(matched, arguments);
  if (!arguments.loft) return blend;
  const std::optional<match::Place> start = loftStart(matched, blend.orders(), arguments.order);
  if (!start) return blend;
  std::vector<BezierSpline> turned;
  for (const BezierSpline& curve : matched) turned.push_back(match::startingAt(curve, *start));
  return blendOf(turned, arguments);
}

/// The length of the curve to a millionth.
double lengthOf(const BezierSpline& spline) {
  constexpr double relative = 1e-6;
  double length_mm = 0;
  for (int i = 0; i < spline.segments(); ++i) {
    const BezierCurve one = segment(spline, i);
    const double polygon_mm = polygonLength(one);
    if (polygon_mm > 0) length_mm += arcLength(one, relative * polygon_mm).value_mm;
  }
  return length_mm;
}

report::BlendFrameRecord recordOf(const SplineFrame& frame, double omega) {
  report::BlendFrameRecord record{
      .omega = omega, .length_mm = lengthOf(frame.spline), .joints = {}};
  for (const SplineJoint& joint : frame.joints)
    record.joints.push_back({.joint = joint.knot,
                             .order = joint.order,
                             .beta = {joint.beta.begin(), joint.beta.end()},
                             .defects = joint.defects,
                             .remedy = nameOf(joint.remedy),
                             .moved_mm = joint.moved_mm});
  return record;
}

std::vector<BezierSpline> framesOf(const SplineBlend& blend, const BlendArguments& arguments,
                                   BlendReport& report) {
  ProgressBar bar("blending");
  const Progress progress = bar.progress();
  std::vector<BezierSpline> frames;
  const std::vector<double> omegas = evenOmegas(static_cast<std::size_t>(arguments.frames));
  for (const double omega : omegas) {
    checkProgress(progress, omega);
    const SplineFrame frame = blend.frameAt(omega);
    report.frames.push_back(recordOf(frame, omega));
    frames.push_back(frame.spline);
  }
  return frames;
}

/// The surface through the frames.
struct Loft {
  FrameLoft surface;
  std::vector<double> creases;  ///< knots of the lines at which a key curve has a corner
};

/// Faces that share an edge have the same poles along it.
constexpr double sew_mm = 1e-7;

/// \throws std::invalid_argument if the frames are all the same.
void requireMovement(const BSplineSurface& loft) {
  for (Eigen::Index row = 0; row < loft.countU(); ++row) {
    const auto line = loft.poles.leftCols<3>().middleRows(row * loft.countV(), loft.countV());
    if ((line.rowwise() - line.row(0)).rowwise().norm().maxCoeff() > sew_mm) return;
  }
  throw std::invalid_argument("all frames are the same: a loft through them has no area");
}

/// Whether all parts between creases have an area: key curves may have sides on one line.
bool haveAreas(const BSplineSurface& surface, const std::vector<double>& creases) {
  for (const BSplineSurface& part : partsBetween(surface, SurfaceDirection::U, creases)) {
    try {
      occ::requireArea(part.poles.leftCols<3>(), sew_mm);
    } catch (const std::invalid_argument&) {
      return false;
    }
  }
  return true;
}

/// The surface through the frames, and what its lines of joints are proven to be.
Loft loftOf(const SplineBlend& blend, const BlendArguments& arguments, BlendReport& report) {
  ProgressBar bar("lofting");
  FrameLoftOptions options;
  options.order = arguments.order;
  options.tolerance_mm = arguments.tolerance_mm;
  options.joint_orders = blend.orders();
  for (int& n : options.joint_orders) n = std::min(n, arguments.order);
  options.first_spans = 1;
  options.stations = evenOmegas(report.key_curves.size());
  if (arguments.in_between == "C0")
    options.kinks.assign(options.stations.begin() + 1, options.stations.end() - 1);
  options.progress = bar.progress();
  const FrameLoft loft =
      frameLoft([&](double omega) { return blend.frameAt(omega).spline; }, {0, 1}, options);
  requireMovement(loft.surface);
  report::BlendLoftRecord record{.degree_u = loft.surface.degree_u,
                                 .degree_v = loft.surface.degree_v,
                                 .poles_u = loft.surface.countU(),
                                 .poles_v = loft.surface.countV(),
                                 .distance_mm = loft.distance_mm,
                                 .reached = loft.reached && loft.ratios_positive};
  std::size_t joint = 0;
  std::vector<double> creases;
  for (const KnotLine& line :
       encloseKnotLines(loft.surface, SurfaceDirection::U, {}, report.closed)) {
    const int order = options.joint_orders.at(joint);
    record.lines.push_back(
        {.joint = static_cast<int>(++joint), .order = order, .figures = line.figures});
    const bool is_inner = line.knot < loft.surface.knots_u.back();
    if (order == 0 && is_inner) creases.push_back(line.knot);
  }
  if (!loft.ratios_positive)
    report.notes.emplace_back(
        "the loft may fold at a line of joints: the ratio of the speeds of its sides may vanish");
  if (!creases.empty() && !haveAreas(loft.surface, creases)) {
    creases.clear();
    report.notes.emplace_back(
        "the loft is one face with creases: between two corners all frames lie on one line");
  }
  record.faces = static_cast<int>(creases.size()) + 1;
  report.loft = record;
  return {.surface = loft, .creases = creases};
}

/// A face for each part between creases. Neighbours share the edge along their crease.
occ::Model modelOf(const Loft& loft) {
  if (loft.creases.empty()) {
    occ::Model model;
    model.shape = occ::faceOf(loft.surface.surface);
    return model;
  }
  std::vector<occ::BuiltItem> items;
  for (BSplineSurface& part : partsBetween(loft.surface.surface, SurfaceDirection::U, loft.creases))
    items.push_back({.geometry = std::move(part)});
  return occ::sewnModel(occ::builtModel(items), {.sew_mm = sew_mm});
}

void addKeyCurves(const KeyCurves& input, BlendReport& report) {
  const std::vector<double> omegas = evenOmegas(input.curves.size());
  for (std::size_t i = 0; i < input.curves.size(); ++i) {
    const KeyCurve& key = input.curves[i];
    report.key_curves.push_back({.input = key.input,
                                 .edges = key.edges,
                                 .points = key.points,
                                 .omega = omegas[i],
                                 .segments = key.curve.segments(),
                                 .gap_mm = key.gap_mm,
                                 .polynomial_mm = key.polynomial_mm});
  }
  report.closed = input.curves.front().curve.closed;
}

/// The file of a key curve, and its edge where the file has several.
std::string keyName(const KeyCurve& key, const BlendArguments& arguments) {
  const std::string& path = arguments.inputs[key.input];
  const bool alone = arguments.inputs.size() > 1 || key.edges.empty();
  return alone ? path : fmt::format("{}: Edge{}", path, key.edges.front());
}

/// How many joints between straight pieces are corners.
int polygonCorners(const BezierSpline& curve) {
  std::vector<bool> straight;
  for (int i = 0; i < curve.segments(); ++i) {
    const BezierCurve piece = segment(curve, i);
    const double chord_mm = (piece.point(1) - piece.point(0)).norm();
    straight.push_back(polygonLength(piece) <=
                       (1 + JointBlendOptions().frame_tolerance) * chord_mm);
  }
  const std::vector<CurveJoint> joints = measureJoints(curve, 1);
  int corners = 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (straight[i] && straight[(i + 1) % straight.size()] &&
        joints[i].angle_rad.value_or(0) > JointBlendOptions().frame_tolerance)
      ++corners;
  return corners;
}

std::string sampledNote(const SampledCurve& curve) {
  std::vector<std::string> kinds;
  if (curve.lines > 0) kinds.push_back(report::counted(curve.lines, "line"));
  if (curve.arcs > 0) kinds.push_back(report::counted(curve.arcs, "arc"));
  return fmt::format(
      "the points are samples of {}, which are the key curve: no point is further than {:.2g} mm "
      "from them",
      fmt::join(kinds, " and "), curve.distance_mm);
}

/// Lines and arcs, corners, which all frames keep, and an option without effect.
void noteKeyCurves(const KeyCurves& input, const BlendArguments& arguments, BlendReport& report) {
  if (input.curves.size() == 2 && arguments.in_between != BlendArguments().in_between)
    report.notes.push_back(fmt::format(
        "--between {} has no effect: there is no key curve between two", arguments.in_between));
  // Polygons that are drawn have few corners, sections of a mesh hundreds.
  constexpr int many_corners = 24;
  // Of a circle by eight points. Who draws a smooth curve takes more.
  constexpr double sharp_rad = 44 * radians_per_degree;
  for (const KeyCurve& key : input.curves) {
    const std::string name = keyName(key, arguments);
    if (key.sampled) report.notes.push_back(name + ": " + sampledNote(*key.sampled));
    if (const std::size_t count = key.corners.size(); count > 0)
      report.notes.push_back(fmt::format(
          "{}: {} (number {}), and {} of G0 in all frames", name,
          count == 1 ? "1 point is a corner" : fmt::format("{} points are corners", count),
          fmt::join(key.corners, ", "), count == 1 ? "a joint" : "joints"));
    if (key.turn_rad > sharp_rad)
      report.notes.push_back(fmt::format(
          "{}: a smooth curve is laid through its {} points, which turn by {:.0f} degrees "
          "on average: if they are corners, put points on the sides between them",
          name, key.points, key.turn_rad * degrees_per_radian));
    if (const int corners = polygonCorners(key.curve); corners >= many_corners)
      report.notes.push_back(fmt::format(
          "{0}: a polygon with {1} corners, all of which stay in all frames. If it samples a "
          "smooth "
          "curve, make one of it first: seamwright curve arcs {2} --tolerance MM -o smooth.step",
          name, corners, arguments.inputs[key.input]));
  }
}

/// Where a frame shrinks to a point, no defect has a value.
bool isFinite(const std::vector<double>& defects) {
  return std::ranges::all_of(defects, [](double defect) { return std::isfinite(defect); });
}

/// Key curves whose rounding can be what lowers the order of their joints.
void noteKeyRounding(const KeyCurves& input, const BlendArguments& arguments,
                     const SplineBlend& blend, BlendReport& report) {
  if (std::ranges::all_of(blend.orders(), [&](int n) { return n >= report.order; })) return;
  for (const KeyCurve& key : input.curves) {
    const auto poles = key.curve.poles.leftCols<3>();
    const double rounding_mm = roundingOf_mm(poles.cwiseAbs().colwise().maxCoeff().transpose());
    const double leg_mm = (poles.bottomRows(poles.rows() - 1) - poles.topRows(poles.rows() - 1))
                              .rowwise()
                              .norm()
                              .minCoeff();
    // A defect is relative, and that of the curvature is the rounding by the leg of the polygon.
    if (rounding_mm > JointBlendOptions().frame_tolerance * leg_mm)
      report.notes.push_back(
          fmt::format("{}: the coordinates are rounded by {:.3g} mm, which lowers the order of "
                      "joints: move the curves to the origin",
                      arguments.inputs[key.input], rounding_mm));
  }
}

/// Notes on joints whose order is lower than the one asked for, and whether all are the order that
/// the key curves have there.
bool noteOrders(const SplineBlend& blend, BlendReport& report) {
  const std::vector<int> of_keys = blend.orders();
  const auto lower = std::ranges::count_if(of_keys, [&](int n) { return n < report.order; });
  if (lower > 0)
    report.notes.push_back(fmt::format(
        "{} of {} joint{} below G{} in the key curves and {} own order in all frames", lower,
        of_keys.size(), (of_keys.size() == 1 ? "" : "s") + std::string(lower == 1 ? " is" : " are"),
        report.order, lower == 1 ? "keeps its" : "keep their"));
  std::size_t lost = 0;
  for (const report::BlendFrameRecord& frame : report.frames)
    for (std::size_t i = 0; i < frame.joints.size(); ++i)
      if (frame.joints[i].order < of_keys[i] || !isFinite(frame.joints[i].defects)) ++lost;
  if (lost > 0)
    report.notes.push_back(
        fmt::format("{} joint{} a lower order than the key curves: add a key curve between", lost,
                    lost == 1 ? " of a frame has" : "s of frames have"));
  return lost == 0;
}

std::string lineOf(const BlendReport& report) {
  return report::toLine(report::toJson(report)) + '\n';
}

void requireLoftFormat(const BlendArguments& arguments, CurveFormat format) {
  if (arguments.loft && format != CurveFormat::Model)
    throw std::runtime_error(arguments.output.model +
                             ": a loft is a surface: write .step, .iges, .brep or .bin");
}

std::vector<std::string> writeBlend(CurveFormat format, const std::vector<BezierSpline>& frames,
                                    const std::optional<Loft>& loft, BlendReport& report,
                                    const BlendArguments& arguments) {
  report.output = {.path = arguments.output.model,
                   .format = formatName(format, arguments.output.model)};
  if (format == CurveFormat::Model) {
    occ::Model model;
    if (loft)
      model = modelOf(*loft);
    else
      model.shape = occ::wiresOf(frames);
    return writeModel(std::move(model), lineOf(report), arguments.output);
  }
  const CurveText text =
      framesText(format, frames, evenOmegas(frames.size()), arguments.tolerance_mm);
  report.output->distance_mm = text.distance_mm;
  writeTexts(text.text, lineOf(report), arguments.output);
  return {};
}

void addOutputs(CLI::App& command, OutputArguments& output) {
  command
      .add_option("-o", output.model,
                  "The frames: a model (.step, .stp, .iges, .igs, .brep, .brp, .bin), .csv, or of "
                  "one plane .svg or .dxf")
      ->type_name("OUT")
      ->required();
  command.add_option("--json", output.report, "Write a JSON report to this file")
      ->type_name("FILE");
  command.add_flag("--overwrite", output.overwrite, "Replace OUT if it exists");
  command.add_flag("--overwrite-source", output.overwrite_source, "Allow OUT to replace an INPUT");
}

void addMatching(CLI::App& command, BlendArguments& arguments) {
  CLI::Option* match =
      command
          .add_option(
              "--match", arguments.match,
              "Which points of the curves correspond. features: corners and extrema of the "
              "curvature, and lengths between them, or lengths alone where they fit better; "
              "length: lengths from the beginning")
          ->check(CLI::IsMember({by_features, by_length}))
          ->capture_default_str();
  command
      .add_option(
          "--pair",
          "Places that correspond, one on each curve, in place of --match: the number of a "
          "point in its file, or a share of the length as 40%. Repeat it for further pairs; "
          "of closed curves the first pair is the start")
      ->type_name("A,B[,...]")
      ->allow_extra_args(false)
      ->expected(1, -1)
      ->excludes(match)
      ->each([&arguments](const std::string& text) { arguments.pairs.push_back(keyPair(text)); });
}

}  // namespace

void addBlendOptions(CLI::App& command, BlendArguments& arguments) {
  command
      .add_option("INPUT", arguments.inputs,
                  "Two or more files, a curve each: points (x,y or x,y,z on each line) or models "
                  "(STEP, IGES, BREP); or one model with several curves")
      ->required();
  command
      .add_option("--frames", arguments.frames,
                  "Number of curves to write, the outer ones included")
      ->type_name("N")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  command.add_option("--order", arguments.order, "n of the G^n that every joint keeps, 1 to 4")
      ->type_name("N")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  addMatching(command, arguments);
  command
      .add_option("--between", arguments.in_between,
                  "Smoothness from frame to frame at key curves between the outer ones")
      ->check(CLI::IsMember({"C0", "C1", "C2"}))
      ->capture_default_str();
  CLI::Option* exact = command.add_flag(
      "--exact", arguments.exact,
      "Keep the key curves exactly: divide them into corresponding pieces. Not given: they get "
      "common knots within the tolerance, so that curves between are fair");
  command
      .add_option("--closeness", arguments.closeness,
                  "With --exact: joints of different curves are one joint if their places differ "
                  "by at most this share of the length, 0 to 0.5")
      ->type_name("SHARE")
      ->check(CLI::Range(0.0, 0.5))
      ->needs(exact)
      ->capture_default_str();
  command.add_flag("--loft", arguments.loft,
                   "Write the surface through the frames instead of the frames");
  command
      .add_option("--tolerance", arguments.tolerance_mm,
                  "Largest distance of the loft from the frames, of curves over common knots from "
                  "the key curves, and of polynomial curves from arcs and rational curves, mm")
      ->type_name("MM")
      ->check(numberIn(Range::Positive))
      ->capture_default_str();
  command.add_flag("--closed", arguments.closed, "Join the last point of each file with its first");
  command
      .add_option(
          "--edge",
          "Edges of the model: numbers as 3 or Edge3, separated by commas, or all, each alone; "
          "give it once for each INPUT that is a model. Not given: the free edges, joined where "
          "they meet")
      ->type_name("N[,N...]")
      ->allow_extra_args(false)
      ->expected(1, -1)
      ->each([&arguments](const std::string& text) { arguments.edges.push_back(edgeList(text)); });
  addOutputs(command, arguments.output);
  exitStatus(command, "every joint keeps the order of the key curves",
             "some do not (OUT is written)");
}

int runBlend(const BlendArguments& arguments) {
  for (const std::string& input : arguments.inputs) requireCurveOutputs(input, arguments.output);
  const CurveFormat format = curveFormat(arguments.output.model);
  requireLoftFormat(arguments, format);
  const KeyCurves input = keyCurves(arguments);
  BlendReport report{.inputs = input.facts,
                     .order = arguments.order,
                     .tolerance_mm = arguments.tolerance_mm,
                     .match = arguments.pairs.empty() ? arguments.match : "pairs",
                     .in_between = arguments.in_between,
                     .reached = true};
  addKeyCurves(input, report);
  noteKeyCurves(input, arguments, report);
  std::optional<Loft> loft;
  std::vector<BezierSpline> frames;
  try {
    const SplineBlend blend = blendOf(input, arguments, report);
    frames = framesOf(blend, arguments, report);
    noteKeyRounding(input, arguments, blend, report);
    report.reached = noteOrders(blend, report) && report.reached;
    if (arguments.loft) loft = loftOf(blend, arguments, report);
  } catch (const FrameFault& fault) {  // a curve that core can't match or blend
    throw std::runtime_error(keyName(input.curves.at(fault.frame()), arguments) + ": " +
                             fault.reason());
  } catch (const std::invalid_argument& error) {  // all curves together
    throw std::runtime_error(
        fmt::format("{}: {}", fmt::join(arguments.inputs, ", "), error.what()));
  }
  if (loft) report.reached = report.reached && report.loft->reached;
  const std::vector<std::string> notes = writeBlend(format, frames, loft, report, arguments);
  warn(arguments.output.model, notes);
  writeStandardOutput(report::toText(report));
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i)
    warn(arguments.inputs[i], input.notes[i]);
  return report.reached ? 0 : 1;
}

}  // namespace seamwright::cli
