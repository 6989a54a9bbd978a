#include "haptics/point/friction_cone.h"

#include <algorithm>

namespace fulcrum {

FrictionCone::FrictionCone(std::unique_ptr<SurfaceObject> surface_object,
                           std::vector<FrictionLaw> laws, int max_rounds)
    : surface_object_(std::move(surface_object)),
      laws_(std::move(laws)),
      stuck_(laws_.size(), 1),
      max_rounds_(max_rounds) {
    contact_ = surface_object_->contact();
}

void FrictionCone::reset(const Vector3& hand_W) noexcept {
    surface_object_->reset(hand_W);
    std::ranges::fill(stuck_, char{1});
    contact_ = surface_object_->contact();
}

void FrictionCone::put_solid(std::size_t solid, const Pose& pose_W) noexcept {
    surface_object_->put_solid(solid, pose_W);
    contact_ = surface_object_->contact();
    if (solid < stuck_.size()) {
        stuck_[solid] = 1;
    }
}

const ProxyContact& FrictionCone::step(const Vector3& hand_W,
                                       std::span<const Pose> solid_poses_W) noexcept {
    surface_object_->carry(solid_poses_W);
    if (!hand_W.allFinite()) {
        return contact_;
    }
    const ProxyContact before = surface_object_->contact();
    Planes storage;
    const std::span<FrictionPlane> planes = hold(hand_W, storage);
    Vector3 drag_W = Vector3::Zero();
    for (const FrictionPlane& plane : planes) {
        drag_W += plane.drag;
    }
    contact_ = surface_object_->follow(hand_W + drag_W);
    if (contact_.n_constraints == 0) {
        // It slid off: there is nothing left to hold it back.
        contact_ = surface_object_->follow(hand_W);
        std::ranges::fill(stuck_, char{1});
        return contact_;
    }
    share_drag(before.active(), planes);
    return contact_;
}

// Solves friction at the planes that hold the surface object now.
std::span<FrictionPlane> FrictionCone::hold(const Vector3& hand_W, Planes& storage) noexcept {
    const ProxyContact& contact = surface_object_->contact();
    std::size_t n = 0;
    bool any = false;
    for (const SolidTouch& touch : contact.active()) {
        const auto solid = static_cast<std::size_t>(touch.solid);
        storage[n] = {.normal = touch.normal_W,
                      .point = contact.position_W,
                      .anchor = touch.anchor_W,
                      .law = laws_[solid],
                      .was_stuck = stuck_[solid] != 0};
        any = any || storage[n].law.any();
        ++n;
    }
    if (!any) {
        return {};
    }
    const std::span<FrictionPlane> planes(storage.data(), n);
    (void)solve_friction(hand_W, planes, max_rounds_);
    // A solid is stuck when all its planes are, and one that is not touched sticks at the next touch.
    std::ranges::fill(stuck_, char{1});
    for (std::size_t i = 0; i < n; ++i) {
        char& stuck = stuck_[static_cast<std::size_t>(contact.touches[i].solid)];
        stuck = stuck != 0 && planes[i].stuck ? 1 : 0;
    }
    return planes;
}

// The contact is the surface object's, seen from the goal: its normal is that of the planes alone, so the force may lean away
// from it, but never pulls. Each drag belongs to the solid that gave it, at whichever of its planes the surface object now lies.
void FrictionCone::share_drag(std::span<const SolidTouch> before,
                              std::span<const FrictionPlane> planes) noexcept {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const double coefficient = find_coefficient(planes[i]);
        SolidTouch* best = contact_.touches.data();
        int best_match = -1;
        for (std::int32_t k = 0; k < contact_.n_constraints; ++k) {
            SolidTouch& touch = contact_.touches[static_cast<std::size_t>(k)];
            const int match = touch.solid != before[i].solid       ? 0
                              : touch.feature != before[i].feature ? 1
                                                                   : 2;
            if (match > best_match) {
                best = &touch;
                best_match = match;
            }
            // The solid's matter is as rough at a plane that was only just met.
            if (match > 0) {
                touch.friction_coefficient = std::max(touch.friction_coefficient, coefficient);
            }
        }
        best->drag_W += planes[i].drag;
        best->friction_coefficient = std::max(best->friction_coefficient, coefficient);
        if (planes[i].law.viscous_ratio > 0.0) {
            best->viscous_m +=
                std::max(planes[i].drag.norm() - coefficient * planes[i].push_m, 0.0);
        }
    }
}

}  // namespace fulcrum
