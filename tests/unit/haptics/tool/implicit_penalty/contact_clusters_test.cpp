#include "haptics/tool/implicit_penalty/contact_clusters.h"

#include "haptics/tool/implicit_penalty/contact_loop.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1.0e-12;
const ContactClusterSettings kPlain{
    .within_m = 0.001, .radius_m = 0.01, .most = 10, .fade_s = 0.01};

NearContact at(double x, double z, double depth_m = 0.0, const Vector3& normal = Vector3::UnitY()) {
    return {{x, 0.0, z}, normal, depth_m};
}

// A patch of 11 x 11 contacts about a place, two millimetres apart.
void add_patch(double x, double z, std::vector<NearContact>& near, double depth_m = 0.0,
               const Vector3& normal = Vector3::UnitY()) {
    for (int i = -5; i <= 5; ++i) {
        for (int j = -5; j <= 5; ++j) {
            near.push_back(at(x + 0.002 * i, z + 0.002 * j, depth_m, normal));
        }
    }
}

// Each contact lies within the radius of a cluster, a shrinking wider, whose normal is like its own.
bool covers(const ContactClusters& clusters, const NearContact& contact) {
    return std::ranges::any_of(clusters.all(), [&](const ContactCluster& one) {
        return (one.point_T - contact.point_T).norm() < 1.01 * clusters.radius_m() &&
               one.normal_O.dot(contact.normal_O) > 0.5;
    });
}

}  // namespace

TEST_CASE("contact clusters: the mean of its contacts, by their depth; a single one exactly") {
    ContactClusters clusters(kPlain);
    const NearContact contact{{0.01, -0.02, 0.03}, Vector3(0.6, 0.8, 0.0), 0.0004};
    const Pose X_OT{{0.1, 0.2, 0.3}, compute_exp(Vector3(0.3, -0.2, 0.5))};
    clusters.update({&contact, 1}, X_OT, kDt_s);
    REQUIRE(clusters.all().size() == 1);
    const ContactCluster& one = clusters.all().front();
    CHECK((one.point_T - contact.point_T).norm() < kRounding);
    CHECK((one.normal_O - contact.normal_O).norm() < kRounding);
    CHECK(one.depth_m == Approx(contact.depth_m).epsilon(kRounding));
    CHECK((one.place_O - (X_OT * contact.point_T + 0.0004 * contact.normal_O)).norm() < kRounding);
    CHECK(one.strength == 1.0);
    // One deep, two just within: weights 2, 1 and 0.5 of a millimetre.
    const std::vector<NearContact> near{at(0.0, 0.0, 0.001), at(0.004, 0.0, 0.0),
                                        at(0.0, 0.004, -0.0005)};
    clusters = ContactClusters(kPlain);
    clusters.update(near, {}, kDt_s);
    REQUIRE(clusters.all().size() == 1);
    const ContactCluster& mean = clusters.all().front();
    CHECK(mean.point_T.x() == Approx(0.004 / 3.5).epsilon(1e-9));
    CHECK(mean.point_T.z() == Approx(0.5 * 0.004 / 3.5).epsilon(1e-9));
    CHECK(mean.depth_m == Approx((2.0 * 0.001 - 0.5 * 0.0005) / 3.5).epsilon(1e-9));
    // What has only just come near moves nothing.
    std::vector<NearContact> more = near;
    more.push_back(at(0.005, 0.005, -0.001));
    clusters.update(more, {}, kDt_s);
    CHECK(clusters.all().front().point_T.x() == Approx(0.004 / 3.5).epsilon(1e-9));
}

TEST_CASE("contact clusters: contacts that go on keep their cluster, and no number is used twice") {
    ContactClusters clusters(kPlain);
    std::vector<NearContact> near;
    add_patch(0.0, 0.0, near);
    clusters.update(near, {}, kDt_s);
    REQUIRE(clusters.all().size() >= 1);
    const std::uint32_t first = clusters.all().front().id;
    // A decimetre along, half a millimetre at a time.
    for (int i = 1; i <= 200; ++i) {
        near.clear();
        add_patch(0.0005 * i, 0.0, near);
        clusters.update(near, {}, kDt_s);
        REQUIRE(clusters.all().front().id == first);
    }
    CHECK(clusters.all().front().point_T.x() > 0.09);
    // It goes; what comes at the same place later is another.
    for (int i = 0; i < 20; ++i) {
        clusters.update({}, {}, kDt_s);
    }
    CHECK(clusters.all().empty());
    clusters.update(near, {}, kDt_s);
    CHECK(clusters.all().front().id > first);
}

TEST_CASE("contact clusters: the two sides of a sheet are two clusters") {
    std::vector<NearContact> near;
    add_patch(0.0, 0.0, near);
    add_patch(0.0, 0.0, near, 0.0, -Vector3::UnitY());
    ContactClusters clusters(kPlain);
    for (int i = 0; i < 20; ++i) {
        clusters.update(near, {}, kDt_s);
    }
    double up = 0.0;
    double down = 0.0;
    for (const ContactCluster& one : clusters.all()) {
        CHECK(std::abs(one.normal_O.y()) == Approx(1.0).epsilon(kRounding));
        (one.normal_O.y() > 0.0 ? up : down) += one.strength;
    }
    CHECK(up > 0.5);
    CHECK(down > 0.5);
}

TEST_CASE("contact clusters: what ends fades evenly in its time and tells what it was") {
    ContactClusters clusters(kPlain);
    const NearContact contact = at(0.0, 0.0, 0.0005);
    clusters.update({&contact, 1}, {}, kDt_s);
    for (int i = 1; i <= 9; ++i) {
        clusters.update({}, {}, kDt_s);
        REQUIRE(clusters.all().size() == 1);
        CHECK(clusters.all().front().strength == Approx(1.0 - 0.1 * i).epsilon(1e-9));
        CHECK(clusters.all().front().depth_m == Approx(0.0005).epsilon(kRounding));
    }
    clusters.update({}, {}, 2.0 * kDt_s);
    CHECK(clusters.all().empty());
    // Where nothing fades, it is gone at once.
    ContactClusterSettings at_once = kPlain;
    at_once.fade_s = 0.0;
    ContactClusters quick(at_once);
    quick.update({&contact, 1}, {}, kDt_s);
    quick.update({}, {}, kDt_s);
    CHECK(quick.all().empty());
}

TEST_CASE("contact clusters: two that come together become the older one, and may part again") {
    ContactClusters clusters(kPlain);
    const auto look = [&](double apart_m) {
        const std::vector<NearContact> near{at(0.0, 0.0, 0.0005), at(apart_m, 0.0, 0.0005)};
        for (int i = 0; i < 30; ++i) {
            clusters.update(near, {}, kDt_s);
        }
        return clusters.all().size();
    };
    CHECK(look(0.03) == 2);
    const std::uint32_t older = clusters.all().front().id;
    for (double apart_m = 0.03; apart_m > 0.001; apart_m -= 0.0005) {
        static_cast<void>(look(apart_m));
    }
    CHECK(look(0.001) == 1);
    CHECK(clusters.all().front().id == older);
    CHECK(clusters.all().front().strength == 1.0);
    CHECK(look(0.03) == 2);
}

TEST_CASE("contact clusters: whatever there are of them, in the end all contacts are covered") {
    CHECK(rc::check([] {
        ContactClusters clusters(kPlain);
        std::vector<NearContact> near;
        const int n = *rc::gen::inRange(1, 200);
        for (int i = 0; i < n; ++i) {
            const auto number = [] { return 1.0e-3 * *rc::gen::inRange(-1000, 1001); };
            // Up to ten times the radius wide; normals up to 30 degrees off one direction.
            const Vector3 normal(0.4 * number(), 1.0, 0.4 * number());
            near.push_back({0.1 * Vector3(number(), number(), number()), normal.normalized(),
                            1.0e-3 * std::abs(number()) - 0.0009});
        }
        for (int i = 0; i < 300; ++i) {
            clusters.update(near, {}, kDt_s);
            RC_ASSERT(clusters.all().size() <= static_cast<std::size_t>(kPlain.most));
        }
        // Never more than a few at the edge of a radius that shrinks and grows again.
        const auto n_left = std::ranges::count_if(
            near, [&](const NearContact& one) { return !covers(clusters, one); });
        RC_ASSERT(n_left <= 2);
        RC_ASSERT(clusters.radius_m() < 0.3);
    }));
    // And the radius comes back to what was asked for.
    ContactClusters clusters(kPlain);
    std::vector<NearContact> wide;
    for (int i = 0; i < 30; ++i) {
        wide.push_back(at(0.02 * i, 0.0));
    }
    for (int i = 0; i < 200; ++i) {
        clusters.update(wide, {}, kDt_s);
    }
    CHECK(clusters.radius_m() > 1.5 * kPlain.radius_m);
    const NearContact one = at(0.0, 0.0);
    for (int i = 0; i < 1500; ++i) {
        clusters.update({&one, 1}, {}, kDt_s);
    }
    CHECK(clusters.radius_m() == kPlain.radius_m);
}

TEST_CASE("contact clusters: a contact that passes from one to another moves neither by a jump") {
    // Two patches stand, and one contact between them goes from one to the other: the step of the means is that of the contact's, whatever its size.
    const auto largest_step = [](int n_steps) {
        ContactClusters clusters(kPlain);
        std::vector<NearContact> near;
        add_patch(-0.012, 0.0, near, 0.0005);
        add_patch(0.012, 0.0, near, 0.0005);
        near.push_back(at(-0.012, 0.0, 0.002));
        for (int i = 0; i < 200; ++i) {
            clusters.update(near, {}, kDt_s);
        }
        std::vector<ContactCluster> last(clusters.all().begin(), clusters.all().end());
        double largest = 0.0;
        for (int k = 0; k <= n_steps; ++k) {
            near.back().point_T.x() = -0.012 + 0.024 * k / n_steps;
            clusters.update(near, {}, kDt_s);
            REQUIRE(clusters.all().size() == last.size());
            for (std::size_t j = 0; j < last.size(); ++j) {
                largest = std::max(largest, (clusters.all()[j].point_T - last[j].point_T).norm());
            }
            last.assign(clusters.all().begin(), clusters.all().end());
        }
        return largest;
    };
    const double coarse = largest_step(300);
    const double fine = largest_step(3000);
    CAPTURE(coarse, fine);
    CHECK(fine > 0.0);
    CHECK(fine < 0.2 * coarse);
}

TEST_CASE("contact clusters: bad settings are refused; what weighs nothing changes nothing") {
    check_refused(kPlain, {[](auto& s) { s.within_m = 0.0; }, [](auto& s) { s.radius_m = -1.0; },
                           [](auto& s) { s.most = 0; }, [](auto& s) { s.most = kMostClusters + 1; },
                           [](auto& s) { s.fade_s = std::nan(""); }});
    const std::vector<NearContact> bad{at(0.03, 0.0, -kPlain.within_m),
                                       at(0.03, 0.0, -1.0),
                                       at(0.03, 0.0, kNan),
                                       at(0.03, 0.0, kInfinity),
                                       at(kNan, 0.0, 0.001),
                                       at(1.0e300, 0.0, 0.001),
                                       at(0.03, 0.0, 0.001, Vector3::Zero()),
                                       at(0.03, 0.0, 0.001, Vector3(kNan, 1.0, 0.0)),
                                       at(0.03, 0.0, 0.001, 1.0e200 * Vector3::UnitY())};
    // Alone none of them is a cluster, at any place of the list.
    for (const NearContact& one : bad) {
        ContactClusters clusters(kPlain);
        for (int i = 0; i < 30; ++i) {
            clusters.update({&one, 1}, Pose{}, kDt_s);
            REQUIRE(clusters.all().empty());
        }
    }
    // Among others they are as if they were not there, whatever the time says.
    std::vector<NearContact> good;
    add_patch(0.0, 0.0, good, 0.0005);
    ContactClusters without(kPlain);
    ContactClusters with(kPlain);
    for (int i = 0; i < 30; ++i) {
        std::vector<NearContact> mixed(bad);
        mixed.insert(mixed.end(), good.begin(), good.end());
        std::ranges::rotate(mixed, mixed.begin() + i % static_cast<int>(bad.size()));
        const double dt_s = i == 10 ? kNan : i == 20 ? -1.0 : kDt_s;
        without.update(good, Pose{}, i == 10 || i == 20 ? 0.0 : kDt_s);
        with.update(mixed, Pose{}, dt_s);
        REQUIRE(with.all().size() == without.all().size());
        for (std::size_t j = 0; j < with.all().size(); ++j) {
            CHECK((with.all()[j].point_T - without.all()[j].point_T).norm() < 1.0e-9);
            CHECK(with.all()[j].strength == without.all()[j].strength);
            CHECK(with.all()[j].id == without.all()[j].id);
        }
    }
}

TEST_CASE(
    "contact clusters: what has begun to end goes on until it has parted by more than before") {
    ContactClusterSettings slow = kPlain;
    slow.fade_s = 1.0;
    ContactClusters clusters(slow);
    double strength = 1.0;  // of the younger one
    const auto look = [&](double apart_m) {
        const std::vector<NearContact> near{at(0.0, 0.0, 0.0005), at(apart_m, 0.0, 0.0005)};
        clusters.update(near, {}, kDt_s);
        REQUIRE(clusters.all().size() == 2);
        const double before = strength;
        strength = clusters.all()[1].strength;
        return strength - before;
    };
    const auto find_apart = [&] {
        const double apart_m = (clusters.all()[1].point_T - clusters.all()[0].point_T).norm();
        return apart_m * apart_m / (clusters.radius_m() * clusters.radius_m());
    };
    for (int i = 0; i < 50; ++i) {
        (void)look(0.015);
    }
    CHECK(strength == 1.0);
    double apart_m = 0.015;
    while (look(apart_m) >= 0.0) {
        apart_m -= 2.0e-5;
        REQUIRE(apart_m > 0.0);
    }
    CHECK(find_apart() < 0.25);
    CHECK(find_apart() > 0.2);
    while (look(apart_m) < 0.0) {
        apart_m += 2.0e-5;
        REQUIRE(apart_m < 0.02);
    }
    CHECK(find_apart() >= 0.36);
    CHECK(find_apart() < 0.42);
}

TEST_CASE("contact clusters: where all are in use nothing joins one that looks the other way") {
    ContactClusterSettings one = kPlain;
    one.most = 1;
    ContactClusters clusters(one);
    const std::vector<NearContact> near{at(0.0, 0.0, 0.001),
                                        at(0.002, 0.0, 0.0008, -Vector3::UnitY())};
    for (int i = 0; i < 20; ++i) {
        clusters.update(near, {}, kDt_s);
        REQUIRE(clusters.all().size() == 1);
        CHECK(clusters.all().front().point_T.norm() < kRounding);
        CHECK(clusters.all().front().depth_m == Approx(0.001).epsilon(kRounding));
        CHECK((clusters.all().front().normal_O - Vector3::UnitY()).norm() < kRounding);
    }
}
