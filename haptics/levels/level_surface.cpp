#include "haptics/levels/level_surface.h"

#include "haptics/geometry/mesh_edges.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

namespace {

bool has_corner(const TriangleCorners& triangle, std::int32_t corner) noexcept {
    return triangle[0] == corner || triangle[1] == corner || triangle[2] == corner;
}

}  // namespace

LevelSurface::LevelSurface(const TriangleMesh& mesh, const ConvexPieces& pieces)
    : places_(mesh.vertices_B()),
      triangles_(mesh.triangles()),
      is_there_(triangles_.size(), true),
      is_fixed_(places_.size(), false),
      at_corner_(places_.size()),
      first_piece_(pieces.piece_of),
      became_(static_cast<std::size_t>(pieces.n_pieces)),
      triangles_of_(became_.size()),
      box_of_(became_.size()),
      seen_(places_.size(), 0),
      n_pieces_(pieces.n_pieces) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        for (const std::int32_t corner : triangles_[i]) {
            at_corner_[static_cast<std::size_t>(corner)].push_back(static_cast<std::int32_t>(i));
        }
        triangles_of_[static_cast<std::size_t>(first_piece_[i])].push_back(
            static_cast<std::int32_t>(i));
    }
    for (std::int32_t piece = 0; piece < n_pieces_; ++piece) {
        became_[static_cast<std::size_t>(piece)] = piece;
        pieces_.push_back(piece);
        measure_box(piece);
    }
    fix_corners(mesh);
}

void LevelSurface::fix_corners(const TriangleMesh& mesh) {
    const auto edges = collect_edges(mesh.triangles(), mesh.vertices_B().size());
    for_each_shared_edge(edges, [&](std::span<const MeshEdge> shared) {
        if (shared.size() != 2 || shared[0].upwards == shared[1].upwards) {
            is_fixed_[static_cast<std::size_t>(shared[0].low)] = true;
            is_fixed_[static_cast<std::size_t>(shared[0].high)] = true;
        }
    });
}

PieceTriangle LevelSurface::places(std::int32_t triangle) const noexcept {
    const TriangleCorners& at = corners(triangle);
    return {place(at[0]), place(at[1]), place(at[2])};
}

std::int32_t LevelSurface::find_piece(std::int32_t piece) noexcept {
    while (became_[static_cast<std::size_t>(piece)] != piece) {
        std::int32_t& next = became_[static_cast<std::size_t>(piece)];
        next = became_[static_cast<std::size_t>(next)];
        piece = next;
    }
    return piece;
}

std::span<const std::int32_t> LevelSurface::triangles_of(std::int32_t piece) {
    auto& triangles = triangles_of_[static_cast<std::size_t>(piece)];
    std::erase_if(triangles, [this](std::int32_t triangle) {
        return !is_there_[static_cast<std::size_t>(triangle)];
    });
    return triangles;
}

void LevelSurface::drop_joined() {
    std::erase_if(pieces_, [this](std::int32_t piece) {
        return became_[static_cast<std::size_t>(piece)] != piece;
    });
}

std::vector<std::int32_t> LevelSurface::collect_pieces() {
    drop_joined();
    return pieces_;
}

void LevelSurface::find_ring(std::int32_t corner, std::vector<std::int32_t>& ring) const {
    ring.clear();
    for (const std::int32_t triangle : triangles_at(corner)) {
        for (const std::int32_t other : corners(triangle)) {
            if (other != corner && std::ranges::find(ring, other) == ring.end()) {
                ring.push_back(other);
            }
        }
    }
}

bool LevelSurface::may_end(std::int32_t kept, std::int32_t gone) const {
    if (is_fixed_[static_cast<std::size_t>(kept)] || is_fixed_[static_cast<std::size_t>(gone)]) {
        return false;
    }
    std::vector<std::int32_t> across;
    for (const std::int32_t triangle : triangles_at(gone)) {
        if (has_corner(corners(triangle), kept)) {
            for (const std::int32_t corner : corners(triangle)) {
                if (corner != kept && corner != gone) {
                    across.push_back(corner);
                }
            }
        }
    }
    if (across.size() != 2 || across[0] == across[1]) {
        return false;
    }
    std::vector<std::int32_t> of_kept;
    std::vector<std::int32_t> of_gone;
    find_ring(kept, of_kept);
    find_ring(gone, of_gone);
    const auto n_common = std::ranges::count_if(of_gone, [&](std::int32_t corner) {
        return std::ranges::find(of_kept, corner) != of_kept.end();
    });
    // Three triangles round a corner are the least that make a surface.
    return n_common == 2 && triangles_at(across[0]).size() > 3 &&
           triangles_at(across[1]).size() > 3;
}

void LevelSurface::drop_triangle(std::int32_t triangle) {
    is_there_[static_cast<std::size_t>(triangle)] = false;
    for (const std::int32_t corner : corners(triangle)) {
        std::erase(at_corner_[static_cast<std::size_t>(corner)], triangle);
    }
}

void LevelSurface::end_edge(std::int32_t kept, std::int32_t gone, const Vector3& place) {
    const std::vector<std::int32_t> moved(triangles_at(gone).begin(), triangles_at(gone).end());
    std::vector<std::int32_t> dropped;
    for (const std::int32_t triangle : moved) {
        if (has_corner(corners(triangle), kept)) {
            dropped.push_back(triangle);
        }
    }
    for (const std::int32_t triangle : dropped) {
        drop_triangle(triangle);
    }
    for (const std::int32_t triangle : at_corner_[static_cast<std::size_t>(gone)]) {
        std::ranges::replace(triangles_[static_cast<std::size_t>(triangle)], gone, kept);
        at_corner_[static_cast<std::size_t>(kept)].push_back(triangle);
    }
    at_corner_[static_cast<std::size_t>(gone)].clear();
    places_[static_cast<std::size_t>(kept)] = place;
    for (const std::int32_t triangle : dropped) {
        const std::int32_t piece = piece_of(triangle);
        if (triangles_of(piece).empty()) {
            join_pieces(piece_of(triangles_at(kept).front()), piece);
        }
    }
    for (const std::int32_t triangle : triangles_at(kept)) {
        measure_box(piece_of(triangle));
    }
}

void LevelSurface::join_pieces(std::int32_t kept, std::int32_t gone) {
    if (kept == gone) {
        return;
    }
    auto& to = triangles_of_[static_cast<std::size_t>(kept)];
    auto& from = triangles_of_[static_cast<std::size_t>(gone)];
    to.insert(to.end(), from.begin(), from.end());
    from = {};
    became_[static_cast<std::size_t>(gone)] = kept;
    --n_pieces_;
    measure_box(kept);
}

void LevelSurface::measure_box(std::int32_t piece) {
    Box box{Vector3::Constant(std::numeric_limits<double>::infinity()),
            Vector3::Constant(-std::numeric_limits<double>::infinity())};
    for (const std::int32_t triangle : triangles_of(piece)) {
        for (const Vector3& corner : places(triangle)) {
            box.lower = box.lower.cwiseMin(corner);
            box.upper = box.upper.cwiseMax(corner);
        }
    }
    box_of_[static_cast<std::size_t>(piece)] = box;
}

Expected<TriangleMesh> LevelSurface::to_mesh() const {
    std::vector<TriangleCorners> left;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        if (is_there_[i]) {
            left.push_back(triangles_[i]);
        }
    }
    return TriangleMesh::build(places_, std::move(left),
                               {.weld_relative = 0.0, .crack_relative = 0.0});
}

void LevelSurface::describe(std::int32_t piece, PieceShape& shape) {
    shape.clear();
    ++stamp_;
    for (const std::int32_t triangle : triangles_of(piece)) {
        shape.add_triangle(places(triangle));
        for (const std::int32_t corner : corners(triangle)) {
            if (seen_[static_cast<std::size_t>(corner)] != stamp_) {
                seen_[static_cast<std::size_t>(corner)] = stamp_;
                shape.corners.push_back(place(corner));
            }
        }
    }
}

bool LevelSurface::is_entered(const PieceShape& shape, std::int32_t one, std::int32_t other,
                              double slack_m) {
    const InnerHull inner(shape, slack_m);
    const Box box{inner.lower(), inner.upper()};
    if (pieces_.size() > 2 * static_cast<std::size_t>(n_pieces_)) {
        drop_joined();
    }
    for (const std::int32_t piece : pieces_) {
        if (became_[static_cast<std::size_t>(piece)] != piece || piece == one || piece == other ||
            !box_of_[static_cast<std::size_t>(piece)].overlaps(box)) {
            continue;
        }
        for (const std::int32_t triangle : triangles_of(piece)) {
            if (inner.is_entered_by(places(triangle))) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace fulcrum
