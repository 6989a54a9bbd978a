#include "runtime/app/shown_sentences.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// Finds "bad" wrong, and nothing else.
dialogue::CheckedText find_bad(std::string_view text) {
    dialogue::CheckedText checked;
    const std::size_t at = text.find("bad");
    checked.corrected = std::string(text);
    if (at != std::string_view::npos) {
        checked.errors.emplace_back();
        checked.proven = true;
        checked.corrected.replace(at, 3, "good");
    }
    return checked;
}

SessionHud hud_with(const std::string& caption, const std::string& title = {}) {
    SessionHud hud;
    hud.caption = caption;
    hud.level_title = title;
    return hud;
}

using Notes = std::vector<std::string>;

// What is told of a text with "bad" in it, at its place.
std::string note(const std::string& place, const std::string& text) {
    return place + ": \"" + text + "\" is no good English; better is \"" +
           find_bad(text).corrected + "\".";
}

}  // namespace

TEST_CASE("shown sentences: each is told once, with the line where it or most of it is written") {
    ShownSentences shown({{"lesson.lua",
                           "world:level(1, \"A bad title\")\n"
                           "world:caption(\"The \" .. noun .. \" feels bad now.\")\n"
                           "say((\"It is bad: %.1f newtons.\"):format(n))"},
                          {"more.lua", "\n\nhint = \"A bad hint.\""}});
    shown.look(hud_with("The egg feels bad now.", "A bad title"));
    shown.look(hud_with("The egg feels bad now.", "A bad title"));
    shown.look(hud_with("It is bad: 3.5 newtons."));
    shown.look(hud_with("It is bad: 12.25 newtons."));
    shown.look(hud_with("Nobody wrote bad."));
    shown.look(hud_with("All is well."));
    CHECK(shown.review(&find_bad).notes == Notes{note("more.lua:3", "A bad hint."),
                                                 note("lesson.lua:2", "The egg feels bad now."),
                                                 note("lesson.lua:1", "A bad title"),
                                                 note("lesson.lua:3", "It is bad: 3.5 newtons."),
                                                 note("lesson.lua", "Nobody wrote bad.")});
    CHECK(shown.review({}).notes.empty());
}

TEST_CASE("shown sentences: what is said about things and what is answered have their lines too") {
    ShownSentences shown(std::vector<LessonSource>{{"lesson.lua", "x = \"This is a bad egg.\""}});
    LessonDescription lesson;
    lesson.bodies.resize(2);
    lesson.bodies[0].about = "This is a bad egg.";
    lesson.bodies[1].about = "A bad rock.";
    lesson.bodies[1].line = 7;
    shown.add_things(lesson);
    shown.add_answer("sky", 9, "It is bad.");
    shown.add_answer("sky", 9, "");
    CHECK(shown.review(&find_bad).notes ==
          Notes{note("lesson.lua:1", "This is a bad egg."), note("lesson.lua:7", "A bad rock."),
                note("lesson.lua:9: what the lesson knows as \"sky\"", "It is bad.")});
    // Of very many answers to one thing the first are enough.
    for (char c = 'a'; c <= 'z'; ++c) {
        shown.add_answer("sky", 9, std::string("It is a bad ") + c + ".");
    }
    CHECK(shown.review(&find_bad).notes.size() == 3 + 11);
}

TEST_CASE("shown sentences: what a grammar could not read is told with its place") {
    const auto zig = [](std::string_view text) {
        dialogue::CheckedText checked;
        const std::size_t at = text.find("zig");
        checked.unread = at == std::string_view::npos ? "" : std::string(text.substr(0, at + 3));
        return checked;
    };
    ShownSentences shown({{"lesson.lua", "x = \"It is zig.\"\ny = \"A zig %d.\""},
                          {"about.lua", "\nhint = \"Feel the zig.\""}});
    shown.look(hud_with("A zig 1."));
    CHECK(shown.review(zig).unread ==
          Notes{"about.lua:2: \"Feel the zig\"", "lesson.lua:2: \"A zig\""});
    shown.look(hud_with("It is zig."));
    shown.look(hud_with("Nobody wrote this zig."));
    CHECK(shown.review(zig).unread == Notes{"about.lua:2: \"Feel the zig\"",
                                            "lesson.lua:2: \"A zig\"",
                                            "lesson.lua:1: \"It is zig\""});
    CHECK(ShownSentences({}).review(zig).unread.empty());
    CHECK(shown.review({}).unread.empty());
}

TEST_CASE("shown sentences: one that stands in two lines is told and asked about once, with both") {
    ShownSentences shown({{"lesson.lua", "hint = \"A bad hint.\"\n\nsolution = \"A bad hint.\""},
                          {"more.lua", "hint = \"A bad hint.\""}});
    shown.look(hud_with("A bad hint."));
    int asked = 0;
    const ShownReview review = shown.review([&](std::string_view text) {
        ++asked;
        return find_bad(text);
    });
    CHECK(asked == 1);
    CHECK(review.notes == Notes{note("lesson.lua:1, lesson.lua:3, more.lua:1", "A bad hint.")});
}

TEST_CASE("shown sentences: a prompt is told as its question's, once, though it is shown as well") {
    ShownSentences shown(std::vector<LessonSource>{
        {"lesson.lua",
         "L:question \"q\" {\n  prompt = \"Look. Is it bad?\",\n  again = "
         "\"Look at the bad one.\",\n}"}});
    LessonDescription lesson;
    lesson.questions.resize(1);
    lesson.questions[0].id = "q";
    lesson.questions[0].line = 1;
    lesson.questions[0].prompt = "Look. Is it bad?";
    lesson.questions[0].again = "Look at the bad one.";
    shown.add_questions(lesson);
    shown.look(hud_with("Look.\nIs it bad?"));
    CHECK(shown.review(&find_bad).notes ==
          Notes{note("lesson.lua:2: question \"q\"", "Look. Is it bad?"),
                note("lesson.lua:3: question \"q\"", "Look at the bad one.")});
}
