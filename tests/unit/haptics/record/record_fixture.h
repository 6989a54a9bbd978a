// A record to write, read and damage.
#pragma once

#include "haptics/base/crc32.h"
#include "haptics/base/little_endian.h"
#include "haptics/math/rotation.h"
#include "haptics/record/record.h"
#include "haptics/record/record_reader.h"
#include "haptics/record/record_writer.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fulcrum {

inline RecordSample make_sample(std::uint64_t tick) {
    const auto t = static_cast<double>(tick);
    RecordSample sample;
    sample.tick = tick;
    sample.time_s = 0.001 * t;
    sample.stamp_s = 0.001 * t - 0.0002;
    sample.pose_D = {Vector3(0.1 * std::sin(t), 0.2, -0.3),
                     compute_exp(Vector3(0.01 * t, 0.0, 0.2))};
    sample.twist_W = {Vector3(1, 2, 3), Vector3(4, 5, 6)};
    sample.commanded_W = {Vector3(0.5 * t, -8, 9), Vector3(10, 11, 12)};
    sample.applied_W = {Vector3(13, 14, 15), Vector3(16, 17, 18)};
    sample.buttons = 3;
    sample.faults = tick % 7 == 0 ? Fault::device_read | Fault::command_stale : Fault::none;
    sample.gate = static_cast<GatePhase>(tick % 5);
    sample.touched_body = static_cast<std::int32_t>(tick % 3) - 1;
    return sample;
}

inline RecordHeader make_header() {
    RecordHeader header;
    header.rate_Hz = 1000.0;
    header.lesson = "gravity";
    header.max_force_N = 5.0;
    header.max_torque_Nm = 0.3;
    header.effects = {"weight", "brake"};
    header.bodies = {"apple", "egg", "m\xC3\xB6hre"};
    header.facts = {{"program.version", "0.1.0"}, {"option.seed", "1"}};
    return header;
}

/// Of both effects of the header.
inline std::array<Wrench, 2> make_shares(std::uint64_t tick) {
    const auto t = static_cast<double>(tick);
    return {{{Vector3(0.5 * t, -9.0, 9.0), Vector3(10, 11, 12)},
             {Vector3(0.0, 1.0, 0.0), Vector3(0.0, 0.0, 1e-300)}}};
}

inline RecordBody make_body(std::uint64_t tick) {
    const auto t = static_cast<double>(tick);
    return {0.001 * t,
            static_cast<std::int32_t>(tick % 3),
            {{Vector3(t, 1.0, 2.0), compute_exp(Vector3(0.0, 0.1, 0.0))},
             Vector3(0.0, -t, 0.0),
             BodyWhere::falling}};
}

/// A block's head is its mark, its kind, its payload's size and the checksum of all but the mark.
inline constexpr std::size_t kBlockHead = 16;
inline constexpr std::size_t kHeaderSizeAt = 12;

inline std::uint32_t u32_at(const std::vector<std::byte>& bytes, std::size_t at) {
    return get_little_endian<std::uint32_t>(&bytes[at]);
}
inline void put_u32(std::vector<std::byte>& bytes, std::size_t at, std::uint32_t value) {
    put_little_endian(value, &bytes[at]);
}
/// Makes the checksum of the block that begins at `at` fit again.
inline void mend_block(std::vector<std::byte>& bytes, std::size_t at) {
    const std::span<const std::byte> all(bytes);
    put_u32(bytes, at + 12,
            compute_crc32(all.subspan(at + kBlockHead, u32_at(bytes, at + 8)),
                          compute_crc32(all.subspan(at + 4, 8))));
}
/// And that of the header.
inline void mend_header(std::vector<std::byte>& bytes) {
    const std::size_t size = u32_at(bytes, kHeaderSizeAt);
    put_u32(bytes, size - 4, compute_crc32(std::span(bytes).first(size - 4)));
}
/// What the reader says about these bytes.
inline std::string find_complaint(const std::vector<std::byte>& bytes) {
    const Expected<Record> record = read_record(bytes);
    REQUIRE_FALSE(record);
    CHECK_FALSE(record.error().message.empty());
    return record.error().message;
}

/// Where the first block of `make_bytes` begins.
inline std::size_t header_bytes() {
    return RecordEncoder(make_header()).take_bytes().size();
}
inline constexpr std::size_t kFixtureSampleBytes = kRecordSampleBytes + 2 * kRecordShareBytes;

/// The same rounds as a writer of version `version`, 1 to 4, put them: by hand, from the format's own words.
inline std::vector<std::byte> make_old_bytes(std::uint32_t version,
                                             const std::vector<RecordSample>& samples,
                                             const std::vector<RecordEvent>& events = {}) {
    std::vector<std::byte> bytes;
    const auto put = [](std::vector<std::byte>& to, const auto& value) {
        const auto* const begin = reinterpret_cast<const std::byte*>(&value);
        to.insert(to.end(), begin, begin + sizeof value);
    };
    const auto put_text = [](std::vector<std::byte>& to, const std::string& text,
                             std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) {
            to.push_back(i < text.size() ? static_cast<std::byte>(text[i]) : std::byte{0});
        }
    };
    put_text(bytes,
             "\x89"
             "FLCR\r\n\x1a",
             8);
    put(bytes, version);
    put(bytes, std::uint32_t{88});
    put(bytes, 1000.0);
    put_text(bytes, "gravity", 60);
    put(bytes, compute_crc32(bytes));
    const auto put_block = [&](std::uint32_t kind, const std::vector<std::byte>& payload) {
        std::vector<std::byte> head;
        put(head, kind);
        put(head, static_cast<std::uint32_t>(payload.size()));
        put_text(bytes, "BLK1", 4);
        bytes.insert(bytes.end(), head.begin(), head.end());
        put(bytes, compute_crc32(payload, compute_crc32(head)));
        bytes.insert(bytes.end(), payload.begin(), payload.end());
    };
    std::vector<std::byte> payload;
    for (const RecordSample& s : samples) {
        put(payload, s.tick);
        const double numbers[] = {s.time_s,
                                  s.stamp_s,
                                  s.pose_D.position.x(),
                                  s.pose_D.position.y(),
                                  s.pose_D.position.z(),
                                  s.pose_D.orientation.w(),
                                  s.pose_D.orientation.x(),
                                  s.pose_D.orientation.y(),
                                  s.pose_D.orientation.z()};
        put(payload, numbers);
        for (const Vector3& v : {s.twist_W.linear, s.twist_W.angular, s.commanded_W.force,
                                 s.commanded_W.torque, s.applied_W.force, s.applied_W.torque}) {
            const double three[] = {v.x(), v.y(), v.z()};
            put(payload, three);
        }
        const std::uint32_t last[] = {s.buttons, static_cast<std::uint32_t>(s.faults),
                                      static_cast<std::uint32_t>(s.gate), 0};
        put(payload, last);
    }
    put_block(1, payload);
    if (!events.empty()) {
        payload.clear();
        for (const RecordEvent& event : events) {
            put(payload, event.time_s);
            put(payload, static_cast<std::uint32_t>(event.kind));
            put(payload, event.body);
            put_text(payload, event.text, 48);
        }
        put_block(2, payload);
    }
    payload.clear();
    put(payload, static_cast<std::uint64_t>(samples.size()));
    put(payload, static_cast<std::uint64_t>(events.size()));
    put_block(3, payload);
    return bytes;
}

inline std::vector<std::byte> make_bytes(int n_samples, bool finish = true) {
    RecordEncoder encoder(make_header());
    for (int i = 0; i < n_samples; ++i) {
        const auto tick = static_cast<std::uint64_t>(i);
        if (i % 100 == 50) {
            encoder.append(RecordEvent{0.001 * i, RecordEventKind::caught, 2, "apple"});
            encoder.append(make_body(tick));
        }
        encoder.append(make_sample(tick), make_shares(tick));
    }
    if (finish) {
        encoder.finish();
    }
    return encoder.take_bytes();
}

}  // namespace fulcrum
