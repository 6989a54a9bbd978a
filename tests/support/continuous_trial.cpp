#include "tests/support/continuous_trial.h"

#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

Triangle draw_triangle(Random& random, double size_m) {
    return {size_m * random.in_cube(), size_m * random.in_cube(), size_m * random.in_cube()};
}

Triangle moved(const Triangle& triangle, const Vector3& by) {
    return {triangle[0] + by, triangle[1] + by, triangle[2] + by};
}

double draw_power(Random& random, double least, double most) {
    return std::pow(10.0, least + (most - least) * (0.5 + 0.5 * random.uniform()));
}

// A millionth to a billionth of a metre, of either sign.
double draw_gap(Random& random) {
    return (random.uniform() < 0.0 ? -1.0 : 1.0) * draw_power(random, -9.0, -6.0);
}

Vector3 draw_across(Random& random, const Vector3& direction) {
    return direction.cross(random.direction()).normalized();
}

TrianglePair draw_turning(Random& random) {
    TrianglePair pair;
    pair.fixed_A = draw_triangle(random, 0.5);
    pair.moving_B = draw_triangle(random, 0.5);
    pair.start_AB = {random.in_cube(), random.turn(M_PI)};
    pair.end_AB = {random.in_cube(), random.turn(M_PI)};
    pair.pivot_B = 0.5 * random.in_cube();
    return pair;
}

struct Moment {
    Triangle place;
    std::array<Vector3, 3> rates;
};

// The moving triangle in the middle of its way.
Moment find_middle(const TrianglePair& pair) {
    const InBetweenMotion motion = pair.motion();
    const SineCosine turn = motion.turn_at(0.5);
    Moment moment;
    for (std::size_t i = 0; i < 3; ++i) {
        const PointPath path = motion.find_path(pair.moving_B[i]);
        moment.place[i] = motion.find_place(path, 0.5, turn);
        moment.rates[i] = motion.find_rate(path, turn);
    }
    return moment;
}

// The held face lies along the moving corner's way, a gap beside it.
TrianglePair draw_grazing_corner(Random& random) {
    TrianglePair pair = draw_turning(random);
    const Moment moment = find_middle(pair);
    const Vector3 normal = draw_across(random, moment.rates[0]);
    const Vector3 u = draw_across(random, normal);
    const Vector3 v = normal.cross(u);
    const Vector3 at = moment.place[0] + draw_gap(random) * normal;
    pair.fixed_A = {at + u, at - 0.5 * u + 0.8 * v, at - 0.5 * u - 0.8 * v};
    return pair;
}

TrianglePair draw_grazing_edge(Random& random) {
    TrianglePair pair = draw_turning(random);
    const Moment moment = find_middle(pair);
    const Vector3 edge = moment.place[1] - moment.place[0];
    const Vector3 rate = 0.5 * (moment.rates[0] + moment.rates[1]);
    // Across the edge and the way: passing sideways.
    const Vector3 normal = edge.cross(rate).normalized();
    const Vector3 at = 0.5 * (moment.place[0] + moment.place[1]) + draw_gap(random) * normal;
    const Vector3 along = normal.cross(random.direction()).normalized();
    pair.fixed_A = {at - 0.6 * along, at + 0.7 * along, at + normal + 0.1 * along};
    return pair;
}

TrianglePair draw_sliding(Random& random) {
    TrianglePair pair;
    const Quaternion turn = random.turn(M_PI);
    const auto in_plane = [&] {
        return Vector3(turn * Vector3(random.uniform(), random.uniform(), 0.0));
    };
    pair.fixed_A = {in_plane(), in_plane(), in_plane()};
    const Vector3 gap = draw_gap(random) * (turn * Vector3::UnitZ());
    pair.moving_B = moved({in_plane(), in_plane(), in_plane()}, gap);
    pair.start_AB = Pose::at(2.0 * in_plane());
    pair.end_AB = Pose::at(2.0 * in_plane());
    return pair;
}

TrianglePair draw_coincident(Random& random) {
    TrianglePair pair = draw_turning(random);
    if (random.uniform() < 0.0) {  // no turn: the edges come on parallel
        pair.end_AB.orientation = pair.start_AB.orientation;
    }
    const Moment moment = find_middle(pair);
    const double gap = random.uniform() < 0.0 ? 0.0 : draw_gap(random);
    const Vector3 beside = gap * random.direction();
    const Vector3 along = random.uniform() * (moment.place[1] - moment.place[0]);
    pair.fixed_A = {moment.place[0] + beside + along, moment.place[1] + beside + along,
                    moment.place[0] + random.in_cube()};
    return pair;
}

Triangle draw_sliver(Random& random) {
    const Vector3 a = 0.5 * random.in_cube();
    const Vector3 b = 0.5 * random.in_cube();
    switch (random.integer() % 4) {
        case 0:
            return {a, a, a};
        case 1:
            return {a, b, b};
        case 2:
            return {a, b, 0.25 * a + 0.75 * b};
        default:
            return {a, b, 0.5 * (a + b) + draw_power(random, -15.0, -4.0) * random.direction()};
    }
}

TrianglePair draw_slivers(Random& random) {
    TrianglePair pair = draw_turning(random);
    pair.moving_B = draw_sliver(random);
    const auto kind = random.integer() % 3;
    pair.fixed_A = kind == 0 ? draw_sliver(random) : draw_triangle(random, 0.5);
    if (kind == 1) {  // aimed
        const Moment moment = find_middle(pair);
        const Vector3 on = 0.3 * pair.fixed_A[0] + 0.3 * pair.fixed_A[1] + 0.4 * pair.fixed_A[2];
        pair.fixed_A =
            moved(pair.fixed_A, moment.place[2] - on + draw_gap(random) * random.direction());
    }
    return pair;
}

TrianglePair draw_half_turn(Random& random) {
    TrianglePair pair = draw_turning(random);
    const double angle = M_PI - (random.uniform() < 0.0 ? 0.0 : draw_power(random, -9.0, -1.0));
    pair.end_AB.orientation = compute_exp(angle * random.direction()) * pair.start_AB.orientation;
    pair.end_AB.position =
        pair.start_AB.position + draw_power(random, -6.0, 0.0) * random.in_cube();
    const Vector3 arm = 5.0 * random.direction();
    pair.moving_B = moved(pair.moving_B, arm);
    const Moment moment = find_middle(pair);
    pair.fixed_A = moved(pair.fixed_A, moment.place[0] - pair.fixed_A[0] + 0.3 * random.in_cube());
    return pair;
}

// Coordinates are multiples of 1/64, so all of it lies in one plane to the last bit.
TrianglePair draw_in_plane(Random& random) {
    const auto place = [&random](double size) {
        return Vector3(std::round(64.0 * size * random.uniform()) / 64.0,
                       std::round(64.0 * size * random.uniform()) / 64.0, 0.0);
    };
    TrianglePair pair;
    pair.fixed_A = {place(0.5), place(0.5), place(0.5)};
    pair.moving_B = {place(0.5), place(0.5), place(0.5)};
    pair.start_AB = Pose::at(place(2.0));
    pair.end_AB = Pose::at(place(2.0));
    if (random.uniform() < 0.0) {
        pair.end_AB.orientation = compute_exp({0.0, 0.0, M_PI * random.uniform()});
    }
    return pair;
}

TrianglePair draw_on_corner(Random& random) {
    TrianglePair pair = draw_turning(random);
    const Moment moment = find_middle(pair);
    const double share = random.uniform() < 0.0 ? 0.0 : 0.5 + 0.5 * random.uniform();
    const Vector3 on = (1.0 - share) * pair.fixed_A[0] + share * pair.fixed_A[1];
    const double gap = random.uniform() < 0.0 ? 0.0 : draw_gap(random);
    pair.fixed_A = moved(pair.fixed_A, moment.place[0] - on + gap * random.direction());
    return pair;
}

TrianglePair draw_at_end(Random& random) {
    TrianglePair pair = draw_turning(random);
    const bool at_begin = random.uniform() < 0.0;
    const Pose& pose = at_begin ? pair.start_AB : pair.end_AB;
    // The corner that is lowest along the normal lies a gap over the face.
    const Vector3 normal =
        (pair.fixed_A[1] - pair.fixed_A[0]).cross(pair.fixed_A[2] - pair.fixed_A[0]).normalized();
    Vector3 lowest = pose * pair.moving_B[0];
    for (const Vector3& corner : pair.moving_B) {
        const Vector3 place = pose * corner;
        lowest = normal.dot(place) < normal.dot(lowest) ? place : lowest;
    }
    const Vector3 on = (pair.fixed_A[0] + pair.fixed_A[1] + pair.fixed_A[2]) / 3.0;
    pair.fixed_A = moved(pair.fixed_A, lowest - on - draw_gap(random) * normal);
    const Pose other{pose.position + draw_power(random, -3.0, 0.0) * random.direction() + normal,
                     random.turn(0.3) * pose.orientation};
    (at_begin ? pair.end_AB : pair.start_AB) = other;
    return pair;
}

TrianglePair draw_still(Random& random) {
    TrianglePair pair = draw_at_end(random);
    const Pose at = random.uniform() < 0.0 ? pair.start_AB : pair.end_AB;
    pair.start_AB = at;
    pair.end_AB = at;
    if (random.uniform() < 0.0) {
        pair.end_AB.position += draw_power(random, -16.0, -5.0) * random.direction();
        pair.end_AB.orientation =
            compute_exp(draw_power(random, -16.0, -5.0) * random.direction()) * at.orientation;
    }
    return pair;
}

TrianglePair draw_fast(Random& random) {
    TrianglePair pair = draw_turning(random);
    const Vector3 way = 500.0 * random.direction();
    pair.start_AB.position -= way;
    pair.end_AB.position += way;
    const Moment moment = find_middle(pair);
    pair.fixed_A = moved(pair.fixed_A, moment.place[0] - pair.fixed_A[0] + 0.4 * random.in_cube());
    return pair;
}

TrianglePair draw_far(Random& random) {
    TrianglePair pair = draw_hard_pair(random, static_cast<int>(random.integer() % 9));
    const Vector3 away = 1000.0 * random.direction();
    pair.fixed_A = moved(pair.fixed_A, away);
    pair.start_AB.position += away;
    pair.end_AB.position += away;
    return pair;
}

}  // namespace

TrianglePair draw_pair(Random& random) {
    TrianglePair pair = draw_turning(random);
    const double size = draw_power(random, -1.5, 0.3);
    pair.moving_B = draw_triangle(random, size);
    if (random.uniform() < 0.0) {  // a step of a hand, not a throw
        const double small = draw_power(random, -4.0, 0.0);
        pair.end_AB = {pair.start_AB.position + small * random.in_cube(),
                       random.turn(small) * pair.start_AB.orientation};
    }
    return pair;
}

TrianglePair draw_hard_pair(Random& random, int kind) {
    using Draw = TrianglePair (*)(Random&);
    static constexpr std::array<Draw, kHardPairs> kDraws{
        draw_grazing_corner, draw_sliding,   draw_coincident, draw_grazing_edge,
        draw_slivers,        draw_half_turn, draw_in_plane,   draw_on_corner,
        draw_at_end,         draw_still,     draw_fast,       draw_far};
    return kDraws[static_cast<std::size_t>(kind)](random);
}

}  // namespace fulcrum
