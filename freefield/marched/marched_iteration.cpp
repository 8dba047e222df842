// A step is the increments X of stress that the laws make of the strain which X brings about, X =
// law(eps(X)), eps linear in X. Elastic soil, X = C eps(X), needs one solution of J X = C eps(0). Other soil
// falls short of it by Z = C eps - X, which changes little from step to step:
//
//     J X = C eps(0) - Z,    Z = 2 Z_n - Z_{n-1}.
//
// From there Newton's method with the elastic tangent J takes the residual r = law(eps(X)) - X away, X +=
// J^-1 r. As soon as r is tolerated one more correction follows, and no law is called for it: its strain is
// owed (MarchedTrial::settle), so that r leaves an error of second order, which later steps do not add to.
// Where a law has corners J misleads the iteration: from the sixth correction on a correction is halved while
// it makes things worse.

#include "freefield/marched/marched_iteration.hpp"

#include <algorithm>

namespace tremolo::freefield {

MarchedIteration::MarchedIteration(std::size_t elements, double tolerance, double rounding)
    : tolerance_(tolerance), rounding_(rounding),
      increment_(Increments::Zero(static_cast<Eigen::Index>(elements), 4)), residual_(increment_),
      correction_(increment_), uncorrected_(increment_), shortfall_(increment_),
      shortfall_before_(increment_) {}

void MarchedIteration::converge(MarchedTrial& trial, const MarchedScheme& scheme, const MarchedState& state,
                                MarchedTangent& tangent) {
  constexpr int most = 60, plain = 5, halvings = 6;
  guess(trial, scheme, tangent);
  double residual = evaluate(trial, scheme, state);
  for (int i = 0; !tolerated(residual) && i < most; ++i) {
    correction_ = residual_;
    tangent.solve(correction_);
    uncorrected_ = increment_;
    const double before = residual;
    double share = 1.0;
    for (int h = 0;; ++h, share *= 0.5) {
      increment_ = uncorrected_ + share * correction_;
      residual = evaluate(trial, scheme, state);
      if (i < plain || residual < before || h == halvings)
        break;
    }
  }
  if (tolerated(residual)) {
    tangent.solve(residual_);
    increment_ += residual_;
    trial.settle(scheme, state, increment_);
  } else {
    ++unconverged_;
    largest_residual_ = std::max(largest_residual_, residual / largest_increment_);
  }
  shortfall_before_.swap(shortfall_);
  trial.elastic_increment(shortfall_);
  increment_ = trial.change();
  shortfall_ -= increment_;
  largest_increment_ = std::max(largest_increment_, increment_.abs().maxCoeff());
}

void MarchedIteration::guess(MarchedTrial& trial, const MarchedScheme& scheme, MarchedTangent& tangent) {
  increment_.setZero();
  trial.move(scheme, increment_);
  trial.elastic_increment(increment_);
  increment_ -= 2.0 * shortfall_ - shortfall_before_;
  tangent.solve(increment_);
}

/// The largest residual of the increments on trial, Pa.
double MarchedIteration::evaluate(MarchedTrial& trial, const MarchedScheme& scheme,
                                  const MarchedState& state) {
  ++evaluations_;
  trial.evaluate(scheme, state, increment_, residual_);
  return residual_.abs().maxCoeff();
}

bool MarchedIteration::tolerated(double residual) const {
  double size = largest_increment_;
  if (residual > tolerance_ * size + rounding_)
    size = std::max(size, (increment_ + residual_).abs().maxCoeff()); // as made by the laws, not as guessed
  return residual <= tolerance_ * size + rounding_;
}

} // namespace tremolo::freefield
