// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <string>

namespace tiprub {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double bytes_per_kib = 1024;

/// The first number of a file, or the fallback if there is none ("max" in a control group's file is none).
double number_in(const std::filesystem::path& path, double fallback) {
  std::ifstream file(path);
  double value = 0;
  return file >> value ? value : fallback;
}

double system_memory(const std::filesystem::path& root) {
  std::ifstream file(root / "proc/meminfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("MemAvailable:", 0) == 0) return std::stod(line.substr(line.find(':') + 1)) * bytes_per_kib;
  return unlimited;
}

double control_group_memory(const std::filesystem::path& root) {
  const std::filesystem::path group = root / "sys/fs/cgroup";
  const double second = number_in(group / "memory.max", unlimited) - number_in(group / "memory.current", 0);
  const double first = number_in(group / "memory/memory.limit_in_bytes", unlimited) -
                       number_in(group / "memory/memory.usage_in_bytes", 0);
  return std::min(first, second);
}

}  // namespace

double mappable_memory() {
  const double mapped = number_in("/proc/self/statm", 0) * static_cast<double>(sysconf(_SC_PAGESIZE));
  double least = unlimited;
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA})
    if (rlimit limit{}; getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      least = std::min(least, static_cast<double>(limit.rlim_cur));
  return std::max(least - mapped, 0.0);
}

double available_memory(const std::filesystem::path& root) {
  return std::min({system_memory(root), control_group_memory(root), mappable_memory()});
}

void require_memory(std::size_t bytes) {
  void* volatile memory = std::malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  std::free(memory);
}

}  // namespace tiprub
