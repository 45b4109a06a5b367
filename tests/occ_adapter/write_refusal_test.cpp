// SPDX-License-Identifier: LGPL-2.1-or-later
// A target is the old file or the new one, whatever happens while it is written.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include "files.hpp"
#include "shapes.hpp"
#include "support/random.hpp"
#include "written.hpp"

namespace seamwright::test {
namespace {

namespace fs = std::filesystem;
using occ::Model;
using occ::ModelErrc;
using occ::readModel;
using occ::writeModel;
using ::testing::HasSubstr;

int entriesOf(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class Refusal : public ::testing::Test {
 protected:
  Refusal() {
    writeStep(box(), folder_ / "box.step");
    model_ = readModel(folder_ / "box.step");
    source_ = contentOf(folder_ / "box.step");
    setContent(folder_ / "old.step", "old");
  }
  /// Nothing but the two files, as they were.
  void expectUntouched() const {
    EXPECT_EQ(entriesOf(folder_ / ""), 2);
    EXPECT_EQ(contentOf(folder_ / "box.step"), source_);
    EXPECT_EQ(contentOf(folder_ / "old.step"), "old");
  }

  std::string script(const fs::path& path, const std::string& commands) {
    setContent(path, "#!/bin/sh\n" + commands + "\n");
    chmod(path.c_str(), 0755);
    return path.string();
  }

  const Folder folder_;
  Model model_;
  std::string source_;
};

TEST_F(Refusal, UnknownExtension) {
  for (const char* name : {"a.stl", "a", "a.step.bak", ".step", "a."})
    EXPECT_EQ(errorOfWriting(model_, folder_ / name).code(), ModelErrc::UnknownTarget) << name;
  expectUntouched();
}

TEST_F(Refusal, FilesThatAreThere) {
  EXPECT_EQ(errorOfWriting(model_, folder_ / "old.step").code(), ModelErrc::TargetExists);
  EXPECT_EQ(errorOfWriting(model_, folder_ / "box.step").code(), ModelErrc::TargetExists);
  EXPECT_EQ(errorOfWriting(model_, folder_ / "box.step", {.overwrite = true}).code(),
            ModelErrc::TargetExists)
      << "the source needs a word of its own";
  fs::create_symlink("box.step", folder_ / "link.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "link.step", {.overwrite = true}).code(),
            ModelErrc::TargetExists);
  fs::remove(folder_ / "link.step");
  fs::create_hard_link(folder_ / "box.step", folder_ / "hard.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "hard.step", {.overwrite = true}).code(),
            ModelErrc::TargetExists);
  fs::remove(folder_ / "hard.step");
  expectUntouched();
}

TEST_F(Refusal, AllowedOverwrites) {
  chmod((folder_ / "old.step").c_str(), 0640);
  fs::create_symlink("old.step", folder_ / "link.step");
  writeModel(model_, folder_ / "link.step", {.overwrite = true});
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.step"));
  EXPECT_EQ(readModel(folder_ / "old.step").faceCount(), 6);
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder_ / "old.step").permissions()), 0640u);
  writeModel(model_, folder_ / "box.step", {.overwrite_source = true});
  EXPECT_EQ(readModel(folder_ / "box.step").faceCount(), 6);
  EXPECT_NE(contentOf(folder_ / "box.step"), source_);
  EXPECT_EQ(entriesOf(folder_ / ""), 3);
}

/// What they lead to comes to be.
TEST_F(Refusal, LinksToNothingStay) {
  fs::create_directory(folder_ / "deep");
  fs::create_symlink("deep/new.step", folder_ / "link.step");
  fs::create_symlink(folder_ / "link.step", folder_ / "deep/second.step");
  writeModel(model_, folder_ / "deep/second.step");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.step"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "deep/second.step"));
  EXPECT_FALSE(fs::is_symlink(folder_ / "deep/new.step"));
  EXPECT_EQ(readModel(folder_ / "deep/new.step").faceCount(), 6);
  fs::create_symlink("none/new.step", folder_ / "lost.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "lost.step").code(), ModelErrc::NotWritable);
  fs::create_symlink("round.step", folder_ / "round.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "round.step").code(), ModelErrc::NotWritable);
  EXPECT_TRUE(fs::is_symlink(folder_ / "round.step"));
}

TEST_F(Refusal, FoldersThatCantBeWrittenTo) {
  EXPECT_EQ(errorOfWriting(model_, folder_ / "none/a.step").code(), ModelErrc::NotWritable);
  fs::create_directory(folder_ / "dir.step");
  EXPECT_EQ(errorOfWriting(model_, folder_ / "dir.step", {.overwrite = true}).code(),
            ModelErrc::NotAFile);
  fs::remove(folder_ / "dir.step");
  expectUntouched();
  fs::permissions(folder_ / "", fs::perms::owner_read | fs::perms::owner_exec);
  boundByPermissions([&] {
    EXPECT_EQ(errorOfWriting(model_, folder_ / "a.step").code(), ModelErrc::NotWritable);
  });
  fs::permissions(folder_ / "", fs::perms::owner_all);
  expectUntouched();
}

TEST_F(Refusal, ASourceThatIsGone) {
  Model gone = model_;
  gone.path = (folder_ / "gone.step").string();
  const occ::ModelError error = errorOfWriting(gone, folder_ / "a.step");
  EXPECT_THAT(error.what(), HasSubstr("gone.step"));
  expectUntouched();
  EXPECT_EQ(written(gone, folder_ / "a.step", {.afresh = true}).faceCount(), 6);
}

/// A file that may not grow any more stands for a full disk: write() fails half-way.
TEST_F(Refusal, NoRoom) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  for (const char* name : {"a.brep", "old.step"}) {
    const rlimit little{1000, before.rlim_max};
    const Model bare = occ::modelFromShape(box());
    setrlimit(RLIMIT_FSIZE, &little);
    const occ::ModelError error = errorOfWriting(bare, folder_ / name, {.overwrite = true});
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_TRUE(error.code() == ModelErrc::NotWritable || error.code() == ModelErrc::NotWritten)
        << error.what();
    expectUntouched();
  }
  ::signal(SIGXFSZ, handler);
}

TEST_F(Refusal, TheWritingProcessFails) {
  const fs::path program = folder_ / "writer";
  for (const char* commands :
       {"exit 0", "exit 3", "kill -SEGV $$", "kill -XCPU $$", "cat > /dev/null; kill -KILL $$",
        R"(printf 'B\377\377\0\0\0\0\0\0half' >&3)", R"(printf 'S\001\0\0\0\0\0\0\0x' >&3)",
        R"(printf 'R\002\0\0\0\0\0\0\0{}' >&3)", R"(printf 'garbage' >&3)"}) {
    SCOPED_TRACE(commands);
    const Environment reader("SEAMWRIGHT_READER", script(program, commands));
    const occ::ModelError error = errorOfWriting(model_, folder_ / "old.step", {.overwrite = true});
    EXPECT_EQ(error.code(), ModelErrc::ReaderDied);
    EXPECT_THAT(error.what(), HasSubstr("can't be written"));
    fs::remove(program);
    expectUntouched();
  }
}

TEST_F(Refusal, CancelledAtEveryMoment) {
  int calls = 0;
  writeModel(model_, folder_ / "a.step", {}, [&](double share) {
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
    ++calls;
    return true;
  });
  fs::remove(folder_ / "a.step");
  ASSERT_GE(calls, 2);
  for (int stop = 1; stop <= calls; ++stop) {
    int call = 0;
    bool stopped = false;
    try {
      writeModel(model_, folder_ / "old.step", {.overwrite = true}, [&](double) {
        stopped = ++call == stop;
        return !stopped;
      });
    } catch (const occ::Cancelled&) {
      EXPECT_TRUE(stopped);
    }
    if (!stopped) break;  // it was done sooner this time
    expectUntouched();
  }
}

/// Kills a process that writes two contents in turn, sixty times, at a random moment after its
/// first file: the file is always one of the two, whole.
TEST_F(Refusal, KilledAtAnyMoment) {
  const Model one = occ::modelFromShape(box()), other = occ::modelFromShape(roundedBox());
  const fs::path target = folder_ / "target.brep";
  std::string contents[2];
  const auto begin = std::chrono::steady_clock::now();
  for (const int i : {0, 1}) {
    writeModel(i == 0 ? one : other, target, {.overwrite = true});
    contents[i] = contentOf(target);
  }
  const auto both = std::chrono::steady_clock::now() - begin;
  std::mt19937 random(testSeed());
  std::uniform_int_distribution<long> microseconds(
      0, std::chrono::duration_cast<std::chrono::microseconds>(both).count());
  int seen[2] = {0, 0};
  for (int round = 0; round < 60; ++round) {
    int written[2];
    ASSERT_EQ(pipe(written), 0);
    const pid_t writer = fork();
    if (writer == 0) {
      for (int i = round;; ++i) {
        writeModel(i % 2 == 0 ? one : other, target, {.overwrite = true});
        if (i == round && write(written[1], "1", 1) != 1) _exit(1);
      }
    }
    close(written[1]);
    char first = 0;
    ASSERT_EQ(read(written[0], &first, 1), 1);  // however busy the machine is
    close(written[0]);
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    const std::string found = contentOf(target);
    ASSERT_TRUE(found == contents[0] || found == contents[1])
        << round << ": " << found.size() << " bytes";
    ++seen[found == contents[1]];
  }
  EXPECT_GT(seen[0], 0);
  EXPECT_GT(seen[1], 0);
  for (const auto& entry : fs::directory_iterator(folder_ / ""))
    EXPECT_TRUE(entry.path().extension() != ".part" ||
                entry.path().filename().string().starts_with(".target.brep."));
}

}  // namespace
}  // namespace seamwright::test
