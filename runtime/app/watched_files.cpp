#include "runtime/app/watched_files.h"

#include "runtime/app/lesson_parts.h"
#include "runtime/app/places.h"
#include "runtime/scene/description.h"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>
#include <utility>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

bool may_be_part_of_lesson(const fs::path& file) {
    constexpr std::array kEndings = {".lua", ".png", ".jpg", ".jpeg", ".glb", ".gltf", ".bin"};
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return std::ranges::find(kEndings, ending) != kEndings.end();
}

}  // namespace

std::vector<fs::path> files_of_lesson(const Places& places, const fs::path& folder,
                                      const LessonDescription& lesson,
                                      std::vector<fs::path> sources) {
    std::vector<fs::path> files = std::move(sources);
    for (const MaterialDescription& material : lesson.materials) {
        if (!material.image.empty()) {
            files.push_back(folder / material.image);
        }
    }
    for (const NamedModel& model : models_of(lesson)) {
        const fs::path file = find_model(places, folder, model.name);
        if (!file.empty() && file == folder / file.filename()) {
            files.push_back(file);
        }
    }
    return files;
}

WatchedFiles::Stamp WatchedFiles::stamp_of(const fs::path& file) {
    std::error_code error;
    Stamp stamp;
    stamp.written = fs::last_write_time(file, error);
    if (error) {
        return {};
    }
    stamp.bytes = fs::file_size(file, error);
    stamp.exists = !error;
    return stamp.exists ? stamp : Stamp{};
}

WatchedFiles::Stamps WatchedFiles::stamps_in(const fs::path& folder) {
    Stamps stamps;
    for (const fs::path& file : entries_of(folder)) {
        if (may_be_part_of_lesson(file)) {
            stamps.emplace(file, stamp_of(file));
        }
    }
    return stamps;
}

void WatchedFiles::watch_folder(const fs::path& folder) {
    folder_ = folder;
    stamps_ = stamps_in(folder);
}

void WatchedFiles::watch_only(const std::vector<fs::path>& files) {
    Stamps kept;
    for (const fs::path& file : files) {
        const auto before = stamps_.find(file);
        kept.emplace(file, before != stamps_.end() ? before->second : stamp_of(file));
    }
    folder_.clear();
    stamps_ = std::move(kept);
}

bool WatchedFiles::changed() const {
    if (!folder_.empty()) {
        return stamps_in(folder_) != stamps_;
    }
    return std::ranges::any_of(
        stamps_, [](const auto& entry) { return stamp_of(entry.first) != entry.second; });
}

bool WatchedFiles::changed_by(double now_s) {
    constexpr double kEvery_s = 0.25;
    if (now_s < looks_next_s_) {
        return false;
    }
    looks_next_s_ = now_s + kEvery_s;
    return changed();
}

}  // namespace fulcrum::runtime
