#include "haptics/loop/round_teller.h"

#include <catch2/catch.hpp>

#include <memory>

using namespace fulcrum;

namespace {

const std::vector<EffectSlot> kEffects{
    {Effect::contact, -1}, {Effect::field, 0}, {Effect::field, 1}};
const Vector3 kOne_N(1.0, 0.0, 0.0);
const Vector3 kTwo_N(0.0, 2.0, 0.0);

}  // namespace

TEST_CASE("round teller: each share is in its effect's place, and of this round") {
    const auto channels = std::make_unique<HapticChannels>();
    const auto shares = std::make_unique<LatestValue<ForceShares>>();
    channels->shares = shares.get();
    RoundTeller teller(*channels, kEffects);
    HapticState state;
    const auto tell_round = [&](bool has_pose, bool adds) {
        teller.begin(has_pose);
        if (adds) {
            teller.share(Effect::contact, kOne_N, kTwo_N);
            teller.share(Effect::field, kTwo_N, kOne_N, 1);
        }
        teller.publish(state, 0.5, 0.001);
        REQUIRE(shares->take());
        return shares->value();
    };
    const ForceShares told = tell_round(true, true);
    REQUIRE(told.n == 3);
    CHECK(told.each_W[0].force == kOne_N);
    CHECK(told.each_W[0].torque == kTwo_N);
    CHECK(told.each_W[1].force == Vector3::Zero());
    CHECK(told.each_W[2].force == kTwo_N);
    CHECK(told.each_W[2].torque == kOne_N);
    // What nobody added is nothing, and so is what is added without a pose.
    CHECK(tell_round(true, false).each_W[2].force == Vector3::Zero());
    CHECK(tell_round(false, true).each_W[0].force == Vector3::Zero());
}

TEST_CASE("round teller: rounds are counted and timed, those with a force too") {
    const auto channels = std::make_unique<HapticChannels>();
    RoundTeller teller(*channels, kEffects);
    HapticState state;
    state.commanded_W.force = state.applied_W.force = kOne_N;
    for (std::uint64_t tick = 0; tick < 3; ++tick) {
        teller.begin(true);
        teller.publish(state, 0.25 + static_cast<double>(tick), 0.125);
        REQUIRE(channels->state_for_world.take());
        REQUIRE(channels->state_for_lesson.take());
        CHECK(channels->state_for_world.value().tick == tick);
        CHECK(channels->state_for_lesson.value().time_s == 0.25 + static_cast<double>(tick));
    }
    CHECK(teller.felt_time().felt_s == 0.375);
    // A round that took no time, or a time that is none, was felt for none.
    teller.publish(state, 4.0, -1.0);
    CHECK(teller.felt_time().felt_s == 0.375);
}

TEST_CASE("round teller: a round is recorded with its shares; without room that is a fault") {
    const auto channels = std::make_unique<HapticChannels>();
    const auto record = std::make_unique<RecordRing>();
    channels->record = record.get();
    RoundTeller teller(*channels, kEffects);
    HapticState state;
    DeviceReading told;
    told.stamp_s = 0.75;
    teller.begin(true);
    teller.share(Effect::field, kTwo_N);
    teller.publish(state, 1.0, 0.001);
    REQUIRE(teller.record(state, told, {}) == Fault::none);
    RecordRound round;
    REQUIRE(record->pop(round));
    CHECK(round.shares.n == 3);
    CHECK(round.shares.each_W[1].force == kTwo_N);
    Fault fault = Fault::none;
    for (std::size_t i = 0; i <= kRecordRingCapacity && fault == Fault::none; ++i) {
        fault = teller.record(state, told, {});
    }
    CHECK(fault == Fault::record_full);
}
