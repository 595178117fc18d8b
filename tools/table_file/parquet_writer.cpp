// SPDX-License-Identifier: MIT
#include "table_file/parquet_writer.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "table_file/little_endian.hpp"
#include "table_file/parquet_format.hpp"
#include "table_file/thrift.hpp"
#include "text/deflate.hpp"
#include "text/error.hpp"

namespace fantail::table_file::parquet {
namespace {

using thrift::Writer;

Type type_of(Kind kind) {
  switch (kind) {
    case Kind::number: return Type::float64;
    case Kind::integer: return Type::int64;
    case Kind::flag: return Type::boolean;
    case Kind::word: break;
  }
  return Type::bytes;
}

// One bit a value, packed into bytes from the lowest on.
class Bits {
 public:
  explicit Bits(std::string& out) : out_{out} {}
  void add(bool bit) {
    if (count_ % 8 == 0) {
      out_ += '\0';
    }
    out_.back() = static_cast<char>(static_cast<unsigned char>(out_.back()) | static_cast<unsigned>(bit) << count_ % 8);
    ++count_;
  }

 private:
  std::string& out_;
  unsigned count_ = 0;
};

// Which values are there: runs of the same, each with its length.
std::string definitions(const std::vector<double>& values) {
  std::string runs;
  for (std::size_t begin = 0; begin < values.size();) {
    const bool known = !std::isnan(values[begin]);
    std::size_t end = begin + 1;
    while (end < values.size() && std::isnan(values[end]) != known) {
      ++end;
    }
    std::uint64_t head = std::uint64_t{end - begin} << 1U;
    for (; head >= 0x80; head >>= 7U) {
      runs += static_cast<char>(head | 0x80U);
    }
    runs += static_cast<char>(head);
    runs += static_cast<char>(known);
    begin = end;
  }
  std::string out;
  put(out, static_cast<std::uint32_t>(runs.size()));
  return out + runs;
}

std::string plain(const Column& column) {
  std::string out = definitions(column.values);
  Bits bits{out};
  for (const double value : column.values) {
    if (std::isnan(value)) {
      continue;
    }
    switch (column.kind) {
      case Kind::number: put(out, value); break;
      case Kind::integer: put(out, static_cast<std::int64_t>(value)); break;
      case Kind::flag: bits.add(value != 0.0); break;
      case Kind::word: {
        const std::string& word = column.words[static_cast<std::size_t>(value)];
        put(out, static_cast<std::uint32_t>(word.size()));
        out += word;
      }
    }
  }
  return out;
}

Writer schema_of(const Column& column) {
  Writer element;
  element.int32(schema_fields::type, static_cast<int>(type_of(column.kind)));
  element.int32(schema_fields::repetition, static_cast<int>(Repetition::optional));
  element.binary(schema_fields::name, column.name);
  if (column.kind == Kind::word) {
    element.int32(schema_fields::converted_type, utf8_text);
    constexpr int string_type = 1;
    Writer logical;
    logical.structure(string_type, {});
    element.structure(schema_fields::logical_type, logical);
  }
  return element;
}

// A page of a file and what the footer says of it.
struct Page {
  std::string bytes;
  std::size_t unpacked = 0;  ///< with its header
};

Page page_of(const Column& column) {
  const std::string content = plain(column);
  const std::string packed = text::gzip(content);
  if (content.size() > std::numeric_limits<std::int32_t>::max()) {
    throw text::Error{text::ErrorKind::bad_data, "a column of more than 2 GB has no room in a page of a Parquet file"};
  }
  Writer data;
  data.int32(data_page_fields::values, static_cast<std::int64_t>(column.values.size()));
  data.int32(data_page_fields::encoding, static_cast<int>(Encoding::plain));
  data.int32(data_page_fields::definition_encoding, static_cast<int>(Encoding::rle));
  data.int32(data_page_fields::repetition_encoding, static_cast<int>(Encoding::rle));
  Writer header;
  header.int32(page_fields::type, data_page);
  header.int32(page_fields::bytes_unpacked, static_cast<std::int64_t>(content.size()));
  header.int32(page_fields::bytes_packed, static_cast<std::int64_t>(packed.size()));
  header.int32(page_fields::crc, static_cast<std::int32_t>(text::crc32(packed)));
  header.structure(page_fields::data, data);
  const std::string head = header.bytes();
  return {.bytes = head + packed, .unpacked = head.size() + content.size()};
}

Writer chunk_of(const Column& column, const Page& page, std::size_t offset) {
  Writer about;
  about.int32(column_fields::type, static_cast<int>(type_of(column.kind)));
  about.int32s(column_fields::encodings, {static_cast<int>(Encoding::plain), static_cast<int>(Encoding::rle)});
  about.binaries(column_fields::path, {column.name});
  about.int32(column_fields::codec, static_cast<int>(Codec::gzip));
  about.int64(column_fields::values, static_cast<std::int64_t>(column.values.size()));
  about.int64(column_fields::bytes_unpacked, static_cast<std::int64_t>(page.unpacked));
  about.int64(column_fields::bytes_packed, static_cast<std::int64_t>(page.bytes.size()));
  about.int64(column_fields::data_offset, static_cast<std::int64_t>(offset));
  Writer chunk;
  chunk.int64(chunk_fields::file_offset, static_cast<std::int64_t>(offset));
  chunk.structure(chunk_fields::about, about);
  return chunk;
}

Writer key_value(std::string_view key, std::string_view value) {
  Writer pair;
  pair.binary(key_value_fields::key, key);
  pair.binary(key_value_fields::value, value);
  return pair;
}

}  // namespace

std::string file(const Columns& columns, const std::string& about) {
  const auto rows = static_cast<std::int64_t>(columns.empty() ? 0 : columns.front().values.size());
  std::string out{magic};
  Writer root;
  root.binary(schema_fields::name, "flight");
  root.int32(schema_fields::children, static_cast<std::int64_t>(columns.size()));
  std::vector<Writer> schema{root};
  std::vector<Writer> chunks;
  std::size_t unpacked = 0;
  for (const Column& column : columns) {
    const Page page = page_of(column);
    schema.push_back(schema_of(column));
    chunks.push_back(chunk_of(column, page, out.size()));
    unpacked += page.unpacked;
    out += page.bytes;
  }
  Writer group;
  group.structures(row_group_fields::columns, chunks);
  group.int64(row_group_fields::bytes, static_cast<std::int64_t>(unpacked));
  group.int64(row_group_fields::rows, rows);
  const auto described = [&](const std::string& checksum) {
    Writer footer;
    footer.int32(file_fields::version, 1);
    footer.structures(file_fields::schema, schema);
    footer.int64(file_fields::rows, rows);
    footer.structures(file_fields::row_groups, {group});
    footer.structures(file_fields::key_values, {key_value("fantail", about), key_value(checksum_key, checksum)});
    footer.binary(file_fields::created_by, "Fantail");
    return footer.bytes();
  };
  const std::string unchecked = described("");
  const std::string description = described(checksum_of(unchecked, unchecked.rfind(checksum_key)));
  out += description;
  put(out, static_cast<std::uint32_t>(description.size()));
  return out += magic;
}

}  // namespace fantail::table_file::parquet
