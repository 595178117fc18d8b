// SPDX-License-Identifier: MIT
#include "elf.hpp"

#include <cstdint>
#include <cstring>
#include <string>

#include <elf.h>

#include "system/folder.hpp"
#include "text/error.hpp"

namespace fantail::board {
namespace {

constexpr std::uint32_t begin = Image::flash_begin;

/// An image with a vector table and nothing else; each test spoils a part of it.
struct Elf {
  Elf32_Ehdr head{};
  Elf32_Phdr segment{};
  std::uint32_t vectors[2]{0x2002'0000, begin + 0x101};
  std::uint32_t rest = 0x7FFF'FFFF;  ///< of the bytes that are written

  Elf() {
    std::memcpy(head.e_ident, ELFMAG, SELFMAG);
    head.e_ident[EI_CLASS] = ELFCLASS32;
    head.e_ident[EI_DATA] = ELFDATA2LSB;
    head.e_machine = EM_ARM;
    head.e_phoff = sizeof head;
    head.e_phentsize = sizeof segment;
    head.e_phnum = 1;
    segment.p_type = PT_LOAD;
    segment.p_offset = sizeof head + sizeof segment;
    segment.p_paddr = begin;
    segment.p_filesz = sizeof vectors;
  }
};

std::string refusal_of(const Elf& elf) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "image.elf";
  std::string bytes(sizeof elf.head + sizeof elf.segment + sizeof elf.vectors, '\0');
  std::memcpy(bytes.data(), &elf.head, sizeof elf.head);
  std::memcpy(bytes.data() + sizeof elf.head, &elf.segment, sizeof elf.segment);
  std::memcpy(bytes.data() + sizeof elf.head + sizeof elf.segment, elf.vectors, sizeof elf.vectors);
  bytes.resize(std::min<std::size_t>(bytes.size(), elf.rest));
  std::ofstream{file, std::ios::binary} << bytes;
  try {
    const Image image{file};
    return "taken";
  } catch (const text::Error& error) {
    const std::string said = error.what();
    const std::string who = file.string() + ": ";
    return said.starts_with(who) ? said.substr(who.size()) : said;
  }
}

TEST(Image, IsTakenWithAVectorTableInTheFlash) { EXPECT_EQ(refusal_of({}), "taken"); }

TEST(Image, OfAnotherProcessorIsRefused) {
  Elf elf;
  elf.head.e_machine = EM_X86_64;
  EXPECT_EQ(refusal_of(elf), "built for machine 62 of ELF; allowed: 40, 32-bit Arm");
  elf.head.e_ident[0] = 'M';
  EXPECT_EQ(refusal_of(elf), "not an ELF file");
}

TEST(Image, WithoutVectorsIsRefused) {
  Elf elf;
  elf.segment.p_paddr = begin + 0x1000;
  EXPECT_EQ(refusal_of(elf), "its vector table says to begin at 0xffffffff, which is no code in the flash");
}

TEST(Image, LargerThanTheFlashIsRefused) {
  Elf elf;
  elf.segment.p_filesz = Image::flash_size + 1;
  EXPECT_EQ(refusal_of(elf), "1048577 bytes at 0x08000000 are outside the flash, 0x08000000 to 0x080fffff");
}

TEST(Image, WhoseFileEndsEarlyIsRefused) {
  Elf elf;
  elf.rest = sizeof elf.head + sizeof elf.segment + 4;
  EXPECT_EQ(refusal_of(elf), "it ends before its contents do");
  elf.rest = 20;
  EXPECT_EQ(refusal_of(elf), "it ends before its contents do");
}

}  // namespace
}  // namespace fantail::board
