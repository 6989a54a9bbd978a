#include "haptics/levels/level_bytes.h"

#include "haptics/voxel/shape_seal.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

using namespace shape_seal;

namespace {

constexpr double kLevelRounding = 1.0e-7;  // of the size
constexpr std::int32_t kMostLevels = 64;   // each has half of the pieces
constexpr std::size_t kNodeBytes = 3 * sizeof(std::int32_t) + 13 * sizeof(double) + 1;

bool is_amount(double value) noexcept {
    return value >= 0.0 && value <= kLargest_m;
}

// Which may be infinite.
bool is_amount_or_endless(double value) noexcept {
    return value >= 0.0;
}

bool is_count(std::int64_t value) noexcept {
    return value >= 0;
}

template <class Walker, class Report>
void walk_report(Walker& walker, Report& report) {
    walker.field(report.n_triangles);
    walker.field(report.n_vertices);
    walker.field(report.open_edges);
    walker.field(report.non_manifold_edges);
    walker.field(report.inconsistent_edges);
    walker.field(report.degenerate_triangles);
    walker.field(report.closed_cracks);
    walker.field(report.self_intersections);
    walk_vector(walker, report.size_m);
    walker.field(report.volume_m3);
}

bool is_report(const MeshReport& report) noexcept {
    return is_count(report.n_triangles) && is_count(report.n_vertices) &&
           is_count(report.open_edges) && is_count(report.non_manifold_edges) &&
           is_count(report.inconsistent_edges) && is_count(report.degenerate_triangles) &&
           is_count(report.closed_cracks) && is_count(report.self_intersections) &&
           is_place(report.size_m) && is_amount_or_endless(report.volume_m3) &&
           std::isfinite(report.volume_m3);
}

template <class Walker, class Node>
void walk_node(Walker& walker, Node& node) {
    walker.field(node.first_child);
    walker.field(node.n_children);
    walker.field(node.level);
    walk_vector(walker, node.centre_B);
    walker.field(node.radius_m);
    walker.field(node.outside_m);
    walker.field(node.deviation_m);
    walker.field(node.detail_m3);
    walker.field(node.support_m2);
    walker.field(node.resolution_per_m);
    walk_vector(walker, node.normal_B);
    walker.field(node.cone_cosine);
}

// Its own numbers; those of places in lists are judged where the lists are.
bool is_node(const LevelNode& node) noexcept {
    constexpr double kUnit = 1.0 + 1.0e-9;
    return node.level >= 0 && node.level <= 2 * kMostLevels && is_place(node.centre_B) &&
           is_amount(node.radius_m) && is_amount(node.outside_m) && is_amount(node.deviation_m) &&
           is_amount_or_endless(node.detail_m3) && is_amount_or_endless(node.support_m2) &&
           std::isfinite(node.support_m2) && is_amount_or_endless(node.resolution_per_m) &&
           node.normal_B.norm() <= kUnit && std::abs(node.cone_cosine) <= kUnit;
}

}  // namespace

// Reads and writes what only the levels' maker may set.
class ContactLevelsBytes {
  public:
    template <class Walker>
    static void walk(Walker& walker, const ContactLevels& levels);
    [[nodiscard]] static std::shared_ptr<const ContactLevels> read(ByteReader& reader);
    [[nodiscard]] static bool holds_triangles(const ContactLevels& levels,
                                              const TriangleMesh& mesh);
    [[nodiscard]] static bool hold_children(const ContactLevels& levels);

  private:
    struct Counts {
        std::uint64_t nodes = 0;
        std::uint64_t points = 0;
        std::uint64_t first_links = 0;
        std::uint64_t links = 0;
        std::uint64_t triangles = 0;
    };
    template <class Walker, class Levels>
    static void walk_head(Walker& walker, Levels& levels);
    template <class Walker, class C>
    static void walk_counts(Walker& walker, C& counts);
    [[nodiscard]] static bool is_head(const ContactLevels& levels) noexcept;
    [[nodiscard]] static bool is_tree(const ContactLevels& levels);
    [[nodiscard]] static bool are_hulls(const ContactLevels& levels) noexcept;
    [[nodiscard]] static bool is_linked(const ContactLevels& levels, std::size_t node) noexcept;
    [[nodiscard]] static bool are_triangles(const ContactLevels& levels);
    [[nodiscard]] static bool is_within(const ContactLevels::Span& span, std::size_t n) noexcept {
        return span.first >= 0 && span.count >= 0 &&
               static_cast<std::size_t>(span.first) + static_cast<std::size_t>(span.count) <= n;
    }
};

template <class Walker, class Levels>
void ContactLevelsBytes::walk_head(Walker& walker, Levels& levels) {
    walker.field(levels.settings_.within_m);
    walk_report(walker, levels.report_);
    walker.field(levels.size_m_);
    walker.field(levels.reach_m_);
    walker.field(levels.n_levels_);
    walker.field(levels.n_pieces_);
}

template <class Walker, class C>
void ContactLevelsBytes::walk_counts(Walker& walker, C& counts) {
    walker.field(counts.nodes);
    walker.field(counts.points);
    walker.field(counts.first_links);
    walker.field(counts.links);
    walker.field(counts.triangles);
}

template <class Walker>
void ContactLevelsBytes::walk(Walker& walker, const ContactLevels& levels) {
    using Span = ContactLevels::Span;
    walk_head(walker, levels);
    walker.field(static_cast<std::uint8_t>(levels.report_.more_self_intersections));
    walker.field(static_cast<std::uint8_t>(levels.report_.inside_out));
    const Counts counts{levels.nodes_.size(), levels.points_.size(), levels.first_links_.size(),
                        levels.links_.size(), levels.triangles_.size()};
    walk_counts(walker, counts);
    for (const LevelNode& node : levels.nodes_) {
        walk_node(walker, node);
        walker.field(static_cast<std::uint8_t>(node.is_bound_only));
    }
    walker.array(std::span<const Span>(levels.points_of_));
    walker.array(std::span<const Span>(levels.links_of_));
    walker.array(std::span<const Span>(levels.triangles_of_));
    for (const Vector3& point : levels.points_) {
        walk_vector(walker, point);
    }
    walker.array(std::span<const std::int32_t>(levels.first_links_));
    walker.array(std::span<const std::int32_t>(levels.links_));
    walker.array(std::span<const std::int32_t>(levels.triangles_));
}

bool ContactLevelsBytes::is_head(const ContactLevels& levels) noexcept {
    return validate(levels.settings_) && is_report(levels.report_) && is_length(levels.size_m_) &&
           is_length(levels.reach_m_) && levels.n_levels_ >= 1 && levels.n_levels_ <= kMostLevels &&
           levels.n_pieces_ >= 1;
}

// Children stand side by side behind their parent, and each node is the child of one.
bool ContactLevelsBytes::is_tree(const ContactLevels& levels) {
    const std::size_t n = levels.nodes_.size();
    std::vector<bool> has_parent(n, false);
    std::size_t n_children = 0;
    std::size_t n_leaves = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const LevelNode& node = levels.nodes_[i];
        if (!is_node(node) || !is_within({node.first_child, node.n_children}, n) ||
            (node.n_children > 0 && static_cast<std::size_t>(node.first_child) <= i)) {
            return false;
        }
        n_leaves += node.n_children == 0 ? 1 : 0;
        for (std::int32_t k = 0; k < node.n_children; ++k) {
            const auto child =
                static_cast<std::size_t>(node.first_child) + static_cast<std::size_t>(k);
            if (has_parent[child]) {
                return false;
            }
            has_parent[child] = true;
            ++n_children;
        }
    }
    return n_children == n - 1 && n_leaves == static_cast<std::size_t>(levels.n_pieces_);
}

// Its corners' neighbours are corners of its own.
bool ContactLevelsBytes::is_linked(const ContactLevels& levels, std::size_t node) noexcept {
    const ContactLevels::Span& points = levels.points_of_[node];
    const ContactLevels::Span& own = levels.links_of_[node];
    if (own.count == 0) {
        return is_within(own, levels.first_links_.size());
    }
    if (own.count != points.count + 1 || !is_within(own, levels.first_links_.size())) {
        return false;
    }
    const auto first =
        std::span<const std::int32_t>(levels.first_links_)
            .subspan(static_cast<std::size_t>(own.first), static_cast<std::size_t>(own.count));
    if (first.front() < 0 || !std::ranges::is_sorted(first) ||
        static_cast<std::size_t>(first.back()) > levels.links_.size()) {
        return false;
    }
    return std::all_of(levels.links_.begin() + first.front(), levels.links_.begin() + first.back(),
                       [&](std::int32_t link) { return link >= 0 && link < points.count; });
}

bool ContactLevelsBytes::are_hulls(const ContactLevels& levels) noexcept {
    if (!std::ranges::all_of(levels.points_, is_place)) {
        return false;
    }
    for (std::size_t i = 0; i < levels.nodes_.size(); ++i) {
        const ContactLevels::Span& points = levels.points_of_[i];
        if (points.count < 1 || !is_within(points, levels.points_.size()) ||
            !is_linked(levels, i)) {
            return false;
        }
    }
    return true;
}

// Each once.
bool ContactLevelsBytes::are_triangles(const ContactLevels& levels) {
    const std::size_t n = levels.triangles_.size();
    std::vector<bool> is_seen(n, false);
    for (const std::int32_t triangle : levels.triangles_) {
        if (triangle < 0 || static_cast<std::size_t>(triangle) >= n ||
            is_seen[static_cast<std::size_t>(triangle)]) {
            return false;
        }
        is_seen[static_cast<std::size_t>(triangle)] = true;
    }
    return std::ranges::all_of(levels.triangles_of_,
                               [n](const ContactLevels::Span& span) { return is_within(span, n); });
}

std::shared_ptr<const ContactLevels> ContactLevelsBytes::read(ByteReader& reader) {
    std::shared_ptr<ContactLevels> levels(new ContactLevels);
    walk_head(reader, *levels);
    std::uint8_t has_more = 0;
    std::uint8_t is_inside_out = 0;
    reader.field(has_more);
    reader.field(is_inside_out);
    Counts counts;
    walk_counts(reader, counts);
    // No more memory than bytes.
    if (!reader.is_whole() || !is_head(*levels) || has_more > 1 || is_inside_out > 1 ||
        counts.nodes < 1 || counts.nodes > reader.n_left() / kNodeBytes ||
        counts.points > reader.n_left() / sizeof(Vector3)) {
        return nullptr;
    }
    levels->report_.more_self_intersections = has_more == 1;
    levels->report_.inside_out = is_inside_out == 1;
    levels->nodes_.resize(counts.nodes);
    for (LevelNode& node : levels->nodes_) {
        std::uint8_t bounds = 0;
        walk_node(reader, node);
        reader.field(bounds);
        node.is_bound_only = bounds == 1;
        if (!reader.is_whole() || bounds > 1) {
            return nullptr;
        }
    }
    reader.array(levels->points_of_, counts.nodes);
    reader.array(levels->links_of_, counts.nodes);
    reader.array(levels->triangles_of_, counts.nodes);
    if (!reader.is_whole() || counts.points > reader.n_left() / sizeof(Vector3)) {
        return nullptr;
    }
    levels->points_.resize(counts.points);
    for (Vector3& point : levels->points_) {
        walk_vector(reader, point);
    }
    reader.array(levels->first_links_, counts.first_links);
    reader.array(levels->links_, counts.links);
    reader.array(levels->triangles_, counts.triangles);
    if (!reader.is_whole() || reader.n_left() != 0 || !is_tree(*levels) || !are_hulls(*levels) ||
        !are_triangles(*levels)) {
        return nullptr;
    }
    return levels;
}

// The spans of the leaves hold every triangle once, and their hulls its corners.
bool ContactLevelsBytes::holds_triangles(const ContactLevels& levels, const TriangleMesh& mesh) {
    const double rounding_m = kLevelRounding * mesh.diagonal_m();
    if (levels.triangles_.size() != mesh.triangles().size() ||
        std::abs(levels.size_m_ - 0.5 * mesh.diagonal_m()) > rounding_m) {
        return false;
    }
    std::vector<bool> is_held(levels.triangles_.size(), false);
    std::size_t n_held = 0;
    double reach_m = 0.0;
    for (std::size_t i = 0; i < levels.nodes_.size(); ++i) {
        if (levels.nodes_[i].n_children > 0) {
            continue;
        }
        const auto node = static_cast<std::int32_t>(i);
        const HullView hull = levels.hull(node);
        const auto triangles = levels.triangles_of(node);
        n_held += triangles.size();
        for (const std::int32_t triangle : triangles) {
            if (is_held[static_cast<std::size_t>(triangle)]) {
                return false;
            }
            is_held[static_cast<std::size_t>(triangle)] = true;
            for (const std::int32_t corner : mesh.triangles()[static_cast<std::size_t>(triangle)]) {
                const Vector3& place = mesh.vertices_B()[static_cast<std::size_t>(corner)];
                reach_m = std::max(reach_m, place.norm());
                const bool is_corner = hull.points.size() < kClimbFrom &&
                                       std::ranges::find(hull.points, place) != hull.points.end();
                if (!is_corner && find_nearest_in_hull(hull, place).gap_m >
                                      levels.nodes_[i].outside_m + rounding_m) {
                    return false;
                }
            }
        }
    }
    return n_held == levels.triangles_.size() && std::abs(reach_m - levels.reach_m_) <= rounding_m;
}

// In its parent's hull and sphere, and no less outside.
bool ContactLevelsBytes::hold_children(const ContactLevels& levels) {
    const double rounding_m = 2.0 * kLevelRounding * levels.size_m_;
    for (std::size_t i = 0; i < levels.nodes_.size(); ++i) {
        const LevelNode& node = levels.nodes_[i];
        const HullView hull = levels.hull(static_cast<std::int32_t>(i));
        for (const Vector3& point : hull.points) {
            if ((point - node.centre_B).norm() > node.radius_m + rounding_m) {
                return false;
            }
        }
        for (std::int32_t k = 0; k < node.n_children; ++k) {
            const std::int32_t child = node.first_child + k;
            if (levels.node(child).outside_m > node.outside_m) {
                return false;
            }
            for (const Vector3& point : levels.hull(child).points) {
                if (find_nearest_in_hull(hull, point).gap_m > rounding_m) {
                    return false;
                }
            }
        }
    }
    return true;
}

namespace {

auto payload_of_levels(const ContactLevels& levels) {
    return [&levels](auto& walker) { ContactLevelsBytes::walk(walker, levels); };
}

}  // namespace

std::size_t count_bytes(const ContactLevels& levels) {
    return count_sealed(payload_of_levels(levels));
}

Bytes encode(const ContactLevels& levels, const Digest& key) {
    return seal(ShapeKind::contact_levels, key, payload_of_levels(levels));
}

Expected<std::shared_ptr<const ContactLevels>> decode_contact_levels(
    std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::contact_levels, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    ByteReader reader(*payload);
    auto levels = ContactLevelsBytes::read(reader);
    if (levels == nullptr) {
        return refuse("the kept contact levels are none");
    }
    return levels;
}

bool can_be_of(const ContactLevels& levels, const TriangleMesh& mesh) {
    return ContactLevelsBytes::holds_triangles(levels, mesh) &&
           ContactLevelsBytes::hold_children(levels);
}

}  // namespace fulcrum
