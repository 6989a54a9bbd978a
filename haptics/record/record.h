// A recorded run: what it was made with, every round of the haptic loop, and what happened meanwhile.
//
// File, little-endian throughout:
//   header  88 bytes  magic 89 46 4C 43 52 0D 0A 1A | u32 version = 4 | u32 header bytes = 88 |
//                     f64 rate in hertz | lesson, UTF-8 padded with zeros to 60 bytes |
//                     u32 CRC-32 of the 84 bytes before it
//   block   16 bytes  u32 "BLK1" | u32 kind (1 samples, 2 events, 3 end) | u32 payload bytes |
//                     u32 CRC-32 of kind, length and payload; then the payload:
//   sample 240 bytes  u64 tick | f64 time | f64 stamp | f64 pose (x y z, quaternion w x y z) |
//                     f64 twist (linear, angular) | f64 commanded (force, torque) |
//                     f64 applied (force, torque) | u32 buttons | u32 faults | u32 gate | u32 0
//   event   64 bytes  f64 time | u32 kind | i32 body | text, UTF-8 padded with zeros to 48 bytes
//   end     16 bytes  u64 number of samples | u64 number of events; always the last block
// faults are the bits of base/fault.h, gate is GatePhase. Version 1 knew no Fault::ended, version 2 none of those of
// hand_guard.h, version 3 no clutch, and they are else the same: they are read too.
// No clock of the day and no address is in it: the same run makes the same bytes. A file without the
// end block was cut off; its whole blocks are good.
//
// Thread: load path. Cost: one pass.
// Source: CRC-32 as in ISO 3309 and PNG (polynomial 0xEDB88320, reflected); the magic follows PNG's,
// whose control characters show a transfer that changed line ends.
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/record_sample.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum {

inline constexpr std::uint32_t kRecordVersion = 4;
inline constexpr std::size_t kRecordLessonBytes = 60;
inline constexpr std::size_t kRecordTextBytes = 48;
inline constexpr std::size_t kRecordHeaderBytes = 88;
inline constexpr std::size_t kRecordSampleBytes = 240;
inline constexpr std::size_t kRecordEventBytes = 64;
inline constexpr std::size_t kRecordBlockSamples =
    256;  ///< samples in a full block; a reader accepts up to 65536

/// What kind of thing happened; the numbers are part of the format.
enum class RecordEventKind : std::uint32_t {
    note = 0,      ///< text alone
    dropped = 1,   ///< a body appeared and fell
    caught = 2,    ///< a body came into the tool
    landed = 3,    ///< a body reached the ground
    released = 4,  ///< the tool was emptied
    asked = 5,     ///< a question; text is its id
    answered = 6,  ///< an answer; text is what was said, shortened
    touched = 7,   ///< the proxy met a body
    failed = 8,    ///< the lesson failed; text says how
};

/// Something that happened during a run.
struct RecordEvent {
    double time_s = 0.0;
    RecordEventKind kind = RecordEventKind::note;
    std::int32_t body = kNoBody;
    std::string text;  ///< at most 48 bytes are kept, cut at a character's border
};

/// What stands at the head of a record.
struct RecordHeader {
    double rate_Hz = 1000.0;  ///< of the haptic loop, 1 to 100000
    std::string lesson;       ///< its id; at most 60 bytes are kept
};

/// A record in memory.
struct Record {
    RecordHeader header;
    std::vector<RecordSample> samples;  ///< in the order of time
    std::vector<RecordEvent> events;
    bool cut_off = false;  ///< the end was missing; what is here is whole
};

/// Reads a whole record. Refuses, with one sentence: wrong magic or version, a bad checksum, counts
/// or sizes that cannot be, times that run backwards or are not finite, anything truncated. Never
/// reads outside `bytes`, never allocates more than they justify.
[[nodiscard]] Expected<Record> read_record(std::span<const std::byte> bytes);
/// The same for a file whose writer was stopped in the middle: keeps every whole block before the
/// first bad or missing byte and sets `cut_off`. A bad header is still refused.
[[nodiscard]] Expected<Record> recover_record(std::span<const std::byte> bytes);
/// Reads the file at `path` (at most 2 GB) with `recover_record`; `where` of an error is the path.
[[nodiscard]] Expected<Record> load_record(const std::string& path);

/// CRC-32 of `bytes`; `before` is the checksum of what came before them, 0 at the start.
[[nodiscard]] std::uint32_t compute_crc32(std::span<const std::byte> bytes,
                                          std::uint32_t before = 0) noexcept;

}  // namespace fulcrum
