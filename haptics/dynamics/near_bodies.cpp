#include "haptics/dynamics/near_bodies.h"

#include "haptics/collision/sampled_contacts.h"
#include "haptics/dynamics/rigid_reach.h"

#include <algorithm>
#include <limits>

namespace fulcrum {
namespace {

// Half the extent of a shape along the world's axes, about its own origin.
Vector3 find_extent(const RigidWorldBody& body) noexcept {
    const ConvexCore& core = body.shape.core;
    const Matrix3& turn = body.place.turn_WB;
    const Vector3 round = Vector3::Constant(core.radius_m);
    switch (core.kind) {
        case ConvexCore::Kind::box:
            return turn.cwiseAbs() * core.half_m;
        case ConvexCore::Kind::segment:
            return core.half_m.y() * turn.col(1).cwiseAbs() + round;
        case ConvexCore::Kind::cylinder: {
            const Vector3 across =
                (Vector3::Ones() - turn.col(1).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
            return core.half_m.y() * turn.col(1).cwiseAbs() + core.half_m.x() * across;
        }
        case ConvexCore::Kind::cloud:
            return Vector3::Constant(body.shape.bounding_radius_m);
        default:
            return round;
    }
}

Box find_box(const RigidWorldBody& body) noexcept {
    if (!body.is_present) {
        constexpr double kNowhere = std::numeric_limits<double>::max();
        return {Vector3::Constant(kNowhere), Vector3::Constant(kNowhere)};
    }
    if (body.shape.kind == ContactShape::Kind::half_space) {
        constexpr double kNoEnd = std::numeric_limits<double>::infinity();
        Box box{Vector3::Constant(-kNoEnd), Vector3::Constant(kNoEnd)};
        // Level ground ends at its plane: what is high above is not near it.
        if (body.place.turn_WB(1, 1) >= 1.0) {
            box.upper.y() = body.place.position_W.y() + body.reach_m;
        }
        return box;
    }
    const Vector3 half = find_extent(body) + Vector3::Constant(body.reach_m);
    return {body.place.position_W - half, body.place.position_W + half};
}

void grow(const Vector3& by_m, Box& box) noexcept {
    box.lower += by_m.cwiseMin(0.0);
    box.upper += by_m.cwiseMax(0.0);
}

}  // namespace

void NearBodies::place(double reach_s, RigidScene& scene) noexcept {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        RigidWorldBody& body = scene.bodies[i];
        if (body.is_still() && is_placed_) {
            continue;
        }
        place_body(body);
        find_reach(body, gravity_W_, reach_s);
        boxes_[i] = find_box(body);
        reaches_m_[i] = body.reach_m;
        moves_[i] = body.moves && body.is_present ? 1 : 0;
    }
    is_placed_ = true;
}

bool NearBodies::is_joined(const BodyPair& pair) const noexcept {
    return !joined_.empty() && std::binary_search(joined_.begin(), joined_.end(), pair);
}

bool NearBodies::is_known(const BodyPair& pair) const noexcept {
    const auto near = near_.all();
    return is_joined(pair) || std::binary_search(near.begin(), near.end(), pair);
}

void NearBodies::find(RigidScene& scene) noexcept {
    near_.clear();
    n_dropped_ = 0;
    for (BodyPair pair : broad_phase_.find_pairs(boxes_.all(), moves_.all(), reaches_m_.all())) {
        if (is_joined(pair)) {
            continue;
        }
        const int n = scene.meets_in_patches(pair) ? kMostPatches : 1;
        for (pair.patch = 0; pair.patch < n; ++pair.patch) {
            n_dropped_ += near_.add(pair) ? 0 : 1;
        }
    }
    n_dropped_ += broad_phase_.n_dropped();
    scene.pairs.update(near_.all());
}

// Boxes are grown for good: what has a way is placed anew in the next step.
std::span<const BodyPair> NearBodies::find_on_ways(std::span<const Twist> ways_W,
                                                   const RigidScene& scene) noexcept {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        grow(ways_W[i].linear, boxes_[i]);
        const double turned_m = compute_length(ways_W[i].angular) * scene.bodies[i].lever_m;
        grow(Vector3::Constant(turned_m), boxes_[i]);
        grow(Vector3::Constant(-turned_m), boxes_[i]);
    }
    const auto pairs = broad_phase_.find_pairs(boxes_.all(), moves_.all());
    n_dropped_ += broad_phase_.n_dropped();
    return pairs;
}

}  // namespace fulcrum
