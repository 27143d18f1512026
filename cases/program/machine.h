// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace tiprub {

/// The address space of this process [bytes].
double mapped_memory();

/// The memory [bytes] that this process may still map under its resource limits (ulimit -d, -v); infinite without
/// limits.
double mappable_memory();

/// The available memory [bytes]: MemAvailable of /proc/meminfo, or less if a control group (version 1 or 2) or a
/// resource limit leaves less. It is infinite if nothing is known. `root` is the folder that contains proc and sys.
double available_memory(const std::filesystem::path& root = "/");

/// Raises RunError if the limits leave no room for the buffers of the libraries. Without this check, OpenBLAS would
/// request its buffer for ever, and HDF5 would continue without its own.
void require_room_for_libraries();

/// Makes malloc keep up to 512 MiB of what is freed, so that the system doesn't clear the same pages again and again,
/// and return the rest where it ends the heap. SuperLU_DIST, which deal.II brings, makes malloc keep all when it is
/// loaded (M_TRIM_THRESHOLD = -1).
void return_freed_memory();

/// Makes malloc keep what is freed, up to 32 MiB a block. A program that allocates and frees large arrays without end
/// otherwise spends a fifth of its time in the system, which clears the same pages again and again.
void keep_freed_memory();

/// Runs `work` on this thread and on `threads` - 1 others at the same time, and waits for all. If the system provides
/// fewer threads, fewer run; results must therefore not depend on their number. If any of them raised an exception,
/// one is raised again after all have ended.
void work_together(int threads, const std::function<void()>& work);

/// Divides 0 .. size - 1 into pieces of `at_once` numbers, and calls work(first, count) for each of them from up to
/// `threads` threads; 0: as many as the machine has. Results must not depend on their number. After an exception no
/// further piece is begun.
void work_on_pieces(std::ptrdiff_t size, std::ptrdiff_t at_once, int threads,
                    const std::function<void(std::ptrdiff_t first, std::ptrdiff_t count)>& work);

/// Prepares the environment of OpenBLAS; to be called first in the main of a program that uses it. OpenBLAS reads its
/// environment variables when it is loaded, before main. If they need other values, this function sets them and runs
/// the program again, which takes 0.2 s. Variables that the user has set stay unchanged.
///
/// OPENBLAS_CORETYPE: OpenBLAS 0.3.21 does not know some Intel processors (family 6, models 183 and 207 among them).
/// It may use generic kernels there, which are half as fast as others that the processor can run.
///
/// OPENBLAS_NUM_THREADS: OpenBLAS starts an idle thread for each processor. If memory is limited, these would take
/// all of it. The program starts its threads later, when it knows for how many the memory suffices.
void prepare_blas(char** argv);

/// The description that OpenBLAS gives of itself, with the name of its kernels; empty if the program has no OpenBLAS.
std::string blas_description();
/// A warning if OpenBLAS uses its generic kernels; empty otherwise.
std::string blas_warning();

}  // namespace tiprub
