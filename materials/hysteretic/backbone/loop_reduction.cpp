#include "materials/hysteretic/backbone/loop_reduction.hpp"

#include "materials/law/parameter_check.hpp"

namespace tremolo::materials {

void validate(const LoopReduction& loops) {
  check_range("p1 of the reduction of loops", loops.at_small_strain, 0.0, 1.0);
  check_range("p2 of the reduction of loops", loops.loss, 0.0, loops.at_small_strain);
  check_range("p3 of the reduction of loops", loops.exponent, 0.1, 10.0);
}

void append_loop_parameters(const LoopReduction& loops, std::vector<ParameterValue>& values) {
  if (!loops.any())
    return;
  values.push_back({"p1", loops.at_small_strain, "1", "F at small strain, of the damping of loops", "given"});
  values.push_back({"p2", loops.loss, "1", "of F, its loss at large strain", "given"});
  values.push_back({"p3", loops.exponent, "1", "of F, exponent", "given"});
}

} // namespace tremolo::materials
