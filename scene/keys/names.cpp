#include "scene/case.hpp"

namespace tremolo::scene {

std::string_view name(Wave wave) {
  return wave == Wave::sv ? "SV" : "P";
}

std::string_view name(DampingModel model) {
  switch (model) {
  case DampingModel::none:
    return "none";
  case DampingModel::rayleigh:
    return "rayleigh";
  case DampingModel::kelvin_voigt:
    return "kelvin_voigt";
  case DampingModel::hysteretic:
    return "hysteretic";
  case DampingModel::shake:
    return "shake";
  case DampingModel::kjartansson:
    return "kjartansson";
  }
  return {};
}

std::string_view name(Integrator integrator) {
  switch (integrator) {
  case Integrator::central_difference:
    return "central_difference";
  case Integrator::newmark:
    return "newmark";
  case Integrator::hht:
    return "hht";
  }
  return {};
}

std::string_view name(NewtonTangent tangent) {
  return tangent == NewtonTangent::consistent ? "consistent" : "initial";
}

std::string_view name(OdeMethod method) {
  switch (method) {
  case OdeMethod::adams:
    return "adams";
  case OdeMethod::bdf:
    return "bdf";
  case OdeMethod::erk:
    return "erk";
  case OdeMethod::imex:
    return "imex";
  }
  return {};
}

std::string_view name(Transfer transfer) {
  switch (transfer) {
  case Transfer::apic:
    return "apic";
  case Transfer::flip:
    return "flip";
  }
  return {};
}

std::string_view name(ParticleBoxes boxes) {
  switch (boxes) {
  case ParticleBoxes::fixed:
    return "fixed";
  case ParticleBoxes::deforming:
    return "deforming";
  }
  return {};
}

std::string_view name(StepOrder order) {
  switch (order) {
  case StepOrder::usl:
    return "usl";
  case StepOrder::musl:
    return "musl";
  }
  return {};
}

std::string_view name(Side side) {
  switch (side) {
  case Side::left:
    return "left";
  case Side::right:
    return "right";
  case Side::base:
    return "base";
  }
  return {};
}

std::string_view name(Sides sides) {
  switch (sides) {
  case Sides::free_field:
    return "free_field";
  case Sides::periodic:
    return "periodic";
  case Sides::periodic_springs:
    return "periodic_springs";
  }
  return {};
}

std::string_view name(Absorber absorber) {
  switch (absorber) {
  case Absorber::dashpots:
    return "dashpots";
  case Absorber::matched_layer:
    return "matched_layer";
  }
  return {};
}

std::string_view name(SourceModel model) {
  switch (model) {
  case SourceModel::wave:
    return "wave";
  case SourceModel::fe:
    return "fe";
  case SourceModel::ode:
    return "ode";
  case SourceModel::oblique:
    return "oblique";
  case SourceModel::eql:
    return "eql";
  case SourceModel::mpm:
    return "mpm";
  case SourceModel::recording:
    return "recording";
  case SourceModel::external:
    return "external";
  }
  return {};
}

std::string_view name(BaseForm form) {
  switch (form) {
  case BaseForm::total:
    return "total";
  case BaseForm::incident:
    return "incident";
  case BaseForm::blended:
    return "blended";
  }
  return {};
}

std::string_view name(ExchangeMode mode) {
  return mode == ExchangeMode::window ? "window" : "lockstep";
}

std::string_view name(OnFullDisk policy) {
  return policy == OnFullDisk::stop ? "stop" : "go_on";
}

std::string_view name(StartBy start) {
  switch (start) {
  case StartBy::ssh:
    return "ssh";
  case StartBy::slurm:
    return "slurm";
  case StartBy::join:
    return "join";
  }
  return {};
}

std::string_view name(OutputField field) {
  switch (field) {
  case OutputField::displacement:
    return "displacement";
  case OutputField::velocity:
    return "velocity";
  case OutputField::acceleration:
    return "acceleration";
  case OutputField::stress:
    return "stress";
  case OutputField::state:
    return "state";
  }
  return {};
}

} // namespace tremolo::scene
