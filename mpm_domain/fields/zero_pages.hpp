#pragma once

// Arrays that begin as zeros, and of which only those pages take memory that somebody has written to: a rank
// has a place for every node of the grid and for every particle's number, and uses those of its own tiles.
// Reading a page that nobody has written finds zeros and takes none.
//
// Kernels that back large arrays with huge pages of 2 MB would take memory for 512 pages at a time; ranks
// switch that off for themselves (process/ranks/small_pages.hpp).

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
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
    void* const memory = is_mapped(bytes) ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                                                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)
                                          : std::calloc(count, sizeof(Number));
    if (memory == nullptr || memory == MAP_FAILED)
      throw std::bad_alloc();
    return static_cast<Number*>(memory);
  }
  void deallocate(Number* memory, std::size_t count) {
    if (is_mapped(count * sizeof(Number)))
      ::munmap(memory, count * sizeof(Number));
    else
      std::free(memory);
  }
  /// New numbers are zero already.
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
