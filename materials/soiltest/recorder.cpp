#include "materials/soiltest/recorder.hpp"

namespace tremolo::soiltest {
namespace {

Column column(std::string_view name, std::string_view unit, std::string_view meaning) {
  return {std::string(name), std::string(unit), std::string(meaning), {}};
}

} // namespace

Recorder::Recorder(const materials::Law& law, const Apparatus& apparatus, std::size_t every)
    : apparatus_(apparatus), every_(every) {
  history_.columns = {column("step", "1", "increments so far"),
                      column("cycle", "1", "cycles so far"),
                      column("eps_xx", "1", "strain"),
                      column("eps_yy", "1", "strain"),
                      column("gamma_xy", "1", "engineering shear strain"),
                      column("sig_xx", "Pa", "effective stress, tension positive"),
                      column("sig_yy", "Pa", "effective stress, tension positive"),
                      column("sig_zz", "Pa", "effective stress, tension positive"),
                      column("sig_xy", "Pa", "shear stress"),
                      column("p_inplane", "Pa", "-(sig_xx + sig_yy)/2"),
                      column("u", "Pa", "excess pore pressure"),
                      column("ru", "1", "excess pore pressure ratio")};
  if (apparatus_.out_of_plane())
    history_.columns.push_back(column("eps_zz", "1", "strain out of plane"));
  const auto variables = state_variables(law);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (!variables[k].internal) {
      variables_.push_back(k);
      history_.columns.push_back(column(variables[k].name, variables[k].unit, variables[k].meaning));
    }
  }
}

void Recorder::record(std::size_t step, double cycle, const materials::PointTest& point, bool keep) {
  const auto number = static_cast<double>(step);
  const std::vector<double>& steps = history_.columns.front().values;
  if ((!keep && step % every_ != 0) || (!steps.empty() && steps.back() == number))
    return;
  const materials::PointStrain& e = point.strain();
  const materials::PointStress& s = point.stress();
  row_ = {number, cycle, e.xx, e.yy, e.xy, s.xx, s.yy, s.zz, s.xy, -0.5 * (s.xx + s.yy)};
  row_.push_back(apparatus_.pore_pressure(point));
  row_.push_back(apparatus_.pore_pressure_ratio(point));
  if (apparatus_.out_of_plane())
    row_.push_back(e.zz);
  for (const std::size_t k : variables_)
    row_.push_back(point.state()[k]);
  for (std::size_t i = 0; i < row_.size(); ++i)
    history_.columns[i].values.push_back(row_[i]);
}

} // namespace tremolo::soiltest
