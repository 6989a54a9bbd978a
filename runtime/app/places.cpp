#include "runtime/app/places.h"

#include "dialogue/english/letters.h"
#include "runtime/files/user_folder.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
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

bool is_folder(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder, error);
}

bool holds_lesson(const fs::path& folder) {
    std::error_code error;
    return fs::is_regular_file(folder / "lesson.lua", error);
}

// What belongs to a folder that holds scenarios/, scripts/ and assets/.
Places places_in(const fs::path& data) {
    return {data / "scenarios",
            data / "scripts" / "lib",
            data / "assets" / "words",
            data / "assets" / "models",
            {}};
}

bool is_whole(const Places& places) {
    return is_folder(places.scenarios) && is_folder(places.scripts_lib) && is_folder(places.words);
}

// $XDG_DATA_HOME, then the folders of $XDG_DATA_DIRS.
std::vector<fs::path> find_data_folders() {
    std::vector<fs::path> folders{
        find_user_folder("XDG_DATA_HOME", ".local/share", "set HOME").value_or(fs::path())};
    const char* shared = std::getenv("XDG_DATA_DIRS");
    std::istringstream list(shared != nullptr && *shared != '\0' ? shared
                                                                 : "/usr/local/share:/usr/share");
    for (std::string folder; std::getline(list, folder, ':');) {
        if (fs::path(folder).is_absolute()) {
            folders.emplace_back(folder);
        }
    }
    return folders;
}

}  // namespace

Expected<Places> find_places() {
    std::error_code error;
    const fs::path executable = fs::read_symlink("/proc/self/exe", error);
    if (error) {
        return fail("the program cannot find its own folder", "/proc/self/exe", "mount /proc");
    }
    return find_places_from(executable, find_data_folders());
}

Expected<Places> find_places_from(const fs::path& executable,
                                  const std::vector<fs::path>& data_folders) {
    const fs::path beside = executable.parent_path();
    const fs::path prefix = beside.parent_path();
    std::vector<Places> found{places_in(prefix / "share" / "fulcrum")};
    for (fs::path folder = beside; !folder.empty(); folder = folder.parent_path()) {
        found.push_back(places_in(folder));
        found.back().models = beside / "assets" / "models";
        if (folder == folder.root_path()) {
            break;
        }
    }
    for (const fs::path& folder : data_folders) {
        if (!folder.empty()) {
            found.push_back(places_in(folder / "fulcrum"));
        }
    }
    const auto first = std::ranges::find_if(found, is_whole);
    if (first == found.end()) {
        return fail("the program's lessons and words are not found", executable.string(),
                    "install the package again, or keep the program inside the project's folder");
    }
    const fs::path installed = prefix / "libexec" / "fulcrum";
    first->helpers = is_folder(installed) ? installed : beside;
    if (!data_folders.empty() && !data_folders.front().empty()) {
        first->own_scenarios = data_folders.front() / "fulcrum" / "scenarios";
    }
    return *first;
}

fs::path find_named_lesson(const Places& places, const std::string& name) {
    for (const fs::path& scenarios : {places.own_scenarios, places.scenarios}) {
        if (!scenarios.empty() && holds_lesson(scenarios / name)) {
            return scenarios / name;
        }
    }
    return {};
}

Expected<fs::path> find_lesson(const Places& places, const std::string& name_or_folder) {
    std::error_code error;
    if (is_plain_name(name_or_folder)) {
        if (fs::path named = find_named_lesson(places, name_or_folder); !named.empty()) {
            return named;
        }
    }
    if (holds_lesson(name_or_folder)) {
        return fs::path(name_or_folder);
    }
    if (const fs::path file(name_or_folder);
        file.filename() == "lesson.lua" && fs::is_regular_file(file, error)) {
        return file.has_parent_path() ? file.parent_path() : fs::path(".");
    }
    const auto names = list_lesson_names(places);
    const auto distance = [&](const std::string& name) {
        return dialogue::edit_distance(name_or_folder, name);
    };
    const auto best = std::ranges::min_element(names, {}, distance);
    const bool close = best != names.end() && distance(*best) <= 2;
    return fail("there is no lesson \"" + name_or_folder + "\"", "",
                close
                    ? "did you mean " + *best + "?  fulcrum list shows all lessons"
                    : "fulcrum list shows all lessons; a folder works when it holds a lesson.lua");
}

std::vector<std::string> list_lesson_names(const Places& places) {
    std::vector<std::string> names;
    for (const fs::path& scenarios : {places.own_scenarios, places.scenarios}) {
        for (const fs::path& entry : entries_of(scenarios)) {
            if (holds_lesson(entry)) {
                names.push_back(entry.filename().string());
            }
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
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
            const fs::path file = folder / (model + ending);
            if (!folder.empty() && fs::is_regular_file(file, error)) {
                return file;
            }
        }
    }
    return {};
}

}  // namespace fulcrum::runtime
