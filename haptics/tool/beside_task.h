// Work that a tool may have beside the haptic steps: finding contact, which takes as long as it takes.
//
//   haptic step   tells where tool and objects are -> goes on with the newest answer -> force
//   beside        takes the newest place -> one round of work -> tells its answer
// Both ways are newest values (handover/latest_value.h): neither side waits, and what is not fetched in time is overwritten.
//
// Thread: `run_once` and `step` on one thread beside the haptic one (loop/beside_thread.h), or by turns with it. Cost: the work's; no allocation.
#pragma once

#include "haptics/base/periodic_task.h"
#include "haptics/tool/contact_age.h"

namespace fulcrum {

/// Told when work that could run beside begins and ends within a step, for who measures it.
class RoundListener {
  public:
    virtual void begins_round() noexcept = 0;
    virtual void ended_round() noexcept = 0;

  protected:
    RoundListener() = default;
    RoundListener(const RoundListener&) = default;
    RoundListener& operator=(const RoundListener&) = default;
    ~RoundListener() = default;
};

class BesideTask : public PeriodicTask {
  public:
    /// One round; false where nothing new had been told, so that nothing was done.
    virtual bool run_once() noexcept = 0;

    /// The same, for who calls it again and again.
    void step(double /*now_s*/) noexcept final { (void)run_once(); }
    /// It drives nothing: the haptic loop lets go by itself (contact_age.h).
    void silence(double /*now_s*/) noexcept final {}
};

/// What a solver (tool_solver.h) that has such work is besides.
class BesideSolver {
  public:
    BesideSolver(const BesideSolver&) = delete;
    BesideSolver& operator=(const BesideSolver&) = delete;

    /// What is to run beside the steps; lives as long as the solver. Null where it was built to do all in its steps.
    [[nodiscard]] virtual BesideTask* beside() noexcept = 0;
    /// How old what the last step knew was. A tool whose contacts are lost is to be placed anew.
    [[nodiscard]] virtual const ContactAge& contact_age() const noexcept = 0;
    /// From now on told of such work that steps do themselves, on their thread; null: nobody is.
    virtual void listen_to_rounds(RoundListener* listener) noexcept = 0;

  protected:
    BesideSolver() = default;
    BesideSolver(BesideSolver&&) = default;
    BesideSolver& operator=(BesideSolver&&) = default;
    ~BesideSolver() = default;
};

}  // namespace fulcrum
