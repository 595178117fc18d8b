# SPDX-License-Identifier: MIT
# Usage: cmake [-D FOLDER=<namespace>] -D FILE=<text file> -D NAME=<identifier> -D OUT=<.cpp> -P embed.cmake
# Turns a text file into a constant of fantail::report (or another folder), declared in its page_assets.hpp, so that the
# program needs no files beside it.
if(NOT DEFINED FOLDER)
  set(FOLDER report)
endif()
file(READ "${FILE}" text)
set(delimiter "embedded")
string(FIND "${text}" ")${delimiter}\"" clash)
if(NOT clash EQUAL -1)
  message(FATAL_ERROR "${FILE} holds the end of the raw string it is put into")
endif()
file(WRITE "${OUT}"
  "#include \"${FOLDER}/page_assets.hpp\"\n\nnamespace fantail::${FOLDER} {\n"
  "const std::string_view ${NAME} = R\"${delimiter}(${text})${delimiter}\";\n"
  "}\n")
