// On which side of a surface the corners of a brick lie, from their distances to it and as few winding numbers as that takes.
//
// Two neighbouring corners whose distances add up to more than the voxel between them have no surface between them: two open balls
// without any of it cover the way. So corners fall into connected parts, and a part lies on one side. Where the mesh is closed,
// one winding number (winding_number.h) tells which. Near open edges w also changes away from the surface; with e the lengths of open
// edges and D their distance,
//   |grad w| <= sum of e / (4 pi D^2)        (the law of Biot and Savart for the border)
// and a part takes one side only if w cannot reach 1/2 on the way through it; else each of its corners is asked.
//
// Thread: build at load; asked from any thread. Cost: 1 to 3 us a part of a brick, some three a brick; near holes, a corner.
#pragma once

#include "haptics/base/parallel_for.h"
#include "haptics/voxel/distance_band.h"
#include "haptics/voxel/voxel_frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

class BrickSides {
  public:
    /// Refers to `clusters`, of the same mesh. `voxel_m` is that of the field.
    BrickSides(const TriangleMesh& mesh, const TriangleClusters& clusters, double voxel_m);

    /// Gives the distances (voxels, 0 or more) of the brick with its least corner at `corner_B` the sign of their side, inside
    /// below 0. Distances may stop at a bound of at least 1.
    /// Where `watch` says so it ends with some corners wrong.
    void put_signs(const Vector3& corner_B, BrickDistances& distances,
                   WorkWatch* watch = nullptr) const noexcept;

    /// How many terms of winding numbers that takes at most, with as many at each place as at `middle_B`, for a brick near which so
    /// many triangles lie: each may part it once more.
    [[nodiscard]] double count_terms(const Vector3& middle_B,
                                     std::size_t n_triangles) const noexcept;

    /// Edges that do not meet another of the opposite direction, each as often as that; none where the mesh is closed.
    [[nodiscard]] std::size_t n_open_edges() const noexcept { return open_edges_.size(); }

  private:
    struct OpenEdge {
        Vector3 from_B, to_B;
    };
    // Parts of a brick while they are found.
    struct Search {
        std::array<std::int16_t, kBrickCorners> queue;
        std::array<std::int16_t, kBrickCorners>
            steps;  // from the first of a part; below 0: not yet seen
    };

    [[nodiscard]] double bound_slope(const Vector3& corner_B) const noexcept;
    // Collects the part that `first` is in; how many corners it has.
    static std::size_t collect_part(std::size_t first, const BrickDistances& distances,
                                    Search& search) noexcept;
    // False where it is to end.
    bool put_sign(std::span<const std::int16_t> part, std::int16_t n_steps, double slope,
                  const Vector3& corner_B, BrickDistances& distances,
                  WorkWatch* watch) const noexcept;

    const TriangleClusters& clusters_;
    double voxel_m_;
    std::vector<OpenEdge> open_edges_;
};

}  // namespace fulcrum
