#include "tests/system/progress/workload.h"

#include <algorithm>
#include <random>

namespace fulcrum::runtime::test {

RecordId Workload::id(std::int64_t number) const {
    std::mt19937_64 random(seed_ * 1'000'003U + static_cast<std::uint64_t>(number));
    RecordId id;
    while (id.size() < 32) {
        id += "0123456789abcdef"[random() % 16];
    }
    return id;
}

Learner Workload::learner() const {
    return {id(0), "pupil " + std::to_string(seed_), 1};
}

SessionRecord Workload::session() const {
    return {id(1), id(0), "gravity", "v1", "A1", 2, {{"force_limit_N", "5"}}};
}

SessionEnd Workload::end() const {
    return {id(1), 3, EndReason::finished, 3, 42, 2};
}

AttemptRecord Workload::attempt(std::int64_t number) const {
    AttemptRecord attempt;
    attempt.id = id(number);
    attempt.session = id(1);
    attempt.question = "question " + std::to_string(number);
    attempt.said = std::string(static_cast<std::size_t>(number % 50) * 10, 'w');
    attempt.meaning_right = number % 2 == 0;
    attempt.answer_s = 0.1 * static_cast<double>(number);
    if (number % 3 == 0) {
        attempt.errors = {{"M:DET", "", "the"}, {"R:ADJ:FORM", "most heavy", "heaviest"}};
    }
    return attempt;
}

Expected<void> Workload::write(ProgressStore& store, std::int64_t number) const {
    if (number == 0) {
        return store.add_learner(learner());
    }
    if (number == 1) {
        return store.begin_session(session());
    }
    return number == records_ - 1 ? store.end_session(end()) : store.add_attempt(attempt(number));
}

std::set<std::int64_t> Workload::missing(const ProgressData& data,
                                         const std::set<std::int64_t>& numbers) const {
    const auto holds = [](const auto& list, const auto& record) {
        return std::find(list.begin(), list.end(), record) != list.end();
    };
    std::set<std::int64_t> missing;
    for (const std::int64_t number : numbers) {
        const bool there = number == 0              ? holds(data.learners, learner())
                           : number == 1            ? holds(data.sessions, session())
                           : number == records_ - 1 ? holds(data.ends, end())
                                                    : holds(data.attempts, attempt(number));
        if (!there) {
            missing.insert(number);
        }
    }
    return missing;
}

bool Workload::is_all_of(const ProgressData& data) const {
    std::set<std::int64_t> all;
    for (std::int64_t number = 0; number < records_; ++number) {
        all.insert(number);
    }
    return missing(data, all).empty() && data.learners.size() == 1 && data.sessions.size() == 1 &&
           data.ends.size() == 1 && data.attempts.size() == static_cast<std::size_t>(records_ - 3);
}

}  // namespace fulcrum::runtime::test
