#include "wavefield/process/wave_process.hpp"

int main(int argc, char** argv) {
  return tremolo::wavefield::wave_process({argv, argv + argc}, {});
}
