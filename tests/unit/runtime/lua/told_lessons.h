// What lessons and scripts are told, for tables: "" where they load.
#pragma once

#include "runtime/lua/sandbox/plain_words.h"
#include "tests/support/table.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/lua/lesson_player.h"
#include "tests/unit/runtime/lua/told_messages.h"

#include <string>

namespace fulcrum::runtime::test {

/// `with`, which may stand in quotes, where "…" stands for what goes in; it alone where `with` is empty.
inline std::string put_into(const std::string& written, const std::string& in) {
    const std::string with = table_field(written);
    const std::string gap = "…";
    const std::size_t at = with.find(gap);
    return at == std::string::npos ? in : std::string(with).replace(at, gap.size(), in);
}

/// Loads a lesson's body, or the body of its L:start, in a lesson whose head says `says` besides.
inline std::string told_lesson(const std::string& body, bool in_start,
                               const std::string& says = "") {
    HostedLesson lesson;
    lesson.says = says;
    return in_start ? lesson.start(body) : lesson.load(body);
}

/// What a lesson says in its first frame.
inline std::string told_playing(const std::string& body) {
    HostedLesson lesson;
    const std::string told = lesson.load(body);
    return told.empty() ? lesson.play() : told;
}

/// What a lesson declares beside one that says nothing; where it fails, what it is told.
inline std::string described_lesson(const std::string& body, bool in_start,
                                    const std::string& says = "") {
    HostedLesson lesson;
    lesson.says = says;
    const std::string told = in_start ? lesson.start(body) : lesson.load(body);
    LessonDescription usual;
    usual.id = "t";
    usual.title = "T";
    usual.level = "A1";
    return told.empty() ? told_description(lesson.host->description(), usual) : told;
}

/// What a lesson sends in its first frame.
inline std::string sent_playing(const std::string& body) {
    HostedLesson lesson;
    std::string told = lesson.load(body);
    told = told.empty() ? lesson.play() : told;
    return told.empty() ? told_reply(lesson.reply) : told;
}

/// What a lesson prints as it loads and in its first frame.
inline std::string printed_playing(const std::string& body) {
    HostedLesson lesson;
    std::string told = lesson.load(body);
    told = told.empty() ? lesson.play() : told;
    return told.empty() ? lesson.prints : told;
}

/// What a simulated hand is told in the first frame, or sends.
inline std::string told_hand(const std::string& script) {
    HostedLesson lesson;
    std::string told = lesson.load("", script);
    told = told.empty() ? lesson.play() : told;
    return told.empty() ? told_reply(lesson.reply) : told;
}

/// What a lesson's file is told.
inline std::string told_file(const std::string& text) {
    LoadMessage message;
    message.lesson = {"lesson.lua", text};
    const auto error = LessonHost(message, HostServices{}).load();
    return error ? to_sentence(to_error(*error)) : "";
}

/// What a lesson with these lines, of the modules that are named, prints while it begins or is told, in a process of its own.
inline std::string told_beginning(const std::string& modules, const std::string& lines) {
    std::string text;
    for (const std::string& module : listed(modules)) {
        text += "local " + module + " = require '" + module + "' ";
    }
    return LessonFolder().begin(text + "\nfunction L:start(world)\n" + lines + "\nend");
}

/// The probes of the tables of api and sandbox; behind start, load and play may stand what goes around, behind begin the modules.
inline TableReader told_lessons() {
    using Text = const std::string&;
    return {
        {{"start", [](Text with, Text in) { return told_lesson(put_into(with, in), true); }},
         {"start_two", [](Text, Text in) { return told_lesson(in, true, ", hands = 2"); }},
         {"load", [](Text with, Text in) { return told_lesson(put_into(with, in), false); }},
         {"play", [](Text with, Text in) { return told_playing(put_into(with, in)); }},
         {"described",
          [](Text with, Text in) { return described_lesson(put_into(with, in), true); }},
         {"described_file",
          [](Text with, Text in) { return described_lesson(put_into(with, in), false); }},
         {"described_two", [](Text, Text in) { return described_lesson(in, true, ", hands = 2"); }},
         {"described_says", [](Text, Text in) { return described_lesson("", false, in); }},
         {"sent", [](Text with, Text in) { return sent_playing(put_into(with, in)); }},
         {"printed", [](Text with, Text in) { return printed_playing(put_into(with, in)); }},
         {"hand", [](Text, Text in) { return told_hand(in); }},
         {"hand_turn",
          [](Text, Text in) {
              return told_hand("\nreturn function() return 1, 2, 3, nil, " + in + " end");
          }},
         {"file", [](Text, Text in) { return told_file(in); }},
         {"begin", told_beginning},
         {"begin_in", [](Text with, Text in) { return LessonFolder().begin(put_into(with, in)); }},
         {"says", [](Text, Text in) { return told_lesson("", false, in); }},
         {"level", [](Text, Text in) { return told_lesson("", false, ", level = '" + in + "'"); }},
         {"run", [](Text, Text in) { return run_script(in); }},
         {"in_plain_words", [](Text, Text in) { return in_plain_words(in); }}},
        {}};
}

}  // namespace fulcrum::runtime::test
