#include "haptics/collision/contact_points.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Of the smaller body's size: candidates nearer to each other than this are one.
constexpr double kOnePlace = 1.0e-3;
// The same: what is deeper by less is as deep.
constexpr double kAsDeep = 1.0e-4;
// By how much of the area others have to be better than those of last time.
constexpr double kBetterArea = 1.1;

std::size_t slot(int i) noexcept {
    return static_cast<std::size_t>(i);
}

// Four of the candidates, or fewer.
struct Choice {
    std::array<int, kMostContacts> of{};
    int count = 0;

    void add(int candidate) noexcept { of[slot(count++)] = candidate; }
};

// The candidates but for those that lie where one before them does.
class Chooser {
  public:
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    Chooser(const ContactCandidates& candidates, const Vector3& normal, double size_m) noexcept
        : normal_(normal), size_m_(size_m) {
        const double nearest = kOnePlace * kOnePlace * size_m * size_m;
        for (int i = 0; i < candidates.count; ++i) {
            const ContactCandidate& one = candidates.places[slot(i)];
            bool is_new = true;
            for (int j = 0; j < n_ && is_new; ++j) {
                is_new = (places_[slot(j)]->place - one.place).squaredNorm() > nearest;
            }
            if (is_new) {
                places_[slot(n_++)] = &one;
            }
        }
    }
    [[nodiscard]] int count() const noexcept { return n_; }
    [[nodiscard]] const ContactCandidate& candidate(int i) const noexcept {
        return *places_[slot(i)];
    }

    /// Twice the area of what four span, whatever their order: the largest of the three ways to pair them as diagonals.
    [[nodiscard]] double find_area(const Choice& choice) const noexcept {
        if (choice.count < kMostContacts) {
            return 0.0;
        }
        const Vector3 ab = place(choice, 1) - place(choice, 0);
        const Vector3 ac = place(choice, 2) - place(choice, 0);
        const Vector3 ad = place(choice, 3) - place(choice, 0);
        return std::max({std::abs(normal_.dot(ab.cross(ad - ac))),
                         std::abs(normal_.dot(ac.cross(ad - ab))),
                         std::abs(normal_.dot(ad.cross(ac - ab)))});
    }
    [[nodiscard]] int find_deepest() const noexcept {
        int best = 0;
        for (int i = 1; i < n_; ++i) {
            if (candidate(i).gap_m < candidate(best).gap_m - kAsDeep * size_m_) {
                best = i;
            }
        }
        return best;
    }
    /// The deepest, the farthest from it, and on both sides of the line between them the one that spans most.
    [[nodiscard]] Choice choose() const noexcept {
        Choice choice;
        if (n_ <= kMostContacts) {
            for (int i = 0; i < n_; ++i) {
                choice.add(i);
            }
            return choice;
        }
        const int first = find_deepest();
        choice.add(first);
        const Vector3& from = candidate(first).place;
        const int second =
            find_most([&](const Vector3& place) noexcept { return (place - from).squaredNorm(); });
        choice.add(second);
        const Vector3 across = normal_.cross(candidate(second).place - from);
        const int left =
            find_most([&](const Vector3& place) noexcept { return across.dot(place - from); });
        const int right =
            find_most([&](const Vector3& place) noexcept { return -across.dot(place - from); });
        // Of places on one line none lies on a side.
        const double least = kOnePlace * size_m_ * compute_length(across);
        if (across.dot(candidate(left).place - from) > least) {
            choice.add(left);
        }
        if (-across.dot(candidate(right).place - from) > least) {
            choice.add(right);
        }
        return choice;
    }
    /// Whether what was chosen last time may stay.
    [[nodiscard]] bool may_stay(const Choice& old, const Choice& other) const noexcept {
        const int deepest = find_deepest();
        double least_m = candidate(old.of[0]).gap_m;
        for (int i = 1; i < old.count; ++i) {
            least_m = std::min(least_m, candidate(old.of[slot(i)]).gap_m);
        }
        return least_m <= candidate(deepest).gap_m + kAsDeep * size_m_ &&
               kBetterArea * find_area(old) >= find_area(other);
    }

  private:
    [[nodiscard]] const Vector3& place(const Choice& choice, int i) const noexcept {
        return candidate(choice.of[slot(i)]).place;
    }
    template <class Measure>
    [[nodiscard]] int find_most(const Measure& measure) const noexcept {
        int best = 0;
        double most = measure(candidate(0).place);
        for (int i = 1; i < n_; ++i) {
            const double here = measure(candidate(i).place);
            if (here > most) {
                most = here;
                best = i;
            }
        }
        return best;
    }

    std::array<const ContactCandidate*, ContactCandidates::kMost> places_;
    int n_ = 0;
    const Vector3& normal_;
    double size_m_;
};

// Which old point each candidate is, and the other way round; -1: none.
class Matches {
  public:
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled below
    Matches(const Chooser& chooser, const ContactManifold& manifold, const ContactTurn& turn,
            double same_m) noexcept
        : chooser_(chooser) {
        old_of_.fill(-1);
        candidate_of_.fill(-1);
        for (int o = 0; o < manifold.count; ++o) {
            const ContactPoint& old = manifold.contacts[slot(o)];
            const Vector3 by_first =
                turn.first.turn_WB * old.place_A + turn.first.position_W - turn.origin_W;
            const Vector3 by_second =
                turn.second.turn_WB * old.place_B + turn.second.position_W - turn.origin_W;
            match_nearest(o, by_first, by_second, same_m * same_m);
        }
        for (int o = 0; o < manifold.count; ++o) {
            if (candidate_of_[slot(o)] < 0) {
                match_feature(o, manifold.contacts[slot(o)].feature);
            }
        }
    }
    [[nodiscard]] int old_of(int candidate) const noexcept { return old_of_[slot(candidate)]; }
    [[nodiscard]] int candidate_of(int old) const noexcept { return candidate_of_[slot(old)]; }

  private:
    void match(int old, int candidate) noexcept {
        old_of_[slot(candidate)] = old;
        candidate_of_[slot(old)] = candidate;
    }
    void match_nearest(int old, const Vector3& by_first, const Vector3& by_second,
                       double within_square) noexcept {
        int best = -1;
        double least = within_square;
        for (int i = 0; i < chooser_.count(); ++i) {
            const Vector3& place = chooser_.candidate(i).place;
            const double away =
                std::min((place - by_first).squaredNorm(), (place - by_second).squaredNorm());
            if (old_of_[slot(i)] < 0 && away <= least) {
                least = away;
                best = i;
            }
        }
        if (best >= 0) {
            match(old, best);
        }
    }
    void match_feature(int old, std::uint16_t feature) noexcept {
        for (int i = 0; i < chooser_.count(); ++i) {
            if (old_of_[slot(i)] < 0 && chooser_.candidate(i).feature == feature) {
                return match(old, i);
            }
        }
    }

    const Chooser& chooser_;
    std::array<int, ContactCandidates::kMost> old_of_;
    std::array<int, kMostContacts> candidate_of_;
};

// The points of last time, where all four are there still.
Choice find_old_choice(const ContactManifold& manifold, const Matches& matches) noexcept {
    Choice choice;
    for (int o = 0; o < manifold.count && manifold.count == kMostContacts; ++o) {
        if (matches.candidate_of(o) < 0) {
            return {};
        }
        choice.add(matches.candidate_of(o));
    }
    return choice;
}

}  // namespace

void choose_contacts(const ContactCandidates& candidates, const Vector3& normal_W, double size_m,
                     const ContactTurn& turn, ContactManifold& manifold) noexcept {
    const Chooser chooser(candidates, normal_W, size_m);
    const Matches matches(chooser, manifold, turn, kSamePlace * size_m);
    Choice choice = chooser.choose();
    const Choice old = find_old_choice(manifold, matches);
    if (old.count == kMostContacts && chooser.may_stay(old, choice)) {
        choice = old;
    }
    std::array<ContactPoint, kMostContacts> contacts;
    for (int i = 0; i < choice.count; ++i) {
        const ContactCandidate& candidate = chooser.candidate(choice.of[slot(i)]);
        const int before = matches.old_of(choice.of[slot(i)]);
        const Vector3 place_W = turn.origin_W + candidate.place;
        contacts[slot(i)] = {
            .place_W = place_W,
            .gap_m = candidate.gap_m,
            .id = before >= 0 ? manifold.contacts[slot(before)].id : manifold.next_id++,
            .feature = candidate.feature,
            .place_A = turn.first.to_body(place_W),
            .place_B = turn.second.to_body(place_W)};
    }
    manifold.contacts = contacts;
    manifold.count = choice.count;
}

}  // namespace fulcrum
