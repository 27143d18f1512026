// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cells/gmsh_file.h"

#include <fcntl.h>
#include <gmsh.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>

#include "cases/program/errors.h"
#include "cases/program/sandbox.h"

namespace tiprub {

namespace {

constexpr std::string_view comments_begin = "$Comments\n", comments_end = "$EndComments\n";

/// An open file. gmsh reads it by its descriptor, so that it is the file whose first line was checked.
class OpenFile {
 public:
  /// A file in memory, because gmsh reads files only.
  explicit OpenFile(const NamedText& contents)
      : file_(memfd_create("mesh", MFD_CLOEXEC)), size_(static_cast<double>(contents.text.size())) {
    std::ofstream copy(name(), std::ios::binary);
    if (copy.write(contents.text.data(), std::ssize(contents.text)).flush()) return;
    const std::string reason = std::strerror(errno);
    close(file_);
    throw RunError(contents.name + ": can't be copied for gmsh: " + reason);
  }
  explicit OpenFile(const std::filesystem::path& path)
      : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (file_ < 0) throw RunError(path.string() + ": " + (errno == ENOENT ? "no such file" : std::strerror(errno)));
    struct stat about {};
    fstat(file_, &about);
    if (S_ISREG(about.st_mode)) {
      size_ = static_cast<double>(about.st_size);
      return;
    }
    close(file_);
    throw RunError(path.string() + ": is no file that can be read");
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { close(file_); }

  double size() const { return size_; }
  std::string first_line() const {
    std::array<char, 64> start{};
    const ssize_t count = pread(file_, start.data(), start.size(), 0);
    const std::string_view text(start.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return std::string(text.substr(0, text.find_first_of("\r\n")));
  }
  /// This name has no ending by which gmsh would choose a reader, and no options file stands beside it.
  std::string name() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
  double size_ = 0;
};

/// Packs values as bytes, one after the other, and unpacks them.
class Bytes {
 public:
  Bytes() = default;
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}
  const std::string& all() const { return bytes_; }

  void put(std::size_t value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value)); }
  template <class List>
  void put_list(const List& list) {
    put(list.size());
    bytes_.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(list[0]));
  }
  std::size_t take() {
    std::size_t value = 0;
    take_bytes(&value, sizeof(value));
    return value;
  }
  template <class List>
  void take_list(List& list) {
    list.resize(take());
    take_bytes(list.data(), list.size() * sizeof(list[0]));
  }

 private:
  void take_bytes(void* to, std::size_t count) {
    if (count > 0) std::memcpy(to, bytes_.data() + at_, count);  // an empty list has no place
    at_ += count;
  }

  std::string bytes_;
  std::size_t at_ = 0;
};

std::string packed(const GmshFile& file) {
  Bytes bytes;
  bytes.put_list(file.node_tags);
  bytes.put_list(file.positions);
  bytes.put(file.elements.size());
  for (const GmshElements& elements : file.elements) {
    bytes.put(static_cast<std::size_t>(elements.dimension));
    bytes.put_list(elements.group);
    bytes.put(static_cast<std::size_t>(elements.type));
    bytes.put_list(elements.tags);
    bytes.put_list(elements.nodes);
  }
  return bytes.all();
}

GmshFile unpacked(std::string from) {
  Bytes bytes(std::move(from));
  GmshFile file;
  bytes.take_list(file.node_tags);
  bytes.take_list(file.positions);
  file.elements.resize(bytes.take());
  for (GmshElements& elements : file.elements) {
    elements.dimension = static_cast<int>(bytes.take());
    bytes.take_list(elements.group);
    elements.type = static_cast<int>(bytes.take());
    bytes.take_list(elements.tags);
    bytes.take_list(elements.nodes);
  }
  return file;
}

void read_entity(int dimension, int entity, const std::string& group, GmshFile& file) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
  for (std::size_t i = 0; i < types.size(); ++i)
    if (!tags[i].empty()) file.elements.push_back({dimension, group, types[i], tags[i], nodes[i]});
}

void read_groups(GmshFile& file) {
  gmsh::vectorpair groups, volumes;
  gmsh::model::getPhysicalGroups(groups);
  std::set<int> named;  // volumes
  for (const auto& [dimension, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, tag, name);
    if (name.empty()) continue;
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
    for (const int entity : entities) read_entity(dimension, entity, name, file);
    if (dimension == 3) named.insert(entities.begin(), entities.end());
  }
  gmsh::model::getEntities(volumes, 3);
  for (const auto& [dimension, entity] : volumes)
    if (!named.contains(entity)) read_entity(dimension, entity, "", file);
}

/// Runs in the child process, so that gmsh's only model needs no clean-up.
std::string read_by_gmsh(const std::string& name) {
  try {
    gmsh::initialize(0, nullptr, false);  // without the user's option files
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::merge(name);
    GmshFile file;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(file.node_tags, file.positions, parameters, -1, -1, false, false);
    read_groups(file);
    return packed(file);
  } catch (std::string& reason) {  // what gmsh 4.8 throws
    if (const std::size_t at = reason.find(name); at != std::string::npos) reason.replace(at, name.size(), "it");
    if (reason == "Error loading 'it'") reason = "it is cut off or damaged";
    throw InputError("gmsh can't read it: " + reason);
  } catch (const std::length_error&) {
    throw InputError("gmsh takes more memory for it than any machine has; its counts don't fit what it holds");
  }
}

SandboxLimits limits_for(double file_size) {
  constexpr double least_bytes = 1024.0 * 1024 * 1024, bytes_per_byte = 100;  // gmsh takes some 10 a byte of text
  constexpr double least_seconds = 10, bytes_per_second = 1e5;                // and reads some 10 MB a second
  return {least_bytes + bytes_per_byte * file_size, least_seconds + file_size / bytes_per_second};
}

GmshFile read_open_file(const OpenFile& file, const std::string& shown) {
  const std::string begin = file.first_line();
  if (begin != "$MeshFormat" && begin != "$Comments")
    throw InputError(shown +
                     ": is no mesh in gmsh's format: its first line must be $MeshFormat; write it by gmsh FILE -save "
                     "-format msh41 -o sector.msh");
  try {
    return unpacked(made_in_sandbox([&] { return read_by_gmsh(file.name()); }, limits_for(file.size())));
  } catch (const InputError& error) {
    throw InputError(shown + ": " + error.what());
  } catch (const RunError& error) {
    throw RunError(shown + ": " + error.what());
  } catch (const SandboxFailure& death) {
    throw InputError(shown + ": gmsh fails on it (" + death.what() +
                     "): its counts don't fit what it holds, or it is damaged; write it again");
  }
}

}  // namespace

std::vector<GmshElements> GmshFile::group(int dimension, const std::string& name) const {
  std::vector<GmshElements> found;
  std::set<std::vector<std::size_t>> known;
  for (const GmshElements& from : elements) {
    if (from.dimension != dimension || from.group != name) continue;
    GmshElements once = {dimension, name, from.type, {}, {}};
    const auto width = static_cast<std::ptrdiff_t>(from.nodes_per_element());
    for (std::size_t i = 0; i < from.tags.size(); ++i) {
      const auto first = from.nodes.begin() + width * static_cast<std::ptrdiff_t>(i);
      std::vector<std::size_t> nodes(first, first + width);
      std::ranges::sort(nodes);
      if (!known.insert(nodes).second) continue;
      once.tags.push_back(from.tags[i]);
      once.nodes.insert(once.nodes.end(), first, first + width);
    }
    if (!once.tags.empty()) found.push_back(once);
  }
  return found;
}

GmshFile read_gmsh_file(const std::filesystem::path& path) {
  return read_open_file(OpenFile(path), path.string());
}

GmshFile read_gmsh_file(const NamedText& contents) {
  return read_open_file(OpenFile(contents), contents.name);
}

void append_comments(const std::string& lines, const std::filesystem::path& path) {
  std::ofstream file(path, std::ios::app);
  file << comments_begin << lines << comments_end;
  if (!file.flush()) throw RunError(path.string() + ": can't be written to its end; is the disk full?");
}

std::string appended_comments(const std::filesystem::path& path) {
  constexpr std::streamoff longest = 1 << 20;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  file.seekg(std::max<std::streamoff>(size - longest, 0));
  const std::string end{std::istreambuf_iterator<char>(file), {}};
  const std::size_t from = end.rfind(comments_begin);
  if (from == std::string::npos || !end.ends_with(comments_end)) return "";
  const std::size_t first = from + comments_begin.size();
  return end.substr(first, end.size() - comments_end.size() - first);
}

}  // namespace tiprub
