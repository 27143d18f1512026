// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <type_traits>

namespace tiprub {

/// A hash of data, to tell whether two files hold the same or were made from the same: 64 bits by Fowler, Noll and
/// Vo, variant 1a. It protects against mistakes and damage, not against malice.
class Digest {
 public:
  void add_bytes(const void* data, std::size_t count) {
    constexpr std::uint64_t prime = 1099511628211ULL;
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < count; ++i) value_ = (value_ ^ bytes[i]) * prime;
  }
  /// Adds the bytes of a number. -0.0 counts as 0.0, because files don't distinguish them.
  template <class Value>
  void add(Value value) {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
    if constexpr (std::is_floating_point_v<Value>) value += Value(0);
    add_bytes(&value, sizeof(value));
  }
  void add(const std::string& text) {
    add(text.size());
    add_bytes(text.data(), text.size());
  }
  template <class Value>
  void add(const Value* data, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(data[i]);
  }
  /// 16 hexadecimal digits.
  std::string digits() const {
    char text[17];
    std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(value_));
    return text;
  }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace tiprub
