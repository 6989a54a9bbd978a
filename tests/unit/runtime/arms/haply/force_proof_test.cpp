#include "runtime/arms/haply/force_proof.h"

#include "runtime/arms/haply/rest_finder.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::runtime {
namespace {

using Verdict = ForceProof::Verdict;

constexpr double kRound_s = 0.001;

// A service that understands one word, or none, and echoes what it took a round ago.
struct Told {
    explicit Told(ForceWord first) : proof(first, 3.0) {}
    // `n` rounds with that force; the most that was sent.
    double push(const Vector3& wanted_N, int n, std::optional<ForceWord> understood) {
        double most_N = 0.0;
        for (int i = 0; i < n; ++i) {
            const Vector3 sent = proof.allow(wanted_N, now_s);
            most_N = std::max(most_N, sent.norm());
            const bool is_heard = proof.word() == understood;
            proof.note_sent(sent, now_s);
            // The hand moves a little each time.
            position.x() += 1.0e-6;
            proof.note_state(position, Vector3::Zero(), echo, now_s);
            echo = is_heard ? gain * sent : Vector3::Zero();
            now_s += kRound_s;
        }
        return most_N;
    }
    ForceProof proof;
    double now_s = 100.0;
    double gain = 1.0;
    Vector3 position{Vector3::Zero()};
    Vector3 echo{Vector3::Zero()};
};

}  // namespace

TEST_CASE(
    "force proof: until the echo comes no more than the trial force goes; then more, slowly") {
    Told told(ForceWord::vector);
    CHECK(told.push({0.0, 5.0, 0.0}, 1, ForceWord::vector) == Approx(0.2));
    CHECK(told.proof.verdict() == Verdict::open);
    (void)told.push({0.0, 5.0, 0.0}, 2, ForceWord::vector);
    REQUIRE(told.proof.verdict() == Verdict::proven);
    // 12 N/s: the hand is not thrown.
    CHECK(told.push({0.0, 5.0, 0.0}, 100, ForceWord::vector) < 0.2 + 12.0 * 0.102);
    CHECK(told.push({0.0, 5.0, 0.0}, 400, ForceWord::vector) == Approx(3.0));
    CHECK(told.proof.allow({3.0, 4.0, 0.0}, told.now_s).isApprox(Vector3(1.8, 2.4, 0.0)));
    CHECK(told.proof.allow({0.1, 0.0, 0.0}, told.now_s) == Vector3(0.1, 0.0, 0.0));
}

TEST_CASE("force proof: the other word is tried once; then nothing is pushed") {
    Told told(ForceWord::vector);
    (void)told.push({1.0, 0.0, 0.0}, ForceProof::kMostStates + 50, ForceWord::values);
    CHECK(told.proof.word() == ForceWord::values);
    CHECK(told.proof.verdict() == Verdict::proven);

    Told deaf(ForceWord::values);
    CHECK(deaf.push({1.0, 0.0, 0.0}, 2 * ForceProof::kMostStates - 1, std::nullopt) == Approx(0.2));
    CHECK(deaf.proof.verdict() == Verdict::open);
    (void)deaf.push({1.0, 0.0, 0.0}, 20, std::nullopt);
    CHECK(deaf.proof.verdict() == Verdict::refused);
    CHECK(deaf.push({1.0, 0.0, 0.0}, 20, ForceWord::vector) == 0.0);
}

TEST_CASE("force proof: who asks for little proves nothing, and is refused nothing") {
    Told told(ForceWord::vector);
    CHECK(told.push({0.1, 0.0, 0.0}, 5000, ForceWord::vector) == Approx(0.1));
    CHECK(told.proof.verdict() == Verdict::open);
    CHECK(told.proof.word() == ForceWord::vector);
}

TEST_CASE("force proof: an echo of another direction or size is none") {
    const auto verdict_at = [](double gain) {
        Told told(ForceWord::vector);
        told.gain = gain;
        (void)told.push({1.0, 0.0, 0.0}, 20, ForceWord::vector);
        return told.proof.verdict();
    };
    CHECK(verdict_at(0.6) == Verdict::proven);
    CHECK(verdict_at(1.2) == Verdict::proven);
    CHECK(verdict_at(1.9) == Verdict::open);
    CHECK(verdict_at(0.4) == Verdict::open);
    CHECK(verdict_at(2.2) == Verdict::open);
    CHECK(verdict_at(-1.0) == Verdict::open);
}

TEST_CASE("force proof: that more is given than was asked for is found, at any time after") {
    Told told(ForceWord::vector);
    (void)told.push({1.0, 0.0, 0.0}, 500, ForceWord::vector);
    REQUIRE(told.proof.verdict() == Verdict::proven);
    CHECK_FALSE(told.proof.is_pushed_more());
    told.gain = 1.8;
    (void)told.push({1.0, 0.0, 0.0}, ForceProof::kMostMore - 1, ForceWord::vector);
    CHECK_FALSE(told.proof.is_pushed_more());
    (void)told.push({1.0, 0.0, 0.0}, 10, ForceWord::vector);
    CHECK(told.proof.is_pushed_more());
    told.gain = 1.0;
    (void)told.push({1.0, 0.0, 0.0}, 10, ForceWord::vector);
    CHECK_FALSE(told.proof.is_pushed_more());
}

TEST_CASE("force proof: what is no number is no force") {
    Told told(ForceWord::vector);
    (void)told.push({1.0, 0.0, 0.0}, 500, ForceWord::vector);
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(told.proof.allow({none, 0.0, 0.0}, told.now_s) == Vector3::Zero());
}

TEST_CASE("force proof: states that repeat while the force changes are found, and forgiven") {
    ForceProof proof(ForceWord::vector, 3.0);
    const auto step = [&](const Vector3& sent, double x, double now_s) {
        proof.note_sent(sent, now_s);
        proof.note_state({x, 0.0, 0.0}, Vector3::Zero(), Vector3::Zero(), now_s);
        return proof.is_stuck();
    };
    // A hand at rest under a force that stays: the encoder may well say the same.
    for (int i = 0; i < 2000; ++i) {
        CHECK_FALSE(step({0.1, 0.0, 0.0}, 0.01, 1e-3 * i));
    }
    // 0.6 N more, and still the same: within 30 ms that may be friction, later it is not.
    CHECK_FALSE(step({0.7, 0.0, 0.0}, 0.01, 2.0));
    CHECK_FALSE(step({0.7, 0.0, 0.0}, 0.01, 2.029));
    CHECK(step({0.7, 0.0, 0.0}, 0.01, 2.031));
    CHECK(step(Vector3::Zero(), 0.01, 5.0));
    CHECK_FALSE(step(Vector3::Zero(), 0.010001, 5.001));
    CHECK_FALSE(step(Vector3::Zero(), 0.010001, 9.0));
}

TEST_CASE("rest finder: the middle is where the handle was still for long enough") {
    RestFinder finder;
    double now_s = 10.0;
    // Somebody carries it there: never still.
    for (int i = 0; i < 200; ++i, now_s += 0.01) {
        CHECK_FALSE(finder.step({0.0005 * i, 0.0, 0.0}, now_s));
    }
    // A trembling hand at rest, about 0.2.
    std::optional<Vector3> middle;
    const double begun_s = now_s;
    for (int i = 0; i < 100 && !middle; ++i, now_s += 0.01) {
        middle = finder.step({0.2 + (i % 2 == 0 ? 0.001 : -0.001), 0.1, 0.0}, now_s);
    }
    REQUIRE(middle);
    CHECK(now_s - begun_s >= RestFinder::kRest_s);
    CHECK((*middle - Vector3(0.2, 0.1, 0.0)).norm() < 1e-4);
}

}  // namespace fulcrum::runtime
