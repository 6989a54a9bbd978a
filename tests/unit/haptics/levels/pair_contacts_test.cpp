// Which way out two flat pieces that cross near a border are told, and when none is theirs.
#include "haptics/geometry/shape.h"
#include "haptics/levels/level_pairs.h"
#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

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

TEST_CASE(
    "pair contacts: where one looks away from the shortest way out, a way is told that both look "
    "along, up to four times as long, and none beyond") {
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
