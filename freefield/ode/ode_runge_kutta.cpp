// Kinnmark and Gray (1984), Math. Comput. Simul. 26(3), 181-188, in the form of third order also for
// nonlinear equations (Guerra and Ullrich 2016, Geosci. Model Dev. 9, 2007-2029):
//
//     c = 0, 1/5, 1/5, 1/3, 2/3, each stage from the one before it alone,   b = (1/4, 0, 0, 0, 3/4).
//
// For y' = i w y the amplification is 1 + z + z^2/2 + z^3/6 + z^4/30 + z^5/150, z = i w dt: at most 1 in
// magnitude for w dt <= sqrt(15). The sixth stage is the derivative at the end, the first of the next step.
//
// Error estimate: a third difference of the stages at c = 0, 1/3, 2/3, 1, times `scale`. It is of third
// order, hence embeds a method of second; for the oscillation it is scale z^3/30, the error itself z^4/120.

#include "freefield/ode/ode_runge_kutta.hpp"

#include <array>
#include <new>

namespace tremolo::freefield {

ButcherTable wide_runge_kutta() {
  constexpr int stages = 6;
  constexpr double scale = 0.1;
  using Row = std::array<realtype, stages>;
  Row c = {0.0, 1.0 / 5.0, 1.0 / 5.0, 1.0 / 3.0, 2.0 / 3.0, 1.0};
  Row b = {0.25, 0.0, 0.0, 0.0, 0.75, 0.0};
  constexpr Row difference = {1.0, 0.0, 0.0, -3.0, 3.0, -1.0};
  std::array<Row, stages> a{};
  for (std::size_t stage = 1; stage < stages - 1; ++stage)
    a[stage][stage - 1] = c[stage];
  a.back() = b;
  Row embedded = b;
  for (std::size_t stage = 0; stage < stages; ++stage)
    embedded[stage] += scale * difference[stage];
  ButcherTable table(
      ARKodeButcherTable_Create(stages, 3, 2, c.data(), a[0].data(), b.data(), embedded.data()));
  if (!table)
    throw std::bad_alloc();
  return table;
}

} // namespace tremolo::freefield
