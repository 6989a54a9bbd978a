// Where two bodies made of contact levels are near each other, as finely as can be felt.
//
// Pairs of nodes are followed from both roots down. A pair (a, b) with hulls g apart
//   is left     where g > d + h_a + h_b: no triangle below a is within d of one below b
//   is a contact where its detail cannot be felt, and g - u_a - u_b <= d, which is minus its depth:
//                  s*_ab = max(phi_a, phi_b) / max(D_a, D_b) <= s0          phi = s / r^2, see contact_levels.h
//               or where both are leaves. A volume of detail phi, spread over the contact area D, is a layer s* thick: that is the error of the
//               contact, metres
//   is refined  else: of the two the one that only bounds, then that of more phi, gives way to its children
// With a budget instead of a tolerance pairs are refined in the order of s*, the worst first, until the time is up; what is left then is a
// contact as it is. Nodes that only bound are refined whatever it takes: the time may be overrun by that, which is told.
//
// Coherence: the tree of pairs is kept. How far the tool has moved at most since a pair was left is the sum of |dx| + 2 sin(turn / 2) reach;
// until that has used up g - (d + h_a + h_b) the pair is not looked at, nor is one above it whose pairs are all left. Then the last
// separating direction is tried before GJK. A pair all of whose children are left is tried again itself, so the front rises too.
//
//   normal   from a's to b's nearest point, or where the tool's piece lies behind the object's, as the mean normals of both say, against it. Where
//            the hulls meet: of the pieces' mean normals, their difference, and where both pieces are round, the way of least translation, the
//            one of least depth. A contact whose normal no triangle beside the pieces has, within 15 degrees, is none: it is a neighbour's
//   points   the nearest, and of pieces larger than `spread_m` up to four corners of each that are near too, far from each other
// Thin pieces that are behind each other by more than d do not know of each other: what is deeper than d inside is found where surfaces cross.
//
// Thread: one at a time. Cost: some 0.5 us a pair that is looked at, 1 to 3 us a contact; no allocation.
// Source: M. Otaduy, M. Lin 2003, Sensation preserving simplification for haptic rendering, SIGGRAPH, section 5 (their s* and s0, their order for a
// budget); the front as in S. Ehmann, M. Lin 2001, with distances for expiry.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/levels/contact_levels.h"

#include <array>
#include <memory>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct LevelPairSettings {
    double tolerance_m = 0.0;  ///< s0, 0 to 1; 0: as fine as the meshes
    /// 0: no budget; else the tolerance is as fine as the time allows, but not finer than `tolerance_m`. 0 to 1e6.
    double budget_us = 0.0;
    double spread_m = 4.0e-3;     ///< between the points of one pair, 1e-6 to 10
    int most_pairs = 1 << 16;     ///< kept at a time, 64 to 2^24; 48 bytes each
    int most_contacts = 1 << 13;  ///< 1 to 2^20
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const LevelPairSettings& settings);

struct LevelContact {
    Vector3 point_O{Vector3::Zero()};    ///< on the tool
    Vector3 normal_O{Vector3::UnitY()};  ///< unit, out of the object
    double depth_m = 0.0;                ///< below 0: so far apart
    double error_m = 0.0;                ///< s*
};

/// How a question went.
struct LevelAnswer {
    double nearest_m =
        0.0;               ///< least distance of the contacts' hulls; infinite where there are none
    double error_m = 0.0;  ///< the greatest s* of what may be a contact
    double deviation_m = 0.0;  ///< the greatest s_a + s_b of these
    int n_looked_at = 0;       ///< pairs whose distance was asked for
    int n_kept = 0;            ///< pairs of the tree
    bool is_late = false;      ///< longer than the budget
    bool is_cut =
        false;  ///< more pairs or contacts than there is room for: some are coarser, or left out
};

class LevelPairs {
  public:
    /// Refuses null ones, levels made for different d, and settings that `validate` does.
    [[nodiscard]] static Expected<std::unique_ptr<LevelPairs>> create(
        std::shared_ptr<const ContactLevels> object, std::shared_ptr<const ContactLevels> tool,
        const LevelPairSettings& settings = {});

    /// Where the tool at `X_OT` is nearer than `within_m`, not above what the levels were made for, or inside. A pose that is not finite has
    /// no contacts.
    LevelAnswer find(const Pose& X_OT, double within_m) noexcept;
    /// Of the last question.
    [[nodiscard]] std::span<const LevelContact> contacts() const noexcept {
        return contacts_.all();
    }
    /// Forgets the tree: the next question begins at the roots.
    void clear() noexcept;
    [[nodiscard]] const ContactLevels& object() const noexcept { return *object_; }
    [[nodiscard]] const ContactLevels& tool() const noexcept { return *tool_; }
    /// With both bodies' levels.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    static constexpr std::int32_t kNone = -1;
    struct Pair {
        std::int32_t object = 0;
        std::int32_t tool = 0;
        std::int32_t first_child = kNone;
        std::int32_t next = kNone;  // beside it, or in the list of free ones
        double until_m = 0.0;       // of motion: not looked at before
        float error_m = 0.0F;
        std::array<float, 3> axis{0.0F, 1.0F, 0.0F};  // last normal, frame O
    };
    // A pair that waits to be opened, the worst first.
    struct Waiting {
        float error_m;
        std::int32_t pair;
        bool operator<(const Waiting& other) const noexcept {
            return error_m != other.error_m ? error_m < other.error_m : pair > other.pair;
        }
    };
    // Where the tool is, while a question is answered.
    struct Place {
        Matrix3 turn{Matrix3::Identity()};
        Vector3 shift{Vector3::Zero()};
        double within_m = 0.0;
    };

    LevelPairs(std::shared_ptr<const ContactLevels> object,
               std::shared_ptr<const ContactLevels> tool, const LevelPairSettings& settings);

    void follow_motion(const Pose& X_OT, double within_m) noexcept;
    [[nodiscard]] Pair& pair(std::int32_t at) noexcept {
        return pairs_[static_cast<std::size_t>(at)];
    }
    [[nodiscard]] std::int32_t make_pair(std::int32_t object, std::int32_t tool) noexcept;
    void free_children(std::int32_t at) noexcept;
    [[nodiscard]] float compute_error_m(std::int32_t object, std::int32_t tool) const noexcept;
    void wait(std::int32_t at) noexcept;
    [[nodiscard]] std::int32_t take_waiting() noexcept;
    void open(std::int32_t at, LevelAnswer& answer) noexcept;
    [[nodiscard]] bool is_time_up(double began_s, const LevelAnswer& answer) const noexcept;
    [[nodiscard]] bool is_fine_enough(const Pair& one) const noexcept;
    [[nodiscard]] bool is_bound_only(const Pair& one) const noexcept;
    [[nodiscard]] bool divide(std::int32_t at) noexcept;
    void wait_for_children(std::int32_t at) noexcept;
    // Asks for the distance; true where it is left.
    bool is_left(std::int32_t at, HullPair& found, LevelAnswer& answer) noexcept;
    void close(std::int32_t at, LevelAnswer& answer) noexcept;
    void rise(LevelAnswer& answer) noexcept;
    void add_contacts(const Pair& one, const HullPair& found, LevelAnswer& answer) noexcept;

    std::shared_ptr<const ContactLevels> object_;
    std::shared_ptr<const ContactLevels> tool_;
    LevelPairSettings settings_;
    std::vector<Pair> pairs_;
    std::int32_t free_ = kNone;
    std::int32_t n_kept_ = 0;
    std::int32_t root_ = kNone;
    BoundedList<Waiting> waiting_;
    BoundedList<std::int32_t> opened_;
    BoundedList<LevelContact> contacts_;
    Place place_;
    Pose last_X_OT_;
    double last_within_m_ = -1.0;
    double moved_m_ = 0.0;
};

}  // namespace fulcrum
