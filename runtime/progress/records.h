// What is kept of a learner: who, which session, every attempt, every error found in it. Facts,
// written once.
//
//   Learner 1 ── n SessionRecord 1 ── 0..1 SessionEnd
//                SessionRecord 1 ── n AttemptRecord 1 ── n ErrorRecord
//   Learner 1 ── n HandSetting
//
// The caller gives each record its id before it is written, so that a write whose outcome is
// unknown can be repeated and leaves one record.
#pragma once

#include "haptics/base/error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// 128 random bits as 32 lower-case hexadecimal digits.
using RecordId = std::string;
using LearnerId = RecordId;

/// A new id from the kernel's random numbers. Waits only if the machine has no entropy yet (early
/// boot).
[[nodiscard]] RecordId random_record_id();

/// True for 32 lower-case hexadecimal digits.
[[nodiscard]] bool is_record_id(const std::string& id) noexcept;

/// Milliseconds since 1970-01-01 00:00 UTC, by the machine's clock.
[[nodiscard]] std::int64_t utc_now_ms() noexcept;

/// The learner under whom answers from a file are kept; left out of a class's report.
inline constexpr const char* kSimulatedPupil = "simulated pupil";

/// A pupil under a nickname; a real name is never asked for.
struct Learner {
    LearnerId id;
    std::string nickname;  ///< 1 to 40 characters, see `checked_nickname`; unique
    std::int64_t enrolled_utc_ms = 0;

    bool operator==(const Learner&) const = default;
};

/// A lesson is begun. Its end is a record of its own.
struct SessionRecord {
    RecordId id;
    LearnerId learner;
    std::string lesson;          ///< the lesson's id, e.g. "gravity"
    std::string lesson_version;  ///< hash or version of the lesson's files, may be empty
    std::string level;           ///< CEFR level of the lesson, e.g. "A1"
    std::int64_t started_utc_ms = 0;
    std::vector<std::pair<std::string, std::string>>
        settings;  ///< e.g. force_limit_N -> 5; names unique

    bool operator==(const SessionRecord&) const = default;
};

/// What turned out in a session, kept with its settings; a name once a session.
struct SessionSetting {
    RecordId session;
    std::string name;  ///< not empty
    std::string value;

    bool operator==(const SessionSetting&) const = default;
};

/// How one device is set for one learner, one thing of it; the newest of a name counts.
struct HandSetting {
    RecordId id;
    LearnerId learner;
    std::string
        device;  ///< which one, as the program calls it; empty for what holds with every device
    std::string name;  ///< e.g. scale, not empty
    std::string value;
    std::int64_t kept_utc_ms = 0;

    bool operator==(const HandSetting&) const = default;
};

/// How a session came to its end.
enum class EndReason : std::uint8_t { finished, left, failed };

/// A session's end; a session has at most one, and none when the program was killed.
struct SessionEnd {
    RecordId session;
    std::int64_t ended_utc_ms = 0;
    EndReason reason = EndReason::finished;
    std::int32_t stars = 0;          ///< 0 to 3
    std::int32_t score = 0;          ///< points, any value
    std::int32_t level_reached = 1;  ///< the lesson's own level, from 1

    bool operator==(const SessionEnd&) const = default;
};

/// One error of form in an answer.
struct ErrorRecord {
    std::string code;  ///< ERRANT-like, e.g. "R:ADJ:FORM"; not empty
    std::string span;  ///< the learner's words, e.g. "most heavy"; empty when a word is missing
    std::string correction;  ///< what belongs there, e.g. "heaviest"; empty when a word is too many
    std::string
        point{};  ///< of grammar, e.g. "passive_voice"; empty in what was kept before points were
    bool target = false;  ///< in the form that the question teaches; false in older ones

    bool operator==(const ErrorRecord&) const = default;
};

/// One answer to one question, with its errors; all of it is kept or none.
struct AttemptRecord {
    RecordId id;
    RecordId session;
    std::string question;  ///< the question's id in the lesson
    std::int32_t attempt =
        1;             ///< 1 the first time; begins again at 1 when the question is asked anew
    std::string said;  ///< the learner's words
    bool understood = true;  ///< false: no template fitted, the learner was asked to say it again
    bool meaning_right = false;  ///< by the lesson's own verdict
    bool form_known = true;   ///< false: what heard it hears the meaning alone; true in older ones
    bool form_right = false;  ///< the form is known, and no error of form was found
    bool target_right =
        false;  ///< the form that the question teaches is known and right, whatever else is not
    double confidence = 1.0;  ///< of the recogniser, 0 to 1; 1 for what was typed
    std::string
        feedback{};  ///< what was answered: "recast", "moved_on" for who was let go on; empty in older ones
    std::string
        uptake{};  ///< to an invitation to say it once more: "repaired", "not_repaired"; else empty
    std::string slots;      ///< what was understood, as text: "thing=watermelon"
    double answer_s = 0.0;  ///< seconds from the question to the answer, finite, not negative
    std::int64_t said_utc_ms = 0;
    std::vector<ErrorRecord> errors;

    bool operator==(const AttemptRecord&) const = default;
};

/// Refuses what cannot be kept: ids that are no ids, empty names, numbers out of range. One
/// sentence.
[[nodiscard]] Expected<void> validate(const Learner& learner);
[[nodiscard]] Expected<void> validate(const SessionRecord& session);
[[nodiscard]] Expected<void> validate(const SessionSetting& setting);
[[nodiscard]] Expected<void> validate(const HandSetting& setting);
[[nodiscard]] Expected<void> validate(const SessionEnd& end);
[[nodiscard]] Expected<void> validate(const AttemptRecord& attempt);

}  // namespace fulcrum::runtime
