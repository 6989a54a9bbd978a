// Reads the Lua files of a lesson, and nothing else: plain files of a sane size, in two folders, by plain names.
//
// Thread: any. Cost: file reads.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lua/wire/wire.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// Which files make a lesson.
struct LessonFiles {
    std::filesystem::path folder;       ///< holds lesson.lua, its modules and simulated hands
    std::filesystem::path library;      ///< scripts/lib; empty for none
    std::string lesson = "lesson.lua";  ///< the file in `folder`
    std::filesystem::path hand;         ///< a simulated hand's file, anywhere; empty for none
    std::filesystem::path second_hand;  ///< likewise of another one
};

/// Reads one file; errors show it as `shown_name`. Refused: what is no plain file, a symbolic link unless `may_be_link`, more
/// than kMaxSourceBytes, compiled Lua.
[[nodiscard]] Expected<LuaSource> read_lua_file(const std::filesystem::path& path,
                                                const std::string& shown_name, bool may_be_link);

class LessonSources {
  public:
    explicit LessonSources(LessonFiles files) : files_(std::move(files)) {}
    [[nodiscard]] Expected<LuaSource> read_lesson();
    /// An empty source when no hand is wanted.
    [[nodiscard]] Expected<LuaSource> read_hand() { return read_hand(files_.hand); }
    [[nodiscard]] Expected<LuaSource> read_second_hand() { return read_hand(files_.second_hand); }
    /// Answers `require "name"`: the library's module first, then one beside the lesson.
    [[nodiscard]] ModuleAnswer find_module(const std::string& name);
    [[nodiscard]] const std::vector<std::filesystem::path>& files_read() const noexcept {
        return files_read_;
    }
    /// The shown name, if it is that of a file that was read; otherwise the lesson's.
    [[nodiscard]] std::string known_name(const std::string& shown_name) const;

  private:
    [[nodiscard]] Expected<LuaSource> read_hand(const std::filesystem::path& file);
    [[nodiscard]] Expected<LuaSource> read(const std::filesystem::path& path,
                                           const std::string& shown_name, bool may_be_link);

    LessonFiles files_;
    std::vector<std::filesystem::path> files_read_;
    std::vector<std::string> shown_names_;
};

}  // namespace fulcrum::runtime
