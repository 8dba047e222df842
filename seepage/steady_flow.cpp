#include "seepage/steady_flow.hpp"

#include "seepage/elements.hpp"

#include <Eigen/Sparse>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace tremolo::seepage {

namespace {

constexpr int most_iterations = 200;
constexpr double under_relaxation = 0.5;
constexpr double tolerance = 1e-6;

using Matrix = Eigen::SparseMatrix<double>;

void check(const FlowProblem& problem) {
  if (problem.elements.empty())
    throw std::invalid_argument("there is no ground for water to flow through");
  if (!(problem.transition > 0.0))
    throw std::invalid_argument(
        fmt::format("the transition of permeability is {:.6g} m; allowed: > 0", problem.transition));
  for (const Element& element : problem.elements)
    if (!(element.permeability > 0.0))
      throw std::invalid_argument(
          fmt::format("the permeability of an element is {:.6g} m/s; allowed: > 0", element.permeability));
}

/// The range of the given heads, m, or 1 where all are one.
struct HeadRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  double span() const { return high > low ? high - low : 1.0; }
};

/// The iteration and its present state.
class Iteration {
public:
  explicit Iteration(const FlowProblem& problem)
      : problem_(problem), used_(problem.nodes.size(), 0), open_(problem.nodes.size(), 0),
        heads_(problem.nodes.size(), 0.0) {
    for (const Element& element : problem.elements)
      for (std::size_t i = 0; i < element.corners; ++i)
        used_[element.nodes[i]] = 1;
    for (std::size_t n = 0; n < heads_.size(); ++n)
      if (used_[n] != 0 && problem.conditions[n] == Condition::head) {
        range_.low = std::min(range_.low, problem.given[n]);
        range_.high = std::max(range_.high, problem.given[n]);
      }
    if (!(range_.high >= range_.low))
      throw std::invalid_argument("no head is given at any node of the ground");
    for (std::size_t n = 0; n < heads_.size(); ++n) {
      open_[n] = problem.conditions[n] == Condition::exit && problem.nodes[n].y < range_.high;
      if (used_[n] != 0)
        heads_[n] = problem.conditions[n] == Condition::head ? problem.given[n] : range_.high;
    }
    for (const Element& element : problem.elements) {
      full_.push_back(full_conductance(problem, element));
      no_flow_ = std::max(no_flow_, 1e-6 * element.permeability *
                                        std::max(std::abs(range_.low), std::abs(range_.high)));
    }
    find_conductances();
  }

  /// One iteration; returns whether it was the last.
  bool step() {
    const std::vector<double> solved = solve_linear();
    double change = 0.0;
    for (std::size_t n = 0; n < heads_.size(); ++n)
      change = std::max(change, std::abs(solved[n] - heads_[n]));
    const bool settled = change < tolerance * range_.span();
    for (std::size_t n = 0; n < heads_.size(); ++n)
      heads_[n] = settled || is_given(n) ? solved[n] : heads_[n] + under_relaxation * (solved[n] - heads_[n]);
    const bool switched = switch_exits(solved);
    find_conductances();
    find_flow();
    return !switched && settled && lost_ <= tolerance * (entering_ + no_flow_);
  }

  SteadyFlow result(int iterations) const {
    SteadyFlow flow;
    flow.heads = heads_;
    flow.inflow = inflow_;
    flow.discharge = entering_;
    flow.iterations = iterations;
    for (std::size_t n = 0; n < heads_.size(); ++n)
      if (open_[n] != 0 && inflow_[n] < 0.0)
        flow.exits.push_back(n);
    return flow;
  }

private:
  bool is_given(std::size_t n) const { return problem_.conditions[n] == Condition::head || open_[n] != 0; }
  double given(std::size_t n) const { return open_[n] != 0 ? problem_.nodes[n].y : problem_.given[n]; }

  void find_conductances() {
    conductances_.clear();
    for (std::size_t e = 0; e < full_.size(); ++e)
      conductances_.push_back(conductance(problem_, problem_.elements[e], full_[e], heads_));
  }

  /// The heads under the permeability of the present ones.
  std::vector<double> solve_linear() {
    std::vector<Eigen::Index> row(heads_.size(), -1);
    Eigen::Index unknowns = 0;
    std::vector<double> solved(heads_.size(), 0.0);
    for (std::size_t n = 0; n < heads_.size(); ++n)
      if (is_given(n))
        solved[n] = given(n);
      else if (used_[n] != 0)
        row[n] = unknowns++;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    for (std::size_t e = 0; e < conductances_.size(); ++e) {
      const Element& element = problem_.elements[e];
      const Eigen::Matrix4d& k = conductances_[e];
      for (std::size_t a = 0; a < element.corners; ++a) {
        const Eigen::Index i = row[element.nodes[a]];
        if (i < 0)
          continue;
        for (std::size_t b = 0; b < element.corners; ++b) {
          const double value = k(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
          if (const Eigen::Index j = row[element.nodes[b]]; j >= 0)
            entries.emplace_back(i, j, value);
          else
            right[i] -= value * solved[element.nodes[b]];
        }
      }
    }
    Matrix matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Matrix> factors(matrix);
    const Eigen::VectorXd found = factors.solve(right);
    if (factors.info() != Eigen::Success || !found.allFinite())
      throw NoSteadyFlow("the heads of the ground cannot be found: a part of it touches no given head");
    for (std::size_t n = 0; n < heads_.size(); ++n)
      if (row[n] >= 0)
        solved[n] = found[row[n]];
    return solved;
  }

  /// Water that enters at nodes under the heads, by the permeability of the present ones.
  std::vector<double> entering(const std::vector<double>& heads) const {
    std::vector<double> flow(heads.size(), 0.0);
    for (std::size_t e = 0; e < conductances_.size(); ++e) {
      const Element& element = problem_.elements[e];
      const Eigen::Matrix4d& k = conductances_[e];
      for (std::size_t a = 0; a < element.corners; ++a)
        for (std::size_t b = 0; b < element.corners; ++b)
          flow[element.nodes[a]] +=
              k(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) * heads[element.nodes[b]];
    }
    return flow;
  }

  /// Seals what would draw water in, opens what stands under pressure.
  bool switch_exits(const std::vector<double>& solved) {
    const std::vector<double> flow = entering(solved);
    bool switched = false;
    for (std::size_t n = 0; n < heads_.size(); ++n) {
      if (used_[n] == 0 || problem_.conditions[n] != Condition::exit)
        continue;
      const bool opens = open_[n] != 0 ? flow[n] <= 0.0 : solved[n] > problem_.nodes[n].y;
      switched |= opens != (open_[n] != 0);
      open_[n] = opens;
    }
    return switched;
  }

  void find_flow() {
    inflow_ = entering(heads_);
    entering_ = 0.0;
    lost_ = 0.0;
    for (std::size_t n = 0; n < heads_.size(); ++n)
      if (is_given(n))
        entering_ += std::max(inflow_[n], 0.0);
      else
        lost_ += inflow_[n];
    lost_ = std::abs(lost_);
  }

  const FlowProblem& problem_;
  std::vector<unsigned char> used_, open_;
  std::vector<double> heads_, inflow_;
  std::vector<Eigen::Matrix4d> full_,
      conductances_; ///< by element: with k_r = 1, and under the present heads
  HeadRange range_;
  double entering_ = 0.0, lost_ = 0.0; // m2/s
  double no_flow_ = 0.0;               ///< what rounding makes of water at rest, m2/s
};

} // namespace

SteadyFlow solve(const FlowProblem& problem) {
  check(problem);
  Iteration iteration(problem);
  for (int n = 1; n <= most_iterations; ++n)
    if (iteration.step())
      return iteration.result(n);
  throw NoSteadyFlow(fmt::format("no steady flow is found after {} iterations: the nodes that water leaves "
                                 "at, or its surface, go on changing",
                                 most_iterations));
}

std::optional<Vector> exit_point(const FlowProblem& problem, const SteadyFlow& flow) {
  if (flow.exits.empty())
    return std::nullopt;
  std::vector<std::size_t> exits = flow.exits;
  std::ranges::sort(exits, std::greater{}, [&](std::size_t n) { return problem.nodes[n].y; });
  const Vector top = problem.nodes[exits[0]];
  if (exits.size() == 1)
    return top;
  const Vector next = problem.nodes[exits[1]];
  const double share = std::min(flow.inflow[exits[0]] / flow.inflow[exits[1]], 1.0);
  return Vector{top.x + (share - 0.5) * (top.x - next.x), top.y + (share - 0.5) * (top.y - next.y)};
}

} // namespace tremolo::seepage
