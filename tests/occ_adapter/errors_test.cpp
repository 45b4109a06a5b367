// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that can't be read: every kind of error, told with the file's name in one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <BRepBuilderAPI_MakeEdge.hxx>

#include "files.hpp"
#include "shapes.hpp"

namespace seamwright::test {
namespace {

using occ::ModelErrc;
using ::testing::HasSubstr;

void expectError(const std::filesystem::path& path, ModelErrc code, const std::string& said) {
  const occ::ModelError error = errorOf(path);
  SCOPED_TRACE(error.what());
  EXPECT_EQ(error.code(), code);
  EXPECT_THAT(error.what(), HasSubstr(path.string() + ": "));
  EXPECT_THAT(error.what(), HasSubstr(said));
  EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
}

TEST(ReadErrors, NamesAFileThatIsNotThere) {
  const Folder folder;
  expectError(folder / "none.step", ModelErrc::NotFound, "no such file");
  expectError(folder / "no-folder/none.step", ModelErrc::NotFound, "no such file");
}

TEST(ReadErrors, NamesAFolder) {
  const Folder folder;
  expectError(folder / "", ModelErrc::NotAFile, "folder");
  expectError("/dev/null", ModelErrc::NotAFile, "not a regular file");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  expectError(folder / "pipe", ModelErrc::NotAFile, "not a regular file");
}

TEST(ReadErrors, NamesAFileThatMayNotBeRead) {
  const Folder folder;
  writeStep(box(), folder / "box.step");
  ASSERT_EQ(chmod((folder / "box.step").c_str(), 0), 0);
  boundByPermissions(
      [&] { expectError(folder / "box.step", ModelErrc::NotReadable, "permissions"); });
}

TEST(ReadErrors, NotReadableUnderRoot) {
  if (!std::filesystem::exists("/proc/self/mem")) GTEST_SKIP();
  // A regular file that no one can read from its start.
  const occ::ModelError error = errorOf("/proc/self/mem");
  EXPECT_TRUE(error.code() == ModelErrc::NotReadable || error.code() == ModelErrc::Empty)
      << error.what();
}

TEST(ReadErrors, NamesAnEmptyFile) {
  const Folder folder;
  setContent(folder / "empty.step", "");
  expectError(folder / "empty.step", ModelErrc::Empty, "empty");
}

TEST(ReadErrors, NamesAnUnknownFormat) {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> contents = {
      {"Dear all, this is a letter.", "not a STEP, IGES or BREP"},
      {"\n", "not a STEP, IGES or BREP"},
      {std::string("PK\x03\x04 and so on", 14), "zip"},
      {"\x1f\x8b\x08 and so on", "gzip"},
      {"\xff\xfeI\x01", "UTF-16"},
      {std::string("I\0S\0O\0-\0001\0000\0", 12), "UTF-16"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "Git LFS"},
      {"solid cube\nfacet normal 0 0 1\n", "not a STEP, IGES or BREP"},
      {std::string(5000, '\0'), "not a STEP, IGES or BREP"}};
  for (const auto& [content, said] : contents) {
    setContent(folder / "odd.step", content);
    expectError(folder / "odd.step", ModelErrc::UnknownFormat, said);
  }
}

TEST(ReadErrors, NamesATruncatedFile) {
  const Folder folder;
  writeStep(box(), folder / "box.step");
  const std::string step = contentOf(folder / "box.step");
  for (const double share : {0.1, 0.5, 0.9, 0.999}) {
    setContent(folder / "cut.step",
               step.substr(0, static_cast<std::size_t>(share * static_cast<double>(step.size()))));
    expectError(folder / "cut.step", ModelErrc::Truncated, "truncated");
  }
  writeIges(box(), folder / "box.igs");
  const std::string iges = contentOf(folder / "box.igs");
  setContent(folder / "cut.igs", iges.substr(0, iges.size() / 2));
  expectError(folder / "cut.igs", ModelErrc::Truncated, "truncated");
}

TEST(ReadErrors, TruncatedBrepIsMalformed) {
  const Folder folder;
  writeBrep(box(), folder / "box.brep");
  writeBinaryBrep(box(), folder / "box.bin");
  for (const char* name : {"box.brep", "box.bin"}) {
    const std::string whole = contentOf(folder / name);
    for (const double share : {0.1, 0.3, 0.5, 0.8, 0.95}) {
      const auto cut = folder / ("cut_at_" + std::to_string(share) + "_" + name);
      setContent(cut, whole.substr(
                          0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
      const occ::ModelError error = errorOf(cut);
      EXPECT_TRUE(error.code() == ModelErrc::Malformed || error.code() == ModelErrc::ReaderDied ||
                  error.code() == ModelErrc::NoShapes)
          << share << " of " << name << ": " << error.what();
    }
  }
}

TEST(ReadErrors, NamesAMalformedFile) {
  const Folder folder;
  setContent(folder / "bad.step",
             "ISO-10303-21;\nHEADER;\nnothing of the kind\nEND-ISO-10303-21;\n");
  const occ::ModelError error = errorOf(folder / "bad.step");
  EXPECT_TRUE(error.code() == ModelErrc::Malformed || error.code() == ModelErrc::NoShapes)
      << error.what();
  writeBrep(box(), folder / "box.brep");
  setContent(folder / "bad.brep", replaced(contentOf(folder / "box.brep"), "Curves", "Kurven"));
  expectError(folder / "bad.brep", ModelErrc::Malformed, "BREP");
}

TEST(ReadErrors, NamesAFileWithoutShapes) {
  const Folder folder;
  const TopoDS_Shape edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Shape();
  writeStep(edge, folder / "edge.step");
  expectError(folder / "edge.step", ModelErrc::NoShapes, "no");
  writeBrep(edge, folder / "edge.brep");
  expectError(folder / "edge.brep", ModelErrc::NoShapes, "no faces");
  writeBinaryBrep(edge, folder / "edge.bin");
  expectError(folder / "edge.bin", ModelErrc::NoShapes, "no faces");
}

}  // namespace
}  // namespace seamwright::test
