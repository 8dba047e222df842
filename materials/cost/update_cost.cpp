#include "materials/cost/update_cost.hpp"

namespace tremolo::materials {

namespace {

struct Cost {
  double operator()(const LinearElastic&) const { return 5.0; }
  double operator()(const MohrCoulomb&) const { return 30.0; }
  double operator()(const DruckerPrager&) const { return 25.0; }
  double operator()(const MasingShear&) const { return 45.0; }
  double operator()(const IwanShear&) const { return 210.0; }
  double operator()(const MultiYieldClay&) const { return 210.0; }
  double operator()(const Pm4Sand&) const { return 450.0; }
  double operator()(const Pdmy03&) const { return 150.0; }
};

} // namespace

double update_cost_ns(const Law& law) {
  return std::visit(Cost(), static_cast<const Laws&>(law));
}

} // namespace tremolo::materials
