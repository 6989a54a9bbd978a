#include "haptics/tool/implicit_penalty/contact_loop.h"

#include "haptics/base/clock.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <memory>
#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

// A floor at y = 0 of its frame under a tool that has one point.
class OnePoint final : public ContactFinder {
  public:
    explicit OnePoint(int& n_asked) : n_asked_(n_asked) {}
    void find(const Pose& X_OT, double within_m, BoundedList<NearContact>& near) noexcept override {
        ++n_asked_;
        const double depth_m = -(X_OT * kPoint).y();
        if (depth_m > -within_m) {
            near.add({kPoint, Vector3::UnitY(), depth_m});
        }
    }
    [[nodiscard]] double reach_m() const noexcept override { return kPoint.norm(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override { return sizeof(*this); }

    static inline const Vector3 kPoint{0.0, -0.01, 0.0};

  private:
    int& n_asked_;
};

auto create_loop(int n_objects, ContactChannels& channels, int& n_asked) {
    std::vector<std::unique_ptr<ContactFinder>> finders;
    for (int i = 0; i < n_objects; ++i) {
        finders.push_back(std::make_unique<OnePoint>(n_asked));
    }
    return ContactLoop::create(std::move(finders), {}, channels);
}

struct Bench {
    int n_asked = 0;
    ContactChannels channels;
    std::unique_ptr<ContactLoop> loop;

    explicit Bench(int n_objects = 1) : loop(create_loop(n_objects, channels, n_asked).value()) {}
    // Where the contact model is, if there is a new one.
    const ContactModel* look(const ToolPlace& place) {
        channels.place.publish(place);
        loop->step(0.0);
        return channels.model.take() ? &channels.model.value() : nullptr;
    }
};

ToolPlace place_at(double y_m, double stamp_s = 0.0, std::int32_t n_objects = 1) {
    ToolPlace place;
    place.stamp_s = stamp_s;
    place.tool.pose_W = Pose::at({0.0, y_m, 0.0});
    place.n_objects = n_objects;
    return place;
}

}  // namespace

TEST_CASE("contact loop: it tells of the newest place, once") {
    Bench bench;
    bench.loop->step(0.0);
    CHECK_FALSE(bench.channels.model.take());
    CHECK(bench.n_asked == 0);
    const ContactModel* model = bench.look(place_at(0.0096, 0.5));
    REQUIRE(model != nullptr);
    CHECK(model->stamp_s == 0.5);
    CHECK(model->n_near == 1);
    REQUIRE(model->n == 1);
    CHECK(model->contacts[0].cluster.depth_m == Approx(0.0004).epsilon(1e-9));
    CHECK(model->contacts[0].cluster.place_O.norm() < 1.0e-12);
    // Nothing new: nothing is looked at again.
    bench.loop->step(1.0);
    CHECK(bench.n_asked == 1);
    CHECK_FALSE(bench.channels.model.take());
    bench.loop->silence(1.0);
}

TEST_CASE("contact loop: what an object sees of the tool is relative to it") {
    Bench bench(2);
    ToolPlace place = place_at(0.0, 0.0, 2);
    // The second object lies on its side elsewhere, on its way, and the tool goes with it, turning a little faster.
    MovingFrame& object = place.objects[1];
    object.pose_W = {{0.5, 0.4, 0.3}, compute_exp(Vector3(0.0, 0.0, -1.2))};
    object.velocity_W = {{0.2, -0.1, 0.4}, {0.0, 3.0, 0.0}};
    const Pose X_OT = {Vector3(0.02, 0.0098, 0.0), Quaternion::Identity()};
    place.tool.pose_W = object.pose_W * X_OT;
    place.tool.velocity_W.linear = compute_velocity_at(object, place.tool.pose_W.position);
    place.tool.velocity_W.angular =
        object.velocity_W.angular + object.pose_W.orientation * Vector3(0.0, 0.0, 0.5);
    place.objects[0].pose_W = Pose::at({0.0, -5.0, 0.0});
    const ContactModel* model = bench.look(place);
    REQUIRE(model != nullptr);
    REQUIRE(model->n == 1);
    const ToldContact& told = model->contacts[0];
    CHECK(told.object == 1);
    CHECK((told.X_OT.position - X_OT.position).norm() < 1.0e-12);
    CHECK(told.velocity_O.linear.norm() < 1.0e-12);
    CHECK((told.velocity_O.angular - Vector3(0.0, 0.0, 0.5)).norm() < 1.0e-12);
    CHECK(told.cluster.depth_m == Approx(0.0002).epsilon(1e-9));
}

TEST_CASE("contact loop: a place that is none tells nothing; clusters live on between rounds") {
    Bench bench;
    ToolPlace spoiled = place_at(0.0096);
    spoiled.tool.pose_W.position.x() = kNan;
    CHECK(bench.look(spoiled) == nullptr);
    spoiled = place_at(0.0096);
    spoiled.objects[0].velocity_W.angular.y() = kInfinity;
    CHECK(bench.look(spoiled) == nullptr);
    CHECK(bench.look(place_at(0.0096, -1.0)) == nullptr);
    CHECK(bench.look(place_at(0.0096, 0.0, 2)) == nullptr);
    CHECK(bench.n_asked == 0);
    CHECK(bench.look(place_at(0.0096)) != nullptr);
    Bench other;
    const std::uint32_t first = other.look(place_at(0.0096, 0.0))->contacts[0].cluster.id;
    CHECK(other.look(place_at(0.0095, 0.001))->contacts[0].cluster.id == first);
    // Off the floor it fades, in the time that passed.
    const ContactModel* model = other.look(place_at(0.02, 0.006));
    REQUIRE(model->n == 1);
    CHECK(model->contacts[0].cluster.strength == Approx(0.5).epsilon(1e-9));
    ToolPlace anew = place_at(0.02, 0.007);
    anew.n_placements = 1;
    model = other.look(anew);
    CHECK(model->n == 0);
    CHECK(model->n_placements == 1);
}

TEST_CASE("contact loop: what cannot be is refused") {
    ContactChannels channels;
    int n_asked = 0;
    CHECK_FALSE(create_loop(0, channels, n_asked));
    CHECK_FALSE(create_loop(kMaxSolids + 1, channels, n_asked));
    std::vector<std::unique_ptr<ContactFinder>> none(1);
    CHECK_FALSE(ContactLoop::create(std::move(none), {}, channels));
    check_refused(
        ContactLoopSettings{},
        {[](auto& s) { s.most_near = 1; }, [](auto& s) { s.clusters.most = 0; },
         [](auto& s) { s.budget_us = -1.0; }, [](auto& s) { s.budget_us = std::nan(""); }});
    const Bench bench(3);
    CHECK(bench.loop->n_objects() == 3);
    CHECK(bench.loop->reach_m() == Approx(0.01));
    CHECK(bench.loop->memory_bytes() > sizeof(ContactLoop) + 2048 * sizeof(NearContact));
}

namespace {

// Takes its time, and keeps what it was given.
class Hurried final : public ContactFinder {
  public:
    Hurried(double takes_us, bool is_near, std::vector<double>& given_us)
        : takes_us_(takes_us), is_near_(is_near), given_us_(given_us) {}
    void limit(double budget_us) noexcept override { budget_us_ = budget_us; }
    [[nodiscard]] bool is_cut() const noexcept override { return is_cut_; }
    void find(const Pose& /*X_OT*/, double /*within_m*/,
              BoundedList<NearContact>& near) noexcept override {
        given_us_.push_back(budget_us_);
        const double until_s = monotonic_now_s() + 1.0e-6 * takes_us_;
        while (monotonic_now_s() < until_s) {
        }
        is_cut_ = budget_us_ > 0.0 && budget_us_ < takes_us_;
        if (is_near_) {
            near.add({Vector3::Zero(), Vector3::UnitY(), 0.0});
        }
    }
    [[nodiscard]] double reach_m() const noexcept override { return 0.01; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override { return sizeof(*this); }

  private:
    double takes_us_;
    bool is_near_;
    std::vector<double>& given_us_;
    double budget_us_ = 0.0;
    bool is_cut_ = false;
};

}  // namespace

TEST_CASE("contact loop: a budget is shared among those that were near, and none is left unasked") {
    std::vector<double> given_us;
    given_us.reserve(64);
    ContactChannels channels;
    const auto make = [&](double budget_us) {
        std::vector<std::unique_ptr<ContactFinder>> finders;
        for (const bool is_near : {true, false, true}) {
            finders.push_back(std::make_unique<Hurried>(2000.0, is_near, given_us));
        }
        ContactLoopSettings settings;
        settings.budget_us = budget_us;
        return ContactLoop::create(std::move(finders), settings, channels).value();
    };
    const auto loop = make(1.0e5);
    const auto ask = [&](ContactLoop& asked, double stamp_s) {
        given_us.clear();
        channels.place.publish(place_at(0.0, stamp_s, 3));
        asked.step(0.0);
        REQUIRE(channels.model.take());
    };
    ask(*loop, 0.001);
    ask(*loop, 0.002);
    // 100 ms: half of it for the first of two that are near, then half of what is left, then all of that.
    REQUIRE(given_us.size() == 3);
    CHECK(given_us[0] <= 0.5e5);
    CHECK(given_us[0] > 0.4e5);
    CHECK(given_us[1] <= 0.5 * 0.98e5);
    CHECK(given_us[2] <= 0.96e5);
    CHECK(given_us[2] > given_us[0]);
    CHECK_FALSE(channels.model.value().is_cut);
    // One that is over by far: all are asked, and it is told.
    ask(*make(100.0), 0.003);
    CHECK(given_us.size() == 3);
    CHECK(given_us[2] == 1.0);
    CHECK(channels.model.value().is_cut);
    CHECK(channels.model.value().n_near == 2);
    // Without one nobody is hurried.
    ask(*make(0.0), 0.004);
    CHECK(given_us == std::vector<double>(3, 0.0));
}
