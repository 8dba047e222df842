#include "mpm_domain/fields/zero_pages.hpp"

#include "mpm_domain/particles/places_by_id.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr std::size_t many = std::size_t{1} << 26; // half a gigabyte of doubles

/// Memory of this process, bytes.
std::size_t resident() {
  std::ifstream file("/proc/self/statm");
  std::size_t all = 0;
  std::size_t pages = 0;
  file >> all >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Memory that an act takes, bytes.
template <typename Act>
std::size_t taken_by(const Act& act) {
  const std::size_t before = resident();
  act();
  return std::max(resident(), before) - before;
}

TEST(ZeroPages, TakeMemoryForWhatIsWritten) {
  constexpr std::size_t part = many / 16;
  ZeroPages<double> array;
  EXPECT_LT(taken_by([&] { set_to_zeros(array, many); }), sizeof(double) * part / 4);
  double sum = 0.0;
  for (std::size_t n = 0; n < many; n += 64)
    sum += array[n];
  EXPECT_EQ(sum, 0.0);
  const std::size_t taken = taken_by([&] { std::fill_n(array.begin() + part, part, 1.0); });
  EXPECT_GT(taken, sizeof(double) * part * 9 / 10);
  EXPECT_LT(taken, sizeof(double) * part * 11 / 10);
}

TEST(ZeroPages, AreZerosAgainWhateverWasThere) {
  for (const std::size_t count : {std::size_t{100}, many / 64}) {
    ZeroPages<double> array(count);
    std::ranges::fill(array, 1.0);
    set_to_zeros(array, count);
    EXPECT_EQ(std::ranges::count(array, 0.0), static_cast<std::ptrdiff_t>(count));
  }
}

TEST(PlacesById, TakeMemoryForTheirOwnParticles) {
  PlacesById places;
  EXPECT_LT(taken_by([&] {
              places.give(many);
              for (std::size_t k = 0; k < 1000; ++k)
                places.put(many / 2 + k, k);
            }),
            many / 16);
  EXPECT_EQ(places[0], PlacesById::nowhere);
  EXPECT_EQ(places[many / 2 + 7], 7U);
  places.remove(many / 2 + 7);
  EXPECT_EQ(places[many / 2 + 7], PlacesById::nowhere);
  EXPECT_EQ(places.size(), many);
}

TEST(PlacesById, AreVisitedInTheOrderOfIds) {
  PlacesById places;
  places.give(4);
  places.put(3, 0);
  places.put(1, 2);
  std::vector<std::uint32_t> visited;
  places.for_all([&](std::uint32_t k) { visited.push_back(k); });
  EXPECT_EQ(visited, (std::vector<std::uint32_t>{2, 0}));
  places.clear();
  places.give(2);
  EXPECT_EQ(places[1], PlacesById::nowhere);
}

} // namespace
} // namespace tremolo::mpm_domain
