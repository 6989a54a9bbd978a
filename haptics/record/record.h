// A recorded run: what it was made with, every round of the haptic loop with each effect's share of its force, and what
// happened and was decided meanwhile.
//
// File, little-endian throughout; a text is a u32 number of bytes and so many of UTF-8, at most 4096:
//   header           magic 89 46 4C 43 52 0D 0A 1A | u32 version = 8 | u32 header bytes |
//                    f64 rate in hertz | f64 the gate's newtons | f64 its newton metres | text lesson |
//                    u32 n, n texts: the effects | u32 n, n texts: the bodies |
//                    u32 n, n pairs of texts: what the run was made with, name and value |
//                    u32 n, of each hand beside the first: f64 its gate's newtons | f64 newton metres | u32 m, m texts: its effects |
//                    u32 CRC-32 of all before it
//   block  16 bytes  u32 "BLK1" | u32 kind (1 samples, 2 events, 3 end, 4 bodies, 5 hand, 6 told) | u32 payload bytes |
//                    u32 CRC-32 of kind, length and payload; then the payload:
//   sample 240 bytes u64 tick | f64 time | f64 stamp | f64 pose (x y z, quaternion w x y z) |
//                    f64 twist (linear, angular) | f64 commanded (force, torque) |
//                    f64 applied (force, torque) | u32 buttons | u32 faults | u32 gate | i32 touched body
//          + 48 each f64 force, torque of each effect of the header, in its order
//   event            f64 time | u32 kind | i32 body | text
//   body    96 bytes f64 time | i32 body | u32 where (BodyWhere) | f64 pose as a sample's | f64 velocity;
//                    of those that are not as they were told last
//   hand             u32 which, 1 for the second | its samples, as the first one's
//   told             u32 which hand, 0 for the first | what its loop took in rounds of it, each: u64 tick | u32 kind | u32 bytes | those
//                    bytes, by kind as told_layout.h walks over them: 1 ForceCommand, 2 WorldFrame, 3 AxleOrders, 4 RigidFrame,
//                    5 LineState, 6 ToldReading; kind by kind, each in the order of ticks. Of a run in real time alone
//   end     40 bytes u64 number of samples | u64 of events | u64 of bodies | u64 of samples of all other hands | u64 of what all loops
//                    were told; always the last block
// faults are the bits of base/fault.h, gate is GatePhase.
// Versions 1 to 4 are read too: their header has 88 bytes, which end with the lesson in 60 and the CRC; their samples
// have neither touched body nor effects, their events 48 bytes of text padded with zeros; they have no bodies. Version 1
// knew no Fault::ended, version 2 none of those of hand_guard.h, version 3 no clutch. Version 5 knew one hand: its header ends
// with the facts, its end has 24 bytes. Version 6 knew no Fault::other_stopped. Before
// version 8 nothing was told, and the end of 6 and 7 has 32 bytes.
// No clock of the day and no address is in it: the same run of the same program makes the same bytes. A file without the
// end block was cut off; its whole blocks are good.
//
// Thread: load path. Cost: one pass.
// Source: CRC-32 as crc32.h has it; the magic follows PNG's, whose control characters show a transfer that changed line ends.
#pragma once

#include "haptics/handover/record_sample.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum {

inline constexpr std::uint32_t kRecordVersion = 8;
inline constexpr std::uint32_t kFirstToldVersion =
    8;  ///< the first that holds what loops were told
inline constexpr std::size_t kRecordTextBytes = 4096;  ///< of any text, at most
inline constexpr std::size_t kRecordSampleBytes = 240;
inline constexpr std::size_t kRecordShareBytes = 48;
inline constexpr std::size_t kRecordBodyBytes = 96;
inline constexpr std::size_t kRecordOldHeaderBytes = 88;  ///< of versions 1 to 4
inline constexpr std::size_t kRecordFacts = 1024;         ///< of a header, at most
inline constexpr std::size_t kRecordBlockSamples =
    256;  ///< samples in a full block; a reader accepts up to 65536

/// What kind of thing happened; the numbers are part of the format.
enum class RecordEventKind : std::uint32_t {
    note = 0,       ///< text alone
    dropped = 1,    ///< a body appeared and fell
    caught = 2,     ///< a body came into the tool
    landed = 3,     ///< a body reached the ground
    released = 4,   ///< the tool was emptied
    asked = 5,      ///< a question; text is its id
    answered = 6,   ///< an answer; text is what was said, shortened
    touched = 7,    ///< the proxy met a body
    failed = 8,     ///< the lesson failed; text says how
    placed = 9,     ///< a body appeared and stays
    hidden = 10,    ///< a body is gone from the scene
    held = 11,      ///< a body was put into the tool
    pressed = 12,   ///< a key; text is its name
    wheel = 13,     ///< a mouse's wheel was turned; text is by how many notches
    said = 14,      ///< shown, asked, answered, marked: a line of the transcript
    switched = 15,  ///< a declared force; text is its name, "on" or "off", and its strength
    gate = 16,      ///< the last gate changed its phase; text is the new one
    fault = 17,     ///< faults came or went; text names those that hold now
    cut = 18,       ///< a tool's step left something out, to end in time; text says how far off
    finished = 19,  ///< the lesson's end; text is its score and stars
};
inline constexpr RecordEventKind kLastRecordEvent = RecordEventKind::finished;

/// Something that happened during a run.
struct RecordEvent {
    double time_s = 0.0;
    RecordEventKind kind = RecordEventKind::note;
    std::int32_t body = kNoBody;
    std::string text;  ///< at most kRecordTextBytes are kept, cut at a character's border
};

/// Where a body was found when it was not as it was told last.
struct RecordBody {
    double time_s = 0.0;
    std::int32_t body = kNoBody;
    BodyState state{};
};

/// One thing that a run was made with, such as "seed" and "1"; a name's part before the point says what kind of thing it is.
struct RecordFact {
    std::string name;
    std::string value;
    friend bool operator==(const RecordFact&, const RecordFact&) = default;
};

/// What stands at the head of a record of a hand beside the first.
struct RecordHand {
    double max_force_N = 0.0;  ///< its gate's limit
    double max_torque_Nm = 0.0;
    std::vector<std::string> effects{};  ///< what may add to its force, at most kMostEffects
    friend bool operator==(const RecordHand&, const RecordHand&) = default;
};
inline constexpr std::size_t kRecordMoreHands = 3;  ///< at most

/// What stands at the head of a record.
struct RecordHeader {
    double rate_Hz = 1000.0;               ///< of the haptic loop, 1 to 100000
    std::string lesson;                    ///< its id
    double max_force_N = 0.0;              ///< the last gate's limit; 0 where it is not known
    double max_torque_Nm = 0.0;            ///< likewise
    std::vector<std::string> effects{};    ///< what may add to the force, at most kMostEffects
    std::vector<std::string> bodies{};     ///< their names, at most kMaxBodies
    std::vector<RecordFact> facts{};       ///< in the order in which they are to be told
    std::vector<RecordHand> more_hands{};  ///< at most kRecordMoreHands
};

/// What a loop was told; the numbers are part of the format.
enum class RecordToldKind : std::uint32_t {
    command = 1,
    world = 2,
    axles = 3,
    rigid = 4,
    line = 5,
    reading = 6
};

/// Of one round one thing that the loop was told, as bytes of the file: `read_told` makes a value of them.
struct RecordTold {
    std::uint64_t tick = 0;
    RecordToldKind kind = RecordToldKind::command;
    std::size_t at = 0;  ///< in RecordRounds::told_bytes
    std::size_t size = 0;
};

/// The rounds of one hand.
struct RecordRounds {
    std::vector<RecordSample> samples;  ///< in the order of time
    std::vector<Wrench>
        shares_W;  ///< of each sample in turn as many as the header has effects of that hand
    std::vector<RecordTold> told;  ///< in the order of ticks; none of a run under a virtual clock
    std::vector<std::byte> told_bytes;
};

/// A record in memory: the first hand's rounds, and what is of all.
struct Record : RecordRounds {
    RecordHeader header;
    std::uint32_t version = kRecordVersion;  ///< that it was read from
    std::vector<RecordRounds> more_hands;    ///< as many as the header has
    std::vector<RecordEvent> events;
    std::vector<RecordBody> bodies;
    bool cut_off = false;  ///< the end was missing or damaged; what is here is whole
    std::string fault;     ///< what was wrong, then: "the record is damaged: …"

    /// What each effect added to the force of a sample.
    [[nodiscard]] std::span<const Wrench> shares_of(std::size_t sample) const {
        const std::size_t n = header.effects.size();
        return std::span(shares_W).subspan(n * sample, n);
    }
};

/// Reads what a loop was told into a value of the type that its kind names; one that was read from a record can be.
template <class T>
void read_told(const RecordRounds& rounds, const RecordTold& told, T& value);

/// What another hand of the record did, as a record of it alone: `hand` is 1 for the second; facts of the device are its own. Nothing
/// where there is none.
[[nodiscard]] std::optional<Record> find_hand(const Record& record, std::size_t hand);
/// The header of such a record; `hand` is there.
[[nodiscard]] RecordHeader header_of_hand(const RecordHeader& header, std::size_t hand);
/// Before the facts of that hand's device: "hand 2.".
[[nodiscard]] std::string fact_prefix(std::size_t hand);

}  // namespace fulcrum
