// SPDX-License-Identifier: MIT
#include "elf.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

#include <cxxabi.h>
#include <elf.h>
#include <fmt/format.h>

#include "text/error.hpp"

namespace fantail::board {
namespace {

class File {
 public:
  explicit File(const std::filesystem::path& path) : path_{path} {
    if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
      throw text::Error{text::ErrorKind::no_such_input, path.string() + ": no regular file"};  // a pipe would block
    }
    std::ifstream file{path, std::ios::binary};
    if (!file) {
      throw text::Error{text::ErrorKind::no_such_input, path.string() + ": no such file, or it cannot be read"};
    }
    bytes_.assign(std::istreambuf_iterator<char>{file}, {});
  }

  template <typename T>
  [[nodiscard]] T at(std::size_t offset) const {
    T value{};
    std::memcpy(&value, part(offset, sizeof(T)), sizeof(T));
    return value;
  }
  [[nodiscard]] const char* part(std::size_t offset, std::size_t size) const {
    if (offset > bytes_.size() || size > bytes_.size() - offset) {
      refuse("it ends before its contents do");
    }
    return bytes_.data() + offset;
  }
  /// A string that ends with 0.
  [[nodiscard]] std::string text(std::size_t offset) const {
    const char* begin = part(offset, 0);
    return {begin, std::find(begin, bytes_.data() + bytes_.size(), '\0')};
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {}", path_.string(), why)};
  }

 private:
  std::filesystem::path path_;
  std::string bytes_;
};

Elf32_Ehdr head_of(const File& file) {
  const auto head = file.at<Elf32_Ehdr>(0);
  if (std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0) {
    file.refuse("not an ELF file");
  }
  if (head.e_ident[EI_CLASS] != ELFCLASS32 || head.e_ident[EI_DATA] != ELFDATA2LSB || head.e_machine != EM_ARM) {
    file.refuse(fmt::format("built for machine {} of ELF; allowed: {}, 32-bit Arm", head.e_machine, EM_ARM));
  }
  return head;
}

}  // namespace

Image::Image(const std::filesystem::path& path) : file_{path}, flash_(flash_size, std::byte{0xFF}) {
  const File file{path};
  const Elf32_Ehdr head = head_of(file);
  for (std::size_t i = 0; i < head.e_phnum; ++i) {
    const auto segment = file.at<Elf32_Phdr>(head.e_phoff + i * head.e_phentsize);
    if (segment.p_type != PT_LOAD || segment.p_filesz == 0) {
      continue;
    }
    const std::uint32_t place = segment.p_paddr - flash_begin;
    if (place > flash_size || segment.p_filesz > flash_size - place) {
      file.refuse(fmt::format("{} bytes at 0x{:08x} are outside the flash, 0x{:08x} to 0x{:08x}", segment.p_filesz,
                              segment.p_paddr, flash_begin, flash_begin + flash_size - 1));
    }
    std::memcpy(&flash_[place], file.part(segment.p_offset, segment.p_filesz), segment.p_filesz);
  }
  std::uint32_t vectors[2]{};
  std::memcpy(vectors, flash_.data(), sizeof vectors);
  if (vectors[1] - flash_begin >= flash_size || vectors[1] % 2 == 0) {
    file.refuse(fmt::format("its vector table says to begin at 0x{:08x}, which is no code in the flash", vectors[1]));
  }
  for (std::size_t i = 0; i < head.e_shnum; ++i) {
    const auto section = file.at<Elf32_Shdr>(head.e_shoff + i * head.e_shentsize);
    if (section.sh_type != SHT_SYMTAB || section.sh_entsize == 0) {
      continue;
    }
    const auto strings = file.at<Elf32_Shdr>(head.e_shoff + std::size_t{section.sh_link} * head.e_shentsize);
    for (std::size_t k = 0; k < section.sh_size / section.sh_entsize; ++k) {
      const auto symbol = file.at<Elf32_Sym>(section.sh_offset + k * section.sh_entsize);
      const auto type = ELF32_ST_TYPE(symbol.st_info);
      const std::string name = file.text(strings.sh_offset + symbol.st_name);
      if (name.empty() || name.front() == '$' || symbol.st_shndx == SHN_UNDEF || type > STT_FUNC) {
        continue;
      }
      const std::uint32_t address = type == STT_FUNC ? symbol.st_value & ~1U : symbol.st_value;
      addresses_[name] = address;
      if (type == STT_FUNC || !names_.contains(address)) {
        names_[address] = name;
      }
    }
  }
}

std::optional<std::uint32_t> Image::address_of(const std::string& symbol) const {
  const auto found = addresses_.find(symbol);
  return found == addresses_.end() ? std::nullopt : std::optional{found->second};
}

std::string Image::where(std::uint32_t address) const {
  auto next = names_.upper_bound(address);
  if (next == names_.begin()) {
    return "?";
  }
  --next;
  int failed = 0;
  const std::unique_ptr<char, decltype(&std::free)> plain{
      abi::__cxa_demangle(next->second.c_str(), nullptr, nullptr, &failed), &std::free};
  const std::string name = plain ? plain.get() : next->second;
  return next->first == address ? name : fmt::format("{} + 0x{:x}", name, address - next->first);
}

}  // namespace fantail::board
