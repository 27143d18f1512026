// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/machine/blas_kernels.h"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <map>

namespace tiprub {

namespace {

constexpr const char* setting = "OPENBLAS_CORETYPE";
constexpr const char* generic = "Prescott";
constexpr std::size_t blas_space =
    (std::size_t{128} << 20) + (std::size_t{1} << 16);  // bytes: of a thread, and its bounds

/// OpenBLAS of the running program, if that has one: not all programs link a BLAS, and not every BLAS is OpenBLAS.
template <class Function>
Function* find(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// Makes OpenBLAS choose again by this name: the two halves of what its constructor and destructor do. Only an
/// OpenBLAS that was built with the kernels of several processors has them.
void choose_again(const std::string& kernels) {
  auto* forget = find<void()>("gotoblas_dynamic_quit");
  auto* choose = find<void()>("gotoblas_dynamic_init");
  if (forget == nullptr || choose == nullptr) return;
  setenv(setting, kernels.c_str(), 1);
  forget();
  choose();
  unsetenv(setting);
}

std::string warning_of(const std::string& kernels, bool given) {
  if (kernels != generic) return {};
  return "OpenBLAS works with its generic kernels (" + kernels + "), which take twice as long or more: " +
         (given ? std::string(setting) + " asks for them" : "this OpenBLAS has no better ones for this processor");
}

}  // namespace

Vectors vectors_of_processor() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx")) return Vectors::none;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return Vectors::avx;
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512cd");
  return avx512 ? Vectors::avx512 : Vectors::avx2;
#else
  return Vectors::none;
#endif
}

std::string better_kernels(const std::string& taken, Vectors processor) {
  static const std::map<std::string, Vectors> needs = {
      {"Prescott", Vectors::none},  {"Core2", Vectors::none},      {"Nehalem", Vectors::none},
      {"Barcelona", Vectors::none}, {"Sandybridge", Vectors::avx}, {"Bulldozer", Vectors::avx},
      {"Piledriver", Vectors::avx}, {"Steamroller", Vectors::avx}, {"Haswell", Vectors::avx2},
      {"Excavator", Vectors::avx2}, {"Zen", Vectors::avx2}};
  constexpr std::array offered = {"", "Sandybridge", "Haswell", "SkylakeX"};
  const auto known = needs.find(taken);
  if (known == needs.end() || known->second >= processor) return {};
  return offered[static_cast<std::size_t>(processor)];
}

BlasKernels choose_blas_kernels() {
  auto* name = find<char*()>("openblas_get_corename");
  auto* config = find<char*()>("openblas_get_config");
  if (name == nullptr || config == nullptr) return {};
  const bool given = std::getenv(setting) != nullptr;
  const std::string taken = name(), better = given ? "" : better_kernels(taken, vectors_of_processor());
  if (!better.empty()) choose_again(better);
  const std::string kernels = name();
  const std::string reason = kernels != taken ? ", by what the processor can do, in place of " + taken
                             : given          ? ", by " + std::string(setting)
                                              : ", as it chose itself";
  return {config() + (", kernels " + kernels) + reason, warning_of(kernels, given)};
}

std::size_t blas_working_space() {
  return find<char*()>("openblas_get_config") == nullptr ? 0 : blas_space;
}

void reserve_blas_space() {
  using Solve = void(const char*, const char*, const char*, const char*, const int*, const int*, const double*,
                     const double*, const int*, double*, const int*);
  auto* solve = find<Solve>("dtrsm_");
  if (solve == nullptr || blas_working_space() == 0) return;
  const int size = 2;
  const double one = 1;
  const std::array<double, 4> unit = {1, 0, 0, 1};
  std::array<double, 4> right = unit;
  solve("L", "U", "N", "N", &size, &size, &one, unit.data(), &size, right.data(), &size);
}

}  // namespace tiprub
