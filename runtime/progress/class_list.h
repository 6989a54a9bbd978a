// Classes and the three pictures by which a pupil is found: two on the card that everybody sees, one that the pupil alone knows.
//
//   ClassRecord 1 ── n ClassSetting     the newest of a name counts
//               1 ── n ClassCard        the newest of a pupil counts; who has one is in the class
//
// Facts, written once, as all progress is. No two cards of a class show the same two pictures, in whichever order. A pupil's third picture
// is drawn by chance from the others; it keeps slips and curiosity out, and is no password.
//
// Thread: any. Cost: in proportion to the rows.
#pragma once

#include "haptics/base/error.h"
#include "runtime/progress/records.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// What a card or a secret may be: models, which are called as what they are.
inline constexpr std::array<std::string_view, 12> kClassPictures{
    "apple", "banana", "bucket", "earth", "egg",  "flower",
    "gem",   "kite",   "ring",   "star",  "tree", "watermelon"};

/// Cards that fit on one picture; there are 66 pairs of pictures.
inline constexpr std::size_t kMostPupils = 36;

struct ClassRecord {
    RecordId id;
    std::string name;  ///< as a nickname; unique
    std::int64_t made_utc_ms = 0;

    bool operator==(const ClassRecord&) const = default;
};

/// Of a class, e.g. shown_as -> names.
struct ClassSetting {
    RecordId id;
    RecordId class_id;
    std::string name;  ///< not empty
    std::string value;
    std::int64_t kept_utc_ms = 0;

    bool operator==(const ClassSetting&) const = default;
};

/// Three of kClassPictures, each another.
struct PupilPictures {
    std::array<std::string, 2> card;
    std::string secret;

    bool operator==(const PupilPictures&) const = default;
};

struct ClassCard {
    RecordId id;
    RecordId class_id;
    LearnerId learner;
    PupilPictures pictures;
    std::int64_t kept_utc_ms = 0;

    bool operator==(const ClassCard&) const = default;
};

/// What is kept of classes, each list in the order of its writing; also what is to be kept at once, all of it or none.
struct ClassRows {
    std::vector<ClassRecord> classes;
    std::vector<ClassSetting> settings;
    std::vector<ClassCard> cards;
    std::vector<Learner> pupils;  ///< those of the cards, as read; kept by `enrol`
};

/// What is asked of a pupil: the card and the secret picture, or the name alone.
enum class ShownAs : std::uint8_t { pictures, names };

struct Pupil {
    Learner learner;
    PupilPictures pictures;
};

/// A class as it is now.
struct SchoolClass {
    ClassRecord record;
    ShownAs shown_as = ShownAs::pictures;
    std::vector<Pupil> pupils;  ///< by nickname
};

/// Pure. A row that names nobody who is known is passed over.
[[nodiscard]] std::vector<SchoolClass> list_classes(const ClassRows& rows);

/// The class of that name, however it is written; of an empty one the only class that there is. Refuses others, naming those there are.
[[nodiscard]] Expected<SchoolClass> find_class(const std::vector<SchoolClass>& classes,
                                               std::string_view name);
/// Whom a nickname means in a class, however it is written; null for nobody.
[[nodiscard]] const Pupil* find_pupil(const SchoolClass& one, std::string_view nickname);

/// "names" or "pictures"; refuses other words.
[[nodiscard]] Expected<ShownAs> read_shown_as(std::string_view word);
[[nodiscard]] std::string_view name_of(ShownAs shown_as) noexcept;
/// The name of the setting.
inline constexpr const char* kShownAs = "shown_as";

/// A number below the one given, each as likely as the others.
using Draw = std::function<std::size_t(std::size_t)>;
/// By the system's random numbers.
[[nodiscard]] std::size_t draw_by_chance(std::size_t below);

/// Whether the two cards show the same, in whichever order.
[[nodiscard]] bool is_same_card(const std::array<std::string, 2>& a,
                                const std::array<std::string, 2>& b) noexcept;

/// Pictures for one more pupil of a class: a card that nobody there has. Nothing where none is left.
[[nodiscard]] std::optional<PupilPictures> draw_pictures(const std::vector<Pupil>& others,
                                                         const Draw& draw);
/// One of the pictures that are not on the card, and another than `but`.
[[nodiscard]] std::string draw_secret(const std::array<std::string, 2>& card, std::string_view but,
                                      const Draw& draw);

/// Refuses what cannot be kept, in one sentence.
[[nodiscard]] Expected<void> validate(const PupilPictures& pictures);
[[nodiscard]] Expected<void> validate(const ClassRows& rows);

}  // namespace fulcrum::runtime
