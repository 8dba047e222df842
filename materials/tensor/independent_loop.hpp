#pragma once

/// Before a loop over points whose arrays do not overlap: GCC counts the pairs of arrays that might, and does
/// not vectorise a loop with more than a few, with or without __restrict.
#if defined(__GNUC__) && !defined(__clang__)
#define TREMOLO_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#else
#define TREMOLO_INDEPENDENT_LOOP
#endif
