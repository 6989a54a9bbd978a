#include "runtime/lesson/past_answers.h"

#include "runtime/lua/wire/wire_limits.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kMillisecondsADay = 86'400'000.0;

/// One question while its attempts are counted.
struct Count {
    PastAnswers past;
    std::int64_t last_utc_ms = 0;
    std::string session;     // of the last attempt
    bool was_right = false;  // the last attempt of this asking
    std::map<std::string, std::int32_t> points;
};

void count_attempt(const AttemptRecord& attempt, Count& count) {
    const bool asked_anew = attempt.attempt <= 1 || attempt.session != count.session;
    if (asked_anew) {
        ++count.past.asked;
        count.was_right = false;
    }
    if (attempt.meaning_right && !count.was_right) {
        ++count.past.right;
        count.was_right = true;
    }
    count.past.wrong_now = attempt.meaning_right ? 0 : count.past.wrong_now + 1;
    count.session = attempt.session;
    count.last_utc_ms = std::max(count.last_utc_ms, attempt.said_utc_ms);
    for (const ErrorRecord& error : attempt.errors) {
        if (!error.point.empty()) {
            ++count.points[error.point];
        }
    }
}

bool is_told(const std::string& text) {
    return text.size() <= kMaxTextBytes && is_clean_utf8(text);
}

}  // namespace

std::vector<PastAnswers> find_past_answers(const ProgressData& data, const LearnerId& learner,
                                           std::int64_t now_utc_ms) {
    std::map<std::string, std::string> lesson_of;  // session -> lesson
    for (const SessionRecord& session : data.sessions) {
        if (session.learner == learner) {
            lesson_of[session.id] = session.lesson;
        }
    }
    std::map<std::pair<std::string, std::string>, Count> counts;
    for (const AttemptRecord& attempt : data.attempts) {
        const auto lesson = lesson_of.find(attempt.session);
        if (lesson != lesson_of.end()) {
            count_attempt(attempt, counts[{lesson->second, attempt.question}]);
        }
    }
    std::vector<Count> all;
    for (auto& [name, count] : counts) {
        count.past.lesson = name.first;
        count.past.question = name.second;
        count.past.days =
            std::max(0.0, static_cast<double>(now_utc_ms - count.last_utc_ms) / kMillisecondsADay);
        for (const auto& point : count.points) {
            if (is_told(point.first) && count.past.points.size() < kMaxListItems) {
                count.past.points.push_back(point);
            }
        }
        // What no lesson can be told, by a damaged database, is left out.
        if (is_told(name.first) && is_told(name.second)) {
            all.push_back(std::move(count));
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const Count& one, const Count& other) {
        return one.last_utc_ms < other.last_utc_ms;
    });
    const std::size_t left_out = all.size() - std::min(all.size(), kMaxPastAnswers);
    std::vector<PastAnswers> past;
    std::transform(std::make_move_iterator(all.begin()) + static_cast<std::ptrdiff_t>(left_out),
                   std::make_move_iterator(all.end()), std::back_inserter(past),
                   [](Count&& count) { return std::move(count.past); });
    return past;
}

Expected<std::vector<PastAnswers>> read_past_answers(ProgressStore& store, const Learner& learner,
                                                     std::int64_t now_utc_ms) {
    return store.read({learner.nickname, {}}).map([&](const ProgressData& data) {
        return find_past_answers(data, learner.id, now_utc_ms);
    });
}

}  // namespace fulcrum::runtime
