#pragma once

// A checkpoint in memory: what a domain and its stepper save, by name.

#include "mpm_domain/state.hpp"
#include "mpm_domain/step/stepper.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace tremolo::test_support {

/// Writer and reader of mpm_domain/state.hpp.
class SavedState {
public:
  void write(const std::string& name, const std::vector<double>& values) { add(numbers_, name, values); }
  void write(const std::string& name, const std::vector<std::uint64_t>& values) {
    add(integers_, name, values);
  }
  template <class Give>
  void write_numbers(const std::string& name, std::size_t size, const Give& give) {
    add_pieces(numbers_, name, size, give);
  }
  template <class Give>
  void write_integers(const std::string& name, std::size_t size, const Give& give) {
    add_pieces(integers_, name, size, give);
  }
  const std::vector<double>& numbers(const std::string& name) const { return numbers_.at(name); }
  const std::vector<std::uint64_t>& integers(const std::string& name) const { return integers_.at(name); }
  std::vector<double> numbers(const std::string& name, std::size_t first, std::size_t count) const {
    return part(numbers(name), first, count);
  }
  std::vector<std::uint64_t> integers(const std::string& name, std::size_t first, std::size_t count) const {
    return part(integers(name), first, count);
  }
  std::size_t size(const std::string& name) const {
    return numbers_.contains(name) ? numbers(name).size() : integers(name).size();
  }

  friend void expect_same(const SavedState& one, const SavedState& other) {
    expect_same(one.numbers_, other.numbers_);
    expect_same(one.integers_, other.integers_);
  }

private:
  template <class Number>
  static std::vector<Number> part(const std::vector<Number>& all, std::size_t first, std::size_t count) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
  }

  template <class Number>
  using Arrays = std::map<std::string, std::vector<Number>>;

  template <class Number>
  static void add(Arrays<Number>& arrays, const std::string& name, const std::vector<Number>& values) {
    EXPECT_TRUE(arrays.emplace(name, values).second) << "saved twice: " << name;
  }
  template <class Number, class Give>
  static void add_pieces(Arrays<Number>& arrays, const std::string& name, std::size_t size,
                         const Give& give) {
    std::vector<Number> values;
    give([&](std::span<const Number> piece) { values.insert(values.end(), piece.begin(), piece.end()); });
    EXPECT_EQ(values.size(), size) << name;
    add(arrays, name, values);
  }
  template <class Number>
  static void expect_same(const Arrays<Number>& one, const Arrays<Number>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (const auto& [name, values] : one)
      EXPECT_EQ(values, other.at(name)) << name;
  }

  Arrays<double> numbers_;
  Arrays<std::uint64_t> integers_;
};

/// What a domain and its stepper keep from step to step.
inline SavedState saved_state(const mpm_domain::Domain& domain, const mpm_domain::Stepper& stepper) {
  SavedState saved;
  save(domain, saved);
  stepper.save(saved);
  return saved;
}

/// Gives it to others, built from the same spec.
inline void restore_state(const SavedState& saved, mpm_domain::Domain& domain, mpm_domain::Stepper& stepper) {
  restore(domain, saved);
  stepper.restore(saved);
}

} // namespace tremolo::test_support
