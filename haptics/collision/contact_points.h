// Which of a pair's possible contacts are kept, and which of them were there before. See find_contacts.h for the law.
//
// Thread: that which steps the pair. Cost: some 50 ns for a face on a face; no allocation.
#pragma once

#include "haptics/collision/contact_manifold.h"
#include "haptics/collision/contact_shadow.h"

#include <array>

namespace fulcrum {

/// A place where a pair may touch.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): always made whole
struct ContactCandidate {
    Vector3 place;  ///< axes W, from the pair's origin
    double gap_m;
    std::uint16_t feature;
};

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
struct ContactCandidates {
    static constexpr int kMost = kMostShared;
    std::array<ContactCandidate, kMost> places;
    int count = 0;

    void add(const ContactCandidate& candidate) noexcept {
        if (count < kMost) {
            places[static_cast<std::size_t>(count++)] = candidate;
        }
    }
};

/// From the pair's origin to the world and to both bodies.
struct ContactTurn {
    Vector3 origin_W;
    const ContactPlace& first;
    const ContactPlace& second;
};

/// Writes the points of `manifold`, whose old ones tell what was there. `size_m`: the smaller body's.
void choose_contacts(const ContactCandidates& candidates, const Vector3& normal_W, double size_m,
                     const ContactTurn& turn, ContactManifold& manifold) noexcept;

}  // namespace fulcrum
