// What hands and lessons do to the bodies of rigid_world.h: loads of the next step, and bodies that are put elsewhere, out or in.
#include "haptics/dynamics/rigid_world.h"
#include "haptics/dynamics/unit_pose.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

std::size_t to_place_of(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

}  // namespace

bool RigidWorld::may_load(std::int32_t index) const noexcept {
    return index >= 0 && index < n_bodies() && scene_.bodies[to_place_of(index)].moves &&
           scene_.bodies[to_place_of(index)].is_present;
}

void RigidWorld::push(std::int32_t index, const Wrench& wrench_W) noexcept {
    if (may_load(index)) {
        BodyLoads::push(wrench_W, scene_.body(index));
    }
}

void RigidWorld::hold(std::int32_t index, const BodyHold& hold) noexcept {
    if (may_load(index)) {
        scene_.loads.hold(hold, scene_.body(index));
    }
}

// What lay on it or hung from it falls.
void RigidWorld::wake_neighbours(std::int32_t index) noexcept {
    for (const Joint& joint : scene_.joints) {
        const std::int32_t other = joint.body_a == index   ? joint.body_b
                                   : joint.body_b == index ? joint.body_a
                                                           : -1;
        if (other >= 0) {
            scene_.bodies[to_place_of(other)].wake();
        }
    }
    for (int i = 0; i < scene_.pairs.count(); ++i) {
        const ContactPair& pair = scene_.pairs.at(i);
        if (pair.manifold.count > 0 &&
            (pair.bodies.first == index || pair.bodies.second == index)) {
            scene_.bodies[to_place_of(pair.bodies.first)].wake();
            scene_.bodies[to_place_of(pair.bodies.second)].wake();
        }
    }
}

void RigidWorld::set_present(std::int32_t index, bool is_present) noexcept {
    if (index < 0 || index >= n_bodies()) {
        return;
    }
    RigidWorldBody& body = scene_.bodies[to_place_of(index)];
    body.is_present = is_present;
    body.forget_loads();
    wake_neighbours(index);
    body.touch();  // its box is made anew, and what it comes to touch wakes
    moves_[to_place_of(index)] = body.moves && is_present ? 1 : 0;
}

void RigidWorld::place(std::int32_t index, const Pose& shape_W, const Twist& velocity_W) noexcept {
    const bool is_number = is_finite(shape_W) && has_turn(shape_W) &&
                           velocity_W.linear.allFinite() && velocity_W.angular.allFinite();
    if (index < 0 || index >= n_bodies() || !is_number) {
        return;
    }
    RigidWorldBody& body = scene_.bodies[to_place_of(index)];
    wake_neighbours(index);
    body.state.pose_W = with_unit_turn(shape_W) * body.X_PB.inverse();
    body.state.velocity_W = body.moves ? velocity_W : Twist{};
    body.forget_loads();
    body.touch();
}

}  // namespace fulcrum
