#include "materials/law.hpp"

#include <array>

namespace tremolo::materials {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>; // clang 14 does not deduce it by itself

constexpr std::array mohr_coulomb_state = {StateVariable{
    "equivalent_plastic_strain", "1", "int sqrt(2/3 de:de) of the deviatoric plastic strain", 0.0}};

} // namespace

std::string_view name(const Law& law) {
  return std::visit(Overloaded{[](const LinearElastic&) { return std::string_view("linear_elastic"); },
                               [](const MohrCoulomb&) { return std::string_view("mohr_coulomb"); }},
                    law);
}

std::span<const StateVariable> state_variables(const Law& law) {
  using Variables = std::span<const StateVariable>;
  return std::visit(Overloaded{[](const LinearElastic&) { return Variables(); },
                               [](const MohrCoulomb&) { return Variables(mohr_coulomb_state); }},
                    law);
}

void update(const Law& law, const Points& points) {
  std::visit([&](const auto& one) { update(one, points); }, law);
}

const Elasticity& elasticity(const Law& law) {
  return std::visit([](const auto& one) -> const Elasticity& { return one.elastic; }, law);
}

Law without_softening(const Law& law) {
  return std::visit(Overloaded{[](const LinearElastic& one) -> Law { return one; },
                               [](const MohrCoulomb& one) -> Law { return without_softening(one); }},
                    law);
}

void validate(const Law& law) {
  std::visit([](const auto& one) { validate(one); }, law);
}

} // namespace tremolo::materials
