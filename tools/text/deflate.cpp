// SPDX-License-Identifier: MIT
#include "text/deflate.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <zlib.h>

namespace fantail::text {
namespace {

constexpr int with_zlib_header = MAX_WBITS;
constexpr int with_gzip_header = MAX_WBITS + 16;

// zlib writes to neither of the two that it is given to read.
Bytef* bytes_of(std::string_view text) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

std::string packed(const std::string& text, int header) {
  z_stream stream{};
  constexpr int memory_level = 8;
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, header, memory_level, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error{"zlib cannot begin"};
  }
  std::string bytes(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = bytes_of(text);
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = bytes_of(bytes);
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int result = deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) {
    throw std::runtime_error{"zlib has not compressed a text"};
  }
  return bytes;
}

}  // namespace

std::string gzip(const std::string& text) { return packed(text, with_gzip_header); }

std::optional<std::string> gunzip(std::string_view bytes, std::size_t most) {
  z_stream stream{};
  if (inflateInit2(&stream, with_gzip_header) != Z_OK) {
    throw std::runtime_error{"zlib cannot begin"};
  }
  std::size_t left = bytes.size();
  stream.next_in = bytes_of(bytes);
  std::string text;
  std::array<char, 1U << 16U> portion{};
  int result = Z_OK;
  while (result == Z_OK && text.size() <= most) {
    if (stream.avail_in == 0) {
      constexpr std::size_t at_once = 1U << 30U;  // zlib counts in 32 bits
      stream.avail_in = static_cast<uInt>(std::min(left, at_once));
      left -= stream.avail_in;
    }
    stream.next_out = reinterpret_cast<Bytef*>(portion.data());
    stream.avail_out = static_cast<uInt>(portion.size());
    result = inflate(&stream, Z_NO_FLUSH);
    text.append(portion.data(), portion.size() - stream.avail_out);
    if (result == Z_STREAM_END && stream.avail_in + left > 0) {
      result = inflateReset(&stream);
    }
  }
  inflateEnd(&stream);
  return result == Z_STREAM_END && text.size() <= most ? std::optional{text} : std::nullopt;
}

std::string zlib_packed(const std::string& text) { return packed(text, with_zlib_header); }

}  // namespace fantail::text
