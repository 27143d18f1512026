// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/foreign_mesh.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "cases/program/text.h"

namespace tiprub::mesh {

namespace {

std::string quoted(std::string_view word) {
  constexpr std::size_t shown = 40;
  return '"' + std::string(word.substr(0, shown)) + '"';
}

}  // namespace

std::optional<std::string_view> TextLines::peek() const {
  if (rest_.empty()) return std::nullopt;
  std::string_view line = rest_.substr(0, rest_.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::optional<std::string_view> TextLines::next() {
  const std::optional<std::string_view> line = peek();
  if (!line) return line;
  ++number_;
  const std::size_t end = rest_.find('\n');
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  return line;
}

void TextLines::refuse(const std::string& message) const {
  refuse_line(file_, number_, message);
}

double TextLines::number_in(std::string_view word, const char* meaning) const {
  std::string text(word);
  for (char& letter : text)
    if (letter == 'D' || letter == 'd') letter = 'E';
  if (text.starts_with('+')) text.erase(0, 1);
  // Nastran leaves out the E before an exponent's sign.
  for (std::size_t i = 1; i < text.size(); ++i)
    if ((text[i] == '+' || text[i] == '-') && text[i - 1] != 'E' && text[i - 1] != 'e') text.insert(i++, "E");
  if (const std::size_t plus = text.find('+'); plus != std::string::npos) text.erase(plus, 1);
  const auto value = number_of<double>(text);
  if (!value) refuse(quoted(word) + " stands for " + meaning + ", which must be a finite number");
  return *value;
}

long TextLines::whole_in(std::string_view word, const char* meaning) const {
  constexpr long most = 2000000000;
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto value = number_of<long>(word);
  if (!value || std::abs(*value) > most)
    refuse(quoted(word) + " stands for " + meaning + ", which must be a whole number");
  return *value;
}

void MeshReader::refuse_linear(int line, const std::string& what) const {
  refuse_line(lines_.file(), line,
              what +
                  ": elements that have corners only bend too stiffly; mesh again with quadratic ones, 10-node "
                  "tetrahedra, 15-node wedges or 20-node bricks");
}

void MeshReader::refuse_solid(int line, const std::string& what, const std::string& known) const {
  refuse_line(lines_.file(), line,
              what + " is not known; " + known + " are; mesh every volume with these solids, or delete the element");
}

void MeshReader::refuse_other_file(const std::string& statement) const {
  lines_.refuse(statement + " leads to another file; give the file that holds the mesh, or put both into one");
}

void MeshReader::refuse_rule(const std::string& statement) const {
  lines_.refuse(statement +
                " makes, moves or removes nodes or elements by a rule that isn't followed here; write all nodes and "
                "elements out");
}

void MeshReader::add_node(int line, long number, const Eigen::Vector3d& at) {
  const std::string node = "node " + std::to_string(number);
  if (number <= 0) refuse_line(lines_.file(), line, node + " must have a number above 0");
  if (!mesh_.nodes.emplace(number, at).second)
    refuse_line(lines_.file(), line, node + " is there twice; does the file hold several parts? Write one");
}

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return result;
}

std::vector<std::string_view> comma_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (line = trimmed(line); !line.empty();) {
    const std::size_t end = line.find(',');
    fields.push_back(trimmed(line.substr(0, end)));
    line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
  }
  return fields;
}

std::vector<std::string_view> column_fields(std::string_view line, std::size_t width) {
  std::vector<std::string_view> fields;
  for (; !line.empty(); line.remove_prefix(std::min(width, line.size())))
    fields.push_back(trimmed(line.substr(0, width)));
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  return fields;
}

}  // namespace tiprub::mesh
