#include "haptics/tool/god_pair.h"

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
constexpr double kWidth = 4.0;      // of the list, in what is asked of: it serves for so many steps
constexpr double kNarrower = 0.25;  // of a list for which there was no room
constexpr int kLists = 3;           // tried
constexpr double kWidestList = 0.1;  // of the tool's reach
constexpr double kForgets = 0.9;     // of the usual way, a step
constexpr double kRounded = 1.0e-9;  // of lengths: more than any rounding here

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

// What kept them apart where they were listed may do so elsewhere.
Vector3 find_hint(const NearTriangles& near) noexcept {
    const NearFeatures& features = near.features;
    return features.distance_m > 0.0
               ? Vector3((features.on_moving - features.on_fixed) / features.distance_m)
               : Vector3::Zero();
}

// How far apart along a direction: never more than they are.
double find_apart_m(const Triangle& object, const Triangle& tool, const Vector3& along) noexcept {
    return std::min({along.dot(tool[0]), along.dot(tool[1]), along.dot(tool[2])}) -
           std::max({along.dot(object[0]), along.dot(object[1]), along.dot(object[2])});
}

}  // namespace

GodPair::GodPair(std::shared_ptr<const GodSurface> object, std::shared_ptr<const GodSurface> tool,
                 int most_contacts)
    : object_(std::move(object)),
      tool_(std::move(tool)),
      near_(kPairsPerContact * most_contacts),
      contacts_(most_contacts),
      places_(std::bit_ceil(2U * static_cast<std::size_t>(most_contacts))),
      least_gap_m_(std::numeric_limits<double>::infinity()) {}

bool GodPair::carries(const NearTriangles& near, const NearFeatures& features) const noexcept {
    switch (features.pair) {
        case FeaturePair::face_vertex:
            return tool_->carries_corner(near.moving_triangle, features.moving_feature);
        case FeaturePair::vertex_face:
            return object_->carries_corner(near.fixed_triangle, features.fixed_feature);
        case FeaturePair::edge_edge:
            break;
    }
    return object_->carries_edge(near.fixed_triangle, features.fixed_feature) &&
           tool_->carries_edge(near.moving_triangle, features.moving_feature);
}

double GodPair::find_rise_m(const NearTriangles& near, const NearFeatures& features,
                            const Vector3& normal_O, const Pose& X_OT) const noexcept {
    const double epsilon = std::max(
        kFallsAway,
        kRoundings * (features.on_fixed.norm() + X_OT.position.norm() + tool_->swept().reach_m()) /
            features.distance_m);
    const Pose X_TO = X_OT.inverse();
    return std::max(object_->find_rise_m(near.fixed_triangle, features.on_fixed, normal_O, epsilon),
                    tool_->find_rise_m(near.moving_triangle, X_TO * features.on_moving,
                                       -(X_TO.orientation * normal_O), epsilon));
}

void GodPair::add(const GodContact& contact) noexcept {
    std::uint64_t hash = 0;
    for (Eigen::Index i = 0; i < 3; ++i) {
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

void GodPair::add_all_of(const NearTriangles& near, const Pose& X_OT, double within_m) noexcept {
    const Triangle object = object_->swept().triangle(near.fixed_triangle);
    const Triangle own = tool_->swept().triangle(near.moving_triangle);
    const Triangle tool{X_OT * own[0], X_OT * own[1], X_OT * own[2]};
    if (find_apart_m(object, tool, find_hint(near)) > within_m) {
        return;
    }
    const auto offer = [&](FeaturePair pair, std::uint8_t i, std::uint8_t j) {
        NearFeatures found{.pair = pair, .fixed_feature = i, .moving_feature = j};
        if (!carries(near, found)) {
            return;
        }
        found = find_nearest_of(pair, i, j, object, tool);
        if (!(found.distance_m > 0.0 && found.distance_m <= within_m)) {
            return;
        }
        const Vector3 normal_O = (found.on_moving - found.on_fixed) / found.distance_m;
        least_gap_m_ = std::min(least_gap_m_, found.distance_m);
        const double rise_m = find_rise_m(near, found, normal_O, X_OT);
        if (rise_m <= within_m) {
            add({found.on_fixed, found.on_moving, normal_O, found.distance_m, rise_m});
        }
    };
    for (std::uint8_t i = 0; i < 3; ++i) {
        offer(FeaturePair::face_vertex, 0, i);
        offer(FeaturePair::vertex_face, i, 0);
        for (std::uint8_t j = 0; j < 3; ++j) {
            offer(FeaturePair::edge_edge, i, j);
        }
    }
}

double GodPair::find_way_m(const Pose& from_OT, const Pose& to_OT) const noexcept {
    const double reach_m = tool_->swept().reach_m();
    const double turn =
        compute_log((to_OT.orientation * from_OT.orientation.conjugate()).normalized()).norm();
    const double lengths_m = reach_m + object_->swept().reach_m() + from_OT.position.norm();
    return (to_OT.position - from_OT.position).norm() + turn * reach_m + kRounded * lengths_m;
}

bool GodPair::list(const Pose& X_OT, double wanted_m, double least_m) noexcept {
    double width_m = std::max(least_m, std::min(wanted_m, kWidestList * tool_->swept().reach_m()));
    for (int i = 0; i < kLists; ++i) {
        if (collect_near(object_->swept(), tool_->swept(), InBetweenMotion(X_OT, X_OT), 0.0,
                         width_m, near_)) {
            listed_OT_ = X_OT;
            width_m_ = width_m;
            return true;
        }
        if (width_m == least_m) {
            break;
        }
        width_m = std::max(least_m, kNarrower * width_m);
    }
    width_m_ = -1.0;
    return false;
}

void GodPair::collect(const Pose& X_OT, double within_m) noexcept {
    contacts_.clear();
    ++round_;
    least_gap_m_ = std::numeric_limits<double>::infinity();
    is_full_ = false;
    double gone_m = find_way_m(listed_OT_, X_OT);
    if (width_m_ - gone_m < within_m) {
        // Where there is no room for all, those that were found are kept.
        const double least_m = within_m + find_way_m(X_OT, X_OT);
        is_full_ = !list(X_OT, kWidth * (within_m + usual_way_m_), least_m);
        listed_OT_ = X_OT;
        gone_m = find_way_m(X_OT, X_OT);
    }
    for (const NearTriangles& near : near_.all()) {
        if (near.features.distance_m - gone_m <= within_m) {
            add_all_of(near, X_OT, within_m);
        }
    }
}

double GodPair::sweep_listed(const InBetweenMotion& motion, double reach_m,
                             const SweepSettings& settings) const noexcept {
    double free = 1.0;
    for (const NearTriangles& near : near_.all()) {
        if (near.features.distance_m > reach_m) {
            continue;
        }
        const TriangleSweep told = sweep_triangles(
            motion, object_->swept().triangle(near.fixed_triangle),
            MovingTriangle::of(motion, tool_->swept().triangle(near.moving_triangle)), settings,
            0.0, free, find_hint(near));
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

double GodPair::find_free_share(const Pose& from_OT, const Pose& to_OT, double touch_m) noexcept {
    const InBetweenMotion motion(from_OT, to_OT);
    const SweepSettings settings{touch_m, touch_m};
    if (!motion.is_valid()) {
        return 0.0;
    }
    const double way_m = find_way_m(from_OT, to_OT) + 2.0 * touch_m;
    usual_way_m_ = std::max(way_m, kForgets * usual_way_m_);
    double reach_m = find_way_m(listed_OT_, from_OT) + way_m;
    if (reach_m > width_m_) {
        if (way_m > kWidestList * tool_->swept().reach_m() ||
            !list(from_OT, kWidth * usual_way_m_, way_m + find_way_m(from_OT, from_OT))) {
            return sweep_all(motion, settings);
        }
        reach_m = find_way_m(from_OT, from_OT) + way_m;
    }
    return sweep_listed(motion, reach_m, settings);
}

bool GodPair::is_apart(const Pose& X_OT, double touch_m) const noexcept {
    const SweepSettings settings{touch_m, touch_m};
    return sweep_meshes(object_->swept(), tool_->swept(), InBetweenMotion(X_OT, X_OT), settings)
               .outcome == SweepOutcome::free;
}

bool GodPair::is_enclosed(const Pose& X_OT) const noexcept {
    return object_->encloses(X_OT * tool_->place_B(0)) ||
           tool_->encloses(X_OT.inverse() * object_->place_B(0));
}

std::size_t GodPair::memory_bytes() const noexcept {
    return near_.capacity() * sizeof(NearTriangles) + contacts_.capacity() * sizeof(GodContact) +
           places_.capacity() * sizeof(Place);
}

}  // namespace fulcrum
