// What enters through the base under unequal surfaces, what takes up the waves that leave, and how far the
// sides must be: an elastic slope in boxes of many widths, compared with a box so wide and deep that nothing
// comes back from its boundaries in the time compared. Prints CSV.

#include "tests/support/scattering_run.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

using namespace tremolo::test_support;

constexpr std::array<std::pair<BaseField, std::string_view>, 6> fields{{{BaseField::incident, "incident"},
                                                                        {BaseField::step, "step"},
                                                                        {BaseField::blend, "blend"},
                                                                        {BaseField::across, "across"},
                                                                        {BaseField::ends, "ends"},
                                                                        {BaseField::local, "local"}}};
constexpr std::array<std::pair<Absorber, std::string_view>, 2> absorbers{
    {{Absorber::dashpots, "dashpots"}, {Absorber::layers, "layers"}}};

constexpr double reference_width = 1600.0; // m

} // namespace

/// Angles of incidence in degrees as arguments; without any 0.
int main(int argc, char** argv) {
  std::vector<double> angles{0.0};
  if (argc > 1) {
    angles.clear();
    for (int i = 1; i < argc; ++i)
      angles.push_back(std::atof(argv[i]));
  }
  std::printf("angle_deg,base,absorber,width_m,error\n");
  for (const double angle : angles) {
    // A layer 100 cells deep, where all waves are nearly gone before the stretch is steep.
    const ScatteredMotion reference =
        shake({reference_width, BaseField::incident, Absorber::layer_below, angle, 100});
    const ScatteredMotion other =
        shake({reference_width, BaseField::across, Absorber::layer_below, angle, 100});
    std::printf("%g,across,layer of 100 cells,%g,%.5f\n", angle, reference_width,
                difference(other, reference));
    std::fflush(stdout);
    for (const auto& [field, field_name] : fields)
      for (const auto& [absorber, absorber_name] : absorbers)
        for (const double width : {40.0, 80.0, 160.0, 320.0}) {
          const ScatteredMotion motion = shake({width, field, absorber, angle});
          std::printf("%g,%s,%s,%g,%.5f\n", angle, field_name.data(), absorber_name.data(), width,
                      difference(motion, reference));
          std::fflush(stdout);
        }
  }
}
