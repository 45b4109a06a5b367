// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/target_file.hpp>
#include <seamwright/occ_adapter/model/unfinished_files.hpp>

namespace seamwright::occ {

namespace {

namespace fs = std::filesystem;

/// Bytes written at a time, between two looks at whether to stop.
constexpr std::size_t portion = 1 << 20;

[[noreturn]] void fail(const fs::path& target, int error) {
  throw ModelError(ModelErrc::NotWritable, target,
                   "can't be written: " + std::generic_category().message(error));
}

fs::path folderOf(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// How names of files beside the target begin; a number and ".part" follow.
std::string stemBeside(const fs::path& target) {
  return "." + target.filename().string().substr(0, 200) + ".";
}

bool isBeside(const std::string& name, const std::string& stem) {
  const std::string end = ".part";
  if (name.size() <= stem.size() + end.size() || name.rfind(stem, 0) != 0 ||
      name.compare(name.size() - end.size(), end.size(), end) != 0)
    return false;
  return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem.size()),
                     name.end() - static_cast<std::ptrdiff_t>(end.size()),
                     [](char c) { return c >= '0' && c <= '9'; });
}

/// Whoever writes a file beside a target holds its lock, which ends with the process however that
/// ends.
bool locked(int file) {
  return ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

/// Takes away what processes that were killed left beside the target.
void sweepBeside(const fs::path& target) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folderOf(target), error)) {
    if (!isBeside(entry.path().filename().string(), stemBeside(target))) continue;
    const int file = ::open(entry.path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    if (entry.is_regular_file(error) && locked(file)) ::unlink(entry.path().c_str());
    ::close(file);
  }
}

/// A new file beside the target; gone with the object, unless it took the target's place.
class Beside {
 public:
  explicit Beside(const fs::path& target) : target_(target) {
    sweepBeside(target);
    while (!create()) {
    }
    lock_ = ::fcntl(file_, F_DUPFD_CLOEXEC, 0);
  }
  ~Beside() {
    if (file_ >= 0) ::close(file_);
    if (!path_.empty()) {
      const UnfinishedFiles files = unfinishedFiles();
      ::unlink(path_.c_str());
      files.paths.erase(path_);
    }
    if (lock_ >= 0) ::close(lock_);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  const fs::path& path() const { return path_; }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(target_, errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void takePlace(bool replace) {
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::fchmod(file_, old.st_mode & 07777);
    if (::fsync(file_) != 0) fail(target_, errno);
    const int closed = ::close(file_);
    file_ = -1;
    if (closed != 0) fail(target_, errno);
    {
      const UnfinishedFiles files = unfinishedFiles();
      rename(replace);
      files.some_finished = true;
      files.paths.erase(path_);
      path_.clear();
    }
    flushFolder();
  }

 private:
  /// \returns whether the file is there, and not taken for a stale one before it was locked. Some
  /// file systems have no locks: nothing is swept there.
  bool create() {
    path_ = folderOf(target_) /
            (stemBeside(target_) + std::to_string(std::random_device()()) + ".part");
    const UnfinishedFiles files = unfinishedFiles();
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0 && errno == EEXIST) return false;
    if (file_ < 0) fail(target_, errno);
    struct stat now {};
    if ((locked(file_) || errno != EWOULDBLOCK) && ::fstat(file_, &now) == 0 && now.st_nlink > 0) {
      files.paths.insert(path_);
      return true;
    }
    ::close(file_);
    return false;
  }

  void rename(bool replace) {
    if (!replace) {
      if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0)
        return;
      // Some file systems can't promise that; the target was missing a moment ago.
      if (errno != EINVAL && errno != ENOSYS) fail(target_, errno);
      if (fs::exists(target_)) fail(target_, EEXIST);
    }
    if (::rename(path_.c_str(), target_.c_str()) != 0) fail(target_, errno);
  }

  /// The new name is on the disk too, where the file system can say so.
  void flushFolder() const {
    const int folder = ::open(folderOf(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    ::fsync(folder);
    ::close(folder);
  }

  fs::path target_;
  fs::path path_;
  int file_ = -1;
  int lock_ = -1;  ///< the same file: the lock outlives file_, until the name is the target's
};

}  // namespace

fs::path withoutLinks(const fs::path& target) {
  constexpr int most_links = 40;  // as the kernel of Linux follows
  std::error_code error;
  fs::path real = target;
  // Where a link leads to nothing it is not followed by canonical names.
  for (int k = 0; k < most_links && !fs::exists(real, error) &&
                  fs::is_symlink(fs::symlink_status(real, error));
       ++k) {
    const fs::path next = fs::read_symlink(real, error);
    if (error) return target;
    real = folderOf(real) / next;
  }
  const fs::path canonical = fs::weakly_canonical(real, error);
  return error ? real : canonical;
}

void requireWritable(const fs::path& target, bool replace) {
  const fs::path real = withoutLinks(target);
  std::error_code error;
  const fs::file_status status = fs::status(real, error);
  if (fs::is_symlink(fs::symlink_status(real, error)))
    throw ModelError(ModelErrc::NotWritable, target,
                     "can't be written: it is a link that leads to itself");
  if (fs::is_directory(status))
    throw ModelError(ModelErrc::NotAFile, target, "is a folder, not a model file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw ModelError(ModelErrc::NotAFile, target, "is not a regular file");
  if (fs::exists(status) && !replace)
    throw ModelError(ModelErrc::TargetExists, target,
                     "already exists; set overwrite or choose another name");
  const fs::path folder = folderOf(real);
  if (!fs::is_directory(folder, error))
    throw ModelError(ModelErrc::NotWritable, target,
                     "can't be written: there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw ModelError(ModelErrc::NotWritable, target,
                     "can't be written: no new file may be made in " + folder.string());
}

void replaceFile(const fs::path& target, std::string_view content, bool replace,
                 const std::function<void(const fs::path&)>& check, const Progress& progress) {
  requireWritable(target, replace);
  Beside beside(withoutLinks(target));
  for (std::size_t at = 0; at < content.size(); at += portion) {
    beside.write(content.substr(at, portion));
    if (progress && !progress(static_cast<double>(std::min(at + portion, content.size())) /
                              static_cast<double>(content.size())))
      throw Cancelled();
  }
  if (check) check(beside.path());
  beside.takePlace(replace);
}

}  // namespace seamwright::occ
