// Where two bodies made of contact levels are near each other, as finely as can be felt.
//
// Pairs of nodes are followed from both roots down. A pair (a, b)
//   is left      where nothing below a is within d of anything below b (pair_tree.h)
//   is a patch   where what is below it is felt as one: where both are leaves, or
//                  s*_ab = max(phi_a, phi_b) / max(D_a, D_b) <= s0                     phi = s / r^2, see contact_levels.h
//                A volume of detail phi, spread over the contact area D, is a layer s* thick. This is the source's condition. Ours adds
//                  s_a + s_b <= min(s0, d), and all of one of them looks one way within 60 degrees
//   is refined   else: of the two the one that only bounds, then that of more phi, gives way to its children
// A patch tells of its two hulls, in one piece of work, whatever is below. These hold the meshes below them and stand out of them by s, as measured at
// 3 to 12 samples a face (contact_levels.h): distance of the meshes - (s_a + s_b) <= distance told <= distance of the meshes, the first as measured
// and a tolerance lets nothing through: it moves surfaces out, by s0 or d as measured. A tool on a coupling of k N/m is so felt off by k s0 where it is
// pressed on something flat; where it snaps from place to place by more. Where hulls overlap depth is that of the hulls.
//
// With a budget what was deepest in the last question is refined first, then what has the greatest s*, as long as there is time to tell a patch of
// each that waits. Then of each, again the deepest first, one patch is told: the pair itself where s_a + s_b is within max(s0, d), else what was
// deepest below it the last time, else where spheres round the nodes are nearest. Each piece of work, a distance or a patch, is begun only within the
// budget, but for the first ways down, of twice as many pairs as there are levels at most, so that something is told. What was left out is counted,
// and how deep it may be is told. Pairs stay from question to question: where the tool rests, the next one goes on from here.
//
//   normal   from a's to b's nearest point, or where the tool's piece lies behind the object's, as the mean normals of both say, against it, if
//            what looks one way of them is no thicker than d: a thicker piece may reach to a hole's wall from the body's other side. Where
//            the hulls meet: the way of least translation, where triangles beside the pieces look so; else of the pieces' mean normals and
//            their difference the one of least depth, unless that is four times as deep. A contact whose normal no triangle beside the pieces
//            has, within 15 degrees, is none: it is a neighbour's
//   points   of pieces larger than `spread_m` up to four corners of each that are near, the deepest and such as are far from each other, for
//            corners stay where they are while faces rock on each other; and the nearest, where no corner near it, nor three anywhere, are as deep
// Thin pieces that are behind each other by more than d do not know of each other: what is deeper than d inside is found where surfaces cross.
//
// Thread: one at a time. Cost: some 0.5 us a pair that is looked at, 1 to 3 us a contact; no allocation.
// Source: M. Otaduy, M. Lin 2003, Sensation preserving simplification for haptic rendering, SIGGRAPH, section 5 (their s* and s0, their order for a
// budget). There contact is between hulls of simplified pieces, which teeth and thin walls let through.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/base/clock.h"
#include "haptics/levels/pair_contacts.h"
#include "haptics/levels/pair_tree.h"

#include <memory>
#include <tuple>
#include <vector>

namespace fulcrum {

/// Fixed at load.
struct LevelPairSettings {
    double tolerance_m = 0.0;  ///< s0, 0 to 1; 0: as fine as the meshes
    /// The source's condition alone, without the two that bound how much too near a patch is told: to be held against ours.
    bool is_as_source = false;
    /// 0: no budget; else the tolerance is as fine as the time allows, but not finer than `tolerance_m`. 0 to 1e6.
    double budget_us = 0.0;
    double spread_m = 4.0e-3;     ///< between the points of one pair, 1e-6 to 10
    int most_pairs = 1 << 16;     ///< kept at a time, 64 to 2^24; 64 bytes each
    int most_contacts = 1 << 13;  ///< 1 to 2^20
    /// What the budget is kept by, seconds; called once a piece of work.
    double (*now_s)() noexcept = &monotonic_now_s;
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const LevelPairSettings& settings);

struct LevelContact {
    Vector3 point_O{Vector3::Zero()};    ///< on the tool
    Vector3 normal_O{Vector3::UnitY()};  ///< unit, out of the object
    double depth_m = 0.0;                ///< below 0: so far apart
    double error_m = 0.0;  ///< s_a + s_b, as measured: by how much it may be told too near
};

/// How a question went.
struct LevelAnswer {
    /// Least distance of pieces that are contacts; infinite where there are none.
    double nearest_m = 0.0;
    double error_m = 0.0;  ///< the greatest of the contacts'
    int n_looked_at = 0;   ///< pairs whose distance was asked for
    int n_kept = 0;        ///< pairs of the tree
    int n_patches = 0;     ///< pairs that were told of
    // Where time was up. Of hulls that are apart a contact that pushes by k N/m from d outside on pushes too hard by k error_m at most. One that was
    // left out would push by k (d + its depth): that is no more than d where one lies behind the other, else left_m by the shortest
    // way out, and four times that where another way is told (pair_contacts.cpp).
    int n_coarser = 0;  ///< patches told coarser than was asked for
    int n_left = 0;     ///< pairs left out
    double left_m =
        0.0;  ///< how far the deepest of what was left out may have to be moved to part,
              ///< by spheres round its hulls
    bool is_late = false;  ///< longer than the budget
    /// More pairs or contacts than there is room for: some are left out.
    bool is_cut = false;
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
    /// Of the questions from now on, in the range of the settings'; 0: none.
    void set_budget_us(double budget_us) noexcept { settings_.budget_us = budget_us; }
    /// Forgets the tree: the next question begins at the roots.
    void clear() noexcept { tree_.clear(); }
    [[nodiscard]] const ContactLevels& object() const noexcept { return tree_.object(); }
    [[nodiscard]] const ContactLevels& tool() const noexcept { return tree_.tool(); }
    /// With both bodies' levels.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // A pair that waits to be opened: what was deepest the last time first, then the worst.
    struct Waiting {
        float told_m;
        float error_m;
        std::int32_t pair;
        bool operator<(const Waiting& other) const noexcept {
            return std::tie(told_m, error_m, other.pair) <
                   std::tie(other.told_m, other.error_m, pair);
        }
    };
    LevelPairs(std::shared_ptr<const ContactLevels> object,
               std::shared_ptr<const ContactLevels> tool, const LevelPairSettings& settings);

    void wait(std::int32_t pair) noexcept;
    [[nodiscard]] std::int32_t take_waiting() noexcept;
    void open(std::int32_t pair, LevelAnswer& answer) noexcept;
    [[nodiscard]] double spent_us() const noexcept;
    [[nodiscard]] bool is_time_up() const noexcept;
    [[nodiscard]] double compute_off_m(const NodePair& nodes) const noexcept;  // s_a + s_b
    [[nodiscard]] bool is_fine_enough(const PairTree::Pair& one) const noexcept;
    void conclude(LevelAnswer& answer) noexcept;
    enum class WayDown { is_told, is_dead_end, has_no_time };
    WayDown go_down(std::int32_t top, int& steps, LevelAnswer& answer) noexcept;
    WayDown tell_as_it_is(std::int32_t top, std::int32_t pair, LevelAnswer& answer) noexcept;
    [[nodiscard]] bool is_usable(const PairTree::Pair& one) const noexcept;
    [[nodiscard]] std::int32_t find_deepest_child(std::int32_t pair) const noexcept;
    void leave(std::int32_t pair, LevelAnswer& answer) noexcept;
    void tell(std::int32_t pair, LevelAnswer& answer) noexcept;
    void learn(const LevelAnswer& answer) noexcept;

    LevelPairSettings settings_;
    PairTree tree_;
    double began_s_ = 0.0;
    double each_us_;  // what a patch takes when time is up
    BoundedList<Waiting> waiting_;
    BoundedList<std::int32_t> opened_;
    BoundedList<LevelContact> contacts_;
};

}  // namespace fulcrum
