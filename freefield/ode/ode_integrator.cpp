// SUNDIALS: Hindmarsh et al. (2005), ACM Trans. Math. Softw. 31(3), 363-396; Gardner et al. (2022),
// 48(3), 31.

#include "freefield/ode/ode_integrator.hpp"

#include "base/require.hpp"
#include "freefield/ode/ode_runge_kutta.hpp"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

namespace tremolo::freefield {
namespace {

template <auto destroy>
struct Free {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
struct FreeContext {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Free<N_VDestroy>>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Free<SUNMatDestroy>>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Free<SUNLinSolFree>>;
using NonlinearSolver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, Free<SUNNonlinSolFree>>;

Context make_context() {
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0)
    throw std::runtime_error("SUNDIALS could not create its context");
  return Context(context);
}

std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<std::size_t>(N_VGetLength(v))};
}

/// Common interface of CVODE and the two modules of ARKODE.
struct Module {
  int (*evolve)(void*, realtype, N_Vector, realtype*, int);
  int (*state)(void*, realtype, int, N_Vector);
  int (*local_errors)(void*, N_Vector);
  int (*error_weights)(void*, N_Vector);
  int (*steps)(void*, long*);
  int (*rejections)(void*, long*);
  void (*destroy)(void**);
};
constexpr Module multistep = {CVode,
                              CVodeGetDky,
                              CVodeGetEstLocalErrors,
                              CVodeGetErrWeights,
                              CVodeGetNumSteps,
                              CVodeGetNumErrTestFails,
                              CVodeFree};
constexpr Module additive_runge_kutta = {ARKStepEvolve,        ARKStepGetDky,      ARKStepGetEstLocalErrors,
                                         ARKStepGetErrWeights, ARKStepGetNumSteps, ARKStepGetNumErrTestFails,
                                         ARKStepFree};
constexpr Module explicit_runge_kutta = {ERKStepEvolve,        ERKStepGetDky,      ERKStepGetEstLocalErrors,
                                         ERKStepGetErrWeights, ERKStepGetNumSteps, ERKStepGetNumErrTestFails,
                                         ERKStepFree};
constexpr int one_step = CV_ONE_STEP;
static_assert(one_step == ARK_ONE_STEP);

const Module& module_of(OdeMethod method) {
  switch (method) {
  case OdeMethod::explicit_runge_kutta:
    return explicit_runge_kutta;
  case OdeMethod::imex:
    return additive_runge_kutta;
  default:
    return multistep;
  }
}

struct FreeMemory {
  const Module* module;
  void operator()(void* memory) const { module->destroy(&memory); }
};
using Memory = std::unique_ptr<void, FreeMemory>;

/// z = sum of c_k x_k, where z may be x_0. SUNDIALS' own reads the vectors whose coefficient is zero too, and
/// those are most of a Runge-Kutta table.
int linear_combination(int terms, realtype* c, N_Vector* x, N_Vector z) {
  const auto out = values(z);
  bool is_first = true;
  for (int k = 0; k < terms; ++k) {
    if (c[k] == 0.0)
      continue;
    const auto in = values(x[k]);
    const double factor = c[k];
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = is_first ? factor * in[i] : out[i] + factor * in[i];
    is_first = false;
  }
  if (is_first)
    N_VConst(0.0, z);
  return 0;
}

} // namespace

struct OdeIntegrator::Sundials {
  OdeSystem& system;
  OdeColumnSettings settings;
  std::vector<double> level;
  double time;
  std::string message; ///< of the last error
  struct NotFinite {
    double time = 0.0;
    std::size_t variable = 0;
  };
  std::optional<NotFinite> not_finite; ///< where a derivative was first
  Context context = make_context();
  Vector y, tolerance;
  Matrix matrix;
  LinearSolver linear;
  NonlinearSolver nonlinear;
  const Module& module;
  Memory memory;

  Sundials(OdeSystem& equations, const OdeColumnSettings& how, std::vector<double> absolute_tolerance,
           std::vector<double> levels)
      : system(equations), settings(how), level(std::move(levels)), time(how.start_time),
        y(N_VNew_Serial(static_cast<sunindextype>(system.size()), context.get())),
        tolerance(N_VClone(y.get())), module(module_of(how.method)), memory(nullptr, FreeMemory{&module}) {
    y->ops->nvlinearcombination = linear_combination; // clones inherit it
    N_VConst(0.0, y.get());
    std::copy(absolute_tolerance.begin(), absolute_tolerance.end(), values(tolerance.get()).begin());
    if (settings.method == OdeMethod::bdf || settings.method == OdeMethod::imex) {
      matrix.reset(SUNBandMatrix(static_cast<sunindextype>(system.size()), system.bandwidth(),
                                 system.bandwidth(), context.get()));
      linear.reset(SUNLinSol_Band(y.get(), matrix.get(), context.get()));
    }
    switch (settings.method) {
    case OdeMethod::explicit_runge_kutta:
      start_explicit();
      break;
    case OdeMethod::imex:
      start_imex();
      break;
    default:
      start_multistep();
    }
  }

  void check(int flag) const {
    if (flag < 0)
      throw std::runtime_error("SUNDIALS refused its settings: " + message);
  }

  void start_multistep() {
    const bool stiff = settings.method == OdeMethod::bdf;
    memory.reset(CVodeCreate(stiff ? CV_BDF : CV_ADAMS, context.get()));
    check(CVodeSetErrHandlerFn(memory.get(), keep_message, this));
    check(CVodeInit(memory.get(), derivative, time, y.get()));
    check(CVodeSVtolerances(memory.get(), settings.relative_tolerance, tolerance.get()));
    check(CVodeSetUserData(memory.get(), this));
    check(CVodeSetMaxStep(memory.get(), settings.max_step));
    if (stiff) {
      check(CVodeSetLinearSolver(memory.get(), linear.get(), matrix.get()));
      check(CVodeSetJacFn(memory.get(), jacobian));
    } else {
      nonlinear.reset(SUNNonlinSol_FixedPoint(y.get(), 0, context.get()));
      check(CVodeSetNonlinearSolver(memory.get(), nonlinear.get()));
    }
  }

  void start_explicit() {
    memory.reset(ERKStepCreate(derivative, time, y.get(), context.get()));
    check(ERKStepSetErrHandlerFn(memory.get(), keep_message, this));
    check(ERKStepSVtolerances(memory.get(), settings.relative_tolerance, tolerance.get()));
    check(ERKStepSetUserData(memory.get(), this));
    check(ERKStepSetMaxStep(memory.get(), settings.max_step));
    if (is_loose())
      check(ERKStepSetTable(memory.get(), wide_runge_kutta().get()));
    else
      check(ERKStepSetOrder(memory.get(), 5));
    check(ERKStepSetInterpolantDegree(memory.get(), 3));
  }

  void start_imex() {
    memory.reset(ARKStepCreate(wave_part, damping_part, time, y.get(), context.get()));
    check(ARKStepSetErrHandlerFn(memory.get(), keep_message, this));
    check(ARKStepSVtolerances(memory.get(), settings.relative_tolerance, tolerance.get()));
    check(ARKStepSetUserData(memory.get(), this));
    check(ARKStepSetMaxStep(memory.get(), settings.max_step));
    check(ARKStepSetOrder(memory.get(), is_loose() ? 3 : 4));
    check(ARKStepSetInterpolantDegree(memory.get(), 3));
    check(ARKStepSetLinearSolver(memory.get(), linear.get(), matrix.get()));
    check(ARKStepSetJacFn(memory.get(), damping_jacobian));
    check(ARKStepSetLinear(memory.get(), 0));
  }

  /// Whether stability rather than accuracy is likely to set the step, as measured.
  bool is_loose() const { return settings.relative_tolerance >= 1e-5; }

  [[noreturn]] void give_up(int flag) const {
    const std::string beginning = "the column could not be integrated beyond t = " + shortest(time) + " s; ";
    if (not_finite) {
      throw std::runtime_error(
          beginning + "at t = " + shortest(not_finite->time) +
          " s its equations have no finite value at y = " + shortest(level[not_finite->variable]) +
          " m: is the input motion finite there?");
    }
    const Vector error(N_VClone(y.get()));
    const Vector weight(N_VClone(y.get()));
    N_VConst(0.0, error.get());
    N_VConst(0.0, weight.get());
    module.local_errors(memory.get(), error.get());
    module.error_weights(memory.get(), weight.get());
    N_VProd(error.get(), weight.get(), error.get());
    const auto errors = values(error.get());
    const auto largest = std::max_element(errors.begin(), errors.end(), [](double a, double b) {
      return std::abs(a) < std::abs(b) || (!std::isfinite(b) && std::isfinite(a));
    });
    throw std::runtime_error(beginning + "its error is largest at y = " +
                             shortest(level[static_cast<std::size_t>(largest - errors.begin())]) +
                             " m. SUNDIALS (" + std::to_string(flag) + "): " + message);
  }

  void step() {
    system.accept(time, values(y.get()));
    const double ahead = time + settings.max_step;
    const int flag = module.evolve(memory.get(), ahead, y.get(), &time, one_step);
    if (flag < 0 || not_finite)
      give_up(flag);
  }

  /// Makes the integrator give up where the equations have no finite value: no smaller step would mend an
  /// input that is not a number. Adams' functional iteration would try them nevertheless.
  int finite_or_stop(double t, N_Vector rate) {
    const auto rates = values(rate);
    if (std::isfinite(std::accumulate(rates.begin(), rates.end(), 0.0)))
      return 0;
    const auto bad = std::find_if_not(rates.begin(), rates.end(), [](double r) { return std::isfinite(r); });
    if (!not_finite)
      not_finite = {t, static_cast<std::size_t>(std::distance(rates.begin(), bad)) % rates.size()};
    return -1;
  }

  static Sundials& self(void* data) { return *static_cast<Sundials*>(data); }

  static int derivative(realtype t, N_Vector y, N_Vector rate, void* data) {
    self(data).system.derivative(t, values(y), values(rate));
    return self(data).finite_or_stop(t, rate);
  }
  static int wave_part(realtype t, N_Vector y, N_Vector rate, void* data) {
    self(data).system.wave_part(t, values(y), values(rate));
    return self(data).finite_or_stop(t, rate);
  }
  static int damping_part(realtype t, N_Vector y, N_Vector rate, void* data) {
    self(data).system.damping_part(values(y), values(rate));
    return self(data).finite_or_stop(t, rate);
  }
  static OdeSystem::Entry adder(SUNMatrix matrix) {
    return [matrix](std::size_t row, std::size_t column, double value) {
      const auto i = static_cast<sunindextype>(row);
      const auto j = static_cast<sunindextype>(column);
      SM_ELEMENT_B(matrix, i, j) += value;
    };
  }
  static int jacobian(realtype t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector,
                      N_Vector) {
    self(data).system.jacobian(t, values(y), adder(matrix));
    return 0;
  }
  static int damping_jacobian(realtype, N_Vector, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector,
                              N_Vector) {
    self(data).system.damping_jacobian(adder(matrix));
    return 0;
  }
  static void keep_message(int, const char*, const char* function, char* text, void* data) {
    self(data).message = std::string(function) + ": " + text;
  }
};

OdeIntegrator::OdeIntegrator(OdeSystem& system, const OdeColumnSettings& settings,
                             std::vector<double> absolute_tolerance, std::vector<double> level)
    : sundials_(
          std::make_unique<Sundials>(system, settings, std::move(absolute_tolerance), std::move(level))) {}

OdeIntegrator::~OdeIntegrator() = default;

void OdeIntegrator::step() {
  sundials_->step();
}

double OdeIntegrator::time() const {
  return sundials_->time;
}

void OdeIntegrator::state(double time, int order, std::span<double> y) const {
  Sundials& s = *sundials_;
  const Vector out(N_VMake_Serial(static_cast<sunindextype>(y.size()), y.data(), s.context.get()));
  const int flag = s.module.state(s.memory.get(), time, order, out.get());
  if (flag < 0)
    throw std::runtime_error("no state of the column at t = " + shortest(time) + " s: " + s.message);
}

OdeStatistics OdeIntegrator::statistics() const {
  OdeStatistics s;
  void* memory = sundials_->memory.get();
  sundials_->module.steps(memory, &s.steps);
  sundials_->module.rejections(memory, &s.rejections);
  switch (sundials_->settings.method) {
  case OdeMethod::explicit_runge_kutta:
    ERKStepGetNumRhsEvals(memory, &s.right_hand_sides);
    break;
  case OdeMethod::imex:
    ARKStepGetNumStepSolveFails(memory, &s.convergence_failures);
    ARKStepGetNumRhsEvals(memory, &s.right_hand_sides, &s.implicit_sides);
    ARKStepGetNumJacEvals(memory, &s.jacobians);
    break;
  default:
    CVodeGetNumStepSolveFails(memory, &s.convergence_failures);
    CVodeGetNumRhsEvals(memory, &s.right_hand_sides);
    if (sundials_->linear)
      CVodeGetNumJacEvals(memory, &s.jacobians);
  }
  return s;
}

} // namespace tremolo::freefield
