// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/words.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tiprub {

namespace {

/// How many letters have to be changed, left out or put in to make one word of the other.
std::size_t letters_apart(std::string_view one, std::string_view other) {
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < other.size(); ++j) {
      const std::size_t changed = diagonal + (one[i] == other[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({changed, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
}

}  // namespace

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string meant(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t few = 2;
  std::size_t least = std::min(few + 1, word.size());
  std::string text;
  for (const std::string& other : known)
    if (const std::size_t apart = letters_apart(word, other); apart < least) {
      least = apart;
      text = " (did you mean " + other + "?)";
    }
  return text;
}

std::string items_of(std::size_t columns) {
  if (columns == 1) return "numbers";
  return columns == 2 ? "[x, y] pairs" : "lists of " + std::to_string(columns) + " numbers";
}

}  // namespace tiprub
