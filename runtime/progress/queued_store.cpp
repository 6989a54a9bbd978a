#include "runtime/progress/queued_store.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kLongestPatience_s = 600.0;

double bounded(double patience_s) {
    return std::isfinite(patience_s) ? std::clamp(patience_s, 0.0, kLongestPatience_s) : 0.0;
}

QueuedStoreSettings bounded(QueuedStoreSettings settings) {
    settings.capacity = std::clamp<std::size_t>(settings.capacity, 1, 65536);
    settings.tries = std::clamp(settings.tries, 1, 10);
    settings.patience_s = bounded(settings.patience_s);
    return settings;
}

Expected<void> write_to(ProgressStore& store, const Learner& learner) {
    return store.add_learner(learner);
}
Expected<void> write_to(ProgressStore& store, const SessionRecord& session) {
    return store.begin_session(session);
}
Expected<void> write_to(ProgressStore& store, const SessionSetting& setting) {
    return store.add_setting(setting);
}
Expected<void> write_to(ProgressStore& store, const HandSetting& setting) {
    return store.add_hand_setting(setting);
}
Expected<void> write_to(ProgressStore& store, const SessionEnd& end) {
    return store.end_session(end);
}
Expected<void> write_to(ProgressStore& store, const AttemptRecord& attempt) {
    return store.add_attempt(attempt);
}

tl::unexpected<Error> many(std::size_t records, const std::string& what) {
    return fail(std::to_string(records) + (records == 1 ? " record" : " records") +
                    " of the learner's progress " + what,
                "", "look whether the disk is full or another program holds the database");
}

}  // namespace

QueuedStore::QueuedStore(std::unique_ptr<ProgressStore> behind, QueuedStoreSettings settings)
    : behind_(std::move(behind)),
      settings_(bounded(settings)),
      keeps_(behind_->keeps()),
      thread_([this] { run(); }) {}

QueuedStore::~QueuedStore() {
    (void)settle(settings_.patience_s);
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

template <class R>
Expected<void> QueuedStore::take_in(const R& record) {
    return validate(record).and_then([&]() -> Expected<void> {
        const std::lock_guard lock(mutex_);
        if (waiting_.size() >= settings_.capacity) {
            return many(waiting_.size(), "wait for the disk, and the next one finds no room");
        }
        waiting_.emplace_back(record);
        ++status_.taken;
        changed_.notify_all();
        return {};
    });
}

Expected<void> QueuedStore::add_learner(const Learner& learner) {
    return take_in(learner);
}
Expected<void> QueuedStore::begin_session(const SessionRecord& session) {
    return take_in(session);
}
Expected<void> QueuedStore::add_setting(const SessionSetting& setting) {
    return take_in(setting);
}
Expected<void> QueuedStore::add_hand_setting(const HandSetting& setting) {
    return take_in(setting);
}
Expected<void> QueuedStore::end_session(const SessionEnd& end) {
    return take_in(end);
}
Expected<void> QueuedStore::add_attempt(const AttemptRecord& attempt) {
    return take_in(attempt);
}

// The thread: one record after the other, as long as the program wants it.
void QueuedStore::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return !waiting_.empty() || ending_; });
        if (ending_) {
            return;
        }
        const Record& record = waiting_.front();  // stays where it is when others come in behind
        lock.unlock();
        const Expected<void> written = write(record);
        lock.lock();
        waiting_.pop_front();
        ++(written ? status_.kept : status_.refused);
        if (!written && !trouble_) {
            trouble_ = written.error();
        }
        changed_.notify_all();
    }
}

Expected<void> QueuedStore::write(const Record& record) {
    Expected<void> written = fail("nothing was written");
    for (int i = 0; i < settings_.tries && !written; ++i) {
        written = std::visit([this](const auto& r) { return write_to(*behind_, r); }, record);
    }
    return written;
}

Expected<void> QueuedStore::settle(double patience_s) {
    std::unique_lock lock(mutex_);
    const bool settled = changed_.wait_for(lock, std::chrono::duration<double>(bounded(patience_s)),
                                           [this] { return waiting_.empty(); });
    return settled ? Expected<void>{} : many(waiting_.size(), "still wait for the disk");
}

// While nothing waits the thread leaves the store alone, and only the caller could hand it more.
Expected<Learner> QueuedStore::enrol(std::string_view nickname) {
    return settle(settings_.patience_s).and_then([&] { return behind_->enrol(nickname); });
}

Expected<ProgressData> QueuedStore::read(const ProgressFilter& filter) {
    return settle(settings_.patience_s).and_then([&] { return behind_->read(filter); });
}

Expected<void> QueuedStore::add_class_rows(const ClassRows& rows) {
    return settle(settings_.patience_s).and_then([&] { return behind_->add_class_rows(rows); });
}

Expected<ClassRows> QueuedStore::read_classes() {
    return settle(settings_.patience_s).and_then([&] { return behind_->read_classes(); });
}

std::optional<Error> QueuedStore::take_trouble() {
    const std::lock_guard lock(mutex_);
    return std::exchange(trouble_, std::nullopt);
}

QueuedStoreStatus QueuedStore::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

}  // namespace fulcrum::runtime
