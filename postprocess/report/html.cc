// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/html.h"

#include <cassert>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <set>

namespace tiprub::html {

namespace {

std::string shown(const Cell& cell) {
  constexpr int digits = 4;
  constexpr double large = 1e3, huge = 1e9;  // whole numbers read better between them
  if (const auto* value = std::get_if<double>(&cell)) {
    if (!std::isfinite(*value)) return "";
    if (std::abs(*value) >= large && std::abs(*value) < huge) return fixed(*value, 0);
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, *value);
    return buffer;
  }
  if (const auto* whole = std::get_if<int>(&cell)) return std::to_string(*whole);
  const auto* text = std::get_if<std::string>(&cell);
  return text ? escaped(*text) : "";
}

bool looks_numeric(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.+-/ e") == std::string::npos;
}

/// Of a cell: numbers stand to the right, and short words on one line.
std::string class_of(const std::string& value) {
  constexpr std::size_t short_text = 16;
  if (looks_numeric(value)) return " class=\"n\"";
  return value.size() <= short_text ? " class=\"s\"" : "";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:  // a control character has no place in a page; U+FFFD shows where one was
        safe += std::iscntrl(static_cast<unsigned char>(letter)) != 0 && letter != '\n' && letter != '\t'
                    ? "\xEF\xBF\xBD"
                    : std::string(1, letter);
    }
  }
  return safe;
}

std::string definitions(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string text = "<dl>";
  for (const auto& [name, meaning] : entries)
    text += "<dt>" + escaped(name) + "</dt><dd>" + escaped(meaning) + "</dd>\n";
  return text + "</dl>\n";
}

std::string table(const Table& table) {
  std::string text = "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\"><table><thead><tr>";
  for (const std::string& name : table.header) text += "<th scope=\"col\">" + escaped(name) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (const Cell& cell : row) {
      const std::string value = shown(cell);
      const bool names_the_row = &cell == &row.front();
      text += (names_the_row ? "<th scope=\"row\"" : "<td") + class_of(value) + ">" + value +
              (names_the_row ? "</th>" : "</td>");
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string svg_url(const std::string& svg) {
  std::string url = "data:image/svg+xml,";
  for (const char letter : svg) {
    const std::string_view replaced = "%#\"<>&\n\t";
    if (replaced.find(letter) == std::string_view::npos) {
      url += letter;
      continue;
    }
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(letter)));
    url += code;
  }
  return url;
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

}  // namespace tiprub::html
