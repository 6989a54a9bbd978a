#include "haptics/levels/level_bytes.h"

#include "haptics/geometry/shape.h"
#include "haptics/levels/level_pairs.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/gear.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/kept_bytes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

using Levels = std::shared_ptr<const ContactLevels>;

using test::kPayloadAt;
using test::number_at;
using test::with_mended;

// Within the payload: what stands before the nodes, and in each of these.
constexpr std::size_t kCountsAt = 8 + 8 * 8 + 4 * 8 + 2 * 8 + 2 * 4 + 2;
constexpr std::size_t kNodesAt = kCountsAt + 5 * 8;
constexpr std::size_t kNodeBytes = 117;

TriangleMesh gear() {
    return make_gear({}).value();
}

Levels make_levels(const TriangleMesh& mesh) {
    return ContactLevels::create(mesh, {.within_m = 1.0e-3}).value();
}

Digest key_of_levels(const TriangleMesh& mesh) {
    return compute_shape_key(ShapeKind::contact_levels, mesh, std::vector<double>{1.0e-3});
}

// A gear's levels as they are kept, and where in the payload its nodes' spans begin.
struct GearBytes {
    TriangleMesh mesh = gear();
    Levels made = make_levels(mesh);
    Digest key = key_of_levels(mesh);
    Bytes bytes = encode(*made, key);
    std::size_t spans_at = kNodesAt + made->nodes().size() * kNodeBytes;
};

// Two balls, one with more corners than are asked one by one; a gear; what is broken.
std::vector<TriangleMesh> meshes() {
    return {make_box(Vector3(0.06, 0.04, 0.02)).value(),
            make_sphere(0.05, 12).value(),
            gear(),
            make_messy(gear(), 0.0).value(),
            make_cracked(gear(), 1.0e-4, 3, 0.0).value(),
            make_t_junctions(make_sphere(0.05, 6).value()).value()};
}

TEST_CASE("level bytes: what was kept answers every question as what was made, to the bit") {
    std::size_t n_contacts = 0;
    for (const TriangleMesh& mesh : meshes()) {
        const Levels made = make_levels(mesh);
        const Digest key = key_of_levels(mesh);
        const Bytes bytes = encode(*made, key);
        CHECK(bytes.size() == count_bytes(*made));
        const auto back = decode_contact_levels(bytes, key);
        REQUIRE(back);
        CHECK(encode(**back, key) == bytes);
        CHECK(can_be_of(**back, mesh));
        CHECK((*back)->n_levels() == made->n_levels());
        CHECK((*back)->n_pieces() == made->n_pieces());
        CHECK((*back)->size_m() == made->size_m());
        CHECK((*back)->reach_m() == made->reach_m());
        CHECK(to_sentence((*back)->report()) == to_sentence(made->report()));
        const auto own = LevelPairs::create(made, made, {.tolerance_m = 1.0e-3}).value();
        const auto kept = LevelPairs::create(*back, *back, {.tolerance_m = 1.0e-3}).value();
        Random random(5);
        for (int i = 0; i < 20; ++i) {
            const Pose X_OT{made->reach_m() * random.direction(), random.turn(3.0)};
            own->find(X_OT, 1.0e-3);
            kept->find(X_OT, 1.0e-3);
            REQUIRE(own->contacts().size() == kept->contacts().size());
            n_contacts += own->contacts().size();
            for (std::size_t k = 0; k < own->contacts().size(); ++k) {
                REQUIRE(own->contacts()[k].point_O == kept->contacts()[k].point_O);
                REQUIRE(own->contacts()[k].depth_m == kept->contacts()[k].depth_m);
                REQUIRE(own->contacts()[k].normal_O == kept->contacts()[k].normal_O);
            }
        }
    }
    CHECK(n_contacts > 1000);
}

TEST_CASE("level bytes: what is cut off, longer, changed, or of another mesh is refused") {
    const TriangleMesh box = make_box(Vector3(0.06, 0.04, 0.02)).value();
    const Digest key = key_of_levels(box);
    const Bytes bytes = encode(*make_levels(box), key);
    test::check_sealed(bytes, [&](std::span<const std::byte> some) {
        return decode_contact_levels(some, key).has_value();
    });
    CHECK_FALSE(decode_contact_levels(bytes, key_of_levels(gear())));
    CHECK_FALSE(decode_pointshell(bytes, key));
    // Whole, under its key, and not round this mesh.
    const TriangleMesh shifted = make_box(Vector3(0.06, 0.041, 0.02)).value();
    const auto back = decode_contact_levels(bytes, key);
    REQUIRE(back);
    CHECK(can_be_of(**back, box));
    CHECK_FALSE(can_be_of(**back, shifted));
    CHECK_FALSE(can_be_of(**back, gear()));
}

TEST_CASE("level bytes: levels that no maker makes are refused, their checksum right or not") {
    const GearBytes gear;
    const std::size_t n_nodes = gear.made->nodes().size();
    const LevelNode& root = gear.made->node(0);
    // The places are those of the layout.
    REQUIRE(number_at<std::uint64_t>(gear.bytes, kPayloadAt + kCountsAt) == n_nodes);
    REQUIRE(number_at<std::int32_t>(gear.bytes, kPayloadAt + kNodesAt) == root.first_child);
    REQUIRE(number_at<double>(gear.bytes, kPayloadAt + kNodesAt + 36) == root.radius_m);
    REQUIRE(number_at<std::int32_t>(gear.bytes, kPayloadAt + gear.spans_at + 4) ==
            static_cast<std::int32_t>(gear.made->hull(0).points.size()));
    const test::Mended mended(gear.bytes, [&](std::span<const std::byte> some) {
        return decode_contact_levels(some, gear.key).has_value();
    });
    // d, size and reach.
    for (const std::size_t at : {std::size_t{0}, kCountsAt - 26, kCountsAt - 18}) {
        mended.check_refused_at(at, kNan, kInfinity, -1.0, 0.0);
    }
    mended.check_refused_at(8, std::int64_t{-1});            // triangles of the report
    mended.check_refused_at(kCountsAt - 10, 0, 2147483647);  // levels
    mended.check_refused_at(kCountsAt - 6, gear.made->n_pieces() + 1);
    mended.check_refused_at(kCountsAt - 2, std::uint8_t{2});
    mended.check_refused_at(kCountsAt - 1, std::uint8_t{2});
    for (std::size_t at = kCountsAt; at < kNodesAt; at += 8) {
        for (const std::uint64_t n :
             {std::uint64_t{0}, std::uint64_t{1} << 60U, ~std::uint64_t{0}}) {
            CHECK((number_at<std::uint64_t>(gear.bytes, kPayloadAt + at) == n ||
                   !mended.takes_at(at, n)));
        }
    }
    // A node that is its own child, one of nobody, one of two, before its parent, or of more than there are.
    mended.check_refused_at(kNodesAt, -1, 0, root.first_child + 1, 2147483647);
    mended.check_refused_at(kNodesAt + 4, -1, 0, root.n_children + 1, 2147483647);
    mended.check_refused_at(kNodesAt + 8, -1, 1000);
    for (std::size_t number = 0; number < 13; ++number) {
        mended.check_refused_at(kNodesAt + 12 + 8 * number, kNan, -1.0e40);
    }
    for (const std::size_t finite : {0U, 3U, 4U, 5U, 7U, 9U, 12U}) {
        mended.check_refused_at(kNodesAt + 12 + 8 * finite, kInfinity);
    }
    mended.check_refused_at(kNodesAt + 116, std::uint8_t{2});
    // Hulls of no point, or of points and triangles that are not there.
    mended.check_refused_at(gear.spans_at + 4, 0, -1, 2147483647);
    for (const std::size_t list : {0U, 1U, 2U}) {
        mended.check_refused_at(gear.spans_at + 8 * list * n_nodes, -1);
    }
    mended.check_refused_at(gear.spans_at + 24 * n_nodes, kNan, 1.0e300);       // a point
    mended.check_refused_at(gear.bytes.size() - kPayloadAt - 36, -1, 1 << 30);  // a triangle
    // And what is within its range is taken.
    CHECK(mended.takes_at(kNodesAt + 12 + 8 * 5, 1.0e-3));
}

TEST_CASE("level bytes: hulls that leave out what lies below them are not those of the mesh") {
    const GearBytes gear;
    const test::Mended mended(gear.bytes, [&](std::span<const std::byte> some) {
        const auto back = decode_contact_levels(some, gear.key);
        return back && can_be_of(**back, gear.mesh);
    });
    // The root has one corner less, or has it elsewhere; its sphere is smaller.
    const auto n_corners = static_cast<std::int32_t>(gear.made->hull(0).points.size());
    mended.check_refused_at(gear.spans_at + 4, n_corners - 1);
    mended.check_refused_at(gear.spans_at + 24 * gear.made->nodes().size(), 0.0);
    mended.check_refused_at(kNodesAt + 36, 0.01);
    // A corner's neighbour that it has not.
    const Levels many = make_levels(make_sphere(0.05, 12).value());
    REQUIRE(many->hull(0).first_link.size() > kClimbFrom);
    const Digest& key = gear.key;
    const Bytes linked = encode(*many, key);
    const std::size_t n_links = number_at<std::uint64_t>(linked, kPayloadAt + kCountsAt + 24);
    const std::size_t n_triangles = number_at<std::uint64_t>(linked, kPayloadAt + kCountsAt + 32);
    const std::size_t links_at = linked.size() - 32 - 4 * (n_links + n_triangles);
    const auto links_to = [&](std::int32_t corner) {
        return decode_contact_levels(with_mended(linked, links_at, corner), key).has_value();
    };
    CHECK(links_to(0));
    CHECK_FALSE(links_to(-1));
    CHECK_FALSE(links_to(static_cast<std::int32_t>(many->hull(0).points.size())));
    CHECK_FALSE(
        decode_contact_levels(with_mended(linked, links_at - 4, std::int32_t{2147483647}), key));
}

TEST_CASE("level bytes: of a leaf that is another one again the mesh has the triangles no more") {
    const GearBytes gear;
    const Levels& made = gear.made;
    const std::size_t n_nodes = made->nodes().size();
    // Siblings, so that their parent's hull holds either, of as many triangles.
    const auto is_leaf = [&](std::int32_t node) { return made->node(node).n_children == 0; };
    std::int32_t first = -1;
    for (const LevelNode& parent : made->nodes()) {
        for (std::int32_t k = 1; k < parent.n_children && first < 0; ++k) {
            const std::int32_t a = parent.first_child + k - 1;
            if (is_leaf(a) && is_leaf(a + 1) &&
                made->triangles_of(a).size() == made->triangles_of(a + 1).size() &&
                made->node(a).outside_m <= made->node(a + 1).outside_m) {
                first = a;
            }
        }
    }
    REQUIRE(first >= 0);
    const auto other = static_cast<std::size_t>(first) + 1;
    // Its sphere, and its spans.
    Bytes changed = with_mended(gear.bytes, kPayloadAt + kNodesAt + other * kNodeBytes + 36, 1.0);
    for (const std::size_t list : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        const std::size_t at = kPayloadAt + gear.spans_at + 8 * (list * n_nodes + other);
        for (const std::size_t number : {std::size_t{0}, std::size_t{4}}) {
            const auto own = number_at<std::int32_t>(gear.bytes, at - 8 + number);
            changed = with_mended(changed, at + number, own);
        }
    }
    const auto back = decode_contact_levels(changed, gear.key);
    REQUIRE(back);
    CHECK_FALSE(can_be_of(**back, gear.mesh));
}

}  // namespace
}  // namespace fulcrum
