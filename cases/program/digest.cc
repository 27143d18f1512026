// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/digest.h"

#include <cstdio>

namespace tiprub {

void Digest::add_bytes(const void* data, std::size_t count) {
  constexpr std::uint64_t prime = 1099511628211ULL;
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < count; ++i) value_ = (value_ ^ bytes[i]) * prime;
}

void Digest::add(const std::string& text) {
  add(text.size());
  add_bytes(text.data(), text.size());
}

std::string Digest::digits() const {
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(value_));
  return text;
}

}  // namespace tiprub
