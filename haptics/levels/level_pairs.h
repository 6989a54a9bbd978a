// Where two bodies made of contact levels are near each other, as finely as can be felt.
//
// Pairs of nodes are followed from both roots down. A pair (a, b)
//   is left      where nothing below a is within d of anything below b (pair_tree.h)
//   is a patch   where what is below it is felt as one: where both are leaves, or
//                  s*_ab = max(phi_a, phi_b) / max(D_a, D_b) <= s0,  s_a + s_b <= s0       phi = s / r^2, see contact_levels.h
//                  the smaller one's radius <= s0, and all of one of them looks one way within 30 degrees
//                A volume of detail phi, spread over the contact area D, is a layer s* thick
//   is refined   else: of the two the one that only bounds, then that of more phi, gives way to its children
// A patch tells of the two pieces of the meshes below it that are nearest, by branch and bound, to a twentieth of s0; where one is inside, of all
// that are near, for which of them is the deepest no bound says. So what is told is of the meshes, never of what was
// simplified, and what is left out lies deeper than it nowhere: a tolerance thins contacts out, and lets nothing through.
// With a budget instead of a tolerance pairs are refined in the order of s*, the worst first, until the time is up; what is left then is a
// patch as it is. Where it is deep the time may be overrun, which is told.
//
// Coherence: the tree of pairs is kept, and of each patch which pieces were the nearest: the search begins there. So an answer may depend on the last
// one by the slack, and what is nearest does not flicker.
//
//   normal   from a's to b's nearest point, or where the tool's piece lies behind the object's, as the mean normals of both say, against it. Where
//            the hulls meet: the way of least translation, where triangles beside the pieces look so; else of the pieces' mean normals and
//            their difference the one of least depth, unless that is four times as deep. A contact whose normal no triangle beside the pieces
//            has, within 15 degrees, is none: it is a neighbour's
//   points   of pieces larger than `spread_m` up to four corners of each that are near, the deepest and such as are far from each other, for
//            corners stay where they are while faces rock on each other; and the nearest, where no corner near it, nor three anywhere, are as deep
// Thin pieces that are behind each other by more than d do not know of each other: what is deeper than d inside is found where surfaces cross.
//
// Thread: one at a time. Cost: some 0.5 us a pair that is looked at, 1 to 3 us a contact; no allocation.
// Source: M. Otaduy, M. Lin 2003, Sensation preserving simplification for haptic rendering, SIGGRAPH, section 5 (their s* and s0, their order for a
// budget). There contact is between the simplified hulls themselves: of teeth and thin walls these let each other through.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/levels/pair_contacts.h"
#include "haptics/levels/pair_tree.h"

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
    int most_pairs = 1 << 16;     ///< kept at a time, 64 to 2^24; 64 bytes each
    int most_contacts = 1 << 13;  ///< 1 to 2^20
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const LevelPairSettings& settings);

struct LevelContact {
    Vector3 point_O{Vector3::Zero()};    ///< on the tool
    Vector3 normal_O{Vector3::UnitY()};  ///< unit, out of the object
    double depth_m = 0.0;                ///< below 0: so far apart
    double error_m = 0.0;                ///< s* of the patch
};

/// How a question went.
struct LevelAnswer {
    double nearest_m =
        0.0;  ///< least distance of pieces that are contacts; infinite where there are none
    double error_m = 0.0;  ///< the greatest s* of a patch; infinite where time was up too early
    int n_looked_at = 0;   ///< pairs whose distance was asked for
    int n_kept = 0;        ///< pairs of the tree
    bool is_late = false;  ///< longer than the budget
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
    /// Of the questions from now on, in the range of the settings'; 0: none.
    void set_budget_us(double budget_us) noexcept { settings_.budget_us = budget_us; }
    /// Forgets the tree: the next question begins at the roots.
    void clear() noexcept { tree_.clear(); }
    [[nodiscard]] const ContactLevels& object() const noexcept { return tree_.object(); }
    [[nodiscard]] const ContactLevels& tool() const noexcept { return tree_.tool(); }
    /// With both bodies' levels.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // A pair that waits to be opened, the worst first.
    struct Waiting {
        float error_m;
        std::int32_t pair;
        bool operator<(const Waiting& other) const noexcept {
            return error_m != other.error_m ? error_m < other.error_m : pair > other.pair;
        }
    };
    // The nearest two leaves below a pair, as far as they were looked for.
    struct Nearest {
        NodePair nodes{};
        HullPair found{};
        double gap_m = 0.0;  // minus how deep its deepest contact is
    };

    LevelPairs(std::shared_ptr<const ContactLevels> object,
               std::shared_ptr<const ContactLevels> tool, const LevelPairSettings& settings);

    void wait(std::int32_t pair) noexcept;
    [[nodiscard]] std::int32_t take_waiting() noexcept;
    void open(std::int32_t pair, bool as_it_is, LevelAnswer& answer) noexcept;
    [[nodiscard]] bool is_time_up(double began_s) const noexcept;
    [[nodiscard]] bool is_fine_enough(const PairTree::Pair& one) const noexcept;
    // The nearest leaves below become a contact; where they are deep, all that are near.
    void look_below(std::int32_t top, LevelAnswer& answer) noexcept;
    template <class LookAt>
    void walk_below(std::int32_t top, const double& enough_m, const LookAt& look_at,
                    LevelAnswer& answer) noexcept;
    [[nodiscard]] PairContacts touch(const NodePair& leaves, const HullPair& found) const noexcept;
    void add_contacts(const NodePair& leaves, const HullPair& found, float error_m,
                      LevelAnswer& answer) noexcept;

    LevelPairSettings settings_;
    PairTree tree_;
    double slack_m_;
    BoundedList<Waiting> waiting_;
    BoundedList<std::int32_t> below_;
    BoundedList<std::int32_t> opened_;
    BoundedList<LevelContact> contacts_;
};

}  // namespace fulcrum
