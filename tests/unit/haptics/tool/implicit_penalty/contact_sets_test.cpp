#include "haptics/math/rotation.h"
#include "haptics/tool/implicit_penalty/contact_clusters.h"
#include "haptics/tool/implicit_penalty/contact_planes.h"
#include "haptics/tool/implicit_penalty/contact_taylor.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounded = 1.0 + 1.0e-9;
constexpr int kSteps = 300;
const ContactPlanesSettings kDamped{.stiffness_N_per_m = 5000.0,
                                    .damping_Ns_per_m = 8.0,
                                    .within_m = 0.001,
                                    .rise_m_per_s = 0.1,
                                    .turn_rad_per_s = 50.0,
                                    .shift_m_per_s = 1.0};
const double kRise_N = kDamped.stiffness_N_per_m * kDamped.rise_m_per_s * kDt_s;
const double kTurn = kDamped.turn_rad_per_s * kDt_s;
const double kShift_m = kDamped.shift_m_per_s * kDt_s;
const std::array<MovingFrame, 1> kStanding{};

// A course by chance: a seed tells it all.
class Chance {
  public:
    Chance() : random_(*rc::gen::arbitrary<unsigned>()) {}
    double any(double least, double most) {
        return least + 0.5 * (most - least) * (random_.uniform() + 1.0);
    }
    int count(int least, int most) {
        return least + static_cast<int>(random_.integer() % static_cast<unsigned>(most - least));
    }
    Vector3 normal(double tilt) {
        return Vector3(tilt * random_.uniform(), 1.0, tilt * random_.uniform()).normalized();
    }

  private:
    Random random_;
};

// What planes push a tool with that stands at the origin, step by step.
class Standing {
  public:
    void learn(std::span<const ContactCluster> clusters) {
        ContactModel model;
        model.stamp_s = 0.0;
        for (const ContactCluster& cluster : clusters) {
            n_new_ += cluster.id > newest_ ? 1U : 0U;
            newest_ = std::max(newest_, cluster.id);
            model.contacts[static_cast<std::size_t>(model.n++)] = {0, cluster, Pose{}, Twist{}};
        }
        planes_.learn(model);
    }
    void step() {
        last_ = now_;
        last_N_ = sum_N_;
        n_planes_ = planes_.planes().size() + n_new_;
        n_new_ = 0;
        planes_.begin_step(Pose{}, kStanding, kDt_s);
        now_ = {};
        sum_N_ = 0.0;
        PlaneContactsLoad(planes_.planes()).add_wrench(RigidState{}, 0.0, now_);
        for (const PlaneContact& plane : planes_.planes()) {
            sum_N_ += compute_push_N(plane, RigidState{});
        }
    }
    // Of the force: each plane's rise, and what turns.
    [[nodiscard]] double promised_N(std::size_t n_planes) const {
        return static_cast<double>(n_planes) * kRise_N + std::max(sum_N_, last_N_) * kTurn;
    }
    [[nodiscard]] double jump_N() const { return (now_.force - last_.force).norm(); }
    [[nodiscard]] double jump_Nm() const { return (now_.torque - last_.torque).norm(); }
    [[nodiscard]] double push_N() const { return sum_N_; }
    [[nodiscard]] double arm_Nm() const { return std::max(sum_N_, last_N_) * kShift_m; }
    // That were there before the step or came with it.
    [[nodiscard]] std::size_t n_planes() const { return n_planes_; }

  private:
    ContactPlanes planes_{kDamped};
    Wrench now_;
    Wrench last_;
    double sum_N_ = 0.0;
    double last_N_ = 0.0;
    std::size_t n_planes_ = 0;
    std::size_t n_new_ = 0;
    std::uint32_t newest_ = 0;
};

constexpr double kRounding = 1.0e-12;
const ContactPlanesSettings kUndamped{.stiffness_N_per_m = 5000.0,
                                      .damping_Ns_per_m = 0.0,
                                      .within_m = 0.001,
                                      .rise_m_per_s = 0.1,
                                      .turn_rad_per_s = 50.0,
                                      .shift_m_per_s = 1.0};

// A cluster of a floor at y = 0, met by the tool's point at a depth.
ToldContact tell(std::uint32_t id, double depth_m, const Vector3& point_T = Vector3::Zero(),
                 const Vector3& normal_O = Vector3::UnitY()) {
    ToldContact told;
    told.X_OT = Pose::at(-depth_m * normal_O - point_T);
    told.cluster = {id, point_T, normal_O, Vector3::Zero(), depth_m, 1.0};
    return told;
}

ContactModel model_of(const std::vector<ToldContact>& all) {
    ContactModel model;
    model.stamp_s = 0.0;
    for (const ToldContact& one : all) {
        model.contacts[static_cast<std::size_t>(model.n++)] = one;
    }
    return model;
}

Wrench find_push(const ContactPlanes& planes, const Pose& tool_W) {
    Wrench wrench;
    PlaneContactsLoad(planes.planes()).add_wrench({tool_W, {}}, 0.0, wrench);
    return wrench;
}

}  // namespace

// Nothing jumps (contact_planes.h): clusters that begin, end, fade, come back and merge, found
// (contact_clusters.h) and followed, on a tool that stands.

TEST_CASE("contact jumps: clusters told by chance, weaker, turned, elsewhere, keep the promise") {
    double most_N = 0.0;
    CHECK(rc::check([&] {
        Chance chance;
        Standing tool;
        const int every = chance.count(1, 12);  // steps a round of the contact thread
        const auto n = static_cast<std::size_t>(chance.count(1, 4));
        std::array<ContactCluster, 3> all;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const double x_m = 0.02 * (k == 1 ? -1.0 : 1.0);
            all.at(k) = {k + 1, {x_m, 0.0, 0.0}, Vector3::UnitY(), {x_m, 0.01, 0.0}, 0.01, 1.0};
        }
        for (int i = 0; i < kSteps; ++i) {
            std::vector<ContactCluster> told;
            for (ContactCluster& one : std::span(all).first(n)) {
                const double what = chance.any(0.0, 1.0);
                one.strength = what < 0.5 ? chance.any(0.0, 1.0) : 1.0;
                one.normal_O = chance.normal(what < 0.2 ? 1.0 : 0.0);
                if (n > 1) {
                    // One alone stays where it is; more are told elsewhere too, and half-way by other numbers.
                    one.point_T = {chance.any(-0.02, 0.02), 0.0, chance.any(-0.02, 0.02)};
                    one.place_O = one.point_T + chance.any(-0.004, 0.01) * one.normal_O;
                    one.id += i == kSteps / 2 ? 10U : 0U;
                }
                if (what < 0.9) {
                    told.push_back(one);
                }
            }
            if (i % every == 0) {
                tool.learn(told);
            }
            tool.step();
            const double promised_N = tool.promised_N(n == 1 ? 1 : tool.n_planes());
            RC_ASSERT(tool.jump_N() <= promised_N * kRounded);
            RC_ASSERT(tool.jump_Nm() <= (0.03 * promised_N + tool.arm_Nm()) * kRounded);
            most_N = std::max(most_N, tool.push_N());
        }
    }));
    // A centimetre deep is worth 55 N: a tenth of its strength is eleven rises.
    CHECK(most_N > 20.0);
}

TEST_CASE("contact jumps: patches that come, go, meet and part at any depth keep the promise") {
    double most_N = 0.0;
    int n_faded = 0;
    int n_merged = 0;
    CHECK(rc::check([&] {
        Chance chance;
        Standing tool;
        ContactClusters clusters(
            {.within_m = 0.001, .radius_m = 0.01, .most = 8, .fade_s = chance.any(0.0, 0.02)});
        const int every = chance.count(1, 12);
        std::array<NearContact, 6> places{};
        std::array<bool, 6> is_there{};
        for (int i = 0; i < kSteps; ++i) {
            if (i % every == 0) {
                const auto one = static_cast<std::size_t>(chance.count(0, 6));
                places[one] = {{chance.any(-0.03, 0.03), 0.0, chance.any(-0.01, 0.01)},
                               chance.normal(0.3),
                               chance.any(-0.002, 0.01)};
                is_there[one] = chance.any(0.0, 1.0) < 0.7;
                std::vector<NearContact> near;
                for (std::size_t k = 0; k < places.size(); ++k) {
                    if (is_there[k]) {
                        near.push_back(places[k]);
                    }
                }
                const std::size_t n_before = clusters.all().size();
                clusters.update(near, Pose{}, every * kDt_s);
                n_faded +=
                    std::ranges::any_of(clusters.all(),
                                        [](const ContactCluster& c) { return c.strength < 1.0; })
                        ? 1
                        : 0;
                n_merged += clusters.all().size() < n_before && !near.empty() ? 1 : 0;
                tool.learn(clusters.all());
            }
            tool.step();
            const std::size_t n = tool.n_planes();
            RC_ASSERT(tool.jump_N() <= tool.promised_N(n) * kRounded);
            RC_ASSERT(tool.jump_Nm() <= (0.05 * tool.promised_N(n) + tool.arm_Nm()) * kRounded);
            most_N = std::max(most_N, tool.push_N());
        }
    }));
    CHECK(most_N > 20.0);
    CHECK(n_faded > 100);
    CHECK(n_merged > 100);
}

TEST_CASE("contact jumps: a normal that is told the other way round turns, and does not flip") {
    Standing tool;
    ContactCluster told{1, Vector3::Zero(), Vector3::UnitY(), {0.0, 0.002, 0.0}, 0.002, 1.0};
    tool.learn({&told, 1});
    for (int i = 0; i < 100; ++i) {
        tool.step();
    }
    REQUIRE(tool.push_N() == Approx(15.0).epsilon(1e-9));
    told.normal_O = -Vector3::UnitY();
    told.place_O = {0.0, -0.002, 0.0};
    tool.learn({&told, 1});
    for (int i = 0; i < 200; ++i) {
        tool.step();
        REQUIRE(tool.jump_N() <= tool.promised_N(1) * kRounded);
    }
    CHECK(tool.push_N() == Approx(15.0).epsilon(1e-9));
}

TEST_CASE("contact planes: pushed by k times the depth; what pushes nothing is there at once") {
    ContactPlanes planes(kUndamped);
    const ToldContact told = tell(1, 0.0004, {0.01, 0.0, 0.0});
    for (int i = 0; i < 100; ++i) {
        planes.learn(model_of({told}));
        planes.begin_step(told.X_OT, kStanding, kDt_s);
    }
    const Wrench push = find_push(planes, told.X_OT);
    CHECK(push.force.y() == Approx(5000.0 * 0.0014).epsilon(1e-9));
    CHECK(push.torque.z() == Approx(0.01 * 5000.0 * 0.0014).epsilon(1e-9));
    // And where the tool goes without being told anew, the plane goes on pushing as it lies.
    const Pose deeper = Pose::at(told.X_OT.position - 0.0006 * Vector3::UnitY());
    planes.begin_step(deeper, kStanding, kDt_s);
    CHECK(find_push(planes, deeper).force.y() == Approx(5000.0 * 0.002).epsilon(1e-9));
    const Pose away = Pose::at(Vector3(-0.01, 0.0011, 0.0));
    planes.begin_step(away, kStanding, kDt_s);
    CHECK(find_push(planes, away).force.norm() == 0.0);
    planes = ContactPlanes(kUndamped);
    planes.learn(model_of({tell(1, -0.0011)}));
    planes.begin_step(tell(1, -0.0011).X_OT, kStanding, kDt_s);
    const Vector3 other = Vector3(1.0, 1.0, 0.0).normalized();
    const ToldContact moved = tell(1, -0.0015, {0.05, 0.0, 0.0}, other);
    planes.learn(model_of({moved}));
    planes.begin_step(moved.X_OT, kStanding, kDt_s);
    REQUIRE(planes.planes().size() == 1);
    CHECK((planes.planes()[0].normal_W - other).norm() < kRounding);
    CHECK(compute_depth_m(planes.planes()[0], moved.X_OT) == Approx(-0.0005).epsilon(1e-9));
}

TEST_CASE("contact planes: one that is told deep pushes nothing at first and comes at its rate") {
    ContactPlanes planes(kUndamped);
    const ToldContact told = tell(1, 0.003);
    planes.learn(model_of({told}));
    for (int i = 1; i <= 60; ++i) {
        planes.begin_step(told.X_OT, kStanding, kDt_s);
        const double reach_m = std::min(0.004, 0.1 * kDt_s * i);
        REQUIRE(find_push(planes, told.X_OT).force.y() == Approx(5000.0 * reach_m).epsilon(1e-9));
    }
}

TEST_CASE("contact planes: one that is no longer told goes back at its rate and is gone") {
    ContactPlanes planes(kUndamped);
    const ToldContact told = tell(1, 0.001);
    for (int i = 0; i < 100; ++i) {
        planes.learn(model_of({told}));
        planes.begin_step(told.X_OT, kStanding, kDt_s);
    }
    planes.learn(model_of({}));
    double last_N = find_push(planes, told.X_OT).force.y();
    CHECK(last_N == Approx(10.0).epsilon(1e-9));
    int n_steps = 0;
    while (planes.is_near() && n_steps < 100) {
        planes.begin_step(told.X_OT, kStanding, kDt_s);
        const double now_N = find_push(planes, told.X_OT).force.y();
        CHECK(last_N - now_N <= 0.5 * (1.0 + 1e-9));
        last_N = now_N;
        ++n_steps;
    }
    CHECK(n_steps == 20);
    CHECK(last_N == 0.0);
}

TEST_CASE("contact planes: a wall that moves takes its plane along and brakes what it meets") {
    ContactPlanesSettings damped = kUndamped;
    damped.damping_Ns_per_m = 10.0;
    damped.within_m = 1.0e-3;
    ContactPlanes planes(damped);
    const ToldContact told = tell(1, 0.001);
    // The tool goes with the wall: nothing is damped. All turned on its side, far from the origin.
    const Quaternion turn = compute_exp(Vector3(0.0, 0.0, -1.0));
    std::array<MovingFrame, 1> wall{};
    wall[0].pose_W = {{0.3, 0.2, 0.1}, turn};
    wall[0].velocity_W.linear = {0.5, -0.2, 0.3};
    RigidState tool;
    for (int i = 0; i < 50; ++i) {
        planes.learn(model_of({told}));
        tool.pose_W = move_evenly(wall[0], -kDt_s).pose_W * told.X_OT;
        planes.begin_step(tool.pose_W, wall, kDt_s);
    }
    tool.pose_W = wall[0].pose_W * told.X_OT;
    tool.velocity_W = wall[0].velocity_W;
    REQUIRE(planes.planes().size() == 1);
    const PlaneContact& plane = planes.planes()[0];
    CHECK((plane.normal_W - turn * Vector3::UnitY()).norm() < kRounding);
    CHECK(compute_push_N(plane, tool) == Approx(10.0).epsilon(1e-9));
    tool.velocity_W.linear -= 0.1 * plane.normal_W;
    CHECK(compute_push_N(plane, tool) == Approx(11.0).epsilon(1e-9));
}

TEST_CASE("contact planes: too many, other objects, none at all, and bad settings") {
    ContactPlanes planes(kUndamped);
    std::vector<ToldContact> many;
    for (std::uint32_t id = 1; id <= kMostClusters; ++id) {
        many.push_back(tell(id, 0.0));
    }
    planes.learn(model_of(many));
    planes.begin_step({}, kStanding, kDt_s);
    CHECK(planes.planes().size() == kMostClusters);
    for (ToldContact& one : many) {
        one.cluster.id += 100;
    }
    planes.learn(model_of(many));
    planes.begin_step({}, kStanding, kDt_s);
    CHECK(planes.planes().size() <= kMostClusters);
    // An object that is not there pushes nothing.
    planes.clear();
    CHECK_FALSE(planes.is_near());
    ToldContact elsewhere = tell(1, 0.001);
    elsewhere.object = 3;
    planes.learn(model_of({elsewhere}));
    planes.begin_step({}, kStanding, kDt_s);
    CHECK_FALSE(planes.is_near());
    check_refused(
        kUndamped,
        {[](auto& s) { s.stiffness_N_per_m = -1.0; }, [](auto& s) { s.damping_Ns_per_m = 1.0e5; },
         [](auto& s) { s.within_m = 0.0; }, [](auto& s) { s.rise_m_per_s = 0.0; },
         [](auto& s) { s.turn_rad_per_s = std::nan(""); },
         [](auto& s) { s.shift_m_per_s = 1.0e9; }});
}
