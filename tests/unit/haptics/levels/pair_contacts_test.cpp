// Which way out two pieces are told, and when no contact is theirs.
#include "haptics/geometry/shape.h"
#include "haptics/levels/level_pairs.h"
#include "haptics/math/rotation.h"
#include "tests/support/gear.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kNear_m = 1.0e-4;
constexpr double kHalf_m = 0.05;
constexpr double kThrough_m = 1.0e-3;

// A square that looks along `along` x `across`, and beside its edge at +`across` a strip that goes down behind it: so a
// surface that goes on round a corner there.
std::shared_ptr<const ContactLevels> make_square(const Vector3& along, const Vector3& across) {
    const auto at = [&](double u, double v, double down) -> Vector3 {
        return kHalf_m * (u * along + v * across - down * along.cross(across));
    };
    const TriangleMesh mesh =
        TriangleMesh::build({at(-1.0, -1.0, 0.0), at(1.0, -1.0, 0.0), at(1.0, 1.0, 0.0),
                             at(-1.0, 1.0, 0.0), at(1.0, 1.0, 0.2), at(-1.0, 1.0, 0.2)},
                            {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}})
            .value();
    return ContactLevels::create(mesh, {.within_m = kNear_m}).value();
}

}  // namespace

TEST_CASE("pair contacts: a way out is told that both look along, up to four times the shortest") {
    // The object lies and looks up, the tool stands on it, leaning back a little, and looks along x; its lower edge is 1 mm through, near the
    // object's border at -x.
    const auto lying = make_square(Vector3::UnitZ(), Vector3::UnitX());
    const auto standing = make_square(-Vector3::UnitZ(), Vector3::UnitY());
    REQUIRE(lying->n_pieces() == 2);
    REQUIRE(standing->n_pieces() == 2);
    const auto pairs = LevelPairs::create(lying, standing).value();
    constexpr double kLean_rad = 0.05;
    const auto is_told_at = [&](double from_border_m) {
        pairs->clear();
        const Vector3 lower_edge(-kHalf_m + from_border_m, -kThrough_m, 0.0);
        const Quaternion turn = compute_exp(Vector3(0.0, 0.0, kLean_rad));
        (void)pairs->find({lower_edge + turn * Vector3(0.0, kHalf_m, 0.0), turn}, kNear_m);
        return std::ranges::any_of(pairs->contacts(), [](const LevelContact& contact) {
            return contact.normal_O.x() < -0.5 && contact.normal_O.y() > 0.5;
        });
    };
    // Between both looks it is some (way to the border + 1 mm) / sqrt 2.
    CHECK(is_told_at(1.5 * kThrough_m));
    CHECK(is_told_at(4.0 * kThrough_m));
    CHECK_FALSE(is_told_at(8.0 * kThrough_m));
    CHECK_FALSE(is_told_at(20.0 * kThrough_m));
}

TEST_CASE(
    "pair contacts: what stands in a hole, apart from its wall, is inside of nothing that reaches "
    "there from the body's outer side") {
    const auto make_levels = [](const TriangleMesh& mesh) {
        return ContactLevels::create(mesh, {.within_m = 1.0e-3}).value();
    };
    // 0.25 to 0.3 mm between them where they are nearest.
    const auto bush = make_levels(make_bush(0.02, 0.0115, 0.03, 35).value());
    const auto peg = make_levels(make_peg(0.01, 0.06, 72).value());
    constexpr double kOff_m = 1.2e-3;
    const double tolerance_m = GENERATE(0.0, 2.0e-4, 8.0e-4);
    const bool is_peg_tool = GENERATE(true, false);
    CAPTURE(tolerance_m, is_peg_tool);
    const auto pairs = LevelPairs::create(is_peg_tool ? bush : peg, is_peg_tool ? peg : bush,
                                          {.tolerance_m = tolerance_m})
                           .value();
    for (int i = 0; i < 50; ++i) {
        const double round = 0.02 * std::numbers::pi * i;
        (void)pairs->find(Pose::at(kOff_m * Vector3(std::cos(round), std::sin(round), 0.0)),
                          1.0e-3);
        bool are_apart = !pairs->contacts().empty();
        for (const LevelContact& contact : pairs->contacts()) {
            are_apart = are_apart && contact.depth_m < contact.error_m;
        }
        INFO("direction " << i);
        CHECK(are_apart);
    }
}
