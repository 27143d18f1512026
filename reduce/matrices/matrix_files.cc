// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/matrices/matrix_files.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::reduce {

namespace {

constexpr int most_rows = 30000000;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // before what Excel writes as "CSV UTF-8"

/// A text file line by line.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& path) : path_(path), in_(path, std::ios::binary) {
    if (!in_ || std::filesystem::is_directory(path)) throw RunError(path.string() + ": can't be read");
  }

  bool next(std::string& line) {
    if (!std::getline(in_, line)) return false;
    if (line.ends_with('\r')) line.pop_back();
    if (++number_ == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    return true;
  }
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(text_of(path_.string(), ":", number_, ": ", message));
  }
  /// The numbers of a line, which must be `count`.
  template <std::size_t count>
  std::array<double, count> numbers(const std::string& line, const char* what) const {
    std::array<double, count> values{};
    const char *at = line.data(), *end = at + line.size();
    for (double& value : values) {
      while (at != end && (*at == ' ' || *at == '\t' || *at == '+' || *at == ',')) ++at;
      const auto [after, error] = std::from_chars(at, end, value);
      if (error != std::errc() || !std::isfinite(value)) refuse(std::string("must be ") + what);
      at = after;
    }
    while (at != end && (*at == ' ' || *at == '\t')) ++at;
    if (at != end) refuse(std::string("must be ") + what + " and nothing else");
    return values;
  }

 private:
  std::filesystem::path path_;
  std::ifstream in_;
  int number_ = 0;
};

struct MatrixHead {
  bool array = false, symmetric = true;
};

/// "%%MatrixMarket matrix coordinate real symmetric".
MatrixHead head_of(const Lines& lines, std::string line) {
  std::transform(line.begin(), line.end(), line.begin(), [](unsigned char c) { return std::tolower(c); });
  std::istringstream words(line);
  std::string banner, object, layout, field, symmetry;
  words >> banner >> object >> layout >> field >> symmetry;
  const bool known = object == "matrix" && (layout == "coordinate" || layout == "array") &&
                     (field == "real" || field == "integer" || field == "double") &&
                     (symmetry == "symmetric" || symmetry == "general");
  if (!known)
    lines.refuse(
        "must be a real matrix, coordinate or array, symmetric or general: K and M of a sector whose cut faces "
        "are both free are real");
  return {layout == "array", symmetry == "symmetric"};
}

int row_in(const Lines& lines, double value) {
  if (value != std::floor(value) || value < 1 || value > most_rows)
    lines.refuse("a row or column must be a whole number from 1 to " + std::to_string(most_rows));
  return static_cast<int>(value) - 1;
}

using Triplets = std::vector<Eigen::Triplet<double>>;

void add(Triplets& entries, int row, int column, double value, bool symmetric) {
  entries.emplace_back(row, column, value);
  if (symmetric && row != column) entries.emplace_back(column, row, value);
}

/// The columns one after the other; those of a symmetric matrix begin at the diagonal.
void read_array(Lines& lines, int size, bool symmetric, Triplets& entries) {
  std::string line;
  for (int column = 0; column < size; ++column)
    for (int row = symmetric ? column : 0; row < size; ++row) {
      do {
        if (!lines.next(line)) lines.refuse("the matrix lacks entries; is the file cut off?");
      } while (line.empty());
      if (const double value = lines.numbers<1>(line, "a finite number")[0]; value != 0)
        add(entries, row, column, value, symmetric);
    }
}

/// Returns how many there are.
std::size_t read_entries(Lines& lines, int size, bool symmetric, Triplets& entries) {
  std::size_t count = 0;
  for (std::string line; lines.next(line);) {
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    const auto [row, column, value] = lines.numbers<3>(line, "row, column and a finite value");
    const int i = row_in(lines, row), j = row_in(lines, column);
    if (size > 0 && std::max(i, j) >= size)
      lines.refuse("an entry lies outside the " + std::to_string(size) + " rows");
    add(entries, i, j, value, symmetric);
    ++count;
  }
  return count;
}

void require_symmetric(const Eigen::SparseMatrix<double>& matrix, const std::string& name) {
  constexpr double tolerance = 1e-9;
  const Eigen::SparseMatrix<double> other = matrix.transpose();
  const double largest = matrix.coeffs().size() > 0 ? matrix.coeffs().abs().maxCoeff() : 0;
  const Eigen::SparseMatrix<double> difference = matrix - other;
  const double off = difference.nonZeros() > 0 ? difference.coeffs().abs().maxCoeff() : 0;
  if (!(off <= tolerance * largest))
    throw InputError(text_of(name, ": is not symmetric: entries differ from those across the diagonal by up to ",
                             std::to_string(off / largest), " of the largest; K and M of a sector are symmetric"));
}

std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) {
    const std::size_t first = field.find_first_not_of(" \t\""), last = field.find_last_not_of(" \t\"");
    fields.push_back(first == std::string::npos ? "" : field.substr(first, last - first + 1));
  }
  return fields;
}

}  // namespace

Eigen::SparseMatrix<double> read_symmetric_matrix(const std::filesystem::path& path) {
  Lines lines(path);
  Triplets entries;
  std::string line;
  int size = 0;
  MatrixHead head;
  std::optional<double> listed;  // entries by the head of the file
  if (!lines.next(line)) lines.refuse("is empty");
  if (line.starts_with("%%")) {
    head = head_of(lines, line);
    do {
      if (!lines.next(line)) lines.refuse("has no line with its size");
    } while (line.empty() || line[0] == '%');
    const std::array<double, 2> shape = [&]() -> std::array<double, 2> {
      if (head.array) return lines.numbers<2>(line, "rows and columns");
      const auto [rows, columns, count] = lines.numbers<3>(line, "rows, columns and entries");
      listed = count;
      return {rows, columns};
    }();
    size = row_in(lines, shape[0]) + 1;
    if (shape[0] != shape[1]) lines.refuse("must have as many columns as rows");
  } else {
    const auto [row, column, value] = lines.numbers<3>(line, "row, column and value, or %%MatrixMarket");
    add(entries, row_in(lines, row), row_in(lines, column), value, true);
  }
  if (head.array)
    read_array(lines, size, head.symmetric, entries);
  else if (const std::size_t count = read_entries(lines, size, head.symmetric, entries);
           listed && *listed != static_cast<double>(count))
    lines.refuse("has " + std::to_string(count) + " entries, and its head lists " +
                 std::to_string(static_cast<long long>(*listed)) + "; is the file cut off?");
  for (const Eigen::Triplet<double>& entry : entries) size = std::max(size, entry.row() + 1);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (!matrix.coeffs().isFinite().all())
    throw InputError(path.string() + ": entries of one place add up beyond all measure");
  require_symmetric(matrix, path.string());
  return matrix;
}

NodeTable read_node_table(const std::filesystem::path& path) {
  static const std::map<std::string, NodePlace> places = {{"", NodePlace::inside},
                                                          {"clamped", NodePlace::clamped},
                                                          {"cyclic_low", NodePlace::cyclic_low},
                                                          {"cyclic_high", NodePlace::cyclic_high},
                                                          {"contact", NodePlace::contact}};
  Lines lines(path);
  std::string line;
  if (!lines.next(line)) lines.refuse("is empty");
  std::map<std::string, std::size_t> column;
  const std::vector<std::string> names = csv_fields(line);
  for (std::size_t k = 0; k < names.size(); ++k) column[names[k]] = k;
  for (const char* name : {"x", "y", "z"})
    if (!column.contains(name)) lines.refuse("must name the columns: x, y, z, and, if wanted, node and set");
  NodeTable table;
  std::vector<Eigen::Vector3d> positions;
  while (lines.next(line)) {
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    const std::vector<std::string> fields = csv_fields(line);
    const auto field = [&](const char* name) {
      const auto at = column.find(name);
      return at != column.end() && at->second < fields.size() ? fields[at->second] : std::string();
    };
    const double x = lines.numbers<1>(field("x"), "a finite x")[0], y = lines.numbers<1>(field("y"), "a finite y")[0],
                 z = lines.numbers<1>(field("z"), "a finite z")[0];
    positions.emplace_back(x, y, z);
    const auto place = places.find(field("set"));
    if (place == places.end())
      lines.refuse("set \"" + field("set") + "\" must be clamped, cyclic_low, cyclic_high, contact, or empty");
    table.place.push_back(place->second);
    table.number.push_back(column.contains("node")
                               ? row_in(lines, lines.numbers<1>(field("node"), "a node's number")[0]) + 1
                               : static_cast<long>(positions.size()));
  }
  table.position.resize(3, static_cast<Eigen::Index>(positions.size()));
  for (std::size_t k = 0; k < positions.size(); ++k) table.position.col(static_cast<Eigen::Index>(k)) = positions[k];
  return table;
}

std::vector<std::pair<long, int>> read_dof_list(const std::filesystem::path& path) {
  Lines lines(path);
  std::vector<std::pair<long, int>> dofs;
  for (std::string line; lines.next(line);) {
    const std::size_t first = line.find_first_not_of(" \t"), point = line.find('.');
    if (first == std::string::npos) continue;
    long node = 0;
    const bool known = point != std::string::npos && point + 1 < line.size() && line[point + 1] >= '1' &&
                       line[point + 1] <= '3' &&
                       std::from_chars(line.data() + first, line.data() + point, node).ptr == line.data() + point;
    if (!known || line.find_last_not_of(" \t") != point + 1)
      lines.refuse("must be a node and a direction, as 12.3, 1 to 3 for x, y, z");
    dofs.emplace_back(node, line[point + 1] - '1');
  }
  return dofs;
}

}  // namespace tiprub::reduce
