#include "haptics/tool/god_object/god_front.h"

#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kRounded = 1.0e-9;       // of lengths: more than any rounding here
constexpr double kFrameError = 2.0e-6;    // of a box's size: its axes are single numbers
constexpr std::size_t kFrontBlock = 128;  // places
constexpr std::size_t kTidied = 256;      // places of two, each time, and parents
constexpr std::size_t kTried = 16;
constexpr int kMostInVain = 6;  // after so many each time twice as many are left out
// Two trees of 2^31 triangles, a pair waiting at each step down.
constexpr int kDeep = 512;

double find_highest_m(const Triangle& corners, const Vector3& along) noexcept {
    return std::max({along.dot(corners[0]), along.dot(corners[1]), along.dot(corners[2])});
}

double find_lowest_m(const Triangle& corners, const Vector3& along) noexcept {
    return std::min({along.dot(corners[0]), along.dot(corners[1]), along.dot(corners[2])});
}

Vector3 find_middle(const OrientedBox& box) noexcept {
    return -box.from_centre(Vector3::Zero());
}

// From the middle to the farthest place along a unit direction.
double find_reach_m(const OrientedBox& box, const Vector3& direction) noexcept {
    double reach_m = 0.0;
    double size_m = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto half_m = static_cast<double>(box.half_size[i]);
        reach_m += half_m * std::abs(direction.dot(box.axis(i)));
        size_m += half_m;
    }
    return reach_m + kFrameError * size_m;
}

float find_size(const OrientedBox& box) noexcept {
    return box.half_size[0] * box.half_size[0] + box.half_size[1] * box.half_size[1] +
           box.half_size[2] * box.half_size[2];
}

Vector3 find_face_normal(const Triangle& t) noexcept {
    return (t[1] - t[0]).cross(t[2] - t[0]);
}

}  // namespace

GodPlace GodPlace::of(const SweptMesh& object, const SweptMesh& tool, const Pose& X_OT) noexcept {
    return {X_OT, X_OT.orientation.toRotationMatrix(),
            kRounded * (object.reach_m() + tool.reach_m() + X_OT.position.norm())};
}

double find_way_m(const SweptMesh& object, const SweptMesh& tool, const Pose& from_OT,
                  const Pose& to_OT) noexcept {
    const double reach_m = tool.reach_m();
    const double turn =
        compute_log((to_OT.orientation * from_OT.orientation.conjugate()).normalized()).norm();
    const double lengths_m = reach_m + object.reach_m() + from_OT.position.norm();
    return (to_OT.position - from_OT.position).norm() + turn * reach_m + kRounded * lengths_m;
}

double find_apart_m(const GodNear& near, const Triangle& tool_own, const GodPlace& place) noexcept {
    const Vector3 direction_T = place.R_OT.transpose() * near.direction_O;
    return find_lowest_m(tool_own, direction_T) + near.direction_O.dot(place.X_OT.position) -
           near.level_m - place.rounded_m;
}

GodFront::GodFront(const SweptMesh& object, const SweptMesh& tool, int most_pairs)
    : object_(&object),
      tool_(&tool),
      pairs_(2 * static_cast<std::size_t>(most_pairs)),
      due_(kFrontBlock * (pairs_.size() / kFrontBlock + 1), kNever),
      block_due_(due_.size() / kFrontBlock, kNever),
      free_(most_pairs),
      used_up_(2 * most_pairs),
      near_(2 * most_pairs),
      waiting_(kDeep) {
    forget();
}

std::size_t GodFront::memory_bytes() const noexcept {
    return pairs_.size() * sizeof(Pair) + (due_.size() + block_due_.size()) * sizeof(double) +
           (free_.capacity() + used_up_.capacity() + near_.capacity() + waiting_.capacity()) *
               sizeof(std::int32_t);
}

std::size_t GodFront::size() const noexcept {
    return end_ - 2 * free_.count();
}

void GodFront::forget() noexcept {
    std::fill(due_.begin(), due_.begin() + static_cast<std::ptrdiff_t>(end_), kNever);
    std::ranges::fill(block_due_, kNever);
    free_.clear();
    end_ = 2;
    tidied_ = 0;
    way_m_ = 0.0;
    place_pair(0, object_->root(), tool_->root(), -1);
    set_due(0, -kNever);
}

void GodFront::place_pair(std::int32_t i, std::int32_t object_node, std::int32_t tool_node,
                          std::int32_t parent) noexcept {
    Pair& pair = at(i);
    pair = {.object_node = object_node, .tool_node = tool_node, .parent = parent};
    if (object_->boxes().first_child(object_node) < 0 &&
        tool_->boxes().first_child(tool_node) < 0) {
        pair.is_triangles = true;
        pair.near.object_triangle = object_->boxes().triangles_of(object_node).front();
        pair.near.tool_triangle = tool_->boxes().triangles_of(tool_node).front();
    }
}

double GodFront::find_level_m(const Pair& pair, const Vector3& direction_O) const noexcept {
    if (pair.is_triangles) {
        return find_highest_m(object_->triangle(pair.near.object_triangle), direction_O);
    }
    const OrientedBox& box = object_->boxes().box(pair.object_node);
    return direction_O.dot(find_middle(box)) + find_reach_m(box, direction_O);
}

double GodFront::find_apart_m(const Pair& pair, const GodPlace& place) const noexcept {
    if (pair.is_triangles) {
        return fulcrum::find_apart_m(pair.near, tool_->triangle(pair.near.tool_triangle), place);
    }
    const Vector3 direction_T = place.R_OT.transpose() * pair.near.direction_O;
    const OrientedBox& box = tool_->boxes().box(pair.tool_node);
    return direction_T.dot(find_middle(box)) - find_reach_m(box, direction_T) +
           pair.near.direction_O.dot(place.X_OT.position) - pair.near.level_m - place.rounded_m;
}

double GodFront::turn_boxes(Pair& pair, const GodPlace& place) const noexcept {
    const OrientedBox& held = object_->boxes().box(pair.object_node);
    const OrientedBox& moving = tool_->boxes().box(pair.tool_node);
    const Vector3 between =
        place.R_OT * find_middle(moving) + place.X_OT.position - find_middle(held);
    double best_m = -kNever;
    GodNear best = pair.near;
    const auto offer = [&](const Vector3& along) {
        const double length = along.norm();
        if (!(length > 0.0)) {
            return;
        }
        // Towards the tool.
        pair.near.direction_O = along / (along.dot(between) < 0.0 ? -length : length);
        pair.near.level_m = find_level_m(pair, pair.near.direction_O);
        if (const double apart_m = find_apart_m(pair, place); apart_m > best_m) {
            best_m = apart_m;
            best = pair.near;
        }
    };
    offer(between);
    for (std::size_t i = 0; i < 3; ++i) {
        offer(held.axis(i));
        offer(place.R_OT * moving.axis(i));
    }
    pair.near = best;
    return best_m;
}

double GodFront::turn_triangles(Pair& pair, const GodPlace& place, double best_m) const noexcept {
    const Triangle held = object_->triangle(pair.near.object_triangle);
    const Triangle moving = place.corners(tool_->triangle(pair.near.tool_triangle));
    for (const Vector3& along :
         {find_face_normal(held), find_face_normal(moving),
          Vector3(moving[0] + moving[1] + moving[2] - held[0] - held[1] - held[2])}) {
        const double length = along.norm();
        for (const double sign : {1.0, -1.0}) {
            const Vector3 direction = sign * along / length;
            const double level_m = find_highest_m(held, direction);
            // False where there is no such direction.
            if (const double apart_m = find_lowest_m(moving, direction) - level_m - place.rounded_m;
                apart_m > best_m) {
                best_m = apart_m;
                pair.near.direction_O = direction;
                pair.near.level_m = level_m;
            }
        }
    }
    return best_m;
}

double GodFront::aim(std::int32_t i, const GodPlace& place) noexcept {
    GodNear& near = at(i).near;
    const Triangle held = object_->triangle(near.object_triangle);
    const NearFeatures features =
        find_nearest_features(held, place.corners(tool_->triangle(near.tool_triangle)));
    if (features.distance_m > place.rounded_m) {
        near.direction_O = (features.on_moving - features.on_fixed) / features.distance_m;
        near.level_m = find_highest_m(held, near.direction_O);
    }
    return features.distance_m;
}

void GodFront::aim_at_times(std::int32_t i, const GodPlace& place, double within_m) noexcept {
    Pair& pair = at(i);
    if (pair.waits > 0) {
        --pair.waits;
        return;
    }
    const bool is_near = aim(i, place) <= within_m;
    pair.in_vain = is_near ? static_cast<std::uint8_t>(std::min(pair.in_vain + 1, kMostInVain))
                           : std::uint8_t{0};
    pair.waits = static_cast<std::uint8_t>((1U << pair.in_vain) - 1U);
}

bool GodFront::split(std::int32_t i, const GodPlace& place) noexcept {
    std::int32_t first = static_cast<std::int32_t>(end_);
    if (free_.count() > 0) {
        first = free_.take_last();
    } else if (end_ == pairs_.size()) {
        return false;
    } else {
        end_ += 2;
    }
    Pair& pair = at(i);
    const ObbForest& held = object_->boxes();
    const ObbForest& moving = tool_->boxes();
    const std::int32_t held_child = held.first_child(pair.object_node);
    const std::int32_t moving_child = moving.first_child(pair.tool_node);
    const bool splits_held =
        moving_child < 0 || (held_child >= 0 && find_size(held.box(pair.object_node)) >=
                                                    find_size(moving.box(pair.tool_node)));
    for (std::int32_t k = 0; k < 2; ++k) {
        place_pair(first + k, splits_held ? held_child + k : pair.object_node,
                   splits_held ? pair.tool_node : moving_child + k, i);
        Pair& child = at(first + k);
        child.near.direction_O = pair.near.direction_O;
        if (child.is_triangles) {
            turn_triangles(child, place, -kNever);
        } else {
            child.near.level_m = find_level_m(child, child.near.direction_O);
        }
        set_due(first + k, -kNever);  // not looked at yet
    }
    pair.first_child = first;
    set_due(i, kNever);
    return true;
}

GodLook GodFront::look_at(std::int32_t top, const GodPlace& place, double reach_m,
                          std::size_t most) noexcept {
    waiting_.clear();
    (void)waiting_.add(top);
    while (waiting_.count() > 0) {
        const std::int32_t i = waiting_.take_last();
        Pair& pair = at(i);
        double apart_m = find_apart_m(pair, place);
        if (apart_m <= reach_m && pair.is_triangles) {
            // What was aimed in vain of late lies as near as it seems.
            apart_m = pair.waits > 0 ? apart_m : turn_triangles(pair, place, apart_m);
        } else if (apart_m <= reach_m) {
            apart_m = turn_boxes(pair, place);
            if (apart_m <= reach_m) {
                if (waiting_.count() + 2 > waiting_.capacity() || !split(i, place)) {
                    return GodLook::no_room;
                }
                (void)waiting_.add(pair.first_child + 1);
                (void)waiting_.add(pair.first_child);
                continue;
            }
        }
        set_due(i, way_m_ + apart_m);
        if (apart_m <= reach_m) {
            (void)near_.add(i);
        }
        if (near_.count() > most) {
            return GodLook::too_many;
        }
    }
    return GodLook::whole;
}

void GodFront::set_due(std::int32_t i, double due_m) noexcept {
    const auto place = static_cast<std::size_t>(i);
    due_[place] = due_m;
    block_due_[place / kFrontBlock] = std::min(block_due_[place / kFrontBlock], due_m);
}

void GodFront::list_used_up(double end_m) noexcept {
    used_up_.clear();
    for (std::size_t begin = 0; begin < end_; begin += kFrontBlock) {
        double& least_m = block_due_[begin / kFrontBlock];
        if (least_m > end_m) {
            continue;
        }
        // It may have been of one that is due later now.
        least_m = Matrix<double, kFrontBlock, 1>(due_.data() + begin).minCoeff();
        for (std::size_t i = begin; least_m <= end_m && i < begin + kFrontBlock; ++i) {
            if (due_[i] <= end_m) {
                (void)used_up_.add(static_cast<std::int32_t>(i));
            }
        }
    }
}

GodLook GodFront::look(const GodPlace& place, double reach_m, std::size_t most) noexcept {
    if (!is_finite(place.X_OT) || !(place.rounded_m < kNever)) {
        near_.clear();
        forget();
        return GodLook::no_room;
    }
    const bool has_moved = at_OT_.position != place.X_OT.position ||
                           at_OT_.orientation.coeffs() != place.X_OT.orientation.coeffs();
    if (has_moved && due_.front() > -kNever) {
        way_m_ += find_way_m(*object_, *tool_, at_OT_, place.X_OT);
    }
    at_OT_ = place.X_OT;
    near_.clear();
    list_used_up(way_m_ + reach_m);
    for (const std::int32_t i : used_up_.all()) {
        const GodLook looked = look_at(i, place, reach_m, most);
        if (looked == GodLook::no_room) {
            forget();
        }
        if (looked != GodLook::whole) {
            return looked;
        }
    }
    return GodLook::whole;
}

void GodFront::tidy(const GodPlace& place, double far_m) noexcept {
    std::size_t n_tried = 0;
    for (std::size_t n = 0; n < kTidied && n_tried < kTried && end_ > 2; ++n) {
        tidied_ = tidied_ + 2 < end_ ? tidied_ + 2 : 2;
        const auto first = static_cast<std::int32_t>(tidied_);
        // What holds no two pairs of the front.
        if (std::max(due(first), due(first + 1)) == kNever) {
            continue;
        }
        ++n_tried;
        const std::int32_t above = at(first).parent;
        Pair& parent = at(above);
        const double apart_m = turn_boxes(parent, place);
        if (apart_m > far_m) {
            set_due(first, kNever);
            set_due(first + 1, kNever);
            parent.first_child = -1;
            set_due(above, way_m_ + apart_m);
            (void)free_.add(first);
        }
    }
}

}  // namespace fulcrum
