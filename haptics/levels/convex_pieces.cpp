#include "haptics/levels/convex_pieces.h"

#include "haptics/geometry/bounding_tree.h"
#include "haptics/geometry/mesh_edges.h"

#include <algorithm>
#include <array>

namespace fulcrum {

namespace {

constexpr std::int32_t kNone = -1;
constexpr double kSlack = 1.0e-7;       // of the diagonal
constexpr double kFewHoles = 0.01;      // of the edges
constexpr std::size_t kFirstLook = 32;  // triangles

class PieceFlood {
  public:
    explicit PieceFlood(const TriangleMesh& mesh)
        : mesh_(mesh), tree_(mesh), neighbours_(mesh.triangles().size(), {kNone, kNone, kNone}) {
        const MeshReport report = compute_mesh_report(mesh);
        const double few = kFewHoles * 1.5 * static_cast<double>(report.n_triangles);
        pieces_.has_inside = static_cast<double>(report.open_edges) <= few &&
                             report.non_manifold_edges == 0 && report.inconsistent_edges == 0 &&
                             !report.inside_out;
        pieces_.slack_m = kSlack * mesh.diagonal_m();
        pieces_.piece_of.assign(mesh.triangles().size(), kNone);
        rejected_by_.assign(mesh.triangles().size(), kNone);
        corner_seen_.assign(mesh.vertices_B().size(), kNone);
        find_neighbours();
    }

    bool run(LoadPulse& pulse) {
        const auto n = static_cast<std::int32_t>(mesh_.triangles().size());
        for (std::int32_t seed = 0; seed < n; ++seed) {
            if (!pulse.goes_on(static_cast<double>(seed) / n)) {
                return false;
            }
            if (piece_at(seed) == kNone) {
                grow(seed);
                ++pieces_.n_pieces;
            }
        }
        return true;
    }
    [[nodiscard]] ConvexPieces take() { return std::move(pieces_); }

  private:
    [[nodiscard]] std::int32_t& piece_at(std::int32_t triangle) {
        return pieces_.piece_of[static_cast<std::size_t>(triangle)];
    }
    [[nodiscard]] const TriangleCorners& corners_at(std::int32_t triangle) const {
        return mesh_.triangles()[static_cast<std::size_t>(triangle)];
    }
    [[nodiscard]] PieceTriangle places_at(std::int32_t triangle) const {
        PieceTriangle places;
        for (std::size_t i = 0; i < 3; ++i) {
            places[i] = mesh_.vertices_B()[static_cast<std::size_t>(corners_at(triangle)[i])];
        }
        return places;
    }

    // Across edges that two triangles share in opposite directions.
    void find_neighbours() {
        std::vector<int> n_known(mesh_.triangles().size(), 0);
        const auto add = [&](std::int32_t triangle, std::int32_t other) {
            const auto at = static_cast<std::size_t>(triangle);
            if (n_known[at] < 3) {
                neighbours_[at][static_cast<std::size_t>(n_known[at]++)] = other;
            }
        };
        const auto edges = collect_edges(mesh_.triangles(), mesh_.vertices_B().size());
        for_each_shared_edge(edges, [&](std::span<const MeshEdge> shared) {
            if (shared.size() == 2 && shared[0].upwards != shared[1].upwards) {
                add(shared[0].triangle, shared[1].triangle);
                add(shared[1].triangle, shared[0].triangle);
            }
        });
    }

    void grow(std::int32_t seed) {
        taken_.clear();
        shape_.clear();
        ++stamp_;
        take_in(seed);
        std::size_t right = 1;
        std::size_t look_at = kFirstLook;
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            // Looked at again and again as it grows: what is far too large takes long to look at.
            if (taken_.size() >= look_at && !shape_.is_flat(pieces_.slack_m)) {
                if (!is_right()) {
                    break;
                }
                right = taken_.size();
                look_at = 2 * right;
            }
            for (const std::int32_t next : neighbours_[static_cast<std::size_t>(taken_[i])]) {
                if (next != kNone && piece_at(next) == kNone &&
                    rejected_by_[static_cast<std::size_t>(next)] != stamp_) {
                    if (may_take(next)) {
                        take_in(next);
                    } else {
                        rejected_by_[static_cast<std::size_t>(next)] = stamp_;
                    }
                }
            }
        }
        keep_what_is_right(right);
    }

    void add_to_shape(std::int32_t triangle) {
        shape_.add_triangle(places_at(triangle));
        for (const std::int32_t corner : corners_at(triangle)) {
            if (corner_seen_[static_cast<std::size_t>(corner)] != stamp_) {
                corner_seen_[static_cast<std::size_t>(corner)] = stamp_;
                shape_.corners.push_back(mesh_.vertices_B()[static_cast<std::size_t>(corner)]);
            }
        }
    }
    void take_in(std::int32_t triangle) {
        piece_at(triangle) = pieces_.n_pieces;
        taken_.push_back(triangle);
        add_to_shape(triangle);
    }

    [[nodiscard]] bool may_take(std::int32_t triangle) const {
        const PieceTriangle places = places_at(triangle);
        const PiecePlane plane = PiecePlane::of(places);
        if (!pieces_.has_inside && plane.normal.dot(shape_.planes.front().normal) <= 0.0) {
            return false;
        }
        if (!shape_.is_before(plane, pieces_.slack_m)) {
            return false;
        }
        for (const Vector3& place : places) {
            if (!shape_.is_behind(place, pieces_.slack_m)) {
                return false;
            }
            if (!pieces_.has_inside && shape_.planes.front().height_m(place) < -pieces_.slack_m) {
                return false;
            }
        }
        return true;
    }

    // Half after half, from all to what was right before.
    void keep_what_is_right(std::size_t right) {
        if (is_right()) {
            return;
        }
        const std::vector<std::int32_t> all = taken_;
        std::size_t wrong = all.size();
        while (wrong - right > 1) {
            const std::size_t half = (right + wrong) / 2;
            set_to(all, half);
            (is_right() ? right : wrong) = half;
        }
        set_to(all, right);
    }
    void set_to(const std::vector<std::int32_t>& all, std::size_t count) {
        for (const std::int32_t triangle : all) {
            piece_at(triangle) = kNone;
        }
        taken_.clear();
        shape_.clear();
        ++stamp_;
        for (std::size_t i = 0; i < count; ++i) {
            take_in(all[i]);
        }
    }

    bool is_right() {
        if (taken_.size() == 1) {
            return true;
        }
        if (shape_.is_flat(pieces_.slack_m)) {
            return shape_.fills_its_polygon();
        }
        const InnerHull inner(shape_);
        bool is_entered = false;
        tree_.for_each_in_box({inner.lower(), inner.upper()}, [&](std::int32_t slot) {
            const std::int32_t triangle = tree_.order()[static_cast<std::size_t>(slot)];
            is_entered = is_entered || (piece_at(triangle) != pieces_.n_pieces &&
                                        inner.is_entered_by(places_at(triangle)));
        });
        return !is_entered;
    }

    const TriangleMesh& mesh_;
    BoundingTree tree_;
    std::vector<std::array<std::int32_t, 3>> neighbours_;
    ConvexPieces pieces_;
    std::int32_t stamp_ = 0;
    std::vector<std::int32_t> rejected_by_;  // the stamp of the flood that did
    std::vector<std::int32_t> corner_seen_;
    std::vector<std::int32_t> taken_;  // of the piece that grows, as they came
    PieceShape shape_;
};

}  // namespace

Expected<ConvexPieces> make_convex_pieces(const TriangleMesh& mesh, const LoadProgress& progress) {
    LoadPulse pulse(progress);
    PieceFlood flood(mesh);
    if (!flood.run(pulse)) {
        return fail("the cutting into convex pieces was stopped", {}, "make them again");
    }
    return flood.take();
}

}  // namespace fulcrum
