#include "dialogue/marking/mark_answer.h"
#include "runtime/lesson/first_use.h"
#include "runtime/lesson/free_english.h"
#include "runtime/lesson/knowledge.h"
#include "runtime/lesson/list_notes.h"
#include "runtime/lesson/question_notes.h"
#include "runtime/lesson/questions.h"
#include "runtime/lesson/sentence_form.h"
#include "tests/support/table.h"
#include "tests/unit/runtime/lesson/question_states.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

using Probe = TableReader::Probe;
using Slots = std::vector<std::pair<std::string, std::string>>;

constexpr const char* kSounds =
    "the DH AH\nis IH Z\nheavy HH EH V IY\negg EH G\napple AE P AH L\nthings TH IH NG Z\n"
    "thighs TH AY Z\n";

const dialogue::Catalogue& words_of_knowledge() {
    static const auto kWords = value_of(dialogue::Catalogue::parse(
        "knowledge.recast = We say: {sentence} {answer}\nknowledge.unknown = No. Ask: {example}\n"
        "knowledge.not_known = No.\n"));
    return kWords;
}

/// "thing: a, b|c; other: d"
std::vector<std::pair<std::string, std::string>> named(const std::string& text) {
    std::vector<std::pair<std::string, std::string>> parts;
    for (const std::string& part : listed(text, "; ")) {
        const std::size_t colon = part.find(": ");
        parts.emplace_back(part.substr(0, colon), part.substr(colon + 2));
    }
    return parts;
}

std::string of_slots(const Slots& slots) {
    std::string all;
    for (const auto& [name, value] : slots) {
        all += ' ' + name + '=' + value;
    }
    return all;
}

// Tables (tests/support/table.h) of what a lesson's questions and its knowledge make of words. What they are of stands above:
//
//   @law NAME           of two things again     @lesson questions, planets or bare
//   @answers A || B     @lists thing: a, b|c; other: d     @rules place: (on|under) it     @again Weigh them.
//   @known colour: what colour is it || …     one thing more that it knows     @nearly of the last of these
//   @bodies it: Stone; earth: Earth           @sounds of the words below     @tries 4
class Scene {
  public:
    LessonDescription lesson = two_things();
    NoteSources sources{{}, "/nowhere"};

    void read(const std::string& word, const std::string& rest) {
        QuestionDescription* question =
            lesson.questions.empty() ? nullptr : &lesson.questions.front();
        if (word == "lesson") {
            describe(rest);
        } else if (word == "answers") {
            question->answers = listed(rest, " || ");
        } else if (word == "lists") {
            auto& lists =
                lesson.knowledge.empty() ? question->lists : lesson.knowledge.back().lists;
            lists.clear();
            for (const auto& [name, list] : named(rest)) {
                lists.emplace_back(name, listed(list));
            }
        } else if (word == "rules") {
            (lesson.knowledge.empty() ? question->rules : lesson.knowledge.back().rules) =
                named(rest);
        } else if (word == "again") {
            question->again = rest;
        } else if (word == "tries") {
            lesson.tries = std::stoi(rest);
        } else if (word == "nearly") {
            lesson.knowledge.back().nearly = listed(rest, " || ");
        } else if (word == "known") {
            const auto [id, asked] = named(rest).at(0);
            const auto line = static_cast<int>(7 + 2 * lesson.knowledge.size());
            lesson.knowledge.push_back({id, listed(asked, " || "), {}, line});
        } else if (word == "bodies") {
            lesson.bodies.clear();
            for (const auto& [name, noun] : named(rest)) {
                lesson.bodies.push_back(thing(name, 0.1));
                lesson.bodies.back().noun = noun;
                lesson.bodies.back().line = static_cast<int>(2 + lesson.bodies.size());
            }
        } else if (word == "sounds") {
            folder_->write("sounds", kSounds);
            sources.heard_words = folder_->file("sounds");
        } else {
            REQUIRE(word == "law");
            describe("two");
        }
    }

  private:
    std::shared_ptr<ScratchFolder> folder_ = std::make_shared<ScratchFolder>();

    void describe(const std::string& name) {
        sources = {{}, "/nowhere"};
        lesson = name == "questions" ? two_questions() : two_things();
        if (name == "planets" || name == "bare") {
            lesson = {};
            lesson.bodies = {thing("apple", 0.2)};
        }
        if (name == "bare") {
            lesson.bodies.clear();
            lesson.questions.resize(1);
            lesson.questions[0].id = "which";
            lesson.questions[0].line = 4;
        }
    }
};

/// "thing=egg, misformed".
std::string slots_in(const Scene& scene, const std::string& said) {
    const dialogue::Mark mark =
        dialogue::mark_answer(value_of(compile_questions(scene.lesson)).at("heaviest"), said);
    return mark.understood
               ? "understood" + of_slots(mark.slots) + (mark.form_right() ? "" : ", misformed")
               : "not understood";
}

template <class Compiled>
std::string refused(const Compiled& compiled) {
    return compiled ? "compiles" : refusal_of(compiled);
}

/// Of the answers that go in, after what stands above.
std::string notes(const Scene& scene) {
    const auto notes = question_notes(scene.lesson, scene.sources);
    return notes.empty() ? "nothing" : spaced(notes, "\n");
}

/// "moons planet=Mars: We say: …".
std::string known(const Scene& scene, const std::string& said, const std::string& with) {
    const Knowledge knowledge =
        value_of(value_of(Knowledge::compile(scene.lesson, words_of_knowledge())));
    const auto asked = knowledge.find(said, with != "unformed");
    return asked ? asked->knowledge + of_slots(asked->mark.slots) + ": " +
                       knowledge.told(*asked, with == "nothing" ? "" : "Two.")
                 : "nothing";
}

// What the lesson is told in a play, and what the learner sees at its end.
// A play's steps stand between ";", and what the lesson does at once between "&":
//
//   ask; say the apple is the heaviest; right => judge heaviest thing=apple, right thing=apple over; Yes!; closed; kept R
class Script {
  public:
    explicit Script(const LessonDescription& lesson) : play_(lesson) { look(play_.frame()); }

    std::string run(const std::string& steps) {
        for (const std::string& step : listed(steps, "; ")) {
            if (step.starts_with("say ")) {
                reply({});
                look(play_.hear(step.substr(4)));
            } else if (step.starts_with("wait ")) {
                reply({});
                for (const AnsweredEvent& answered : play_.wait(std::stod(step.substr(5)))) {
                    add(answered);
                }
            } else {
                act(step);
            }
        }
        reply({});
        look(play_.frame());
        reply({});
        const SessionHud& hud = play_.session->hud();
        return (told_.empty() ? "nothing" : spaced(told_, ", ")) + "; " + hud.feedback + "; " +
               (hud.invited         ? "invited"
                : hud.question_open ? "open"
                                    : "closed") +
               "; kept " + kept() + (play_.session->result().finished ? "; finished" : "");
    }

  private:
    Play play_;
    bool begun_ = true;
    std::vector<std::string> told_{};

    /// A letter for each: R, or r with a slip, W, or ? where it was not understood.
    [[nodiscard]] std::string kept() const {
        std::string letters;
        for (const AttemptRecord& attempt : play_.store.data.attempts) {
            letters += !attempt.understood      ? '?'
                       : !attempt.meaning_right ? 'W'
                       : attempt.form_right     ? 'R'
                                                : 'r';
        }
        return letters.empty() ? "none" : letters;
    }
    void add(const AnsweredEvent& answered) {
        std::string text = !answered.understood ? "not understood"
                           : answered.right     ? "right"
                                                : "wrong";
        text += of_slots(answered.slots);
        text += answered.understood && !answered.form_right ? " misformed" : "";
        text += answered.turned_round ? " turned" : "";
        text += answered.over ? " over" : "";
        told_.push_back(text +
                        (answered.attempt == 1 ? "" : " try " + std::to_string(answered.attempt)));
    }
    void look(const LessonFrame& frame) {
        begun_ = true;
        for (const LessonEvent& event : frame.events) {
            if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
                told_.push_back("judge " + judge->question + of_slots(judge->slots));
            } else if (const auto* answered = std::get_if<AnsweredEvent>(&event)) {
                add(*answered);
            } else if (const auto* asked = std::get_if<AskedEvent>(&event)) {
                told_.push_back("asked " + asked->knowledge + of_slots(asked->slots));
            }
        }
    }
    void reply(std::vector<LessonCommand> commands) {
        if (begun_) {
            (void)play_.reply(std::move(commands));
        }
        begun_ = false;
    }
    void act(const std::string& step) {
        std::vector<LessonCommand> commands;
        for (const std::string& done : listed(step, " & ")) {
            const std::size_t blank = std::min(done.find(' '), done.size());
            const std::string what = done.substr(0, blank);
            const std::string of = blank == done.size() ? "heaviest" : done.substr(blank + 1);
            if (what == "ask") {
                commands.push_back(AskCommand{of});
            } else if (what == "right" || what == "wrong") {
                commands.push_back(VerdictCommand{of, what == "right"});
            } else if (what == "tell") {
                commands.push_back(TellCommand{play_.lesson.knowledge.at(0).id, of});
            } else if (what == "finish") {
                commands.push_back(FinishCommand{2});
            } else {
                REQUIRE(what == "look");
            }
        }
        if (!begun_) {
            look(play_.frame());
        }
        reply(std::move(commands));
    }
};

/// What comes of it in this state of a dialogue, and what the lesson is told: "replaying, wrong".
std::string turn(const std::string& from, const std::string& what) {
    constexpr std::array kNames{"idle",    "asked",       "heard", "replaying",
                                "invited", "heard_again", "left",  "done"};
    const auto state = std::ranges::find(kNames, from) - kNames.begin();
    QuestionDialogue dialogue = in_state(static_cast<State>(state));
    const std::vector<AnsweredEvent> answers = told(take(dialogue, what));
    std::string came = kNames.at(static_cast<std::size_t>(dialogue.state()));
    for (const AnsweredEvent& answered : answers) {
        CHECK(answered.question == "heaviest");
        came +=
            std::string(answered.right ? ", right" : ", wrong") + (answered.over ? " over" : "");
    }
    return came;
}

TableReader make_reader() {
    const auto scene = std::make_shared<Scene>();
    const auto with_answers = [scene](const std::string& in) {
        Scene asked = *scene;
        asked.read("answers", in);
        return asked;
    };
    static const auto kCheck = value_of(open_free_english({"egg"}));
    const std::map<std::string, Probe> probes{
        {"slots", [scene](auto&, const std::string& in) { return slots_in(*scene, in); }},
        {"questions",
         [=](auto&, const std::string& in) {
             return refused(compile_questions(with_answers(in).lesson));
         }},
        {"notes", [=](auto&, const std::string& in) { return notes(with_answers(in)); }},
        {"notes_of_source",
         [scene](const std::string& with, const std::string& in) {
             scene->sources.texts = {with == "alone" ? "" : "L:question \"heaviest\" { }", in};
             return notes(*scene);
         }},
        {"capitals",
         [scene](auto&, const std::string& in) {
             scene->read("lists", "fruit: " + in);
             const auto notes = list_notes(scene->lesson);
             return notes.empty() ? "nothing" : spaced(notes, "\n");
         }},
        {"knows", [scene](const std::string& with,
                          const std::string& in) { return known(*scene, in, with); }},
        {"knowledge",
         [scene](auto&, const std::string& in) {
             scene->lesson.knowledge.back().asked = listed(in, " || ");
             return refused(Knowledge::compile(scene->lesson, words_of_knowledge()));
         }},
        {"begins", [](auto&, const std::string& in) { return yes_or_no(begins_as_question(in)); }},
        {"asks", [](auto&, const std::string& in) { return yes_or_no(asks_something(in)); }},
        {"way",
         [](auto&, const std::string& in) {
             constexpr std::array kNames{"right", "left", "up", "down", "near", "away"};
             const auto way = way_in(in);
             return std::string(way ? kNames.at(static_cast<std::size_t>(*way)) : "none");
         }},
        {"which",
         [](auto&, const std::string& in) {
             const auto which = which_in(in);
             return which ? std::to_string(*which) : "none";
         }},
        {"felt", [](auto&, const std::string& in) { return says_nothing(in) ? "nothing" : "?"; }},
        {"english", [](auto&, const std::string& in) { return kCheck(in).corrected; }},
        {"form",
         [](auto&, const std::string& in) {
             const std::string told = tell_form(kCheck, in);
             return told.empty() ? "nothing" : told;
         }},
        {"things",
         [=](auto&, const std::string& in) { return spaced(things_of(with_answers(in).lesson)); }},
        {"turn", turn},
        {"play", [scene](auto&, const std::string& in) { return Script(scene->lesson).run(in); }}};
    return {probes,
            [scene](const std::string& word, const std::string& rest) { scene->read(word, rest); }};
}

}  // namespace

TEST_CASE("lesson: words do to questions, to knowledge and in a play what the tables say") {
    hold_tables(FULCRUM_SOURCE_DIR "/tests/unit/runtime/lesson", make_reader);
}
