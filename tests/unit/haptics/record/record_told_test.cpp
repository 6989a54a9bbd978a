// What loops were told, in a record.
#include "haptics/handover/axle_messages.h"
#include "haptics/handover/line_state.h"
#include "haptics/handover/rigid_messages.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/record/record_fixture.h"

#include <catch2/catch.hpp>

#include <bit>
#include <span>

using namespace fulcrum;

namespace {

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(const Vector3& a, const Vector3& b) {
    return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

ForceCommand make_command() {
    ForceCommand command;
    command.stamp_s = 0.25;
    command.lesson_alive = true;
    command.fields[2] = {false, Vector3(1.0, -0.0, kNan), 0.5};
    command.linearised.force_W = Vector3(1.0, 2.0, 3.0);
    command.linearised.stiffness_N_per_m << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    command.linearised.torque_stiffness_Nm_per_m(2, 0) = -4.0;
    return command;
}

WorldFrame make_frame() {
    WorldFrame frame;
    frame.stamp_s = 0.5;
    frame.carried_force_W = Vector3(0.0, -3.0, -0.0);
    frame.solid_poses_W[4] = {Vector3(1, 2, 3), compute_exp(Vector3(0.1, 0.2, 0.3))};
    frame.solid_placements[1] = 7;
    return frame;
}

RigidFrame make_rigid() {
    RigidFrame frame;
    frame.stamp_s = 1.5;
    frame.rate = 0.75;
    // Out of the scene, and told all the same.
    frame.solids[15].pose_W.position.x() = -0.0;
    frame.solids[3] = {Pose::at({1, 2, 3}), {Vector3(4, 5, 6), Vector3(7, 8, 9)}, 0.002, true, 3};
    return frame;
}

AxleOrders make_orders() {
    AxleOrders orders;
    orders.axles[1] = {2, 0.5, 3, -1.5, true, Vector3(0.1, 0.2, 0.3), 4.0};
    return orders;
}

Record round_trip() {
    RecordHeader header = make_header();
    header.more_hands = {{2.5, 0.1, {}}};
    RecordEncoder encoder(header);
    for (std::uint64_t tick = 0; tick < 600; ++tick) {
        encoder.append(make_sample(tick), make_shares(tick));
        encoder.append(1, make_sample(tick));
        if (tick % 5 == 0) {
            WorldFrame frame = make_frame();
            frame.stamp_s = 0.001 * static_cast<double>(tick);
            encoder.append(0, Told<WorldFrame>{tick, frame});
        }
    }
    // Kind by kind, as they are taken from their rings.
    encoder.append(0, Told<ForceCommand>{7, make_command()});
    encoder.append(0, Told<AxleOrders>{3, make_orders()});
    encoder.append(0, Told<ToldReading>{4, {Fault::clutched | Fault::emergency_stop, false}});
    encoder.append(1, Told<RigidFrame>{9, make_rigid()});
    encoder.append(1, Told<LineState>{8, {0.1, Vector3(1, 2, 3), Vector3(4, 5, 6), 7.0, 8.0, 9}});
    encoder.append(2, Told<LineState>{8, {}});  // a hand that is not there
    encoder.finish();
    auto record = read_record(encoder.take_bytes());
    REQUIRE(record);
    return std::move(*record);
}

template <class T>
T find_told(const RecordRounds& rounds, RecordToldKind kind, std::uint64_t tick) {
    for (const RecordTold& told : rounds.told) {
        if (told.kind == kind && told.tick == tick) {
            T value;
            read_told(rounds, told, value);
            return value;
        }
    }
    FAIL("it is not there");
    return {};
}

}  // namespace

TEST_CASE("record: what each loop was told is read again to the bit, in the order of rounds") {
    const Record record = round_trip();
    REQUIRE(record.told.size() == 120 + 3);
    REQUIRE(record.more_hands[0].told.size() == 2);
    for (std::size_t i = 1; i < record.told.size(); ++i) {
        REQUIRE(record.told[i - 1].tick <= record.told[i].tick);
    }
    CHECK(record.more_hands[0].told[0].kind == RecordToldKind::line);

    const auto command = find_told<ForceCommand>(record, RecordToldKind::command, 7);
    CHECK(command.lesson_alive);
    CHECK(command.stamp_s == 0.25);
    CHECK_FALSE(command.fields[2].on);
    CHECK(same_bits(command.fields[2].anchor_W, make_command().fields[2].anchor_W));
    CHECK(command.fields[1].on);
    CHECK(command.linearised.stiffness_N_per_m == make_command().linearised.stiffness_N_per_m);
    CHECK(command.linearised.torque_stiffness_Nm_per_m(2, 0) == -4.0);
    CHECK(command.linearised.force_W == Vector3(1.0, 2.0, 3.0));

    const auto frame = find_told<WorldFrame>(record, RecordToldKind::world, 595);
    CHECK(frame.stamp_s == 0.001 * 595.0);
    CHECK(same_bits(frame.carried_force_W, make_frame().carried_force_W));
    CHECK(frame.solid_poses_W[4].orientation.coeffs() ==
          make_frame().solid_poses_W[4].orientation.coeffs());
    CHECK(frame.solid_poses_W[3].position == Vector3::Zero());
    CHECK(frame.solid_placements == make_frame().solid_placements);

    const auto orders = find_told<AxleOrders>(record, RecordToldKind::axles, 3);
    CHECK(orders.axles[1].n_spins == 3);
    CHECK(orders.axles[1].spin_rad_per_s == -1.5);
    CHECK(orders.axles[1].is_set);
    CHECK(orders.axles[1].pivot_B == Vector3(0.1, 0.2, 0.3));
    CHECK_FALSE(orders.axles[0].is_set);

    const auto reading = find_told<ToldReading>(record, RecordToldKind::reading, 4);
    CHECK(reading.faults == (Fault::clutched | Fault::emergency_stop));
    CHECK_FALSE(reading.is_reading);

    const RecordRounds& second = record.more_hands[0];
    const auto rigid = find_told<RigidFrame>(second, RecordToldKind::rigid, 9);
    CHECK(rigid.rate == 0.75);
    CHECK(rigid.solids[3].velocity_W.angular == Vector3(7, 8, 9));
    CHECK(rigid.solids[3].behind_s == 0.002);
    CHECK(rigid.solids[3].is_present);
    CHECK(rigid.solids[3].n_placements == 3);
    CHECK(same_bits(rigid.solids[15].pose_W.position.x(), -0.0));
    const auto line = find_told<LineState>(second, RecordToldKind::line, 8);
    CHECK(line.hand_W == Vector3(1, 2, 3));
    CHECK(line.n_launches == 9);
}

TEST_CASE("record: what was told goes with the hand that is looked at alone") {
    const Record record = round_trip();
    const auto second = find_hand(record, 1);
    REQUIRE(second);
    CHECK(second->told.size() == 2);
    CHECK(find_told<LineState>(*second, RecordToldKind::line, 8).length_m == 8.0);
}

TEST_CASE("record: messages that cannot be are refused, and never read past their end") {
    RecordEncoder encoder(make_header());
    encoder.append(0, Told<WorldFrame>{5, make_frame()});
    encoder.append(0, Told<ToldReading>{6, {}});
    encoder.finish();
    const std::vector<std::byte> good = encoder.take_bytes();
    REQUIRE(read_record(good));
    const std::size_t block = header_bytes();
    const std::size_t size = u32_at(good, block + 8);
    int refused = 0;
    for (std::size_t at = 0; at + 4 <= size; at += 4) {
        for (const std::uint32_t value : {0U, 2U, 17U, 4097U, 0xFFFFFFFFU}) {
            auto bytes = good;
            put_u32(bytes, block + kBlockHead + at, value);
            mend_block(bytes, block);
            refused += read_record(bytes) ? 0 : 1;
        }
    }
    CHECK(refused > 30);
    // Of a hand that the header has not.
    auto bytes = good;
    put_u32(bytes, block + kBlockHead, 1);
    mend_block(bytes, block);
    CHECK(find_complaint(bytes).find("a hand that its header has not") != std::string::npos);
    // Cut off anywhere it keeps what is whole.
    for (std::size_t n = block; n < good.size(); n += 7) {
        const auto part = recover_record(std::span(good).first(n));
        REQUIRE(part);
        CHECK((part->told.empty() || part->told.size() == 2));
    }
}
