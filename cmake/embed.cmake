# SPDX-License-Identifier: MIT
# Usage: cmake -D FILE=<text file> -D NAME=<identifier> -D HEADER=<as in the #include> -D NAMESPACE=<of it> -D OUT=<.cpp>
#   -P embed.cmake
# Turns a text file into a constant that the header declares, so that the program needs no files beside it.
file(READ "${FILE}" text)
set(delimiter "embedded")
string(FIND "${text}" ")${delimiter}\"" clash)
if(NOT clash EQUAL -1)
  message(FATAL_ERROR "${FILE} holds the end of the raw string it is put into")
endif()
file(WRITE "${OUT}"
  "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n"
  "const std::string_view ${NAME} = R\"${delimiter}(${text})${delimiter}\";\n"
  "}\n")
