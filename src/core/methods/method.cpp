#include "methods/method.h"

#include "methods/exact.h"
#include "methods/fixed_step.h"
#include "methods/impulse.h"

namespace ping_pong
{
namespace
{
void reserveNothing(WorldWithWindows&, std::size_t) {}
void startAtOnce(WorldWithWindows&) {}
void goOn(WorldWithWindows&, std::size_t) {}

// Steps look at each ball as it is: nothing is planned that a change could make void.
constexpr MethodFunctions fixedStep(void (*advance)(WorldWithWindows&, double))
{
  return {reserveNothing, startAtOnce, goOn, advance};
}

constexpr MethodFunctions kEulerExplicit = fixedStep(runEulerExplicit);
constexpr MethodFunctions kEulerSemiImplicit = fixedStep(runEulerSemiImplicit);
constexpr MethodFunctions kVerlet = fixedStep(runVerlet);
constexpr MethodFunctions kRk4 = fixedStep(runRk4);
constexpr MethodFunctions kImpulse = {reserveImpulse, startImpulse, impulseBallChanged, runImpulse};
constexpr MethodFunctions kExact = {reserveExact, startExact, exactBallChanged, runExact, true};
constexpr MethodFunctions kRk4Located = {reserveExact, startExact, exactBallChanged, runExact, true, true};
}  // namespace

const MethodFunctions& functionsOf(Method method)
{
  switch (method)
  {
    case Method::EulerExplicit:
      return kEulerExplicit;
    case Method::EulerSemiImplicit:
      return kEulerSemiImplicit;
    case Method::Verlet:
      return kVerlet;
    case Method::Rk4:
      return kRk4;
    case Method::Rk4Located:
      return kRk4Located;
    case Method::Impulse:
      return kImpulse;
    case Method::Exact:
    case Method::Auto:
      break;
  }
  return kExact;
}
}  // namespace ping_pong
