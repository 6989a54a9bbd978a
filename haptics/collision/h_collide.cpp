#include "haptics/collision/h_collide.h"

#include "haptics/base/range.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum {

namespace {

// Long triangles lie in many cells. More entries than this for each triangle, and the cells are made larger.
constexpr double kMostEntries = 12.0;
constexpr double kFewEntries = 4096.0;  // as many are never too many
// No cell is smaller than this part of the mesh's diagonal, nor larger than all of it.
constexpr double kSmallestCell = 1.0e-5;

double find_area_m2(const CollisionMesh& mesh) {
    double area_m2 = 0.0;
    for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
        area_m2 += 0.5 * prepare_triangle(mesh, i).doubled_area.norm();
    }
    return area_m2;
}

double choose_cell_m(const CollisionMesh& mesh, const HCollideSettings& settings) {
    const Box& box = mesh.tree().root_box();
    const double diagonal_m = (box.upper - box.lower).norm();
    const double cell_m =
        std::sqrt(find_area_m2(mesh) * settings.triangles_a_cell / mesh.n_triangles());
    return std::clamp(cell_m, kSmallestCell * diagonal_m, diagonal_m);
}

}  // namespace

Expected<void> validate(const HCollideSettings& settings) {
    const Range ranges[] = {
        {"triangles a cell", settings.triangles_a_cell, 1.0, 1.0e6},
        {"triangles a leaf", static_cast<double>(settings.triangles_a_leaf), 1.0, 1000.0},
    };
    return check_ranges("H-COLLIDE's", ranges);
}

Expected<std::shared_ptr<const HCollide>> HCollide::create(
    std::shared_ptr<const CollisionMesh> mesh, const HCollideSettings& settings) {
    if (!mesh) {
        return fail("there is no mesh to find segments on", {}, "give one");
    }
    return validate(settings).map(
        [&] { return std::shared_ptr<const HCollide>(new HCollide(std::move(mesh), settings)); });
}

HCollide::HCollide(std::shared_ptr<const CollisionMesh> mesh, const HCollideSettings& settings)
    : mesh_(std::move(mesh)),
      forest_(mesh_->vertices_B(), mesh_->triangles(), settings.triangles_a_leaf) {
    std::vector<Entry> entries;
    double cell_m = choose_cell_m(*mesh_, settings);
    do {
        grid_ = HashGrid(mesh_->tree().root_box(), cell_m);
        cell_m = 2.0 * grid_.cell_m();
    } while (!list_entries(entries));
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::pair(a.key, a.triangle) < std::pair(b.key, b.triangle);
    });
    plant(entries);
}

// Every triangle in every cell that its box overlaps; false when they are too many.
bool HCollide::list_entries(std::vector<Entry>& entries) const {
    const auto most =
        static_cast<std::size_t>(std::max(kFewEntries, kMostEntries * mesh_->n_triangles()));
    entries.clear();
    for (std::int32_t i = 0; i < mesh_->n_triangles(); ++i) {
        const TriangleCorners& t = mesh_->corners(i);
        const Vector3& a = mesh_->vertex_B(t[0]);
        const Vector3& b = mesh_->vertex_B(t[1]);
        const Vector3& c = mesh_->vertex_B(t[2]);
        const Vector3 margin = Vector3::Constant(grid_.margin_m());
        const HashGrid::Cell first = grid_.find_cell(a.cwiseMin(b).cwiseMin(c) - margin);
        const HashGrid::Cell last = grid_.find_cell(a.cwiseMax(b).cwiseMax(c) + margin);
        double n_here = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            n_here *= last[axis] - first[axis] + 1;
        }
        if (static_cast<double>(entries.size()) + n_here > static_cast<double>(most)) {
            return false;
        }
        for (std::int32_t z = first[2]; z <= last[2]; ++z) {
            for (std::int32_t y = first[1]; y <= last[1]; ++y) {
                for (std::int32_t x = first[0]; x <= last[0]; ++x) {
                    entries.push_back({HashGrid::to_key({x, y, z}), i});
                }
            }
        }
    }
    return true;
}

// A tree in each cell that holds something; entries lie by cell.
void HCollide::plant(const std::vector<Entry>& entries) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
        n_cells_ += i == 0 || entries[i].key != entries[i - 1].key ? 1 : 0;
    }
    grid_.reserve(static_cast<std::size_t>(n_cells_));
    roots_.reserve(static_cast<std::size_t>(n_cells_));
    std::vector<std::int32_t> here;
    for (std::size_t first = 0; first < entries.size();) {
        here.clear();
        std::size_t end = first;
        for (; end < entries.size() && entries[end].key == entries[first].key; ++end) {
            here.push_back(entries[end].triangle);
        }
        roots_.push_back(forest_.add(here));
        grid_.insert(entries[first].key, roots_.back());
        first = end;
    }
    forest_.shrink();
}

std::int32_t HCollide::find_tree(std::uint64_t key, Memory& memory) const noexcept {
    if (!memory.has_cell || memory.key != key) {
        memory.key = key;
        memory.tree = grid_.find(key);
        memory.has_cell = true;
    }
    return memory.tree;
}

SegmentHit HCollide::find_nearest_hit(const Vector3& from_B, const Vector3& to_B,
                                      Memory& memory) const noexcept {
    SegmentHit nearest;
    const auto ask = [&](std::int32_t triangle) noexcept {
        const SegmentHit hit = meet(prepare_triangle(*mesh_, triangle), from_B, to_B);
        if (hit.is_before(nearest)) {
            nearest = hit;
        }
    };
    // What was met last is likely to be met again: all that lies behind it is spared.
    if (memory.triangle >= 0) {
        ask(memory.triangle);
    }
    const CentredSegment segment = to_centred(from_B, to_B);
    if (grid_.resolves(segment.largest_m)) {
        grid_.for_each_along(from_B, to_B, [&](std::uint64_t key, double t_leave) noexcept {
            const std::int32_t tree = find_tree(key, memory);
            if (tree != HashGrid::kNothing) {
                forest_.for_each_met(tree, segment, ask);
            }
            return nearest.t > t_leave;
        });
    } else {
        for (const std::int32_t root : roots_) {
            forest_.for_each_met(root, segment, ask);
        }
    }
    memory.triangle = nearest.found() ? nearest.triangle : memory.triangle;
    return nearest;
}

std::size_t HCollide::memory_bytes() const noexcept {
    return grid_.memory_bytes() + forest_.memory_bytes() + roots_.capacity() * sizeof(std::int32_t);
}

}  // namespace fulcrum
