// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/text_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numbers>

#include "cases/program/text.h"

namespace tiprub {

namespace {

constexpr std::uintmax_t largest_text = 4 << 20;  // [byte]

/// Whether a word begins with a letter or a quote, and is not a number in letters (nan, inf).
bool is_name(std::string_view word) {
  double number = 0;
  const bool has_letter = word[0] == '"' || std::isalpha(static_cast<unsigned char>(word[0])) != 0;
  return has_letter && std::from_chars(word.data(), word.data() + word.size(), number).ec != std::errc();
}

[[noreturn]] void refuse_word(const NamedText& file, const NumberLine& line, std::size_t word,
                              const std::string& what) {
  constexpr std::size_t shown = 40;  // letters of a word
  const std::string found =
      word < line.words.size() ? '"' + std::string(line.words[word].substr(0, shown)) + "\" stands for " : "no ";
  refuse_line(file, line.number, found + what);
}

bool is_hdf5(const std::filesystem::path& path) {
  constexpr std::string_view signature = "\x89HDF";
  std::string start(signature.size(), ' ');
  return std::ifstream(path, std::ios::binary).read(start.data(), std::ssize(start)) && start == signature;
}

}  // namespace

std::string place_in(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t start = before.find_last_of('\n') + 1;  // npos + 1 is 0
  return ":" + std::to_string(line) + ":" + std::to_string(offset - start + 1) + ": ";
}

void require_utf8(const NamedText& file, const std::string& kind) {
  const std::string_view text = file.text;
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw InputError(file.name + ": is written in UTF-16; save it as UTF-8");
  for (std::size_t i = 0; i < text.size();) {
    const int length = letter_length(text.substr(i, 4));
    if (length == 0 || text[i] == '\0')
      throw InputError(file.name + place_in(text, i) + "the byte " + printable(text.substr(i, 1)) +
                       " is no letter of UTF-8; is this " + kind + ", saved as UTF-8?");
    i += length;
  }
}

NamedText read_named_text(const std::filesystem::path& path, const std::string& kind) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  if (!none && is_hdf5(path)) throw InputError(path.string() + ": is an HDF5 file; name " + kind + " here");
  if (!none && size > largest_text)
    throw InputError(path.string() + ": is larger than " + std::to_string(largest_text >> 20) + " MiB; name " + kind);
  NamedText file = read_named_bytes(path, kind);
  require_utf8(file, kind);
  return file;
}

NamedText read_named_bytes(const std::filesystem::path& path, const std::string& kind) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw RunError(path.string() + ": can't be read: it is " + (fs::is_directory(status) ? "a folder" : "no file") +
                   "; name " + kind);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  NamedText file{path.string(), std::string(std::istreambuf_iterator<char>(stream), {})};
  if (!stream.is_open() || stream.bad())
    throw RunError(path.string() + ": can't be read" + (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
  return file;
}

std::vector<NumberLine> lines_of(const NamedText& file) {
  std::vector<NumberLine> lines;
  std::string_view rest = file.text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::size_t remark = std::min(line.size(), line.find('#'));
    NumberLine found{number, words_of(line.substr(0, remark), " \t\r,"), line.substr(remark)};
    if (!found.words.empty() || !found.remark.empty()) lines.push_back(std::move(found));
  }
  return lines;
}

std::vector<NumberLine> lines_below_heading(const NamedText& file) {
  std::vector<NumberLine> lines = lines_of(file);
  std::erase_if(lines, [](const NumberLine& line) { return line.words.empty(); });
  if (!lines.empty() && is_name(lines[0].words[0])) lines.erase(lines.begin());
  return lines;
}

void require_words(const NamedText& file, const NumberLine& line, std::size_t count, std::string_view meaning) {
  if (line.words.size() != count)
    refuse_line(file, line.number,
                "has " + std::to_string(line.words.size()) + " words, and must have " + std::to_string(count) + ": " +
                    std::string(meaning));
}

void refuse_line(const NamedText& file, int line, const std::string& message) {
  throw InputError(file.name + ":" + std::to_string(line) + ": " + message);
}

double number_in(const NamedText& file, const NumberLine& line, std::size_t word, std::string_view meaning) {
  if (word < line.words.size()) {
    std::string_view text = line.words[word];
    if (text.starts_with('+')) text.remove_prefix(1);
    if (const auto value = number_of<double>(text)) return *value;
  }
  refuse_word(file, line, word, std::string(meaning) + ", which must be a finite number");
}

double angle_in(const NamedText& file, const NumberLine& line, std::size_t word, std::string_view meaning,
                double unit) {
  constexpr double most = 100 * 2.0 * std::numbers::pi;
  const double angle = unit * number_in(file, line, word, meaning);
  if (std::abs(angle) > most)
    refuse_word(file, line, word, std::string(meaning) + ", which must be within 100 turns");
  return angle;
}

int count_in(const NamedText& file, const NumberLine& line, std::size_t word, std::string_view meaning, int least,
             int most) {
  if (word < line.words.size()) {
    const auto value = number_of<int>(line.words[word]);
    if (value >= least && value <= most) return *value;
  }
  refuse_word(file, line, word,
              std::string(meaning) + ", which must be a whole number from " + std::to_string(least) + " to " +
                  std::to_string(most));
}

}  // namespace tiprub
