#include "runtime/app/places.h"

#include "runtime/app/options.h"

#include <algorithm>
#include <system_error>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

// Names of models and lessons come from lesson files: plain words only, so that none can leave its
// folder.
bool is_plain_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '-' || c == '_';
    });
}

}  // namespace

Expected<Places> find_places() {
    std::error_code error;
    const fs::path executable = fs::read_symlink("/proc/self/exe", error);
    if (error) {
        return fail("the program cannot find its own folder", "/proc/self/exe", "mount /proc");
    }
    return find_places_from(executable);
}

Expected<Places> find_places_from(const fs::path& executable) {
    std::error_code error;
    for (fs::path folder = executable.parent_path(); !folder.empty();
         folder = folder.parent_path()) {
        if (fs::is_directory(folder / "scenarios", error)) {
            return Places{folder / "scenarios", folder / "scripts" / "lib",
                          folder / "assets" / "words",
                          executable.parent_path() / "assets" / "models"};
        }
        if (folder == folder.root_path()) {
            break;
        }
    }
    return fail("no scenarios folder lies beside the program or above it", executable.string(),
                "keep the program inside the project's folder");
}

Expected<fs::path> find_lesson(const Places& places, const std::string& name_or_folder) {
    std::error_code error;
    const auto holds_lesson = [&](const fs::path& folder) {
        return fs::is_regular_file(folder / "lesson.lua", error);
    };
    if (is_plain_name(name_or_folder) && holds_lesson(places.scenarios / name_or_folder)) {
        return places.scenarios / name_or_folder;
    }
    if (holds_lesson(name_or_folder)) {
        return fs::path(name_or_folder);
    }
    if (const fs::path file(name_or_folder);
        file.filename() == "lesson.lua" && fs::is_regular_file(file, error)) {
        return file.has_parent_path() ? file.parent_path() : fs::path(".");
    }
    const auto names = list_lesson_names(places);
    const auto best =
        std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
            return edit_distance(name_or_folder, a) < edit_distance(name_or_folder, b);
        });
    const bool close = best != names.end() && edit_distance(name_or_folder, *best) <= 2;
    return fail("there is no lesson \"" + name_or_folder + "\"", "",
                close
                    ? "did you mean " + *best + "?  fulcrum list shows all lessons"
                    : "fulcrum list shows all lessons; a folder works when it holds a lesson.lua");
}

std::vector<std::string> list_lesson_names(const Places& places) {
    std::vector<std::string> names;
    std::error_code error;
    for (const fs::path& entry : entries_of(places.scenarios)) {
        if (fs::is_regular_file(entry / "lesson.lua", error)) {
            names.push_back(entry.filename().string());
        }
    }
    return names;
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code error;
    // Not a range-for: its ++ throws when the folder goes away meanwhile.
    for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator();
         at.increment(error)) {
        entries.push_back(at->path());
    }
    std::sort(entries.begin(), entries.end());
    return entries;
}

fs::path find_model(const Places& places, const fs::path& lesson_folder, const std::string& model) {
    std::error_code error;
    if (!is_plain_name(model)) {
        return {};
    }
    for (const fs::path& folder : {lesson_folder, places.models}) {
        for (const char* ending : {".glb", ".gltf"}) {
            if (fs::path file = folder / (model + ending); fs::is_regular_file(file, error)) {
                return file;
            }
        }
    }
    return {};
}

}  // namespace fulcrum::runtime
