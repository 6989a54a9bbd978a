#include "haptics/loop/solid_push.h"

#include "haptics/math/length.h"

#include <algorithm>

namespace fulcrum {
namespace {

// What planes hold of the coupling's stretch.
struct Hold {
    bool touches = false;
    Vector3 push_W = Vector3::Zero();  // along the planes' normals
    Vector3 drag_W = Vector3::Zero();

    void add(const SolidTouch& touch) noexcept {
        touches = true;
        push_W += touch.push_m * touch.normal_W;
        drag_W += touch.drag_W;
    }
};

}  // namespace

PushShare limit_push(const MostFelt& most, SolidPush& push) noexcept {
    const auto find_share = [](double asked, double allowed) {
        return asked > allowed ? allowed / asked : 1.0;
    };
    const double share = find_share(compute_length(push.force_W), most.force_N);
    push.force_W *= share;
    const double couple =
        std::min(share, find_share(compute_length(push.couple_W), most.torque_Nm));
    push.couple_W *= couple;
    return {share, couple};
}

SolidPush compute_solid_push(const ProxyContact& contact, std::int32_t solid,
                             const Vector3& force_W, double cursor_m) noexcept {
    Hold here;
    Hold all;
    bool alone = contact.solid == solid;
    for (const SolidTouch& touch : contact.active()) {
        all.add(touch);
        if (touch.solid == solid) {
            here.add(touch);
        }
        alone = alone && touch.solid == solid;
    }
    SolidPush push;
    push.touches = here.touches || contact.solid == solid;
    push.at_W = contact.position_W;
    if (!push.touches) {
        return push;
    }
    // Along that solid's planes together.
    push.normal_W = -(alone ? contact.normal_W : compute_direction(here.push_W));
    push.at_W += cursor_m * push.normal_W;
    if (alone) {
        push.force_W = -force_W;
    } else if (const double stretch_m = compute_length(Vector3(all.push_W + all.drag_W));
               stretch_m > 0.0) {
        push.force_W = -compute_length(force_W) / stretch_m * (here.push_W + here.drag_W);
    }
    return push;
}

}  // namespace fulcrum
