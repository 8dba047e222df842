// In every medium, with complex speeds a^2 = M*/rho and b^2 = G*/rho, vertical slownesses q_a^2 = 1/a^2 - p^2
// and q_b^2 = 1/b^2 - p^2, and c_2 = 1 - 2 b^2 p^2, a wave of unit particle velocity has
//
//                v_x    v_y     s_xy / -1       s_yy / -1
//     P  up      a p    a q_a   2 G a p q_a     rho a c_2
//     P  down    a p   -a q_a  -2 G a p q_a     rho a c_2
//     SV up      b q_b -b p     rho b c_2      -2 G b p q_b
//     SV down    b q_b  b p    -rho b c_2      -2 G b p q_b
//
// (Aki and Richards 2002, Quantitative Seismology, ch. 5.) With U the upgoing amplitudes at the bottom of a
// layer, D the downgoing ones at its top and E = diag exp(-s q h), |E| <= 1, the state is
//
//     M_up exp(-s q (y - y_bottom)) U + M_down exp(+s q (y - y_top)) D,
//
// where no exponential grows, however thick and evanescent the layer (Kennett 1983, Seismic Wave Propagation
// in Stratified Media, ch. 6). From the top down, with w = E U of the layer below an interface,
//
//     surface            D_1 = R_1 E_1 U_1,             M_down,sigma R_1 = -M_up,sigma
//     interface j|j+1    M_up,j U_j + M_down,j X_j U_j = M_up,j+1 w + M_down,j+1 D_j+1,
//                        X_j = E_j R_j E_j,
//
// and with A = [M_up,j, -M_down,j+1] factorised once, [B_1; B_2] = A^-1 M_down,j, [C_1; C_2] = A^-1 M_up,j+1,
//
//     U_j = T w,  T = (I + B_1 X_j)^-1 C_1        D_j+1 = R_j+1 w,  R_j+1 = C_2 - B_2 X_j T.
//
// The half-space starts the way back with w = the incident amplitude.
//
// Rayleigh damping at vertical incidence, rho (s v + alpha (v - v_ref)) = d sigma/dy: rho (1 + alpha/s)
// stands for rho, and a layer carries the velocity g v_ref, g = alpha/(s + alpha), without stress. v_ref is
// twice the incident wave at the foot of the lowest layer with alpha. So an interface has a source k = (g_j -
// g_j+1) v_ref, and with [K_1; K_2] = A^-1 k the recursion is affine, d_1 = 0,
//
//     U_j = T w + t_j,        t_j = -(I + B_1 X_j)^-1 (B_1 E_j d_j + K_1)
//     D_j+1 = R_j+1 w + d_j+1,    d_j+1 = -B_2 (X_j t_j + E_j d_j) - K_2.
//
// Where a wave runs exactly along a layer, q = 0, its up- and downgoing forms coincide and the basis is lost.
// The field in a layer is even in q, so a relative error d of the slowness costs d^2 there; |q| of a layer is
// kept above 5e-6 of the slowness, which costs 2.5e-11.

#include "wavefield/layers/reflectivity.hpp"

#include "base/require.hpp"

#include <Eigen/LU>

#include <cmath>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;
constexpr double least_slowness_of_layer = 5e-6;

/// sqrt(1/c^2 - p^2) on the branch of waves that decay away from their source; s = 0 stands for s = +0 i.
Complex vertical_slowness(Complex slowness, double p, Complex s) {
  const Complex q = std::sqrt((slowness - p) * (slowness + p));
  const Complex direction = s == 0.0 ? Complex(0.0, 1.0) : s;
  return (direction * q).real() < 0.0 ? -q : q;
}

Complex not_along_the_layer(Complex q, Complex slowness) {
  const double least = least_slowness_of_layer * std::abs(slowness);
  return std::abs(q) < least ? Complex(least) : q;
}

WaveBasis wave_basis(Complex density, const ComplexModuli& moduli, Complex q_a, Complex q_b, double p,
                     double impedance) {
  const Complex a = std::sqrt(moduli.p_wave / density);
  const Complex b = std::sqrt(moduli.shear / density);
  const Complex g = moduli.shear / impedance;
  const Complex rho_c2 = density / impedance - 2.0 * g * p * p;
  WaveBasis basis;
  basis.q = {q_a, q_b};
  basis.up << a * p, b * q_b, a * q_a, -b * p, 2.0 * g * a * p * q_a, rho_c2 * b, rho_c2 * a,
      -2.0 * g * b * p * q_b;
  basis.down << a * p, b * q_b, -a * q_a, b * p, -2.0 * g * a * p * q_a, -rho_c2 * b, rho_c2 * a,
      -2.0 * g * b * p * q_b;
  return basis;
}

double density(const LayeredHalfSpace& profile, std::size_t index) {
  return index < profile.layers.size() ? profile.layers[index].density : profile.half_space.density;
}

/// alpha of a medium, 1/s.
double mass_damping(const LayeredHalfSpace& profile, std::size_t index) {
  return index < profile.layers.size()
             ? rayleigh_factors(profile.damping, profile.layers[index].damping).alpha
             : 0.0;
}

} // namespace

Reflectivity::Reflectivity(const LayeredHalfSpace& profile, WaveType wave, double angle_rad)
    : profile_(profile), incident_(wave == WaveType::P ? 0 : 1), p_(0.0),
      impedance_(profile.half_space.density * profile.half_space.vs),
      factorised_once_(is_frequency_independent(profile.damping.model)) {
  validate(profile);
  const Incidence incidence{.wave = wave, .angle_rad = angle_rad};
  validate(incidence);
  p_ = wavefield::slowness_x(profile.half_space, incidence);
  require(p_ == 0.0 || profile.damping.model != DampingModel::rayleigh, "angle of incidence, in rad,",
          angle_rad,
          "0 under rayleigh damping: its part in proportion to mass is known at vertical incidence");
  const std::size_t layers = profile.layers.size();
  for (std::size_t j = 0; j <= layers; ++j)
    moduli_.emplace_back(profile, j);
  media_.resize(layers + 1);
  interfaces_.resize(layers);
  reflected_.resize(layers + 1);
  transmitted_.resize(layers);
  phase_.resize(layers);
  own_up_.resize(layers, Eigen::Vector2cd::Zero());
  own_down_.resize(layers + 1, Eigen::Vector2cd::Zero());
  amplitudes_.resize(layers + 1);
  if (factorised_once_)
    factorise(0.0);
}

void Reflectivity::factorise(Complex s) {
  for (std::size_t j = 0; j < media_.size(); ++j) {
    Medium& medium = media_[j];
    // At s = 0 everything moves with the outcrop, or undamped.
    const Complex braked = s == 0.0 ? Complex(1.0) : 1.0 + mass_damping(profile_, j) / s;
    const Complex rho = density(profile_, j) * braked;
    medium.moduli = moduli_[j].at(s);
    const Complex slowness_a = 1.0 / std::sqrt(medium.moduli.p_wave / rho);
    const Complex slowness_b = 1.0 / std::sqrt(medium.moduli.shear / rho);
    Complex q_a = vertical_slowness(slowness_a, p_, s);
    Complex q_b = vertical_slowness(slowness_b, p_, s);
    if (j < half_space()) {
      q_a = not_along_the_layer(q_a, slowness_a);
      q_b = not_along_the_layer(q_b, slowness_b);
    }
    medium.basis = wave_basis(rho, medium.moduli, q_a, q_b, p_, impedance_);
  }
  carry(s);
  const WaveBasis& top = media_.front().basis;
  surface_ = -top.down.bottomRows<2>().inverse() * top.up.bottomRows<2>();
  for (std::size_t j = 0; j < interfaces_.size(); ++j) {
    Eigen::Matrix4cd leaving;
    leaving << media_[j].basis.up, -media_[j + 1].basis.down;
    const Eigen::PartialPivLU<Eigen::Matrix4cd> factors(leaving);
    const WaveBasis::Columns from_above = factors.solve(media_[j].basis.down);
    const WaveBasis::Columns from_below = factors.solve(media_[j + 1].basis.up);
    interfaces_[j] = {.up_from_above = from_above.topRows<2>(),
                      .down_from_above = from_above.bottomRows<2>(),
                      .up_from_below = from_below.topRows<2>(),
                      .down_from_below = from_below.bottomRows<2>()};
    if (const Complex jump = amplitudes_[j].carried - amplitudes_[j + 1].carried; jump != 0.0) {
      const Eigen::Vector4cd source = jump * Eigen::Vector4cd::Unit(incident_ == 1 ? 0 : 1);
      const Eigen::Vector4cd leave = factors.solve(source);
      interfaces_[j].up_from_carried = leave.head<2>();
      interfaces_[j].down_from_carried = leave.tail<2>();
    }
  }
}

/// Velocity carried by each layer with Rayleigh damping, per unit incident velocity at the top of the
/// half-space.
void Reflectivity::carry(Complex s) {
  if (profile_.damping.model != DampingModel::rayleigh || s == 0.0)
    return;
  Complex reference = 2.0;
  bool braked = false;
  for (std::size_t j = interfaces_.size(); j-- > 0;) {
    const double alpha = mass_damping(profile_, j);
    braked = braked || alpha > 0.0;
    if (!braked)
      reference *= std::exp(-s * media_[j].basis.q[incident_] * profile_.layers[j].thickness);
  }
  for (std::size_t j = 0; j < interfaces_.size(); ++j) {
    const double alpha = mass_damping(profile_, j);
    amplitudes_[j].carried = alpha / (s + alpha) * reference;
  }
}

const std::vector<LayerAmplitudes>& Reflectivity::solve(Complex s) {
  if (!factorised_once_)
    factorise(s);
  reflected_.front() = surface_;
  for (std::size_t j = 0; j < interfaces_.size(); ++j) {
    const double h = profile_.layers[j].thickness;
    const auto& q = media_[j].basis.q;
    phase_[j] = {std::exp(-s * q[0] * h), std::exp(-s * q[1] * h)};
    const Interface& face = interfaces_[j];
    const Eigen::Matrix2cd there_and_back = phase_[j].asDiagonal() * reflected_[j] * phase_[j].asDiagonal();
    const Eigen::Matrix2cd again =
        (Eigen::Matrix2cd::Identity() + face.up_from_above * there_and_back).inverse();
    transmitted_[j] = again * face.up_from_below;
    reflected_[j + 1] = face.down_from_below - face.down_from_above * there_and_back * transmitted_[j];
    const Eigen::Vector2cd arriving = phase_[j].cwiseProduct(own_down_[j]);
    own_up_[j] = -again * (face.up_from_above * arriving + face.up_from_carried);
    own_down_[j + 1] =
        -face.down_from_above * (there_and_back * own_up_[j] + arriving) - face.down_from_carried;
  }
  Eigen::Vector2cd entering = Eigen::Vector2cd::Unit(static_cast<Eigen::Index>(incident_));
  amplitudes_.back().up = entering;
  amplitudes_.back().down = reflected_.back() * entering + own_down_.back();
  for (std::size_t j = interfaces_.size(); j-- > 0;) {
    amplitudes_[j].up = transmitted_[j] * entering + own_up_[j];
    entering = phase_[j].cwiseProduct(amplitudes_[j].up);
    amplitudes_[j].down = reflected_[j] * entering + own_down_[j];
  }
  return amplitudes_;
}

} // namespace tremolo::wavefield
