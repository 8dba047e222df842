#include "toy_process.hpp"

int main(int argc, char** argv) {
  return tremolo::coupler::toy_process({argv, argv + argc}, {});
}
