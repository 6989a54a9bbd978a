// Where the program finds what it needs: lessons, shared Lua, words, models, helpers.
//
//   installed     PREFIX/bin/fulcrum, PREFIX/share/fulcrum, PREFIX/libexec/fulcrum
//   checkout      build/PRESET/fulcrum with helpers and models beside it, scenarios/ in a folder above
//   moved alone   share/fulcrum of an installation, in $XDG_DATA_HOME or a folder of $XDG_DATA_DIRS
// The first that is there. The user's own lessons are added: $XDG_DATA_HOME/fulcrum/scenarios.
// Source: XDG Base Directory Specification 0.8.
#pragma once

#include "haptics/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A helper is a program of this project that a run may start. CMake's target fulcrum_program builds all that stand here;
/// tests/system/helpers.sh reads their names here and starts each. This one hears by PocketSphinx.
inline constexpr const char* kSphinxHelper = "fulcrum-sphinx";

/// The folders of one installation. All exist but `models`, which may be empty until the build has
/// made it, and `own_scenarios`.
struct Places {
    std::filesystem::path scenarios;    ///< one folder a lesson
    std::filesystem::path scripts_lib;  ///< Lua that lessons share
    std::filesystem::path words;        ///< catalogues, one a language
    std::filesystem::path models;       ///< models made by the build
    std::filesystem::path helpers;      ///< programs that a run may start
    std::filesystem::path
        own_scenarios{};  ///< the user's own lessons, one folder each; empty: no home folder
};

/// Looks from where this program lies.
[[nodiscard]] Expected<Places> find_places();
/// The same from a given program file; `data_folders` holds $XDG_DATA_HOME (or empty), then those of $XDG_DATA_DIRS.
[[nodiscard]] Expected<Places> find_places_from(
    const std::filesystem::path& executable,
    const std::vector<std::filesystem::path>& data_folders);

/// The folder of a lesson that list_lesson_names names; empty when there is none.
[[nodiscard]] std::filesystem::path find_named_lesson(const Places& places,
                                                      const std::string& name);

/// The folder of a lesson: `name` among the user's own, then under scenarios/, or a path of a folder that holds a lesson.lua.
[[nodiscard]] Expected<std::filesystem::path> find_lesson(const Places& places,
                                                          const std::string& name_or_folder);

/// The names of all lessons under scenarios/ and of the user's own, in alphabetical order.
[[nodiscard]] std::vector<std::string> list_lesson_names(const Places& places);

/// What lies in a folder, in alphabetical order; nothing when it cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);

/// A model's file: the lesson's own folder first, where there is one, then the shared models; empty when neither has
/// it.
[[nodiscard]] std::filesystem::path find_model(const Places& places,
                                               const std::filesystem::path& lesson_folder,
                                               const std::string& model);

}  // namespace fulcrum::runtime
