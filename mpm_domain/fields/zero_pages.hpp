#pragma once

// Arrays that begin as zeros, and of which only those pages take memory that somebody has written to: a rank
// has a place for every node of the grid and for every particle's number, and uses those of its own tiles.
// Reading a page that nobody has written finds zeros and takes none.
//
// Kernels that back large arrays with huge pages of 2 MB would take memory for 512 pages at a time; ranks
// switch that off for themselves (process/ranks/small_pages.hpp).

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

template <typename Number>
class ZeroPageAllocator {
public:
  using value_type = Number;

  ZeroPageAllocator() = default;
  template <typename Other>
  ZeroPageAllocator(const ZeroPageAllocator<Other>&) {}

  /// @throws std::bad_alloc
  Number* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(Number);
    if (!is_mapped(bytes)) {
      void* const memory = std::calloc(count, sizeof(Number));
      if (memory == nullptr)
        throw std::bad_alloc();
      return static_cast<Number*>(memory);
    }
    void* const pages = ::mmap(nullptr, bytes + page, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (pages == MAP_FAILED)
      throw std::bad_alloc();
    return reinterpret_cast<Number*>(static_cast<std::byte*>(pages) + offset_in(pages));
  }
  void deallocate(Number* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(Number);
    if (!is_mapped(bytes))
      return std::free(memory);
    const std::size_t within = reinterpret_cast<std::uintptr_t>(memory) % page;
    ::munmap(reinterpret_cast<std::byte*>(memory) - within, bytes + page);
  }
  /// New numbers are zero already; not so in an array that has shrunk and grows again (set_to_zeros()).
  template <typename Other>
  void construct(Other* /*number*/) {}
  template <typename Other, typename Value>
  void construct(Other* number, Value&& value) {
    ::new (static_cast<void*>(number)) Other(std::forward<Value>(value));
  }

  template <typename Other>
  bool operator==(const ZeroPageAllocator<Other>&) const {
    return true;
  }

private:
  static constexpr std::size_t page = 4096;

  /// Arrays begin at different places of their first pages, a multiple of a cache's line from its start:
  /// those that are read side by side would take turns in the same few lines.
  static std::size_t offset_in(const void* pages) {
    constexpr std::size_t line = 64;
    return reinterpret_cast<std::uintptr_t>(pages) / page * 37 % 61 * line;
  }
  static bool is_mapped(std::size_t bytes) {
    constexpr std::size_t least = std::size_t{1} << 18; // a system call costs more than to clear less
    return bytes >= least;
  }
};

/// A vector whose constructor of a size leaves all pages untouched.
template <typename Number>
using ZeroPages = std::vector<Number, ZeroPageAllocator<Number>>;

/// Makes an array all zeros, and gives back the memory that it has used.
template <typename Number>
void set_to_zeros(ZeroPages<Number>& array, std::size_t count) {
  array = ZeroPages<Number>(); // two of them at a time would need twice the memory
  array = ZeroPages<Number>(count);
}

} // namespace tremolo::mpm_domain
