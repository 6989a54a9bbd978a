// The contact model that one thread hands to another: clusters, and where the tool was when they were found.
//
// Thread: the contact thread fills one, the haptic thread reads it. Cost: a copy, 6 kB.
#pragma once

#include "haptics/coupling/tool_coupling.h"
#include "haptics/handover/latest_value.h"
#include "haptics/handover/messages.h"
#include "haptics/tool/implicit_penalty/contact_clusters.h"

#include <array>
#include <cstdint>

namespace fulcrum {

/// A cluster as the haptic loop learns of it.
struct ToldContact {
    std::int32_t object = 0;  ///< in the plan's order
    ContactCluster cluster{};
    Pose X_OT{};         ///< where the tool was then
    Twist velocity_O{};  ///< of the tool's centre of mass and its spin, as the object saw it
};

/// One state of contact, of all objects together.
struct ContactModel {
    double stamp_s = -1.0;           ///< of the place that it was found for; below 0: none yet
    std::uint32_t n_placements = 0;  ///< as that place had it
    std::int32_t n_near = 0;         ///< contacts before they were clustered
    bool is_cut = false;  ///< coarser than asked for, or not all of it, for want of time or room
    std::int32_t n = 0;
    std::array<ToldContact, kMostClusters> contacts{};

    [[nodiscard]] std::span<const ToldContact> all() const noexcept {
        return {contacts.data(), static_cast<std::size_t>(n)};
    }
};

/// Where the tool and the objects are: what the contact thread fetches.
struct ToolPlace {
    double stamp_s = -1.0;  ///< below 0: nowhere yet
    std::uint32_t n_placements =
        0;               ///< grows when the tool was put elsewhere: what was known of it is void
    MovingFrame tool{};  ///< centre of mass, principal axes
    std::int32_t n_objects = 0;
    std::array<MovingFrame, kMaxSolids> objects{};
};

/// Between the haptic thread and the contact thread.
struct ContactChannels {
    LatestValue<ToolPlace> place;     ///< haptic loop; contact loop
    LatestValue<ContactModel> model;  ///< contact loop; haptic loop
};

}  // namespace fulcrum
