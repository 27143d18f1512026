// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/memory_need.h"

#include <cblas.h>
#include <cholmod.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
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
constexpr int columns_on_their_way = 24 * 5;  // complex vectors a thread: a block of right sides, as it is reordered
constexpr double cubic_cell_bytes = 95 * bytes_per_kib;  // see MeshErrorEstimate
constexpr double program_bytes = 0.3 * bytes_per_gib;    // with its libraries, before it has read anything

/// Lower triangle of the graph of free nodes in the factor's order: column starts and rows.
struct Graph {
  std::vector<std::int64_t> starts = {0};
  std::vector<std::int64_t> rows;
};

Graph node_graph(const SectorMesh& mesh, const SectorDofs& dofs) {
  const std::vector<std::vector<int>> neighbours = node_neighbours(mesh);
  std::vector<int> node_at(dofs.sector() / 3);
  for (int node = 0; node < mesh.node_count(); ++node)
    if (dofs.first[node] >= 0) node_at[dofs.first[node] / 3] = node;
  Graph graph;
  for (std::size_t column = 0; column < node_at.size(); ++column) {
    const auto first = static_cast<std::ptrdiff_t>(graph.rows.size());
    for (const int other : neighbours[node_at[column]])
      if (dofs.first[other] >= static_cast<int>(3 * column)) graph.rows.push_back(dofs.first[other] / 3);
    std::sort(graph.rows.begin() + first, graph.rows.end());
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

MemoryNeed memory_need(const SectorMesh& mesh, const SectorDofs& dofs, const Holdings& held) {
  Graph graph = node_graph(mesh, dofs);
  const int highest_diameter = mesh.sector_count / 2;
  const double diameters = highest_diameter + 1, at_once = std::min<double>(held.threads, diameters);
  const double interface = dofs.interface(), kept = dofs.face + dofs.boundary(), independent = dofs.independent();
  MemoryNeed need;
  need.threads = mapped_by_threads(held.threads);
  // Each thread makes one more than those that are held.
  const double sparse_matrices = other_matrices + held.stiffnesses + at_once;
  need.matrices = program_bytes + held.cubic_cells * cubic_cell_bytes +
                  sparse_matrices * entry_bytes * block_entries * static_cast<double>(graph.rows.size());
  need.bases = complex_bytes * independent * (held.columns + columns_on_their_way) * at_once;
  need.factor = held.factors *
                (real_bytes * (block_entries * factor_entries(graph) + interface_matrices * interface * interface) +
                 complex_bytes * kept * kept * at_once);
  return need;
}

void require_memory(const MemoryNeed& need, double available, double mappable) {
  const bool fits = need.total() <= available;
  if (fits && need.total() + need.threads <= mappable) return;
  const std::string parts =
      "factor " + gib(need.factor) + ", bases " + gib(need.bases) + ", matrices " + gib(need.matrices);
  throw RunError("not enough memory: about " +
                 (fits ? gib(need.total() + need.threads) + " are needed (" + parts + ", threads " +
                             gib(need.threads) + "), " + gib(mappable) + " are available under ulimit"
                       : gib(need.total()) + " are needed (" + parts + "), " + gib(available) + " are available") +
                 "; coarsen the mesh, ask for fewer fixed_interface_modes or threads, or take a larger machine");
}

void start_threads(const MemoryNeed& need, int threads) {
  require_memory(need, available_memory(), mappable_memory());
  openblas_set_num_threads(threads);
}

}  // namespace tiprub::reduce
