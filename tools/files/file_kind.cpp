// SPDX-License-Identifier: MIT
#include "files/file_kind.hpp"

#include <algorithm>
#include <array>

namespace fantail::files {
namespace {

using namespace std::string_view_literals;

struct Beginning {
  std::string_view begin;
  std::string_view said;
};

constexpr std::array kinds{
    Beginning{"\xA3\x95\x80\x80"sv, "an ArduPilot DataFlash log; let its name end in .bin"},
    Beginning{"H Product:Blackbox"sv, "a Betaflight black box; let its name end in .bbl"},
    Beginning{"ULog\x01\x12\x35"sv, "a ULog of PX4; let its name end in .ulg"},
    Beginning{"PAR1"sv, "a Parquet file; let its name end in .parquet"},
    Beginning{"ARROW1"sv, "a Feather file; let its name end in .feather"},
    Beginning{"\x89HDF\r\n"sv, "an HDF5 file; let its name end in .h5"},
    Beginning{"MATLAB 5.0"sv, "a MAT-file; let its name end in .mat"},
    Beginning{"\x89MCAP0"sv, "an MCAP file; let its name end in .mcap"},
    Beginning{"\x1F\x8B"sv, "packed by gzip; let its name end in .gz"},
    Beginning{"PK\x03\x04"sv, "a zip archive; unpack it, or let the name of a workbook end in .xlsx"},
    Beginning{"SQLite format 3"sv, "an SQLite database; export a table of it as CSV"},
    Beginning{"%PDF"sv, "a PDF"},
    Beginning{"\x7F"
              "ELF"sv,
              "a program"},
    Beginning{"<?xml"sv, "XML; export the flight as CSV"},
    Beginning{"VERSION "sv,
              "a telemetry file of AltOS, of an old kind; AltosUI makes a table of it: File, Export data"},
    Beginning{"TELEM "sv, "a telemetry file of AltOS; let its name end in .telem"},
    Beginning{"\xD0\xCF\x11\xE0"sv, "a workbook of old Excel; save it as .xlsx or CSV"},
    Beginning{"3.0.1-euroc"sv, "a log of a CATS Vega; its configurator exports it as CSV"},
    Beginning{"FMT, 128"sv, "an ArduPilot log as text; its .bin is read"},
};

}  // namespace

std::string kind_that_is_no_table(std::string_view bytes) {
  const auto found = std::ranges::find_if(kinds, [&](const Beginning& one) { return bytes.starts_with(one.begin); });
  if (found != kinds.end()) {
    return std::string{found->said};
  }
  constexpr std::string_view arts2 = "Ozark.odf";  // the name of its own format, behind four bytes
  if (bytes.substr(0, 64).find(arts2) != std::string_view::npos) {
    return "a log of an ARTS2; its program exports it as text";
  }
  // AltOS writes what the computer's flash holds behind its settings.
  constexpr std::size_t looked_at = 4096;
  const std::string_view first = bytes.substr(0, looked_at);
  return first.starts_with('{') && first.find("\"log_format\"") != std::string_view::npos
             ? "a flash image of AltOS; let its name end in .eeprom"
             : "";
}

}  // namespace fantail::files
