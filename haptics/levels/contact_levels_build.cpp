#include "haptics/levels/contact_levels.h"
#include "haptics/levels/filtered_collapse.h"
#include "haptics/levels/level_draft.h"
#include "haptics/levels/surface_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

}  // namespace

class ContactLevelsBuilder {
  public:
    ContactLevelsBuilder(const TriangleMesh& mesh, const ContactLevelSettings& settings,
                         const ConvexPieces& pieces, LoadPulse& pulse)
        : mesh_(mesh),
          settings_(settings),
          pieces_(pieces),
          pulse_(pulse),
          surface_(mesh, pieces),
          distance_(mesh),
          nodes_of_(static_cast<std::size_t>(pieces.n_pieces)) {}

    bool run() {
        make_leaves();
        return simplify() && join_by_place();
    }
    [[nodiscard]] std::shared_ptr<const ContactLevels> take();

  private:
    void make_leaves();
    bool simplify();
    bool add_level(const FilteredCollapse& collapse);
    void add_node(std::int32_t piece, double longest_m);
    bool join_by_place();
    std::int32_t join_span(std::span<std::int32_t> drafts);
    void bound(LevelDraft& draft);
    void put(ContactLevels& levels, std::int32_t draft, std::size_t place);
    [[nodiscard]] std::vector<std::vector<std::int32_t>> collect_triangles() const;

    const TriangleMesh& mesh_;
    const ContactLevelSettings& settings_;
    const ConvexPieces& pieces_;
    LoadPulse& pulse_;
    LevelSurface surface_;
    SurfaceDistance distance_;
    std::vector<LevelDraft> drafts_;
    std::vector<std::vector<std::int32_t>> nodes_of_;  // of a piece: the drafts that stand for it
    std::vector<std::vector<std::int32_t>> triangles_of_piece_;
    PieceShape shape_;
    std::int32_t n_levels_ = 1;
    std::int32_t root_ = 0;
};

void ContactLevelsBuilder::make_leaves() {
    constexpr std::size_t kSamples = 4;
    SupportArea support(surface_, settings_.within_m);
    for (const std::int32_t piece : surface_.collect_pieces()) {
        LevelDraft draft;
        draft.piece = piece;
        surface_.describe(piece, shape_);
        draft.take_points(shape_, pieces_.slack_m);
        // What find_nearest_in_hull leaves open, and rounding.
        draft.node.outside_m =
            draft.measure_outside_m(shape_.corners) + 1.0e-9 * mesh_.diagonal_m();
        draft.look(surface_, piece);
        const auto triangles = surface_.triangles_of(piece);
        const std::size_t n_samples = std::min(kSamples, triangles.size());
        for (std::size_t i = 0; i < n_samples; ++i) {
            const std::int32_t triangle = triangles[i * triangles.size() / n_samples];
            draft.node.support_m2 += support.measure_m2(surface_.corners(triangle)[i % 3]) /
                                     static_cast<double>(n_samples);
        }
        draft.node.resolution_per_m = kEndless;
        nodes_of_[static_cast<std::size_t>(piece)] = {static_cast<std::int32_t>(drafts_.size())};
        drafts_.push_back(std::move(draft));
    }
}

bool ContactLevelsBuilder::simplify() {
    FilteredCollapse collapse(surface_, pieces_.slack_m);
    while (surface_.n_pieces() > 1) {
        const std::int32_t before = surface_.n_pieces();
        const bool goes_on = collapse.go_on_to(before / 2, pulse_);
        if (!goes_on && !pulse_.goes_on(kSimplifying)) {
            return false;  // it was told to stop
        }
        if (surface_.n_pieces() < before && !add_level(collapse)) {
            return false;
        }
        if (!goes_on) {
            break;
        }
    }
    return true;
}

bool ContactLevelsBuilder::add_level(const FilteredCollapse& collapse) {
    for (std::size_t piece = 0; piece < nodes_of_.size(); ++piece) {
        const auto became =
            static_cast<std::size_t>(surface_.find_piece(static_cast<std::int32_t>(piece)));
        if (became != piece) {
            auto& to = nodes_of_[became];
            to.insert(to.end(), nodes_of_[piece].begin(), nodes_of_[piece].end());
            nodes_of_[piece].clear();
        }
    }
    for (const std::int32_t piece : surface_.collect_pieces()) {
        if (!pulse_.goes_on(kSimplifying *
                            (1.0 - static_cast<double>(surface_.n_pieces()) / pieces_.n_pieces))) {
            return false;
        }
        add_node(piece, collapse.longest_m());
    }
    ++n_levels_;
    return true;
}

void ContactLevelsBuilder::add_node(std::int32_t piece, double longest_m) {
    auto& nodes = nodes_of_[static_cast<std::size_t>(piece)];
    surface_.describe(piece, shape_);
    // One that only lost a few corners stays what it was.
    if (nodes.size() == 1) {
        const std::size_t n_before = drafts_[static_cast<std::size_t>(nodes.front())].points.size();
        if (n_before < 8 || 2 * shape_.corners.size() > n_before) {
            return;
        }
    }
    LevelDraft draft;
    draft.node.level = n_levels_;
    draft.node.resolution_per_m = 1.0 / longest_m;
    draft.points = shape_.corners;
    draft.children = nodes;
    nodes = {static_cast<std::int32_t>(drafts_.size())};
    drafts_.push_back(std::move(draft));
}

// Half after half across the longest side of their middles.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the tree
std::int32_t ContactLevelsBuilder::join_span(std::span<std::int32_t> drafts) {
    if (drafts.size() == 1) {
        return drafts.front();
    }
    const auto middle_of = [this](std::int32_t draft) {
        const auto& points = drafts_[static_cast<std::size_t>(draft)].points;
        Vector3 lower = points.front();
        Vector3 upper = lower;
        for (const Vector3& point : points) {
            lower = lower.cwiseMin(point);
            upper = upper.cwiseMax(point);
        }
        return Vector3(0.5 * (lower + upper));
    };
    Vector3 lower = middle_of(drafts.front());
    Vector3 upper = lower;
    for (const std::int32_t draft : drafts) {
        lower = lower.cwiseMin(middle_of(draft));
        upper = upper.cwiseMax(middle_of(draft));
    }
    Index axis = 0;
    (upper - lower).maxCoeff(&axis);
    std::ranges::sort(drafts, [&](std::int32_t a, std::int32_t b) {
        const double at_a = middle_of(a)[axis];
        const double at_b = middle_of(b)[axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    LevelDraft draft;
    draft.node.is_bound_only = true;
    draft.children = {join_span(drafts.first(drafts.size() / 2)),
                      join_span(drafts.subspan(drafts.size() / 2))};
    draft.points = {lower, upper};
    for (const std::int32_t child : draft.children) {
        const std::int32_t level = drafts_[static_cast<std::size_t>(child)].node.level;
        draft.node.level = std::max(draft.node.level, level + 1);
    }
    drafts_.push_back(std::move(draft));
    return static_cast<std::int32_t>(drafts_.size() - 1);
}

bool ContactLevelsBuilder::join_by_place() {
    std::vector<std::int32_t> last;
    for (const std::int32_t piece : surface_.collect_pieces()) {
        const auto& nodes = nodes_of_[static_cast<std::size_t>(piece)];
        last.insert(last.end(), nodes.begin(), nodes.end());
    }
    root_ = join_span(last);
    // Below first, for children are made before their parent.
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
        if (!pulse_.goes_on(kSimplifying + (1.0 - kSimplifying) * static_cast<double>(i) /
                                               static_cast<double>(drafts_.size()))) {
            return false;
        }
        bound(drafts_[i]);
    }
    return true;
}

// Of the bounds of its children.
void ContactLevelsBuilder::bound(LevelDraft& draft) {
    LevelNode& node = draft.node;
    if (!draft.children.empty()) {
        std::vector<const LevelDraft*> below;
        std::vector<Vector3> corners;
        for (const std::int32_t child : draft.children) {
            const LevelDraft& one = drafts_[static_cast<std::size_t>(child)];
            below.push_back(&one);
            corners.insert(corners.end(), one.points.begin(), one.points.end());
            node.outside_m = std::max(node.outside_m, one.node.outside_m);
            node.support_m2 += one.node.support_m2 / static_cast<double>(draft.children.size());
        }
        draft.look_as(below);
        draft.take_hull(corners);
        if (!node.is_bound_only) {
            constexpr double kOfNoUse = 0.1;
            node.deviation_m = draft.measure_bulge_m(distance_, 1.0 / node.resolution_per_m,
                                                     kOfNoUse * mesh_.diagonal_m());
        }
        draft.faces = {};
        const double length_m = node.resolution_per_m > 0.0 ? 1.0 / node.resolution_per_m : 0.0;
        node.detail_m3 = node.is_bound_only ? kEndless : node.deviation_m * length_m * length_m;
    }
    draft.find_sphere();
}

std::vector<std::vector<std::int32_t>> ContactLevelsBuilder::collect_triangles() const {
    std::vector<std::vector<std::int32_t>> triangles(static_cast<std::size_t>(pieces_.n_pieces));
    for (std::size_t i = 0; i < pieces_.piece_of.size(); ++i) {
        triangles[static_cast<std::size_t>(pieces_.piece_of[i])].push_back(
            static_cast<std::int32_t>(i));
    }
    return triangles;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the tree
void ContactLevelsBuilder::put(ContactLevels& levels, std::int32_t draft, std::size_t place) {
    const auto count = [](const auto& list) { return static_cast<std::int32_t>(list.size()); };
    LevelDraft& one = drafts_[static_cast<std::size_t>(draft)];
    levels.points_of_[place] = {count(levels.points_), count(one.points)};
    levels.points_.insert(levels.points_.end(), one.points.begin(), one.points.end());
    levels.links_of_[place] = {count(levels.first_links_), count(one.first_link)};
    for (const std::int32_t first : one.first_link) {
        levels.first_links_.push_back(count(levels.links_) + first);
    }
    levels.links_.insert(levels.links_.end(), one.links.begin(), one.links.end());
    one.node.first_child = count(levels.nodes_);
    one.node.n_children = count(one.children);
    const std::size_t first_child = levels.nodes_.size();
    const std::size_t n = first_child + one.children.size();
    levels.nodes_.resize(n);
    levels.points_of_.resize(n);
    levels.links_of_.resize(n);
    levels.triangles_of_.resize(n);
    levels.triangles_of_[place].first = count(levels.triangles_);
    if (one.piece >= 0) {
        const auto& own = triangles_of_piece_[static_cast<std::size_t>(one.piece)];
        levels.triangles_.insert(levels.triangles_.end(), own.begin(), own.end());
    }
    for (std::size_t i = 0; i < one.children.size(); ++i) {
        put(levels, one.children[i], first_child + i);
    }
    levels.triangles_of_[place].count =
        count(levels.triangles_) - levels.triangles_of_[place].first;
    levels.nodes_[place] = one.node;
}

std::shared_ptr<const ContactLevels> ContactLevelsBuilder::take() {
    std::shared_ptr<ContactLevels> levels(new ContactLevels);
    levels->settings_ = settings_;
    levels->report_ = compute_mesh_report(mesh_);
    levels->nodes_.resize(1);
    levels->points_of_.resize(1);
    levels->links_of_.resize(1);
    levels->triangles_of_.resize(1);
    triangles_of_piece_ = collect_triangles();
    put(*levels, root_, 0);
    levels->size_m_ = 0.5 * mesh_.diagonal_m();
    for (const TriangleCorners& triangle : mesh_.triangles()) {
        for (const std::int32_t corner : triangle) {
            levels->reach_m_ = std::max(
                levels->reach_m_, mesh_.vertices_B()[static_cast<std::size_t>(corner)].norm());
        }
    }
    levels->n_levels_ = n_levels_;
    levels->n_pieces_ = pieces_.n_pieces;
    levels->nodes_.shrink_to_fit();
    levels->points_.shrink_to_fit();
    return levels;
}

Expected<std::shared_ptr<const ContactLevels>> ContactLevels::create(
    const TriangleMesh& mesh, const ContactLevelSettings& settings, const LoadProgress& progress) {
    if (const Expected<void> right = validate(settings); !right) {
        return tl::make_unexpected(right.error());
    }
    // Cutting, then all else: about a fifth of the time.
    constexpr double kCutting = 0.2;
    const LoadProgress of_cutting = [&](double share) { return progress(kCutting * share); };
    const LoadProgress of_rest = [&](double share) {
        return progress(kCutting + (1.0 - kCutting) * share);
    };
    const Expected<ConvexPieces> pieces =
        make_convex_pieces(mesh, progress ? of_cutting : LoadProgress());
    if (!pieces) {
        return tl::make_unexpected(pieces.error());
    }
    const LoadProgress rest = progress ? of_rest : LoadProgress();
    LoadPulse pulse(rest);
    ContactLevelsBuilder builder(mesh, settings, *pieces, pulse);
    if (!builder.run()) {
        return fail("the contact levels were stopped before they were made", {}, "make them again");
    }
    return builder.take();
}

}  // namespace fulcrum
