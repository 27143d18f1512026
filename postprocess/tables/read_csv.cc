// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/read_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cases/program/errors.h"
#include "postprocess/tables/table.h"

namespace tiprub {

namespace {

/// Cells of all lines; a cell in quotes may hold commas, lines and doubled quotes.
std::vector<std::vector<std::string>> cells_of(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    std::string& cell = lines.back().back();
    if (quoted && letter == '"' && i + 1 < text.size() && text[i + 1] == '"')
      cell += text[++i];
    else if (letter == '"')
      quoted = !quoted;
    else if (letter == ',' && !quoted)
      lines.back().emplace_back();
    else if (letter == '\n' && !quoted)
      lines.emplace_back(1);
    else
      cell += letter;
  }
  if (lines.back().size() == 1 && lines.back().front().empty()) lines.pop_back();
  return lines;
}

}  // namespace

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end())
    throw InputError(file + ": has no column \"" + name + "\"; give a report that this version made");
  return static_cast<std::size_t>(found - header.begin());
}

Eigen::VectorXd CsvTable::numbers(const std::string& name) const {
  const std::size_t at = column(name);
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::string& text = rows[row][at];
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      throw InputError(file + ": column \"" + name + "\", row " + std::to_string(row + 1) + ": \"" + text +
                       "\" is no number");
    values[static_cast<Eigen::Index>(row)] = value;
  }
  return values;
}

CsvTable read_csv(const std::filesystem::path& path) {
  std::vector<std::vector<std::string>> lines = cells_of(read_text(path));
  if (lines.empty()) throw InputError(path.string() + ": is empty; a table has a header");
  CsvTable table{path.string(), std::move(lines.front()), {}};
  lines.erase(lines.begin());
  for (const auto& line : lines)
    if (line.size() != table.header.size())
      throw InputError(table.file + ": row " + std::to_string(&line - lines.data() + 1) + " has " +
                       std::to_string(line.size()) + " cells, the header " + std::to_string(table.header.size()));
  table.rows = std::move(lines);
  return table;
}

}  // namespace tiprub
