#include "runtime/progress/records.h"

#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sys/random.h>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kIdBytes = 16;
constexpr std::int32_t kMaxStars = 3;

Expected<void> check_id(const RecordId& id, const char* whose) {
    if (!is_record_id(id)) {
        return fail(std::string("the id of the ") + whose + " is not 32 hexadecimal digits", {},
                    "make it with random_record_id");
    }
    return {};
}

Expected<void> check_named(const std::string& text, const char* what) {
    if (text.empty()) {
        return fail(std::string("the ") + what + " has no name", {}, "give it one");
    }
    return {};
}

}  // namespace

RecordId random_record_id() {
    std::array<unsigned char, kIdBytes> bytes{};
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t got = getrandom(bytes.data() + filled, bytes.size() - filled, 0);
        if (got > 0) {
            filled += static_cast<std::size_t>(got);
        } else if (errno != EINTR) {
            std::abort();  // a kernel without random numbers: ids would collide
        }
    }
    constexpr const char* kDigits = "0123456789abcdef";
    RecordId id;
    for (const unsigned char byte : bytes) {
        id += kDigits[byte >> 4U];
        id += kDigits[byte & 0x0FU];
    }
    return id;
}

bool is_record_id(const std::string& id) noexcept {
    return id.size() == 2 * kIdBytes && std::all_of(id.begin(), id.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
}

std::int64_t utc_now_ms() noexcept {
    const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count();
}

Expected<void> validate(const Learner& learner) {
    return check_id(learner.id, "learner").and_then([&]() -> Expected<void> {
        const auto checked = checked_nickname(learner.nickname);
        if (!checked) {
            return tl::unexpected(checked.error());
        }
        if (*checked != learner.nickname) {
            return fail("the nickname begins or ends with a blank", {}, "take the blank away");
        }
        return {};
    });
}

Expected<void> validate(const SessionRecord& session) {
    std::set<std::string> names;
    for (const auto& [name, value] : session.settings) {
        if (!names.insert(name).second) {
            return fail("the session has the setting \"" + name + "\" twice", {}, "give it once");
        }
    }
    return check_id(session.id, "session")
        .and_then([&] { return check_id(session.learner, "session's learner"); })
        .and_then([&] { return check_named(session.lesson, "session's lesson"); });
}

Expected<void> validate(const SessionSetting& setting) {
    return check_id(setting.session, "setting's session").and_then([&] {
        return check_named(setting.name, "session's setting");
    });
}

Expected<void> validate(const HandSetting& setting) {
    return check_id(setting.id, "hand's setting")
        .and_then([&] { return check_id(setting.learner, "learner of the hand's setting"); })
        .and_then([&] { return check_named(setting.name, "hand's setting"); });
}

Expected<void> validate(const SessionEnd& end) {
    if (end.stars < 0 || end.stars > kMaxStars) {
        return fail("a session ended with " + std::to_string(end.stars) + " stars", {},
                    "give 0 to 3 stars");
    }
    if (end.level_reached < 1) {
        return fail("a session ended in level " + std::to_string(end.level_reached), {},
                    "count levels from 1");
    }
    return check_id(end.session, "ended session");
}

Expected<void> validate(const AttemptRecord& attempt) {
    if (attempt.attempt < 1) {
        return fail("an attempt has the number " + std::to_string(attempt.attempt), {},
                    "count attempts from 1");
    }
    if (!std::isfinite(attempt.answer_s) || attempt.answer_s < 0.0) {
        return fail("an attempt's time to answer is no time", {}, "give seconds from 0");
    }
    if (!(attempt.confidence >= 0.0 && attempt.confidence <= 1.0)) {
        return fail("an attempt's confidence is none", {}, "give it 0 to 1");
    }
    if (!attempt.form_known &&
        (attempt.form_right || attempt.target_right || !attempt.errors.empty())) {
        return fail("an attempt has a form that nobody heard", {},
                    "keep neither errors nor a right form of it");
    }
    for (const ErrorRecord& error : attempt.errors) {
        if (error.code.empty()) {
            return fail("an attempt has an error without a code", {}, "give each error a code");
        }
    }
    return check_id(attempt.id, "attempt")
        .and_then([&] { return check_id(attempt.session, "attempt's session"); })
        .and_then([&] { return check_named(attempt.question, "attempt's question"); });
}

}  // namespace fulcrum::runtime
