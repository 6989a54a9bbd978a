#include "haptics/tool/god_object/god_pair.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/god_scene.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kTouch_m = 2.5e-7;

GodPair make_pair(const TriangleMesh& object, const TriangleMesh& tool, int most = 512) {
    return {GodSurface::create(object), GodSurface::create(tool), most};
}

// Two bumpy balls.
GodPair make_bumpy_pair() {
    static const TriangleMesh kObject = make_bumpy_sphere(0.05, 6, 0.15, 90.0).value();
    static const TriangleMesh kTool = make_bumpy_sphere(0.03, 5, 0.2, 120.0).value();
    return make_pair(kObject, kTool);
}

TEST_CASE("god pair: a cube on a plate is held at its corners, over its border along both") {
    GodPair pair = make_pair(make_plate(0.2, 0.2, 10).value(), test::make_cube(0.02));
    constexpr double kGap_m = 1.0e-6;
    pair.collect(Pose::at({0.003, 0.01 + kGap_m, 0.001}), 4.0 * kGap_m);
    REQUIRE(pair.contacts().size() == 4);
    CHECK_FALSE(pair.is_full());
    CHECK(pair.least_gap_m() == Approx(kGap_m).epsilon(1.0e-9));
    for (const GodContact& contact : pair.contacts()) {
        CHECK((contact.normal_O - Vector3::UnitY()).norm() < 1.0e-9);
        CHECK(contact.gap_m == Approx(kGap_m).epsilon(1.0e-9));
        CHECK(std::abs(std::abs(contact.on_tool_O.x() - 0.003) - 0.01) < 1.0e-12);
        CHECK(contact.rise_m == 0.0);
    }
    // Beyond, nothing.
    pair.collect(Pose::at({0.003, 0.01 + 5.0 * kGap_m, 0.001}), 4.0 * kGap_m);
    CHECK(pair.contacts().empty());
    CHECK(pair.least_gap_m() == kInfinity);
    pair = make_pair(make_plate(0.2, 0.2, 10).value(), test::make_cube(0.02));
    // An edge of the cube along z, aside of the plate's border along z and above it.
    const Vector3 off(1.0e-6, 2.0e-6, 0.0);
    pair.collect(Pose::at(Vector3(0.1 + 0.01, 0.01, 0.0) + off), 4.0e-6);
    REQUIRE_FALSE(pair.contacts().empty());
    for (const GodContact& contact : pair.contacts()) {
        CHECK((contact.normal_O - off.normalized()).norm() < 1.0e-8);
    }
}

// What all features of all triangles say, each pair of them.
std::vector<GodContact> find_all(const GodPair& pair, const Pose& X_OT, double within_m) {
    std::vector<GodContact> all;
    const GodSurface& object = pair.object();
    const GodSurface& tool = pair.tool();
    const GodPlace place = GodPlace::of(object.swept(), tool.swept(), X_OT);
    const auto offer = [&](FeaturePair kind, std::int32_t i, std::int32_t j, std::uint8_t a,
                           std::uint8_t b) {
        const NearFeatures found = find_nearest_of(kind, a, b, object.swept().triangle(i),
                                                   place.corners(tool.swept().triangle(j)));
        if (!(found.distance_m > 0.0 && found.distance_m <= within_m)) {
            return;
        }
        const Vector3 normal_O = (found.on_moving - found.on_fixed) / found.distance_m;
        const Pose X_TO = X_OT.inverse();
        const double epsilon = std::max(1.0e-8, 1.0e-15 / found.distance_m);
        const double rise_m = std::max(
            object.find_rise_m(i, found.on_fixed, normal_O, epsilon),
            tool.find_rise_m(j, X_TO * found.on_moving, -(X_TO.orientation * normal_O), epsilon));
        const bool is_known = std::ranges::any_of(all, [&](const GodContact& each) {
            return (each.on_tool_O - found.on_moving).norm() < 2.0e-9 &&
                   (each.normal_O - normal_O).norm() < 2.0e-7;
        });
        if (rise_m <= within_m && !is_known) {
            all.push_back({found.on_fixed, found.on_moving, normal_O, found.distance_m, rise_m});
        }
    };
    for (std::int32_t i = 0; i < object.swept().n_triangles(); ++i) {
        for (std::int32_t j = 0; j < tool.swept().n_triangles(); ++j) {
            const auto distance_m = find_nearest_features(object.swept().triangle(i),
                                                          place.corners(tool.swept().triangle(j)))
                                        .distance_m;
            if (distance_m > within_m) {
                continue;
            }
            for (std::uint8_t a = 0; a < 3; ++a) {
                if (tool.carries_corner(j, a)) {
                    offer(FeaturePair::face_vertex, i, j, 0, a);
                }
                if (object.carries_corner(i, a)) {
                    offer(FeaturePair::vertex_face, i, j, a, 0);
                }
                for (std::uint8_t b = 0; b < 3; ++b) {
                    if (object.carries_edge(i, a) && tool.carries_edge(j, b)) {
                        offer(FeaturePair::edge_edge, i, j, a, b);
                    }
                }
            }
        }
    }
    return all;
}

TEST_CASE("god pair: its contacts are those of all features of all triangles, each once") {
    const bool is_flat = GENERATE(false, true);
    const TriangleMesh object = is_flat ? make_plate(0.06, 0.06, 6).value()
                                        : make_bumpy_sphere(0.05, 5, 0.15, 90.0).value();
    const TriangleMesh tool = is_flat ? make_cylinder(0.01, 0.02, 24).value()
                                      : make_bumpy_sphere(0.03, 4, 0.2, 120.0).value();
    GodPair pair = make_pair(object, tool, 4096);
    Random random(9);
    std::size_t n_found = 0;
    Pose at = is_flat ? Pose::at({0.003, 0.010002, 0.001}) : Pose::at({0.0, 0.083, 0.0});
    for (int k = 0; k < 40; ++k) {
        const double within_m = is_flat ? 4.0e-6 : 2.0e-4 * (1 + k % 40);
        if (is_flat) {
            at.position += 5.0e-4 * Vector3(random.in_cube().x(), 0.0, random.in_cube().z());
            at.orientation = compute_exp(Vector3(0.0, 0.02 * k, 0.0));
        } else {
            at.position += 2.0e-4 * random.in_cube();
            at.orientation = compute_exp(0.02 * random.in_cube()) * at.orientation;
        }
        // The same place again and again, and then another: what was looked at in vain is found all the same.
        for (int again = 0; again <= k % 3; ++again) {
            pair.collect(at, within_m);
        }
        const std::vector<GodContact> all = find_all(pair, at, within_m);
        n_found += all.size();
        CAPTURE(k, within_m, is_flat);
        REQUIRE(pair.contacts().size() == all.size());
        for (const GodContact& contact : all) {
            REQUIRE(std::ranges::any_of(pair.contacts(), [&](const GodContact& each) {
                return (each.on_tool_O - contact.on_tool_O).norm() < 2.0e-9 &&
                       (each.normal_O - contact.normal_O).norm() < 2.0e-7 &&
                       std::abs(each.gap_m - contact.gap_m) < 1.0e-12;
            }));
        }
    }
    CHECK(n_found > 40);
}

TEST_CASE(
    "god pair: with its front it finds what the whole meshes' sweep finds, whatever was asked "
    "before") {
    GodPair pair = make_bumpy_pair();
    const auto sweep = [&](const Pose& from, const Pose& to, double tolerance_m) {
        return sweep_meshes(pair.object().swept(), pair.tool().swept(), InBetweenMotion(from, to),
                            {kTouch_m, tolerance_m});
    };
    Random random(5);
    Pose at = Pose::at({0.0, 0.12, 0.0});
    int n_touching = 0;
    int n_otherwise = 0;
    int n_cut = 0;
    for (int i = 0; i < 400; ++i) {
        const double speed = i % 40 == 0 ? 0.03 : 0.0008;
        const Pose to{at.position + speed * random.in_cube() - 0.01 * speed * 100.0 * at.position,
                      (compute_exp(10.0 * speed * random.in_cube()) * at.orientation).normalized()};
        const MeshSweep whole = sweep(at, to, kTouch_m);
        const double free = pair.find_free_share(at, to, kTouch_m);
        CAPTURE(i, whole.contact.time);
        // What lies within the tolerance one may tell as a touch and the other as free: it goes no farther than a sweep of a thousandth of
        // that tolerance allows.
        const double told = whole.outcome == SweepOutcome::free ? 1.0 : whole.contact.time;
        if (pair.is_cut()) {
            REQUIRE(told >= free);
            REQUIRE(free > 0.0);
            ++n_cut;
        } else if (std::abs(free - told) > 1.0e-9) {
            const MeshSweep strict = sweep(at, to, 1.0e-3 * kTouch_m);
            REQUIRE(free > told);
            REQUIRE((strict.outcome == SweepOutcome::free ? 1.0 : strict.contact.time) >= free);
            ++n_otherwise;
        }
        n_touching += free < 1.0 ? 1 : 0;
        // On to shortly before, so that the next way begins apart.
        const InBetweenMotion motion(at, to);
        at = free == 1.0 ? to : motion.pose(0.99 * free);
        // Contacts are those of a front made there.
        pair.collect(at, 1.0e-4);
        GodPair fresh = make_bumpy_pair();
        fresh.collect(at, 1.0e-4);
        REQUIRE(pair.contacts().size() == fresh.contacts().size());
        REQUIRE(pair.is_apart(at, 1.0e-12));
    }
    CHECK(n_touching > 30);
    CHECK(n_otherwise < 40);
    CHECK(n_cut > 0);
    CHECK(n_cut < 200);
}

TEST_CASE(
    "god pair: more contacts than there is room for are told, poses that are none are not gone") {
    GodPair pair = make_pair(make_plate(0.2, 0.2, 40).value(), make_plate(0.1, 0.1, 40).value(), 8);
    pair.collect(Pose::at({0.0001, 1.0e-6, 0.0001}), 4.0e-6);
    CHECK(pair.is_full());
    CHECK(pair.contacts().size() <= 8);
    CHECK(pair.find_free_share(Pose{}, Pose::at({kNan, 0.0, 0.0}), kTouch_m) == 0.0);
    CHECK_FALSE(pair.is_apart(Pose::at({0.0, 0.0, kNan}), kTouch_m));
    // Crossing: nothing may be gone.
    CHECK(pair.find_free_share({Vector3::Zero(), compute_exp(Vector3(1.0, 0.0, 0.0))},
                               {Vector3(0.01, 0.0, 0.0), compute_exp(Vector3(1.0, 0.0, 0.0))},
                               kTouch_m) == 0.0);
    CHECK(pair.memory_bytes() > 0);
}

TEST_CASE("god pair: whether something is within a distance is told as brute force tells it") {
    const TriangleMesh object = make_bumpy_sphere(0.03, 4, 0.2, 120.0).value();
    const TriangleMesh tool = make_box({0.02, 0.015, 0.01}).value();
    GodPair pair = make_pair(object, tool);
    Random random(31);
    Pose at = Pose::at({0.0, 0.05, 0.0});
    int n_within = 0;
    int n_apart = 0;
    for (int i = 0; i < 1500; ++i) {
        const Pose before = at;
        at.position += 0.0015 * random.in_cube() - 0.01 * (at.position - Vector3(0.0, 0.04, 0.0));
        at.orientation = (compute_exp(0.05 * random.in_cube()) * at.orientation).normalized();
        const double distance_m = test::find_distance_m(object, {}, tool, at);
        // Never where they cross: there the tool is not.
        if (!(distance_m > 0.0) || test::do_cross(object, {}, tool, at)) {
            at = before;
            continue;
        }
        for (const double share : {0.5, 0.999, 1.001, 3.0}) {
            CAPTURE(i, distance_m, share);
            REQUIRE(pair.has_within(at, share * distance_m) == (share > 1.0));
        }
        n_within += pair.has_within(at, 1.0e-3) ? 1 : 0;
        n_apart += pair.has_within(at, 1.0e-3) ? 0 : 1;
    }
    CHECK(n_within > 100);
    CHECK(n_apart > 100);
    CHECK(pair.has_within(Pose::at({kNan, 0.0, 0.0}), 1.0e-3));
}

TEST_CASE("god pair: put elsewhere it goes as one that is new, to the bit") {
    GodPair pair = make_bumpy_pair();
    Random random(11);
    Pose at = Pose::at({0.0, 0.1, 0.0});
    int n_cut = 0;
    for (int i = 0; i < 120; ++i) {
        const Pose to{at.position + 0.02 * random.in_cube() - 0.05 * at.position,
                      (compute_exp(0.2 * random.in_cube()) * at.orientation).normalized()};
        GodPair fresh = make_bumpy_pair();
        pair.forget();
        const double free = pair.find_free_share(at, to, kTouch_m);
        CAPTURE(i);
        REQUIRE(free == fresh.find_free_share(at, to, kTouch_m));
        REQUIRE(pair.is_cut() == fresh.is_cut());
        n_cut += pair.is_cut() ? 1 : 0;
        pair.collect(at, 1.0e-4);
        // Short ways, of which what is usual is learnt.
        const Pose near_by{at.position + 1.0e-4 * random.in_cube(), at.orientation};
        (void)pair.find_free_share(at, near_by, kTouch_m);
        at = free == 1.0 ? to : InBetweenMotion(at, to).pose(0.9 * free);
    }
    CHECK(n_cut > 3);
}

}  // namespace
}  // namespace fulcrum
