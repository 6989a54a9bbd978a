// What is known of pairs of bodies from step to step: where they touch, and what impulses went through each contact.
//
// A pair lives from the step in which the broad phase first names it to that in which it does not. Impulses are kept by the contact's id
// (contact_manifold.h) and along the world's axes, so they serve as a first guess however the contacts are listed and the normal turns.
//
// Thread: the world loop; different pairs from different threads. Cost: two numbers compared a pair; no allocation.
#pragma once

#include "haptics/collision/broad_phase.h"
#include "haptics/collision/contact_manifold.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// What a contact's impulse was.
struct ContactMemory {
    std::uint32_t id = 0;
    Vector3 impulse_W{Vector3::Zero()};  ///< on the pair's first body, N s
    bool slides = false;
};

struct ContactPair {
    BodyPair bodies{};
    ContactManifold manifold{};
    std::array<ContactMemory, kMostContacts> memories{};
    int n_memories = 0;
    // What was found of the step ahead (dynamics/contacts_ahead.h).
    double meet_s = 0.0;   ///< the manifold is that of the bodies so much later; 0: as they are
    bool passes = false;   ///< they are near each other, but their ways do not meet
    bool is_first = true;  ///< neither body meets another before

    /// None for a contact that is new.
    [[nodiscard]] const ContactMemory* recall(std::uint32_t id) const noexcept {
        for (int i = 0; i < n_memories; ++i) {
            if (memories[static_cast<std::size_t>(i)].id == id) {
                return &memories[static_cast<std::size_t>(i)];
            }
        }
        return nullptr;
    }
    void forget() noexcept { n_memories = 0; }
    void remember(const ContactMemory& memory) noexcept {
        if (n_memories < kMostContacts) {
            memories[static_cast<std::size_t>(n_memories++)] = memory;
        }
    }
};

class ContactPairs {
  public:
    explicit ContactPairs(int max_pairs);

    /// Keeps the pairs named, in their order, forgets the others and begins those that are new. `pairs` ascend, as `BroadPhase` gives
    /// them; those beyond the most are left out.
    void update(std::span<const BodyPair> pairs) noexcept;
    [[nodiscard]] int count() const noexcept { return static_cast<int>(used_.count()); }
    /// From 0 to count - 1; stays where it is in memory while the pair lives.
    [[nodiscard]] ContactPair& at(int i) noexcept { return slots_[used_[to_index(i)]]; }
    [[nodiscard]] const ContactPair& at(int i) const noexcept { return slots_[used_[to_index(i)]]; }

  private:
    static std::size_t to_index(int i) noexcept { return static_cast<std::size_t>(i); }

    std::vector<ContactPair> slots_;
    BoundedList<std::uint32_t> free_;
    BoundedList<std::uint32_t> used_;
    BoundedList<std::uint32_t> before_;  // those of the last update
};

}  // namespace fulcrum
