// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <set>
#include <string>
#include <system_error>
#include <thread>

#include "cases/program/errors.h"

namespace fs = std::filesystem;

namespace tiprub {

namespace {

constexpr const char* list_name = ".tiprub-files";

/// The name of a file relative to the folder; empty for a folder.
std::string name_in(const fs::path& folder, const fs::directory_entry& entry) {
  const bool is_file = !entry.is_directory() || entry.is_symlink();
  return is_file ? entry.path().lexically_relative(folder).generic_string() : "";
}

/// Leaves in a folder the list of all files in it and below it. Raises RunError if it can't be written.
void list_made_files(const fs::path& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    files.insert(name_in(folder, entry));
  write_file(folder / list_name, [&](std::ostream& list) {
    for (const std::string& file : files)
      if (!file.empty()) list << file << "\n";
  });
}

/// A file in the folder, or below it, that is not on the folder's list. Without a list no file is.
std::optional<std::string> file_not_made_here(const fs::path& folder) {
  std::set<std::string> known = {"", list_name};
  std::ifstream list(folder / list_name);
  for (std::string line; std::getline(list, line);) known.insert(line);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (std::string name = name_in(folder, entry); !known.contains(name)) return name;
  return std::nullopt;
}

/// "report/" is the folder "report". Raises RunError if the last part of the path is no name.
fs::path with_name(const fs::path& output) {
  fs::path named = output.has_filename() ? output : output.parent_path();
  if (named.filename().empty() || named.filename() == "." || named.filename() == "..")
    throw RunError(output.string() + ": can't be replaced; give the output a name of its own");
  return named;
}

/// Raises RunError if the folder of an output does not exist.
void require_folder(const fs::path& output) {
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) throw RunError(output.string() + ": can't be written: no folder " + folder.string());
}

/// "sector.msh" -> "sector.tiprub.part.msh".
fs::path beside(const fs::path& target, const std::string& word) {
  fs::path name = target;
  return name.replace_filename(target.stem().string() + ".tiprub." + word + target.extension().string());
}

/// Files that do not exist yet are compared by their names.
bool same_file(const fs::path& one, const fs::path& other) {
  if (one.empty() || other.empty()) return false;
  std::error_code ignored;
  if (fs::equivalent(one, other, ignored)) return true;
  const fs::path place = fs::weakly_canonical(fs::absolute(one), ignored);
  return !place.empty() && place == fs::weakly_canonical(fs::absolute(other), ignored);
}

void require_replaceable(const fs::path& target, OutputFile::Kind kind) {
  const fs::file_status status = fs::status(target);
  const std::string refusal = target.string() + ": can't be replaced: it ";
  if (!fs::exists(status) || (fs::is_regular_file(status) && kind == OutputFile::Kind::file)) return;
  if (kind == OutputFile::Kind::file) throw RunError(refusal + "is no file; give another name");
  if (!fs::is_directory(status)) throw RunError(refusal + "is no folder; give another name");
  if (const auto stranger = file_not_made_here(target))
    throw RunError(refusal + "holds " + *stranger +
                   ", which this program did not make; move that away, or give another -o");
}

/// Waits until the disk has the file. A full disk may show only now.
std::error_code synchronise_file(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {errno, std::generic_category()};
  const bool failed = ::fsync(file) != 0;
  const std::error_code error(failed ? errno : 0, std::generic_category());
  ::close(file);
  return error;
}

/// The same for a file, or for all files in a folder.
std::error_code synchronise(const fs::path& path) {
  if (!fs::is_directory(path)) return synchronise_file(path);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file())
      if (const std::error_code error = synchronise_file(entry.path())) return error;
  return {};
}

/// rename() replaces files, but only empty folders.
std::error_code replace_folder(const fs::path& scratch, const fs::path& target) {
  std::error_code error;
  const fs::path old = beside(target, "old");
  fs::remove_all(old, error);
  fs::rename(target, old, error);
  if (error) return error;
  fs::rename(scratch, target, error);
  std::error_code ignored;
  if (error)
    fs::rename(old, target, ignored);
  else
    fs::remove_all(old, ignored);
  return error;
}

fs::path lock_of(const fs::path& output) {
  const fs::path named = with_name(output);
  return fs::path(named).replace_filename("." + named.filename().string() + ".lock");
}

/// Whether the name still leads to the open file. Its former holder may have removed it meanwhile.
bool leads_to(const fs::path& path, int file) {
  struct stat by_name {
  }, opened{};
  return ::stat(path.c_str(), &by_name) == 0 && ::fstat(file, &opened) == 0 && by_name.st_ino == opened.st_ino &&
         by_name.st_dev == opened.st_dev;
}

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(::getpid()) + " on " + host.data();
}

/// Locks an open file. Asks for a second: the child of a process that was just killed may hold the lock until it
/// ends.
bool locked(int file) {
  constexpr int tries = 20;
  for (int i = 0; i < tries; ++i) {
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

std::string holder(const fs::path& path) {
  std::string line;
  std::ifstream file(path);
  std::getline(file, line);
  return line.empty() ? "another process" : line;
}

}  // namespace

OutputFile::OutputFile(const fs::path& target, Kind kind)
    : target_(with_name(target)), scratch_(beside(target_, "part")), kind_(kind) {
  require_folder(target_);
  require_replaceable(target_, kind_);
  fs::remove_all(scratch_);
  removed_on_signal_.emplace(scratch_);
}

OutputFile::~OutputFile() {
  removed_on_signal_.reset();
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
}

void OutputFile::commit() {
  require_replaceable(target_, kind_);
  if (fs::is_directory(scratch_)) list_made_files(scratch_);
  std::error_code error = synchronise(scratch_);
  if (!error && fs::is_directory(scratch_) && fs::is_directory(target_))
    error = replace_folder(scratch_, target_);
  else if (!error)
    fs::rename(scratch_, target_, error);
  if (error) throw RunError(target_.string() + ": can't be written: " + error.message());
  removed_on_signal_.reset();
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& body) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  if (out) body(out);
  out.close();  // a stream holds bytes back, so that a full disk may show only now
  const int reason = errno;
  if (!out)
    throw RunError(path.string() + ": can't be written" +
                   (reason == 0 ? "" : ": " + std::generic_category().message(reason)));
}

void refuse_overwriting(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  std::vector<fs::path> taken = inputs;
  for (const fs::path& output : outputs) {
    for (const fs::path& other : taken)
      if (same_file(output, other))
        throw InputError(output.string() + ": would be written over " + other.string() +
                         ", which this run reads or writes too; give it another name");
    taken.push_back(output);
  }
}

OutputLock::OutputLock(const fs::path& output) : path_(lock_of(output)) {
  require_folder(output);
  while (file_ < 0) {
    constexpr mode_t readable_by_all = 0644;
    // A link that came with the case may lead to a file of the user's, and the lock would overwrite that.
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, readable_by_all);
    if (file_ < 0 && errno == ELOOP) throw RunError(path_.string() + ": is a link in place of a lock; remove it");
    if (file_ < 0) throw RunError(output.string() + ": can't be written: " + std::generic_category().message(errno));
    if (!locked(file_)) {
      ::close(file_);
      throw RunError(output.string() + ": " + holder(path_) + " is writing it; wait for that, or give another -o");
    }
    if (leads_to(path_, file_)) break;
    ::close(file_);
    file_ = -1;
  }
  const std::string who = this_process() + "\n";
  const bool named = ::ftruncate(file_, 0) == 0 && ::write(file_, who.data(), who.size()) > 0;
  removed_on_signal_.emplace(path_);
  static_cast<void>(named);  // on a full disk the lock holds all the same
}

OutputLock::~OutputLock() {
  ::unlink(path_.c_str());
  removed_on_signal_.reset();
  ::close(file_);
}

}  // namespace tiprub
