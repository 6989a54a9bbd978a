// The grip on an arm's handle, slower than the arm: its turn and buttons as they were last told.
//
// The first that is awake is kept to, so that two on one desk do not take turns; where it is away or asleep its turn stays and no button
// is down. Without any: not turned.
//
// Thread: the port's. Cost: a comparison a grip.
// Source: docs.haply.co/inverseSDK/service/realtime/websocket-protocol; 50 to 60 a second by chai3d_haply.
#pragma once

#include "runtime/arms/haply/haply_message.h"

namespace fulcrum::runtime {

class GripHold {
  public:
    void take(const std::vector<HaplyGrip>& grips) {
        buttons_ = 0;
        for (const HaplyGrip& grip : grips) {
            if (!grip.is_awake || (!id_.empty() && grip.id != id_)) {
                continue;
            }
            id_ = grip.id;
            buttons_ = grip.buttons;
            orientation_A_ = grip.orientation_A.value_or(orientation_A_);
            return;
        }
    }
    [[nodiscard]] const Quaternion& orientation_A() const noexcept { return orientation_A_; }
    [[nodiscard]] std::uint32_t buttons() const noexcept { return buttons_; }

  private:
    std::string id_;
    Quaternion orientation_A_{Quaternion::Identity()};
    std::uint32_t buttons_ = 0;
};

}  // namespace fulcrum::runtime
