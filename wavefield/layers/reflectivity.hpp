#pragma once

#include "wavefield/layers/layered_half_space.hpp"

#include <Eigen/Core>

#include <array>
#include <complex>
#include <vector>

namespace tremolo::wavefield {

/// The plane waves of one medium at one s = i omega + epsilon and one horizontal slowness p. A wave depends
/// on position like exp(-s (p x +- q y)), + up, - down, and has unit particle velocity. Columns: P, SV. Rows:
/// vx, vy, and the tractions sxy, syy divided by -Z, Z an impedance that scales them (Pa s/m).
struct WaveBasis {
  using Columns = Eigen::Matrix<std::complex<double>, 4, 2>;
  std::array<std::complex<double>, 2> q; ///< vertical slowness of P and S, s/m, Re(s q) >= 0
  Columns up, down;
};

/// Amplitudes of the waves of one layer, P and SV, each referred to the face where it enters: the upgoing at
/// the layer's bottom, the downgoing at its top. In the half-space both are referred to its top.
struct LayerAmplitudes {
  Eigen::Vector2cd up, down;
  /// Velocity that a layer of Rayleigh damping has besides its waves, along the incident wave's motion.
  std::complex<double> carried = 0.0;
};

/// Response of a layered half-space to an incident plane P or SV wave, one frequency at a time.
class Reflectivity {
public:
  /// @throws std::invalid_argument for values outside their range
  Reflectivity(const LayeredHalfSpace& profile, WaveType wave, double angle_rad);

  /// All layers' amplitudes, the half-space's last, for an incident wave of unit particle velocity at the top
  /// of the half-space. s = 0 is the limit of low frequencies. Valid until the next call.
  const std::vector<LayerAmplitudes>& solve(std::complex<double> s);

  /// Waves and moduli of a medium at the s of the last solve(); index as in MediumModuli.
  const WaveBasis& basis(std::size_t index) const { return media_[index].basis; }
  const ComplexModuli& moduli(std::size_t index) const { return media_[index].moduli; }

  double slowness_x() const { return p_; }                     ///< s/m
  double impedance() const { return impedance_; }              ///< Z of WaveBasis, Pa s/m
  std::size_t half_space() const { return media_.size() - 1; } ///< index of its medium

  /// Vertical slowness of the incident wave at the s of the last solve(), s/m.
  std::complex<double> incident_slowness() const { return media_.back().basis.q[incident_]; }

private:
  struct Medium {
    ComplexModuli moduli;
    WaveBasis basis;
  };
  /// Scattering at an interface: outgoing waves for given incoming ones.
  struct Interface {
    Eigen::Matrix2cd up_from_above, down_from_above; ///< both caused by the wave coming down from above
    Eigen::Matrix2cd up_from_below, down_from_below; ///< both caused by the wave coming up from below
    /// Both caused by what the layers carry, where that differs.
    Eigen::Vector2cd up_from_carried = Eigen::Vector2cd::Zero(), down_from_carried = Eigen::Vector2cd::Zero();
  };

  void factorise(std::complex<double> s);
  void carry(std::complex<double> s);

  LayeredHalfSpace profile_;
  std::size_t incident_;
  double p_;
  double impedance_;
  bool factorised_once_;
  std::vector<MediumModuli> moduli_;
  std::vector<Medium> media_;
  std::vector<Interface> interfaces_;         ///< below layer j
  Eigen::Matrix2cd surface_;                  ///< downgoing amplitudes per upgoing, at the free surface
  std::vector<Eigen::Matrix2cd> reflected_;   ///< per layer: down at its top per up at its top
  std::vector<Eigen::Matrix2cd> transmitted_; ///< per layer: up at its bottom per up at the next one's top
  std::vector<Eigen::Vector2cd> phase_;       ///< per layer: exp(-s q h)
  std::vector<Eigen::Vector2cd> own_up_;      ///< per layer: up at its bottom without a wave from below
  std::vector<Eigen::Vector2cd> own_down_;    ///< per layer: down at its top without a wave from below
  std::vector<LayerAmplitudes> amplitudes_;
};

} // namespace tremolo::wavefield
