// Work that is done again and again at a fixed rate: a haptic loop, a world loop. A thread or a
// virtual clock calls it.
#pragma once

namespace fulcrum {

class PeriodicTask {
  public:
    PeriodicTask() = default;
    PeriodicTask(const PeriodicTask&) = delete;
    PeriodicTask& operator=(const PeriodicTask&) = delete;
    virtual ~PeriodicTask() = default;

    /// One round at `now_s` seconds of the run's clock, which never goes back.
    virtual void step(double now_s) = 0;
    /// The last call, when the task is stopped or has failed: whatever it drives is left without
    /// force.
    virtual void silence(double now_s) noexcept = 0;
};

}  // namespace fulcrum
