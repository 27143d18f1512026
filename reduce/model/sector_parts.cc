// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/sector_parts.h"

#include <algorithm>
#include <set>

#include "mesh/cells/cell_kind.h"

namespace tiprub {

namespace {

std::string quoted(const std::string& part) {
  return "part \"" + part + "\"";
}

std::string wrong_lists(Eigen::Index cell_count, const NamedLists& parts) {
  std::vector<const std::string*> owner(static_cast<std::size_t>(cell_count));
  for (const auto& [part, cells] : parts) {
    if (cells.empty()) return quoted(part) + " has no cell of the sector";
    std::size_t taken = 0;
    const std::string* other = nullptr;
    for (const int cell : cells) {
      const std::string*& first = owner[static_cast<std::size_t>(cell)];
      if (first == &part) return quoted(part) + " lists cell " + std::to_string(cell) + " (from 0) twice";
      if (first != nullptr) ++taken, other = first;
      first = &part;
    }
    if (taken > 0)
      return std::to_string(taken) + " of the " + std::to_string(cells.size()) + " cells of " + quoted(part) +
             " are also in " + quoted(*other) + "; each cell belongs to one part";
  }
  return "";
}

}  // namespace

std::string wrong_parts(const Eigen::MatrixXi& cells, const NamedLists& parts, const NamedLists& tips) {
  if (const std::string wrong = wrong_lists(cells.cols(), parts); !wrong.empty()) return wrong;
  for (const auto& [part, tip] : tips) {
    if (!parts.contains(part)) continue;
    std::set<int> nodes;
    for (const int cell : parts.at(part))
      for (const int node : nodes_of(cells, cell)) nodes.insert(node);
    const auto outside = std::count_if(tip.begin(), tip.end(), [&](int node) { return !nodes.contains(node); });
    if (outside > 0)
      return quoted(part) + " does not hold " + std::to_string(outside) + " of the " + std::to_string(tip.size()) +
             " nodes of its tip line: are two parts exchanged?";
  }
  return "";
}

int listed_twice(std::vector<int> list) {
  std::sort(list.begin(), list.end());
  const auto twice = std::adjacent_find(list.begin(), list.end());
  return twice == list.end() ? -1 : *twice;
}

}  // namespace tiprub
