// Says clearly that the processor is too old, before main and before any newer instruction could stop the
// program with "illegal instruction". This file alone is compiled for the baseline processor.

#include <cstring>
#include <unistd.h>

namespace {

__attribute__((constructor(101))) void check_cpu() {
  if (std::strcmp(TREMOLO_ARCH, "x86-64-v3") != 0)
    return;
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
    return;
  static const char message[] =
      "tremolo: this build needs an x86-64-v3 processor (AVX2, FMA, BMI2; Intel Haswell or "
      "AMD Excavator and later); build from source with -DTREMOLO_NATIVE=ON on this machine\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof(message) - 1);
  _exit(1);
}

} // namespace
