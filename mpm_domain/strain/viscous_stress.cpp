#include "mpm_domain/strain/viscous_stress.hpp"

namespace tremolo::mpm_domain {

double damp(Particles& p, const ParticleRange& range, const StrainIncrements& seen,
            const StrainIncrements& moved, const double* ratios, double dt) {
  const materials::Elasticity& elastic = materials::elasticity(p.law);
  const double rate = p.damping_time / dt;
  const double along = rate * elastic.p_modulus();
  const double across = rate * elastic.lame();
  const double shear = rate * elastic.shear_modulus();
  Lanes work{};
  by_fours(range.begin, range.end, [&](std::size_t k, auto group) {
    const std::size_t c = k - range.begin;
    const Lanes exx = group.load(&moved.exx[c]);
    const Lanes eyy = group.load(&moved.eyy[c]);
    const Lanes gxy = group.load(&moved.gxy[c]);
    const auto power = [&] {
      return group.load(&p.viscous_xx[k]) * exx + group.load(&p.viscous_yy[k]) * eyy +
             group.load(&p.viscous_xy[k]) * gxy;
    };
    const Lanes volume = group.load(&p.volume[k]);
    work += 0.5 * volume * power();
    const Lanes factor = ratios != nullptr ? group.load(ratios + c) : all(1.0);
    const Lanes seen_xx = group.load(&seen.exx[c]);
    const Lanes seen_yy = group.load(&seen.eyy[c]);
    group.store(&p.viscous_xx[k], factor * (along * seen_xx + across * seen_yy));
    group.store(&p.viscous_yy[k], factor * (across * seen_xx + along * seen_yy));
    group.store(&p.viscous_xy[k], factor * (shear * group.load(&seen.gxy[c])));
    work += 0.5 * volume * growth(exx + eyy) * power();
  });
  return sum(work);
}

} // namespace tremolo::mpm_domain
