#include "haptics/voxel/pointshell.h"

#include "haptics/math/length.h"
#include "haptics/voxel/rasterise.h"
#include "haptics/voxel/voxelise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>

namespace fulcrum {
namespace {

// Every third bit.
std::uint64_t spread_bits(std::uint64_t v) {
    std::uint64_t spread = 0;
    for (int bit = 0; bit < 21; ++bit) {
        spread |= (v >> bit & 1U) << (3 * bit);
    }
    return spread;
}

// Morton's number of a place in the box, 2^16 steps an axis.
std::uint64_t compute_morton(const Vector3& p, const Vector3& lower, double longest_m) {
    constexpr double kSteps = 65535.0;
    const Vector3 g = ((p - lower) * (kSteps / longest_m)).cwiseMax(0.0).cwiseMin(kSteps);
    return spread_bits(static_cast<std::uint64_t>(g.x())) |
           spread_bits(static_cast<std::uint64_t>(g.y())) << 1 |
           spread_bits(static_cast<std::uint64_t>(g.z())) << 2;
}

TrianglePoints corners_of(const TriangleMesh& mesh, const TriangleCorners& triangle) {
    const std::vector<Vector3>& p = mesh.vertices_B();
    return {p[static_cast<std::size_t>(triangle[0])], p[static_cast<std::size_t>(triangle[1])],
            p[static_cast<std::size_t>(triangle[2])]};
}

// Twice the area long, out of the front.
Vector3 compute_doubled_area(const TrianglePoints& t) {
    return (t[1] - t[0]).cross(t[2] - t[0]);
}

// Points and what they are put in order by.
struct Candidate {
    std::uint64_t morton = 0;
    Vector3 position;
    Vector3 normal;  // inwards
};

Pointshell in_order(std::vector<Candidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.morton < b.morton; });
    Pointshell shell;
    for (const Candidate& one : candidates) {
        shell.add(one.position, one.normal);
    }
    return shell;
}

// A voxel's normals, weighted by area up to that of a voxel's face: a large triangle is not more there than a small one. Where
// they cancel, as on both sides of a thin plate, the first one counts.
struct NormalSum {
    Vector3 sum{Vector3::Zero()};
    Vector3 first{Vector3::Zero()};

    void add(const Vector3& doubled_area, double face_m2) {
        const Vector3 normal = compute_direction(doubled_area);
        const double area_m2 = 0.5 * compute_length(doubled_area);
        first = first.isZero() ? normal : first;
        sum += std::min(area_m2, face_m2) / face_m2 * normal;
    }
    [[nodiscard]] Vector3 inwards() const {
        constexpr double kCancelled = 1.0e-6;  // of a face
        const double length = compute_length(sum);
        return length > kCancelled ? Vector3(-sum / length) : Vector3(-first);
    }
};

// The R2 sequence, folded into a triangle: even at every length.
Vector3 compute_place(const TrianglePoints& t, std::int64_t k) {
    constexpr double kFirst = 0.7548776662466927;   // 1/g, g^3 = g + 1
    constexpr double kSecond = 0.5698402909980532;  // 1/g^2
    constexpr double kStart = 1.0 / 3.0;            // a triangle's only point lies in its middle
    double u = kStart + kFirst * static_cast<double>(k);
    double v = kStart + kSecond * static_cast<double>(k);
    u -= std::floor(u);
    v -= std::floor(v);
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
}

// Triangles along Morton's curve, neighbours mostly near each other.
std::vector<std::size_t> order_triangles(const TriangleMesh& mesh, double longest_m) {
    std::vector<std::uint64_t> morton;
    morton.reserve(mesh.triangles().size());
    for (const TriangleCorners& triangle : mesh.triangles()) {
        const TrianglePoints t = corners_of(mesh, triangle);
        morton.push_back(compute_morton((t[0] + t[1] + t[2]) / 3.0, mesh.lower_B(), longest_m));
    }
    std::vector<std::size_t> order(morton.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&morton](std::size_t a, std::size_t b) { return morton[a] < morton[b]; });
    return order;
}

// Point k stands for the area from k/n to (k + 1)/n; the triangle in which its middle lies has it. False where it was stopped.
template <class GoesOn>
bool place_points(const TriangleMesh& mesh, const std::vector<std::size_t>& order, int n_points,
                  const GoesOn& goes_on, std::vector<Candidate>& candidates) {
    constexpr std::size_t kBetween = 4096;  // triangles and points from one question to the next
    const double longest_m = (mesh.upper_B() - mesh.lower_B()).maxCoeff();
    double total = 0.0;
    for (const TriangleCorners& triangle : mesh.triangles()) {
        total += compute_length(compute_doubled_area(corners_of(mesh, triangle)));
    }
    candidates.reserve(static_cast<std::size_t>(n_points));
    double passed = 0.0;
    std::size_t asked_at = kBetween;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const TrianglePoints t = corners_of(mesh, mesh.triangles()[order[i]]);
        const Vector3 doubled_area = compute_doubled_area(t);
        passed += compute_length(doubled_area);
        const bool last = i + 1 == order.size();
        const double share = static_cast<double>(n_points) * passed / total - 0.5;
        const auto end = last ? n_points : std::min(n_points, static_cast<int>(std::ceil(share)));
        for (int k = 0; static_cast<int>(candidates.size()) < end; ++k) {
            const Vector3 place = compute_place(t, k);
            candidates.push_back({compute_morton(place, mesh.lower_B(), longest_m), place,
                                  -compute_direction(doubled_area)});
            if (i + candidates.size() >= asked_at) {
                asked_at = i + candidates.size() + kBetween;
                if (!goes_on(static_cast<double>(candidates.size()) / n_points)) {
                    return false;
                }
            }
        }
    }
    return true;
}

}  // namespace

void Pointshell::add(const Vector3& position_T, const Vector3& normal_T) {
    x_m.push_back(static_cast<float>(position_T.x()));
    y_m.push_back(static_cast<float>(position_T.y()));
    z_m.push_back(static_cast<float>(position_T.z()));
    nx.push_back(static_cast<float>(normal_T.x()));
    ny.push_back(static_cast<float>(normal_T.y()));
    nz.push_back(static_cast<float>(normal_T.z()));
}

Expected<Pointshell> make_voxel_pointshell(const TriangleMesh& mesh, double voxel_m) {
    VoxeliseSettings settings;
    settings.voxel_m = voxel_m;
    settings.proximity_layers = 0;
    const Expected<VoxelGrid> grid = voxelise(mesh, settings);
    if (!grid) {
        return tl::unexpected(grid.error());
    }
    // Surface voxels are numbered by place, their normals summed by number.
    const VoxelFrame& frame = grid->frame;
    std::vector<std::int32_t> number(grid->cells.size(), -1);
    std::vector<Candidate> candidates;
    std::vector<NormalSum> normals;
    const double longest_m = mesh.diagonal_m();
    for (const TriangleCorners& triangle : mesh.triangles()) {
        const TrianglePoints t = corners_of(mesh, triangle);
        const Vector3 doubled_area = compute_doubled_area(t);
        rasterise(frame, t, [&](const VoxelFrame::Cell& cell) {
            std::int32_t& here = number[grid->index_of(cell)];
            if (here < 0) {
                here = static_cast<std::int32_t>(candidates.size());
                const Vector3 centre = frame.centre_of(cell);
                candidates.push_back(
                    {compute_morton(centre, frame.lower_O, longest_m + 2.0 * voxel_m), centre,
                     Vector3::Zero()});
                normals.emplace_back();
            }
            normals[static_cast<std::size_t>(here)].add(doubled_area, voxel_m * voxel_m);
        });
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        candidates[i].normal = normals[i].inwards();
    }
    return in_order(candidates);
}

Expected<Pointshell> make_surface_pointshell(const TriangleMesh& mesh, int n_points,
                                             const LoadProgress& progress) {
    if (n_points < 1 || n_points > kMostShellPoints) {
        return fail("a pointshell of " + std::to_string(n_points) +
                        " points is outside the range 1 to 16 million",
                    {}, "set it within that range");
    }
    // About as much of the time as each step takes.
    constexpr double kOrdered = 0.2;
    constexpr double kPlaced = 0.6;
    const auto goes_on = [&](double share) { return !progress || progress(share); };
    const double longest_m = (mesh.upper_B() - mesh.lower_B()).maxCoeff();
    const std::vector<std::size_t> order = order_triangles(mesh, longest_m);
    std::vector<Candidate> candidates;
    if (!goes_on(kOrdered) ||
        !place_points(
            mesh, order, n_points,
            [&](double share) { return goes_on(kOrdered + share * (kPlaced - kOrdered)); },
            candidates)) {
        return fail("the points were stopped before they were made", {}, "make them again");
    }
    Pointshell shell = in_order(candidates);
    if (!goes_on(1.0)) {
        return fail("the points were stopped before they were made", {}, "make them again");
    }
    return shell;
}

Pointshell make_moved(const Pointshell& shell, const Pose& X_NT) {
    Pointshell moved;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        moved.add(X_NT * shell.position_T(i), X_NT.orientation * shell.normal_T(i));
    }
    return moved;
}

}  // namespace fulcrum
