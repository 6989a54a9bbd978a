// All that a hand's loop reads and writes besides its device, with what the plan's effects add to it.
#pragma once

#include "haptics/flight/kite_loop.h"
#include "haptics/handover/axle_messages.h"
#include "haptics/handover/channels.h"
#include "haptics/handover/rigid_messages.h"
#include "haptics/loop/haptic_plan.h"

#include <memory>

namespace fulcrum::runtime {

class HandChannels final : public HapticChannels {
  public:
    /// Before the loop is made. `has_rigid`: the run has a world of rigid bodies.
    void add(const HapticPlan& plan, bool has_rigid) {
        make(!plan.axles.empty(), axle_channels_, axles);
        make(has_rigid, rigid_channels_, rigid);
        make(plan.line.has_value(), kite_channels_, kite);
    }

  private:
    template <class T>
    static void make(bool is_wanted, std::unique_ptr<T>& kept, T*& told) {
        if (is_wanted) {
            kept = std::make_unique<T>();
            told = kept.get();
        }
    }

    std::unique_ptr<AxleChannels> axle_channels_;
    std::unique_ptr<RigidChannels> rigid_channels_;
    std::unique_ptr<KiteChannels> kite_channels_;
};

}  // namespace fulcrum::runtime
