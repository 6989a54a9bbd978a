#include "haptics/collision/contact_sweep.h"

#include "haptics/collision/contact_axis.h"
#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// What a body's points may come nearer by turning, m/s.
double find_turning(const MovingShape& body) noexcept {
    const double spin = compute_length(body.velocity_W.angular);
    return spin > 0.0 ? spin * body.radius_m : 0.0;
}

}  // namespace

ContactPlace MovingShape::find_place(double time_s) const noexcept {
    if (velocity_W.angular.isZero(0.0)) {
        return {Vector3(place.position_W + time_s * velocity_W.linear), place.turn_WB};
    }
    const Matrix3 turned = compute_exp(time_s * velocity_W.angular).toRotationMatrix();
    return {Vector3(find_centre(time_s) + turned * (place.position_W - centre_W)),
            Matrix3(turned * place.turn_WB)};
}

double find_meeting_s(const MovingShape& first, const MovingShape& second, double near_m,
                      double end_s) noexcept {
    const Vector3 apart = first.velocity_W.linear - second.velocity_W.linear;
    const double turning = find_turning(first) + find_turning(second);
    double time_s = 0.0;
    std::int32_t last = 0;
    for (int look = 0; look < kMostLooks; ++look) {
        const ContactPlace a = first.find_place(time_s);
        const ContactPlace b = second.find_place(time_s);
        if (!is_finite(a) || !is_finite(b)) {
            return kNever;
        }
        // Seen from one of them that has a middle.
        const bool is_ground = first.shape->kind == ContactShape::Kind::half_space;
        const Vector3 origin = is_ground ? b.position_W : a.position_W;
        const ContactAxis axis = find_contact_axis(
            {first.shape, a.turn_WB, Vector3(a.position_W - origin)},
            {second.shape, b.turn_WB, Vector3(b.position_W - origin)}, kNever, last);
        if (!(axis.gap_m > near_m)) {
            return time_s;
        }
        last = axis.which;
        const double rate = turning - axis.normal_W.dot(apart);
        if (!(rate > 0.0)) {
            return kNever;
        }
        time_s += (axis.gap_m - 0.5 * near_m) / rate;
        if (!(time_s < end_s)) {
            return kNever;
        }
    }
    return time_s;
}

}  // namespace fulcrum
