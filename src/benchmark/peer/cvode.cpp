// SUNDIALS CVODE on the library's work.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <memory>
#include <numeric>
#include <stdexcept>

#include "benchmark/peer/peers.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr int kElements = 5;

struct Task {
  const PeerWork& work;
  double velocity;
};

int rates(realtype /*time*/, N_Vector force, N_Vector rate, void* task) {
  const auto* given = static_cast<const Task*>(task);
  maxwellRates(given->work, given->velocity, N_VGetArrayPointer(force), N_VGetArrayPointer(rate));
  return 0;
}

int jacobian(realtype /*time*/, N_Vector /*force*/, N_Vector /*rate*/, SUNMatrix matrix, void* task, N_Vector /*a*/,
             N_Vector /*b*/, N_Vector /*c*/) {
  const auto* given = static_cast<const Task*>(task);
  for (int k = 0; k < kElements; ++k) {
    SM_ELEMENT_D(matrix, k, k) = -given->work.rate[static_cast<std::size_t>(k)];
  }
  return 0;
}

void check(int status) {
  if (status < 0) {
    throw std::runtime_error("CVODE gave up");
  }
}

// All that CVODE allocates, given back in the order that it asks for.
class Solver {
 public:
  explicit Solver(Task& task) {
    check(SUNContext_Create(nullptr, &context_));
    state_ = N_VNew_Serial(kElements, context_);
    N_VConst(0.0, state_);
    memory_ = CVodeCreate(CV_BDF, context_);
    check(CVodeInit(memory_, rates, 0.0, state_));
    check(CVodeSStolerances(memory_, kRelativeTolerance, kAbsoluteTolerance));
    check(CVodeSetUserData(memory_, &task));
    matrix_ = SUNDenseMatrix(kElements, kElements, context_);
    solver_ = SUNLinSol_Dense(state_, matrix_, context_);
    check(CVodeSetLinearSolver(memory_, solver_, matrix_));
    check(CVodeSetJacFn(memory_, jacobian));
    check(CVodeSetMaxNumSteps(memory_, 100000));
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    CVodeFree(&memory_);
    SUNLinSolFree(solver_);
    SUNMatDestroy(matrix_);
    N_VDestroy(state_);
    SUNContext_Free(&context_);
  }

  // The sum of forces at a time that no step may go beyond, as the velocity changes there.
  double advanceTo(double time) {
    check(CVodeSetStopTime(memory_, time));
    realtype reached = 0.0;
    check(CVode(memory_, time, state_, &reached, CV_NORMAL));
    const double* force = N_VGetArrayPointer(state_);
    return std::accumulate(force, force + kElements, 0.0);
  }

 private:
  SUNContext context_ = nullptr;
  N_Vector state_ = nullptr;
  void* memory_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
};

}  // namespace

void cvodeBackwardDifferentiation(const PeerWork& work, std::vector<double>& force) {
  Task task{work, 0.0};
  Solver solver(task);
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    task.velocity = work.velocity(i);
    force[i] = solver.advanceTo(static_cast<double>(i) * work.dt);
  }
}

}  // namespace rubber_suspension::benchmark
