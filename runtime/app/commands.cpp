#include "runtime/app/commands.h"

#include "haptics/device/hid/hidapi/hidapi_bus.h"
#include "runtime/app/arm_search.h"
#include "runtime/app/device_list.h"
#include "runtime/app/felt_notes.h"
#include "runtime/app/headless.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/knob_errors.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/menu_screen.h"
#include "runtime/app/open_store.h"
#include "runtime/app/quiet_run.h"
#include "runtime/app/run_request.h"
#include "runtime/app/stage_clock.h"
#include "runtime/progress/database_path.h"
#include "runtime/progress/report.h"
#include "runtime/progress/report_csv.h"
#include "runtime/progress/report_text.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "runtime/scene/explain.h"
#include "runtime/scene/knobs.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace fulcrum::runtime {
namespace {

// What L:test{ expect = … } may name (kTestFacts), as text.
std::map<std::string, std::string> facts_of(LessonRun& run) {
    const SessionResult& result = run.session().result();
    return {{"finished", result.finished ? "true" : "false"},
            {"felt", was_felt(felt_times_of(run.hands())) ? "true" : "false"},
            {"stars", std::to_string(result.stars)},
            {"score", std::to_string(result.score)},
            {"level", std::to_string(result.level)},
            {"attempts", std::to_string(result.attempts)},
            {"caught", std::to_string(result.caught)},
            {"form_errors", std::to_string(result.form_errors)}};
}

int count_unmet(const LessonTestDescription& test, LessonRun& run) {
    const auto facts = facts_of(run);
    int unmet = 0;
    for (const auto& [name, value] : test.expect) {
        const auto fact = facts.find(name);
        const std::string is = fact == facts.end() ? "not known" : fact->second;
        if (is != value) {
            std::fprintf(stderr, "lesson.lua:%d: expected %s = %s, but it is %s.\n", test.line,
                         name.c_str(), value.c_str(), is.c_str());
            ++unmet;
        }
    }
    return unmet;
}

// The answers of a play that were not right, one sentence each: "lesson.lua:40: the answer "the egg" was marked wrong."
void name_wrong_answers(const LessonTestDescription& test, const std::vector<std::string>& talk) {
    for (const std::string& line : talk) {
        const std::size_t who = line.find("learner  ");
        const std::size_t verdict = line.rfind(" (");
        if (who == std::string::npos || verdict == std::string::npos || who > verdict) {
            continue;
        }
        const std::size_t begin = who + std::string_view("learner  ").size();
        const std::string marked = line.substr(verdict + 2, line.size() - verdict - 3);
        if (marked.starts_with("wrong") || marked == "not understood") {
            std::fprintf(stderr, "lesson.lua:%d: the answer \"%s\" was %s.\n", test.line,
                         line.substr(begin, verdict - begin).c_str(),
                         marked == "not understood" ? "not understood" : "marked wrong");
        }
    }
}

// What the test asks and the lesson knows nothing of; how many.
int tell_unknown_asked(LessonRun& run) {
    const LessonTestDescription& test = run.description().tests.front();
    const auto& known = run.session().knowledge();
    int unknown = 0;
    for (const std::string& said : test.say) {
        if (said.starts_with('?') && (!known || !known->find(said.substr(1)))) {
            std::fprintf(
                stderr,
                "lesson.lua:%d: the test asks \"%s\", and the lesson knows nothing that this "
                "asks for; add it to know.things or an L:knows, or take it out.\n",
                test.line, said.substr(1).c_str());
            ++unknown;
        }
    }
    return unknown;
}

tl::unexpected<Error> refuse_broken_off() {
    return fail("the play was broken off, so there are no figures of the whole of it", {},
                "let it come to its end, or give --seconds");
}

// Plays the lesson under the virtual clock, each stage timed, and then its loops alone once more for each knob of the plan. The lesson's
// prints would be in the way of the figures.
Expected<Analysis> measure_stages(LessonRun& run, const Places& places, const RunRequest& request,
                                  const std::optional<double>& end_s) {
    StageClock clock(run.plan());
    RunTape tape(traits_of(run.hands()));
    HeadlessSettings settings;
    settings.tape = &tape;
    settings.end_s = end_s;
    settings.clock = &clock;
    settings.shows_prints = false;
    run.haptic_loop().listen_to_rounds(&clock);
    const auto outcome = run_headless(run, settings);
    run.haptic_loop().listen_to_rounds(nullptr);
    if (!outcome) {
        return tl::unexpected(outcome.error());
    }
    if (outcome->interrupted) {
        return refuse_broken_off();
    }
    say(trouble_of(run, *outcome, true));
    if (!clock.hand_moved()) {
        std::fprintf(stderr,
                     "The hand stayed where it was, so little was done; give --hand FILE.lua.\n");
    }
    Analysis analysis = clock.finish(outcome->simulated_s, outcome->wall_s);
    analysis.knobs = measure_knobs(
        tape, run.plan(), place_at_first(run.description()),
        list_knobs(run.description(), run.plan(), tape.hands()),
        [&](const auto& change) { return run.compile_changed(places, request, change); });
    if (interrupted()) {
        return refuse_broken_off();
    }
    return analysis;
}

}  // namespace

int list_command(const Installation& installation) {
    for (const LessonCard& card : read_lesson_cards(installation.places)) {
        if (card.error.empty()) {
            std::printf("%-16s %-44s %-3s %3.0f min\n", card.name.c_str(), card.title.c_str(),
                        card.level.c_str(), card.minutes);
        } else {
            std::printf("%-16s %s\n", card.name.c_str(), card.error.c_str());
        }
    }
    return 0;
}

namespace {

// Files of simulated hands instead of those that the test names.
Expected<void> name_files(const Options& options, RunRequest& request) {
    for (std::size_t i = 0; i < options.hands.size(); ++i) {
        auto choice = read_hand(options.hands[i], false, {});
        if (!choice) {
            return tl::unexpected(choice.error());
        }
        const bool is_simulated = choice->hand == HandKind::scripted;
        if (!is_simulated && !(i > 0 && choice->hand == HandKind::none)) {
            return fail("a test is played by simulated hands", "--hand " + options.hands[i],
                        "give --hand a Lua file's name");
        }
        if (i == 0) {
            request.hand_file = choice->hand_file;
        } else {
            request.more_hands.push_back(std::move(*choice));
        }
    }
    return {};
}

// How many expectations of its first test the lesson did not meet, each told. Who errs by chance, or is less able, need not come to the score of
// the lesson's own test, but to its end.
int judge_test(LessonRun& run, bool errs, const std::vector<std::string>& talk) {
    LessonTestDescription test = run.description().tests.front();
    if (errs) {
        test.expect = {{"finished", "true"}};
    }
    int unmet = count_unmet(test, run);
    if (unmet != 0 && !errs) {
        name_wrong_answers(test, talk);
    }
    unmet += tell_unknown_asked(run);
    tell_felt(felt_times_of(run.hands()), "lesson.lua:" + std::to_string(test.line));
    return unmet;
}

// The lesson's own test, played by this; gives the exit code. `played`: whether it came to that.
int test_by(const Installation& installation, const Options& options, PlayedBy by, bool& played) {
    RunRequest request = quiet_request(options);
    request.hands_there = options.hands.empty() ? HandsThere::simulated : HandsThere::nobody;
    if (auto named = name_files(options, request); !named) {
        return complain(named.error(), 2);
    }
    request.seed = options.seed.value_or(request.seed);
    play_by(by, request);
    if (options.errors) {
        request.learner_rates = rates_of(*options.errors);
    }
    return with_run(installation, options, request, [&](LessonRun& run, const auto& folder) {
        if (run.description().tests.empty()) {
            return complain(
                {"the lesson has no test", (folder / "lesson.lua").string(), "add L:test { … }"},
                1);
        }
        played = true;
        HeadlessSettings settings;
        const auto desk = seat_player(run, request);
        settings.desk = desk.get();
        std::vector<std::string> talk;
        settings.talk = &talk;
        const auto outcome = run_headless(run, settings);
        if (!outcome) {
            return complain(outcome.error(), 1);
        }
        say(trouble_of(run, *outcome, false));
        // What an example says is true of what is there when the test's hand has played.
        if (const int unmet = guesses(by) ? 0 : tell_unmet_examples(run); unmet != 0) {
            return unmet;
        }
        const bool errs = options.errors || std::ranges::count(kSkilledPlayers, by) == 0;
        const int unmet = judge_test(run, errs, talk);
        std::printf("%s: %s by %s after %.1f s of play.\n", run.description().id.c_str(),
                    unmet == 0 ? "passed" : "failed", std::string(name_of(by)).c_str(),
                    outcome->simulated_s);
        return unmet == 0 ? 0 : 1;
    });
}

}  // namespace

int test_command(const Installation& installation, const Options& options) {
    bool played = true;
    if (options.by) {
        return test_by(installation, options, *options.by, played);
    }
    int worst = 0;
    for (const PlayedBy by : kSkilledPlayers) {
        played = false;
        worst = std::max(worst, test_by(installation, options, by, played));
        if (interrupted() || !played) {
            break;  // what cannot be played by one cannot be played by the others, and has been said
        }
    }
    return worst != 0 ? worst : interrupt_exit_code();
}

int explain_command(const Installation& installation, const Options& options) {
    if (!options.analyze && (options.seconds || !options.hands.empty() || !options.say.empty())) {
        return complain({"--hand, --say and --seconds are for a play", {}, "add --analyze"}, 2);
    }
    RunRequest request = quiet_request(options);
    if (options.analyze) {
        auto played = make_request(installation.places, options, false);
        if (!played) {
            return complain(played.error(), 2);
        }
        request = std::move(*played);
    }
    request.plan.picture = !options.headless;
    request.plan.sound = !options.headless && !options.mute;
    request.plan.record = !options.record.empty();
    // The record is built, so that its size and time can be told; what it says is nobody's.
    request.record_file = "/dev/null";
    return with_run(installation, options, request, [&](LessonRun& run, const auto& folder) {
        request.folder = folder;
        std::optional<Analysis> analysis;
        if (options.analyze) {
            auto measured = measure_stages(run, installation.places, request, options.seconds);
            if (!measured) {
                return complain(measured.error(), 1);
            }
            analysis = std::move(*measured);
        }
        std::string text = options.json ? explain_json(run.description(), run.plan(),
                                                       analysis ? &*analysis : nullptr)
                                        : explain(run.description(), run.plan());
        if (analysis && !options.json) {
            text += explain_costs(run.plan(), *analysis);
        }
        std::fputs(text.c_str(), stdout);
        return 0;
    });
}

int report_command(const Options& options) {
    std::string path = options.database;
    if (path.empty()) {
        const auto standard = default_database_path();
        if (!standard) {
            return complain(standard.error(), 2);
        }
        path = *standard;
    }
    SqliteStoreOptions only_look;
    only_look.create = false;
    const auto store = open_sqlite_store(path, only_look);
    if (!store) {
        return complain(store.error(), 2);
    }
    const auto report = make_report(
        **store,
        {.nickname = options.learner, .lesson = options.lesson, .each_guest = options.each_guest});
    if (!report) {
        return complain(report.error(), 2);
    }
    const std::string text = options.format == "csv" ? to_csv(*report) : to_text(*report);
    if (options.out.empty()) {
        std::fputs(text.c_str(), stdout);
        return 0;
    }
    std::ofstream file(options.out, std::ios::binary);
    file << text;
    if (!file.flush()) {
        return complain(
            {"the report cannot be written", options.out, "choose another file with --out"}, 2);
    }
    return 0;
}

int devices_command(const Options& options) {
    const auto bus = hid::make_hidapi_bus();
    auto entries = list_devices(bus->list(), display_available());
    std::ranges::move(find_makers_arms(), std::back_inserter(entries));
    const std::string text = options.json ? devices_json(entries) : devices_text(entries);
    std::fputs(text.c_str(), stdout);
    if (const auto why = bus->why_never()) {
        say(to_sentence(*why));
    }
    return 0;
}

}  // namespace fulcrum::runtime
