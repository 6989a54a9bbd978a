#include "haptics/levels/hull_pair.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace fulcrum {

namespace {

// Up to four support points and how the point nearest to the origin is blended of them.
class BlendedSimplex {
  public:
    bool add(const Vector3& on_first, const Vector3& on_second) noexcept {
        const Vector3 way = on_second - on_first;
        for (std::size_t i = 0; i < count_; ++i) {
            if (corners_[i].way == way) {
                return false;
            }
        }
        corners_[count_++] = {way, on_first, on_second, 0.0};
        return true;
    }
    // The nearest point; keeps what it is blended of. `holds_origin` says that it is inside of four.
    Vector3 reduce(bool is_careful) noexcept {
        if (is_careful) {
            keep_nearest_part();
            return blend();
        }
        switch (count_) {
            case 1:
                corners_[0].weight = 1.0;
                break;
            case 2:
                reduce_segment();
                break;
            case 3:
                reduce_triangle();
                break;
            default:
                reduce_tetrahedron();
        }
        return blend();
    }
    [[nodiscard]] Vector3 blend() const noexcept {
        Vector3 nearest = Vector3::Zero();
        for (std::size_t i = 0; i < count_; ++i) {
            nearest += corners_[i].weight * corners_[i].way;
        }
        return nearest;
    }
    [[nodiscard]] bool holds_origin() const noexcept { return count_ == 4; }
    // Four that hold the origin.
    void tell_held(HullPair& pair) const noexcept {
        constexpr double kFlat = 1.0e-6;  // of the edges' box: as good as in a plane
        for (std::size_t i = 0; i < 4; ++i) {
            pair.held[i] = corners_[i].way;
        }
        const Vector3 a = pair.held[1] - pair.held[0];
        const Vector3 b = pair.held[2] - pair.held[0];
        const Vector3 c = pair.held[3] - pair.held[0];
        const double volume = a.cross(b).dot(c);
        pair.is_held =
            volume * volume > kFlat * kFlat * a.squaredNorm() * b.squaredNorm() * c.squaredNorm();
    }
    void tell(HullPair& pair) const noexcept {
        pair.on_first.setZero();
        pair.on_second.setZero();
        for (std::size_t i = 0; i < count_; ++i) {
            pair.on_first += corners_[i].weight * corners_[i].on_first;
            pair.on_second += corners_[i].weight * corners_[i].on_second;
        }
    }

  private:
    struct Corner {
        Vector3 way{Vector3::Zero()};
        Vector3 on_first{Vector3::Zero()};
        Vector3 on_second{Vector3::Zero()};
        double weight = 0.0;
    };

    // Of all its parts, one by one: right where slivers mislead the regions.
    void keep_nearest_part() noexcept {
        BlendedSimplex best;
        double least = std::numeric_limits<double>::infinity();
        const auto try_part = [&](const BlendedSimplex& part) noexcept {
            const double here = part.blend().squaredNorm();
            if (here < least) {
                least = here;
                best = part;
            }
        };
        for (std::size_t i = 0; i < count_; ++i) {
            try_part(pick({i}));
            for (std::size_t j = i + 1; j < count_; ++j) {
                BlendedSimplex edge = pick({i, j});
                edge.reduce_segment();
                try_part(edge);
                for (std::size_t k = j + 1; k < count_; ++k) {
                    BlendedSimplex face = pick({i, j, k});
                    if (face.blend_face()) {
                        try_part(face);
                    }
                }
            }
        }
        *this = best;
    }
    [[nodiscard]] BlendedSimplex pick(std::initializer_list<std::size_t> corners) const noexcept {
        BlendedSimplex part;
        for (const std::size_t corner : corners) {
            part.corners_[part.count_] = corners_[corner];
            part.corners_[part.count_++].weight = 1.0;
        }
        return part;
    }
    // Where the foot of the origin lies within three; false where it does not.
    bool blend_face() noexcept {
        const Vector3 ab = corners_[1].way - corners_[0].way;
        const Vector3 ac = corners_[2].way - corners_[0].way;
        const Vector3 normal = ab.cross(ac);
        const double square = normal.squaredNorm();
        const double b = ac.cross(corners_[0].way).dot(normal);
        const double c = corners_[0].way.cross(ab).dot(normal);
        if (!(square > 0.0) || b < 0.0 || c < 0.0 || b + c > square) {
            return false;
        }
        corners_[1].weight = b / square;
        corners_[2].weight = c / square;
        corners_[0].weight = 1.0 - corners_[1].weight - corners_[2].weight;
        return true;
    }
    void keep_one(std::size_t i) noexcept {
        corners_[0] = corners_[i];
        corners_[0].weight = 1.0;
        count_ = 1;
    }
    // The point at `t` of the way from corner i to corner j.
    void keep_two(std::size_t i, std::size_t j, double t) noexcept {
        const Corner from = corners_[i];
        corners_[1] = corners_[j];
        corners_[0] = from;
        corners_[0].weight = 1.0 - t;
        corners_[1].weight = t;
        count_ = 2;
    }
    void reduce_segment() noexcept {
        const Vector3 along = corners_[1].way - corners_[0].way;
        const double before = -corners_[0].way.dot(along);
        const double length = along.squaredNorm();
        if (!(before > 0.0)) {
            keep_one(0);
        } else if (before >= length) {
            keep_one(1);
        } else {
            keep_two(0, 1, before / length);
        }
    }
    // By the regions of corners, edges and the face.
    void reduce_triangle() noexcept {
        const Vector3 ab = corners_[1].way - corners_[0].way;
        const Vector3 ac = corners_[2].way - corners_[0].way;
        const double d1 = -ab.dot(corners_[0].way);
        const double d2 = -ac.dot(corners_[0].way);
        if (d1 <= 0.0 && d2 <= 0.0) {
            return keep_one(0);
        }
        const double d3 = -ab.dot(corners_[1].way);
        const double d4 = -ac.dot(corners_[1].way);
        if (d3 >= 0.0 && d4 <= d3) {
            return keep_one(1);
        }
        const double vc = d1 * d4 - d3 * d2;
        if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
            return keep_two(0, 1, d1 / (d1 - d3));
        }
        const double d5 = -ab.dot(corners_[2].way);
        const double d6 = -ac.dot(corners_[2].way);
        if (d6 >= 0.0 && d5 <= d6) {
            return keep_one(2);
        }
        const double vb = d5 * d2 - d1 * d6;
        if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
            return keep_two(0, 2, d2 / (d2 - d6));
        }
        const double va = d3 * d6 - d5 * d4;
        if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
            return keep_two(1, 2, (d4 - d3) / ((d4 - d3) + (d5 - d6)));
        }
        const double sum = va + vb + vc;
        corners_[0].weight = va / sum;
        corners_[1].weight = vb / sum;
        corners_[2].weight = vc / sum;
    }
    // Inside, or the nearest of the faces that the origin is in front of; of all faces where it is flat.
    void reduce_tetrahedron() noexcept {
        constexpr std::array<std::array<std::size_t, 4>, 4> kFaces{
            {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}}};
        constexpr double kFlat = 1.0e-12;  // of an edge: a height of mere rounding has no inside
        BlendedSimplex best;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& face : kFaces) {
            const Vector3& a = corners_[face[0]].way;
            const Vector3 normal = (corners_[face[1]].way - a).cross(corners_[face[2]].way - a);
            const Vector3 across = corners_[face[3]].way - a;
            const double inwards = normal.dot(across);
            if (-normal.dot(a) * inwards > 0.0 &&
                std::abs(inwards) > kFlat * normal.norm() * across.norm()) {
                continue;
            }
            BlendedSimplex triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                triangle.corners_[i] = corners_[face[i]];
            }
            triangle.count_ = 3;
            triangle.reduce_triangle();
            const double here = triangle.blend().squaredNorm();
            if (here < least) {
                least = here;
                best = triangle;
            }
        }
        if (std::isfinite(least)) {
            *this = best;
            return;
        }
        // The origin is inside: the blend that gives it, each corner by the volume across from it.
        const auto volume = [this](std::size_t i, std::size_t j, std::size_t k) noexcept {
            return std::abs(corners_[i].way.dot(corners_[j].way.cross(corners_[k].way)));
        };
        const std::array<double, 4> parts{volume(1, 2, 3), volume(0, 2, 3), volume(0, 1, 3),
                                          volume(0, 1, 2)};
        const double sum = parts[0] + parts[1] + parts[2] + parts[3];
        for (std::size_t i = 0; i < 4; ++i) {
            corners_[i].weight = sum > 0.0 ? parts[i] / sum : 0.25;
        }
    }

    std::array<Corner, 4> corners_{};
    std::size_t count_ = 0;
};

HullPair meet(HullPair pair) noexcept {
    pair.gap_m = 0.0;
    pair.least_m = 0.0;
    return pair;
}

// `find_first(d)`: of the first the farthest along d, and so on.
template <class FindFirst, class FindSecond>
HullPair search(const Vector3& start, double enough_m, const FindFirst& find_first,
                const FindSecond& find_second) noexcept {
    constexpr int kMostSteps = 48;
    constexpr double kEnough = 1.0e-9;  // of the distance: what may be left
    constexpr double kMeet = 1.0e-13;   // of the difference's size: no distance
    constexpr double kSure = 1.0e-8;    // likewise: what rounding alone leaves open
    BlendedSimplex simplex;
    bool is_careful = false;
    HullPair pair;
    pair.least_m = -std::numeric_limits<double>::infinity();
    Vector3 v = start;
    double size_m = 0.0;
    double last_m = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostSteps; ++i) {
        const double length_m = v.norm();
        if (!(length_m > kMeet * size_m)) {
            simplex.tell(pair);
            return meet(pair);
        }
        const Vector3 normal = v / length_m;
        const Vector3 on_first = find_first(normal);
        const Vector3 on_second = find_second(Vector3(-normal));
        const Vector3 w = on_second - on_first;
        const double bound_m = normal.dot(w);
        if (bound_m > pair.least_m) {
            pair.least_m = std::max(bound_m, 0.0);
            pair.normal = normal;
        }
        if (bound_m > enough_m) {
            pair.gap_m = bound_m;
            pair.is_far = true;
            return pair;
        }
        size_m = std::max(size_m, w.norm());
        // A simplex that gets no nearer has come as near as rounding lets it.
        const bool is_found = i > 0 && length_m - bound_m <= kEnough * length_m;
        const bool is_stuck = i > 0 && !(length_m < last_m);
        if (is_found || is_stuck || !simplex.add(on_first, on_second)) {
            if (is_found || is_careful || length_m - bound_m <= kSure * size_m) {
                break;
            }
            // Slivers misled it: on with care, from what is left.
            is_careful = true;
            v = simplex.reduce(is_careful);
            last_m = std::numeric_limits<double>::infinity();
            continue;
        }
        last_m = i > 0 ? length_m : last_m;
        v = simplex.reduce(is_careful);
        if (simplex.holds_origin()) {
            simplex.tell(pair);
            simplex.tell_held(pair);
            return meet(pair);
        }
    }
    simplex.tell(pair);
    pair.gap_m = (pair.on_second - pair.on_first).norm();
    pair.least_m = std::min(pair.least_m, pair.gap_m);
    return pair;
}

}  // namespace

const Vector3& HullView::find_support(const Vector3& direction, std::int32_t& at) const noexcept {
    if (first_link.empty()) {
        std::size_t best = 0;
        double most = direction.dot(points[0]);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double here = direction.dot(points[i]);
            if (here > most) {
                most = here;
                best = i;
            }
        }
        return points[best];
    }
    double most = direction.dot(points[static_cast<std::size_t>(at)]);
    for (bool climbs = true; climbs;) {
        climbs = false;
        const auto begin = static_cast<std::size_t>(first_link[static_cast<std::size_t>(at)]);
        const auto end = static_cast<std::size_t>(first_link[static_cast<std::size_t>(at) + 1]);
        for (const std::int32_t link : links.subspan(begin, end - begin)) {
            const double here = direction.dot(points[static_cast<std::size_t>(link)]);
            if (here > most) {
                most = here;
                at = link;
                climbs = true;
            }
        }
    }
    return points[static_cast<std::size_t>(at)];
}

HullPair find_hull_pair(const HullView& first, const HullView& second, const Matrix3& turn,
                        const Vector3& shift, const Vector3& start, double enough_m,
                        HullCorners& at) noexcept {
    return search(
        start, enough_m,
        [&](const Vector3& d) noexcept -> Vector3 { return first.find_support(d, at.first); },
        [&](const Vector3& d) noexcept -> Vector3 {
            return turn * second.find_support(turn.transpose() * d, at.second) + shift;
        });
}

HullPair find_hull_pair(const HullView& first, const HullView& second, const Matrix3& turn,
                        const Vector3& shift, const Vector3& start, double enough_m) noexcept {
    HullCorners at;
    return find_hull_pair(first, second, turn, shift, start, enough_m, at);
}

double measure_along(const HullView& first, const HullView& second, const Matrix3& turn,
                     const Vector3& shift, const Vector3& normal) noexcept {
    const Vector3 back = turn.transpose() * -normal;
    return normal.dot(turn * second.find_support(back) + shift) -
           normal.dot(first.find_support(normal));
}

HullPair find_nearest_in_hull(const HullView& hull, const Vector3& point, const Vector3& start,
                              double enough_m, std::int32_t at) noexcept {
    const Vector3 way = start.squaredNorm() > 0.0 ? start : Vector3(point - hull.points[0]);
    return search(
        way.squaredNorm() > 0.0 ? way : Vector3(Vector3::UnitY()), enough_m,
        [&hull, &at](const Vector3& d) noexcept -> Vector3 { return hull.find_support(d, at); },
        [&point](const Vector3&) noexcept -> Vector3 { return point; });
}

}  // namespace fulcrum
