#include "runtime/progress/store.h"
#include "runtime/progress/text_rules.h"

namespace fulcrum::runtime {
namespace {

class NullStore final : public ProgressStore {
  public:
    [[nodiscard]] bool keeps() const noexcept override { return false; }

    [[nodiscard]] Expected<Learner> enrol(std::string_view nickname) override {
        return checked_nickname(nickname).map([](std::string name) {
            return Learner{random_record_id(), std::move(name), utc_now_ms()};
        });
    }
    [[nodiscard]] Expected<void> add_learner(const Learner& learner) override {
        return validate(learner);
    }
    [[nodiscard]] Expected<void> begin_session(const SessionRecord& session) override {
        return validate(session);
    }
    [[nodiscard]] Expected<void> add_setting(const SessionSetting& setting) override {
        return validate(setting);
    }
    [[nodiscard]] Expected<void> add_hand_setting(const HandSetting& setting) override {
        return validate(setting);
    }
    [[nodiscard]] Expected<void> end_session(const SessionEnd& end) override {
        return validate(end);
    }
    [[nodiscard]] Expected<void> add_attempt(const AttemptRecord& attempt) override {
        return validate(attempt);
    }
    [[nodiscard]] Expected<ProgressData> read(const ProgressFilter& /*filter*/) override {
        return ProgressData{};
    }
};

}  // namespace

Expected<void> ProgressStore::add_class_rows(const ClassRows& rows) {
    return validate(rows).and_then([]() -> Expected<void> {
        return fail("no class can be kept here", {}, "name another database with --db");
    });
}

std::unique_ptr<ProgressStore> make_null_store() {
    return std::make_unique<NullStore>();
}

}  // namespace fulcrum::runtime
