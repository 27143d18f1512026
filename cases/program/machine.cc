// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/machine.h"

#include <dlfcn.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double bytes_per_kib = 1024;
constexpr double room_for_libraries = 160 * bytes_per_kib * bytes_per_kib;  // OpenBLAS maps 128 MiB, HDF5 16 MiB
constexpr const char* kernels_variable = "OPENBLAS_CORETYPE";
constexpr const char* generic_kernels = "Prescott";

/// The first number of a file, or the fallback if there is none, as in the file of a control group that says "max".
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

/// A function of OpenBLAS, or null: not all programs link a BLAS, and not every BLAS is OpenBLAS.
template <class Function>
Function* find(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// The name of the kernels in use; empty without OpenBLAS.
std::string kernels_taken() {
  auto* name = find<char*()>("openblas_get_corename");
  return name != nullptr ? name() : "";
}

/// OpenBLAS's name of the kernels for the widest vectors that the processor and the operating system support.
std::string kernels_of_processor() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512cd");
  if (avx512) return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
  if (__builtin_cpu_supports("avx")) return "Sandybridge";
#endif
  return generic_kernels;
}

/// Sets a variable unless the user has set it. Returns whether it did.
bool offer(const char* variable, const std::string& value) {
  return std::getenv(variable) == nullptr && setenv(variable, value.c_str(), 1) == 0;
}

constexpr int mebibyte = 1 << 20;

}  // namespace

double mapped_memory() {
  return number_in("/proc/self/statm", 0) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double mappable_memory() {
  double least = unlimited;
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA})
    if (rlimit limit{}; getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      least = std::min(least, static_cast<double>(limit.rlim_cur));
  return std::max(least - mapped_memory(), 0.0);
}

double available_memory(const std::filesystem::path& root) {
  return std::min({system_memory(root), control_group_memory(root), mappable_memory()});
}

void require_room_for_libraries() {
  constexpr double bytes_per_mib = bytes_per_kib * bytes_per_kib;
  const double mappable = mappable_memory();
  if (mappable >= room_for_libraries) return;
  throw RunError("not enough memory: about " + std::to_string(std::lround(room_for_libraries / bytes_per_mib)) +
                 " MiB are needed to begin with, " + std::to_string(std::lround(mappable / bytes_per_mib)) +
                 " MiB are available under ulimit; raise that");
}

void return_freed_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, 512 * mebibyte);
}

void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);  // glibc takes no more
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, 16 * mebibyte);
}

void work_together(int threads, const std::function<void()>& work) {
  std::mutex failing;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  others.reserve(static_cast<std::size_t>(std::max(threads - 1, 0)));
  try {
    for (int i = 1; i < threads; ++i) others.emplace_back(guarded);
  } catch (const std::system_error&) {  // the system gives no more threads
  }
  guarded();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

void work_on_pieces(std::ptrdiff_t size, std::ptrdiff_t at_once, int threads,
                    const std::function<void(std::ptrdiff_t first, std::ptrdiff_t count)>& work) {
  std::atomic<std::ptrdiff_t> next = 0;
  const std::ptrdiff_t most = threads > 0 ? threads : std::thread::hardware_concurrency();
  work_together(static_cast<int>(std::min(most, (size + at_once - 1) / at_once)), [&] {
    for (std::ptrdiff_t first = 0; (first = next.fetch_add(at_once)) < size;) try {
        work(first, std::min(at_once, size - first));
      } catch (...) {
        next = size;
        throw;
      }
  });
}

void prepare_blas(char** argv) {
  const std::string taken = kernels_taken();
  bool other =
      taken == generic_kernels && kernels_of_processor() != taken && offer(kernels_variable, kernels_of_processor());
  if (!taken.empty() && std::isfinite(mappable_memory())) other |= offer("OPENBLAS_NUM_THREADS", "1");
  if (other) execv("/proc/self/exe", argv);
}

std::string blas_description() {
  auto* config = find<char*()>("openblas_get_config");
  if (config == nullptr) return "";
  const char* asked = std::getenv(kernels_variable);
  return config() + (", kernels " + kernels_taken()) +
         (asked != nullptr ? std::string(", by ") + kernels_variable : "");
}

std::string blas_warning() {
  if (kernels_taken() != generic_kernels) return "";
  return std::string("OpenBLAS works with its generic kernels (") + generic_kernels +
         "), which take twice as long or more: " +
         (std::getenv(kernels_variable) != nullptr ? std::string(kernels_variable) + " asks for them"
                                                   : "it has no better ones for this processor");
}

}  // namespace tiprub
