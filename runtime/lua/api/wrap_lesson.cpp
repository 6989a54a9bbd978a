// lesson{…} and what hangs on the lesson itself: questions, tests, listeners.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace fulcrum::runtime {
namespace {

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& known, std::string_view word) {
    return std::find(known.begin(), known.end(), word) != known.end();
}

/// "a, b or c".
template <std::size_t n>
std::string listed(const std::array<std::string_view, n>& words, const char* last) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) {
        text += (i == 0 ? "" : i + 1 == n ? last : ", ") + std::string(words[i]);
    }
    return text;
}

/// What a test expects must be something that a lesson ends with.
void check_expected(lua_State* lua, const std::string& name, const std::string& value) {
    if (!is_one_of(kTestFacts, name)) {
        const std::string near = nearest_word(name, {kTestFacts.begin(), kTestFacts.end()});
        raise_in_lesson(lua, "test.expect has no \"" + clean_text(name, 40) + "\"; " +
                                 (near.empty() ? "it has " + listed(kTestFacts, " and ")
                                               : "did you mean \"" + near + "\"?"));
    }
    const bool is_flag = value == "true" || value == "false";
    const std::size_t first_digit = value.starts_with('-') ? 1 : 0;
    const bool is_whole = value.size() > first_digit &&
                          value.find_first_not_of("0123456789", first_digit) == std::string::npos;
    const bool wants_flag = std::find(kTestFacts.begin(), kTestFacts.begin() + kTestFlags, name) !=
                            kTestFacts.begin() + kTestFlags;
    if (wants_flag ? !is_flag : !is_whole) {
        raise_in_lesson(lua, "test.expect." + name + " is " +
                                 (wants_flag ? "true or false" : "a whole number") + "; got " +
                                 clean_text(value, 40));
    }
}

/// The steps of feedback that were given; none where there were none.
dialogue::FeedbackLadder take_ladder(lua_State* lua, const char* called, const Argument& given) {
    if (!given.given) {
        return {};
    }
    auto ladder = dialogue::read_ladder(given.texts);
    if (!ladder) {
        raise_in_lesson(lua, std::string(called) + ": " + ladder.error().message);
    }
    return std::move(*ladder);
}

int make_lesson(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.lesson_ref != LUA_NOREF) {
        raise_in_lesson(lua, "a file makes one lesson; this is the second lesson{…}");
    }
    context.description.id = arguments["id"].text;
    context.description.title = arguments["title"].text;
    context.description.level = arguments["level"].text;
    if (!is_one_of(kEnglishLevels, context.description.level)) {
        raise_in_lesson(lua, "lesson.level is " + listed(kEnglishLevels, " or ") + "; got \"" +
                                 clean_text(context.description.level, 16) + '"');
    }
    context.description.minutes = arguments["minutes"].number;
    if (arguments["force_limit"].given) {
        context.description.force_limit_N = arguments["force_limit"].number;
    }
    context.description.free_english = arguments["free_english"].flag;
    context.description.feedback = take_ladder(lua, "lesson.feedback", arguments["feedback"]);
    context.description.tries = static_cast<std::int32_t>(arguments["tries"].number);
    context.description.sureness = arguments["sureness"].number;
    context.most_hands = static_cast<std::size_t>(arguments["hands"].number);
    if (context.most_hands > 1) {
        ScriptError unmet = place_in_lesson(lua);
        unmet.message =
            "the lesson says hands = 2; declare the second one by another "
            "world:hand { … } in L:start";
        context.needs.emplace_back(Need::hands, std::move(unmet));
    }
    lua_newtable(lua);
    luaL_setmetatable(lua, "fulcrum.lesson");
    lua_pushvalue(lua, -1);
    context.lesson_ref = luaL_ref(lua, LUA_REGISTRYINDEX);
    return 1;
}

constexpr Parameter kRates[] = {
    {"wrong", ParameterType::number, "", 0, 1, "0", "wrong in meaning"},
    {"form", ParameterType::number, "", 0, 1, "0", "right in meaning, with an error of form"},
    {"unclear", ParameterType::number, "", 0, 1, "0", "not to be understood"}};

// Answers of which is known how they are to be marked.
constexpr Parameter kExamples[] = {
    {"right", ParameterType::texts, "", 0, 0, "nil", "right in meaning and form"},
    {"wrong", ParameterType::texts, "", 0, 0, "nil", "understood, and wrong in meaning"},
    {"form", ParameterType::texts, "", 0, 0, "nil", "right in meaning, with an error of form"}};

int add_question(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    QuestionDescription question;
    question.id = arguments["name"].text;
    question.prompt = arguments["prompt"].text;
    question.answers = arguments["answers"].texts;
    question.nearly = arguments["nearly"].texts;
    question.lists = arguments["lists"].lists;
    question.rules = arguments["rules"].values;
    question.again = arguments["again"].text;
    if (arguments["examples"].given) {
        const Arguments examples = arguments.record("examples");
        question.examples = {examples["right"].texts, examples["wrong"].texts,
                             examples["form"].texts};
    }
    question.feedback = take_ladder(lua, "question.feedback", arguments["feedback"]);
    question.line = place_in_lesson(lua).line;
    auto& known = context.description.questions;
    if (std::any_of(known.begin(), known.end(),
                    [&](const auto& q) { return q.id == question.id; })) {
        raise_in_lesson(
            lua, "there is already a question \"" + question.id + "\"; give this one another name");
    }
    if (known.size() >= kMaxQuestions) {
        raise_in_lesson(lua,
                        "a lesson has at most " + std::to_string(kMaxQuestions) + " questions");
    }
    if (question.answers.empty()) {
        raise_in_lesson(
            lua,
            "question.answers is empty; give at least one sentence that a learner may answer with");
    }
    lua_pushvalue(lua, arguments["right"].stack_index);
    context.judges.emplace_back(question.id, luaL_ref(lua, LUA_REGISTRYINDEX));
    known.push_back(std::move(question));
    return 0;
}

// Ways to ask of which is known what they come to.
constexpr Parameter kAskedExamples[] = {
    {"right", ParameterType::texts, "", 0, 0, "nil", "ask for it in good English"},
    {"form", ParameterType::texts, "", 0, 0, "nil", "ask for it with an error of form"},
    {"other", ParameterType::texts, "", 0, 0, "nil", "do not ask for it"}};

int add_knowledge(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    KnowledgeDescription knowledge;
    knowledge.id = arguments["name"].text;
    knowledge.asked = arguments["asked"].texts;
    knowledge.lists = arguments["lists"].lists;
    knowledge.rules = arguments["rules"].values;
    knowledge.nearly = arguments["nearly"].texts;
    if (arguments["examples"].given) {
        const Arguments examples = arguments.record("examples");
        knowledge.examples = {examples["right"].texts, examples["form"].texts,
                              examples["other"].texts};
    }
    knowledge.line = place_in_lesson(lua).line;
    auto& known = context.description.knowledge;
    if (std::any_of(known.begin(), known.end(),
                    [&](const auto& k) { return k.id == knowledge.id; })) {
        raise_in_lesson(
            lua, "the lesson knows \"" + knowledge.id + "\" already; give this another name");
    }
    if (known.size() >= kMaxQuestions) {
        raise_in_lesson(lua, "a lesson knows at most " + std::to_string(kMaxQuestions) + " things");
    }
    if (knowledge.asked.empty()) {
        raise_in_lesson(lua, "knows.asked is empty; give at least one question that asks for it");
    }
    lua_pushvalue(lua, arguments["answer"].stack_index);
    context.tellers.emplace_back(knowledge.id, luaL_ref(lua, LUA_REGISTRYINDEX));
    known.push_back(std::move(knowledge));
    return 0;
}

/// Wrong, in form and unclear are parts of one whole.
void check_parts(lua_State* lua, const LearnerRates& rates) {
    constexpr double kRounding = 1e-9;  // 0.7 + 0.2 + 0.1
    const double sum = rates.wrong + rates.form + rates.unclear;
    if (sum > 1.0 + kRounding) {
        lua_pushfstring(lua,
                        "test.learner errs in %f of its answers, wrong, form and unclear together; "
                        "1 is all of them",
                        sum);
        raise_in_lesson(lua, lua_tostring(lua, -1));
    }
}

int add_test(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    LessonTestDescription test;
    test.hand = arguments["hand"].text;
    test.second_hand = arguments["second_hand"].text;
    test.say = arguments["say"].texts;
    test.expect = arguments["expect"].values;
    if (arguments["learner"].given) {
        const Arguments rates = arguments.record("learner");
        test.learner =
            LearnerRates{rates["wrong"].number, rates["form"].number, rates["unclear"].number};
        if (!test.say.empty()) {
            raise_in_lesson(lua, "test has say and learner; leave out one of them");
        }
        check_parts(lua, *test.learner);
    }
    test.line = place_in_lesson(lua).line;
    for (const auto& [name, value] : test.expect) {
        check_expected(lua, name, value);
    }
    for (const auto& [field, file] :
         {std::pair{"test.hand", std::string_view(test.hand)},
          std::pair{"test.second_hand", std::string_view(test.second_hand)}}) {
        if (!file.empty() &&
            !(file.ends_with(".lua") && is_name(file.substr(0, file.size() - 4)))) {
            raise_in_lesson(lua, std::string(field) +
                                     " is the name of a Lua file beside the lesson, such as "
                                     "\"sweep.lua\"; got \"" +
                                     clean_text(file, 40) + '"');
        }
    }
    if (context.description.tests.size() >= kMaxListItems) {
        raise_in_lesson(lua, "a lesson has at most " + std::to_string(kMaxListItems) + " tests");
    }
    context.description.tests.push_back(std::move(test));
    return 0;
}

int add_listener(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.listeners.size() >= 32) {
        raise_in_lesson(lua, "a lesson has at most 32 listeners");
    }
    lua_pushvalue(lua, arguments["listener"].stack_index);
    context.listeners.push_back(luaL_ref(lua, LUA_REGISTRYINDEX));
    return 0;
}

}  // namespace

void add_lesson_api(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back(
        {"",
         "lesson",
         CallShape::record,
         CallTime::loading,
         {{"id", name, "", 0, 0, kRequired, "short name, used in reports"},
          {"title", text, "", 0, kMostTitleBytes, kRequired, "what the list of lessons shows"},
          {"level", text, "", 0, kMostLevelBytes, "A1",
           "level of English: A1, A2, B1, B2, C1 or C2"},
          {"minutes", number, "minutes", 0, kMostMinutes, "10", "how long it takes"},
          {"force_limit", number, "newtons", kLeastForceLimit_N, kMostForceLimit_N, "nil",
           "no force in this lesson is larger; this place and the device may allow less"},
          {"free_english", flag, "", 0, 0, "false",
           "what is said beside a question's answers is checked, and good English for it is "
           "shown"},
          {"tries", integer, "", 1, kMostTries, "4",
           "after so many answers of wrong meaning a question is left, and the lesson goes on; "
           "after "
           "six that are not understood it is left as well"},
          {"sureness", number, "", 0, 1, "0.4",
           "what a recogniser of speech hears less surely is asked for again, and neither right "
           "nor "
           "wrong; ./fulcrum run LESSON --sure N says it for one play"},
          {"hands", integer, "", 1, static_cast<double>(kMostHands), "1",
           "how many hands or fingers it can use at once; each has a world:hand { … } of its own, "
           "and where fewer are there it is played with those"},
          {"feedback", texts, "", 0, 0, "nil",
           "what is done about an error of form, by how often it has been made: the first time "
           "the first of these, and so on, from then on the last; \"recast\" (the right "
           "sentence), \"prompt\" (say it once more), \"rule\" (and why), \"replay\" (and "
           "feel it again); { \"recast\", \"prompt\", \"rule\" } by default"}},
         "Lesson",
         "Begins a lesson. The file ends with `return` of what this gives.",
         &make_lesson});
    table.functions.push_back(
        {"lesson",
         "question",
         CallShape::named_record,
         CallTime::loading,
         {{"name", name, "", 0, 0, kRequired, "what world:ask and game.ask call it"},
          {"prompt", text, "", 0, 1000, kRequired, "what the learner is asked"},
          {"answers", texts, "", 0, 0, kRequired,
           "templates of the sentences that answer it; the first of several articles is the one "
           "that is said "
           "back: \"[a|an|the] {thing}\" gives \"An apple is …\", \"[the|a|an] {thing}\" gives "
           "\"The "
           "apple is …\""},
          {"nearly", texts, "", 0, 0, "nil",
           "templates of what learners say for them that is no good English: understood, and said "
           "back as the first answer with the same {slots}"},
          {"lists", lists, "", 0, 0, "nil",
           "plain words that {name} in a template may stand for, with | between two ways to say "
           "one, such as { size = { \"big|large\", \"small\" } }; no [ ], ( ), { } or < >; {thing} "
           "and {other} are by default the "
           "nouns "
           "of all bodies of the scene, whether they move, are solid or neither; not of those with "
           "noun = \"\""},
          {"rules", rules, "", 0, 0, "nil",
           "templates that <name> in a template stands for, such as { place = \"(on|under) the "
           "{thing}\" }; a rule may use another one, not itself"},
          {"again", text, "", 0, 200, "",
           "what is said after \"Not yet.\" when the meaning is wrong, such as \"Let's weigh both "
           "again.\"; \"Try again.\" by default"},
          {"right", function, "", 0, 0, kRequired,
           "function(answer): is the meaning right? see answer; ./fulcrum check calls it with what "
           "the "
           "answers can mean, when the question is asked"},
          {"examples", record, "", 0, 0, "nil",
           "answers that are marked by ./fulcrum check and test, and must come out as said", "",
           kExamples, std::size(kExamples)},
          {"feedback", texts, "", 0, 0, "nil", "as the lesson's, for this question alone"}},
         "",
         "Declares a question.",
         &add_question});
    table.functions.push_back(
        {"lesson",
         "knows",
         CallShape::named_record,
         CallTime::loading,
         {{"name", name, "", 0, 0, kRequired, "what it is about"},
          {"asked", texts, "", 0, 0, kRequired,
           "templates of the questions that ask for it, such as \"how heavy is (it|the {thing})\""},
          {"nearly", texts, "", 0, 0, "nil",
           "templates of what learners say for them that is no good English: understood, said "
           "back "
           "as the first of `asked` with the same {slots}, and answered"},
          {"lists", lists, "", 0, 0, "nil",
           "as a question's; a name means the same in all of them; {material} is by default every "
           "material that the program or the lesson has, and some more"},
          {"rules", rules, "", 0, 0, "nil", "likewise"},
          {"answer", function, "", 0, 0, kRequired,
           "function(asked, world): the answer as a text, or nil where that is not known; asked "
           "has the "
           "{slots}, and asked.bodies the bodies that they name; ./fulcrum check and test call it "
           "for each way to ask with each word of its lists"},
          {"examples", record, "", 0, 0, "nil",
           "questions that are looked at by ./fulcrum check and test, and must come out as said",
           "", kAskedExamples, std::size(kAskedExamples)}},
         "",
         "Declares something that a learner may ask for while no question is open: with the Tab "
         "key, or aloud; and where a question's own answers ask (\"Now you ask me!\"): there it is "
         "a right answer.",
         &add_knowledge});
    table.functions.push_back(
        {"lesson",
         "test",
         CallShape::record,
         CallTime::loading,
         {{"hand", text, "", 0, 48, "", "simulated hand: a Lua file beside the lesson, see motion"},
          {"second_hand", text, "", 0, 48, "",
           "likewise of the second hand; without it the lesson is played with one"},
          {"say", texts, "", 0, 0, "nil", "what the simulated learner answers, in turn"},
          {"learner", record, "", 0, 0, "nil",
           "who answers instead of say: a simulated learner who knows what is right, and errs in "
           "such "
           "parts of the answers",
           "", kRates, std::size(kRates)},
          {"expect", values, "", 0, 0, "nil", "how the lesson must end, see Tests"}},
         "",
         "Declares how the lesson is played in tests.",
         &add_test});
    table.functions.push_back({"lesson",
                               "listen",
                               CallShape::positional,
                               CallTime::acting,
                               {{"listener", function, "", 0, 0, kRequired,
                                 "function(event): event.name says what happened, see Events"}},
                               "",
                               "Calls a function with every event, after the lesson's own; "
                               "\"update\" comes each frame with event.dt.",
                               &add_listener});
}

}  // namespace fulcrum::runtime
