// A store for tests: it keeps what it is given in memory, unless it is told to refuse.
#pragma once

#include "runtime/progress/store.h"

#include <string>

namespace fulcrum::runtime::test {

class TestStore : public ProgressStore {
  public:
    [[nodiscard]] bool keeps() const noexcept override { return true; }
    [[nodiscard]] Expected<Learner> enrol(std::string_view nickname) override {
        (void)begin_write("enrol");
        return Learner{random_record_id(), std::string(nickname), utc_now_ms()};
    }
    [[nodiscard]] Expected<void> add_learner(const Learner& /*learner*/) override {
        return begin_write("learner");
    }
    [[nodiscard]] Expected<void> begin_session(const SessionRecord& session) override {
        return begin_write("session").map([&] { data.sessions.push_back(session); });
    }
    [[nodiscard]] Expected<void> add_setting(const SessionSetting& setting) override {
        return begin_write("setting").map([&] {
            if (!data.sessions.empty()) {
                data.sessions.back().settings.emplace_back(setting.name, setting.value);
            }
        });
    }
    [[nodiscard]] Expected<void> add_hand_setting(const HandSetting& setting) override {
        return begin_write(setting.name).map([&] { data.hands.push_back(setting); });
    }
    [[nodiscard]] Expected<void> end_session(const SessionEnd& end) override {
        return begin_write("end").map([&] { data.ends.push_back(end); });
    }
    [[nodiscard]] Expected<void> add_attempt(const AttemptRecord& attempt) override {
        return begin_write(attempt.question).map([&] { data.attempts.push_back(attempt); });
    }
    [[nodiscard]] Expected<ProgressData> read(const ProgressFilter& /*filter*/) override {
        return data;
    }

    ProgressData data;
    int refusals = 0;  ///< so many of the next writes are refused

  protected:
    /// Comes before each write, with what is written: an attempt's question, else its kind.
    virtual Expected<void> begin_write(const std::string& /*what*/) {
        if (refusals > 0) {
            --refusals;
            return fail("the disk is full");
        }
        return {};
    }
};

}  // namespace fulcrum::runtime::test
