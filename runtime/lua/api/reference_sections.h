// What the reference says beside the binding table: events, answers and their templates, names of sounds and models, tests,
// and the modules of scripts/lib as their own comments tell it.
//
// Thread: pure functions.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// A field of a table that the program gives to a lesson.
struct FieldText {
    std::string_view name;
    std::string_view type;  ///< for the annotations
    std::string_view text;
};

/// What an answer has, beside its slots: in L:answered, in the event "answered" and in what story.ask gives.
[[nodiscard]] std::span<const FieldText> answer_fields();

/// What the events of L:listen and story.wait_for have beside `name`.
struct EventText {
    std::string_view name;
    std::string_view text;
    std::vector<std::string_view> fields;
};
[[nodiscard]] std::vector<EventText> event_texts();

/// The models that the program makes, and those that need no file.
inline constexpr std::array<std::string_view, 44> kModelNames{
    "watermelon", "apple",     "banana", "egg",    "bucket",  "cursor", "ghost",   "star",
    "ground",     "hill",      "tree",   "cloud",  "flower",  "plank",  "sphere",  "box",
    "cloth",      "spaceship", "table",  "statue", "bell",    "chair",  "castle",  "sun",
    "mercury",    "venus",     "earth",  "mars",   "jupiter", "saturn", "uranus",  "neptune",
    "lever",      "support",   "ring",   "bowl",   "walker",  "gem",    "handles", "cylinder",
    "capsule",    "hand",      "kite",   "orbit"};

/// A file of scripts/lib.
struct LibraryModule {
    std::string name;  ///< "story"
    std::string text;
};

/// The sections on events, answers, templates, sounds, models and tests.
[[nodiscard]] std::string general_sections();

/// A section of the reference out of a module's comments: the block at the head of the file, and each block that stands
/// before a function of the module.
[[nodiscard]] std::string library_section(const LibraryModule& module);

}  // namespace fulcrum::runtime
