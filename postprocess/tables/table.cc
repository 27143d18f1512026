// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/table.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>

#include "cases/program/errors.h"
#include "cases/program/output_file.h"

namespace tiprub::postprocess {

namespace {

constexpr int file_digits = 10;

std::string number(double value, const char* format, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, digits, value);
  return buffer;
}

/// Whether a spreadsheet would take a text for a formula and compute it.
bool is_formula(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const bool begins = text.size() > 1 && std::string_view("=+-@").find(text[0]) != std::string_view::npos;
  return begins && std::from_chars(text.data(), end, value).ptr != end;
}

std::string csv_text(const std::string& text) {
  if (is_formula(text)) return csv_text("'" + text);
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

std::string shown(const Cell& cell) {
  constexpr int shown_digits = 6;
  if (const auto* value = std::get_if<double>(&cell))
    return std::isfinite(*value) ? number(*value, "%.*g", shown_digits) : "";
  if (const auto* whole = std::get_if<int>(&cell)) return std::to_string(*whole);
  const auto* text = std::get_if<std::string>(&cell);
  return text ? *text : "";
}

void require_finite(const Table& table, const std::filesystem::path& path) {
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t i = 0; i < table.rows[row].size(); ++i)
      if (const auto* value = std::get_if<double>(&table.rows[row][i]); value && !std::isfinite(*value))
        throw RunError(path.filename().string() + ": column \"" + table.header[i] + "\", row " +
                       std::to_string(row + 1) +
                       ": the number is not finite; look for values beyond all measure in " +
                       "the files that the report is made from");
}

/// Width on a terminal: bytes that don't continue a UTF-8 letter.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char letter) { return (letter & 0xC0) != 0x80; }));
}

}  // namespace

std::string fixed(double value, int digits) {
  return std::isfinite(value) ? number(value, "%.*f", digits) : "";
}

std::string scientific(double value, int digits) {
  return std::isfinite(value) ? number(value, "%.*e", digits) : "";
}

std::string significant(double value, int digits) {
  return std::isfinite(value) ? number(value, "%.*g", digits) : "";
}

std::string csv_cell(const Cell& cell) {
  if (const auto* value = std::get_if<double>(&cell)) return number(*value, "%.*g", file_digits);
  if (std::holds_alternative<NoNumber>(cell)) return "NaN";
  if (const auto* whole = std::get_if<int>(&cell)) return std::to_string(*whole);
  return csv_text(std::get<std::string>(cell));
}

Cell number_if_any(double value) {
  return std::isnan(value) ? Cell(NoNumber{}) : Cell(value);
}

void write_csv(const Table& table, const std::filesystem::path& path) {
  require_finite(table, path);
  std::string text;
  for (std::size_t i = 0; i < table.header.size(); ++i) text += (i > 0 ? "," : "") + csv_text(table.header[i]);
  text += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + csv_cell(row[i]);
    text += '\n';
  }
  write_text(text, path);
}

std::string aligned_text(const Table& table) {
  std::vector<std::vector<std::string>> lines = {table.header};
  for (const auto& row : table.rows) {
    lines.emplace_back();
    for (const Cell& cell : row) lines.back().push_back(shown(cell));
  }
  std::string text;
  std::vector<std::size_t> widths(table.header.size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      text += std::string(widths[i] - width(line[i]) + (i > 0 ? 2 : 0), ' ') + line[i];
    text += '\n';
  }
  return text;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw RunError(path.string() + ": can't be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const std::string& text, const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& stream) { stream << text; });
}

std::string filled(std::string_view page, const std::map<std::string, std::string>& values) {
  constexpr std::string_view opening = "{{", closing = "}}";
  std::string text;
  std::set<std::string> used;
  for (std::size_t start = page.find(opening); start != std::string_view::npos; start = page.find(opening)) {
    const std::size_t end = page.find(closing, start);
    assert(end != std::string_view::npos);
    const auto value = values.find(std::string(page.substr(start + opening.size(), end - start - opening.size())));
    assert(value != values.end());
    text.append(page.substr(0, start)) += value->second;
    used.insert(value->first);
    page.remove_prefix(end + closing.size());
  }
  assert(used.size() == values.size());
  return text.append(page);
}

std::string rpm_text(double speed) {
  return fixed(speed * rpm_per_rad_s, 0) + " rpm";
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string mm_text(double length) {
  return fixed(length * mm_per_m, 3) + " mm";
}

std::string mpa_text(double stress) {
  return fixed(stress * mpa_per_pa, 0) + " MPa";
}

std::string yes_or_no(bool value) {
  return value ? "yes" : "no";
}

Cell optional_cell(const std::optional<double>& value, double factor) {
  return value ? Cell(*value * factor) : Cell(std::string());
}

void sort_by_speed(Table& table) {
  std::ranges::stable_sort(table.rows, {}, [](const auto& row) { return std::get<double>(row.front()); });
}

}  // namespace tiprub::postprocess
