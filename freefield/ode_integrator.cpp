// SUNDIALS: Hindmarsh et al. (2005), ACM Trans. Math. Softw. 31(3), 363-396; Gardner et al. (2022),
// 48(3), 31.

#include "freefield/ode_integrator.hpp"

#include "freefield/require.hpp"

#include <arkode/arkode_arkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
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
struct FreeCvode {
  void operator()(void* memory) const { CVodeFree(&memory); }
};
struct FreeArkode {
  void operator()(void* memory) const { ARKStepFree(&memory); }
};
using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Free<N_VDestroy>>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Free<SUNMatDestroy>>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Free<SUNLinSolFree>>;
using NonlinearSolver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, Free<SUNNonlinSolFree>>;

Context make_context() {
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0) {
    throw std::runtime_error("SUNDIALS could not create its context");
  }
  return Context(context);
}

std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<std::size_t>(N_VGetLength(v))};
}

bool is_cvode(OdeMethod method) {
  return method == OdeMethod::adams || method == OdeMethod::bdf;
}

/// Tells the integrator to give up where the equations have no finite value: no smaller step would mend an
/// input that is not a number.
int finite_or_stop(N_Vector rate) {
  double sum = 0.0;
  for (const double r : values(rate)) {
    sum += r;
  }
  return std::isfinite(sum) ? 0 : -1;
}

} // namespace

struct OdeIntegrator::Sundials {
  OdeSystem& system;
  OdeColumnSettings settings;
  std::vector<double> level;
  double time;
  std::string message; ///< of the last error
  Context context = make_context();
  Vector y, tolerance;
  Matrix matrix;
  LinearSolver linear;
  NonlinearSolver nonlinear;
  std::unique_ptr<void, FreeCvode> cvode;
  std::unique_ptr<void, FreeArkode> arkode;

  Sundials(OdeSystem& equations, const OdeColumnSettings& how, std::vector<double> absolute_tolerance,
           std::vector<double> levels)
      : system(equations), settings(how), level(std::move(levels)), time(how.start_time),
        y(N_VNew_Serial(static_cast<sunindextype>(system.size()), context.get())),
        tolerance(N_VClone(y.get())) {
    N_VConst(0.0, y.get());
    std::copy(absolute_tolerance.begin(), absolute_tolerance.end(), values(tolerance.get()).begin());
    if (settings.method == OdeMethod::bdf || settings.method == OdeMethod::imex) {
      matrix.reset(SUNBandMatrix(static_cast<sunindextype>(system.size()), OdeSystem::bandwidth,
                                 OdeSystem::bandwidth, context.get()));
      linear.reset(SUNLinSol_Band(y.get(), matrix.get(), context.get()));
    }
    if (is_cvode(settings.method)) {
      start_cvode();
    } else {
      start_arkode();
    }
  }

  void check(int flag) const {
    if (flag < 0) {
      throw std::runtime_error("SUNDIALS refused its settings: " + message);
    }
  }

  void start_cvode() {
    const bool stiff = settings.method == OdeMethod::bdf;
    cvode.reset(CVodeCreate(stiff ? CV_BDF : CV_ADAMS, context.get()));
    void* memory = cvode.get();
    check(CVodeSetErrHandlerFn(memory, keep_message, this));
    check(CVodeInit(memory, derivative, time, y.get()));
    check(CVodeSVtolerances(memory, settings.relative_tolerance, tolerance.get()));
    check(CVodeSetUserData(memory, this));
    check(CVodeSetMaxStep(memory, settings.max_step));
    if (stiff) {
      check(CVodeSetLinearSolver(memory, linear.get(), matrix.get()));
      check(CVodeSetJacFn(memory, jacobian));
    } else {
      nonlinear.reset(SUNNonlinSol_FixedPoint(y.get(), 0, context.get()));
      check(CVodeSetNonlinearSolver(memory, nonlinear.get()));
    }
  }

  void start_arkode() {
    const bool imex = settings.method == OdeMethod::imex;
    arkode.reset(ARKStepCreate(imex ? wave_part : derivative, imex ? damping_part : nullptr, time, y.get(),
                               context.get()));
    void* memory = arkode.get();
    check(ARKStepSetErrHandlerFn(memory, keep_message, this));
    check(ARKStepSVtolerances(memory, settings.relative_tolerance, tolerance.get()));
    check(ARKStepSetUserData(memory, this));
    check(ARKStepSetMaxStep(memory, settings.max_step));
    check(ARKStepSetOrder(memory, order(imex)));
    check(ARKStepSetInterpolantDegree(memory, 3));
    if (imex) {
      check(ARKStepSetLinearSolver(memory, linear.get(), matrix.get()));
      check(ARKStepSetJacFn(memory, damping_jacobian));
      check(ARKStepSetLinear(memory, 0));
    }
  }

  /// The cheapest orders as measured: three where stability rather than accuracy sets the step.
  int order(bool imex) const {
    constexpr double loose = 1e-5;
    return settings.relative_tolerance >= loose ? 3 : imex ? 4 : 5;
  }

  [[noreturn]] void give_up(int flag) const {
    const Vector error(N_VClone(y.get()));
    const Vector weight(N_VClone(y.get()));
    N_VConst(0.0, error.get());
    N_VConst(0.0, weight.get());
    if (cvode) {
      CVodeGetEstLocalErrors(cvode.get(), error.get());
      CVodeGetErrWeights(cvode.get(), weight.get());
    } else {
      ARKStepGetEstLocalErrors(arkode.get(), error.get());
      ARKStepGetErrWeights(arkode.get(), weight.get());
    }
    N_VProd(error.get(), weight.get(), error.get());
    const auto errors = values(error.get());
    const auto largest = std::max_element(errors.begin(), errors.end(), [](double a, double b) {
      return std::abs(a) < std::abs(b) || (!std::isfinite(b) && std::isfinite(a));
    });
    throw std::runtime_error("the column could not be integrated beyond t = " + shortest(time) +
                             " s; its error is largest at y = " +
                             shortest(level[static_cast<std::size_t>(largest - errors.begin())]) +
                             " m. SUNDIALS (" + std::to_string(flag) + "): " + message);
  }

  void step() {
    system.accept(time, values(y.get()));
    const double ahead = time + settings.max_step;
    const int flag = cvode ? CVode(cvode.get(), ahead, y.get(), &time, CV_ONE_STEP)
                           : ARKStepEvolve(arkode.get(), ahead, y.get(), &time, ARK_ONE_STEP);
    if (flag < 0) {
      give_up(flag);
    }
  }

  static Sundials& self(void* data) { return *static_cast<Sundials*>(data); }

  static int derivative(realtype t, N_Vector y, N_Vector rate, void* data) {
    self(data).system.derivative(t, values(y), values(rate));
    return finite_or_stop(rate);
  }
  static int wave_part(realtype t, N_Vector y, N_Vector rate, void* data) {
    self(data).system.wave_part(t, values(y), values(rate));
    return finite_or_stop(rate);
  }
  static int damping_part(realtype, N_Vector y, N_Vector rate, void* data) {
    self(data).system.damping_part(values(y), values(rate));
    return finite_or_stop(rate);
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
  const int flag = s.cvode ? CVodeGetDky(s.cvode.get(), time, order, out.get())
                           : ARKStepGetDky(s.arkode.get(), time, order, out.get());
  if (flag < 0) {
    throw std::runtime_error("no state of the column at t = " + shortest(time) + " s: " + s.message);
  }
}

OdeStatistics OdeIntegrator::statistics() const {
  OdeStatistics s;
  if (void* cvode = sundials_->cvode.get()) {
    CVodeGetNumSteps(cvode, &s.steps);
    CVodeGetNumErrTestFails(cvode, &s.rejections);
    CVodeGetNumStepSolveFails(cvode, &s.convergence_failures);
    CVodeGetNumRhsEvals(cvode, &s.right_hand_sides);
    CVodeGetNumJacEvals(cvode, &s.jacobians);
    s.jacobians = std::max(s.jacobians, 0L);
    return s;
  }
  void* arkode = sundials_->arkode.get();
  ARKStepGetNumSteps(arkode, &s.steps);
  ARKStepGetNumErrTestFails(arkode, &s.rejections);
  ARKStepGetNumStepSolveFails(arkode, &s.convergence_failures);
  ARKStepGetNumRhsEvals(arkode, &s.right_hand_sides, &s.implicit_sides);
  if (sundials_->linear) {
    ARKStepGetNumJacEvals(arkode, &s.jacobians);
  }
  return s;
}

} // namespace tremolo::freefield
