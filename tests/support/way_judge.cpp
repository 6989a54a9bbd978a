#include "tests/support/way_judge.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

using LongTriangle = std::array<LongVector, 3>;

// What two triangles' corners, edges and faces are apart, by areas and by solving for both parameters

long double square(const LongVector& v) {
    return v.dot(v);
}

long double corner_to_edge(const LongVector& p, const LongVector& a, const LongVector& b) {
    const LongVector along = b - a;
    const long double length = square(along);
    const long double share =
        length > 0.0L ? std::clamp(along.dot(p - a) / length, 0.0L, 1.0L) : 0.0L;
    return square(p - a - share * along);
}

long double corner_to_face(const LongVector& p, const LongTriangle& t) {
    long double best = std::min({corner_to_edge(p, t[0], t[1]), corner_to_edge(p, t[1], t[2]),
                                 corner_to_edge(p, t[2], t[0])});
    const LongVector normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const long double length = square(normal);
    if (length > 0.0L) {
        bool is_inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
            is_inside = is_inside && normal.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) >= 0.0L;
        }
        const long double height = normal.dot(p - t[0]);
        best = is_inside ? std::min(best, height * height / length) : best;
    }
    return best;
}

// Inside both edges only: their ends are the corners' business.
long double edge_to_edge(const LongVector& a, const LongVector& b, const LongVector& p,
                         const LongVector& q) {
    const LongVector normal = (b - a).cross(q - p);
    const long double length = square(normal);
    constexpr long double kFar = 1.0e300L;
    if (!(length > 0.0L)) {
        return kFar;
    }
    const LongVector between = p - a;
    const long double s = normal.dot(between.cross(q - p)) / length;
    const long double t = normal.dot(between.cross(b - a)) / length;
    if (s < 0.0L || s > 1.0L || t < 0.0L || t > 1.0L) {
        return kFar;
    }
    const long double height = normal.dot(between);
    return height * height / length;
}

// How deep an edge goes through a triangle: the least of what lies on either side of its plane, and of how far from its border. 0: not at all.
long double find_depth(const LongVector& p, const LongVector& q, const LongTriangle& t) {
    const LongVector normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const long double length = normal.norm();
    const long double from = normal.dot(p - t[0]);
    const long double to = normal.dot(q - t[0]);
    if (!(from * to < 0.0L)) {
        return 0.0L;
    }
    const LongVector at = p + from / (from - to) * (q - p);
    long double depth = std::min(std::abs(from), std::abs(to)) / length;
    for (std::size_t i = 0; i < 3; ++i) {
        const LongVector edge = t[(i + 1) % 3] - t[i];
        depth = std::min(depth, normal.dot(edge.cross(at - t[i])) / (length * edge.norm()));
    }
    return std::max(depth, 0.0L);
}

long double find_gap(const LongTriangle& f, const LongTriangle& m) {
    long double best = 1.0e300L;
    long double depth = 0.0L;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t i_next = (i + 1) % 3;
        depth = std::max({depth, find_depth(f[i], f[i_next], m), find_depth(m[i], m[i_next], f)});
        best = std::min({best, corner_to_face(f[i], m), corner_to_face(m[i], f)});
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t j_next = (j + 1) % 3;
            best = std::min({best, edge_to_edge(f[i], f[i_next], m[j], m[j_next]),
                             corner_to_edge(f[i], m[j], m[j_next]),
                             corner_to_edge(m[j], f[i], f[i_next])});
        }
    }
    return depth > 0.0L ? -depth : std::sqrt(best);
}

using LongQuaternion = QuaternionOf<long double>;

}  // namespace

WayJudge::WayJudge(const TrianglePair& pair) {
    const LongQuaternion start = pair.start_AB.orientation.cast<long double>().normalized();
    const LongQuaternion end = pair.end_AB.orientation.cast<long double>().normalized();
    const LongVector pivot = pair.pivot_B.cast<long double>();
    pivot_start_ = start * pivot + pair.start_AB.position.cast<long double>();
    travel_ = end * pivot + pair.end_AB.position.cast<long double>() - pivot_start_;
    LongQuaternion turn = end * start.conjugate();
    if (turn.w() < 0.0L) {
        turn.coeffs() *= -1.0L;
    }
    // Half a turn may go either way round: as the motion does.
    const InBetweenMotion motion = pair.motion();
    if (turn.vec().dot(motion.axis_A().cast<long double>()) < 0.0L && turn.w() < 1.0e-12L) {
        turn.coeffs() *= -1.0L;
    }
    const long double sine = turn.vec().norm();
    angle_ = 2.0L * std::atan2(sine, turn.w());
    axis_ = sine > 0.0L ? LongVector(turn.vec() / sine) : LongVector::UnitX();
    long double reach = 0.0L;
    for (std::size_t i = 0; i < 3; ++i) {
        fixed_[i] = pair.fixed_A[i].cast<long double>();
        arms_[i] = start * LongVector(pair.moving_B[i].cast<long double>() - pivot);
        reach = std::max(reach, arms_[i].norm());
    }
    fastest_ = travel_.norm() + angle_ * reach;
}

std::array<LongVector, 3> WayJudge::find_place(long double t) const {
    const long double sine = std::sin(t * angle_);
    const long double cosine = std::cos(t * angle_);
    std::array<LongVector, 3> place;
    for (std::size_t i = 0; i < 3; ++i) {
        // Rodrigues
        place[i] = pivot_start_ + t * travel_ + cosine * arms_[i] + sine * axis_.cross(arms_[i]) +
                   (1.0L - cosine) * axis_.dot(arms_[i]) * axis_;
    }
    return place;
}

long double WayJudge::find_distance_m(long double t) const {
    return find_gap(fixed_, find_place(t));
}

long double WayJudge::find_valley(long double from, long double to) const {
    for (int i = 0; i < 60; ++i) {
        const long double third = (to - from) / 3.0L;
        if (find_distance_m(from + third) < find_distance_m(to - third)) {
            to -= third;
        } else {
            from += third;
        }
    }
    return 0.5L * (from + to);
}

// Between a time at which they are farther apart and one at which they are not.
long double WayJudge::find_edge(long double near_m, long double far, long double near) const {
    for (int i = 0; i < 50 && find_distance_m(far) > near_m; ++i) {
        const long double middle = 0.5L * (far + near);
        (find_distance_m(middle) > near_m ? far : near) = middle;
    }
    return near;
}

long double WayJudge::find_first(long double near_m, long double from, long double to,
                                 long double finest) const {
    finest /= std::max(1.0L, fastest_);
    constexpr long double kFlat_m = 1.0e-16L;  // falls less are rounding
    long double t = from;
    long double before = from;
    long double gap_before = 1.0e300L;
    bool was_falling = false;
    while (true) {
        const long double gap = find_distance_m(t);
        if (gap <= near_m) {
            return find_edge(near_m, before, t);
        }
        if (was_falling && gap > gap_before && gap_before - near_m < 2.0L * finest * fastest_) {
            const long double bottom = find_valley(std::max(from, before - finest), t);
            if (find_distance_m(bottom) <= near_m) {
                return find_edge(near_m, std::max(from, before - finest), bottom);
            }
        }
        if (t >= to || !(fastest_ > 0.0L)) {
            return 2.0L;
        }
        was_falling = gap < gap_before - kFlat_m;
        before = t;
        gap_before = gap;
        t = std::min(to, t + std::max((gap - near_m) / fastest_, finest));
    }
}

Verdict judge(const TrianglePair& pair, const TriangleSweep& told, const SweepSettings& settings,
              double rounding_m) {
    const WayJudge way(pair);
    const long double touch_m = settings.touch_m;
    const bool is_told = told.outcome != SweepOutcome::free;
    const long double time = is_told ? static_cast<long double>(told.contact.time) : 1.0L;
    Verdict verdict;
    // What the judge finds within the rounding of the places counts as either.
    if (told.outcome != SweepOutcome::overlapping) {
        const long double before = is_told ? std::nextafter(time, 0.0L) : time;
        verdict.is_missed =
            time > 0.0L && way.find_first(touch_m - rounding_m, 0.0L, before) <= before;
    }
    if (told.outcome == SweepOutcome::touching) {
        verdict.is_early = way.find_distance_m(time) >
                           touch_m + settings.tolerance_m * (1.0L + 1.0e-6L) + rounding_m;
    } else if (told.outcome == SweepOutcome::overlapping) {
        verdict.is_early = way.find_distance_m(time) > rounding_m;
    }
    verdict.is_touching =
        verdict.is_missed || (is_told && way.find_first(touch_m + rounding_m, time, 1.0L) <= 1.0L);
    verdict.is_false = is_told && !verdict.is_touching;
    return verdict;
}

}  // namespace fulcrum
