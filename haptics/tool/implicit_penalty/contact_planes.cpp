#include "haptics/tool/implicit_penalty/contact_planes.h"

#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// From `from` towards `to`, no farther than `most`.
Vector3 go_towards(const Vector3& from, const Vector3& to, double most) noexcept {
    const Vector3 way = to - from;
    const double length = way.norm();
    return length > most ? Vector3(from + (most / length) * way) : to;
}

// Likewise of unit vectors, by no more than that angle; of opposite ones about any axis across.
Vector3 turn_towards(const Vector3& from, const Vector3& to, double most_rad) noexcept {
    if (from == to) {
        return to;
    }
    const Vector3 axis = from.cross(to);
    const double sine = axis.norm();
    const double angle = std::atan2(sine, from.dot(to));
    if (!(angle > most_rad)) {
        return to;
    }
    const Vector3 about = sine > 0.0 ? Vector3(axis / sine) : Vector3(from.unitOrthogonal());
    return (compute_exp(most_rad * about) * from).normalized();
}

}  // namespace

void ContactPlanes::clear() noexcept {
    n_ = 0;
}

void ContactPlanes::learn(const ContactModel& model) noexcept {
    std::for_each(shown_.begin(), shown_.begin() + static_cast<std::ptrdiff_t>(n_),
                  [](Shown& one) { one.is_told = false; });
    for (const ToldContact& told : model.all()) {
        const auto end = shown_.begin() + static_cast<std::ptrdiff_t>(n_);
        auto at = std::find_if(shown_.begin(), end, [&](const Shown& one) {
            return one.id == told.cluster.id && one.object == told.object;
        });
        if (at == end) {
            if (n_ == shown_.size()) {
                continue;  // those that are on their way out first leave room
            }
            // As deep as the layer begins: it pushes nothing yet.
            *at = {told.cluster.id,
                   told.object,
                   told.cluster.point_T,
                   told.cluster.normal_O,
                   told.cluster.place_O,
                   {},
                   true};
            at->place_O =
                told.X_OT * told.cluster.point_T - settings_.within_m * told.cluster.normal_O;
            ++n_;
        }
        at->told = told.cluster;
        at->is_told = true;
    }
}

double ContactPlanes::follow(const Placement& X_OT, double dt_s, Shown& shown) const noexcept {
    const double d_m = settings_.within_m;
    const double rise_m = settings_.rise_m_per_s * dt_s;
    // How far it pushes: above 0 it does.
    const double reach_m = shown.normal_O.dot(shown.place_O - X_OT * shown.point_T) + d_m;
    double aim_m = reach_m - rise_m;
    if (shown.is_told) {
        const ContactCluster& told = shown.told;
        const bool is_free = !(reach_m > 0.0);
        shown.point_T =
            is_free ? told.point_T
                    : go_towards(shown.point_T, told.point_T, settings_.shift_m_per_s * dt_s);
        shown.normal_O =
            is_free ? told.normal_O
                    : turn_towards(shown.normal_O, told.normal_O, settings_.turn_rad_per_s * dt_s);
        // What fades goes back by its share, along with all else that it is told.
        double told_m = told.normal_O.dot(told.place_O - X_OT * told.point_T) + d_m;
        told_m = told_m > 0.0 ? told.strength * told_m : told_m;
        const double from_m = std::max(reach_m, 0.0);
        aim_m = told_m > 0.0 ? std::clamp(told_m, from_m - rise_m, from_m + rise_m)
                             : std::max(told_m, from_m - rise_m);
        aim_m = is_free && !(told_m > 0.0) ? told_m : aim_m;
    }
    shown.place_O = X_OT * shown.point_T + (aim_m - d_m) * shown.normal_O;
    return aim_m;
}

void ContactPlanes::begin_step(const Pose& tool_W, std::span<const MovingFrame> objects,
                               double dt_s) noexcept {
    std::size_t kept = 0;
    std::size_t seen = objects.size();  // the object by which the tool is at X_OT
    Placement X_OT;
    Matrix3 R_WO{Matrix3::Identity()};
    for (std::size_t i = 0; i < n_; ++i) {
        const auto object = static_cast<std::size_t>(shown_[i].object);
        if (object >= objects.size()) {
            continue;
        }
        const MovingFrame& frame = objects[object];
        if (object != seen) {
            seen = object;
            const Pose place = move_evenly(frame, -dt_s).pose_W.inverse() * tool_W;
            X_OT = {place.position, place.orientation.toRotationMatrix()};
            R_WO = frame.pose_W.orientation.toRotationMatrix();
        }
        Shown& shown = shown_[kept];
        if (kept != i) {
            shown = shown_[i];
        }
        const double reach_m = follow(X_OT, dt_s, shown);
        if (!shown.is_told && !(reach_m > 0.0)) {
            continue;
        }
        PlaneContact& plane = planes_[kept];
        plane.point_B = shown.point_T;
        plane.normal_W = R_WO * shown.normal_O;
        plane.plane_point_W =
            frame.pose_W.position + R_WO * shown.place_O + settings_.within_m * plane.normal_W;
        plane.plane_velocity_W = compute_velocity_at(frame, plane.plane_point_W);
        plane.stiffness_N_per_m = settings_.stiffness_N_per_m;
        plane.damping_Ns_per_m = settings_.damping_Ns_per_m;
        ++kept;
    }
    n_ = kept;
}

}  // namespace fulcrum
