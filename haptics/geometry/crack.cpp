#include "haptics/geometry/crack.h"

#include "haptics/geometry/near_points.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace fulcrum {

namespace {

// A triangle that keeps its side keeps at least this cosine between its normals before and after.
constexpr double kLeastTurn = 0.5;

struct OpenEdge {
    std::array<std::int32_t, 2> ends;
    std::int32_t triangle;
    Vector3 inwards;  // unit, into the triangle
};

// Two open edges that may be one.
struct Match {
    double distance_m;  // of the ends that are further apart
    std::int32_t one;
    std::int32_t other;
    bool crossed;  // the first end of one belongs to the second end of the other
};

class CrackCloser {
  public:
    CrackCloser(std::span<const Vector3> vertices, std::span<const TriangleCorners> triangles,
                double tolerance_m)
        : vertices_(vertices), triangles_(triangles), tolerance_m_(tolerance_m) {}

    ClosedCracks run() {
        find_open_edges();
        if (open_.size() < 2) {
            return {};
        }
        list_triangles_of_open_vertices();
        becomes_.resize(vertices_.size());
        std::iota(becomes_.begin(), becomes_.end(), 0);
        members_.resize(vertices_.size());
        is_closed_.assign(open_.size(), false);
        for (const Match& match : find_matches()) {
            close(match);
        }
        return sum_up();
    }

  private:
    [[nodiscard]] const Vector3& at(std::int32_t vertex) const {
        return vertices_[static_cast<std::size_t>(vertex)];
    }
    [[nodiscard]] std::int32_t& becomes(std::int32_t vertex) {
        return becomes_[static_cast<std::size_t>(vertex)];
    }

    void find_open_edges() {
        const std::vector<MeshEdge> edges = collect_edges(triangles_, vertices_.size());
        for_each_shared_edge(edges, [this](std::span<const MeshEdge> shared) {
            if (shared.size() == 1) {
                const MeshEdge& edge = shared.front();
                const TriangleCorners& t = triangles_[static_cast<std::size_t>(edge.triangle)];
                const std::int32_t third = *std::find_if(t.begin(), t.end(), [&](std::int32_t v) {
                    return v != edge.low && v != edge.high;
                });
                const Vector3 along = compute_direction(Vector3(at(edge.high) - at(edge.low)));
                const Vector3 in = at(third) - at(edge.low);
                open_.push_back({{edge.low, edge.high},
                                 edge.triangle,
                                 compute_direction(Vector3(in - in.dot(along) * along))});
            }
        });
    }

    // For the check of what a weld does to them.
    void list_triangles_of_open_vertices() {
        around_.resize(vertices_.size());
        std::vector<bool> is_open(vertices_.size(), false);
        for (const OpenEdge& edge : open_) {
            for (const std::int32_t end : edge.ends) {
                is_open[static_cast<std::size_t>(end)] = true;
            }
        }
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            for (const std::int32_t corner : triangles_[i]) {
                if (is_open[static_cast<std::size_t>(corner)]) {
                    around_[static_cast<std::size_t>(corner)].push_back(
                        static_cast<std::int32_t>(i));
                }
            }
        }
    }

    [[nodiscard]] Match match(std::int32_t one, std::int32_t other) const {
        const OpenEdge& a = open_[static_cast<std::size_t>(one)];
        const OpenEdge& b = open_[static_cast<std::size_t>(other)];
        const auto farther = [&](std::size_t first) {
            return std::max((at(a.ends[0]) - at(b.ends[first])).norm(),
                            (at(a.ends[1]) - at(b.ends[1 - first])).norm());
        };
        const double straight_m = farther(0);
        const double crossed_m = farther(1);
        return {std::min(straight_m, crossed_m), one, other, crossed_m < straight_m};
    }

    // All that face each other, nearest first.
    [[nodiscard]] std::vector<Match> find_matches() const {
        std::vector<Vector3> middles;
        middles.reserve(open_.size());
        for (const OpenEdge& edge : open_) {
            middles.emplace_back(0.5 * (at(edge.ends[0]) + at(edge.ends[1])));
        }
        NearPoints near(middles, tolerance_m_);
        std::vector<Match> matches;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const auto one = static_cast<std::int32_t>(i);
            int n_near = 0;
            near.for_each_near(middles[i], [&](std::int32_t other) {
                const Match here = match(one, other);
                const double fold =
                    open_[i].inwards.dot(open_[static_cast<std::size_t>(other)].inwards);
                if (++n_near <= kMostNear && here.distance_m <= tolerance_m_ && fold < kFolded) {
                    matches.push_back(here);
                }
            });
            near.add(one);
        }
        std::sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
            return std::tuple(a.distance_m, a.one, a.other) <
                   std::tuple(b.distance_m, b.one, b.other);
        });
        return matches;
    }

    void close(const Match& match) {
        const auto one = static_cast<std::size_t>(match.one);
        const auto other = static_cast<std::size_t>(match.other);
        if (is_closed_[one] || is_closed_[other]) {
            return;
        }
        const auto& ends = open_[one].ends;
        auto mates = open_[other].ends;
        if (match.crossed) {
            std::swap(mates[0], mates[1]);
        }
        // One end alone only shortens the crack, which does no harm.
        for (std::size_t end = 0; end < 2; ++end) {
            if (!can_unite(ends[end], mates[end])) {
                return;
            }
            unite(becomes(ends[end]), becomes(mates[end]));
        }
        is_closed_[one] = true;
        is_closed_[other] = true;
        closed_.push_back(match);
    }

    // May the vertices that these two have become be one?
    [[nodiscard]] bool can_unite(std::int32_t a, std::int32_t b) {
        const std::int32_t kept = std::min(becomes(a), becomes(b));
        const std::int32_t left = std::max(becomes(a), becomes(b));
        return kept == left || ((at(kept) - at(left)).norm() <= tolerance_m_ &&
                                keeps_triangles(left, kept) && keeps_triangles_of(left, kept));
    }
    [[nodiscard]] bool keeps_triangles_of(std::int32_t left, std::int32_t kept) {
        const auto& members = members_[static_cast<std::size_t>(left)];
        return std::all_of(members.begin(), members.end(),
                           [&](std::int32_t member) { return keeps_triangles(member, kept); });
    }
    // Do the triangles round a vertex keep their side when it moves to `kept`?
    [[nodiscard]] bool keeps_triangles(std::int32_t vertex, std::int32_t kept) {
        const std::int32_t before = becomes(vertex);
        const auto& around = around_[static_cast<std::size_t>(vertex)];
        return std::all_of(around.begin(), around.end(), [&](std::int32_t triangle) {
            const TriangleCorners& t = triangles_[static_cast<std::size_t>(triangle)];
            TriangleCorners moved{};
            for (std::size_t k = 0; k < 3; ++k) {
                moved[k] = becomes(t[k]) == before ? kept : becomes(t[k]);
            }
            // Zero for one that would have no area left.
            const auto normal = [&](const TriangleCorners& c) {
                return compute_direction(Vector3((at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0]))));
            };
            return normal(t).dot(normal(moved)) > kLeastTurn;
        });
    }
    void unite(std::int32_t a, std::int32_t b) {
        const std::int32_t kept = std::min(a, b);
        const std::int32_t left = std::max(a, b);
        if (kept == left) {
            return;
        }
        auto& members = members_[static_cast<std::size_t>(kept)];
        auto& leaving = members_[static_cast<std::size_t>(left)];
        members.push_back(left);
        members.insert(members.end(), leaving.begin(), leaving.end());
        for (const std::int32_t member : leaving) {
            becomes(member) = kept;
        }
        becomes(left) = kept;
        leaving.clear();
    }

    // Cracks are what hangs together of the closed edges.
    [[nodiscard]] ClosedCracks sum_up() {
        ClosedCracks result;
        result.closed_edges = static_cast<std::int64_t>(closed_.size());
        for (std::size_t i = 0; i < becomes_.size(); ++i) {
            result.welded_vertices += becomes_[i] != static_cast<std::int32_t>(i) ? 1 : 0;
        }
        std::vector<std::int32_t> crack(vertices_.size());
        std::iota(crack.begin(), crack.end(), 0);
        const auto root = [&crack](std::int32_t vertex) {
            while (crack[static_cast<std::size_t>(vertex)] != vertex) {
                std::int32_t& up = crack[static_cast<std::size_t>(vertex)];
                up = crack[static_cast<std::size_t>(up)];
                vertex = up;
            }
            return vertex;
        };
        for (const Match& match : closed_) {
            const auto& ends = open_[static_cast<std::size_t>(match.one)].ends;
            crack[static_cast<std::size_t>(root(becomes(ends[0])))] = root(becomes(ends[1]));
        }
        std::set<std::int32_t> roots;
        for (const Match& match : closed_) {
            roots.insert(root(becomes(open_[static_cast<std::size_t>(match.one)].ends[0])));
        }
        result.cracks = static_cast<std::int64_t>(roots.size());
        if (result.welded_vertices > 0) {
            result.becomes = std::move(becomes_);
        }
        return result;
    }

    std::span<const Vector3> vertices_;
    std::span<const TriangleCorners> triangles_;
    double tolerance_m_;
    std::vector<OpenEdge> open_;
    std::vector<std::vector<std::int32_t>> around_;   // triangles of each open vertex
    std::vector<std::int32_t> becomes_;               // of each vertex
    std::vector<std::vector<std::int32_t>> members_;  // vertices that became this one
    std::vector<bool> is_closed_;                     // of each open edge
    std::vector<Match> closed_;
};

}  // namespace

ClosedCracks close_cracks(std::span<const Vector3> vertices,
                          std::span<const TriangleCorners> triangles, double tolerance_m) {
    return CrackCloser(vertices, triangles, tolerance_m).run();
}

}  // namespace fulcrum
