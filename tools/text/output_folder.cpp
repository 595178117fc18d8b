// SPDX-License-Identifier: MIT
#include "text/output_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <random>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fantail::text {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
  throw OutputError{path.string() + ": " + std::strerror(error)};
}

// A file-size limit would otherwise kill the program before write() can return EFBIG. The signal is that of the thread
// which writes, so it is that thread which blocks it.
class IgnoreFileSizeSignal {
 public:
  IgnoreFileSizeSignal() {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~IgnoreFileSizeSignal() {
    if (sigismember(&before_, SIGXFSZ) == 0) {
      constexpr timespec now{};
      sigtimedwait(&signal_, nullptr, &now);
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  IgnoreFileSizeSignal(const IgnoreFileSizeSignal&) = delete;
  IgnoreFileSizeSignal& operator=(const IgnoreFileSizeSignal&) = delete;

 private:
  sigset_t signal_{};
  sigset_t before_{};
};

// 64 random bits: process ids repeat, between containers too, and threads share one.
std::string token() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

// What has been done so far, and how to take it back.
class Transaction {
 public:
  explicit Transaction(fs::path folder) : folder_{std::move(folder)}, token_{token()} {}
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  ~Transaction() {
    if (!committed_) {
      undo();
    }
  }

  /// There it is, and nobody else writes into it until this has ended.
  void take_folder() {
    constexpr std::chrono::minutes patience{1};
    constexpr int tries = 100;  // who fails beside this takes the folders away that it has made
    for (int i = 1; i <= tries; ++i) {
      if (create_folder(i == tries) && lock_.take(folder_, patience)) {
        return;
      }
    }
    fail(folder_, ENOENT);
  }

  void stage(const NamedFile& file) {
    staged_.push_back(
        {.target = folder_ / file.name, .temporary = hidden(file.name, "new"), .backup = hidden(file.name, "old")});
    Staged& s = staged_.back();
    // A device or a pipe would be set aside like an old file, and whoever needs it would find a file in its place.
    struct stat info{};
    if (lstat(s.target.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISLNK(info.st_mode) &&
        !S_ISDIR(info.st_mode)) {
      throw OutputError{s.target.string() + ": is a device, a pipe or a socket, so no file can be written there"};
    }
    const int fd = open(s.temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd < 0) {
      fail(s.target, errno);
    }
    s.written = true;
    const int error = write_all(fd, file.content);
    // close() reports what the file system kept to itself until now.
    const int close_error = close(fd) == 0 ? 0 : errno;
    if (error != 0 || close_error != 0) {
      fail(s.target, error != 0 ? error : close_error);
    }
  }

  void stage_removal(const std::string& name) {
    staged_.push_back({.target = folder_ / name, .temporary = {}, .backup = hidden(name, "old"), .removal = true});
  }

  void commit() {
    for (Staged& s : staged_) {
      struct stat info{};
      // Only a file is set aside: a folder in the way makes the next rename fail, as it should.
      if (lstat(s.target.c_str(), &info) == 0 && !S_ISDIR(info.st_mode)) {
        move(s.target, s.backup, s.target);
        s.set_aside = true;
      }
      if (!s.removal) {
        move(s.temporary, s.target, s.target);
        s.in_place = true;
      }
    }
    committed_ = true;
    for (const Staged& s : staged_) {
      if (s.set_aside) {
        unlink(s.backup.c_str());
      }
    }
    // The names too should survive a power cut; a file system that cannot sync a folder has still got the files.
    if (const int fd = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); fd >= 0) {
      fsync(fd);
      close(fd);
    }
  }

 private:
  struct Staged {
    fs::path target;
    fs::path temporary;
    fs::path backup;
    bool removal = false;
    bool written = false;
    bool set_aside = false;
    bool in_place = false;
  };

  [[nodiscard]] fs::path hidden(const std::string& name, const char* kind) const {
    return folder_ / ("." + name + "." + token_ + "." + kind);
  }

  /// False when it has gone meanwhile, unless this is the last try.
  [[nodiscard]] bool create_folder(bool is_last_try) {
    fs::path part;
    for (const fs::path& step : folder_) {
      part /= step;
      if (mkdir(part.c_str(), 0777) == 0) {
        made_folders_.push_back(part);
      } else if (const int error = errno; error != EEXIST && error != EISDIR) {
        std::error_code ignored;
        if (!fs::is_directory(part, ignored)) {  // "/" and mount points may answer with EROFS or EACCES
          if (error == ENOENT && !is_last_try) {
            return false;
          }
          fail(part, error);
        }
      }
    }
    struct stat info{};
    if (stat(folder_.c_str(), &info) != 0 && errno == ENOENT && !is_last_try) {
      return false;
    }
    if (!S_ISDIR(info.st_mode)) {
      fail(folder_, ENOTDIR);
    }
    return true;
  }

  static int write_all(int fd, const std::string& content) {
    std::size_t done = 0;
    while (done < content.size()) {
      const ssize_t count = ::write(fd, content.data() + done, content.size() - done);
      if (count < 0 && errno != EINTR) {
        return errno;
      }
      done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    return fsync(fd) == 0 || errno == EINVAL ? 0 : errno;  // EINVAL: this file system has no fsync
  }

  static void move(const fs::path& from, const fs::path& to, const fs::path& blamed) {
    if (std::rename(from.c_str(), to.c_str()) != 0) {
      fail(blamed, errno);
    }
  }

  void undo() noexcept {
    for (const Staged& s : staged_) {
      if (s.in_place) {
        unlink(s.target.c_str());
      } else if (s.written) {
        unlink(s.temporary.c_str());
      }
      if (s.set_aside) {
        std::rename(s.backup.c_str(), s.target.c_str());
      }
    }
    lock_.release();  // its file would keep the folder
    for (auto folder = made_folders_.rbegin(); folder != made_folders_.rend(); ++folder) {
      rmdir(folder->c_str());
    }
  }

  fs::path folder_;
  std::string token_;
  FolderLock lock_;
  std::vector<fs::path> made_folders_;
  std::vector<Staged> staged_;
  bool committed_ = false;
};

void spare(const fs::path& input, const fs::path& target) {
  std::error_code not_there;
  if (fs::equivalent(input, target, not_there)) {
    throw OutputError{target.string() + ": these results are made from it; choose another place for them"};
  }
}

}  // namespace

void OutputFolder::write(std::span<const NamedFile> files, std::span<const std::string> removed) const {
  const IgnoreFileSizeSignal ignore;
  const fs::path folder = folder_.empty() ? fs::path{"."} : folder_;
  for (const fs::path& input : inputs_) {
    spare(input, folder);
    std::ranges::for_each(files, [&](const NamedFile& file) { spare(input, folder / file.name); });
    std::ranges::for_each(removed, [&](const std::string& name) { spare(input, folder / name); });
  }
  Transaction transaction{folder};
  transaction.take_folder();
  for (const NamedFile& file : files) {
    transaction.stage(file);
  }
  for (const std::string& name : removed) {
    transaction.stage_removal(name);
  }
  transaction.commit();
}

}  // namespace fantail::text
