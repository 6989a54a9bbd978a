// A folder with Lua files that is gone when the test is over, and lessons started from it.
#pragma once

#include "runtime/lua/process/lesson_process.h"
#include "tests/unit/runtime/lua/lesson_helper.h"

#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <string>

namespace fulcrum::runtime::test {

class LessonFolder {
  public:
    LessonFolder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "fulcrum-lua-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    LessonFolder(const LessonFolder&) = delete;
    LessonFolder& operator=(const LessonFolder&) = delete;
    ~LessonFolder() { std::filesystem::remove_all(path_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name) << text;
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    [[nodiscard]] LessonFiles files(const std::string& hand = {}) const {
        LessonFiles files;
        files.folder = path_;
        files.library = std::filesystem::path(FULCRUM_SOURCE_DIR) / "scripts/lib";
        if (!hand.empty()) {
            files.hand = path_ / hand;
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

  private:
    std::filesystem::path path_;
};

/// A lesson's file: the head, `body`, and the return.
inline std::string lesson_text(const std::string& body) {
    return "local L = lesson { id = \"t\", title = \"T\" }\n" + body + "\nreturn L\n";
}

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
