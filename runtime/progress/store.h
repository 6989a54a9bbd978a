// Where learners' progress is kept. Append-only: facts are added, never changed.
//
// A write that returned success is acknowledged: it is on the disk, and neither a killed process
// nor a power cut takes it away. (A store that writes on a thread of its own, `queued_store.h`, only
// takes a write in, in order, and acknowledges with `settle`.) A write that returned an error has an unknown outcome: repeating
// it with the same ids is safe, leaves one record, and on success acknowledges it. Repeating it
// with other content under the same id is refused.
//
// Thread: one thread at a time for a store; several stores, also of several programs, may share one
// database. Cost: a write waits for the disk (0.2 ms on an SSD, 10 ms and more on a spinning disk
// or an SD card).
#pragma once

#include "haptics/base/error.h"
#include "runtime/progress/class_list.h"
#include "runtime/progress/records.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// Which part of the progress is wanted; an empty field takes all.
struct ProgressFilter {
    std::string nickname;       ///< as `enrol` takes it
    std::string lesson;         ///< a lesson's id
    bool results_only = false;  ///< how sessions ended, without what was said in them
    bool each_guest = false;    ///< of a report: each guest stands there, else all as one
};

/// Everything that a filter matched, as it stood at one moment, each list in the order of its
/// writing. Learners who match but have not played (this lesson) are listed too.
struct ProgressData {
    std::vector<Learner> learners;
    std::vector<SessionRecord> sessions;
    std::vector<SessionEnd> ends;
    std::vector<AttemptRecord> attempts;
    std::vector<HandSetting> hands;  ///< of these learners, whatever the lesson
};

class ProgressStore {
  public:
    ProgressStore() = default;
    ProgressStore(const ProgressStore&) = delete;
    ProgressStore& operator=(const ProgressStore&) = delete;
    virtual ~ProgressStore() = default;

    /// False when nothing is kept (the null store): say so to the teacher.
    [[nodiscard]] virtual bool keeps() const noexcept = 0;

    /// The learner of this nickname, enrolled now, in NFC, if there is none: the one of that very name first, else one whose name is the
    /// same but for capitals, blanks and how its letters are composed. Refuses what `checked_nickname` refuses.
    [[nodiscard]] virtual Expected<Learner> enrol(std::string_view nickname) = 0;

    /// Keeps a learner under an id that the caller made. Refuses a nickname that another learner
    /// has.
    [[nodiscard]] virtual Expected<void> add_learner(const Learner& learner) = 0;

    /// Keeps the beginning of a session with its settings. The learner must be known.
    [[nodiscard]] virtual Expected<void> begin_session(const SessionRecord& session) = 0;

    /// Keeps what turned out in a session, beside its settings. The session must be known.
    [[nodiscard]] virtual Expected<void> add_setting(const SessionSetting& setting) = 0;

    /// Keeps how a device is set for a learner, beside what was kept before. The learner must be known.
    [[nodiscard]] virtual Expected<void> add_hand_setting(const HandSetting& setting) = 0;

    /// Keeps a session's end. The session must be known and have no other end.
    [[nodiscard]] virtual Expected<void> end_session(const SessionEnd& end) = 0;

    /// Keeps an attempt and its errors, together. The session must be known.
    /// Words that are no UTF-8 are mended and cut (see `kept_text`) rather than refused.
    [[nodiscard]] virtual Expected<void> add_attempt(const AttemptRecord& attempt) = 0;

    /// Reads one consistent picture. Cost: in proportion to what is kept.
    [[nodiscard]] virtual Expected<ProgressData> read(const ProgressFilter& filter) = 0;

    /// Keeps what is new of classes, all of it or none; their learners must be known. A store without classes refuses it.
    [[nodiscard]] virtual Expected<void> add_class_rows(const ClassRows& rows);

    /// All that is kept of classes; nothing in a store without them.
    [[nodiscard]] virtual Expected<ClassRows> read_classes() { return ClassRows{}; }

    /// For a store that keeps later: the first write that was taken in and could not be kept, since
    /// this was last asked. Never waits.
    [[nodiscard]] virtual std::optional<Error> take_trouble() { return std::nullopt; }

    /// For a store that keeps later: waits, at most `patience_s`, until each write that was taken in
    /// has been kept or refused. Success means that none still waits; one sentence tells how many do.
    [[nodiscard]] virtual Expected<void> settle(double /*patience_s*/) { return {}; }
};

/// Plays without keeping anything: checks what it is given, as a real store does, and forgets it.
/// Used when the database is damaged, newer than the program, or not to be reached.
[[nodiscard]] std::unique_ptr<ProgressStore> make_null_store();

}  // namespace fulcrum::runtime
