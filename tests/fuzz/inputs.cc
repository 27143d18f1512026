// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/inputs.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "tests/fuzz/hdf5_structure.h"

namespace tiprub::fuzz {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double extreme_numbers[] = {0,      -0.0,   1,       -1,     2,      0.5,     1e-3,     1e6,       1e9,
                                      -1e9,   1e16,   1e-16,   1e200,  -1e200, 1e-200,  1e-300,   1e308,     -1e308,
                                      5e-324, 0x1p31, -0x1p31, 0x1p32, 0x1p63, -0x1p63, infinity, -infinity, nan};
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t extreme_integers[] = {
    0, 1, -1, 2, -2, 127, 128, 255, 256, 65535, 65536, 0x7fffffff, 0x80000000, 0xffffffff, largest, -largest - 1};
constexpr unsigned char extreme_bytes[] = {0, 1, 2, 0x0a, 0x20, 0x22, 0x7f, 0x80, 0xfe, 0xff};
constexpr std::size_t longest_block = 4096;

/// What stands at the beginning of HDF5's own tables: where its metadata is.
constexpr const char* signatures[] = {"\x89HDF", "TREE", "SNOD", "HEAP", "GCOL"};
constexpr std::size_t metadata_reach = 600;

template <class Value>
void put(std::string& data, std::size_t at, Value value) {
  if (at < data.size()) std::memcpy(data.data() + at, &value, std::min(sizeof(value), data.size() - at));
}

}  // namespace

double extreme_number(Random& random) {
  return random.of(extreme_numbers);
}

void put_extreme_number(std::string& data, std::size_t at, Random& random) {
  const std::int64_t integer = random.of(extreme_integers);
  switch (random.below(4)) {
    case 0:
      return put(data, at, extreme_number(random));
    case 1:
      return put(data, at, static_cast<float>(integer));
    case 2:
      return put(data, at, static_cast<std::int32_t>(integer));
    default:
      return put(data, at, integer);
  }
}

namespace {

/// Anywhere; of HDF5 files half of the time in their metadata, which are a small part of them.
std::size_t place_in(const std::string& data, Random& random) {
  const std::size_t anywhere = random.below(data.size());
  if (random.once_in(2)) return anywhere;
  const std::size_t found = data.find(random.of(signatures), anywhere);
  return found == std::string::npos ? anywhere : std::min(found + random.below(metadata_reach), data.size() - 1);
}

std::size_t block_from(const std::string& data, std::size_t at, Random& random) {
  return std::min(1 + random.below(random.once_in(2) ? 16 : longest_block), data.size() - at);
}

void change_block(std::string& data, const std::string& other, std::size_t at, Random& random) {
  const std::size_t size = block_from(data, at, random);
  const std::string block = data.substr(at, size);
  switch (random.below(6)) {
    case 0:
      data.erase(at, size);
      break;
    case 1:
      data.insert(at, block);
      break;
    case 2:
      data.erase(at, size), data.insert(random.below(data.size()), block);
      break;
    case 3:
      data.replace(at, size, size, static_cast<char>(random.of(extreme_bytes)));
      break;
    case 4:
      data.resize(at);
      break;
    default:
      data = data.substr(0, at) + other.substr(random.below(other.size()));
      break;
  }
}

/// One change: a bit, a byte, a number; a block removed, doubled, moved, zeroed or made up; the end cut off; or from
/// somewhere on the rest of another input.
void change_bytes(std::string& data, const std::string& other, Random& random) {
  if (data.empty()) data = other;
  const std::size_t at = place_in(data, random);
  switch (random.below(6)) {
    case 0:
      data[at] = static_cast<char>(data[at] ^ (1 << random.below(8)));
      break;
    case 1:
      data[at] = static_cast<char>(random.below(256));
      break;
    case 2:
      data[at] = static_cast<char>(random.of(extreme_bytes));
      break;
    case 3:
      put_extreme_number(data, at - at % 8, random);
      break;
    case 4:
      put_extreme_number(data, at, random);
      break;
    default:
      change_block(data, other, at, random);
  }
}

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

/// One change: a number or a word becomes an extreme or an odd one, or one of another text; words are exchanged;
/// lines are removed, doubled, moved or taken from another text.
void change_text(std::string& text, const std::string& other, Random& random) {
  if (random.below(3) < 2)
    change_word(text, other, random);
  else
    change_lines(text, other, random);
}

constexpr std::size_t most_changes = 6;

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": can't be written");
}

}  // namespace

std::vector<Base> read_bases(const std::vector<std::string>& files) {
  std::vector<Base> bases;
  for (const std::string& path : files) {
    std::ifstream file(path, std::ios::binary);
    bases.push_back({path, std::string(std::istreambuf_iterator<char>(file), {})});
    if (bases.back().bytes.empty()) throw std::runtime_error(path + ": can't be read, or is empty");
  }
  return bases;
}

std::filesystem::path make_input(const std::filesystem::path& file, Format format, const std::vector<Base>& bases,
                                 std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index);
  const Base &base = random.of(bases), &other = random.of(bases);
  std::string bytes = base.bytes;
  const bool sound = format == Format::hdf5 && random.once_in(2);  // for HDF5; what it holds may be anything
  const bool as_text = format == Format::text ? !random.once_in(4) : format == Format::mesh && random.once_in(2);
  const std::size_t changes = random.few(most_changes);
  for (std::size_t i = 0; i < changes && !sound; ++i)
    if (as_text)
      change_text(bytes, other.bytes, random);
    else
      change_bytes(bytes, other.bytes, random);
  write(file, bytes);
  for (std::size_t i = 0; i < changes && sound; ++i) change_structure(file, random);
  return base.file.parent_path();
}

}  // namespace tiprub::fuzz
