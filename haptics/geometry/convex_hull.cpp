#include "haptics/geometry/convex_hull.h"

#include "haptics/math/length.h"
#include "haptics/math/orientation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace fulcrum {

namespace {

using Corner = std::int32_t;

struct Face {
    std::array<Corner, 3> corner;
    std::array<std::int32_t, 3> neighbour;  // across the edge from corner i to the next
    std::vector<Corner> outside;            // points that see it, each in one face's list alone
    bool alive = true;
};

// A corner and the next on the border of what a point sees, and the face beyond.
struct BorderEdge {
    Corner from;
    Corner to;
    std::int32_t beyond;
};

class HullBuilder {
  public:
    explicit HullBuilder(const std::vector<Vector3>& points) : points_(points) {}

    // False when all points lie in a plane.
    bool build() {
        std::array<Corner, 4> first{};
        if (!find_first(first)) {
            return false;
        }
        begin(first);
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            while (faces_[face].alive && !faces_[face].outside.empty()) {
                take(find_farthest(faces_[face]), static_cast<std::int32_t>(face));
            }
        }
        return true;
    }

    [[nodiscard]] std::vector<TriangleCorners> triangles() const {
        std::vector<TriangleCorners> found;
        for (const Face& face : faces_) {
            if (face.alive) {
                found.push_back(face.corner);
            }
        }
        return found;
    }

  private:
    [[nodiscard]] const Vector3& at(Corner corner) const {
        return points_[static_cast<std::size_t>(corner)];
    }
    [[nodiscard]] bool sees(Corner point, const Face& face) const {
        return orientation(at(face.corner[0]), at(face.corner[1]), at(face.corner[2]), at(point)) >
               0;
    }
    template <class Measure>
    [[nodiscard]] Corner find_largest(Measure&& measure) const {
        Corner best = 0;
        double largest = -1.0;
        for (Corner i = 0; i < static_cast<Corner>(points_.size()); ++i) {
            const double here = measure(at(i));
            if (here > largest) {
                largest = here;
                best = i;
            }
        }
        return best;
    }

    // Four points that span a body: far from each other, but not in one plane by exact signs.
    bool find_first(std::array<Corner, 4>& first) const {
        first[0] = 0;
        first[1] = find_largest([&](const Vector3& p) { return (p - at(first[0])).squaredNorm(); });
        const Vector3 along = compute_direction(Vector3(at(first[1]) - at(first[0])));
        first[2] = find_largest(
            [&](const Vector3& p) { return along.cross(p - at(first[0])).squaredNorm(); });
        const Vector3 normal = compute_direction(Vector3(along.cross(at(first[2]) - at(first[0]))));
        first[3] =
            find_largest([&](const Vector3& p) { return std::abs(normal.dot(p - at(first[0]))); });
        int side = orientation(at(first[0]), at(first[1]), at(first[2]), at(first[3]));
        for (Corner i = 0; side == 0 && i < static_cast<Corner>(points_.size()); ++i) {
            first[3] = i;
            side = orientation(at(first[0]), at(first[1]), at(first[2]), at(i));
        }
        if (side > 0) {
            std::swap(first[0], first[1]);
        }
        return side != 0;
    }

    // The fourth point does not see the face of the first three.
    void begin(const std::array<Corner, 4>& p) {
        faces_ = {{{p[0], p[1], p[2]}, {3, 1, 2}, {}},
                  {{p[2], p[1], p[3]}, {0, 3, 2}, {}},
                  {{p[0], p[2], p[3]}, {0, 1, 3}, {}},
                  {{p[1], p[0], p[3]}, {0, 2, 1}, {}}};
        std::vector<Corner> all(points_.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = static_cast<Corner>(i);
        }
        hand_out(all, 0);
    }

    // Gives each point to the first of the faces from `first_face` on that it sees; one that sees none is inside.
    void hand_out(const std::vector<Corner>& points, std::size_t first_face) {
        for (const Corner point : points) {
            for (std::size_t face = first_face; face < faces_.size(); ++face) {
                if (sees(point, faces_[face])) {
                    faces_[face].outside.push_back(point);
                    break;
                }
            }
        }
    }

    [[nodiscard]] Corner find_farthest(const Face& face) const {
        const Vector3& a = at(face.corner[0]);
        const Vector3 normal = (at(face.corner[1]) - a).cross(at(face.corner[2]) - a);
        return *std::ranges::max_element(face.outside, {},
                                         [&](Corner point) { return normal.dot(at(point) - a); });
    }

    // The point becomes a corner of the hull.
    void take(Corner point, std::int32_t seen_face) {
        std::vector<Corner> orphans;
        const std::vector<BorderEdge> border = remove_seen(point, seen_face, orphans);
        const std::size_t first_new = faces_.size();
        std::map<Corner, std::int32_t> face_from;  // the new face whose border edge starts there
        for (const BorderEdge& edge : border) {
            const auto index = static_cast<std::int32_t>(faces_.size());
            faces_.push_back({{edge.from, edge.to, point}, {edge.beyond, -1, -1}, {}});
            face_from[edge.from] = index;
            Face& beyond = faces_[static_cast<std::size_t>(edge.beyond)];
            for (std::size_t i = 0; i < 3; ++i) {
                if (beyond.corner[i] == edge.to && beyond.corner[(i + 1) % 3] == edge.from) {
                    beyond.neighbour[i] = index;
                }
            }
        }
        for (std::size_t i = first_new; i < faces_.size(); ++i) {
            const std::int32_t next = face_from.at(faces_[i].corner[1]);
            faces_[i].neighbour[1] = next;
            faces_[static_cast<std::size_t>(next)].neighbour[2] = static_cast<std::int32_t>(i);
        }
        std::erase(orphans, point);
        hand_out(orphans, first_new);
    }

    // All faces that the point sees, and the border round them.
    std::vector<BorderEdge> remove_seen(Corner point, std::int32_t first,
                                        std::vector<Corner>& orphans) {
        std::vector<BorderEdge> border;
        std::vector<std::int32_t> open{first};
        faces_[static_cast<std::size_t>(first)].alive = false;
        while (!open.empty()) {
            Face& face = faces_[static_cast<std::size_t>(open.back())];
            open.pop_back();
            orphans.insert(orphans.end(), face.outside.begin(), face.outside.end());
            face.outside.clear();
            for (std::size_t i = 0; i < 3; ++i) {
                Face& other = faces_[static_cast<std::size_t>(face.neighbour[i])];
                if (other.alive && sees(point, other)) {
                    other.alive = false;
                    open.push_back(face.neighbour[i]);
                }
            }
            seen_.push_back(&face - faces_.data());
        }
        for (const std::ptrdiff_t index : seen_) {
            const Face& face = faces_[static_cast<std::size_t>(index)];
            for (std::size_t i = 0; i < 3; ++i) {
                if (faces_[static_cast<std::size_t>(face.neighbour[i])].alive) {
                    border.push_back({face.corner[i], face.corner[(i + 1) % 3], face.neighbour[i]});
                }
            }
        }
        seen_.clear();
        return border;
    }

    const std::vector<Vector3>& points_;
    std::vector<Face> faces_;
    std::vector<std::ptrdiff_t> seen_;
};

}  // namespace

Expected<TriangleMesh> make_convex_hull(const std::vector<Vector3>& points_B) {
    for (const Vector3& point : points_B) {
        if (!(largest_component(point) <= TriangleMesh::kLargestCoordinate_m)) {
            return fail("a point of the hull is not finite or beyond 1e30 m", {},
                        "leave it out or scale the cloud");
        }
    }
    HullBuilder builder(points_B);
    if (points_B.size() < 4 || !builder.build()) {
        return fail("the hull's points lie in a plane", {},
                    "add one that gives the body a thickness");
    }
    // Only the corners that are used, counted anew.
    std::vector<TriangleCorners> triangles = builder.triangles();
    std::vector<std::int32_t> new_index(points_B.size(), -1);
    std::vector<Vector3> vertices_B;
    for (TriangleCorners& triangle : triangles) {
        for (std::int32_t& corner : triangle) {
            std::int32_t& index = new_index[static_cast<std::size_t>(corner)];
            if (index < 0) {
                index = static_cast<std::int32_t>(vertices_B.size());
                vertices_B.push_back(points_B[static_cast<std::size_t>(corner)]);
            }
            corner = index;
        }
    }
    return TriangleMesh::build(std::move(vertices_B), std::move(triangles), {.weld_relative = 0.0});
}

}  // namespace fulcrum
