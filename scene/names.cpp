#include "scene/case.hpp"

namespace tremolo::scene {

std::string_view name(Wave wave) {
  return wave == Wave::sv ? "SV" : "P";
}

std::string_view name(Quantity quantity) {
  return quantity == Quantity::acceleration ? "acceleration" : "velocity";
}

std::string_view name(Integrator integrator) {
  return integrator == Integrator::central_difference ? "central_difference" : "newmark";
}

std::string_view name(Transfer transfer) {
  switch (transfer) {
  case Transfer::apic:
    return "apic";
  case Transfer::flip:
    return "flip";
  case Transfer::pic_blend:
    return "pic_blend";
  }
  return {};
}

std::string_view name(StepOrder order) {
  switch (order) {
  case StepOrder::usl:
    return "usl";
  case StepOrder::usf:
    return "usf";
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

std::string_view name(SourceModel model) {
  return model == SourceModel::wave ? "wave" : "column";
}

std::string_view name(BaseForm form) {
  return form == BaseForm::total ? "total" : "incident";
}

std::string_view name(ExchangeMode mode) {
  return mode == ExchangeMode::window ? "window" : "lockstep";
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
