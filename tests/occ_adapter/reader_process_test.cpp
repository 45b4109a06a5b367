// SPDX-License-Identifier: LGPL-2.1-or-later
// The reading process: missing, crashing, silent, talking nonsense. An error each time, soon, and never a hang.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "files.hpp"

namespace seamwright::test {
namespace {

using occ::ModelErrc;
using ::testing::HasSubstr;

class ReaderProcess : public ::testing::Test {
 protected:
  ReaderProcess() { writeBrep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), folder_ / "box.brep"); }

  std::string script(const std::string& commands) {
    const auto path = folder_ / "reader";
    setContent(path, "#!/bin/sh\n" + commands + "\n");
    chmod(path.c_str(), 0755);
    return path.string();
  }

  /// The error that reading the box with this program ends with, within 10 s.
  occ::ModelError errorWith(const std::string& program) {
    const Environment reader("SEAMWRIGHT_READER", program);
    const auto start = std::chrono::steady_clock::now();
    const occ::ModelError error = errorOf(folder_ / "box.brep");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_THAT(error.what(), HasSubstr("box.brep"));
    return error;
  }

  const Folder folder_;
};

TEST_F(ReaderProcess, Missing) {
  EXPECT_EQ(errorWith("/nonexistent").code(), ModelErrc::ReaderMissing);
  EXPECT_EQ(errorWith((folder_ / "box.brep").string()).code(), ModelErrc::ReaderMissing) << "not executable";
}

TEST_F(ReaderProcess, EndsWithoutAWord) {
  for (const char* program : {"/bin/false", "/bin/true"})
    EXPECT_EQ(errorWith(program).code(), ModelErrc::ReaderDied) << program;
}

TEST_F(ReaderProcess, Crashes) {
  for (const char* signal : {"SEGV", "ABRT", "KILL", "BUS"}) {
    const occ::ModelError error = errorWith(script(std::string("kill -") + signal + " $$"));
    EXPECT_EQ(error.code(), ModelErrc::ReaderDied);
    EXPECT_THAT(error.what(), HasSubstr("crashed"));
  }
}

TEST_F(ReaderProcess, UsesUpItsTime) {
  const occ::ModelError error = errorWith(script("kill -XCPU $$"));
  EXPECT_EQ(error.code(), ModelErrc::ReaderDied);
  EXPECT_THAT(error.what(), HasSubstr("did not come to an end"));
}

TEST_F(ReaderProcess, TalksNonsense) {
  const std::string zeros = R"(\0\0\0\0\0\0\0)";  // the upper seven bytes of a length
  const std::vector<std::string> answers = {
      "garbage",                                // no frame: a length of text
      R"(X\003)" + zeros + "abc",               // an unknown kind
      R"(S\001)" + zeros + "x",                 // a shape that is none
      R"(S\377\377\377\377\377\377\377\377x)",  // longer than any memory
      R"(F\002)" + zeros + "{}",                // facts without their keys
      R"(F\001)" + zeros + "x",                 // no JSON
      R"(E\002)" + zeros + "{}",                // an error without its keys
      R"(E\001)" + zeros + "x",
      R"(P\002)" + zeros + "ab",  // progress of the wrong size
      R"(E\012)" + zeros + R"({"code":1})",
  };
  for (const std::string& answer : answers) {
    SCOPED_TRACE(answer);
    const std::string program = script("printf '" + answer + "' >&3");
    try {
      const occ::ModelError error = errorWith(program);
      EXPECT_TRUE(error.code() == ModelErrc::ReaderDied || error.code() == ModelErrc::Malformed ||
                  error.code() == ModelErrc::NoShapes)
          << error.what();
    } catch (const std::exception& other) {
      ADD_FAILURE() << "not a ModelError: " << other.what();
    }
  }
}

TEST_F(ReaderProcess, ItsNonsenseDoesNotReachStandardOutput) {
  std::ostringstream shown;
  std::streambuf* const before = std::cout.rdbuf(shown.rdbuf());
  const occ::ModelError error = errorWith(script(R"(printf 'S\001\0\0\0\0\0\0\0x' >&3)"));
  std::cout.rdbuf(before);
  EXPECT_EQ(shown.str(), "");
}

TEST_F(ReaderProcess, HangsAndIsStoppedByProgress) {
  const Environment reader("SEAMWRIGHT_READER", script("exec sleep 1000"));
  int calls = 0;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(occ::readModel(folder_ / "box.brep", [&](double) { return ++calls < 5; }), occ::Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST_F(ReaderProcess, AnExceptionOfProgressPassesThrough) {
  const Environment reader("SEAMWRIGHT_READER", script("exec sleep 1000"));
  EXPECT_THROW(occ::readModel(folder_ / "box.brep", [](double) -> bool { throw std::range_error("no"); }),
               std::range_error);
}

TEST_F(ReaderProcess, ClosesItsAnswerButLivesOn) {
  const Environment reader("SEAMWRIGHT_READER", script("exec 3>&-\nsleep 3"));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(occ::readModel(folder_ / "box.brep", [](double) { return true; }), occ::ModelError);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8));
}

TEST_F(ReaderProcess, WritesToStandardOutputAreLost) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  errorWith(script("echo loud; echo louder >&2; exit 3"));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReaderProcess, IsFoundBesideTheProgram) {
  EXPECT_EQ(occ::readModel(folder_ / "box.brep").faceCount(), 6);
}

}  // namespace
}  // namespace seamwright::test
