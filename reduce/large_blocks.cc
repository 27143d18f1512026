// SPDX-License-Identifier: GPL-3.0-or-later
// What this program itself allocates goes through these functions: it is linked with
// -Wl,--wrap=malloc,--wrap=realloc.
//
// The system clears the pages of a large block one by one when they are first touched, and the processor looks up the
// place of each. For vectors of 100,000 dofs in pages of 4 KiB this takes a third of a reduction's time. Many systems
// give pages of 2 MiB only to those who ask.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

// The names are those of the linker's option.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_realloc(void* block, std::size_t size);
void* __wrap_malloc(std::size_t size);
void* __wrap_realloc(void* block, std::size_t size);
}

namespace {

/// Asks for large pages within a block; a system that has none lets it stand as it is.
void* with_large_pages(void* block, std::size_t size) {
  constexpr std::size_t large = std::size_t{4} << 20;
  if (block == nullptr || size < large) return block;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(block) % page) % page;
  madvise(static_cast<char*>(block) + skipped, (size - skipped) / page * page, MADV_HUGEPAGE);
  return block;
}

}  // namespace

void* __wrap_malloc(std::size_t size) {
  return with_large_pages(__real_malloc(size), size);
}

void* __wrap_realloc(void* block, std::size_t size) {
  return with_large_pages(__real_realloc(block, size), size);
}
// NOLINTEND(bugprone-reserved-identifier)

void* operator new(std::size_t size) {
  if (void* block = std::malloc(std::max<std::size_t>(size, 1))) return block;
  throw std::bad_alloc();
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t /*size*/) noexcept {
  std::free(block);
}
