// Preloaded: in rank TREMOLO_FAILING_RANK the call number TREMOLO_FAILING_CALL of MPI_Testall, by which ranks
// wait for messages, throws what an error in a step would throw.

#include <cstdlib>
#include <dlfcn.h>
#include <stdexcept>
#include <string>

namespace {

long number(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? -1 : std::atol(text);
}

} // namespace

extern "C" int MPI_Testall(int count, void* requests, int* done, void* statuses) {
  using Function = int (*)(int, void*, int*, void*);
  static const auto original = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "MPI_Testall"));
  static const bool fails = number("OMPI_COMM_WORLD_RANK") == number("TREMOLO_FAILING_RANK");
  static long left = number("TREMOLO_FAILING_CALL");
  if (fails && --left == 0)
    throw std::runtime_error("this step fails on purpose");
  return original(count, requests, done, statuses);
}
