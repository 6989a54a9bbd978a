// Progress written on a thread of its own: a loop that watches a hand or reads the emergency stop never waits for a disk.
//
//   add_attempt … --taken in, in order--> queue --its thread: the store behind, twice if need be--> kept, or refused
//
//   taken in   the write returned success. It stands in the queue and no more: a killed process loses it.
//   kept       the store behind has acknowledged it: a killed process does not lose it any more. `status` counts these,
//              and while none is refused they are the first that were taken in; `settle` waits until all are.
//   refused    tried twice in vain; `take_trouble` tells the first, and the next ones are tried all the same.
//
// What can never be kept (`validate`), or finds the queue full, is refused at once.
//
// Thread: one that calls, and its own; the store behind is used by one of them at a time.
// Cost: a write a copy and a lock held for as long; `enrol`, `read`, those of classes and `settle` wait for what was taken in before.
#pragma once

#include "runtime/progress/store.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <variant>

namespace fulcrum::runtime {

struct QueuedStoreSettings {
    std::size_t capacity =
        256;  ///< records that may wait, 1 to 65 536: what a class says in a quarter of an hour
    int tries = 2;  ///< of one record, 1 to 10: a write whose outcome is unknown may be repeated
    double patience_s = 15.0;  ///< `enrol`, `read` and the end wait so long at most, 0 to 600
};

/// How far the thread has come; `taken - kept - refused` records wait.
struct QueuedStoreStatus {
    std::uint64_t taken = 0;
    std::uint64_t kept = 0;
    std::uint64_t refused = 0;
};

class QueuedStore final : public ProgressStore {
  public:
    /// Takes the store and starts the thread. Settings out of range are brought into it.
    explicit QueuedStore(std::unique_ptr<ProgressStore> behind, QueuedStoreSettings settings = {});
    /// Waits for what was taken in, as long as its patience; what waits then is lost. To hear of that, `settle` before.
    ~QueuedStore() override;

    [[nodiscard]] bool keeps() const noexcept override { return keeps_; }
    [[nodiscard]] Expected<Learner> enrol(std::string_view nickname) override;
    [[nodiscard]] Expected<void> add_learner(const Learner& learner) override;
    [[nodiscard]] Expected<void> begin_session(const SessionRecord& session) override;
    [[nodiscard]] Expected<void> add_setting(const SessionSetting& setting) override;
    [[nodiscard]] Expected<void> add_hand_setting(const HandSetting& setting) override;
    [[nodiscard]] Expected<void> end_session(const SessionEnd& end) override;
    [[nodiscard]] Expected<void> add_attempt(const AttemptRecord& attempt) override;
    [[nodiscard]] Expected<ProgressData> read(const ProgressFilter& filter) override;
    [[nodiscard]] Expected<void> add_class_rows(const ClassRows& rows) override;
    [[nodiscard]] Expected<ClassRows> read_classes() override;

    [[nodiscard]] std::optional<Error> take_trouble() override;
    [[nodiscard]] Expected<void> settle(double patience_s) override;
    [[nodiscard]] QueuedStoreStatus status() const;

  private:
    using Record = std::variant<Learner, SessionRecord, SessionSetting, HandSetting, SessionEnd,
                                AttemptRecord>;

    template <class R>
    Expected<void> take_in(const R& record);
    void run();
    [[nodiscard]] Expected<void> write(const Record& record);

    std::unique_ptr<ProgressStore> behind_;  // the thread's while anything waits, else the caller's
    QueuedStoreSettings settings_;
    bool keeps_;

    mutable std::mutex mutex_;  // guards what follows; never held while the disk is waited for
    std::condition_variable changed_;  // something was taken in, came to its end, or all ends
    std::deque<Record> waiting_;       // the first one is being written
    QueuedStoreStatus status_{};
    std::optional<Error> trouble_;
    bool ending_ = false;

    std::thread thread_;  // last: it begins when all else is there
};

}  // namespace fulcrum::runtime
