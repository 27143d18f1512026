// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace tiprub {

/// [bytes] that this process may still map under its resource limits (ulimit -d, -v); infinite without any.
double mappable_memory();

/// [bytes] MemAvailable of /proc/meminfo, or less if a control group (versions 1 and 2) or a resource limit leaves
/// less. Infinite if nothing is known. `root` is where /proc and /sys are.
double available_memory(const std::filesystem::path& root = "/");

/// Raises RunError if the limits leave no room for the buffers of the libraries. OpenBLAS asks for ever for a buffer
/// that it is refused, and HDF5 works on without it: it is too late to find out there.
void require_room_for_libraries();

/// Runs `work` at once on this thread and on up to `threads` - 1 others, and waits for all. With fewer others if the
/// system gives no more (limits on memory or processes): results must not hang on how many there are. Raises what
/// one of them raised, once all have ended.
void work_together(int threads, const std::function<void()>& work);

/// The first step of the main of a program that works with OpenBLAS. OpenBLAS reads its variables as it is loaded,
/// before main; where they should be others, this sets them and runs the program again, which takes 0.2 s.
/// - OPENBLAS_CORETYPE: of an Intel processor that it does not know, OpenBLAS 0.3.21 may take the generic kernels of
///   any 64-bit processor (family 6, models 183 and 207 among them), which are half as fast as what it can run.
/// - OPENBLAS_NUM_THREADS: where memory is limited, the idle threads that OpenBLAS starts, one a processor, would
/// take
///   what there is. The program asks for its threads later, once it knows how much they leave.
/// What the user has set is left alone.
void prepare_blas(char** argv);

/// OpenBLAS's own words, with the name of its kernels; empty if the program has no OpenBLAS.
std::string blas_description();
/// Of generic kernels; empty if they are not.
std::string blas_warning();

}  // namespace tiprub
