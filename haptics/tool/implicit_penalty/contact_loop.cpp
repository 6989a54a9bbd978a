#include "haptics/tool/implicit_penalty/contact_loop.h"

#include "haptics/base/clock.h"
#include "haptics/math/spatial.h"

#include <algorithm>

namespace fulcrum {
namespace {

bool is_place(const ToolPlace& place) noexcept {
    return place.stamp_s >= 0.0 && is_finite(place.tool) &&
           are_finite(std::span(place.objects).first(static_cast<std::size_t>(place.n_objects)));
}

ToldContact tell_cluster(const ToolPlace& place, std::size_t i,
                         const ContactCluster& cluster) noexcept {
    const MovingFrame& object = place.objects[i];
    const Quaternion q_OW = object.pose_W.orientation.conjugate();
    const Pose X_OT = object.pose_W.inverse() * place.tool.pose_W;
    const Twist seen_O{q_OW * Vector3(place.tool.velocity_W.linear -
                                      compute_velocity_at(object, place.tool.pose_W.position)),
                       q_OW * Vector3(place.tool.velocity_W.angular - object.velocity_W.angular)};
    return {static_cast<std::int32_t>(i), cluster, X_OT, seen_O};
}

}  // namespace

// Of each object its oldest first, then of each the next: so none that is near goes without, as long as there is room for one of each.
void ContactLoop::tell(const ToolPlace& place) noexcept {
    model_.n = 0;
    bool is_whole = false;
    for (std::size_t nth = 0; !is_whole; ++nth) {
        is_whole = true;
        for (std::size_t i = 0; i < finders_.size(); ++i) {
            const std::span<const ContactCluster> clusters = clusters_[i].all();
            if (nth >= clusters.size()) {
                continue;
            }
            if (model_.n == kMostClusters) {
                model_.is_cut = true;
                return;
            }
            is_whole = false;
            model_.contacts[static_cast<std::size_t>(model_.n++)] =
                tell_cluster(place, i, clusters[nth]);
        }
    }
}

void ContactLoop::share_time(std::size_t object, double began_s) noexcept {
    constexpr double kLeast_us = 1.0;
    const auto after = std::span(clusters_).subspan(object + 1);
    const auto n_near =
        std::ranges::count_if(after, [](const ContactClusters& one) { return !one.all().empty(); });
    const double left_us = settings_.budget_us - 1.0e6 * (monotonic_now_s() - began_s);
    finders_[object]->limit(std::max(left_us / static_cast<double>(1 + n_near), kLeast_us));
}

bool ContactLoop::is_free(const Pose& tool_W, std::span<const MovingFrame> objects,
                          double within_m) noexcept {
    if (objects.size() != finders_.size()) {
        return false;
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const Pose X_OT = objects[i].pose_W.inverse() * tool_W;
        near_.clear();
        finders_[i]->limit(settings_.budget_us / static_cast<double>(objects.size()));
        finders_[i]->find(X_OT, within_m, near_);
        if (near_.count() > 0 || finders_[i]->is_cut() || finders_[i]->is_enclosed(X_OT)) {
            return false;
        }
    }
    return true;
}

bool ContactLoop::run_once() noexcept {
    if (!channels_.place.take()) {
        return false;
    }
    const ToolPlace& place = channels_.place.value();
    if (static_cast<std::size_t>(place.n_objects) != finders_.size() || !is_place(place)) {
        return false;
    }
    if (listener_ != nullptr) {
        listener_->begins_round();
    }
    look(place);
    channels_.model.publish(model_);
    if (listener_ != nullptr) {
        listener_->ended_round();
    }
    return true;
}

void ContactLoop::look(const ToolPlace& place) noexcept {
    if (place.n_placements != n_placements_) {
        n_placements_ = place.n_placements;
        model_.stamp_s = -1.0;
        std::ranges::for_each(clusters_, [](ContactClusters& one) { one.clear(); });
    }
    const double dt_s = model_.stamp_s < 0.0 ? 0.0 : std::max(place.stamp_s - model_.stamp_s, 0.0);
    model_.n_near = 0;
    model_.is_cut = false;
    const bool has_budget = settings_.budget_us > 0.0;
    const double began_s = has_budget ? monotonic_now_s() : 0.0;
    for (std::size_t i = 0; i < finders_.size(); ++i) {
        const Pose X_OT = place.objects[i].pose_W.inverse() * place.tool.pose_W;
        near_.clear();
        if (has_budget) {
            share_time(i, began_s);
        }
        finders_[i]->find(X_OT, settings_.clusters.within_m, near_);
        model_.is_cut = model_.is_cut || finders_[i]->is_cut();
        model_.n_near += static_cast<std::int32_t>(near_.count());
        clusters_[i].update(near_.all(), X_OT, dt_s);
    }
    tell(place);
    model_.stamp_s = place.stamp_s;
    model_.n_placements = place.n_placements;
}

}  // namespace fulcrum
