#include "haptics/continuous/interval_sweep.h"

#include "haptics/continuous/turn_function.h"

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kNoContact = 2.0;

// One elementary contact on its way.
class ElementaryContact {
  public:
    ElementaryContact(const InBetweenMotion& motion, const Triangle& fixed,
                      const MovingTriangle& moving, const SweepBounds& bounds, FeaturePair pair,
                      std::uint8_t fixed_feature, std::uint8_t moving_feature) noexcept
        : motion_(motion),
          fixed_(fixed),
          moving_(moving),
          bounds_(bounds),
          pair_(pair),
          fixed_feature_(fixed_feature),
          moving_feature_(moving_feature),
          heights_(make_turn_function(motion, fixed, moving, pair, fixed_feature, moving_feature,
                                      bounds)),
          shortest_(0.5 * bounds.tolerance_m / motion.find_longest_way_m(moving.reach_m)) {}

    /// The beginning of the first piece of time that may hold a contact, or kNoContact. Adds to `looks`.
    [[nodiscard]] double find_first(double t_begin, double t_end,
                                    std::int32_t& looks) const noexcept;
    [[nodiscard]] NearFeatures find_features(double t) const noexcept {
        return find_nearest_of(pair_, fixed_feature_, moving_feature_, fixed_,
                               moving_.find_place(motion_, t, motion_.turn_at(t)));
    }

  private:
    // Cuts the piece to where roots may be; false where there are none.
    [[nodiscard]] bool cut(Interval& piece) const noexcept;
    // Does the direction between the nearest points at its middle keep them apart all the time?
    [[nodiscard]] bool is_apart(const Interval& piece) const noexcept;

    const InBetweenMotion& motion_;
    const Triangle& fixed_;
    const MovingTriangle& moving_;
    const SweepBounds& bounds_;
    FeaturePair pair_;
    std::uint8_t fixed_feature_;
    std::uint8_t moving_feature_;
    TurnFunction heights_;
    double shortest_;  // a piece that need not be halved
};

bool ElementaryContact::cut(Interval& piece) const noexcept {
    const double most = interval_details::round_up(bounds_.touch_m * heights_.per_m);
    const Interval near{-most, most};
    const SineCosineInterval turn = motion_.turn_over(piece);
    if (is_empty(intersect(heights_.find_value(piece, turn), near))) {
        return false;
    }
    const Interval middle = Interval::at(piece.middle());
    const Interval value = heights_.find_value(middle, motion_.turn_over(middle));
    const Interval rate = heights_.find_rate(piece, turn);
    if (is_empty(intersect(value + rate * (piece - middle), near))) {
        return false;
    }
    if (!rate.contains(0.0)) {
        piece = intersect(piece, middle + (near - value) / rate);
    }
    return !is_empty(piece);
}

bool ElementaryContact::is_apart(const Interval& piece) const noexcept {
    const double t = piece.middle();
    const NearFeatures near = find_features(t);
    const Vector3 between = near.on_moving - near.on_fixed;
    const double length = between.norm();
    if (!(length > bounds_.touch_m)) {
        return false;
    }
    const Vector3 direction = between / length;
    const IntervalVector k{Interval::at(direction.x()), Interval::at(direction.y()),
                           Interval::at(direction.z())};
    const auto along = [&k](const Vector3& v) {
        return v.x() * k[0] + v.y() * k[1] + v.z() * k[2];
    };
    // The farthest that the held feature goes, and what counts as touching; k is as long as 1 but for rounding.
    const std::size_t n_fixed =
        pair_ == FeaturePair::face_vertex ? 3 : (pair_ == FeaturePair::edge_edge ? 2 : 1);
    double highest = -Interval::kInfinite;
    for (std::size_t i = 0; i < n_fixed; ++i) {
        highest = std::max(highest, along(fixed_[(fixed_feature_ + i) % 3]).upper);
    }
    highest = interval_details::round_up(highest + bounds_.touch_m);
    const SineCosineInterval turn = motion_.turn_over(piece);
    const SineCosineInterval turn_middle = motion_.turn_over(Interval::at(t));
    const Interval travel = along(motion_.travel_A());
    const std::size_t n_moving =
        pair_ == FeaturePair::vertex_face ? 3 : (pair_ == FeaturePair::edge_edge ? 2 : 1);
    for (std::size_t i = 0; i < n_moving; ++i) {
        const PointPath& corner = moving_.corners[(moving_feature_ + i) % 3];
        const Interval b = along(corner.b);
        const Interval c = along(corner.c);
        const Interval value =
            along(corner.a) + t * travel + b * turn_middle.cosine + c * turn_middle.sine;
        const Interval rate = travel + motion_.angle_rad() * (c * turn.cosine - b * turn.sine);
        const Interval all = value + rate * (piece - Interval::at(t));
        if (!(all.lower > highest)) {
            return false;
        }
    }
    return true;
}

double ElementaryContact::find_first(double t_begin, double t_end,
                                     std::int32_t& looks) const noexcept {
    // Halves that wait; each is half as long as the one below it, or shorter.
    constexpr std::size_t kDeepest = 64;
    std::array<Interval, kDeepest> waiting{};
    std::size_t n_waiting = 0;
    waiting[n_waiting++] = {t_begin, t_end};
    for (int done = 0; n_waiting > 0; ++done) {
        Interval piece = waiting[--n_waiting];
        const double begin = piece.lower;
        if (done == kMostPieces) {
            return begin;
        }
        ++looks;
        if (!cut(piece) || is_apart(piece)) {
            continue;
        }
        const double middle = piece.middle();
        if (!(piece.upper - piece.lower > shortest_) || !(middle > piece.lower) ||
            !(middle < piece.upper) || n_waiting + 2 > kDeepest) {
            return piece.lower;
        }
        waiting[n_waiting++] = {middle, piece.upper};
        waiting[n_waiting++] = {piece.lower, middle};
    }
    return kNoContact;
}

class FirstOfAll {
  public:
    FirstOfAll(const InBetweenMotion& motion, const Triangle& fixed, const MovingTriangle& moving,
               const SweepBounds& bounds, double t_begin, double t_end) noexcept
        : motion_(motion),
          fixed_(fixed),
          moving_(moving),
          bounds_(bounds),
          t_begin_(t_begin),
          t_end_(t_end) {}

    void look_for(FeaturePair pair, std::uint8_t i, std::uint8_t j) noexcept {
        const ElementaryContact contact(motion_, fixed_, moving_, bounds_, pair, i, j);
        const double t = contact.find_first(t_begin_, t_end_, told_.looks);
        if (t <= t_end_ && (told_.outcome == SweepOutcome::free || t < told_.contact.time)) {
            told_.outcome = SweepOutcome::touching;
            told_.contact.time = t;
            told_.contact.features = contact.find_features(t);
            t_end_ = t;
        }
    }
    [[nodiscard]] TriangleSweep& told() noexcept { return told_; }

  private:
    const InBetweenMotion& motion_;
    const Triangle& fixed_;
    const MovingTriangle& moving_;
    const SweepBounds& bounds_;
    double t_begin_;
    double t_end_;
    TriangleSweep told_{};
};

}  // namespace

TriangleSweep sweep_triangles_by_intervals(const InBetweenMotion& motion, const Triangle& fixed,
                                           const MovingTriangle& moving,
                                           const SweepSettings& settings, double t_begin,
                                           double t_end) noexcept {
    if (!motion.is_valid() || !is_valid(settings) || !is_finite(fixed) || !is_finite(moving) ||
        !(t_begin >= 0.0 && t_begin <= t_end && t_end <= 1.0)) {
        return {.outcome = SweepOutcome::invalid};
    }
    const SweepBounds bounds =
        SweepBounds::of(motion, moving.reach_m, find_reach_m(fixed), settings);
    const Triangle begin = moving.find_place(motion, t_begin, motion.turn_at(t_begin));
    const NearFeatures near_begin = find_nearest_features(fixed, begin);
    if (near_begin.distance_m <= bounds.slack_m || do_cross(fixed, begin)) {
        TriangleSweep told{.outcome = SweepOutcome::overlapping};
        told.contact.time = t_begin;
        told.contact.features = near_begin;
        return told;
    }
    FirstOfAll first(motion, fixed, moving, bounds, t_begin, t_end);
    for (std::uint8_t i = 0; i < 3; ++i) {
        first.look_for(FeaturePair::face_vertex, 0, i);
        first.look_for(FeaturePair::vertex_face, i, 0);
        for (std::uint8_t j = 0; j < 3; ++j) {
            first.look_for(FeaturePair::edge_edge, i, j);
        }
    }
    TriangleSweep& told = first.told();
    const NearFeatures& near = told.contact.features;
    if (told.outcome == SweepOutcome::touching && near.distance_m > 0.0) {
        told.contact.normal_A = (near.on_moving - near.on_fixed) / near.distance_m;
    }
    return told;
}

}  // namespace fulcrum
