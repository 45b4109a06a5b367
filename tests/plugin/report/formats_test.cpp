// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>
#include <seamwright/plugin/report/blend_surface_json.hpp>
#include <seamwright/plugin/report/csv.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <sstream>

namespace seamwright::report {
namespace {

using testing::ContainsRegex;
using testing::DoubleNear;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

using Json = nlohmann::ordered_json;

constexpr double degree = std::numbers::pi / 180;

/// Seam 1 is smooth and certain, 2 a defect whose angle may be within the limit, 3 matched and only
/// sampled.
occ::Report madeByHand() {
  occ::SeamResult smooth;
  smooth.id = 1;
  smooth.edges = {7};
  smooth.faces = {1, 2};
  smooth.length_mm = 12.5;
  smooth.figures.gap_mm = Figure{0, 1e-13, 0};
  smooth.figures.angle_rad = Figure{0.05 * degree, 0.0500001 * degree, 0.25};
  smooth.figures.curvature_per_mm = Figure{0.001, 0.0011, 0.5};
  smooth.figures.curvature_rel = Figure{0.01, 0.011, 0.5};
  smooth.figures.curvature_change_per_mm2 = Figure{0.0002, 0.0003, 0.75};
  smooth.figures.curvature_change_rel = Figure{0.3, 0.4, 0.75};
  smooth.figures.certified = true;
  smooth.verdict = {Level::G2, SeamClass::Smooth, true};
  smooth.worst = occ::WorstPoint{"curvature_change", 0.75, {1.5, -2, 3}};

  occ::SeamResult doubtful = smooth;
  doubtful.id = 2;
  doubtful.edges = {8};
  doubtful.figures.angle_rad = Figure{0.09 * degree, 0.12 * degree, 0.25};
  doubtful.verdict = {Level::G0, SeamClass::Defect, false};
  doubtful.note = "face 2: rebuilt";

  occ::SeamResult sampled;
  sampled.id = 3;
  sampled.kind = occ::SeamKind::Matched;
  sampled.edges = {9, 12};
  sampled.faces = {3, 4};
  sampled.figures.gap_mm = Figure{0.004, {}, 1};
  sampled.figures.angle_rad = Figure{2 * degree, {}, 0};
  sampled.figures.uncertified = "degree 31, 17";
  sampled.verdict = {Level::G0, SeamClass::Defect, false};

  occ::Report report;
  report.model = {"part.step", "STEP", "millimetre", 4, 12, {}};
  report.level = Level::G1;
  report.seams = {smooth, doubtful, sampled};
  return report;
}

TEST(Json, FiguresAreEnclosuresAndCertifiedIsTheVerdict) {
  const auto json = toJson(madeByHand());
  const auto& smooth = json["seams"][0];
  EXPECT_EQ(smooth["gap_mm"], (Json{{"lower", 0.0}, {"upper", 1e-13}, {"at", 0.0}}));
  EXPECT_THAT(smooth["angle_deg"]["upper"].get<double>(), DoubleNear(0.0500001, 1e-15));
  EXPECT_EQ(smooth["curvature_change_per_mm2"]["upper"], 0.0003);
  EXPECT_EQ(smooth["curvature_change_rel"]["lower"], 0.3);
  EXPECT_EQ(smooth["certified"], true);
  EXPECT_EQ(smooth["worst"],
            (Json{{"quantity", "curvature_change"}, {"at", 0.75}, {"point", {1.5, -2.0, 3.0}}}));
  const auto& sampled = json["seams"][2];
  EXPECT_EQ(sampled["kind"], "matched");
  EXPECT_EQ(sampled["edges"], (Json{9, 12}));
  EXPECT_TRUE(sampled["gap_mm"]["upper"].is_null());
  EXPECT_TRUE(sampled["curvature_change_rel"].is_null());
  EXPECT_TRUE(sampled["worst"].is_null());
  EXPECT_EQ(sampled["certified"], false);
}

TEST(Json, ASeamWithAllBoundsIsNotCertifiedWhileItsVerdictIsOpen) {
  EXPECT_EQ(toJson(madeByHand())["seams"][1]["certified"], false);
  occ::Report clear = madeByHand();
  clear.seams[2].verdict.certain = true;  // 2 degrees seen are a defect whatever else there is
  EXPECT_EQ(toJson(clear)["seams"][2]["certified"], true);
}

TEST(Json, TheSummaryCountsOpenVerdictsAndMatchedSeams) {
  const auto json = toJson(madeByHand())["summary"];
  EXPECT_EQ(json["uncertified"], 2);
  EXPECT_EQ(json["matched_seams"], 1);
}

TEST(Note, SaysWhyAVerdictIsOpen) {
  const occ::Report report = madeByHand();
  EXPECT_EQ(noteOf(report.seams[0], report.tolerance), "");
  EXPECT_EQ(noteOf(report.seams[1], report.tolerance),
            "face 2: rebuilt; not certified: angle is 0.09..0.12 deg, limit 0.1 deg");
  EXPECT_EQ(noteOf(report.seams[2], report.tolerance), "not certified: degree 31, 17");
}

TEST(Note, SaysWhyABoundIsMissingUnderACertainVerdict) {
  occ::Report report = madeByHand();
  report.seams[2].verdict.certain = true;
  EXPECT_EQ(noteOf(report.seams[2], report.tolerance), "no upper bound: degree 31, 17");
}

TEST(Note, NamesTheFigureThatHoldsItsLimit) {
  const occ::Report report = madeByHand();
  const auto noteWith = [&](std::optional<Figure> SeamFigures::*figure, Figure value) {
    occ::SeamResult seam;
    seam.figures.*figure = value;
    return noteOf(seam, report.tolerance);
  };
  EXPECT_THAT(noteWith(&SeamFigures::gap_mm, {0.009, 0.02, 0}),
              HasSubstr("gap is 0.009..0.02 mm, limit 0.01 mm"));
  EXPECT_THAT(noteWith(&SeamFigures::angle_rad, {4 * degree, 6 * degree, 0}),
              HasSubstr("4..6 deg, limit 5 deg"));
  EXPECT_THAT(noteWith(&SeamFigures::curvature_rel, {0.01, 0.03, 0}),
              HasSubstr("curvature is 1..3 %, limit 2 %"));
  EXPECT_THAT(noteWith(&SeamFigures::curvature_change_rel, {0.01, 0.03, 0}),
              HasSubstr("change of curvature is 1..3 %, limit 2 %"));
  EXPECT_EQ(noteWith(&SeamFigures::gap_mm, {0.02, 0.03, 0}), "");
}

TEST(LeftOut, IsInJsonAndNote) {
  occ::Report report = madeByHand();
  occ::SeamResult& seam = report.seams[0];
  EXPECT_EQ(toJson(seam, report.tolerance)["left_out"], (Json{{"angle_deg", Json::array()},
                                                              {"curvature_per_mm", Json::array()},
                                                              {"curvature_rel", Json::array()}}));
  seam.figures.angle_left_out = {{{0.9995, 1}}, std::nullopt};
  seam.figures.curvature_left_out = {{{0, 1e-6}, {0.25, 0.250001}, {0.9995, 1}}, std::nullopt};
  const Json intervals = Json::parse("[[0.0, 1e-6], [0.25, 0.250001], [0.9995, 1.0]]");
  EXPECT_EQ(toJson(seam, report.tolerance)["left_out"],
            (Json{{"angle_deg", Json::parse("[[0.9995, 1.0]]")},
                  {"curvature_per_mm", intervals},
                  {"curvature_rel", intervals}}));
  const std::string intervals_text =
      "the angle leaves out the last 0.0005 of the seam; "
      "the curvature leaves out the first 1e-06, 0.25 to 0.250001, the last 0.0005 of the seam";
  EXPECT_EQ(noteOf(seam, report.tolerance), intervals_text);
  occ::SeamResult many = seam;
  many.figures.angle_left_out = {};
  many.figures.curvature_left_out = {
      {{0.25, 0.25 + 1e-9}, {0.5, 0.5001}, {0.6, 0.7}, {0.8, 0.9}, {0.95, 0.96}}, std::nullopt};
  EXPECT_EQ(noteOf(many, report.tolerance),
            "the curvature leaves out 1e-09 at 0.25, 0.5 to 0.5001, 0.6 to 0.7 and 2 more "
            "intervals of the seam");
  seam.verdict.certain = false;
  EXPECT_EQ(
      noteOf(seam, report.tolerance),
      intervals_text + "; not certified: angle is unknown where it is left out, limit 0.1 deg");
  seam.figures.angle_left_out.upper = 0.2 * degree;
  EXPECT_THAT(noteOf(seam, report.tolerance),
              EndsWith("angle is up to 0.2 deg where it is left out, limit 0.1 deg"));
  seam.figures.angle_left_out = {};
  EXPECT_THAT(noteOf(seam, report.tolerance),
              EndsWith("curvature is unknown where it is left out, limit 2 %"));
}

TEST(Table, WritesEnclosuresAndMarksOpenVerdicts) {
  const std::string table = toTable(madeByHand());
  EXPECT_THAT(
      table,
      HasSubstr("\ndefect?  G0     Edge8         1-2    shared      12.500  \u22641e-13  0.09..0.12"
                "       1..1.1    30..40  face 2: rebuilt; not certified: angle is"));
  EXPECT_THAT(table, ContainsRegex("\ndefect\\?  G0     Edge9,Edge12  3-4    matched"));
  EXPECT_THAT(table, ContainsRegex("\u22650.004 +\u22652 +- +-  not certified: degree 31, 17\n"));
  EXPECT_THAT(table, ContainsRegex("\nsmooth   G2 .* 0.05 "));
  EXPECT_THAT(table, HasSubstr("3 seams, 1 of them matched: 2 defects"));
  EXPECT_THAT(
      table,
      EndsWith(
          "FAILED: 2 defects at level G1; 1 of 3 verdicts certain, the others are marked ?\n"));
}

TEST(Table, HasNoMarkAndNoEmptyColumnWhereAllIsCertain) {
  occ::Report report = madeByHand();
  report.seams.resize(1);
  report.seams[0].figures.curvature_change_rel.reset();
  const std::string table = toTable(report);
  EXPECT_THAT(table, Not(HasSubstr("?")));
  EXPECT_THAT(table, Not(HasSubstr("change")));
  EXPECT_THAT(table, EndsWith("PASSED: no defects at level G1; 1 of 1 verdict certain\n"));
}

TEST(Table, OfABlendHasARowForASideWithoutSeams) {
  occ::BlendSurfaceReport blend;
  blend.seams.push_back({.result = madeByHand().seams[0], .level = Level::G1});
  blend.ends.resize(2);
  blend.ends[0] = {"start", {7}, {1}, 12.5, 12.5, Level::G1, ""};
  blend.ends[1] = {"end", {8, 9}, {3}, 20, 5, Level::G2, "seams cover 5 of 20 mm"};
  const std::string table = toTable(blend, {}, {}, std::nullopt);
  EXPECT_THAT(table, ContainsRegex("\nG1 +G2 +Edge7 +Face1 +12.500"));
  EXPECT_THAT(table, ContainsRegex("\nG2 +none +Edge8, Edge9 +Face3 +15.000.* "
                                   "end: seams cover 5 of 20 mm\n"));
  EXPECT_THAT(table, EndsWith("NOT REACHED: a seam, or a part of a side, falls short\n"));
  EXPECT_EQ(sidesJson(blend)[1]["reason"], "seams cover 5 of 20 mm");
}

TEST(Table, ColumnsStandBelowOneAnother) {
  std::istringstream lines(toTable(madeByHand()));
  std::string line;
  std::vector<std::size_t> ends;
  while (std::getline(lines, line)) {
    const auto mark = line.find("shared");
    if (mark == std::string::npos) continue;
    std::string letters;
    for (const char c : line)
      if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) letters += c;
    ends.push_back(letters.find("1e-13"));
  }
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0], ends[1]);
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> all(1);
  for (const char c : line) {
    if (c == ',')
      all.emplace_back();
    else if (c != '\n')
      all.back() += c;
  }
  return all;
}

TEST(Csv, HasLowerUpperAndPlaceOfEachFigure) {
  occ::Report report = madeByHand();
  report.seams[2].figures.uncertified.clear();
  const auto names = fields(csvHeader());
  std::istringstream rows(csvRows(report));
  std::vector<std::vector<std::string>> cells;
  for (std::string row; std::getline(rows, row);) cells.push_back(fields(row));
  ASSERT_EQ(cells.size(), 3U);
  cells[1].resize(names.size());  // the comma in the quoted note is not a separator
  const auto cell = [&](std::size_t row, const std::string& name) {
    return cells[row].at(static_cast<std::size_t>(std::ranges::find(names, name) - names.begin()));
  };
  ASSERT_EQ(cells[0].size(), names.size());
  ASSERT_EQ(cells[2].size(), names.size());
  EXPECT_EQ(std::stod(cell(0, "gap_mm_upper")), 1e-13);
  EXPECT_EQ(std::stod(cell(0, "curvature_change_per_mm2_lower")), 0.0002);
  EXPECT_EQ(std::stod(cell(0, "curvature_change_rel_at")), 0.75);
  EXPECT_EQ(cell(0, "certified"), "true");
  EXPECT_EQ(cell(0, "worst"), "curvature_change");
  EXPECT_EQ(std::stod(cell(0, "worst_y_mm")), -2);
  EXPECT_EQ(cell(2, "edges"), "9 12");
  EXPECT_EQ(cell(2, "angle_deg_upper"), "");
  EXPECT_EQ(cell(2, "worst_z_mm"), "");
  EXPECT_EQ(cell(2, "certified"), "false");
}

}  // namespace
}  // namespace seamwright::report
