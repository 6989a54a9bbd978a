#include "runtime/progress/class_list.h"

#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <unordered_map>

namespace fulcrum::runtime {
namespace {

constexpr std::array<std::string_view, 2> kShownWords{"pictures", "names"};

std::string all_pictures() {
    std::string all;
    for (const std::string_view picture : kClassPictures) {
        all.append(all.empty() ? "" : ", ").append(picture);
    }
    return all;
}

Expected<void> check_ids(std::initializer_list<const RecordId*> ids) {
    const bool good =
        std::ranges::all_of(ids, [](const RecordId* id) { return is_record_id(*id); });
    return good ? Expected<void>{}
                : fail("an id of a class is not 32 hexadecimal digits", {},
                       "make it with random_record_id");
}

template <class Record, class Check>
Expected<void> check_each(const std::vector<Record>& records, Check&& check) {
    for (const Record& record : records) {
        if (Expected<void> checked = check(record); !checked) {
            return checked;
        }
    }
    return {};
}

}  // namespace

std::vector<SchoolClass> list_classes(const ClassRows& rows) {
    std::vector<SchoolClass> classes;
    std::unordered_map<RecordId, std::size_t> places;
    for (const ClassRecord& record : rows.classes) {
        places.emplace(record.id, classes.size());
        classes.push_back({record, ShownAs::pictures, {}});
    }
    std::unordered_map<LearnerId, const Learner*> learners;
    for (const Learner& learner : rows.pupils) {
        learners.emplace(learner.id, &learner);
    }
    for (const ClassSetting& setting : rows.settings) {
        const auto place = places.find(setting.class_id);
        const auto shown = read_shown_as(setting.value);
        if (place != places.end() && setting.name == kShownAs && shown) {
            classes[place->second].shown_as = *shown;
        }
    }
    for (const ClassCard& card : rows.cards) {
        const auto place = places.find(card.class_id);
        const auto learner = learners.find(card.learner);
        if (place == places.end() || learner == learners.end()) {
            continue;
        }
        std::vector<Pupil>& pupils = classes[place->second].pupils;
        const auto known = std::ranges::find(pupils, card.learner,
                                             [](const Pupil& pupil) { return pupil.learner.id; });
        if (known == pupils.end()) {
            pupils.push_back({*learner->second, card.pictures});
        } else {
            known->pictures = card.pictures;
        }
    }
    for (SchoolClass& one : classes) {
        std::ranges::sort(one.pupils, {}, [](const Pupil& pupil) {
            return std::pair(folded_nickname(pupil.learner.nickname), pupil.learner.id);
        });
    }
    return classes;
}

Expected<SchoolClass> find_class(const std::vector<SchoolClass>& classes, std::string_view name) {
    if (name.empty() && classes.size() == 1) {
        return classes.front();
    }
    std::string all;
    for (const SchoolClass& one : classes) {
        if (!name.empty() && folded_nickname(one.record.name) == folded_nickname(name)) {
            return one;
        }
        all.append(all.empty() ? "\"" : ", \"").append(one.record.name).append("\"");
    }
    if (classes.empty()) {
        return fail("there is no class yet", {}, "make one: fulcrum class new 4b Mina Jonas");
    }
    return fail(name.empty() ? "there are several classes"
                             : "there is no class \"" + std::string(name) + '"',
                {}, "name one of them with --class: " + all);
}

const Pupil* find_pupil(const SchoolClass& one, std::string_view nickname) {
    const auto found = std::ranges::find(
        one.pupils, folded_nickname(nickname),
        [](const Pupil& pupil) { return folded_nickname(pupil.learner.nickname); });
    return found == one.pupils.end() ? nullptr : &*found;
}

Expected<ShownAs> read_shown_as(std::string_view word) {
    const auto found = std::ranges::find(kShownWords, word);
    if (found == kShownWords.end()) {
        return fail("a class is not shown as \"" + std::string(word) + '"', {},
                    "write pictures or names");
    }
    return static_cast<ShownAs>(found - kShownWords.begin());
}

std::string_view name_of(ShownAs shown_as) noexcept {
    return kShownWords[static_cast<std::size_t>(shown_as)];
}

// Of 2^60 numbers the last few would be rarer; nobody lives to see it.
std::size_t draw_by_chance(std::size_t below) {
    constexpr std::size_t kDigits = 15;
    return std::stoull(random_record_id().substr(0, kDigits), nullptr, 16) % below;
}

bool is_same_card(const std::array<std::string, 2>& a,
                  const std::array<std::string, 2>& b) noexcept {
    return a == b || (a[0] == b[1] && a[1] == b[0]);
}

std::optional<PupilPictures> draw_pictures(const std::vector<Pupil>& others, const Draw& draw) {
    std::vector<std::array<std::string, 2>> free;
    for (const std::string_view first : kClassPictures) {
        for (const std::string_view second : kClassPictures) {
            const std::array<std::string, 2> card{std::string(first), std::string(second)};
            if (first != second && std::ranges::none_of(others, [&](const Pupil& other) {
                    return is_same_card(other.pictures.card, card);
                })) {
                free.push_back(card);
            }
        }
    }
    if (free.empty()) {
        return std::nullopt;
    }
    const auto& card = free[draw(free.size())];
    return PupilPictures{card, draw_secret(card, {}, draw)};
}

std::string draw_secret(const std::array<std::string, 2>& card, std::string_view but,
                        const Draw& draw) {
    std::vector<std::string_view> free;
    std::ranges::copy_if(kClassPictures, std::back_inserter(free), [&](std::string_view picture) {
        return picture != card[0] && picture != card[1] && picture != but;
    });
    return std::string(free[draw(free.size())]);
}

Expected<void> validate(const PupilPictures& pictures) {
    for (const std::string* word : {&pictures.card[0], &pictures.card[1], &pictures.secret}) {
        if (std::ranges::find(kClassPictures, *word) == kClassPictures.end()) {
            return fail("there is no picture \"" + *word + '"', {},
                        "write three of " + all_pictures());
        }
    }
    if (pictures.card[0] == pictures.card[1] || pictures.secret == pictures.card[0] ||
        pictures.secret == pictures.card[1]) {
        return fail("a pupil's three pictures are not three", {},
                    "write three of " + all_pictures() + ", each another");
    }
    return {};
}

Expected<void> validate(const ClassRows& rows) {
    return check_each(rows.classes,
                      [](const ClassRecord& one) -> Expected<void> {
                          return check_ids({&one.id}).and_then([&]() -> Expected<void> {
                              const auto name = checked_nickname(one.name);
                              return name && *name == one.name
                                         ? Expected<void>{}
                                         : fail("the class \"" + kept_text(one.name) +
                                                    "\" cannot be called so",
                                                {}, "give 1 to 40 letters, digits and blanks");
                          });
                      })
        .and_then([&] {
            return check_each(rows.settings, [](const ClassSetting& one) -> Expected<void> {
                return check_ids({&one.id, &one.class_id}).and_then([&] {
                    return one.name.empty()
                               ? fail("the setting of a class has no name", {}, "give it one")
                               : Expected<void>{};
                });
            });
        })
        .and_then([&] {
            return check_each(rows.cards, [](const ClassCard& one) -> Expected<void> {
                return check_ids({&one.id, &one.class_id, &one.learner}).and_then([&] {
                    return validate(one.pictures);
                });
            });
        });
}

}  // namespace fulcrum::runtime
