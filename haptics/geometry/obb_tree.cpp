#include "haptics/geometry/obb_tree.h"

#include "haptics/math/dense.h"

#include <algorithm>
#include <utility>

namespace fulcrum {

namespace {

// A box keeps at least this part of its triangles on either side of a split; else they are halved by number.
constexpr std::size_t kLeastPart = 8;

constexpr double kRoundings = 16.0 * std::numeric_limits<double>::epsilon();

float round_up(double size_m) {
    return std::nextafter(static_cast<float>(size_m), std::numeric_limits<float>::infinity());
}

// Surface and its first and second moments.
struct Moments {
    double area = 0.0;
    Vector3 first{Vector3::Zero()};
    Matrix3 second{Matrix3::Zero()};

    void add(const std::array<Vector3, 3>& corners, const Vector3& origin) {
        const Vector3 a = corners[0] - origin;
        const Vector3 b = corners[1] - origin;
        const Vector3 c = corners[2] - origin;
        const double here = 0.5 * (b - a).cross(c - a).norm();
        const Vector3 sum = a + b + c;  // three times the centre
        area += here;
        first += here / 3.0 * sum;
        second +=
            here / 12.0 *
            (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
    // Axes one a row; those of space where the surface says nothing.
    [[nodiscard]] Matrix3 find_axes() const {
        if (!(area > 0.0)) {
            return Matrix3::Identity();
        }
        const Vector3 mean = first / area;
        const Matrix3 covariance = second / area - mean * mean.transpose();
        if (!covariance.allFinite()) {
            return Matrix3::Identity();
        }
        return compute_symmetric_axes(covariance).axes.transpose();
    }
};

}  // namespace

std::array<Vector3, 3> ObbForest::corners_of(std::int32_t triangle) const {
    const TriangleCorners& t = corners_[static_cast<std::size_t>(triangle)];
    return {vertices_[static_cast<std::size_t>(t[0])], vertices_[static_cast<std::size_t>(t[1])],
            vertices_[static_cast<std::size_t>(t[2])]};
}

// Half the sizes that a box of this centre and these axes needs. It reads them as they are kept, in single precision: inlined
// after their rounding, g++ 12 at -O3 takes the numbers from before it, and then the box is too small.
[[gnu::noinline]] Vector3 ObbForest::measure(const OrientedBox& box,
                                             std::span<const std::int32_t> triangles,
                                             Vector3& middle) const {
    Vector3 lower = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 upper = -lower;
    for (const std::int32_t triangle : triangles) {
        for (const Vector3& corner : corners_of(triangle)) {
            const Vector3 place = box.to_frame(corner);
            lower = lower.cwiseMin(place);
            upper = upper.cwiseMax(place);
        }
    }
    middle = 0.5 * (lower + upper);
    Vector3 half = lower.cwiseAbs().cwiseMax(upper.cwiseAbs());
    half += Vector3::Constant(kRoundings * half.sum());  // a flat box is as thick as rounding
    return half;
}

OrientedBox ObbForest::fit(std::span<const std::int32_t> triangles) const {
    const Vector3 origin = corners_of(triangles.front())[0];
    Moments moments;
    for (const std::int32_t triangle : triangles) {
        moments.add(corners_of(triangle), origin);
    }
    const Matrix3 axes = moments.find_axes();
    OrientedBox box;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Index>(i);
        box.centre[i] = static_cast<float>(origin[row]);
        for (std::size_t k = 0; k < 3; ++k) {
            box.axes[i][k] = static_cast<float>(axes(row, static_cast<Index>(k)));
        }
    }
    // About any centre first, to find a better one; the sizes are those about the centre as it is kept.
    Vector3 middle;
    (void)measure(box, triangles, middle);
    const Vector3 moved = axes.transpose() * middle;
    for (std::size_t i = 0; i < 3; ++i) {
        box.centre[i] += static_cast<float>(moved[static_cast<Index>(i)]);
    }
    const Vector3 half = measure(box, triangles, middle);
    box.half_size = {round_up(half.x()), round_up(half.y()), round_up(half.z())};
    return box;
}

// Puts the triangles of the first child first; returns how many they are.
std::size_t ObbForest::split(const OrientedBox& box, std::span<std::int32_t> triangles) const {
    const auto longest = static_cast<std::size_t>(
        std::max_element(box.half_size.begin(), box.half_size.end()) - box.half_size.begin());
    const Vector3 axis = box.axis(longest);
    const auto place = [&](std::int32_t triangle) {
        const auto [a, b, c] = corners_of(triangle);
        return axis.dot(a) + axis.dot(b) + axis.dot(c);
    };
    double mean = 0.0;
    for (const std::int32_t triangle : triangles) {
        mean += place(triangle) / static_cast<double>(triangles.size());
    }
    const auto middle = std::partition(triangles.begin(), triangles.end(),
                                       [&](std::int32_t one) { return place(one) < mean; });
    const auto n_first = static_cast<std::size_t>(middle - triangles.begin());
    const std::size_t least = std::max<std::size_t>(1, triangles.size() / kLeastPart);
    if (n_first >= least && n_first + least <= triangles.size()) {
        return n_first;
    }
    const std::size_t n_half = triangles.size() / 2;
    std::nth_element(
        triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(n_half), triangles.end(),
        [&](std::int32_t one, std::int32_t other) { return place(one) < place(other); });
    return n_half;
}

std::int32_t ObbForest::add(std::span<const std::int32_t> triangles) {
    struct Part {
        std::int32_t node;
        std::size_t first;
        std::size_t count;
    };
    const auto root = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    std::vector<Part> waiting{{root, triangles_.size(), triangles.size()}};
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    while (!waiting.empty()) {
        const Part part = waiting.back();
        waiting.pop_back();
        const std::span<std::int32_t> own(triangles_.data() + part.first, part.count);
        Node node{.box = fit(own)};
        if (part.count <= triangles_a_leaf_) {
            node.first = static_cast<std::int32_t>(part.first);
            node.n_triangles = static_cast<std::int32_t>(part.count);
        } else {
            const std::size_t n_first = split(node.box, own);
            node.first = static_cast<std::int32_t>(nodes_.size());
            nodes_.resize(nodes_.size() + 2);
            waiting.push_back({node.first + 1, part.first + n_first, part.count - n_first});
            waiting.push_back({node.first, part.first, n_first});
        }
        nodes_[static_cast<std::size_t>(part.node)] = node;
    }
    return root;
}

void ObbForest::shrink() {
    nodes_.shrink_to_fit();
    triangles_.shrink_to_fit();
}

std::size_t ObbForest::memory_bytes() const noexcept {
    return nodes_.capacity() * sizeof(Node) + triangles_.capacity() * sizeof(std::int32_t);
}

}  // namespace fulcrum
