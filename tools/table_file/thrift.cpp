// SPDX-License-Identifier: MIT
#include "table_file/thrift.hpp"

#include <algorithm>

namespace fantail::table_file::thrift {
namespace {

struct Nonsense {};

class Reader {
 public:
  explicit Reader(std::string_view& rest) : rest_{rest} {}

  Value structure(int depth) {
    constexpr int deepest = 16;
    if (depth > deepest) {
      throw Nonsense{};
    }
    Value value;
    int field = 0;
    while (true) {
      const std::uint8_t head = byte();
      if (head == 0) {
        return value;
      }
      const int step = head >> 4U;
      field = step > 0 ? field + step : static_cast<int>(number());
      value.members.emplace_back(field, of(Type{static_cast<std::uint8_t>(head & 0x0FU)}, depth, false));
    }
  }

 private:
  std::uint8_t byte() {
    if (rest_.empty()) {
      throw Nonsense{};
    }
    const auto value = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }

  std::uint64_t unsigned_number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint8_t part = byte();
      value |= std::uint64_t{part & 0x7FU} << shift;
      if (part < 0x80) {
        return value;
      }
    }
    throw Nonsense{};
  }

  std::int64_t number() {  // small ones of both signs are short
    const std::uint64_t value = unsigned_number();
    return static_cast<std::int64_t>(value >> 1U) ^ -static_cast<std::int64_t>(value & 1U);
  }

  std::string_view bytes(std::uint64_t count) {
    if (count > rest_.size()) {
      throw Nonsense{};
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  Value of(Type type, int depth, bool in_list) {
    Value value{.type = type};
    switch (type) {
      case Type::yes:
      case Type::no: value.number = in_list ? byte() : static_cast<std::int64_t>(type == Type::yes); return value;
      case Type::int8: value.number = static_cast<std::int8_t>(byte()); return value;
      case Type::int16:
      case Type::int32:
      case Type::int64: value.number = number(); return value;
      case Type::binary: value.bytes = bytes(unsigned_number()); return value;
      case Type::structure: return structure(depth + 1);
      case Type::list: break;
      default: throw Nonsense{};
    }
    const std::uint8_t head = byte();
    constexpr std::uint64_t size_follows = 15;
    const std::uint64_t count = head >> 4U == size_follows ? unsigned_number() : head >> 4U;
    if (count > rest_.size()) {  // each has at least one byte
      throw Nonsense{};
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      value.elements.push_back(of(Type{static_cast<std::uint8_t>(head & 0x0FU)}, depth + 1, true));
    }
    return value;
  }

  std::string_view& rest_;
};

}  // namespace

void Writer::unsigned_number(std::uint64_t value) {
  for (; value >= 0x80; value >>= 7U) {
    bytes_ += static_cast<char>(value | 0x80U);
  }
  bytes_ += static_cast<char>(value);
}

void Writer::number(std::int64_t value) {
  unsigned_number(static_cast<std::uint64_t>(value) << 1U ^ (value < 0 ? ~std::uint64_t{0} : 0));
}

void Writer::head(int field, Type type) {
  const int step = field - last_field_;  // of 1 to 15, by what is written here
  bytes_ += static_cast<char>(static_cast<unsigned>(step) << 4U | static_cast<unsigned>(type));
  last_field_ = field;
}

void Writer::integer(int field, std::int64_t value, Type type) {
  head(field, type);
  number(value);
}

void Writer::binary(int field, std::string_view bytes) {
  head(field, Type::binary);
  unsigned_number(bytes.size());
  bytes_ += bytes;
}

void Writer::structure(int field, const Writer& inner) {
  head(field, Type::structure);
  bytes_ += inner.bytes();
}

void Writer::list(int field, Type type, std::size_t count) {
  head(field, Type::list);
  constexpr std::size_t size_follows = 15;
  bytes_ += static_cast<char>(std::min(count, size_follows) << 4U | static_cast<unsigned>(type));
  if (count >= size_follows) {
    unsigned_number(count);
  }
}

void Writer::structures(int field, const std::vector<Writer>& list) {
  this->list(field, Type::structure, list.size());
  for (const Writer& inner : list) {
    bytes_ += inner.bytes();
  }
}

void Writer::binaries(int field, const std::vector<std::string>& list) {
  this->list(field, Type::binary, list.size());
  for (const std::string& bytes : list) {
    unsigned_number(bytes.size());
    bytes_ += bytes;
  }
}

void Writer::int32s(int field, const std::vector<std::int32_t>& list) {
  this->list(field, Type::int32, list.size());
  for (const std::int32_t value : list) {
    number(value);
  }
}

const Value* Value::find(int field, Type wanted) const {
  const auto found = std::ranges::find(members, field, &std::pair<int, Value>::first);
  return found != members.end() && found->second.type == wanted ? &found->second : nullptr;
}

std::optional<std::int64_t> Value::integer(int field) const {
  for (const Type width : {Type::int32, Type::int64}) {
    if (const Value* const value = find(field, width)) {
      return value->number;
    }
  }
  return {};
}

std::optional<Value> read(std::string_view& rest) {
  try {
    return Reader{rest}.structure(0);
  } catch (const Nonsense&) {
    return {};
  }
}

}  // namespace fantail::table_file::thrift
