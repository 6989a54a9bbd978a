// A solid's surface as places where it may touch another: corners, places along its sharp edges, and places on its faces.
//
//   corner   a vertex of an edge that is sharp and looks outwards, or one from which all falls away with normals 12 degrees apart: a tip
//   edge     the middles of equal pieces of such an edge, none longer than the spacing
//   face     as many as asked for, evenly over the area (pointshell.h)
// An edge is sharp where its triangles' normals part by more than 20 degrees, or where it has one triangle alone. Those that look inwards
// touch nothing that has not touched their faces before. The spacing is the root of the area a place on a face has to itself.
// Places that follow each other lie near each other, and each group of them has a ball.
//
// Thread: load. Cost: some 0.1 us a triangle and 1 us a place.
// Source: features of a surface by kind, each sought along what it may slide on: M. Macklin, K. Erleben, M. Mueller, N. Chentanez,
// S. Jeschke, Z. Corse 2020, Local optimization for robust signed distance field collision, Proc. ACM CGIT 3(1).
#pragma once

#include "haptics/base/error.h"
#include "haptics/geometry/triangle_mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

enum class SampleKind : std::uint8_t { corner, edge, face };

/// Of the body's frame B.
struct SurfaceSample {
    Vector3 place_B{Vector3::Zero()};
    Vector3 along_B{Vector3::Zero()};  ///< unit; of an edge alone
    double reach_m = 0.0;              ///< of an edge: its piece of it goes so far either way
    /// Unit, the middle of the normals that meet at a corner or an edge, and the cosine to the farthest of them: something else touches here
    /// from within this cone. Of a face zero.
    Vector3 outwards_B{Vector3::Zero()};
    double cone_cosine = -1.0;
    SampleKind kind = SampleKind::face;
};

class SurfaceSamples {
  public:
    struct Group {
        Vector3 centre_B{Vector3::Zero()};
        double radius_m = 0.0;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    static constexpr int kLeastFacePlaces = 16;
    static constexpr int kMostFacePlaces = 100'000;
    /// Corners and places along edges together; a mesh that has more is to be made coarser.
    static constexpr std::size_t kMostSharpPlaces = 100'000;

    /// `n_face_places` from 16 to 100 000. Refuses a mesh with more than 100 000 corners and places along edges.
    [[nodiscard]] static Expected<SurfaceSamples> make(const TriangleMesh& mesh, int n_face_places);

    [[nodiscard]] std::span<const SurfaceSample> all() const noexcept { return samples_; }
    [[nodiscard]] std::span<const Group> groups() const noexcept { return groups_; }
    [[nodiscard]] std::span<const SurfaceSample> of(const Group& group) const noexcept {
        return all().subspan(group.first, group.count);
    }
    [[nodiscard]] double spacing_m() const noexcept { return spacing_m_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return samples_.capacity() * sizeof(SurfaceSample) + groups_.capacity() * sizeof(Group);
    }

  private:
    void put_in_order();
    void add_group(std::size_t first, std::size_t count);

    std::vector<SurfaceSample> samples_;
    std::vector<Group> groups_;
    double spacing_m_ = 0.0;
};

}  // namespace fulcrum
