#include "materials/soiltest/apparatus.hpp"
#include "materials/soiltest/recorder.hpp"
#include "materials/soiltest/size.hpp"
#include "materials/soiltest/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <numbers>

namespace tremolo::soiltest {
namespace {

using materials::Law;
using materials::PointState;
using materials::PointTest;

double cpu_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Increments to cover a strain.
std::size_t increments(double distance, double increment) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(distance) / increment - 1e-9)));
}

double mobilised_angle(const materials::PointStress& stress) {
  const double sum = -(stress.xx + stress.yy);
  const double difference = 2.0 * std::hypot(0.5 * (stress.xx - stress.yy), stress.xy);
  return difference < sum ? std::asin(difference / sum) : difference > 0.0 ? 0.5 * std::numbers::pi : 0.0;
}

/// The recorded part of a loop.
struct LoopSoFar {
  double area = 0.0; ///< int tau d gamma, J/m3
  double most = 0.0; ///< tau, Pa
  double least = 0.0;
  double widest = 0.0; ///< gamma
  double narrowest = 0.0;

  void widen(double tau, double gamma) {
    most = std::max(most, tau);
    least = std::min(least, tau);
    widest = std::max(widest, gamma);
    narrowest = std::min(narrowest, gamma);
  }
};

/// One straight piece of loading in a cyclic test.
struct HalfCycle {
  double begin = 0.0; ///< cycles at its start
  double share = 0.0; ///< of a cycle: 1/4 for the first, 1/2 for the others
  double from = 0.0;  ///< tau (Pa) or strain at its start and end
  double to = 0.0;

  double cycle(double now) const { return begin + share * std::clamp((now - from) / (to - from), 0.0, 1.0); }
};

/// A test while it runs.
class Run {
public:
  Run(const Law& law, const SoilTest& test)
      : test_(test), point_(specimen(law, test)), apparatus_(test, point_),
        recorder_(law, apparatus_, test.every), cyclic_(std::holds_alternative<StressCycles>(test.loading) ||
                                                        std::holds_alternative<StrainCycles>(test.loading)),
        sense_(test.kind == Kind::triaxial_extension || test.kind == Kind::plane_strain_extension ? -1.0
                                                                                                  : 1.0) {
    note(0.0, true);
  }

  Result result() {
    try {
      std::visit([&](const auto& loading) { load(loading); }, test_.loading);
    } catch (const std::exception& refusal) {
      point_.set(last_);
      result_.end = End::refused;
      result_.end_reason = fmt::format("at strain {:g}, tau = {:g} Pa: {}", apparatus_.strain(point_),
                                       apparatus_.shear_stress(point_), refusal.what());
    }
    recorder_.record(result_.increments, result_.cycles, point_, true);
    result_.history = recorder_.take();
    result_.updates = point_.updates();
    result_.largest_missing_stress = point_.largest_missing();
    result_.leaps = point_.leaps();
    return std::move(result_);
  }

private:
  /// Extremes, cycles to them, and a row of the history.
  void note(double cycle, bool keep) {
    const double strain = apparatus_.strain(point_);
    const double before = result_.largest_strain;
    const double tau = std::abs(apparatus_.shear_stress(point_));
    const double ratio = apparatus_.pore_pressure_ratio(point_);
    const double amplitude = most_ - least_;
    most_ = std::max(most_, strain);
    least_ = std::min(least_, strain);
    result_.largest_strain = std::max(before, std::abs(strain));
    result_.peak_shear_stress = std::max(result_.peak_shear_stress, tau);
    result_.mobilised_angle = std::max(result_.mobilised_angle, mobilised_angle(point_.stress()));
    const double highest_ratio = std::max(ratio, result_.largest_pore_pressure_ratio);
    if (cyclic_) {
      CyclesTo& to = result_.cycles_to;
      reach(to.strain_1pc, 0.01, before, result_.largest_strain, cycle);
      reach(to.strain_3pc, 0.03, before, result_.largest_strain, cycle);
      reach(to.strain_5pc, 0.05, before, result_.largest_strain, cycle);
      reach(to.double_amplitude_5pc, 0.05, amplitude, most_ - least_, cycle);
      reach(to.ru_98, 0.98, result_.largest_pore_pressure_ratio, highest_ratio, cycle);
    }
    result_.largest_pore_pressure_ratio = highest_ratio;
    result_.cycles = cycle;
    recorder_.record(result_.increments, cycle, point_, keep);
    last_ = point_.now();
    if (test_.watch)
      test_.watch({result_.increments, most_increments_, cycle, strain});
  }

  /// Notes the cycle, interpolated within the increment, at which a value passes a limit.
  void reach(double& cycles, double limit, double before, double now, double cycle) const {
    if (before < limit && now >= limit)
      cycles = result_.cycles + (cycle - result_.cycles) * (limit - before) / (now - before);
  }

  void advance(double increment) {
    point_.apply(apparatus_.step(increment, point_));
    ++result_.increments;
  }

  void end(End how, std::string why) {
    result_.end = how;
    result_.end_reason = std::move(why);
  }

  void load(const Monotonic& loading) {
    strain_to(sense_ * loading.strain, {});
    end(End::completed, fmt::format("the strain reached {:g}", loading.strain));
  }

  /// Loads in equal increments to a strain.
  void strain_to(double goal, const HalfCycle& half) {
    const double start = apparatus_.strain(point_);
    const std::size_t steps = increments(goal - start, test_.strain_increment);
    for (std::size_t k = 1; k <= steps; ++k) {
      const double tau = apparatus_.shear_stress(point_);
      const double strain = apparatus_.strain(point_);
      const double gamma = apparatus_.shear_strain(point_);
      const double part = static_cast<double>(k) / static_cast<double>(steps);
      const double next = k == steps ? goal : start + (goal - start) * part;
      advance(next - strain);
      const double next_tau = apparatus_.shear_stress(point_);
      const double next_gamma = apparatus_.shear_strain(point_);
      loop_.area += 0.5 * (tau + next_tau) * (next_gamma - gamma);
      loop_.widen(next_tau, next_gamma);
      note(half.share > 0.0 ? half.cycle(next) : 0.0, k == steps);
    }
  }

  void load(const StrainCycles& loading) {
    HalfCycle half;
    const auto go = [&](double strain, double share) {
      half.share = share;
      half.from = apparatus_.strain(point_);
      half.to = strain;
      strain_to(strain, half);
      half.begin += share;
    };
    for (const double amplitude : loading.amplitudes) {
      double sign = sense_;
      for (int reversal = 0; reversal <= 2 * loading.cycles; ++reversal, sign = -sign) {
        go(sign * amplitude, reversal == 0 ? 0.25 : 0.5);
        if (reversal % 2 == 0) {
          if (reversal > 0)
            close_loop(amplitude, reversal / 2);
          const double tau = apparatus_.shear_stress(point_);
          const double gamma = apparatus_.shear_strain(point_);
          loop_ = {0.0, tau, tau, gamma, gamma};
        }
      }
      go(0.0, 0.25);
    }
    end(End::completed, "all amplitudes were applied");
  }

  void close_loop(double amplitude, int cycle) {
    const double gamma = 0.5 * (loop_.widest - loop_.narrowest);
    const double modulus = 0.5 * (loop_.most - loop_.least) / gamma;
    const double damping = loop_.area / (2.0 * std::numbers::pi * modulus * gamma * gamma);
    result_.loops.push_back(
        {amplitude, cycle, gamma, modulus, damping, apparatus_.pore_pressure_ratio(point_)});
  }

  void load(const StressCycles& loading) {
    const double level = test_.initial.vertical_stress;
    const double middle = apparatus_.shear_stress(point_);
    double sign = sense_;
    HalfCycle half;
    half.share = 0.25;
    half.from = middle;
    while (true) {
      half.to = middle + sign * loading.stress_ratio * level;
      if (!stress_to(loading, half, sign))
        return;
      half.begin += half.share;
      half.share = 0.5;
      half.from = half.to;
      sign = -sign;
    }
  }

  /// Loads to the end of a half cycle; false if the test ended on the way.
  bool stress_to(const StressCycles& loading, const HalfCycle& half, double sign) {
    bool reversal = false;
    while (!reversal) {
      advance(sign * test_.strain_increment);
      reversal = sign * (apparatus_.shear_stress(point_) - half.to) >= 0.0;
      if (reversal) {
        stop_at_stress(point_, apparatus_, last_, sign * test_.strain_increment, half.to,
                       1e-9 * test_.initial.vertical_stress);
      }
      // Soil that softens falls back from a stress that it had reached: cycles do not run backwards with it.
      note(reversal ? half.begin + half.share
                    : std::max(result_.cycles, half.cycle(apparatus_.shear_stress(point_))),
           reversal);
      if (over(loading))
        return false;
    }
    return true;
  }

  bool over(const StressCycles& loading) {
    if (std::abs(apparatus_.strain(point_)) >= loading.largest_strain)
      end(End::largest_strain, fmt::format("the strain reached {:g}", loading.largest_strain));
    else if (result_.cycles >= loading.most_cycles)
      end(End::most_cycles, fmt::format("{:g} cycles were applied", loading.most_cycles));
    else if (loading.pore_pressure_ratio &&
             apparatus_.pore_pressure_ratio(point_) >= *loading.pore_pressure_ratio)
      end(End::pore_pressure_ratio, fmt::format("r_u reached {:g}", *loading.pore_pressure_ratio));
    else
      return false;
    return true;
  }

  void load(const Path& path) {
    for (std::size_t i = 1; i < path.rows.size(); ++i) {
      const PathRow& a = path.rows[i - 1];
      const PathRow& b = path.rows[i];
      const auto steps = static_cast<std::size_t>(b.step - a.step);
      for (std::size_t k = 1; k <= steps; ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(steps);
        point_.apply(apparatus_.step_to(path, between(a, b, part, path.rows.front()), point_));
        ++result_.increments;
        note(0.0, k == steps);
      }
    }
    end(End::completed, "the path was followed to its end");
  }

  /// A row in between, with strains counted from the first.
  static PathRow between(const PathRow& a, const PathRow& b, double part, const PathRow& first) {
    const auto mix = [&](double from, double to) { return part == 1.0 ? to : from + part * (to - from); };
    PathRow row;
    row.strain = {
        mix(a.strain.xx, b.strain.xx) - first.strain.xx, mix(a.strain.yy, b.strain.yy) - first.strain.yy,
        mix(a.strain.xy, b.strain.xy) - first.strain.xy, mix(a.strain.zz, b.strain.zz) - first.strain.zz};
    row.stress = {mix(a.stress.xx, b.stress.xx), mix(a.stress.yy, b.stress.yy), mix(a.stress.zz, b.stress.zz),
                  mix(a.stress.xy, b.stress.xy)};
    return row;
  }

  const SoilTest& test_;
  PointTest point_;
  Apparatus apparatus_;
  Recorder recorder_;
  double most_increments_ = increments(test_);
  bool cyclic_;     ///< whether cycles are counted
  double sense_;    ///< of the first loading
  PointState last_; ///< after the last complete increment
  double most_ = 0.0;
  double least_ = 0.0;
  LoopSoFar loop_; ///< since the last reversal at which a loop ends
  Result result_;
};

} // namespace

Result run(const Law& law, const SoilTest& test) {
  validate(law, test);
  const double start = cpu_seconds();
  Result result = Run(law, test).result();
  result.cpu_seconds = cpu_seconds() - start;
  return result;
}

} // namespace tremolo::soiltest
