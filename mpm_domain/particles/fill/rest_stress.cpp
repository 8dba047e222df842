#include "mpm_domain/particles/fill/rest_stress.hpp"

#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Highest and lowest point of an outline at some x; none: it does not reach there.
std::optional<std::pair<double, double>> chord_at(const std::vector<Vector>& outline, double x) {
  std::optional<std::pair<double, double>> chord;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vector& a = outline[j];
    const Vector& b = outline[i];
    if ((a.x > x) == (b.x > x))
      continue;
    const double y = a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
    chord = chord ? std::pair(std::max(chord->first, y), std::min(chord->second, y)) : std::pair(y, y);
  }
  return chord;
}

/// What a particle is in one of its columns.
struct PieceOfColumn {
  double column; ///< number
  double y;      ///< m
  double load;   ///< its weight, and what water pulls at it, over the length of its side, Pa
  double unit;   ///< weight of a volume of it, N/m3
};
constexpr std::size_t piece_numbers = 4;

/// The pieces column after column, each from the top down.
/// @param columns  of the model
std::vector<std::size_t> from_the_top_down(const std::vector<PieceOfColumn>& pieces, std::size_t columns) {
  std::vector<std::size_t> begin(columns + 1, 0);
  for (const PieceOfColumn& piece : pieces)
    ++begin[static_cast<std::size_t>(piece.column) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::size_t> next = begin;
  std::vector<std::size_t> order(pieces.size());
  for (std::size_t n = 0; n < pieces.size(); ++n)
    order[next[static_cast<std::size_t>(pieces[n].column)]++] = n;
  for (std::size_t c = 0; c < columns; ++c)
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin[c]),
                     order.begin() + static_cast<std::ptrdiff_t>(begin[c + 1]),
                     [&](std::size_t a, std::size_t b) { return pieces[a].y > pieces[b].y; });
  return order;
}

/// The stress of the pieces of some columns, in their order, by what lies above each.
/// @param columns      of the model
/// @param cavities_at  (number of a column) the lowest and highest points of cavities there
template <typename CavitiesAt>
std::vector<double> overburdens(const std::vector<PieceOfColumn>& pieces, std::size_t columns,
                                const CavitiesAt& cavities_at) {
  const std::vector<std::size_t> order = from_the_top_down(pieces, columns);
  std::vector<double> stress(pieces.size());
  std::vector<std::pair<double, double>> cavities;
  const PieceOfColumn* above = nullptr;
  double overburden = 0.0;
  for (const std::size_t n : order) {
    const PieceOfColumn& piece = pieces[n];
    if (above == nullptr || above->column != piece.column) {
      above = nullptr;
      overburden = 0.0;
      cavities = cavities_at(piece.column);
    }
    for (const auto& [top, bottom] : cavities)
      if (const double middle = 0.5 * (top + bottom);
          above != nullptr && above->y > middle && piece.y < middle)
        overburden += above->unit * (top - bottom);
    above = &piece;
    stress[n] = overburden + 0.5 * piece.load;
    overburden += piece.load;
  }
  return stress;
}

using Lists = std::vector<std::vector<double>>; ///< by rank

Lists swap(Lists lists, Communicator* ranks) {
  return ranks != nullptr ? ranks->swap(lists) : std::move(lists);
}

} // namespace

void set_rest_stress(std::span<Particles> sets, const Spec& spec,
                     const std::function<bool(std::size_t, std::size_t)>& concerns, Communicator* ranks) {
  const int finest = std::ranges::max_element(sets, {}, &Particles::level)->level;
  const double width = particle_size(spec, finest);
  const auto columns = static_cast<std::size_t>(std::lround((spec.box.x_max - spec.box.x_min) / width));
  const auto rank_count = static_cast<std::size_t>(ranks != nullptr ? ranks->size() : 1);
  /// act(set, particle, one of its columns, the rank that works out the column)
  const auto for_particles = [&](const auto& act) {
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (std::size_t k = 0; k < sets[s].size(); ++k) {
        if (concerns && !concerns(s, k))
          continue;
        const Particles& set = sets[s];
        const auto first =
            static_cast<std::size_t>((set.x[k] - set.half_size + 0.5 * width - spec.box.x_min) / width);
        for (std::size_t c = first; c < first + (std::size_t{1} << (finest - set.level)); ++c)
          act(sets[s], k, c, c * rank_count / columns);
      }
  };

  Lists asked(rank_count);
  for_particles([&](const Particles& set, std::size_t k, std::size_t column, std::size_t rank) {
    const double rising =
        set.traits.seeping ? set.water->unit_weight * set.volume[k] * set.head_slope_y[k] : 0.0;
    const double load = (set.weight_share * set.mass[k] * spec.gravity + rising) / (2.0 * set.half_size);
    const double unit = set.weight_share * set.density * spec.gravity;
    asked[rank].insert(asked[rank].end(), {static_cast<double>(column), set.y[k], load, unit});
  });
  std::vector<PieceOfColumn> pieces;
  std::vector<std::size_t> of_rank;
  for (const std::vector<double>& numbers : swap(std::move(asked), ranks)) {
    for (std::size_t n = 0; n < numbers.size(); n += piece_numbers)
      pieces.push_back({numbers[n], numbers[n + 1], numbers[n + 2], numbers[n + 3]});
    of_rank.push_back(numbers.size() / piece_numbers);
  }
  const std::vector<double> stress = overburdens(pieces, columns, [&](double column) {
    std::vector<std::pair<double, double>> cavities;
    for (const Lining& lining : spec.linings)
      if (const auto chord = chord_at(lining.outline, spec.box.x_min + (column + 0.5) * width))
        cavities.push_back(*chord);
    return cavities;
  });
  Lists answers;
  auto next = stress.begin();
  for (const std::size_t count : of_rank) {
    answers.emplace_back(next, next + static_cast<std::ptrdiff_t>(count));
    next += static_cast<std::ptrdiff_t>(count);
  }
  answers = swap(std::move(answers), ranks);

  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t k = 0; k < sets[s].size(); ++k)
      if (!concerns || concerns(s, k))
        sets[s].syy[k] = 0.0;
  std::vector<std::size_t> taken(rank_count, 0);
  for_particles([&](Particles& set, std::size_t k, std::size_t, std::size_t rank) {
    set.syy[k] -= answers[rank][taken[rank]++] / static_cast<double>(1 << (finest - set.level));
  });
  for (std::size_t s = 0; s < sets.size(); ++s) {
    Particles& set = sets[s];
    const double k0 = materials::elasticity(set.law).rest_coefficient();
    for (std::size_t k = 0; k < set.size(); ++k)
      if (!concerns || concerns(s, k))
        set.sxx[k] = set.szz[k] = k0 * set.syy[k];
  }
}

} // namespace tremolo::mpm_domain
