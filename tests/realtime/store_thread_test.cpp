// The store's thread beside a lesson loop that hands in, looks for trouble, settles and leaves: for the thread sanitizer.
#include "runtime/progress/queued_store.h"

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

// Without any lock of its own: only the queue keeps the two threads apart.
class BareStore final : public ProgressStore {
  public:
    explicit BareStore(std::vector<AttemptRecord>& kept) : kept_(kept) {}
    [[nodiscard]] bool keeps() const noexcept override { return true; }
    [[nodiscard]] Expected<Learner> enrol(std::string_view nickname) override {
        ++writes_;
        return Learner{random_record_id(), std::string(nickname), 1};
    }
    [[nodiscard]] Expected<void> add_learner(const Learner&) override { return count(); }
    [[nodiscard]] Expected<void> begin_session(const SessionRecord&) override { return count(); }
    [[nodiscard]] Expected<void> add_setting(const SessionSetting&) override { return count(); }
    [[nodiscard]] Expected<void> add_hand_setting(const HandSetting&) override { return count(); }
    [[nodiscard]] Expected<void> end_session(const SessionEnd&) override { return count(); }
    [[nodiscard]] Expected<void> add_attempt(const AttemptRecord& attempt) override {
        if (++writes_ % 7 == 0) {
            return fail("the disk was busy");  // the second try goes well
        }
        kept_.push_back(attempt);
        return {};
    }
    [[nodiscard]] Expected<ProgressData> read(const ProgressFilter&) override {
        ProgressData data;
        data.attempts = kept_;
        return data;
    }

  private:
    Expected<void> count() {
        ++writes_;
        return {};
    }

    std::vector<AttemptRecord>& kept_;
    int writes_ = 0;
};

AttemptRecord numbered(int number) {
    AttemptRecord attempt;
    attempt.id = random_record_id();
    attempt.session = random_record_id();
    attempt.question = "q" + std::to_string(number);
    attempt.said = std::string(200, 'a');
    return attempt;
}

}  // namespace

TEST_CASE("store thread: hands in, reads, settles and ends without a race, and loses nothing") {
    constexpr int kRounds = 20;
    constexpr int kAttempts = 100;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<AttemptRecord> kept;
        std::vector<AttemptRecord> handed_in;
        {
            QueuedStore store(std::make_unique<BareStore>(kept));
            for (int i = 0; i < kAttempts; ++i) {
                handed_in.push_back(numbered(i));
                REQUIRE(store.add_attempt(handed_in.back()));
                CHECK_FALSE(store.take_trouble());
                CHECK(store.status().kept <= store.status().taken);
                if (i % 40 == 39) {
                    CHECK(store.read({})->attempts.size() == handed_in.size());
                    CHECK(store.enrol("Mina"));
                }
            }
            if (round % 2 == 0) {
                REQUIRE(store.settle(60.0));
                CHECK(store.status().kept == kAttempts);
            }
        }
        CHECK(kept == handed_in);
    }
}
