// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/memory_need.h"

#include <cblas.h>
#include <cholmod.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include "cases/program/errors.h"
#include "cases/program/machine.h"

namespace tiprub::reduce {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double bytes_per_kib = 1024, bytes_per_gib = 1024.0 * 1024 * 1024;
constexpr double real_bytes = sizeof(double), complex_bytes = 2 * sizeof(double);
constexpr double entry_bytes = sizeof(double) + sizeof(int);  // of a sparse matrix
constexpr double block_entries = 9;                           // of a pair of nodes
constexpr int other_matrices = 3;                             // sparse: M, the pattern, the copy that is factorized
constexpr int interface_matrices = 1;                         // of real numbers: S
constexpr int columns_on_their_way = 16 * 5;  // complex vectors a thread: a block of right sides, as it is reordered
// Of MUMPS, over L by CHOLMOD: with its workspace; its fronts, without L; its buffers.
constexpr double mumps_factor = 1.5, mumps_fronts = 0.4, mumps_buffers = 0.1;
// The front of S in MUMPS, and its copy, which is mapped from a file where the factors are on disk.
constexpr double mumps_interfaces = 2, mumps_interfaces_mapped = 1;
constexpr double program_bytes = 0.3 * bytes_per_gib;  // with its libraries, before it has read anything

/// Lower triangle of the graph of free nodes in the factor's order: column starts and rows.
struct Graph {
  std::vector<std::int64_t> starts = {0};
  std::vector<std::int64_t> rows;
};

Graph node_graph(const SectorMesh& mesh, const SectorDofs& dofs) {
  Graph graph;
  for (const std::vector<int>& rows : lower_neighbours(mesh, dofs)) {
    graph.rows.insert(graph.rows.end(), rows.begin(), rows.end());
    graph.starts.push_back(static_cast<std::int64_t>(graph.rows.size()));
  }
  return graph;
}

/// Entries of the supernodal factor of a graph in its given order.
double factor_entries(Graph& graph) {
  cholmod_common common{};
  cholmod_l_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.print = 0;
  cholmod_sparse view{};
  view.nrow = view.ncol = graph.starts.size() - 1;
  view.nzmax = graph.rows.size();
  view.p = graph.starts.data();
  view.i = graph.rows.data();
  view.stype = -1;  // lower triangle
  view.itype = CHOLMOD_LONG;
  view.xtype = CHOLMOD_PATTERN;
  view.sorted = view.packed = 1;
  cholmod_factor* factor = cholmod_l_analyze(&view, &common);
  const double entries = factor == nullptr ? unlimited : std::max(common.lnz, static_cast<double>(factor->xsize));
  cholmod_l_free_factor(&factor, &common);
  cholmod_l_finish(&common);
  return entries;
}

/// The BLAS has a buffer for each of its threads and for each of ours that calls it; malloc has an arena for each.
double mapped_by_threads(int threads) {
  constexpr double blas_buffer = 128, stack_and_arena = 8 + 64;  // [MiB]
  return bytes_per_kib * bytes_per_kib *
         (threads * blas_buffer + (threads - 1) * (blas_buffer + 2 * stack_and_arena));
}

std::string gib(double bytes) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f GiB", bytes / bytes_per_gib);
  return text;
}

}  // namespace

double MemoryNeed::factor_by(FactorMethod method) const {
  if (method == FactorMethod::cholmod || factors == 0) return factor;
  const double factorizing = mumps_fronts * sparse_factor + mumps_interfaces_mapped * interface;
  if (method == FactorMethod::mumps_on_disk)  // both factors are made before there are bases
    return std::max(factorizing - bases,
                    factor - factors * (sparse_factor + interface) + mumps_buffers * sparse_factor);
  return factor + factors * ((mumps_factor - 1) * sparse_factor + mumps_interfaces * interface);
}

double MemoryNeed::on_disk(FactorMethod method) const {
  return method == FactorMethod::mumps_on_disk ? factors * (sparse_factor + interface) : 0;
}

MemoryNeed memory_need(const SectorMesh& mesh, const SectorDofs& dofs, const Holdings& held) {
  Graph graph = node_graph(mesh, dofs);
  const int highest_diameter = mesh.sector_count / 2;
  const double diameters = highest_diameter + 1, at_once = std::min<double>(held.threads, diameters);
  const double interface = dofs.interface(), kept = dofs.face + dofs.boundary(), independent = dofs.independent();
  MemoryNeed need;
  need.threads = mapped_by_threads(held.threads);
  const double sparse_matrices = other_matrices + held.stiffnesses;
  need.matrices = program_bytes + held.mesh_error +
                  sparse_matrices * entry_bytes * block_entries * static_cast<double>(graph.rows.size());
  need.bases = complex_bytes * independent * (held.columns + columns_on_their_way) * at_once;
  need.factors = held.factors;
  need.sparse_factor = real_bytes * block_entries * factor_entries(graph);
  need.interface = real_bytes * interface * interface;
  need.factor = held.factors *
                (need.sparse_factor + interface_matrices * need.interface + complex_bytes * kept * kept * at_once);
  return need;
}

namespace {

bool fits(const MemoryNeed& need, FactorMethod method, double available, double mappable) {
  return need.total(method) <= available && need.total(method) + need.threads <= mappable;
}

/// Raises RunError if the disk is too small for the factors.
void require_disk(double bytes, const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path place = folder.empty() ? "." : folder;
  const double room = static_cast<double>(std::filesystem::space(place, error).available);
  if (error || bytes <= room) return;
  throw RunError("not enough memory for the factors, nor room on the disk of " + place.string() + ": about " +
                 gib(bytes) + " are needed there, " + gib(room) +
                 " are available; write model.h5 to another disk, coarsen the mesh, or take a larger machine");
}

}  // namespace

void require_memory(const MemoryNeed& need, FactorMethod method, double available, double mappable) {
  if (fits(need, method, available, mappable)) return;
  const double total = need.total(method);
  const std::string parts = std::string("factor ") + gib(need.factor_by(method)) +
                            (method == FactorMethod::mumps_on_disk ? " beside that on disk" : "") + ", bases " +
                            gib(need.bases) + ", matrices " + gib(need.matrices);
  const double on_disk = need.total(FactorMethod::mumps_on_disk);
  const bool disk_helps = method == FactorMethod::cholmod && on_disk < total;
  throw RunError(
      "not enough memory: about " +
      (total <= available ? gib(total + need.threads) + " are needed (" + parts + ", threads " + gib(need.threads) +
                                "), " + gib(mappable) + " are available under ulimit"
                          : gib(total) + " are needed (" + parts + "), " + gib(available) + " are available") +
      "; coarsen the mesh, ask for fewer fixed_interface_modes or threads, or take a larger machine" +
      (disk_helps ? "; factorization = \"mumps\" would need " + gib(on_disk) + ", with factors on disk" : ""));
}

FactorMethod choose_method(const MemoryNeed& need, Factorization wanted, double available, double mappable) {
  const FactorMethod in_memory = wanted == Factorization::mumps ? FactorMethod::mumps : FactorMethod::cholmod;
  if (wanted == Factorization::cholmod || need.factors == 0) return in_memory;
  const bool disk_helps = need.total(FactorMethod::mumps_on_disk) < need.total(in_memory);
  return !disk_helps || fits(need, in_memory, available, mappable) ? in_memory : FactorMethod::mumps_on_disk;
}

FactorMethod choose_method(const MemoryNeed& need, const ReductionParameters& parameters, int processes) {
  const double available = available_memory() / processes;
  const FactorMethod method = choose_method(need, parameters.factorization, available, mappable_memory());
  require_memory(need, method, available, mappable_memory());
  require_disk(processes * need.on_disk(method), parameters.scratch_folder);
  return method;
}

void start_threads(const MemoryNeed& need, FactorMethod method, int threads) {
  require_memory(need, method, available_memory(), mappable_memory());
  openblas_set_num_threads(threads);
}

}  // namespace tiprub::reduce
