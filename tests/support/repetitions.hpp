#pragma once

namespace tremolo::test_support {

/// How often a random test repeats itself: in instrumented programs, which take ten times as long, a fifth as often as
/// elsewhere, for what a sanitizer looks for shows as soon as a branch is taken.
template <class Count>
constexpr Count repetitions(Count elsewhere) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return elsewhere / 5;
#else
  return elsewhere;
#endif
}

} // namespace tremolo::test_support
