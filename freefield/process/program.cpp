#include "freefield/process/column_process.hpp"

int main(int argc, char** argv) {
  return tremolo::freefield::column_process({argv, argv + argc}, {});
}
