// Where the program finds what it needs: lessons, shared Lua, words, models.
#pragma once

#include "haptics/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// The folders of one installation. All exist but `models`, which may be empty until the build has
/// made it.
struct Places {
    std::filesystem::path scenarios;    ///< one folder a lesson
    std::filesystem::path scripts_lib;  ///< Lua that lessons share
    std::filesystem::path words;        ///< catalogues, one a language
    std::filesystem::path models;       ///< models made by the build
};

/// Looks for scenarios/ beside the program and in every folder above it.
[[nodiscard]] Expected<Places> find_places();
/// The same from a given program file; for tests.
[[nodiscard]] Expected<Places> find_places_from(const std::filesystem::path& executable);

/// The folder of a lesson: `name` under scenarios/, or a path of a folder that holds a lesson.lua.
[[nodiscard]] Expected<std::filesystem::path> find_lesson(const Places& places,
                                                          const std::string& name_or_folder);

/// The names of all lessons under scenarios/, in alphabetical order.
[[nodiscard]] std::vector<std::string> list_lesson_names(const Places& places);

/// What lies in a folder, in alphabetical order; nothing when it cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);

/// A model's file: the lesson's own folder first, then the shared models; empty when neither has
/// it.
[[nodiscard]] std::filesystem::path find_model(const Places& places,
                                               const std::filesystem::path& lesson_folder,
                                               const std::string& model);

}  // namespace fulcrum::runtime
