#include "coupler/process/recording_process.hpp"

int main(int argc, char** argv) {
  return tremolo::coupler::recording_process({argv, argv + argc}, {});
}
