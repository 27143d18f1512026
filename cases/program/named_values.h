// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>

#include "cases/program/errors.h"

namespace tiprub {

template <class Value>
using NamedValue = std::pair<Value, const char*>;

/// The values of an enumeration and their names in files. Writers and readers share one such list.
template <class Value, std::size_t count>
using NamedValues = std::array<NamedValue<Value>, count>;

template <class Value, std::size_t count>
constexpr const char* name_in(const NamedValues<Value, count>& names, Value value) {
  for (const auto& [known, name] : names)
    if (known == value) return name;
  return "";
}

/// Raises FileError with a message that begins with `where` if no value has that name.
template <class Value, std::size_t count>
Value value_named(const NamedValues<Value, count>& names, const std::string& name, const std::string& where) {
  std::string known;
  for (std::size_t i = 0; i < count; ++i) {
    if (name == names[i].second) return names[i].first;
    known += (i == 0 ? "\"" : i + 1 < count ? "\", \"" : "\" or \"") + std::string(names[i].second);
  }
  throw FileError(where + " is \"" + name + "\", must be " + known + "\"");
}

}  // namespace tiprub
