#include "haptics/tool/god_object/god_pair.h"

#include "haptics/continuous/triangle_sweep.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kSamePlace_m = 1.0e-9;
constexpr double kSameNormal = 1.0e-7;  // of a gap of a micrometre, between coordinates of a metre
constexpr double kFallsAway =
    1.0e-8;  // what a surface may rise: a direction so far off is felt as friction
constexpr double kRoundings = 4.0e-15;  // of lengths, in a direction between places a gap apart
constexpr int kPairsPerContact = 8;
constexpr double kFar = 4.0;            // what has gone from the front, in usual ways
constexpr double kLongWay = 0.1;        // of the tool's reach
constexpr std::size_t kMostNear = 384;  // pairs that are looked at for one way, at least
constexpr std::size_t kMoreNear = 4;    // times what is in contact, at least
constexpr int kCuts = 4;                // of a way on which more come near
constexpr double kShorter = 0.25;       // a cut
constexpr double kLonger = 1.5;         // after one that was not too long
constexpr double kFills = 0.8;          // of what is looked at at most
constexpr double kBend = 0.125;         // the most that an arc lies off its chord, in w^2 r
constexpr double kForgets = 0.9;        // of the usual way, a step

std::uint64_t mix(std::uint64_t hash, double value, double grid) noexcept {
    const double cell = value / grid;
    const auto whole =
        std::abs(cell) < 9.0e18 ? static_cast<std::uint64_t>(std::llround(cell)) : std::uint64_t{0};
    hash ^= whole;
    hash *= 0x9E3779B97F4A7C15ULL;
    return hash ^ (hash >> 29U);
}

bool is_alike(const GodContact& a, const GodContact& b) noexcept {
    return (a.on_tool_O - b.on_tool_O).squaredNorm() <= kSamePlace_m * kSamePlace_m &&
           (a.normal_O - b.normal_O).squaredNorm() <= kSameNormal * kSameNormal;
}

}  // namespace

GodPair::GodPair(std::shared_ptr<const GodSurface> object, std::shared_ptr<const GodSurface> tool,
                 int most_contacts)
    : object_(std::move(object)),
      tool_(std::move(tool)),
      front_(object_->swept(), tool_->swept(), kPairsPerContact * most_contacts),
      contacts_(most_contacts),
      places_(std::bit_ceil(2U * static_cast<std::size_t>(most_contacts))),
      least_gap_m_(std::numeric_limits<double>::infinity()) {}

void GodPair::forget() noexcept {
    front_.forget();
    usual_way_m_ = 0.0;
    most_way_m_ = std::numeric_limits<double>::infinity();
    n_held_ = 0;
}

double GodPair::find_rise_m(const GodNear& near, const NearFeatures& features,
                            const Vector3& normal_O, const Pose& X_OT) const noexcept {
    const double epsilon = std::max(
        kFallsAway,
        kRoundings * (features.on_fixed.norm() + X_OT.position.norm() + tool_->swept().reach_m()) /
            features.distance_m);
    const Pose X_TO = X_OT.inverse();
    return std::max(
        object_->find_rise_m(near.object_triangle, features.on_fixed, normal_O, epsilon),
        tool_->find_rise_m(near.tool_triangle, X_TO * features.on_moving,
                           -(X_TO.orientation * normal_O), epsilon));
}

void GodPair::add(const GodContact& contact) noexcept {
    std::uint64_t hash = 0;
    for (Index i = 0; i < 3; ++i) {
        hash = mix(hash, contact.on_tool_O[i], 4.0 * kSamePlace_m);
        hash = mix(hash, contact.normal_O[i], 4.0 * kSameNormal);
    }
    // Never full: it has twice as many places as there are contacts.
    const std::size_t mask = places_.size() - 1;
    for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
        Place& place = places_[at];
        if (place.round != round_) {
            if (contacts_.add(contact)) {
                place = {round_, static_cast<std::uint32_t>(contacts_.count() - 1)};
            } else {
                is_full_ = true;
            }
            break;
        }
        if (is_alike(contacts_[place.contact], contact)) {
            break;
        }
    }
}

bool GodPair::add_all_of(const GodNear& near, const GodPlace& place, double within_m) noexcept {
    const Triangle own = tool_->swept().triangle(near.tool_triangle);
    if (find_apart_m(near, own, place) > within_m) {
        return true;
    }
    bool is_near = false;
    const Triangle object = object_->swept().triangle(near.object_triangle);
    const Triangle tool = place.corners(own);
    const auto offer = [&](FeaturePair pair, std::uint8_t i, std::uint8_t j) {
        const NearFeatures found = find_nearest_of(pair, i, j, object, tool);
        if (!(found.distance_m > 0.0 && found.distance_m <= within_m)) {
            return;
        }
        is_near = true;
        const Vector3 normal_O = (found.on_moving - found.on_fixed) / found.distance_m;
        least_gap_m_ = std::min(least_gap_m_, found.distance_m);
        const double rise_m = find_rise_m(near, found, normal_O, place.X_OT);
        if (rise_m <= within_m) {
            add({found.on_fixed, found.on_moving, normal_O, found.distance_m, rise_m, pair, i, j,
                 near.object_triangle, near.tool_triangle});
        }
    };
    // Each corner and each edge once: of all triangles that have it one asks.
    const unsigned object_edges = object_->own_edges(near.object_triangle);
    const unsigned tool_edges = tool_->own_edges(near.tool_triangle);
    for (std::uint8_t i = 0; i < 3; ++i) {
        if ((tool_->own_corners(near.tool_triangle) >> i & 1U) != 0) {
            offer(FeaturePair::face_vertex, 0, i);
        }
        if ((object_->own_corners(near.object_triangle) >> i & 1U) != 0) {
            offer(FeaturePair::vertex_face, i, 0);
        }
        for (std::uint8_t j = 0; j < 3 && (object_edges >> i & 1U) != 0; ++j) {
            if ((tool_edges >> j & 1U) != 0) {
                offer(FeaturePair::edge_edge, i, j);
            }
        }
    }
    return is_near;
}

void GodPair::collect(const Pose& X_OT, double within_m) noexcept {
    contacts_.clear();
    if (++round_ == 0) {
        // Round 0 is that of a place never taken.
        std::ranges::fill(places_, Place{});
        round_ = 1;
    }
    least_gap_m_ = std::numeric_limits<double>::infinity();
    const GodPlace place = GodPlace::of(object_->swept(), tool_->swept(), X_OT);
    // Where there is no room for all, those that were found are kept.
    is_full_ = front_.look(place, within_m) != GodLook::whole;
    n_held_ = front_.near().size();
    for (const std::int32_t i : front_.near()) {
        if (!add_all_of(front_.pair(i), place, within_m)) {
            front_.aim_at_times(i, place, within_m);  // not to be asked again
        }
    }
    if (!is_full_) {
        front_.tidy(place, kFar * usual_way_m_);
    }
}

bool GodPair::stays_apart(std::int32_t i, const GodPlace& from, const GodPlace& to,
                          double least_m) noexcept {
    const GodNear& near = front_.pair(i);
    const Triangle own = tool_->swept().triangle(near.tool_triangle);
    const auto is_apart = [&] {
        return std::min(find_apart_m(near, own, from), find_apart_m(near, own, to)) > least_m;
    };
    if (is_apart()) {
        return true;
    }
    front_.aim(i, from);
    return is_apart();
}

double GodPair::sweep_near(const InBetweenMotion& motion, const GodPlace& from, const GodPlace& to,
                           const SweepSettings& settings) noexcept {
    const double angle = motion.angle_rad();
    const double bend_m = kBend * angle * angle * tool_->swept().reach_m();
    double free = 1.0;
    for (const std::int32_t i : front_.near()) {
        if (stays_apart(i, from, to, settings.touch_m + bend_m)) {
            continue;
        }
        const GodNear& near = front_.pair(i);
        const TriangleSweep told =
            sweep_triangles(motion, object_->swept().triangle(near.object_triangle),
                            MovingTriangle::of(motion, tool_->swept().triangle(near.tool_triangle)),
                            settings, 0.0, free, near.direction_O);
        if (told.outcome == SweepOutcome::touching) {
            free = std::min(free, told.contact.time);
        } else if (told.outcome != SweepOutcome::free) {
            return 0.0;
        }
    }
    return free;
}

double GodPair::sweep_all(const InBetweenMotion& motion,
                          const SweepSettings& settings) const noexcept {
    const MeshSweep swept = sweep_meshes(object_->swept(), tool_->swept(), motion, settings);
    switch (swept.outcome) {
        case SweepOutcome::free:
            return 1.0;
        case SweepOutcome::touching:
            return swept.contact.time;
        case SweepOutcome::overlapping:
        case SweepOutcome::invalid:
            break;
    }
    return 0.0;
}

double GodPair::look_along(const GodPlace& from, double way_m, double touch_m) noexcept {
    const std::size_t most = std::max(kMostNear, kMoreNear * n_held_);
    double part = std::min(1.0, most_way_m_ / way_m);
    for (int i = 0; i < kCuts; ++i) {
        const double reach_m = part * way_m + 2.0 * touch_m;
        const GodLook looked = front_.look(from, reach_m, i + 1 < kCuts ? most : SIZE_MAX);
        if (looked == GodLook::whole) {
            usual_way_m_ = std::max(reach_m, kForgets * usual_way_m_);
            // Longer the next time, as far as there is likely to be room: what is too much is looked at for nothing.
            const double room =
                kFills * static_cast<double>(most) / static_cast<double>(front_.near().size() + 1);
            most_way_m_ =
                part < 1.0 ? std::min(kLonger, room) * part * way_m : std::max(most_way_m_, way_m);
            return part;
        }
        part *= kShorter;
        most_way_m_ = part * way_m;
    }
    return 0.0;
}

double GodPair::find_free_share(const Pose& from_OT, const Pose& to_OT, double touch_m) noexcept {
    is_cut_ = false;
    const InBetweenMotion motion(from_OT, to_OT);
    const SweepSettings settings{touch_m, touch_m};
    if (!motion.is_valid()) {
        return 0.0;
    }
    const SweptMesh& object = object_->swept();
    const SweptMesh& tool = tool_->swept();
    const GodPlace from = GodPlace::of(object, tool, from_OT);
    const double way_m = find_way_m(object, tool, from_OT, to_OT);
    const double long_m = kLongWay * tool.reach_m();
    // In the open: as far as it likes.
    if (way_m > long_m && front_.look(from, long_m, 0) == GodLook::whole) {
        return sweep_all(motion, settings);
    }
    const double part = look_along(from, way_m, touch_m);
    if (!(part > 0.0)) {
        return sweep_all(motion, settings);
    }
    if (part == 1.0) {
        return sweep_near(motion, from, GodPlace::of(object, tool, to_OT), settings);
    }
    const Pose part_OT = motion.pose(part);
    const double free = sweep_near(InBetweenMotion(from_OT, part_OT), from,
                                   GodPlace::of(object, tool, part_OT), settings);
    is_cut_ = free == 1.0;
    return part * free;
}

bool GodPair::is_apart(const Pose& X_OT, double touch_m) const noexcept {
    const SweepSettings settings{touch_m, touch_m};
    return sweep_meshes(object_->swept(), tool_->swept(), InBetweenMotion(X_OT, X_OT), settings)
               .outcome == SweepOutcome::free;
}

bool GodPair::has_within(const Pose& X_OT, double within_m) noexcept {
    const GodPlace place = GodPlace::of(object_->swept(), tool_->swept(), X_OT);
    if (front_.look(place, within_m) != GodLook::whole) {
        return !is_apart(X_OT, within_m);
    }
    return std::ranges::any_of(front_.near(),
                               [&](std::int32_t i) { return front_.aim(i, place) <= within_m; });
}

bool GodPair::is_enclosed(const Pose& X_OT) const noexcept {
    const auto is_any_inside = [](const GodSurface& outer, const GodSurface& inner,
                                  const Pose& place) {
        return std::ranges::any_of(inner.parts(), [&](std::int32_t corner) {
            return outer.encloses(place * inner.place_B(static_cast<std::size_t>(corner)));
        });
    };
    return is_any_inside(*object_, *tool_, X_OT) || is_any_inside(*tool_, *object_, X_OT.inverse());
}

std::size_t GodPair::memory_bytes() const noexcept {
    return front_.memory_bytes() + contacts_.capacity() * sizeof(GodContact) +
           places_.capacity() * sizeof(Place);
}

}  // namespace fulcrum
