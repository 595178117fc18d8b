// SPDX-License-Identifier: MIT
#include "hal/linux/file_flash.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hal/nor_memory.hpp"

namespace fantail::hal::on_linux {
namespace {

void complement(std::span<std::byte> bytes) {
  std::ranges::transform(bytes, bytes.begin(), [](std::byte byte) { return ~byte; });
}

}  // namespace

FileFlash::FileFlash(std::filesystem::path path, const FlashGeometry& geometry)
    : path_{std::move(path)}, geometry_{geometry} {
  if (!sensible(geometry_)) {
    refuse("a flash is a whole number of sectors, and a sector a whole number of pages");
  }
  try {
    open();
    load();
  } catch (...) {
    if (file_ >= 0) {
      ::close(file_);
    }
    throw;
  }
}

FileFlash::~FileFlash() { ::close(file_); }

void FileFlash::open() {
  // Without O_NONBLOCK the opening of a pipe or a modem would wait.
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (file_ < 0) {
    refuse(std::strerror(errno));
  }
  struct stat status{};
  if (::fstat(file_, &status) != 0) {
    refuse(std::strerror(errno));
  }
  if (!S_ISREG(status.st_mode)) {
    refuse("is not a file");
  }
  // Before the size is looked at: another process may be giving it one.
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    refuse(errno == EWOULDBLOCK ? "is the flash of another process that is running" : std::strerror(errno));
  }
}

void FileFlash::load() {
  struct stat status{};
  if (::fstat(file_, &status) != 0) {
    refuse(std::strerror(errno));
  }
  if (status.st_size == 0 && ::ftruncate(file_, static_cast<off_t>(geometry_.size)) == 0) {
    status.st_size = static_cast<off_t>(geometry_.size);
  } else if (status.st_size == 0) {
    refuse(std::strerror(errno));
  }
  if (std::cmp_not_equal(status.st_size, geometry_.size)) {
    const std::string why = "has " + std::to_string(status.st_size) + " bytes, and the flash has " +
                            std::to_string(geometry_.size) + "; is it another file?";
    refuse(why.c_str());
  }
  cells_.resize(geometry_.size);
  for (std::size_t at = 0; at < cells_.size();) {
    const ssize_t size = ::pread(file_, cells_.data() + at, cells_.size() - at, static_cast<off_t>(at));
    if (size <= 0 && !(size < 0 && errno == EINTR)) {
      refuse(size == 0 ? "became shorter while it was read" : std::strerror(errno));
    }
    at += size > 0 ? static_cast<std::size_t>(size) : 0;
  }
  complement(cells_);
}

void FileFlash::refuse(const char* why) const { throw std::runtime_error{path_.string() + ": " + why}; }

FlashResult FileFlash::read(std::uint32_t address, std::span<std::byte> out) {
  return failed_ ? FlashResult::failed : NorMemory{cells_, geometry_}.read(address, out);
}

FlashResult FileFlash::program(std::uint32_t address, std::span<const std::byte> bytes) {
  if (failed_) {
    return FlashResult::failed;
  }
  const FlashResult result = NorMemory{cells_, geometry_}.program(address, bytes);
  return result == FlashResult::ok ? write_through(address, bytes.size()) : result;
}

FlashResult FileFlash::erase_sector(std::uint32_t address) {
  if (failed_) {
    return FlashResult::failed;
  }
  const FlashResult result = NorMemory{cells_, geometry_}.erase_sector(address);
  if (result != FlashResult::ok) {
    return result;
  }
  const int punched = ::fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(address),
                                  static_cast<off_t>(geometry_.sector_size));
  return punched == 0 ? FlashResult::ok
                      : write_through(address, geometry_.sector_size);  // no holes in this file system
}

FlashResult FileFlash::write_through(std::uint32_t address, std::size_t size) {
  std::vector<std::byte> bytes{cells_.begin() + address, cells_.begin() + address + static_cast<std::ptrdiff_t>(size)};
  complement(bytes);
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t written = ::pwrite(file_, bytes.data() + at, bytes.size() - at, static_cast<off_t>(address + at));
    if (written < 0 && errno != EINTR) {
      failed_ = true;
      return FlashResult::failed;
    }
    at += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
  return FlashResult::ok;
}

}  // namespace fantail::hal::on_linux
