# SPDX-License-Identifier: MIT
# Usage: cmake -D ROOT=<project> -D "FILES=<file>;..." -D OUT=<.cpp> -P embed_files.cmake
# Writes what shipped_texts.hpp declares. The names of the files are from ROOT.
set(rows "")
set(count 0)
foreach(file IN LISTS FILES)
  file(READ "${ROOT}/${file}" text)
  string(FIND "${text}" ")embedded\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${file} holds the end of the raw string it is put into")
  endif()
  string(APPEND rows "    {\"${file}\", R\"embedded(${text})embedded\"},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE "${OUT}" "#include \"playground/shipped_texts.hpp\"

#include <array>

namespace fantail::playground {
std::span<const ShippedText> shipped_texts() {
  static constexpr std::array<ShippedText, ${count}> all{{
${rows}  }};
  return all;
}
}  // namespace fantail::playground
")
