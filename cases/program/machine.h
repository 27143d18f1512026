// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace tiprub {

/// The memory [bytes] that this process may still map under its resource limits (ulimit -d, -v); infinite without
/// any.
double mappable_memory();

/// The available memory [bytes]: MemAvailable of /proc/meminfo, or less if a control group (version 1 or 2) or a
/// resource limit leaves less. It is infinite if nothing is known. `root` is the folder that holds proc and sys.
double available_memory(const std::filesystem::path& root = "/");

/// Raises RunError if the limits leave no room for the buffers of the libraries. Without this check OpenBLAS would
/// ask for its buffer again and again without end, and HDF5 would go on without its own.
void require_room_for_libraries();

/// Makes malloc return large blocks to the system when they are freed, with the thresholds that glibc comes to of
/// itself. SuperLU_DIST, which comes with deal.II, forbids that as it is loaded (M_MMAP_MAX = 0, M_TRIM_THRESHOLD =
/// -1): the process then keeps all memory that it ever had, in pieces.
void return_freed_memory();

/// Runs `work` on this thread and, at the same time, on `threads` - 1 others, and waits for all. There are fewer if
/// the system gives no more, so results must not depend on their number. Raises what one of them raised, once all
/// have ended.
void work_together(int threads, const std::function<void()>& work);

/// The first step in the main of a program that uses OpenBLAS. OpenBLAS reads its environment variables when it is
/// loaded, before main. If they should be different, this sets them and runs the program again, which takes 0.2 s.
/// OPENBLAS_CORETYPE: OpenBLAS 0.3.21 does not know some Intel processors (family 6, models 183 and 207 among them),
/// and may use generic kernels there, which are half as fast as others that the processor can run.
/// OPENBLAS_NUM_THREADS: OpenBLAS starts an idle thread for each processor. If memory is limited, they would take all
/// of it. The program asks for its threads later, when it knows how many there is memory for.
/// Variables that the user has set stay as they are.
void prepare_blas(char** argv);

/// OpenBLAS's description of itself, with the name of its kernels; empty if the program has no OpenBLAS.
std::string blas_description();
/// A warning if OpenBLAS uses its generic kernels; otherwise empty.
std::string blas_warning();

}  // namespace tiprub
