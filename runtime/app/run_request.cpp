#include "runtime/app/run_request.h"

#include "haptics/device/replay/recorded_traits.h"
#include "haptics/record/record_reader.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/speech/speech_parts.h"
#include "runtime/arms/dhd/dhd_port.h"
#include "runtime/files/line_program.h"
#include "runtime/lesson/simulated_pupil.h"
#include "runtime/lesson/talk.h"
#include "runtime/progress/guest_name.h"
#include "runtime/progress/store.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

namespace fulcrum::runtime {
namespace {

// By what the simulated hand plays.
Expected<void> choose_player(const Options& options, bool in_window, RunRequest& request) {
    if (!options.by) {
        return {};
    }
    const bool is_there =
        request.hand == HandKind::scripted || (in_window && options.hands.empty());
    const bool is_driven = !options.deeds.empty() && *options.by != PlayedBy::arm;
    if (!is_there || (in_window && !is_driven)) {
        return fail("--by says how a simulated hand plays, and there is none", "",
                    "add --headless, and give --hand a Lua file or nothing");
    }
    play_by(*options.by, request);
    return {};
}

// Each arm has a key of its own.
std::string key_file_of(const Options& options, std::size_t hand) {
    return hand == 0                          ? options.arm.key_file
           : hand <= options.more_keys.size() ? options.more_keys[hand - 1]
                                              : std::string();
}

// What was said of a real arm, for the process that serves it.
std::vector<std::string> words_for_arm(const ArmOptions& arm) {
    std::vector<std::string> words;
    const auto say = [&](const char* option, const std::string& value) {
        if (!value.empty()) {
            words.insert(words.end(), {option, value});
        }
    };
    say("--service-port", std::to_string(arm.service_port));
    say("--device", arm.device_id);
    say("--log", arm.log_file);
    say("--library", arm.library);
    if (arm.may_initialise) {
        words.emplace_back(kInitialiseOption);
    }
    return words;
}

// Whose hands: what was asked for, else the mouse in a window and the lesson's own simulated hands without.
Expected<void> choose_hands(const Options& options, bool in_window, RunRequest& request) {
    request.hands_there = in_window               ? HandsThere::desk
                          : options.hands.empty() ? HandsThere::simulated
                                                  : HandsThere::nobody;
    HandChoice& first = request;
    first.hand = in_window ? HandKind::mouse : HandKind::scripted;
    for (std::size_t i = 0; i < options.hands.size(); ++i) {
        auto choice = read_hand(options.hands[i], in_window, key_file_of(options, i));
        if (!choice) {
            return tl::unexpected(choice.error());
        }
        choice->arm_words = words_for_arm(options.arm);
        if (i == 0) {
            first = std::move(*choice);
        } else {
            request.more_hands.push_back(std::move(*choice));
        }
    }
    return check_shared(first, request.more_hands).and_then([&] {
        return choose_player(options, in_window, request);
    });
}

// Whose answers: a file's, the lesson's own when nobody could type, else the keyboard's.
Expected<void> choose_answers(const Options& options, bool in_window, RunRequest& request) {
    request.own_test = !in_window || options.by;
    request.learner = options.learner;
    request.guest = new_guest_name();
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
Expected<void> choose_hearing(const Places& places, const Options& options, RunRequest& request) {
    request.plan.partner = options.partner;
    request.plan.partner.gives_up = interrupted;
    request.plan.speech = options.speech;
    if (options.speech == SpeechInput::text) {
        if (options.hear.empty() && !options.sureness) {
            return {};
        }
        return fail(
            std::string(options.hear.empty() ? "--sure" : "--hear") + " without somebody who hears",
            "", "add --speech sphinx, or --speech exec:COMMAND");
    }
    if (options.speech == SpeechInput::sphinx) {
        if (auto why = why_no_sphinx()) {
            return tl::unexpected(std::move(*why));
        }
    }
    HearingOrder& hearing = request.plan.hearing;
    hearing.listen = options.listen;
    hearing.sureness = options.sureness;
    hearing.gives_up = interrupted;
    if (options.speech == SpeechInput::external) {
        hearing.words = shell_line(options.hearing);
    } else {
        hearing.words = {(places.helpers / kSphinxHelper).string()};
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

// A hand that keeps its own time needs real time; any other may have it, where nobody plays at a desk.
Expected<void> choose_clock(const Options& options, RunRequest& request) {
    if (options.real_time && request.by != PlayedBy::arm) {
        return fail("--real-time is not for a simulated player at a desk", "",
                    "leave --by out, or --real-time");
    }
    request.plan.live = request.plan.live || options.real_time || keeps_time(request);
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

bool keeps_time(const RunRequest& request) noexcept {
    return keeps_time(request.hand) ||
           std::ranges::any_of(request.more_hands,
                               [](const HandChoice& choice) { return keeps_time(choice.hand); });
}

Expected<std::vector<std::string>> settle_hands(const LessonDescription& lesson,
                                                RunRequest& request) {
    HandChoice& first = request;
    return settle_hands(lesson, {first, request.hands_there, request.by}, request.more_hands)
        .map([&](std::vector<std::string>&& told) {
            request.plan.n_hands = 1 + request.more_hands.size();
            return std::move(told);
        });
}

namespace {

// As it was written; a fact that is missing or no number leaves it.
template <class Number>
void read_number(const RecordHeader& header, const std::string& name, Number& value) {
    const auto text = find_fact(header, name);
    Number read = value;
    if (text &&
        std::from_chars(text->data(), text->data() + text->size(), read).ec == std::errc{} &&
        std::isfinite(static_cast<double>(read))) {
        value = read;
    }
}

// Who talked back in it, as it was then: what a program said stands in its notes.
void repeat_partner(const Record& record, PartnerOrder& partner) {
    const auto name = find_fact(record.header, kPartnerFact);
    if (!name || partner.is_given) {
        return;
    }
    partner.kind = *name == name_of(PartnerKind::none) ? PartnerKind::none : PartnerKind::recorded;
    for (const RecordEvent& event : record.events) {
        if (auto words = event.kind == RecordEventKind::note ? read_partner_note(event.text)
                                                             : std::nullopt) {
            words->time_s = event.time_s;
            partner.recorded.push_back(std::move(*words));
        }
    }
}

// Those that the record's walls were made for: of the first hand, and of others where it tells theirs.
WallHolders read_holders(const RecordHeader& header) {
    WallHolders holders;
    for (std::size_t i = 0; i <= header.more_hands.size(); ++i) {
        const std::string prefix = holder_prefix(i);
        WallHolder holder;
        const auto name = find_fact(header, prefix + kHolderFact);
        if (!name && i > 0) {
            break;
        }
        holder.name = name.value_or(holder.name);
        read_number(header, prefix + kHolderMassFact, holder.mass_kg);
        read_number(header, prefix + kHolderDampingFact, holder.damping_Ns_per_m);
        read_number(header, prefix + kHolderForceFact, holder.max_force_N);
        read_number(header, prefix + kHolderLinkFact, holder.link_s);
        holders.push_back(std::move(holder));
    }
    return holders;
}

}  // namespace

std::string holder_prefix(std::size_t hand) {
    return hand > 0 ? fact_prefix(hand) : std::string();
}

Expected<RunRequest> with_record(RunRequest request) {
    if (request.hand != HandKind::replay) {
        return request;
    }
    auto loaded = load_record(request.hand_file.string());
    if (loaded && loaded->samples.empty()) {
        return fail(
            "the record holds no round of the hand" + (loaded->cut_off ? ": " + loaded->fault : ""),
            request.hand_file.string(), "record the run again");
    }
    return std::move(loaded).map([&](Record&& record) {
        if (!request.seed_is_given) {
            read_number(record.header, "option.seed", request.seed);
        }
        read_number(record.header, "option.day", request.plan.day);
        double scale = 1.0;
        read_number(record.header, kScaleFact, scale);
        request.fit.scale = request.fit.scale.value_or(scale);
        if (const auto text = find_fact(record.header, kFeedbackFact)) {
            request.kept_feedback =
                dialogue::read_ladder_text(*text).value_or(dialogue::FeedbackLadder{});
        }
        repeat_partner(record, request.plan.partner);
        request.plan.holders = read_holders(record.header);
        // Who is not told otherwise repeats all hands.
        for (std::size_t i = request.more_hands.size(); i < record.more_hands.size(); ++i) {
            HandChoice repeated;
            repeated.hand = HandKind::replay;
            repeated.hand_file = request.hand_file;
            request.more_hands.push_back(std::move(repeated));
        }
        request.replayed = std::make_shared<const Record>(std::move(record));
        return std::move(request);
    });
}

RunRequest of_hand(const RunRequest& request, std::size_t hand) {
    RunRequest own = request;
    if (hand > 0) {
        const HandChoice& first = request;
        static_cast<HandChoice&>(own) = request.more_hands[hand - 1];
        own.more_hands[hand - 1] = first;
        own.fit = hand <= request.more_fits.size() ? request.more_fits[hand - 1] : HandFit{};
        own.replayed = nullptr;
    }
    return own;
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
    request.more_fits = options.more_fits;
    request.first_use = options.first_use;
    request.yield = options.yield;
    return choose_hands(options, in_window, request)
        .and_then([&] { return choose_answers(options, in_window, request); })
        .and_then([&] { return choose_hearing(places, options, request); })
        .and_then([&] { return choose_clock(options, request); })
        .map([&] { return std::move(request); });
}

}  // namespace fulcrum::runtime
