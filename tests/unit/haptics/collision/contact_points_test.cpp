#include "haptics/collision/contact_points.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <vector>

namespace fulcrum {
namespace {

ContactManifold choose(const std::vector<Vector3>& places) {
    ContactCandidates candidates;
    for (std::size_t i = 0; i < places.size(); ++i) {
        candidates.add({places[i], -1.0e-4, static_cast<std::uint16_t>(i)});
    }
    const ContactPlace here;
    ContactManifold manifold;
    choose_contacts(candidates, Vector3::UnitY(), 0.1, {Vector3::Zero(), here, here}, manifold);
    return manifold;
}

TEST_CASE("contact points: of many on one line two are kept, far apart and each once") {
    std::vector<Vector3> places;
    for (const double x_m : {0.0, 0.02, 0.05, 0.03, 0.04}) {
        places.push_back({x_m, 0.0, 2.0 * x_m});
    }
    const ContactManifold manifold = choose(places);
    REQUIRE(manifold.count == 2);
    CHECK(std::abs(manifold.contacts[0].place_W.x() - manifold.contacts[1].place_W.x()) >= 0.03);
}

TEST_CASE("contact points: of eight round a face four are kept that are not the same") {
    std::vector<Vector3> places;
    for (int i = 0; i < 8; ++i) {
        places.push_back(0.05 * Vector3(std::cos(0.7854 * i), 0.0, std::sin(0.7854 * i)));
    }
    const ContactManifold manifold = choose(places);
    REQUIRE(manifold.count == 4);
    std::set<std::uint16_t> features;
    for (const ContactPoint& point : manifold.points()) {
        features.insert(point.feature);
    }
    CHECK(features.size() == 4);
}

}  // namespace
}  // namespace fulcrum
