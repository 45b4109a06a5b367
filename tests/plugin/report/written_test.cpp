// SPDX-License-Identifier: LGPL-2.1-or-later
// What becomes of a file that is not as good as the model in memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/plugin/report/written.hpp>

#include "files.hpp"
#include "shapes.hpp"

namespace seamwright::report {
namespace {

using test::contentOf;
using test::Folder;
using testing::HasSubstr;

occ::SeamResult defect(int edge, int one, int other) {
  occ::SeamResult seam;
  seam.edges = {edge};
  seam.faces = {one, other};
  return seam;
}

ModelCounts counts(std::vector<occ::SeamResult> defects) {
  ModelCounts made;
  made.faces = 6;
  made.edges = 12;
  made.defects = static_cast<int>(defects.size());
  made.defect_seams = std::move(defects);
  return made;
}

double statedAccuracy(const std::filesystem::path& path) {
  std::smatch found;
  const std::string text = contentOf(path);
  return std::regex_search(
             text, found, std::regex(R"(UNCERTAINTY_MEASURE_WITH_UNIT\(LENGTH_MEASURE\(([^)]*)\))"))
             ? std::stod(found[1])
             : 0;
}

/// A box from a STEP file, which is written to out.step; what is counted in each file that is read
/// back is said beforehand.
class WriteJudged : public testing::Test {
 protected:
  WriteJudged() {
    test::writeStep(test::box(), folder_ / "in.step", "MM");
    model_ = occ::readModel(folder_ / "in.step");
    stated_ = statedAccuracy(folder_ / "in.step");
  }

  /// The last of the counts goes for all further files.
  JudgedFile written(std::vector<ModelCounts> found, ModelCounts memory, bool has_given = false,
                     const std::function<void(const WrittenModel&)>& accepted = {}) {
    const Judge judge = [&](const occ::Model& model, const occ::Progress&) {
      EXPECT_EQ(model.faceCount(), 6);
      return found[std::min(looks_++, found.size() - 1)];
    };
    return writeJudged(model_, out_, {}, {judge, std::move(memory), has_given ? &model_ : nullptr},
                       {}, accepted);
  }

  /// Nothing lies about.
  void expectFiles(std::ptrdiff_t count) const {
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / ""),
                            std::filesystem::directory_iterator()),
              count);
  }

  Folder folder_;
  std::filesystem::path out_ = folder_ / "out.step";
  occ::Model model_;
  double stated_ = 0;
  std::size_t looks_ = 0;
};

TEST_F(WriteJudged, AFileAsGoodAsTheModelIsKeptAtOnce) {
  const JudgedFile file = written({counts({defect(3, 1, 2)})}, counts({defect(5, 2, 1)}));
  EXPECT_EQ(looks_, 1u);
  EXPECT_EQ(statedAccuracy(out_), stated_);
  EXPECT_TRUE(file.model.only_in_file.empty());
  EXPECT_TRUE(file.report.notes.empty());
  EXPECT_EQ(file.model.differences(counts({defect(5, 2, 1)})), "");
  expectFiles(2);
}

TEST_F(WriteJudged, ATenthOfTheAccuracyIsTried) {
  const JudgedFile file = written({counts({defect(3, 1, 2)}), counts({})}, counts({}));
  EXPECT_NEAR(statedAccuracy(out_), stated_ / 10, 1e-12 * stated_);
  EXPECT_EQ(file.model.found.defects, 0);
  ASSERT_EQ(file.report.notes.size(), 1u);
  EXPECT_THAT(file.report.notes[0], HasSubstr("a tenth of the accuracy"));
  expectFiles(2);
}

TEST_F(WriteJudged, TheBetterOfTwoIsKept) {
  const ModelCounts two = counts({defect(3, 1, 2), defect(4, 2, 3)}),
                    one = counts({defect(4, 2, 3)});
  const JudgedFile better = written({two, one, one}, counts({}));
  EXPECT_NEAR(statedAccuracy(out_), stated_ / 10, 1e-12 * stated_);
  EXPECT_EQ(better.model.found.defects, 1);
  looks_ = 0;
  std::filesystem::remove(out_);
  const JudgedFile first = written({one, two, one}, counts({}));
  EXPECT_EQ(statedAccuracy(out_), stated_);
  EXPECT_EQ(first.model.found.defects, 1);
  EXPECT_TRUE(first.report.notes.empty());
}

TEST_F(WriteJudged, DefectsInTheFileAloneAreNamedWithWhatWritingSpoils) {
  const ModelCounts memory = counts({defect(3, 1, 2), defect(9, 4, 5)});
  // Edge 3 has another number, edge 9 is smooth, and edges 4 and 7 are defects in the file alone.
  // Of the unchanged model writing spoils edge 7.
  const ModelCounts file = counts({defect(1, 2, 1), defect(4, 2, 3), defect(7, 3, 6)});
  const ModelCounts rewritten = counts({defect(7, 3, 6), defect(3, 1, 2)}),
                    given = counts({defect(3, 1, 2)});
  const JudgedFile written_file = written({file, file, rewritten, given, file}, memory, true);
  ASSERT_EQ(written_file.model.only_in_file.size(), 2u);
  EXPECT_EQ(written_file.model.only_in_file[0].edges, std::vector{4});
  EXPECT_EQ(written_file.model.spoilt_by_writing, 1);
  ASSERT_EQ(written_file.model.worse.size(), 1u);
  EXPECT_EQ(written_file.model.worse[0].edges, std::vector{4});
  const std::string text = written_file.model.differences(memory);
  EXPECT_THAT(text, HasSubstr("Edge4 (faces 2-3), Edge7 (faces 3-6); writing spoils 1 of them"));
  const nlohmann::json json = toJson(written_file.model);
  EXPECT_EQ(json["only_in_file"][1]["faces"], (std::vector{3, 6}));
  EXPECT_EQ(json["spoilt_by_writing"], 1);
  expectFiles(2);
}

TEST_F(WriteJudged, ASeamThatIsRepairedInMemoryAloneIsNotWorse) {
  const ModelCounts memory = counts({}), given = counts({defect(5, 2, 1)});
  const ModelCounts file = counts({defect(3, 1, 2), defect(4, 1, 2)});
  const JudgedFile written_file = written({file, file, given, given, file}, memory, true);
  EXPECT_EQ(written_file.model.only_in_file.size(), 2u);
  EXPECT_EQ(written_file.model.spoilt_by_writing, 0);
  ASSERT_EQ(written_file.model.worse.size(), 1u);
  EXPECT_EQ(written_file.model.worse[0].edges, std::vector{4});
}

/// A seam with a kink.
occ::SeamResult kink(int edge, double angle_rad, Level level = Level::G0) {
  occ::SeamResult seam = defect(edge, 1, 2);
  seam.verdict.level = level;
  seam.figures.angle_rad = Figure{angle_rad, angle_rad, 0};
  return seam;
}

/// Of two kinks edge 4 is another one in the file; what writing the unchanged model makes of them.
WrittenModel writtenKinks(
    const std::function<JudgedFile(std::vector<ModelCounts>, ModelCounts, bool)>& write,
    const occ::SeamResult& in_file, const ModelCounts& rewritten) {
  const ModelCounts memory = counts({kink(3, 0.02), kink(4, 0.1)}),
                    file = counts({kink(3, 0.021), in_file});
  return write({file, file, rewritten, memory, file}, memory, true).model;
}

TEST_F(WriteJudged, ADefectThatIsLargerInTheFileIsWorse) {
  const auto write = [this](auto... given) { return written(given...); };
  const WrittenModel found =
      writtenKinks(write, kink(4, 0.12), counts({kink(3, 0.02), kink(4, 0.1)}));
  ASSERT_EQ(found.worse.size(), 1u);
  EXPECT_EQ(found.worse[0].edges, std::vector{4});
}

TEST_F(WriteJudged, ADefectOfALowerLevelInTheFileIsWorse) {
  const auto write = [this](auto... given) { return written(given...); };
  const WrittenModel found =
      writtenKinks(write, kink(4, 0.1, Level::None), counts({kink(3, 0.02), kink(4, 0.1)}));
  ASSERT_EQ(found.worse.size(), 1u);
  EXPECT_EQ(found.worse[0].edges, std::vector{4});
}

TEST_F(WriteJudged, WhatWritingAloneMakesLargerIsNotWorse) {
  const auto write = [this](auto... given) { return written(given...); };
  const WrittenModel found =
      writtenKinks(write, kink(4, 0.12), counts({kink(3, 0.02), kink(4, 0.12)}));
  EXPECT_EQ(found.only_in_file.size(), 1u);
  EXPECT_TRUE(found.worse.empty());
}

TEST_F(WriteJudged, FacesThatHaveOtherNumbersInTheFileAreTold) {
  ModelCounts memory = counts({defect(2, 1, 2)}), file = counts({defect(9, 5, 6)});
  memory.neighbours = {{1, 2}, {3, 4}, {3, 5}};
  file.neighbours = {{5, 6}, {1, 2}, {1, 3}};
  const JudgedFile found = written({file}, memory);
  EXPECT_TRUE(found.model.only_in_file.empty());
  EXPECT_EQ(found.model.differences(memory), "read back: numbers of faces and edges differ");
}

TEST_F(WriteJudged, WhereFacesAreOthersNoSeamIsNamed) {
  ModelCounts file = counts({defect(4, 2, 3)});
  file.faces = 7;
  const JudgedFile found = written({file}, counts({}));
  EXPECT_TRUE(found.model.only_in_file.empty());
  EXPECT_THAT(found.model.differences(counts({})), HasSubstr("1 defect, 7 faces"));
}

TEST_F(WriteJudged, WhatIsNotAcceptedIsNotWritten) {
  const auto refuse = [](const WrittenModel&) { throw std::runtime_error("no"); };
  EXPECT_THROW(written({counts({})}, counts({}), false, refuse), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(out_));
  expectFiles(1);
}

}  // namespace
}  // namespace seamwright::report
