// Notices that a file of a lesson was saved: its Lua, its pictures, its models.
//
// Thread: main. Cost: one look at each file's date and size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace fulcrum::runtime {

struct LessonDescription;
struct Places;

/// The files that a lesson which could be loaded is made of: `sources` (its Lua files), the pictures of its materials and the
/// models that lie beside it. A file that more than one thing uses comes more than once.
[[nodiscard]] std::vector<std::filesystem::path> files_of_lesson(
    const Places& places, const std::filesystem::path& folder, const LessonDescription& lesson,
    std::vector<std::filesystem::path> sources);

/// Remembers how files lay on the disk and tells when one of them is another.
class WatchedFiles {
  public:
    /// Watches whatever in the folder can be part of a lesson (Lua, PNG, JPEG, glTF), also what is still to come. Called before the
    /// lesson is loaded, so that what is saved meanwhile is noticed; it stays so when the lesson cannot be loaded.
    void watch_folder(const std::filesystem::path& folder);

    /// From now on only these count, wherever they lie. Those of the folder are compared with how they lay at
    /// `watch_folder`, the others with how they lie now.
    void watch_only(const std::vector<std::filesystem::path>& files);

    /// A file was written, grew, shrank, came or went.
    [[nodiscard]] bool changed() const;
    /// The same, looked at four times a second at most; false in between. `now_s`: of any clock.
    [[nodiscard]] bool changed_by(double now_s);

  private:
    /// A date and a size: an older file that is copied over a newer one is another one too.
    struct Stamp {
        bool exists = false;
        std::filesystem::file_time_type written{};
        std::uintmax_t bytes = 0;
        bool operator==(const Stamp&) const = default;
    };
    using Stamps = std::map<std::filesystem::path, Stamp>;
    [[nodiscard]] static Stamp stamp_of(const std::filesystem::path& file);
    [[nodiscard]] static Stamps stamps_in(const std::filesystem::path& folder);

    std::filesystem::path folder_;  // empty: only the files of stamps_ count
    Stamps stamps_;
    double looks_next_s_ = 0.0;
};

}  // namespace fulcrum::runtime
