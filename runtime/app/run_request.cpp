#include "runtime/app/run_request.h"

#include "haptics/device/replay/recorded_traits.h"
#include "runtime/lesson/simulated_pupil.h"
#include "runtime/progress/store.h"

#include <charconv>
#include <chrono>
#include <cstdio>
#include <random>
#include <string_view>
#include <system_error>

namespace fulcrum::runtime {
namespace {

Expected<void> choose_hid(const std::string& word, RunRequest& request) {
    request.hand = HandKind::hid;
    return choose_hid_hand(word).map([&](HidChoice&& choice) { request.hid = std::move(choice); });
}

// By what the simulated hand plays.
Expected<void> choose_player(const Options& options, bool in_window, RunRequest& request) {
    if (!options.by) {
        return {};
    }
    if (in_window || request.hand != HandKind::scripted) {
        return fail("--by says how a simulated hand plays, and there is none", "",
                    "add --headless, and give --hand a Lua file or nothing");
    }
    play_by(*options.by, request);
    return {};
}

// Whose hand: what was asked for, else the mouse in a window and the lesson's own simulated hand without.
Expected<void> choose_hand(const Options& options, bool in_window, RunRequest& request) {
    constexpr std::string_view kReplay = "replay:";
    constexpr std::string_view kLink = "udp:";
    if (options.hand.starts_with(kReplay)) {
        request.hand = HandKind::replay;
        request.hand_file = options.hand.substr(kReplay.size());
        std::error_code error;
        if (!std::filesystem::is_regular_file(request.hand_file, error)) {
            return fail("there is no such record", request.hand_file.string(),
                        "give --hand replay: a file that --record wrote");
        }
    } else if (asks_for_hid(options.hand)) {
        return choose_hid(options.hand, request);
    } else if (options.hand.starts_with(kLink)) {
        request.hand = HandKind::link;
        request.hand_address = options.hand.substr(kLink.size());
        request.key_file = options.arm.key_file;
    } else if (options.hand == "mouse" || (options.hand.empty() && in_window)) {
        request.hand = HandKind::mouse;
    } else if (!options.hand.empty() && !options.hand.ends_with(".lua")) {
        return fail("there is no hand \"" + options.hand + "\"", "",
                    "give --hand mouse, hid, udp:HOST:PORT, replay:FILE, or a Lua file's name");
    } else {
        request.hand_file = options.hand;
    }
    if (!in_window && request.hand == HandKind::mouse) {
        return fail("there is no mouse without a window", "",
                    "leave --hand out, give it a hand's file, or add --by mouse");
    }
    return choose_player(options, in_window, request);
}

// Whose answers: a file's, the lesson's own when nobody could type, else the keyboard's.
Expected<void> choose_answers(const Options& options, bool in_window, RunRequest& request) {
    request.own_test = !in_window;
    request.learner = options.learner;
    if (options.errors) {
        request.learner_rates = rates_of(*options.errors);
    }
    if (!options.say.empty()) {
        const auto lines = SimulatedPupil::read_lines(options.say);
        if (!lines) {
            return tl::unexpected(lines.error());
        }
        if (lines->empty()) {
            return fail("there are no answers in this file", options.say, "write one a line");
        }
        request.say = *lines;
    }
    const bool has_answers =
        !request.say.empty() || request.learner_rates.has_value() || !options.hear.empty();
    if (in_window || (has_answers && !request.learner.empty())) {
        return {};
    }
    if (!request.learner.empty()) {
        std::fprintf(stderr,
                     "The answers are the lesson's own, so they are kept for the %s, not for %s.\n",
                     kSimulatedPupil, request.learner.c_str());
    }
    request.learner = kSimulatedPupil;
    return {};
}

// Which program hears, and what.
Expected<void> choose_hearing(const Options& options, RunRequest& request) {
    request.plan.speech = options.speech;
    if (options.speech == SpeechInput::text) {
        return options.hear.empty()
                   ? Expected<void>{}
                   : Expected<void>(fail("--hear without somebody who hears", "",
                                         "add --speech sphinx, or --speech exec:COMMAND"));
    }
    HearingOrder& hearing = request.plan.hearing;
    hearing.listen = options.listen;
    if (options.speech == SpeechInput::external) {
        hearing.words = {"/bin/sh", "-c", options.hearing};
    } else {
        std::error_code error;
        const auto own = std::filesystem::read_symlink("/proc/self/exe", error);
        hearing.words = {(own.parent_path() / "fulcrum-sphinx").string()};
        hearing.takes_throat = true;
        hearing.throat = options.throat.value_or(0.0);
    }
    if (options.hear.empty()) {
        return {};
    }
    const auto lines = SimulatedPupil::read_lines(options.hear);
    if (!lines) {
        return tl::unexpected(lines.error());
    }
    // Names are from where the list lies.
    const auto folder = std::filesystem::path(options.hear).parent_path();
    for (const std::string& line : *lines) {
        hearing.recordings.push_back((folder / line).string());
    }
    return {};
}

// Days since noon of 1 January 2000, of Greenwich.
double today() {
    constexpr std::chrono::sys_days kFirst{std::chrono::year{2000} / 1 / 1};
    const std::chrono::duration<double, std::ratio<86400>> since =
        std::chrono::system_clock::now() - (kFirst + std::chrono::hours(12));
    return since.count();
}

}  // namespace

const char* how_to_move(const RunRequest& request, bool has_reel, bool left_handed) noexcept {
    if (request.hand == HandKind::hid) {
        return request.hid.form == hid::HandForm::space_mouse ? "hud.cap_help" : "hud.stick_help";
    }
    return has_reel ? "hud.reel_help" : left_handed ? "hud.left_mouse_help" : "hud.mouse_help";
}

Expected<RunRequest> with_record(RunRequest request) {
    if (request.hand != HandKind::replay) {
        return request;
    }
    return load_record(request.hand_file.string()).map([&](Record&& record) {
        const auto number = [&](const char* name, auto& value) {
            if (const auto text = find_fact(record.header, name)) {
                auto read = value;
                if (std::from_chars(text->data(), text->data() + text->size(), read).ec ==
                    std::errc{}) {
                    value = read;
                }
            }
        };
        if (!request.seed_is_given) {
            number("option.seed", request.seed);
        }
        number("option.day", request.plan.day);
        double scale = 1.0;
        number("option.scale", scale);
        request.fit.scale = request.fit.scale.value_or(scale);
        request.replayed = std::make_shared<const Record>(std::move(record));
        return std::move(request);
    });
}

bool repeats_input(const RunRequest& request) noexcept {
    constexpr std::uint32_t kFirstThatTells = 5;
    return request.replayed != nullptr && request.replayed->version >= kFirstThatTells &&
           request.say.empty() && !request.learner_rates && request.plan.hearing.recordings.empty();
}

void play_by(PlayedBy by, RunRequest& request) {
    request.by = by;
    request.hand = by == PlayedBy::arm ? HandKind::scripted : HandKind::mouse;
}

LearnerRates rates_of(double errors) {
    return {.wrong = errors / 3.0, .form = errors / 2.0, .unclear = errors / 6.0};
}

Expected<RunRequest> make_request(const Places& places, const Options& options, bool in_window) {
    RunRequest request;
    const auto folder = find_lesson(places, options.lesson);
    if (!folder) {
        return tl::unexpected(folder.error());
    }
    request.folder = *folder;
    request.plan.site = options.site;
    request.plan.picture = in_window || !options.screenshot.empty();
    request.plan.sound = in_window && !options.mute;
    request.plan.record = !options.record.empty();
    request.plan.live = in_window;
    request.plan.day = in_window ? today() : kTestDay;
    request.seed = options.seed.value_or(in_window ? std::random_device{}() : request.seed);
    request.seed_is_given = options.seed.has_value();
    request.record_file = options.record;
    request.feedback = options.feedback;
    request.fit = options.fit;
    request.first_use = options.first_use;
    return choose_hand(options, in_window, request)
        .and_then([&] { return choose_answers(options, in_window, request); })
        .and_then([&] { return choose_hearing(options, request); })
        .map([&] { request.plan.live = request.plan.live || keeps_time(request.hand); })
        .map([&] { return std::move(request); });
}

}  // namespace fulcrum::runtime
