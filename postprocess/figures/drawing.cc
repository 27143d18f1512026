// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/drawing.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <list>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <thread>

#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "cases/program/signal_cleanup.h"
#include "embedded/figure_list.h"
#include "embedded/figure_scripts.h"
#include "postprocess/tables/table.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {

namespace {

constexpr int value_digits = 12;
constexpr int table_digits = 8;  // more than a picture can show
constexpr const char* array_start = "array ";

/// With a point or an exponent, since gnuplot rounds the quotient of whole numbers.
std::string number(double value) {
  if (!std::isfinite(value)) return "NaN";
  const std::string text = significant(value, value_digits);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// "name = 3", or an array, which has at least one element in gnuplot.
struct Assignment {
  const std::string& name;

  std::string operator()(int value) const { return name + " = " + std::to_string(value) + "\n"; }
  std::string operator()(double value) const { return name + " = " + number(value) + "\n"; }
  std::string operator()(const std::string& text) const { return name + " = " + gnuplot_text(text) + "\n"; }
  std::string operator()(const DrawnRange& range) const {
    const DrawnRange drawn = range.widened();
    return name + "_low = " + number(drawn.low) + "\n" + name + "_high = " + number(drawn.high) + "\n";
  }
  std::string operator()(const std::vector<double>& values) const { return list(values, number); }
  std::string operator()(const std::vector<std::string>& texts) const { return list(texts, gnuplot_text); }

  template <typename Value, typename Written>
  std::string list(const std::vector<Value>& values, const Written& written) const {
    if (values.empty()) return array_start + name + "[1]\n";
    std::string text = array_start + name + "[" + std::to_string(values.size()) + "] = [";
    for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + written(values[i]);
    return text + "]\n";
  }
};

void write_sheet(std::ostream& out, const Eigen::MatrixXd& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (Eigen::Index k = 0; k < rows.cols(); ++k)
      out << (std::isfinite(rows(i, k)) ? significant(rows(i, k), table_digits) : "NaN")
          << (k + 1 < rows.cols() ? ',' : '\n');
}

std::string data_block(const ScriptTable& table) {
  std::ostringstream out;
  out << "$" << table.name << " << EOD\n";
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < table.sheets.size(); ++i) {
    if (i > 0) out << "\n\n";
    write_sheet(out, table.sheets[i]);
    rows += table.sheets[i].rows();
  }
  out << "EOD\n" << table.name << "_rows = " << rows << "\n";
  return out.str();
}

constexpr const char* program = "gnuplot";

/// The environment, with malloc told to keep what is freed: the surface of one picture after the other has the same
/// size, and the system would clear its pages again for each.
std::vector<char*> environment() {
  static std::array<std::string, 3> keep = {"MALLOC_MMAP_THRESHOLD_=33554432", "MALLOC_TRIM_THRESHOLD_=1073741824",
                                            "MALLOC_TOP_PAD_=16777216"};
  std::vector<char*> all;
  for (std::string& variable : keep) all.push_back(variable.data());
  for (char** variable = environ; *variable != nullptr; ++variable) all.push_back(*variable);
  all.push_back(nullptr);
  return all;
}

/// Starts gnuplot in the folder, with its messages in `log`.
pid_t start(const fs::path& folder, const std::string& script, const std::string& log) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  std::string name = program, argument = script;
  char* const arguments[] = {name.data(), argument.data(), nullptr};
  pid_t child = -1;
  const int error = posix_spawnp(&child, program, &files, nullptr, arguments, environment().data());
  posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw RunError(std::string("gnuplot can't be started: ") + std::strerror(error) +
                   (error == ENOENT ? "; install it (Debian: gnuplot-nox)" : ""));
  return child;
}

/// Waits for one child and gives its status; -1 after a signal, which may have come to another thread.
int wait_for(pid_t child) {
  constexpr std::chrono::milliseconds between_looks(5);
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if ((ended < 0 && errno != EINTR) || interruption() != 0) return -1;
    std::this_thread::sleep_for(between_looks);
  }
}

/// Whether a picture ends as it should: gnuplot does not report a full disk.
bool is_whole(const fs::path& picture) {
  const std::string last_words = picture.extension() == ".svg" ? "</svg>" : "IEND\xAE\x42\x60\x82";
  constexpr std::streamoff end_size = 16;
  std::ifstream stream(picture, std::ios::binary);
  stream.seekg(-end_size, std::ios::end);
  const std::string end(std::istreambuf_iterator<char>(stream), {});
  return end.find(last_words) != std::string::npos;
}

/// Drawings that one process makes one after the other; ended with this object if it still runs.
class Job {
 public:
  Job(fs::path folder, const std::string& name, std::vector<const Drawing*> drawings)
      : folder_(std::move(folder)), name_(name), drawings_(std::move(drawings)) {
    std::string script;
    for (const Drawing* drawing : drawings_) {
      write_text(prologue(*drawing), folder_ / (drawing->name + ".gp"));
      script += "load '" + drawing->name + ".gp'\nreset session\n";
    }
    write_text(script, folder_ / (name_ + ".gp"));
    child_ = start(folder_, name_ + ".gp", name_ + ".log");
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job() {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) continue;
  }

  /// Waits for the process and checks its pictures.
  void finish() {
    const int status = wait_for(child_);
    stop_if_interrupted();
    child_ = -1;
    for (const Drawing* drawing : drawings_)
      for (const char* ending : {".svg", ".png"}) {
        const fs::path picture = folder_ / (drawing->name + ending);
        if (is_whole(picture)) continue;
        if (status != 0)
          throw RunError((folder_ / drawing->name).string() + ": gnuplot could not draw it: " + complaint(status));
        throw RunError(picture.string() + ": is not whole; is the disk full? gnuplot says: " + complaint(status));
      }
    if (status != 0) throw RunError(folder_.string() + ": gnuplot failed: " + complaint(status));
    for (const Drawing* drawing : drawings_) fs::remove(folder_ / (drawing->name + ".gp"));
    for (const char* ending : {".gp", ".log"}) fs::remove(folder_ / (name_ + ending));
  }

 private:
  /// gnuplot's message, on one line.
  std::string complaint(int status) const {
    std::string text = read_text(folder_ / (name_ + ".log"));
    std::ranges::replace_if(
        text, [](unsigned char letter) { return std::iscntrl(letter) != 0; }, ' ');
    text.erase(0, text.find_first_not_of(' '));
    text.erase(text.find_last_not_of(' ') + 1);
    if (!text.empty()) return text;
    if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status)) + " ended it";
    return "it gave no reason";
  }

  fs::path folder_;
  std::string name_;
  std::vector<const Drawing*> drawings_;
  pid_t child_ = -1;
};

constexpr int gnuplot_processes = 2;

void write_pixels(const Pixels& pixels, const fs::path& folder) {
  using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMajor values = pixels.values;
  write_file(folder / pixels.file, [&](std::ostream& stream) {
    stream.write(reinterpret_cast<const char*>(values.data()),
                 static_cast<std::streamsize>(sizeof(float) * static_cast<std::size_t>(values.size())));
  });
}

}  // namespace

DrawnRange DrawnRange::widened() const {
  constexpr double narrowest = 1e-4, smallest = 1e-12;
  const double least = std::max(narrowest * std::max(std::abs(low), std::abs(high)), smallest);
  if (high - low >= least) return *this;
  return low == 0 ? DrawnRange{0, least} : DrawnRange{low - 0.5 * least, high + 0.5 * least};
}

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) {
    if (std::strchr("_^{}@&~\\", letter) != nullptr && letter != '\0') quoted += '\\';
    if (letter == '\'')
      quoted += R"('."\047".')";  // neither doubled nor as it is: gnuplot 5.4 loses count of either
    else
      quoted += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return quoted + "'";
}

std::string prologue(const Drawing& drawing) {
  // Names of files are this program's own, letters and underscores, and need no quoting.
  std::string text = "name = '" + drawing.name + "'\nscript = '" + drawing.script +
                     "'\nwidth = " + std::to_string(drawing.width) + "\nheight = " + std::to_string(drawing.height) +
                     "\n";
  for (const auto& [name, value] : drawing.values) text += std::visit(Assignment{name}, value);
  for (const ScriptTable& table : drawing.tables) text += data_block(table);
  return text + "load 'scripts/draw.gp'\n";
}

void require_gnuplot() {
  const pid_t child = start(fs::path("/"), "--version", "/dev/null");
  if (wait_for(child) != 0) throw RunError("gnuplot --version failed; reinstall it (Debian: gnuplot-nox)");
}

void draw(const std::vector<Drawing>& drawings, const fs::path& folder, int processes) {
  const fs::path scripts = folder / "scripts";
  fs::create_directories(scripts);
  for (const auto& [name, text] : embedded::figure_scripts::files) write_text(std::string(text), scripts / name);
  std::vector<std::vector<const Drawing*>> shares(
      std::min(static_cast<std::size_t>(std::max(processes, 1)), drawings.size()));
  for (std::size_t i = 0; i < drawings.size(); ++i) shares[i % shares.size()].push_back(&drawings[i]);
  std::list<Job> jobs;
  for (std::vector<const Drawing*>& share : shares)
    jobs.emplace_back(folder, "drawings_" + std::to_string(jobs.size()), std::move(share));
  for (Job& job : jobs) job.finish();
  fs::remove_all(scripts);
}

Figure listed_figure(const std::string& name, const std::map<std::string, std::string>& values) {
  static const nlohmann::json list = nlohmann::json::parse(embedded::figure_list::figures_json, nullptr, true, true);
  const nlohmann::json& entry = list.at(name);
  const std::string caption =
      listed(entry.at("caption"), " ", [](const nlohmann::json& line) { return line.get<std::string>(); });
  const std::string text = filled(entry.at("title").get<std::string>() + "\n" + caption, values);
  const std::size_t title_end = text.find('\n');
  return {.drawing = {.name = name,
                      .width = entry.at("size").at(0),
                      .height = entry.at("size").at(1),
                      .script = entry.value("script", name)},
          .title = text.substr(0, title_end),
          .caption = text.substr(title_end + 1)};
}

void set_pixels(Figure& figure, Eigen::MatrixXf values) {
  figure.drawing.values.insert(figure.drawing.values.end(), {{"pixel_columns", static_cast<int>(values.cols())},
                                                             {"pixel_rows", static_cast<int>(values.rows())}});
  figure.pixels.push_back({figure.drawing.name + ".pixels", std::move(values)});
}

void draw_figures(const std::vector<Figure>& figures, const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<Drawing> drawings;
  for (const Figure& figure : figures) {
    stop_if_interrupted();
    write_csv(figure.data, folder / (figure.drawing.name + ".csv"));
    for (const Pixels& pixels : figure.pixels) write_pixels(pixels, folder);
    drawings.push_back(figure.drawing);
  }
  draw(drawings, folder, gnuplot_processes);
  for (const Figure& figure : figures)
    for (const Pixels& pixels : figure.pixels) fs::remove(folder / pixels.file);
}

}  // namespace tiprub::postprocess
