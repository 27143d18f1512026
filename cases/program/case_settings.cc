// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_settings.h"

#include <regex>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr std::string_view option = "--set ";

/// Moves, for toml++ drops the positions of what it copies.
void merge(toml::table& into, toml::table&& from) {
  for (auto&& [key, value] : from) {
    toml::table* inner = into[key.str()].as_table();
    if (inner != nullptr && value.is_table())
      merge(*inner, std::move(*value.as_table()));
    else
      into.insert_or_assign(key, std::move(value));
  }
}

}  // namespace

std::string setting_origin(const std::string& setting) {
  return std::string(option) + setting;
}

void apply_setting(toml::table& values, const std::string& setting) {
  static const std::regex form("(\\w+(?:\\.\\w+)+) *= *([^\n]*)");
  const std::string origin = setting_origin(setting);
  std::smatch parts;
  if (!std::regex_match(setting, parts, form)) throw InputError(origin + ": must be TABLE.KEY=VALUE, in one line");
  try {
    merge(values, toml::parse(setting, origin));
  } catch (const toml::parse_error& error) {
    throw InputError(origin + ": " + parts.str(2) + " is no TOML value (" + std::string(error.description()) +
                     "); a text needs quotes: " + std::string(option) + "'" + parts.str(1) + "=\"" + parts.str(2) +
                     "\"'");
  }
}

std::string place(const std::string& file, const toml::source_region& source) {
  if (source.path && source.path->starts_with(option)) return *source.path + ": ";
  return file + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column) + ": ";
}

}  // namespace tiprub
