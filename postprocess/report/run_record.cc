// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report.h"

#include <sys/resource.h>

#include <ctime>

#include "cases/program/command_line.h"
#include "cases/program/text_file.h"
#include "postprocess/tables/table.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {

namespace {

/// "2026-03-01 12:30 UTC"; empty if the file has no date.
std::string date_of(const fs::path& file) {
  std::error_code error;
  const fs::file_time_type written = fs::last_write_time(file, error);
  if (error) return "";
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(std::chrono::file_clock::to_sys(written)));
  std::tm parts{};
  char text[32] = "";
  if (gmtime_r(&seconds, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

/// "model: tiprub-reduce 0.1.0, 12.3 s, 20.1 s of processor time on 2 processors".
std::string stage_in_words(const fs::path& note) {
  const NamedText file = read_named_text(note, "a note that --times wrote");
  const std::vector<NumberLine> lines = lines_below_heading(file);
  if (lines.size() != 1) throw InputError(file.name + ": must hold one run, as --times notes it");
  const NumberLine& line = lines.front();
  require_words(file, line, 5, "program and version, wall time [s], processor time [s], processors");
  std::vector<double> numbers;
  for (std::size_t word = 2; word < line.words.size(); ++word) {
    numbers.push_back(number_in(file, line, word, "a time or a number of processors"));
    if (numbers.back() < 0) refuse_line(file, line.number, "a time is negative; --times notes none");
  }
  return note.stem().string() + ": " + std::string(line.words[0]) + " " + std::string(line.words[1]) + ", " +
         fixed(numbers[0], 1) + " s, " + fixed(numbers[1], 1) + " s of processor time on " + fixed(numbers[2], 0) +
         (numbers[2] == 1 ? " processor" : " processors");
}

/// [bytes] The most memory that this process has had so far.
double peak_memory() {
  constexpr double unit = 1024;  // of ru_maxrss
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? unit * static_cast<double>(usage.ru_maxrss) : 0;
}

}  // namespace

RunRecord::RunRecord(std::vector<fs::path> inputs, const std::vector<fs::path>& stages)
    : inputs_(std::move(inputs)), stages_(listed(stages, "; ", stage_in_words)) {}

void RunRecord::done(const std::string& part) {
  const auto now = std::chrono::steady_clock::now();
  parts_.emplace_back(part, std::chrono::duration<double>(now - last_).count());
  memory_ = peak_memory();
  last_ = now;
}

std::vector<Answer> RunRecord::in_words() const {
  constexpr double bytes_per_gb = 1e9;
  const std::string inputs =
      listed(inputs_, "; ", [](const fs::path& file) { return file.filename().string() + " of " + date_of(file); });
  std::string times =
      listed(parts_, ", ", [](const auto& part) { return part.first + " " + fixed(part.second, 1) + " s"; });
  if (memory_ > 0) times += "; at most " + fixed(memory_ / bytes_per_gb, 2) + " GB of memory";
  const std::string commit = TIPRUB_COMMIT;
  std::vector<Answer> answers = {
      {"Program", program_version("tiprub-postprocess") + (commit.empty() ? "" : ", built of commit " + commit)},
      {"Inputs", inputs},
      {"Time taken", times}};
  if (!stages_.empty()) answers.push_back({"The stages before", stages_});
  return answers;
}

}  // namespace tiprub::postprocess
