// SPDX-License-Identifier: LGPL-2.1-or-later
// The reading process: missing, crashing, silent, talking nonsense. An error each time, soon, and
// never a hang.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <thread>

#include <seamwright/occ_adapter/model/bounds.hpp>

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

TEST_F(ReaderProcess, AMissingReaderIsTold) {
  EXPECT_EQ(errorWith("/nonexistent").code(), ModelErrc::ReaderMissing);
  EXPECT_EQ(errorWith((folder_ / "box.brep").string()).code(), ModelErrc::ReaderMissing)
      << "not executable";
}

TEST_F(ReaderProcess, EndsWithoutAWord) {
  for (const char* program : {"/bin/false", "/bin/true"})
    EXPECT_EQ(errorWith(program).code(), ModelErrc::ReaderDied) << program;
}

TEST_F(ReaderProcess, ACrashIsTold) {
  for (const char* signal : {"SEGV", "ABRT", "KILL", "BUS"}) {
    const occ::ModelError error = errorWith(script(std::string("kill -") + signal + " $$"));
    EXPECT_EQ(error.code(), ModelErrc::ReaderDied);
    EXPECT_THAT(error.what(), HasSubstr("crashed"));
  }
}

TEST_F(ReaderProcess, UsesUpItsProcessorTime) {
  const occ::ModelError error = errorWith(script("kill -XCPU $$"));
  EXPECT_EQ(error.code(), ModelErrc::ReaderDied);
  EXPECT_THAT(error.what(), HasSubstr("exceeded the time limit"));
}

TEST_F(ReaderProcess, UsesUpItsTime) {
  const Environment time("SEAMWRIGHT_READER_SECONDS", "0.25");
  for (const char* commands :
       {"exec sleep 1000", "exec 3>&-\nexec sleep 1000", "exec cat /dev/zero >&3"}) {
    const occ::ModelError error = errorWith(script(commands));
    EXPECT_EQ(error.code(), ModelErrc::ReaderDied) << commands;
    EXPECT_THAT(error.what(), HasSubstr("limit of 0.25 s")) << commands;
    EXPECT_THAT(error.what(), HasSubstr("SEAMWRIGHT_READER_SECONDS")) << commands;
  }
}

TEST_F(ReaderProcess, TimeThatProgressTakesDoesNotCount) {
  const Environment time("SEAMWRIGHT_READER_SECONDS", "3");
  int calls = 0;
  const occ::Model model = occ::readModel(folder_ / "box.brep", [&calls](double) {
    if (++calls == 1) std::this_thread::sleep_for(std::chrono::seconds(4));
    return true;
  });
  EXPECT_EQ(model.faceCount(), 6);
  EXPECT_GE(calls, 1);
}

/// A failure to allocate that OpenCASCADE catches must not pass for a fault of the file, nor cost
/// faces.
TEST_F(ReaderProcess, UsesUpItsMemory) {
  TopoDS_Compound boxes;
  BRep_Builder().MakeCompound(boxes);
  for (int i = 0; i < 30; ++i)
    BRep_Builder().Add(boxes, BRepPrimAPI_MakeBox(gp_Pnt(2 * i, 0, 0), 1, 2, 3).Shape());
  writeStep(boxes, folder_ / "boxes.step");
  writeIges(boxes, folder_ / "boxes.igs", "MM", 1);
  for (const char* name : {"boxes.step", "boxes.igs"}) {
    int read = 0, refused = 0;
    for (const double megabytes :
         {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0, 50.0}) {
      SCOPED_TRACE(testing::Message() << name << " with " << megabytes << " MB");
      const Environment memory("SEAMWRIGHT_READER_MEMORY_MB", std::to_string(megabytes));
      try {
        EXPECT_EQ(occ::readModel(folder_ / name).faceCount(), 180);
        ++read;
      } catch (const occ::ModelError& error) {
        EXPECT_EQ(error.code(), ModelErrc::ReaderDied);
        EXPECT_THAT(error.what(), HasSubstr("MB of memory"));
        EXPECT_THAT(error.what(), HasSubstr("SEAMWRIGHT_READER_MEMORY_MB"));
        ++refused;
      }
    }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 2);
  }
}

TEST_F(ReaderProcess, BoundsGrowWithTheFile) {
  const occ::ReaderBounds none = occ::readerBounds(0), large = occ::readerBounds(10'000'000);
  EXPECT_EQ(none.seconds, 60);
  EXPECT_EQ(large.seconds, 60 + 300);
  EXPECT_LE(none.memory_bytes, 4'000'000'000u);
  EXPECT_LE(large.memory_bytes, 4'500'000'000u);
  EXPECT_GT(none.memory_bytes, 0u);
}

TEST_F(ReaderProcess, BoundsThatAreNoNumbersAreRefused) {
  for (const char* name : {"SEAMWRIGHT_READER_SECONDS", "SEAMWRIGHT_READER_MEMORY_MB"})
    for (const char* value : {"", "0", "-1", "ten", "1 h", "inf", "nan", "1e300"}) {
      const Environment bound(name, value);
      try {
        occ::readModel(folder_ / "box.brep");
        ADD_FAILURE() << name << " '" << value << "' was taken";
      } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr("'" + std::string(value) + "'"));
      }
    }
}

TEST_F(ReaderProcess, CountsThatAFileCannotHoldEndSoon) {
  const std::string brep = contentOf(folder_ / "box.brep");
  for (const char* section :
       {"Locations", "Curve2ds", "Curves", "Polygon3D", "Surfaces", "TShapes"}) {
    const std::regex count(std::string(section) + " [0-9]+");
    setContent(folder_ / "count.brep",
               std::regex_replace(brep, count, std::string(section) + " 999999999",
                                  std::regex_constants::format_first_only));
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(errorOf(folder_ / "count.brep").code(), ModelErrc::Malformed) << section;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << section;
  }
}

/// Runs or waits: a process that has ended and was not waited for yet does neither.
bool isAlive(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string number, program, state;
  return file >> number >> program >> state && state != "Z" && state != "X";
}

/// \returns whether \p holds() came true within 10 s.
template <class Condition>
bool soon(const Condition& holds) {
  for (int i = 0; i < 1000 && !holds(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return holds();
}

std::filesystem::path readerBesideThisProgram() {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename().string().starts_with("seamwright-read-occt")) return entry.path();
  return {};
}

TEST_F(ReaderProcess, EndsWithItsParent) {
  // The program waits for a model on its standard input, which never comes.
  ASSERT_EQ(mkfifo((folder_ / "fifo").c_str(), 0600), 0);
  const std::string note = folder_ / "pid";
  const std::string program = script("echo $$ > " + note + ".part; mv " + note + ".part " + note +
                                     "; exec " + readerBesideThisProgram().string() +
                                     " write STEP afresh 1 '' <>" + (folder_ / "fifo").string());
  const Environment reader("SEAMWRIGHT_READER", program);
  const pid_t parent = fork();
  if (parent == 0) {
    std::thread worker([this] { occ::readModel(folder_ / "box.brep"); });
    worker.join();
    _exit(0);
  }
  ASSERT_TRUE(soon([&note] { return std::filesystem::exists(note); }));
  const pid_t child = std::stoi(contentOf(note));
  const std::filesystem::path real = std::filesystem::canonical(readerBesideThisProgram());
  std::error_code error;
  ASSERT_TRUE(soon([&] {
    return std::filesystem::read_symlink("/proc/" + std::to_string(child) + "/exe", error) == real;
  }));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_TRUE(isAlive(child));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(soon([child] { return !isAlive(child); }));
  if (isAlive(child)) kill(child, SIGKILL);
}

TEST_F(ReaderProcess, NonsenseIsRefused) {
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
  EXPECT_THROW(occ::readModel(folder_ / "box.brep", [&](double) { return ++calls < 5; }),
               occ::Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST_F(ReaderProcess, AnExceptionOfProgressPassesThrough) {
  const Environment reader("SEAMWRIGHT_READER", script("exec sleep 1000"));
  EXPECT_THROW(
      occ::readModel(folder_ / "box.brep", [](double) -> bool { throw std::range_error("no"); }),
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
