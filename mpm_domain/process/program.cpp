#include "mpm_domain/process/domain_process.hpp"

int main(int argc, char** argv) {
  return tremolo::mpm_domain::domain_process({argv, argv + argc}, {});
}
