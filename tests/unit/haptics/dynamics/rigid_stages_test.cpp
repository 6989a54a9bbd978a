#include "haptics/dynamics/contacts_ahead.h"
#include "haptics/dynamics/island_stepper.h"
#include "haptics/dynamics/island_turns.h"
#include "haptics/dynamics/near_bodies.h"
#include "haptics/dynamics/scene_islands.h"
#include "haptics/dynamics/way_bounds.h"

#include <catch2/catch.hpp>

#include <span>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

// What a step of the world of rigid bodies is made of, each stage alone.
constexpr double kRadius_m = 0.05;
constexpr double kNear_m = 4.0e-3 * kRadius_m;  // of two such balls: 2e-3 of their sizes together
constexpr double kStep_s = 1.0e-3;

RigidWorldBody make_ball(double x_m, double speed_m_per_s = 0.0) {
    RigidWorldBody body{.shape = make_contact_shape(SphereShape{kRadius_m}).value(),
                        .inertia = {1.0, Vector3::Constant(1.0e-3)},
                        .moves = true,
                        .lever_m = kRadius_m};
    body.state.pose_W.position.x() = x_m;
    body.state.velocity_W.linear.x() = speed_m_per_s;
    return body;
}
RigidWorldBody make_post(double x_m) {
    RigidWorldBody body = make_ball(x_m);
    body.moves = false;
    return body;
}

RigidWorldSettings make_weightless() {
    RigidWorldSettings settings;
    settings.gravity_W.setZero();
    settings.most_pairs = 8;
    return settings;
}

// Balls along x, without weight, and all stages of their step.
struct Stages {
    explicit Stages(std::vector<RigidWorldBody> bodies, std::vector<Joint> joints = {},
                    const RigidWorldSettings& settings = make_weightless())
        : scene{std::move(bodies), ContactPairs(settings.most_pairs), std::move(joints),
                BodyLoads(4)},
          near(settings, scene),
          ahead(settings, scene),
          islands(n_bodies(), settings.most_pairs, static_cast<int>(scene.joints.size())),
          turns(settings, n_bodies()),
          stepper(settings, {.bodies = n_bodies(), .contacts = 32, .rows = 6}, ahead),
          bounds(n_bodies()) {}

    [[nodiscard]] int n_bodies() const { return static_cast<int>(scene.bodies.size()); }
    // As far as what touches.
    void look(double reach_s = 2.0 * kStep_s) {
        near.place(reach_s, scene);
        near.find(scene);
        ahead.find(reach_s, scene);
    }
    // As far as whose turn it is.
    void part(double dt_s = kStep_s) {
        look(2.0 * dt_s);
        islands.find(near.moves(), scene);
        turns.find(dt_s, islands, scene);
    }
    // As what is due does when it has moved.
    void forget_loads() {
        for (RigidWorldBody& body : scene.bodies) {
            body.forget_loads();
        }
    }
    [[nodiscard]] std::vector<BodyPair> list_pairs() const {
        std::vector<BodyPair> pairs(static_cast<std::size_t>(scene.pairs.count()));
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            pairs[i] = scene.pairs.at(static_cast<int>(i)).bodies;
        }
        return pairs;
    }

    RigidScene scene;
    NearBodies near;
    ContactsAhead ahead;
    SceneIslands islands;
    IslandTurns turns;
    IslandStepper stepper;
    WayBounds bounds;
};

using Pairs = std::vector<BodyPair>;

Joint join(int a, int b, bool bodies_touch, const std::vector<RigidWorldBody>& bodies) {
    const auto pose_of = [&](int i) { return bodies[static_cast<std::size_t>(i)].state.pose_W; };
    return make_joint({.body_a = a, .body_b = b, .bodies_touch = bodies_touch}, pose_of(a),
                      pose_of(b));
}

TEST_CASE("near bodies: those are that come together in the time, with or without a joint") {
    // 1 m lies between the middles, 0.9 m between the balls; both come 0.45 m in 10 ms at 45 m/s.
    for (const double speed_m_per_s : {44.0, 46.0}) {
        const std::vector<RigidWorldBody> bodies{make_ball(0.0, speed_m_per_s),
                                                 make_ball(1.0, -speed_m_per_s)};
        Stages free(bodies);
        free.look(1.0e-2);
        CHECK(free.list_pairs() == (speed_m_per_s > 45.0 ? Pairs{{0, 1}} : Pairs{}));
        Stages joined(bodies, {join(0, 1, false, bodies)});
        joined.look(1.0e-2);
        CHECK(joined.list_pairs().empty());
        Stages touching(bodies, {join(0, 1, true, bodies)});
        touching.look(1.0e-2);
        CHECK(touching.list_pairs() == free.list_pairs());
    }
}

TEST_CASE("near bodies: what is out of the world is near nothing, until it is back") {
    Stages stages({make_ball(0.0), make_ball(2.0 * kRadius_m), make_post(4.0 * kRadius_m)});
    stages.look();
    CHECK(stages.list_pairs() == Pairs{{0, 1}, {1, 2}});
    CHECK(std::vector<int>(stages.near.moves().begin(), stages.near.moves().end()) ==
          std::vector<int>{1, 1, 0});
    for (const bool is_present : {false, true}) {
        stages.scene.body(1).is_present = is_present;
        stages.scene.body(1).touch();
        stages.look();
        CHECK(stages.list_pairs() == (is_present ? Pairs{{0, 1}, {1, 2}} : Pairs{}));
        CHECK(stages.near.moves()[1] == (is_present ? 1 : 0));
    }
}

TEST_CASE("near bodies: pairs without room are counted, of the last step alone") {
    RigidWorldSettings settings = make_weightless();
    settings.most_pairs = 1;
    Stages stages({make_ball(0.0), make_ball(0.02), make_ball(0.04)}, {}, settings);
    for (int i = 0; i < 2; ++i) {
        stages.look();
        CHECK(stages.list_pairs().size() == 1);
        CHECK(stages.near.n_dropped() == 2);
    }
}

TEST_CASE("near bodies: far ways come together with what was not known") {
    const std::vector<RigidWorldBody> bodies{make_ball(0.0), make_ball(2.0 * kRadius_m),
                                             make_ball(1.0), make_ball(2.0)};
    Stages stages(bodies, {join(0, 3, false, bodies)});
    stages.look();
    CHECK(stages.list_pairs() == Pairs{{0, 1}});
    const auto list_far = [&](double way_m) {
        std::vector<Twist> ways_W(4);
        ways_W[0].linear.x() = way_m;
        Pairs far;
        stages.near.find_far(ways_W, stages.scene,
                             [&](const BodyPair& pair) { far.push_back(pair); });
        return far;
    };
    // Nearer than 0.9 m it meets nothing but what it touches already; at 1.9 m what it is joined to.
    CHECK(list_far(0.89).empty());
    CHECK(list_far(2.0) == Pairs{{0, 2}});
}

TEST_CASE("contacts ahead: where ways meet there are contacts of then; what passes has none") {
    // 0.1 m between them at 100 m/s: a millisecond.
    Stages stages({make_ball(0.0, 100.0), make_post(0.2)});
    stages.look();
    REQUIRE(stages.scene.pairs.count() == 1);
    const ContactPair& pair = stages.scene.pairs.at(0);
    CHECK(pair.meet_s == Approx(1.0e-3).margin(kNear_m / 100.0));
    REQUIRE(pair.manifold.count == 1);
    CHECK(pair.manifold.points()[0].gap_m == Approx(0.1).margin(1.0e-12));
    CHECK_FALSE(pair.passes);
    CHECK_FALSE(ContactsAhead::is_apart(0, stages.scene));

    stages.scene.body(0).state.pose_W.position.y() = 2.0 * kRadius_m + 10.0 * kNear_m;
    stages.look();
    REQUIRE(stages.scene.pairs.count() == 1);
    CHECK(pair.passes);
    CHECK(ContactsAhead::is_apart(0, stages.scene));
}

TEST_CASE("contacts ahead: of what bounces only what is met first does") {
    for (const double restitution : {0.5, 0.0}) {
        // Both come to the middle one: at 100 m/s the nearer, at 50 the other.
        std::vector<RigidWorldBody> bodies{make_ball(0.0, 100.0), make_ball(0.15),
                                           make_ball(0.3, -50.0)};
        bodies[1].restitution = restitution;
        Stages stages(bodies);
        stages.part(2.0e-3);
        const auto is_first = [&](const BodyPair& asked) {
            for (int i = 0; i < stages.scene.pairs.count(); ++i) {
                if (stages.scene.pairs.at(i).bodies == asked) {
                    return stages.scene.pairs.at(i).is_first;
                }
            }
            return false;
        };
        CHECK(is_first({0, 1}));
        CHECK(is_first({1, 2}) == (restitution == 0.0));
        // Within the step the first turns back: then it is the other that is met.
        stages.scene.body(0).ahead_W.linear.x() = -100.0;
        stages.ahead.find_of(stages.islands.parts_of(0), 4.0e-3, stages.scene);
        CHECK(is_first({1, 2}));
    }
}

TEST_CASE("contacts ahead: what a command moved wakes what it touches, once") {
    Stages stages({make_post(0.0), make_ball(2.0 * kRadius_m), make_ball(1.0)});
    stages.look();
    stages.scene.body(0).touched = true;
    stages.scene.body(1).asleep = stages.scene.body(2).asleep = true;
    stages.look();
    CHECK_FALSE(stages.scene.body(1).asleep);
    CHECK(stages.scene.body(2).asleep);
    CHECK_FALSE(stages.scene.body(0).touched);
}

TEST_CASE("scene islands: by touches and joints of what is there, and with ways that pass") {
    // 0 and 1 touch; 2 and 3 are joined; 4 flies by the post 5.
    std::vector<RigidWorldBody> bodies{make_ball(0.0), make_ball(2.0 * kRadius_m), make_ball(1.0),
                                       make_ball(1.5), make_ball(2.9, 100.0),      make_post(3.1)};
    bodies[4].state.pose_W.position.y() = 2.0 * kRadius_m + 10.0 * kNear_m;
    Stages stages(bodies, {join(2, 3, false, bodies)});
    stages.part();
    REQUIRE(stages.islands.count() == 3);
    const auto list = [](std::span<const std::int32_t> all) {
        return std::vector<std::int32_t>(all.begin(), all.end());
    };
    using List = std::vector<std::int32_t>;
    CHECK(list(stages.islands.parts_of(0).bodies) == List{0, 1});
    CHECK(list(stages.islands.parts_of(0).pairs) == List{0});
    CHECK(list(stages.islands.parts_of(1).bodies) == List{2, 3});
    CHECK(list(stages.islands.parts_of(1).joints) == List{0});
    CHECK(list(stages.islands.parts_of(2).bodies) == List{4});
    REQUIRE(stages.scene.pairs.at(1).passes);
    CHECK(list(stages.islands.parts_of(2).pairs) == List{1});
    CHECK(stages.islands.island_of(3) == 1);
    CHECK(stages.islands.island_of(5) == -1);

    stages.scene.body(3).is_present = false;
    stages.scene.body(3).touch();
    stages.part();
    CHECK(list(stages.islands.parts_of(1).bodies) == List{2});
    CHECK(stages.islands.parts_of(1).joints.empty());
}

TEST_CASE("island turns: a touched island goes at once, others when their time has come together") {
    RigidWorldSettings settings = make_weightless();
    settings.slow_period_s = 3.0 * kStep_s;
    Stages stages({make_ball(0.0), make_ball(1.0)}, {}, settings);
    for (int i = 1; i <= 3; ++i) {
        stages.scene.body(1).touch();
        stages.part();
        const auto due = stages.turns.due();
        REQUIRE(due.size() == (i < 3 ? 1U : 2U));
        CHECK(due.back().island == 1);
        CHECK(due.back().dt_s == kStep_s);
        stages.turns.rest(stages.islands.parts_of(1), kStep_s, stages.scene);
        stages.scene.body(1).forget_loads();
    }
    CHECK(stages.turns.due()[0].island == 0);
    CHECK(stages.turns.due()[0].dt_s == Approx(3.0 * kStep_s));
}

TEST_CASE(
    "island turns: what is slow for long sleeps with its island, and one that wakes wakes all") {
    RigidWorldSettings settings = make_weightless();
    settings.sleep_after_s = 2.0 * kStep_s;
    Stages stages({make_ball(0.0), make_ball(2.0 * kRadius_m), make_ball(1.0)}, {}, settings);
    const auto rest = [&] {
        stages.part();
        for (const DueIsland& due : stages.turns.due()) {
            stages.turns.rest(stages.islands.parts_of(due.island), due.dt_s, stages.scene);
        }
        stages.forget_loads();
    };
    stages.scene.body(0).state.velocity_W.linear.y() = 1.01 * settings.sleep_speed_m_per_s;
    rest();
    stages.scene.body(0).state.velocity_W = {};
    rest();
    CHECK_FALSE(stages.scene.body(1).asleep);
    rest();
    CHECK(stages.scene.body(0).asleep);
    CHECK(stages.scene.body(1).asleep);
    CHECK_FALSE(stages.scene.body(2).asleep);  // it touches nothing
    rest();
    CHECK(stages.turns.n_asleep() == 2);
    CHECK(stages.scene.body(0).asleep);
    CHECK(stages.turns.due().size() == 1);
    stages.scene.body(1).wake();
    rest();
    CHECK_FALSE(stages.scene.body(0).asleep);
    CHECK(stages.turns.n_asleep() == 0);
}

TEST_CASE("way bounds: an island goes no farther than to what nobody looked for") {
    // The first two touch and are one; the post stands 0.8 m before the second.
    Stages stages({make_ball(0.0), make_ball(2.0 * kRadius_m), make_post(1.0), make_ball(3.0)});
    stages.part();
    const auto bound = [&](double way_m) {
        stages.scene.body(0).drift_W.linear.x() = way_m / kStep_s;
        stages.scene.body(1).drift_W.linear.x() = way_m / kStep_s;
        stages.bounds.find(stages.turns.due(), stages.islands, stages.scene, stages.near);
    };
    bound(0.7);
    CHECK(stages.bounds.part_of(0) == 1.0);
    CHECK(stages.bounds.n_held() == 0);
    stages.forget_loads();
    stages.part();
    bound(1.6);
    CHECK(stages.bounds.part_of(0) == Approx(0.5).margin(kNear_m));
    CHECK(stages.bounds.part_of(1) == 1.0);
    CHECK(stages.bounds.n_held() == 1);
}

TEST_CASE(
    "island stepper: it goes by what it was solved for, or a part of it, and bounces on the way") {
    for (const double goes : {1.0, 0.5}) {
        Stages stages({make_ball(0.0, 2.0)});
        BodyLoads::push({{0.0, 3.0, 0.0}, Vector3::Zero()}, stages.scene.body(0));
        stages.part();
        const IslandParts parts = stages.islands.parts_of(0);
        SolvedIsland solved = stages.stepper.solve(parts, kStep_s, stages.scene);
        CHECK(solved.n_parts == 1);
        CHECK(stages.scene.body(0).state.pose_W.position.x() == 0.0);
        IslandStepper::move(parts, kStep_s, goes, solved, stages.scene);
        const RigidState& state = stages.scene.body(0).state;
        CHECK(state.pose_W.position.x() == Approx(goes * 2.0 * kStep_s));
        CHECK(state.velocity_W.linear.y() == Approx(3.0 * kStep_s));
        CHECK(stages.scene.body(0).load_W.force.isZero(0.0));
    }
    for (const double goes : {1.0, 0.5}) {
        // A tenth of a millisecond before the post, which it leaves as fast as it comes: 0.01 m there and 0.08 back.
        std::vector<RigidWorldBody> bodies{make_ball(0.0, 100.0), make_post(0.11)};
        bodies[0].restitution = 1.0;
        Stages stages(bodies);
        stages.part();
        const IslandParts parts = stages.islands.parts_of(0);
        SolvedIsland solved = stages.stepper.solve(parts, kStep_s, stages.scene);
        CHECK(solved.n_parts > 1);
        CHECK_FALSE(solved.is_cut);
        CHECK(stages.scene.body(0).state.pose_W.position.x() == 0.0);
        IslandStepper::move(parts, kStep_s, goes, solved, stages.scene);
        const RigidState& state = stages.scene.body(0).state;
        CHECK(state.velocity_W.linear.x() == Approx(-100.0));
        CHECK(state.pose_W.position.x() == Approx(-0.08 * goes).margin(2.0 * kNear_m));
    }
}

}  // namespace
}  // namespace fulcrum
