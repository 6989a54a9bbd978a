#include "haptics/collision/surface_samples.h"

#include "haptics/geometry/mesh_edges.h"
#include "haptics/math/length.h"
#include "haptics/voxel/pointshell.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace fulcrum {
namespace {

// The cosine of 20 degrees.
constexpr double kSharpCosine = 0.93969262;
// A corner without sharp edges: of 12 degrees, from which all edges fall by 3.
constexpr double kTipCosine = 0.97814760;
constexpr double kTipFall = 0.052;
constexpr std::size_t kGroupSize = 16;

std::size_t place_of(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

Vector3 find_area_normal(const TriangleMesh& mesh, std::int32_t triangle) {
    const TriangleCorners& at = mesh.triangles()[place_of(triangle)];
    const auto& vertices = mesh.vertices_B();
    const Vector3& a = vertices[place_of(at[0])];
    return 0.5 * (vertices[place_of(at[1])] - a).cross(vertices[place_of(at[2])] - a);
}

double find_area_m2(const TriangleMesh& mesh) {
    double area_m2 = 0.0;
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
        area_m2 += compute_length(find_area_normal(mesh, static_cast<std::int32_t>(t)));
    }
    return area_m2;
}

/// Sharp, and no groove: the other triangle bends away behind the first.
bool is_sharp(const TriangleMesh& mesh, std::span<const MeshEdge> sides) {
    if (sides.size() != 2) {
        return true;
    }
    const Vector3 normal = compute_direction(find_area_normal(mesh, sides[0].triangle));
    const Vector3 other = compute_direction(find_area_normal(mesh, sides[1].triangle));
    if (normal.dot(other) > kSharpCosine) {
        return false;
    }
    const Vector3& on = mesh.vertices_B()[place_of(sides[0].low)];
    for (const std::int32_t corner : mesh.triangles()[place_of(sides[1].triangle)]) {
        if (corner != sides[0].low && corner != sides[0].high) {
            return normal.dot(mesh.vertices_B()[place_of(corner)] - on) < 0.0;
        }
    }
    return false;
}

/// Of normals: their middle, and the cosine from it to the farthest.
struct NormalCone {
    Vector3 middle{Vector3::Zero()};
    double cosine = 1.0;

    void add(const Vector3& normal) noexcept { middle += normal; }
    void finish() noexcept {
        middle = middle.squaredNorm() > 0.0 ? compute_direction(middle) : Vector3(Vector3::Zero());
    }
    void widen(const Vector3& normal) noexcept { cosine = std::min(cosine, middle.dot(normal)); }
};

class SharpPlaces {
  public:
    SharpPlaces(const TriangleMesh& mesh, double spacing_m)
        : mesh_(mesh),
          spacing_m_(spacing_m),
          cones_(mesh.vertices_B().size()),
          is_corner_(mesh.vertices_B().size(), false) {}

    Expected<std::vector<SurfaceSample>> find() {
        const auto edges = collect_edges(mesh_.triangles(), mesh_.vertices_B().size());
        for_each_shared_edge(std::span<const MeshEdge>(edges),
                             [&](std::span<const MeshEdge> sides) {
                                 if (!is_full() && is_sharp(mesh_, sides)) {
                                     add_edge(sides);
                                 }
                             });
        add_corners();
        if (is_full()) {
            return fail("the mesh has more than " +
                            std::to_string(SurfaceSamples::kMostSharpPlaces) +
                            " corners and places along sharp edges",
                        {}, "give it fewer triangles, or smooth them");
        }
        return std::move(samples_);
    }

  private:
    [[nodiscard]] bool is_full() const {
        return samples_.size() > SurfaceSamples::kMostSharpPlaces;
    }
    void add_edge(std::span<const MeshEdge> sides) {
        NormalCone cone;
        for (const MeshEdge& side : sides) {
            cone.add(compute_direction(find_area_normal(mesh_, side.triangle)));
        }
        cone.finish();
        for (const MeshEdge& side : sides) {
            cone.widen(compute_direction(find_area_normal(mesh_, side.triangle)));
        }
        // A plate's rim is touched from behind as well.
        cone.cosine = sides.size() == 2 ? cone.cosine : -1.0;
        const Vector3& from = mesh_.vertices_B()[place_of(sides[0].low)];
        const Vector3 way = mesh_.vertices_B()[place_of(sides[0].high)] - from;
        const double length_m = compute_length(way);
        const int n =
            static_cast<int>(std::min(std::ceil(length_m / spacing_m_),
                                      static_cast<double>(SurfaceSamples::kMostSharpPlaces)));
        for (int i = 0; i < n; ++i) {
            samples_.push_back({.place_B = from + ((i + 0.5) / n) * way,
                                .along_B = way / length_m,
                                .reach_m = 0.5 * length_m / n,
                                .outwards_B = cone.middle,
                                .cone_cosine = cone.cosine,
                                .kind = SampleKind::edge});
        }
        for (const std::int32_t end : {sides[0].low, sides[0].high}) {
            is_corner_[place_of(end)] = true;
            cones_[place_of(end)].cosine = std::min(cones_[place_of(end)].cosine, cone.cosine);
        }
    }
    // All triangles round a corner open its cone. One at an open rim is open to all sides.
    void add_corners() {
        const auto for_each_corner = [&](const auto& visit) {
            for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
                const Vector3 normal =
                    compute_direction(find_area_normal(mesh_, static_cast<std::int32_t>(t)));
                for (const std::int32_t corner : mesh_.triangles()[t]) {
                    visit(cones_[place_of(corner)], normal);
                }
            }
        };
        for_each_corner([](NormalCone& cone, const Vector3& normal) { cone.add(normal); });
        for (NormalCone& cone : cones_) {
            cone.finish();
        }
        for_each_corner([](NormalCone& cone, const Vector3& normal) { cone.widen(normal); });
        find_tips();
        for (std::size_t i = 0; i < is_corner_.size(); ++i) {
            if (is_corner_[i]) {
                samples_.push_back({.place_B = mesh_.vertices_B()[i],
                                    .outwards_B = cones_[i].middle,
                                    .cone_cosine = cones_[i].cosine,
                                    .kind = SampleKind::corner});
            }
        }
    }
    // The tip of a cone has no sharp edge, and yet is a corner where all round it falls away.
    void find_tips() {
        std::vector<bool> is_tip(cones_.size(), true);
        for (const TriangleCorners& triangle : mesh_.triangles()) {
            for (const std::int32_t corner : triangle) {
                const Vector3& at = mesh_.vertices_B()[place_of(corner)];
                for (const std::int32_t other : triangle) {
                    const Vector3 way = mesh_.vertices_B()[place_of(other)] - at;
                    const bool falls =
                        cones_[place_of(corner)].middle.dot(way) <= -kTipFall * compute_length(way);
                    is_tip[place_of(corner)] =
                        is_tip[place_of(corner)] && (falls || other == corner);
                }
            }
        }
        for (std::size_t i = 0; i < is_tip.size(); ++i) {
            is_corner_[i] = is_corner_[i] || (is_tip[i] && cones_[i].cosine < kTipCosine);
        }
    }

    const TriangleMesh& mesh_;
    double spacing_m_;
    std::vector<NormalCone> cones_;
    std::vector<bool> is_corner_;
    std::vector<SurfaceSample> samples_;
};

}  // namespace

Expected<SurfaceSamples> SurfaceSamples::make(const TriangleMesh& mesh, int n_face_places) {
    if (n_face_places < kLeastFacePlaces || n_face_places > kMostFacePlaces) {
        return fail("places on a body's faces must number 16 to 100000, not " +
                        std::to_string(n_face_places),
                    {}, "512 do for most");
    }
    SurfaceSamples made;
    made.spacing_m_ = std::sqrt(find_area_m2(mesh) / n_face_places);
    auto sharp = SharpPlaces(mesh, made.spacing_m_).find();
    if (!sharp) {
        return tl::make_unexpected(sharp.error());
    }
    made.samples_ = std::move(*sharp);
    const auto faces = make_surface_pointshell(mesh, n_face_places);
    if (!faces) {
        return tl::make_unexpected(faces.error());
    }
    for (std::size_t i = 0; i < faces->size(); ++i) {
        made.samples_.push_back({.place_B = faces->position_T(i)});
    }
    made.put_in_order();
    return made;
}

// Each part is split at its middle across its longest side, until it is a group.
void SurfaceSamples::put_in_order() {
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, samples_.size()}};
    while (!parts.empty()) {
        const auto [first, count] = parts.back();
        parts.pop_back();
        if (count <= kGroupSize) {
            add_group(first, count);
            continue;
        }
        Vector3 lower = samples_[first].place_B;
        Vector3 upper = lower;
        for (std::size_t i = first; i < first + count; ++i) {
            lower = lower.cwiseMin(samples_[i].place_B);
            upper = upper.cwiseMax(samples_[i].place_B);
        }
        int axis = 0;
        (upper - lower).maxCoeff(&axis);
        const auto begin = samples_.begin() + static_cast<std::ptrdiff_t>(first);
        const std::size_t half = count / 2;
        std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half),
                         begin + static_cast<std::ptrdiff_t>(count),
                         [axis](const SurfaceSample& a, const SurfaceSample& b) {
                             return a.place_B[axis] < b.place_B[axis];
                         });
        parts.emplace_back(first + half, count - half);
        parts.emplace_back(first, half);
    }
}

void SurfaceSamples::add_group(std::size_t first, std::size_t count) {
    Group group{.first = static_cast<std::uint32_t>(first),
                .count = static_cast<std::uint32_t>(count)};
    for (std::size_t i = first; i < first + count; ++i) {
        group.centre_B += samples_[i].place_B / static_cast<double>(count);
    }
    for (std::size_t i = first; i < first + count; ++i) {
        group.radius_m =
            std::max(group.radius_m, compute_length(Vector3(samples_[i].place_B - group.centre_B)));
    }
    groups_.push_back(group);
}

}  // namespace fulcrum
