// Large arrays lie in huge pages, where Linux gives them when asked (transparent_hugepage = madvise, as on
// Debian). A step walks over dozens of arrays side by side: those of ten million particles are half a million
// pages of 4 KiB, whose addresses the processor has to look up in memory again and again, and each of which
// the kernel hands out by a fault of its own. Huge pages are 512 times fewer.
//
// This replaces operator new and delete of the programs it is linked into, which is how all arrays get it.

#include <cstddef>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

/// An array takes whole huge pages, half of one too much in the mean. From this size on that is below an
/// eighth.
constexpr std::size_t least_large = 4 * huge_page;

void* allocate(std::size_t size) {
  if (size < least_large)
    return std::malloc(size > 0 ? size : 1);
  const std::size_t whole = (size + huge_page - 1) / huge_page * huge_page;
  void* const memory = std::aligned_alloc(huge_page, whole);
  if (memory != nullptr)
    ::madvise(memory, whole, MADV_HUGEPAGE); // a kernel without them says no, and gives small ones
  return memory;
}

} // namespace

void* operator new(std::size_t size) {
  for (;;) {
    if (void* const memory = allocate(size))
      return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr)
      throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}
