#include "runtime/lesson/learner_throat.h"

#include <array>
#include <charconv>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr double kLargestThroat = 2.0;

std::optional<double> throat_of(const std::string& text) {
    double throat = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), throat);
    const bool whole = read.ec == std::errc{} && read.ptr == text.data() + text.size();
    return whole && throat >= 1.0 && throat <= kLargestThroat ? std::optional(throat)
                                                              : std::nullopt;
}

}  // namespace

std::string throat_text(double throat) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", throat);
    return text.data();
}

std::optional<double> find_throat(const ProgressData& data, const LearnerId& learner) {
    std::optional<double> newest;
    for (const SessionRecord& session : data.sessions) {
        // Of one session what was heard comes behind what it began with.
        for (const auto& [name, value] : session.settings) {
            if (session.learner == learner && (name == kThroat || name == kThroatHeard)) {
                const auto throat = throat_of(value);
                newest = throat ? throat : newest;
            }
        }
    }
    return newest;
}

std::optional<double> read_throat(ProgressStore& store, const Learner& learner) {
    const auto data = store.read({learner.nickname, {}});
    return data ? find_throat(*data, learner.id) : std::nullopt;
}

}  // namespace fulcrum::runtime
