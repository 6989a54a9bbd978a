#include "haptics/collision/convex_depth.h"

#include <limits>
#include <utility>

namespace fulcrum {
namespace {

// Of the first corners' extent: what is no more than this beyond a face is in its plane.
constexpr double kBeyondFace = 1.0e-10;
// A triangle's height over its longest edge below which it has no direction.
constexpr double kThin = 1.0e-9;

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
GrowingHull::GrowingHull(const std::array<Vector3, 4>& corners) noexcept {
    for (std::size_t i = 0; i < 4; ++i) {
        corners_[i] = corners[i];
    }
    least_m_ = kBeyondFace * (corners[1] - corners[0]).norm();
    const double volume =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]);
    const std::uint8_t b = volume > 0.0 ? 2 : 1;
    const std::uint8_t c = volume > 0.0 ? 1 : 2;
    add_face(0, b, c);
    add_face(0, 3, b);
    add_face(b, 3, c);
    add_face(c, 3, 0);
}

// A face without area keeps its place among its neighbours, but no point is beyond it and it is never the nearest.
void GrowingHull::add_face(std::uint8_t a, std::uint8_t b, std::uint8_t c) noexcept {
    Face& face = faces_[static_cast<std::size_t>(n_faces_++)];
    face.corners = {a, b, c};
    const Vector3 ab = corners_[b] - corners_[a];
    const Vector3 ac = corners_[c] - corners_[a];
    const Vector3 normal = ab.cross(ac);
    const double length = normal.norm();
    const double longest = std::max(ab.squaredNorm(), ac.squaredNorm());
    if (length > kThin * longest) {
        face.normal = normal / length;
        face.offset_m = face.normal.dot(corners_[a]);
    } else {
        face.normal = Vector3::Zero();
        face.offset_m = std::numeric_limits<double>::infinity();
    }
}

void GrowingHull::remove_face(int i) noexcept {
    const Face& face = faces_[static_cast<std::size_t>(i)];
    const auto [a, b, c] = face.corners;
    toggle_edge(a, b);
    toggle_edge(b, c);
    toggle_edge(c, a);
    faces_[static_cast<std::size_t>(i)] = faces_[static_cast<std::size_t>(--n_faces_)];
}

// An edge between two faces that both go is no border.
void GrowingHull::toggle_edge(std::uint8_t from, std::uint8_t to) noexcept {
    for (int i = 0; i < n_border_; ++i) {
        const Edge& edge = border_[static_cast<std::size_t>(i)];
        if (edge.from == to && edge.to == from) {
            border_[static_cast<std::size_t>(i)] = border_[static_cast<std::size_t>(--n_border_)];
            return;
        }
    }
    if (n_border_ < kMostFaces) {
        border_[static_cast<std::size_t>(n_border_++)] = {from, to};
    }
}

const GrowingHull::Face& GrowingHull::find_nearest() const noexcept {
    std::size_t best = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(n_faces_); ++i) {
        if (faces_[i].offset_m < faces_[best].offset_m) {
            best = i;
        }
    }
    return faces_[best];
}

bool GrowingHull::grow(const Vector3& corner) noexcept {
    if (n_corners_ == kMostCorners) {
        return false;
    }
    n_border_ = 0;
    for (int i = n_faces_; i-- > 0;) {
        const Face& face = faces_[static_cast<std::size_t>(i)];
        if (face.normal.dot(corner) > face.offset_m + least_m_) {
            remove_face(i);
        }
    }
    if (n_border_ == 0 || n_faces_ + n_border_ > kMostFaces) {
        return false;
    }
    const auto added = static_cast<std::uint8_t>(n_corners_);
    corners_[static_cast<std::size_t>(n_corners_++)] = corner;
    for (int i = 0; i < n_border_; ++i) {
        const Edge& edge = border_[static_cast<std::size_t>(i)];
        add_face(edge.from, edge.to, added);
    }
    return true;
}

}  // namespace fulcrum
