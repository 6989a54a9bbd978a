#include "haptics/collision/sampled_contacts.h"

#include "haptics/collision/contact_points.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace fulcrum {
namespace {

// What two surfaces that face each other have, as a cosine.
constexpr double kFacing = -0.95;
// By how much a normal may lie beside a corner's or an edge's cone.
constexpr double kBesideCone_rad = 0.15;
// The same of a normal and those beside it: 14 degrees.
constexpr double kSameRound = 0.97;
// Of a patch's normal and its touch's: the cosine of 25 degrees; where there is no room for another patch that of 60.
constexpr double kOnePatch = 0.90630779;
constexpr double kAnyPatch = 0.5;
constexpr int kMostTouches = 128;
// Slides along a surface, and halvings along a line.
constexpr int kSlides = 6;
constexpr int kHalvings = 8;
// What is left of a slope where it is least.
constexpr double kLevelSlope = 0.01;
// Of the way: how far off the surface a place may be that was put back on it.
constexpr double kBackOn = 0.02;
// Of the size: what all touches of a patch weigh at least, so that those at the margin have a mean.
constexpr double kLeastWeight = 1.0e-6;
// The same: what is farther than the nearest by less bears with it.
constexpr double kBeyondRange = 2.0e-3;

std::size_t place_in(int i) noexcept {
    return static_cast<std::size_t>(i);
}

/// A place where the surfaces are near; axes W, from the pair's origin.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): always made whole
struct Touch {
    Vector3 place;   ///< half way between the surfaces
    Vector3 normal;  ///< from the second body to the first
    double gap_m;
    double rounding_m;
    SampleKind kind;
    bool is_sure;  ///< the normal is the same all round
    std::uint16_t feature;
};

// Flat on flat all of the face is as near as its corners, which bound it: they go first.
bool goes_first(const Touch& a, const Touch& b) noexcept {
    return std::tie(a.kind, a.gap_m, a.feature) < std::tie(b.kind, b.gap_m, b.feature);
}

/// Those that go first, and the nearest.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
struct Touches {
    std::array<Touch, kMostTouches> of;
    int count = 0;

    void add(const Touch& touch) noexcept {
        if (count < kMostTouches) {
            of[place_in(count++)] = touch;
            return;
        }
        Touch& last = *std::ranges::max_element(of, goes_first);
        if (goes_first(touch, last) || touch.gap_m < find_nearest().gap_m) {
            last = touch;
        }
    }
    [[nodiscard]] Touch& find_nearest() noexcept {
        return *std::ranges::min_element(used(), {}, &Touch::gap_m);
    }
    [[nodiscard]] std::span<Touch> used() noexcept { return std::span(of).first(place_in(count)); }
};

/// One body's surface as the other sees it. x in the own frame.
struct Seen {
    const SampledShape& own;
    const SampledShape& other;
    Matrix3 turn;   // own to other
    Vector3 shift;  // the own origin in the other's frame

    [[nodiscard]] Vector3 to_other(const Vector3& x) const noexcept { return turn * x + shift; }
    [[nodiscard]] Gap at(const Vector3& x) const noexcept {
        Gap gap = other.at(to_other(x));
        gap.normal_B = turn.transpose() * gap.normal_B;
        return gap;
    }
};

// Where the gap is least from `x` on along a line, no farther than `reach_m` either way: where it falls no more.
Vector3 slide_along(const Seen& seen, const Vector3& x, const Vector3& line,
                    double reach_m) noexcept {
    const double rise = seen.at(x).normal_B.dot(line);
    if (!(std::abs(rise) > kLevelSlope)) {
        return x;
    }
    const Vector3 way = rise > 0.0 ? Vector3(-line) : line;
    const auto falls_at = [&](double s) noexcept {
        return seen.at(Vector3(x + s * way)).normal_B.dot(way) < 0.0;
    };
    if (falls_at(reach_m)) {
        return x + reach_m * way;
    }
    double falls_m = 0.0;
    double rises_m = reach_m;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle_m = 0.5 * (falls_m + rises_m);
        (falls_at(middle_m) ? falls_m : rises_m) = middle_m;
    }
    return x + 0.5 * (falls_m + rises_m) * way;
}

// The same along the surface.
Vector3 slide_over(const Seen& seen, Vector3 x, double reach_m) noexcept {
    double gap_m = seen.at(x).gap_m;
    for (int i = 0; i < kSlides; ++i) {
        const Vector3 outwards = seen.own.at(x).normal_B;
        const Vector3 uphill = seen.at(x).normal_B;
        const Vector3 level = uphill - uphill.dot(outwards) * outwards;
        const double length = compute_length(level);
        if (!(length > kLevelSlope)) {
            return x;
        }
        const Vector3 beside = slide_along(seen, x, Vector3(level / length), reach_m);
        const Gap off = seen.own.at(beside);
        const Vector3 next = beside - off.gap_m * off.normal_B;
        // Far beyond an edge of its own nothing says where the surface is.
        const bool is_on = std::abs(seen.own.at(next).gap_m) <= kBackOn * reach_m;
        const double next_m = seen.at(next).gap_m;
        if (!is_on || !(next_m < gap_m)) {
            return x;
        }
        x = next;
        gap_m = next_m;
    }
    return x;
}

/// Looks over one body's samples.
class TouchFinder {
  public:
    TouchFinder(const SampledBody& own, const SampledBody& other, const Vector3& origin_W,
                bool is_first, double margin_m, Touches& touches) noexcept
        : seen_{own.shape, other.shape, other.place.turn_WB.transpose() * own.place.turn_WB,
                other.place.to_body(own.place.position_W)},
          own_(own.place),
          origin_W_(origin_W),
          is_first_(is_first),
          margin_m_(margin_m),
          touches_(touches) {}

    void find_all() noexcept {
        const SurfaceSamples& samples = seen_.own.samples();
        const double near_m = margin_m_ + 0.5 * samples.spacing_m();
        for (const SurfaceSamples::Group& group : samples.groups()) {
            const Vector3 centre = seen_.to_other(group.centre_B);
            if (seen_.other.bound_m(centre) <= near_m + group.radius_m) {
                find_in(group, near_m);
            }
        }
    }

  private:
    void find_in(const SurfaceSamples::Group& group, double near_m) noexcept {
        const SurfaceSamples& samples = seen_.own.samples();
        const SurfaceSample* nearest = nullptr;
        double nearest_m = 0.0;
        for (const SurfaceSample& sample : samples.of(group)) {
            const double gap_m = seen_.other.at(seen_.to_other(sample.place_B)).gap_m;
            if (gap_m > near_m) {
                continue;
            }
            if (sample.kind == SampleKind::face) {
                // Of those that are equally near the first, whatever trembles.
                if (nearest == nullptr || gap_m < nearest_m - rounding_m()) {
                    nearest_m = gap_m;
                    nearest = &sample;
                }
                continue;
            }
            const bool is_edge = sample.kind == SampleKind::edge;
            add(is_edge ? slide_along(seen_, sample.place_B, sample.along_B, sample.reach_m)
                        : sample.place_B,
                sample);
        }
        if (nearest != nullptr) {
            add(slide_over(seen_, nearest->place_B, samples.spacing_m()), *nearest);
        }
    }
    [[nodiscard]] double rounding_m() const noexcept {
        return seen_.own.rounding_m() + seen_.other.rounding_m();
    }
    // Whether a sample can be touched by what has this normal: in the middle of a face, or from within a corner's or an edge's cone. So
    // edges that lie flush with the other's do not touch it sideways.
    [[nodiscard]] bool faces(const Vector3& x, const SurfaceSample& sample,
                             const Vector3& normal) const noexcept {
        if (sample.kind == SampleKind::face) {
            return seen_.own.at(x).normal_B.dot(normal) < kFacing;
        }
        const double cosine = -sample.outwards_B.dot(normal);
        return std::acos(std::clamp(cosine, -1.0, 1.0)) <=
               std::acos(std::clamp(sample.cone_cosine, -1.0, 1.0)) + kBesideCone_rad;
    }
    // Beside a corner or an edge of the other the direction away from it turns within a voxel: there it tells little.
    [[nodiscard]] bool is_same_round(const Vector3& x, const Vector3& normal) const noexcept {
        const Vector3 across = normal.unitOrthogonal();
        const Vector3 along = normal.cross(across);
        const double beside_m = seen_.other.feature_m();
        return std::ranges::all_of(
            std::array{across, Vector3(-across), along, Vector3(-along)},
            [&](const Vector3& way) noexcept {
                return seen_.at(Vector3(x + beside_m * way)).normal_B.dot(normal) > kSameRound;
            });
    }
    void add(const Vector3& x, const SurfaceSample& sample) noexcept {
        const Gap gap = seen_.at(x);
        if (!(gap.gap_m <= margin_m_) || !faces(x, sample, gap.normal_B)) {
            return;
        }
        const bool is_face = sample.kind == SampleKind::face;
        const Vector3 normal = own_.turn_WB * gap.normal_B;
        const Vector3 place = own_.turn_WB * x + (own_.position_W - origin_W_);
        const auto number = static_cast<std::uint32_t>(&sample - seen_.own.samples().all().data());
        touches_.add({.place = place - 0.5 * gap.gap_m * normal,
                      .normal = is_first_ ? normal : Vector3(-normal),
                      .gap_m = gap.gap_m,
                      .rounding_m = rounding_m(),
                      .kind = sample.kind,
                      .is_sure = is_face || is_same_round(x, gap.normal_B),
                      .feature = static_cast<std::uint16_t>(2 * number + (is_first_ ? 0 : 1))});
    }

    Seen seen_;
    const ContactPlace& own_;
    const Vector3& origin_W_;
    bool is_first_;
    double margin_m_;
    Touches& touches_;
};

template <class Value>
std::array<Value, kMostPatches> make_filled(const Value& value) noexcept {
    std::array<Value, kMostPatches> all{};
    all.fill(value);
    return all;
}

/// Which patch each touch belongs to.
class Patches {
  public:
    Patches(std::span<ContactManifold* const> last, const TouchRange& range, double size_m) noexcept
        : margin_m_(range.margin_m),
          beyond_m_(range.ahead_m + kBeyondRange * size_m),
          least_m_(kLeastWeight * size_m),
          n_(std::min(static_cast<int>(last.size()), kMostPatches)) {
        for (int i = 0; i < n_; ++i) {
            was_there_[place_in(i)] = last[place_in(i)]->count > 0;
            normals_[place_in(i)] = last[place_in(i)]->normal_W;
        }
    }
    void share_out(Touches& touches) noexcept {
        std::ranges::sort(touches.used(), goes_first);
        // Sure directions first: another one counts where none of them is near.
        for (const bool is_sure : {true, false}) {
            for (const Touch& touch : touches.used()) {
                if (touch.is_sure == is_sure) {
                    join(touch);
                }
            }
        }
    }
    /// Those that may touch within the step: what is farther than that from the nearest bears nothing, and would take a place.
    [[nodiscard]] ContactCandidates candidates(int patch) const noexcept {
        const ContactCandidates& all = candidates_[place_in(patch)];
        double least_m = std::numeric_limits<double>::infinity();
        for (int i = 0; i < all.count; ++i) {
            least_m = std::min(least_m, all.places[place_in(i)].gap_m);
        }
        ContactCandidates near;
        for (int i = 0; i < all.count; ++i) {
            const ContactCandidate& one = all.places[place_in(i)];
            if (one.gap_m <= least_m + beyond_m_) {
                near.add(one);
            }
        }
        return near;
    }
    [[nodiscard]] Vector3 normal_of(int patch) const noexcept {
        const Vector3& sum = sums_[place_in(patch)];
        return sum.squaredNorm() > 0.0 ? compute_direction(sum) : normals_[place_in(patch)];
    }
    [[nodiscard]] int count() const noexcept { return n_; }

  private:
    void join(const Touch& touch) noexcept {
        const int patch = find_patch(touch);
        if (patch < 0) {
            return;
        }
        const std::size_t i = place_in(patch);
        take(touch, candidates_[i], sharp_m_[i]);
        if (touch.is_sure || !has_sure_[i]) {
            sums_[i] += (margin_m_ - touch.gap_m + least_m_) * touch.normal;
        }
        has_sure_[i] = has_sure_[i] || touch.is_sure;
    }
    // The last place is kept for the nearest face. One that is as near as a corner, but for what its field rounds, is no nearer.
    static void take(const Touch& touch, ContactCandidates& into, double& sharp_m) noexcept {
        double gap_m = touch.gap_m;
        if (touch.kind == SampleKind::face) {
            gap_m = gap_m > sharp_m - touch.rounding_m ? std::max(gap_m, sharp_m) : gap_m;
        } else if (into.count + 1 >= ContactCandidates::kMost) {
            return;
        } else if (touch.is_sure) {
            sharp_m = std::min(sharp_m, gap_m);
        }
        into.add({touch.place, gap_m, touch.feature});
    }
    // The one that is nearest in direction, of those that `counts(i)`; -1 where there is none.
    template <class Counts>
    [[nodiscard]] int find_nearest(const Vector3& normal, double least_cosine,
                                   const Counts& counts) const noexcept {
        int best = -1;
        for (int i = 0; i < n_; ++i) {
            const double cosine = normals_[place_in(i)].dot(normal);
            if (counts(place_in(i)) && cosine >= least_cosine) {
                least_cosine = cosine;
                best = i;
            }
        }
        return best;
    }
    // A new one where none is near enough; where there is no room for that one that is not so near.
    [[nodiscard]] int find_patch(const Touch& touch) noexcept {
        const auto is_sure = [&](std::size_t i) noexcept { return has_sure_[i]; };
        const auto is_taken = [&](std::size_t i) noexcept {
            return was_there_[i] || candidates_[i].count > 0;
        };
        int patch = touch.is_sure ? -1 : find_nearest(touch.normal, kAnyPatch, is_sure);
        patch = patch < 0 ? find_nearest(touch.normal, kOnePatch, is_taken) : patch;
        for (int i = 0; i < n_ && patch < 0; ++i) {
            if (!is_taken(place_in(i))) {
                normals_[place_in(i)] = touch.normal;
                patch = i;
            }
        }
        return patch < 0 ? find_nearest(touch.normal, kAnyPatch, is_taken) : patch;
    }

    double margin_m_;
    double beyond_m_;
    double least_m_;
    int n_;
    std::array<bool, kMostPatches> was_there_{};
    std::array<bool, kMostPatches> has_sure_{};
    std::array<Vector3, kMostPatches> normals_;
    std::array<Vector3, kMostPatches> sums_ = make_filled(Vector3(Vector3::Zero()));
    std::array<ContactCandidates, kMostPatches> candidates_;
    std::array<double, kMostPatches> sharp_m_ =
        make_filled(std::numeric_limits<double>::infinity());  // the least gap of corners and edges
};

}  // namespace

void find_sampled_contacts(const SampledBody& first, const SampledBody& second, double size_m,
                           const TouchRange& range,
                           std::span<ContactManifold* const> patches) noexcept {
    const double margin_m = range.margin_m;
    Touches touches;
    const Vector3 origin_W = first.place.position_W;
    if (is_finite(first.place) && is_finite(second.place) && std::isfinite(margin_m)) {
        TouchFinder(first, second, origin_W, true, margin_m, touches).find_all();
        TouchFinder(second, first, origin_W, false, margin_m, touches).find_all();
    }
    Patches shared(patches, range, size_m);
    if (touches.count > 0) {
        shared.share_out(touches);
    }
    const ContactTurn turn{origin_W, first.place, second.place};
    for (int i = 0; i < shared.count(); ++i) {
        ContactManifold& manifold = *patches[place_in(i)];
        manifold.which_axis = 0;
        const ContactCandidates candidates = shared.candidates(i);
        if (candidates.count == 0) {
            manifold.count = 0;
            continue;
        }
        manifold.normal_W = shared.normal_of(i);
        choose_contacts(candidates, manifold.normal_W, size_m, turn, manifold);
    }
}

}  // namespace fulcrum
