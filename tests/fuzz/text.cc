// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/text.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

namespace tiprub::fuzz {

namespace {

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, '|');) parts.push_back(part);
  return parts;
}

const std::vector<std::string> numbers = split(
    "0|-0|1|-1|2|3|0.5|1e-3|1e3|1e6|1e9|1e16|1e-16|1e200|-1e200|1e-300|1e308|5e-324|1e-320|1e999|nan|inf|-inf|"
    "2147483647|2147483648|-2147483649|4294967296|9223372036854775807|9223372036854775808|"
    "99999999999999999999999|0x7fffffff|1_000|1,5|+7|007");
const std::vector<std::string> odd_words =
    split(R"w(true|""|"linear"|''|[]|[[]]|{}|[0.0, 1.0]|[[0.0, 1e-3], [1.0, 1e-3]]|[[0.0, 1.0, 2.0]]|)w"
          R"w([[1.0, 0.0], [0.0, 1.0]]|[nan]|["a"]|{a = 1}|1979-05-27T07:32:00Z|"\u0000"|"a\nb"|"$(touch ran)"|)w"
          R"w(`touch ran`|#|=|[|]|"|'''|$End|SystemCall "touch ran";|)w"
          "\"\x1b[31m\"|\x01|\xff\xfe|\xc3\xa4");
constexpr std::string_view blanks = " \t\n\r,[]={}";
constexpr std::size_t deepest = 3000, longest = 70000;

struct Piece {
  std::size_t at, size;
};

/// Words are what stands between blanks, commas and brackets; lines keep their end.
std::vector<Piece> words_of(const std::string& text) {
  std::vector<Piece> words;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    words.push_back({at, end - at});
    at = text.find_first_not_of(blanks, end);
  }
  return words;
}

std::vector<Piece> lines_of(const std::string& text) {
  std::vector<Piece> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    lines.push_back({at, end - at});
    at = end;
  }
  return lines;
}

std::string copy(const std::string& text, Piece piece) {
  return text.substr(piece.at, piece.size);
}

/// One that begins as numbers do, as far as 20 tries find one.
Piece number_of(const std::string& text, const std::vector<Piece>& words, Random& random) {
  Piece word = random.of(words);
  for (int tries = 0; tries < 20 && std::string_view("+-.0123456789").find(text[word.at]) == std::string_view::npos;
       ++tries)
    word = random.of(words);
  return word;
}

std::string much(Random& random) {
  const std::size_t count = 1 + random.below(random.once_in(2) ? deepest : longest);
  constexpr std::string_view parts[] = {"[", "a.", "{a=", "9", "x", " ", "\n", "\"", "[[1,2],"};
  const std::string_view part = random.of(parts);
  std::string text;
  while (text.size() < count) text += part;
  return text;
}

void change_word(std::string& text, const std::string& other, Random& random) {
  const std::vector<Piece> words = words_of(text), others = words_of(other);
  if (words.empty() || others.empty()) return;
  const Piece word = random.of(words), number = number_of(text, words, random);
  switch (random.below(6)) {
    case 0:
    case 1:
      text.replace(number.at, number.size, random.of(numbers));
      break;
    case 2:
      text.replace(word.at, word.size, random.of(odd_words));
      break;
    case 3:
      text.replace(word.at, word.size, copy(text, random.of(words)));
      break;
    case 4:
      text.replace(word.at, word.size, copy(other, random.of(others)));
      break;
    default:
      if (random.once_in(4))
        text.replace(word.at, word.size, much(random));
      else
        text.replace(number.at, number.size, std::to_string(random.below(1000)));
  }
}

void change_lines(std::string& text, const std::string& other, Random& random) {
  const std::vector<Piece> lines = lines_of(text), others = lines_of(other);
  if (lines.empty() || others.empty()) return;
  const Piece line = random.of(lines);
  const std::size_t place = random.of(lines).at;
  switch (random.below(5)) {
    case 0:
      text.erase(line.at, line.size);
      break;
    case 1:
      text.insert(place, copy(text, line));
      break;
    case 2:
      text.insert(place, copy(other, random.of(others)));
      break;
    case 3: {
      const std::string moved = copy(text, line);
      text.erase(line.at, line.size);
      text.insert(std::min(place, text.size()), moved);
      break;
    }
    default: {  // from here to there
      const std::size_t first = std::min(line.at, place), last = std::max(line.at, place);
      if (random.once_in(2))
        text.erase(first, last - first);
      else
        text.insert(last, text.substr(first, last - first));
    }
  }
}

}  // namespace

void change_text(std::string& text, const std::string& other, Random& random) {
  if (random.below(3) < 2)
    change_word(text, other, random);
  else
    change_lines(text, other, random);
}

}  // namespace tiprub::fuzz
