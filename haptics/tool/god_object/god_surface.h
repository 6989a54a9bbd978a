// A mesh made ready for the god-object: to be swept, and to tell where it can be touched from which direction.
//
// Two bodies are nearest to each other only where both surfaces fall away from the line between their nearest points: at a corner v or an edge,
// p a place of it, n the unit direction to the other body,
//   n . (w - p) <= epsilon |w - p|      for all corners w of the triangles that meet there
// epsilon for rounding. By how much the surface rises more than that is told. Pairs of features of which one does are nearer elsewhere: they would push along directions that the surface does not have, as
// edges between the triangles of one plane would. Edges between triangles of one plane, and corners where all edges are such, touch nothing that
// other features do not: they are left out. Which side is the front is not asked, and corners at one place are one: so cracks, flipped and
// loose triangles only add features.
//
// Thread: build at load; questions from any thread. Cost: O(n log n); 41 bytes a triangle beside the swept mesh's.
// Source: the local minima of distance: D. Johnson, E. Cohen 2001, Spatialized normal cone hierarchies, ACM I3D, section 3.
#pragma once

#include "haptics/continuous/swept_mesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

class GodSurface {
  public:
    [[nodiscard]] static std::shared_ptr<const GodSurface> create(const TriangleMesh& mesh);

    [[nodiscard]] const SweptMesh& swept() const noexcept { return *swept_; }
    /// May the triangle's corner, or its edge from this corner to the next, touch what nothing else of the surface does?
    [[nodiscard]] bool carries_corner(std::int32_t triangle, std::size_t corner) const noexcept {
        return corner_carries_[place_of(triangle, corner)];
    }
    [[nodiscard]] bool carries_edge(std::int32_t triangle, std::size_t edge) const noexcept {
        return edge_carries_[edge_of(triangle, edge)];
    }
    /// Those of its corners and edges that carry and that no triangle before it has, a bit each: who asks all triangles that are near asks each
    /// feature once.
    [[nodiscard]] unsigned own_corners(std::int32_t triangle) const noexcept {
        return own_[static_cast<std::size_t>(triangle)] & kCorners;
    }
    [[nodiscard]] unsigned own_edges(std::int32_t triangle) const noexcept {
        return static_cast<unsigned>(own_[static_cast<std::size_t>(triangle)]) >> kEdgeBit;
    }
    /// How far the surface round a place of the triangle, on its border or inside it, rises along a direction, metres; 0: it falls away.
    [[nodiscard]] double find_rise_m(std::int32_t triangle, const Vector3& at_B,
                                     const Vector3& direction_B, double epsilon) const noexcept;
    /// Whether the place is inside what a closed mesh encloses, wherever its fronts face; of an open one never.
    [[nodiscard]] bool encloses(const Vector3& at_B) const noexcept;
    /// Corners, each place once.
    [[nodiscard]] std::size_t n_places() const noexcept { return places_B_.size(); }
    [[nodiscard]] const Vector3& place_B(std::size_t i) const noexcept { return places_B_[i]; }
    /// One corner of each part that hangs together.
    [[nodiscard]] std::span<const std::int32_t> parts() const noexcept { return parts_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    explicit GodSurface(const TriangleMesh& mesh);
    void number_places(const TriangleMesh& mesh);
    void list_edges();
    void list_parts();
    void share_out();
    [[nodiscard]] bool is_flat(std::int32_t low, std::int32_t high,
                               std::span<const std::int32_t> wings) const;
    [[nodiscard]] std::size_t place_of(std::int32_t triangle, std::size_t corner) const noexcept {
        return static_cast<std::size_t>(triangles_[static_cast<std::size_t>(triangle)][corner]);
    }
    [[nodiscard]] std::size_t edge_of(std::int32_t triangle, std::size_t edge) const noexcept {
        return static_cast<std::size_t>(edges_of_[static_cast<std::size_t>(triangle)][edge]);
    }
    [[nodiscard]] double find_rise_m(std::span<const std::int32_t> places, const Vector3& at_B,
                                     const Vector3& direction_B, double epsilon) const noexcept;

    // Lists of places, one after the other: those of `i` begin at first[i].
    struct Lists {
        std::vector<std::int32_t> first{0};
        std::vector<std::int32_t> places{};
        [[nodiscard]] std::span<const std::int32_t> of(std::size_t i) const noexcept {
            const auto begin = static_cast<std::size_t>(first[i]);
            return std::span(places).subspan(begin, static_cast<std::size_t>(first[i + 1]) - begin);
        }
    };

    std::shared_ptr<const SweptMesh> swept_;
    std::vector<Vector3> places_B_;           // corners at one place are one
    std::vector<TriangleCorners> triangles_;  // of places
    std::vector<TriangleCorners> edges_of_;   // of triangles, from each corner to the next
    Lists wings_;                             // of an edge: the third corners of its triangles
    Lists rings_;                             // of a place: the other ends of its edges
    std::vector<std::int32_t> parts_;         // a place of each
    std::vector<bool> corner_carries_;        // of a place
    std::vector<bool> edge_carries_;
    static constexpr unsigned kCorners = 7;
    static constexpr unsigned kEdgeBit = 3;
    std::vector<std::uint8_t>
        own_;                // of a triangle: its own corners, and from the fourth bit on edges
    bool is_closed_ = true;  // every edge has two triangles
};

}  // namespace fulcrum
