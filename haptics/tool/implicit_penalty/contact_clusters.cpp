#include "haptics/tool/implicit_penalty/contact_clusters.h"

#include "haptics/base/range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr int kRounds = 2;         // of Lloyd's a time
constexpr double kMergeAt = 0.25;  // q: half of rho apart
constexpr double kPartAt = 0.36;   // and no longer merging from here on
constexpr double kWidens = 1.02;   // rho, a time
constexpr double kNarrows = 1.002;
constexpr double kWidest = 100.0;     // times what was asked for
constexpr double kLeastShare = 0.01;  // of one just born, so that it may have members at all

double phi(double q) noexcept {
    return q < 1.0 ? (1.0 - q) * (1.0 - q) : 0.0;
}

// What has a weight, and is numbers whose squares are.
bool has_weight(const NearContact& contact, double within_m) noexcept {
    constexpr double kHalf2 = 0.25;  // of a unit normal
    const double normal2 = contact.normal_O.squaredNorm();
    return contact.depth_m > -within_m && std::isfinite(contact.depth_m * contact.depth_m) &&
           std::isfinite(contact.point_T.squaredNorm()) && normal2 > kHalf2 &&
           normal2 < 1.0 / kHalf2;
}

}  // namespace

ContactClusters::ContactClusters(const ContactClusterSettings& settings)
    : settings_(settings), radius_m_(settings.radius_m) {}

double ContactClusters::compute_unlikeness(const NearContact& contact,
                                           const ContactCluster& cluster) const noexcept {
    return (contact.point_T - cluster.point_T).squaredNorm() / (radius_m_ * radius_m_) +
           (contact.normal_O - cluster.normal_O).squaredNorm();
}

void ContactClusters::begin_round() noexcept {
    for (std::size_t j = 0; j < n_; ++j) {
        Growth& sum = growth_[j];
        sum.weight = sum.depth = 0.0;
        sum.point.setZero();
        sum.normal.setZero();
    }
}

bool ContactClusters::share_out(const NearContact& contact) noexcept {
    std::array<double, kMostClusters> part{};
    double all = 0.0;
    for (std::size_t j = 0; j < n_; ++j) {
        part[j] = growth_[j].is_empty
                      ? 0.0
                      : growth_[j].share * phi(compute_unlikeness(contact, clusters_[j]));
        all += part[j];
    }
    if (!(all > 0.0)) {
        return false;
    }
    const double weight = (contact.depth_m + settings_.within_m) / all;
    for (std::size_t j = 0; j < n_; ++j) {
        const double w = weight * part[j];
        Growth& sum = growth_[j];
        sum.weight += w;
        sum.point += w * contact.point_T;
        sum.normal += w * contact.normal_O;
        sum.depth += w * contact.depth_m;
    }
    return true;
}

// Of those whose normal is not against it.
void ContactClusters::put_to_nearest(const NearContact& contact) noexcept {
    std::size_t nearest = n_;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < n_; ++j) {
        const double q = compute_unlikeness(contact, clusters_[j]);
        if (!growth_[j].is_empty && q < least &&
            contact.normal_O.dot(clusters_[j].normal_O) > 0.0) {
            nearest = j;
            least = q;
        }
    }
    if (nearest == n_) {
        return;
    }
    const double w = contact.depth_m + settings_.within_m;
    Growth& sum = growth_[nearest];
    sum.weight += w;
    sum.point += w * contact.point_T;
    sum.normal += w * contact.normal_O;
    sum.depth += w * contact.depth_m;
}

bool ContactClusters::run_round(std::span<const NearContact> near) noexcept {
    begin_round();
    bool all_covered = true;
    for (const NearContact& contact : near) {
        if (has_weight(contact, settings_.within_m) && !share_out(contact)) {
            put_to_nearest(contact);
            all_covered = false;
        }
    }
    move_to_means();
    return all_covered;
}

void ContactClusters::move_to_means() noexcept {
    for (std::size_t j = 0; j < n_; ++j) {
        const Growth& sum = growth_[j];
        const double length = sum.normal.norm();
        // What has no members, or whose members' normals cancel, stays as it was.
        if (!(sum.weight > 0.0) || !(length > 0.0)) {
            continue;
        }
        clusters_[j].point_T = sum.point / sum.weight;
        clusters_[j].normal_O = sum.normal / length;
        clusters_[j].depth_m = sum.depth / sum.weight;
    }
}

// A cluster for the deepest contact that none covers, again and again.
void ContactClusters::bear(std::span<const NearContact> near) noexcept {
    const auto most = static_cast<std::size_t>(settings_.most);
    while (n_ < most) {
        const NearContact* deepest = nullptr;
        for (const NearContact& contact : near) {
            if ((deepest != nullptr && !(contact.depth_m > deepest->depth_m)) ||
                !has_weight(contact, settings_.within_m)) {
                continue;
            }
            const bool covered = std::any_of(
                clusters_.begin(), clusters_.begin() + static_cast<std::ptrdiff_t>(n_),
                [&](const ContactCluster& cluster) {
                    return !growth_[static_cast<std::size_t>(&cluster - clusters_.data())]
                                .is_empty &&
                           compute_unlikeness(contact, cluster) < 1.0;
                });
            deepest = covered ? deepest : &contact;
        }
        if (deepest == nullptr) {
            return;
        }
        clusters_[n_] = {.id = next_id_++,
                         .point_T = deepest->point_T,
                         .normal_O = deepest->normal_O,
                         .depth_m = deepest->depth_m};
        growth_[n_] = {.share = kLeastShare};
        ++n_;
    }
}

// The younger of two that have come together ends, until they part.
void ContactClusters::notice_merging() noexcept {
    for (std::size_t j = 0; j < n_; ++j) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < j; ++i) {
            if (growth_[i].is_empty || growth_[i].ends) {
                continue;
            }
            const NearContact other{clusters_[i].point_T, clusters_[i].normal_O, 0.0};
            least = std::min(least, compute_unlikeness(other, clusters_[j]));
        }
        growth_[j].ends = least < (growth_[j].ends ? kPartAt : kMergeAt);
    }
}

void ContactClusters::age(double dt_s) noexcept {
    const double share = settings_.fade_s > 0.0 ? dt_s / settings_.fade_s : 1.0;
    const double step = share > 0.0 ? std::min(share, 1.0) : 0.0;  // no number: no time
    for (std::size_t j = 0; j < n_; ++j) {
        Growth& growth = growth_[j];
        const bool going = growth.ends || growth.is_empty;
        double& strength = clusters_[j].strength;
        strength = std::clamp(strength + (going ? -step : step), 0.0, 1.0);
        growth.share = std::clamp(growth.share + (going ? -step : step), kLeastShare, 1.0);
    }
}

// In order: older ones stand before younger.
void ContactClusters::drop_ended() noexcept {
    std::size_t kept = 0;
    for (std::size_t j = 0; j < n_; ++j) {
        if (clusters_[j].strength > 0.0) {
            clusters_[kept] = clusters_[j];
            growth_[kept] = growth_[j];
            ++kept;
        }
    }
    n_ = kept;
}

void ContactClusters::update(std::span<const NearContact> near, const Pose& X_OT,
                             double dt_s) noexcept {
    bear(near);
    bool all_covered = true;
    for (int round = 0; round < kRounds; ++round) {
        all_covered = run_round(near);
    }
    radius_m_ = std::clamp(all_covered ? radius_m_ / kNarrows : radius_m_ * kWidens,
                           settings_.radius_m, kWidest * settings_.radius_m);
    for (std::size_t j = 0; j < n_; ++j) {
        growth_[j].is_empty = !(growth_[j].weight > 0.0);
        if (!growth_[j].is_empty) {
            clusters_[j].place_O =
                X_OT * clusters_[j].point_T + clusters_[j].depth_m * clusters_[j].normal_O;
        }
    }
    notice_merging();
    age(dt_s);
    drop_ended();
}

}  // namespace fulcrum
