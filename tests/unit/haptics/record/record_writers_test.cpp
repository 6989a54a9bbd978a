#include "haptics/handover/axle_messages.h"
#include "haptics/handover/line_state.h"
#include "haptics/handover/rigid_messages.h"
#include "haptics/record/record_reader.h"
#include "haptics/record/record_writer.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/record/record_fixture.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>

using namespace fulcrum;

namespace {

void check_same(const RecordSample& a, const RecordSample& b) {
    CHECK(a.tick == b.tick);
    CHECK(a.time_s == b.time_s);
    CHECK(a.stamp_s == b.stamp_s);
    CHECK(a.pose_D.position == b.pose_D.position);
    CHECK(a.pose_D.orientation.coeffs() == b.pose_D.orientation.coeffs());
    CHECK(a.twist_W.linear == b.twist_W.linear);
    CHECK(a.twist_W.angular == b.twist_W.angular);
    CHECK(a.commanded_W.force == b.commanded_W.force);
    CHECK(a.commanded_W.torque == b.commanded_W.torque);
    CHECK(a.applied_W.force == b.applied_W.force);
    CHECK(a.applied_W.torque == b.applied_W.torque);
    CHECK(a.buttons == b.buttons);
    CHECK(a.faults == b.faults);
    CHECK(a.gate == b.gate);
    CHECK(a.touched_body == b.touched_body);
}

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

TEST_CASE("record: what is written is read again, every field of it") {
    const std::vector<std::byte> bytes = make_bytes(700);
    const Expected<Record> record = read_record(bytes);
    REQUIRE(record);
    CHECK(record->header.rate_Hz == 1000.0);
    CHECK(record->header.lesson == "gravity");
    CHECK(record->header.max_force_N == 5.0);
    CHECK(record->header.max_torque_Nm == 0.3);
    CHECK(record->header.effects == make_header().effects);
    CHECK(record->header.bodies == make_header().bodies);
    CHECK(record->header.facts == make_header().facts);
    CHECK(record->version == kRecordVersion);
    CHECK_FALSE(record->cut_off);
    REQUIRE(record->samples.size() == 700);
    REQUIRE(record->shares_W.size() == 1400);
    for (std::size_t i = 0; i < 700; i += 13) {
        check_same(record->samples[i], make_sample(i));
        for (std::size_t k = 0; k < 2; ++k) {
            CHECK(record->shares_of(i)[k].force == make_shares(i)[k].force);
            CHECK(record->shares_of(i)[k].torque == make_shares(i)[k].torque);
        }
    }
    REQUIRE(record->bodies.size() == 7);
    for (std::size_t i = 0; i < 7; ++i) {
        const RecordBody expected = make_body(100 * i + 50);
        const RecordBody& body = record->bodies[i];
        CHECK((body.time_s == expected.time_s && body.body == expected.body));
        CHECK(body.state.where == expected.state.where);
        CHECK(body.state.pose_W.position == expected.state.pose_W.position);
        CHECK(body.state.pose_W.orientation.coeffs() == expected.state.pose_W.orientation.coeffs());
        CHECK(body.state.velocity_W == expected.state.velocity_W);
    }
    REQUIRE(record->events.size() == 7);
    CHECK(record->events[1].time_s == 0.150);
    CHECK(record->events[1].kind == RecordEventKind::caught);
    CHECK(record->events[1].body == 2);
    CHECK(record->events[1].text == "apple");
}

TEST_CASE("record: sizes are as the format says, and fields lie where it says") {
    const std::vector<std::byte> bytes = make_bytes(1);
    const std::size_t head = header_bytes();
    // header, a block of one sample, the end
    REQUIRE(bytes.size() == head + 16 + kFixtureSampleBytes + 16 + 40);
    CHECK(std::memcmp(bytes.data(),
                      "\x89"
                      "FLCR\r\n\x1a",
                      8) == 0);
    CHECK(static_cast<int>(bytes[8]) == 8);  // version, least byte first
    CHECK(static_cast<std::size_t>(bytes[12]) == head);
    CHECK(static_cast<int>(bytes[40]) == 7);  // the lesson's length, behind three numbers
    CHECK(std::memcmp(&bytes[44], "gravity", 7) == 0);
    CHECK(std::memcmp(&bytes[head], "BLK1", 4) == 0);
    double number = 0.0;
    std::memcpy(&number, &bytes[head + 16 + 24 + 16], 8);
    CHECK(number == -0.3);  // z of the pose
    std::memcpy(&number, &bytes[head + 16 + kRecordSampleBytes + 8], 8);
    CHECK(number == -9.0);  // y of the first effect's force
}

TEST_CASE("record: the same run, the same bytes; long texts are cut at a character") {
    CHECK(make_bytes(1000) == make_bytes(1000));
    RecordHeader header;
    // the e with its accent does not fit whole
    header.lesson = std::string(kRecordTextBytes - 1, 'a') + "\xC3\xA9";
    header.facts = {{"lesson.odd\nname", ""}};
    RecordEncoder encoder(header);
    encoder.append(RecordEvent{0.0, RecordEventKind::note, kNoBody, std::string("a\0b\tc", 5)});
    encoder.finish();
    const Expected<Record> record = read_record(encoder.take_bytes());
    REQUIRE(record);
    CHECK(record->header.lesson == std::string(kRecordTextBytes - 1, 'a'));
    CHECK(record->header.facts[0].name == "lesson.odd name");
    CHECK(record->events[0].text == "a b c");
}

TEST_CASE("record: longer lists and more shares than fit are shortened, missing ones zero") {
    RecordHeader header;
    header.effects.assign(kMostEffects + 3, "e");
    header.bodies.assign(kMaxBodies + 3, "b");
    header.facts.assign(kRecordFacts + 3, {"f", "1"});
    RecordEncoder encoder(header);
    const std::vector<Wrench> one = {{Vector3(1, 2, 3), Vector3(4, 5, 6)}};
    encoder.append(make_sample(1), one);
    encoder.finish();
    const Expected<Record> record = read_record(encoder.take_bytes());
    REQUIRE(record);
    CHECK(record->header.effects.size() == kMostEffects);
    CHECK(record->header.bodies.size() == kMaxBodies);
    CHECK(record->header.facts.size() == kRecordFacts);
    CHECK(record->shares_of(0)[0].torque.z() == 6.0);
    CHECK(record->shares_of(0)[kMostEffects - 1].force.norm() == 0.0);
    encoder = RecordEncoder(make_header());
    RecordRound round;
    round.sample = make_sample(1);
    round.shares.n = 1000;
    encoder.append(round);
    encoder.finish();
    CHECK(read_record(encoder.take_bytes()));
}

TEST_CASE("record writer: a file is written, read, and bad places are refused") {
    std::string folder =
        (std::filesystem::temp_directory_path() / "fulcrum_record_XXXXXX").string();
    REQUIRE(mkdtemp(folder.data()) != nullptr);
    const std::string path = folder + "/run.flcr";
    {
        auto writer = RecordWriter::create(path, make_header());
        REQUIRE(writer);
        auto ring = std::make_unique<RecordRing>();
        for (std::uint64_t i = 0; i < 300; ++i) {
            REQUIRE(ring->push({make_sample(i), {}}));
        }
        REQUIRE(writer->drain(*ring));
        REQUIRE(writer->append(RecordEvent{0.5, RecordEventKind::note, kNoBody, "half"}));
        // A crash here would leave the first block.
        const Expected<Record> so_far = load_record(path);
        REQUIRE(so_far);
        CHECK(so_far->cut_off);
        CHECK(so_far->samples.size() == 256);
        REQUIRE(writer->finish());
        // The file is closed: a further block has nowhere to go.
        for (std::uint64_t i = 0; i + 1 < kRecordBlockSamples; ++i) {
            REQUIRE(writer->append(RecordRound{make_sample(300 + i), {}}));
        }
        CHECK_FALSE(writer->append(RecordRound{make_sample(999), {}}));
    }
    const Expected<Record> record = load_record(path);
    REQUIRE(record);
    CHECK_FALSE(record->cut_off);
    CHECK(record->samples.size() == 300);
    CHECK(record->events.size() == 1);
    // It is its owner's alone, and what is put in the place of an older file as well.
    namespace fs = std::filesystem;
    const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
    CHECK(fs::status(path).permissions() == own);
    fs::permissions(path, fs::perms::all);
    REQUIRE(RecordWriter::create(path, {}));
    CHECK(fs::status(path).permissions() == own);
    CHECK_FALSE(RecordWriter::create(folder + "/no/such/run.flcr", {}));
    const Expected<Record> missing = load_record(folder + "/none.flcr");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().where.find("none.flcr") != std::string::npos);
    CHECK_FALSE(load_record(folder));
    std::filesystem::remove_all(folder);
}

// What loops were told, in a record.

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
