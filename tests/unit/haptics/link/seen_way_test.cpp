#include "haptics/link/seen_way.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

constexpr double kRound_s = 0.001;

Vector3 along(double x) {
    return {x, 0.0, 0.0};
}

}  // namespace

TEST_CASE("seen way: a steady way has its velocity, from the first round and in uneven rounds") {
    SeenWay way;
    CHECK(way.velocity().isZero(0.0));
    for (const double dt_s : {0.001, 0.001, 0.004, 0.0005, 0.002}) {
        way.step(along(0.1 * dt_s), dt_s);
        CHECK(way.velocity().x() == Approx(0.1).epsilon(1e-12));
    }
}

TEST_CASE("seen way: between an encoder's steps it goes on, with the true velocity on average") {
    SeenWay way;
    double sum = 0.0;
    int n = 0;
    double gone_m = 0.0;
    double shown_m = 0.0;
    for (int i = 0; i < 2000; ++i) {
        gone_m += 0.02 * kRound_s;
        const double step_m = 5.5e-5 * std::floor((gone_m - shown_m) / 5.5e-5);
        shown_m += step_m;
        way.step(along(step_m), kRound_s);
        if (i >= 100) {
            CHECK(way.velocity().x() > 0.0);
            sum += way.velocity().x();
            ++n;
        }
    }
    CHECK(sum / n == Approx(0.02).epsilon(0.02));
}

TEST_CASE("seen way: joints that step one after the other show one way") {
    SeenWay way;
    // Along x + y, one axis at a time.
    for (int i = 0; i < 100; ++i) {
        way.step(i % 2 == 0 ? Vector3(1e-4, 0.0, 0.0) : Vector3(0.0, 1e-4, 0.0), kRound_s);
    }
    const Vector3 direction = way.velocity().normalized();
    CHECK(direction.x() > 0.5);
    CHECK(direction.y() > 0.5);
}

TEST_CASE("seen way: it turns round within three rounds, rests after 50 ms, takes no nonsense") {
    SeenWay way;
    for (int i = 0; i < 100; ++i) {
        way.step(along(1e-4), kRound_s);
    }
    for (int i = 0; i < 3; ++i) {
        way.step(along(-1e-4), kRound_s);
    }
    CHECK(way.velocity().x() < 0.0);
    for (int i = 0; i < 51; ++i) {
        CHECK((i >= 49 || way.velocity().x() < 0.0));
        way.step(along(0.0), kRound_s);
    }
    CHECK(way.velocity().isZero(0.0));
    way.step(along(1e-4), kRound_s);
    const Vector3 before = way.velocity();
    way.step(along(kNan), kRound_s);
    way.step(along(1.0), 0.0);
    way.step(along(1.0), kNan);
    CHECK(way.velocity() == before);
    way.reset();
    CHECK(way.velocity().isZero(0.0));
}
