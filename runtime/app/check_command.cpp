// fulcrum check: what is wrong with a lesson, found without a window and without a hand.
#include "haptics/collision/self_intersection.h"
#include "runtime/app/felt_notes.h"
#include "runtime/app/glosses.h"
#include "runtime/app/headless.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/kept_check.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/app/question_trials.h"
#include "runtime/app/quiet_run.h"
#include "runtime/app/shown_sentences.h"
#include "runtime/app/walled_work.h"
#include "runtime/lesson/free_english.h"
#include "runtime/lesson/list_notes.h"
#include "runtime/lesson/question_notes.h"
#include "runtime/scene/picture/grey_picture.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace fulcrum::runtime {
namespace {

/// How much of a lesson is played, under a virtual clock.
constexpr double kCheckedPlay_s = 600.0;
/// Who answers where it has no test of its own: every kind of answer shall come.
constexpr LearnerRates kErringLearner{0.3, 0.2, 0.1};
/// Who answers when it is played again: hints, what is felt again and solutions come, each of them.
constexpr LearnerRates kWrongLearner{1.0, 0.0, 0.0};

std::string at_line(int line) {
    return "lesson.lua:" + std::to_string(line) + ": ";
}

/// A surface with holes can be touched, so that is no mistake, but it may not feel as it looks. Models that come with the program
/// are passed over: whoever writes a lesson cannot mend them.
void add_mesh_notes(const Places& places, const std::filesystem::path& folder,
                    const LessonDescription& lesson, std::vector<std::string>& notes) {
    std::set<std::string> told;  // bodies of one model are alike
    for (const BodyDescription& body : lesson.bodies) {
        const BodyDescription felt = as_felt(body);
        const bool is_own = find_model(places, folder, felt.model).parent_path() == folder;
        if (!body.solid || !is_own || !told.insert(felt.model).second) {
            continue;
        }
        const auto mesh = load_solid_mesh(places, folder, felt);
        if (!mesh) {
            continue;  // the plan was compiled from the same file a moment ago
        }
        if (const MeshReport report = compute_full_mesh_report(*mesh); !report.is_sound()) {
            notes.push_back(at_line(felt.line) + felt.name + ": " + to_sentence(report));
        }
    }
}

/// A picture of one grey has no relief, so that is no mistake, but hardly what was meant.
void add_picture_notes(const LessonDescription& lesson, const std::filesystem::path& folder,
                       std::vector<std::string>& notes) {
    for (const MaterialDescription& material : lesson.materials) {
        if (material.image.empty()) {
            continue;
        }
        const auto picture = load_grey_picture(folder / material.image);
        if (picture && is_flat(*picture)) {
            notes.push_back(at_line(material.line) + material.image +
                            " is one grey all over, so nothing of it is felt; take a picture with "
                            "dark and light places.");
        }
    }
}

/// Two rigid bodies in one place burst apart as soon as they may move.
void add_place_notes(const LessonDescription& lesson, std::vector<std::string>& notes) {
    for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
        const BodyDescription& body = lesson.bodies[i];
        for (std::size_t j = 0; j < i; ++j) {
            const BodyDescription& other = lesson.bodies[j];
            const bool both = body.rigid && other.rigid && body.visible && other.visible;
            if (both && body.position_W == other.position_W) {
                notes.push_back(at_line(body.line) + body.name + " stands where " + other.name +
                                " of line " + std::to_string(other.line) +
                                " does; give one of them another `at`.");
            }
        }
    }
}

/// The Lua texts that stand in the lesson's own folder.
std::vector<LessonSource> own_sources(const LessonRun& run, const std::filesystem::path& folder) {
    std::vector<LessonSource> sources;
    for (const std::filesystem::path& path : run.process().files_read()) {
        if (path.parent_path() == folder) {
            std::ifstream file(path);
            sources.push_back(
                {path.filename().string(), {std::istreambuf_iterator<char>(file), {}}});
        }
    }
    return sources;
}

/// What can be seen before it plays, and is no mistake.
std::vector<std::string> notes_before_play(const Installation& installation, const LessonRun& run,
                                           const std::filesystem::path& folder,
                                           const std::vector<LessonSource>& own_files,
                                           const dialogue::FormCheck& check, StageTeller& stages) {
    const LessonDescription& lesson = run.description();
    std::vector<std::string> notes;
    stages.begin("models and pictures");
    add_mesh_notes(installation.places, folder, lesson, notes);
    add_picture_notes(lesson, folder, notes);
    add_place_notes(lesson, notes);
    for (const Language language : kHomeLanguages) {
        if (const auto words = read_lesson_words(folder, language); !words) {
            notes.push_back(to_sentence(words.error()));
        }
    }
    NoteSources sources;
    for (const LessonSource& file : own_files) {
        sources.texts.push_back(file.text);
    }
    sources.check = check;
    sources.begins = [&](const std::string& what) { stages.begin(what); };
    stages.begin("lists and questions");
    // What follows from a noun that is written as a name is not told again of each sentence.
    for (const auto& found :
         {list_notes(lesson), question_notes(with_small_nouns(lesson), sources)}) {
        notes.insert(notes.end(), found.begin(), found.end());
    }
    notes.insert(notes.end(), run.plan().notices.begin(), run.plan().notices.end());
    return notes;
}

/// The words that a learner of the lesson's level is taken to know, and those that it names, teaches or asks for: nouns of things, lists
/// of its questions and of what it knows. Nothing above A2, and of a room.
std::optional<dialogue::CommonWords> common_words(const Places& places,
                                                  const LessonDescription& lesson) {
    std::ifstream file(places.words / "common.txt");
    const std::string list{std::istreambuf_iterator<char>(file), {}};
    if (list.empty() || lesson.is_room || (lesson.level != "A1" && lesson.level != "A2")) {
        return std::nullopt;
    }
    dialogue::CommonWords common(list);
    for (const BodyDescription& body : lesson.bodies) {
        common.add(body.noun);
    }
    const auto add_lists = [&](const auto& asked) {
        for (const auto& [name, words] : asked.lists) {
            for (const std::string& word : words) {
                common.add(word);
            }
        }
    };
    std::ranges::for_each(lesson.questions, add_lists);
    std::ranges::for_each(lesson.knowledge, add_lists);
    return common;
}

/// What a check has come to.
struct Checked {
    std::string lesson;
    std::string level{};
    std::optional<dialogue::CommonWords> common{};  ///< nothing where no word is looked up
    std::size_t n_notes = 0;
    dialogue::FormCheck check{};  ///< empty where what it takes is not installed
    std::optional<ShownSentences> shown{};
    std::string said{};  ///< all lines

    /// Says each on the terminal; how many there were.
    std::size_t say_each(const std::vector<std::string>& notes) {
        for (const std::string& note : notes) {
            std::printf("%s\n", note.c_str());
            said += note + '\n';
        }
        std::fflush(stdout);  // what goes wrong later is told behind it
        return notes.size();
    }
};

/// Plays the lesson's own test; gives the exit code.
int check_as_meant(const Installation& installation, LessonRun& run,
                   const std::filesystem::path& folder, bool is_quick, Checked& checked,
                   StageTeller& stages) {
    checked.lesson = run.description().id;
    checked.level = run.description().level;
    checked.common = common_words(installation.places, run.description());
    if (auto check = open_english_review(things_of(run.description())); check) {
        checked.check = std::move(*check);
    }
    const std::vector<LessonSource> sources = own_sources(run, folder);
    checked.shown.emplace(sources).add_things(run.description());
    checked.shown->add_questions(run.description());
    const std::vector<std::string> notes =
        notes_before_play(installation, run, folder, sources, checked.check, stages);
    if (is_quick) {
        checked.n_notes = checked.say_each(notes);
        return 0;
    }
    stages.begin("the play");
    // What stands in functions is only known to be right when it runs.
    QuestionTrials trials(run);
    HeadlessSettings settings;
    settings.end_s = kCheckedPlay_s;
    settings.shows_prints = false;
    settings.after_frame = [&](double now_s) {
        trials.try_open_one(now_s);
        checked.shown->look(run.session().hud());
    };
    const auto outcome = run_headless(run, settings);
    if (!outcome || trials.failed()) {
        // What ends the play comes first: what else is told may follow from it.
        const int code = complain(trials.failed() ? *trials.failed() : outcome.error(), 1);
        checked.say_each(notes);
        return code;
    }
    checked.n_notes = checked.say_each(notes);
    const int line = run.description().tests.empty() ? 0 : run.description().tests.front().line;
    for (const Error& note :
         notes_of_felt(felt_times_of(run.hands()), line > 0 ? "lesson.lua:" + std::to_string(line)
                                                            : std::string("lesson.lua"))) {
        checked.n_notes += checked.say_each({to_sentence(note)});
    }
    if (interrupted()) {
        return interrupt_exit_code();
    }
    const auto take_answer = [&](const KnowledgeDescription& known, const std::string& answer) {
        checked.shown->add_answer(known.id, known.line, answer);
    };
    stages.begin("examples of what is said");
    if (const int unmet = tell_unmet_examples(run, take_answer); unmet != 0) {
        return unmet;
    }
    stages.begin("questions that were not asked in the play");
    trials.try_others();
    checked.n_notes += checked.say_each(trials.notes());
    return 0;
}

/// Plays it again with a learner who never knows, so that hints and what is felt again come too, and anything may happen at its end.
int check_with_errors(LessonRun& run, ShownSentences& shown) {
    HeadlessSettings settings;
    settings.end_s = kCheckedPlay_s;
    settings.shows_prints = false;
    settings.after_frame = [&](double /*now_s*/) { shown.look(run.session().hud()); };
    if (const auto outcome = run_headless(run, settings); !outcome) {
        return complain(outcome.error(), 1);
    }
    if (interrupted()) {
        return interrupt_exit_code();
    }
    const auto happened = try_events(run);
    return happened ? 0 : complain(happened.error(), 1);
}

int check_anew(const Installation& installation, const Options& options, Checked& checked,
               StageTeller& stages) {
    RunRequest request = quiet_request(options);
    request.learner_without_test = kErringLearner;
    stages.begin("loading");
    int code = with_run(installation, options, request, [&](LessonRun& run, const auto& folder) {
        return check_as_meant(installation, run, folder, options.quick, checked, stages);
    });
    if (code != 0 || interrupted()) {
        return code != 0 ? code : interrupt_exit_code();
    }
    if (!options.quick) {
        request.learner_rates = kWrongLearner;
        stages.begin("the play of a learner who never knows");
        code =
            with_run(installation, options, request, [&](LessonRun& run, const auto& /*folder*/) {
                return check_with_errors(run, *checked.shown);
            });
    }
    stages.begin("English");
    if (checked.common) {
        checked.n_notes +=
            checked.say_each(checked.shown->rare_words(*checked.common, checked.level));
    }
    const ShownReview review = checked.shown->review(checked.check);
    checked.n_notes += checked.say_each(review.notes);
    if (!review.unread.empty()) {
        checked.say_each(
            {"Nothing wrong is found in these, but a grammar could not read them; read them "
             "once more:"});
        checked.say_each(review.unread);
    }
    if (code == 0) {
        const std::string end = checked.n_notes == 0
                                    ? "no mistakes found."
                                    : std::string("it can be played, but see the ") +
                                          (checked.n_notes == 1 ? "sentence" : "sentences") +
                                          " above.";
        checked.say_each({checked.lesson + ": " + end +
                          (options.quick ? " It was not played; leave --quick away." : "")});
    }
    return code;
}

void say_again(const FoundBefore& found) {
    constexpr std::size_t kMost = 32;
    std::array<char, kMost> when{};
    std::tm parts{};
    (void)std::strftime(when.data(), when.size(), "%Y-%m-%d at %H:%M",
                        ::localtime_r(&found.at, &parts));
    std::printf(
        "%sThis was found on %s, and nothing has changed since; to look anew, add --again.\n",
        found.said.c_str(), when.data());
}

int check_all(const Installation& installation, const Options& options, StageTeller& stages) {
    Checked checked;
    const auto folder = find_lesson(installation.places, options.lesson);
    if (!folder || options.quick) {
        return check_anew(installation, options, checked, stages);
    }
    const KeptCheck kept(installation.places, *folder, options.site, default_check_cache_folder());
    if (const auto found = options.again ? std::nullopt : kept.read()) {
        say_again(*found);
        return 0;
    }
    const int code = check_anew(installation, options, checked, stages);
    if (code == 0 && !interrupted()) {
        kept.keep(checked.said);
    }
    return code;
}

}  // namespace

int check_command(const Installation& installation, const Options& options) {
    return run_walled(options.lesson, {}, [&](StageTeller& stages) {
        return check_all(installation, options, stages);
    });
}

}  // namespace fulcrum::runtime
