// A folder with Lua files that is gone when the test is over, and lessons started from it.
#pragma once

#include "runtime/lua/process/lesson_process.h"
#include "tests/support/scratch_folder.h"

#include <filesystem>
#include <string>

namespace fulcrum::runtime::test {

/// The program that plays a lesson's process in these tests: it lies beside the tests' own.
inline std::string lesson_helper() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "lesson_process_helper";
}

/// A lesson's file: the head, `body`, and the return.
inline std::string lesson_text(const std::string& body) {
    return "local L = lesson { id = \"t\", title = \"T\" }\n" + body + "\nreturn L\n";
}

class LessonFolder : public ScratchFolder {
  public:
    [[nodiscard]] LessonFiles files(const std::string& hand = {}) const {
        LessonFiles files;
        files.folder = path();
        files.library = std::filesystem::path(FULCRUM_SOURCE_DIR) / "scripts/lib";
        if (!hand.empty()) {
            files.hand = path() / hand;
        }
        return files;
    }
    [[nodiscard]] static LessonProcessOptions options() {
        LessonProcessOptions options;
        options.executable = lesson_helper();
        return options;
    }
    /// Starts the lesson with this text.
    [[nodiscard]] Expected<std::unique_ptr<LessonProcess>> start(
        const std::string& text, const std::string& hand = {}) const {
        write("lesson.lua", text);
        return LessonProcess::start(files(hand), options());
    }
    /// Starts the lesson with this body: what it prints while it begins, each with a ';' behind it, or its error's sentence.
    [[nodiscard]] std::string begin(const std::string& body) const {
        const auto process = start(lesson_text(body));
        if (!process) {
            return to_sentence(process.error());
        }
        std::string prints;
        for (const std::string& line : (*process)->prints_while_loading()) {
            prints += line + ';';
        }
        return prints;
    }
};

/// A frame in which every body lies where it was declared.
inline LessonFrame frame_for(const LessonDescription& description, double time_s) {
    LessonFrame frame;
    frame.time_s = time_s;
    frame.dt_s = 1.0 / 60.0;
    for (const BodyDescription& body : description.bodies) {
        BodyState state;
        state.pose_W.position = body.position_W;
        state.where = body.visible ? BodyWhere::placed : BodyWhere::hidden;
        frame.bodies.push_back(state);
    }
    return frame;
}

}  // namespace fulcrum::runtime::test
