// fulcrum class: a teacher makes a class, adds to it, looks who has which pictures, gives others, and says how it is shown.
#include "runtime/app/commands.h"
#include "runtime/app/open_store.h"
#include "runtime/progress/class_list.h"
#include "runtime/progress/name_list.h"
#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <span>

namespace fulcrum::runtime {
namespace {

using Words = std::span<const std::string>;

constexpr std::size_t kLongestList_bytes = 65536;

Expected<std::string> read_text(const std::string& file) {
    std::ifstream opened;
    if (file != "-") {
        opened.open(file, std::ios::binary);
    }
    std::istream& in = file == "-" ? std::cin : opened;
    std::string text(kLongestList_bytes + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (in.bad() || !in.eof()) {
        return text.size() > kLongestList_bytes
                   ? fail("this is no list of a class, it is too long", file, "write a name a line")
                   : fail("the names cannot be read", file, "name a file with a name a line");
    }
    return text;
}

// A file's, or those that stand behind the command.
Expected<std::vector<std::string>> read_names(const Options& options, Words words) {
    if (options.names_file.empty()) {
        return check_names({words.begin(), words.end()});
    }
    if (!words.empty()) {
        return fail("\"" + words[0] + "\" and --names are names twice", {},
                    "write them in the file, or behind the command");
    }
    return read_text(options.names_file).and_then([&](const std::string& text) {
        return read_name_list(text,
                              options.names_file == "-" ? "standard input" : options.names_file);
    });
}

Expected<std::vector<SchoolClass>> read_classes(ProgressStore& store) {
    return store.read_classes().map([](const ClassRows& rows) { return list_classes(rows); });
}

void tell_pupil(const Pupil& pupil, std::size_t width) {
    const std::string name = kept_text(pupil.learner.nickname);
    const auto& [card, secret] = pupil.pictures;
    const std::string both = card[0] + " and " + card[1];
    std::printf("  %s%s  %-24s  secret: %s\n", name.c_str(),
                std::string(width - std::min(width, display_width(name)), ' ').c_str(),
                both.c_str(), secret.c_str());
}

void tell_class(const SchoolClass& one) {
    std::printf("%s: %zu %s, shown as %s\n", kept_text(one.record.name).c_str(), one.pupils.size(),
                one.pupils.size() == 1 ? "pupil" : "pupils",
                std::string(name_of(one.shown_as)).c_str());
    std::size_t width = 0;
    for (const Pupil& pupil : one.pupils) {
        width = std::max(width, display_width(pupil.learner.nickname));
    }
    for (const Pupil& pupil : one.pupils) {
        tell_pupil(pupil, width);
    }
}

// Enrols them and draws their pictures, beside who is there; what is made anew goes into `rows`.
Expected<void> add_pupils(ProgressStore& store, const std::vector<std::string>& names,
                          SchoolClass& one, ClassRows& rows) {
    if (one.pupils.size() + names.size() > kMostPupils) {
        return fail("the class would have " + std::to_string(one.pupils.size() + names.size()) +
                        " pupils, and " + std::to_string(kMostPupils) + " are the most",
                    one.record.name, "make another class");
    }
    for (const std::string& name : names) {
        if (find_pupil(one, name) != nullptr) {
            return fail("\"" + name + "\" is in the class already", one.record.name,
                        "leave the name out, or write another");
        }
    }
    for (const std::string& name : names) {
        auto learner = store.enrol(name);
        if (!learner) {
            return tl::unexpected(learner.error());
        }
        const auto pictures = draw_pictures(one.pupils, draw_by_chance);
        if (!pictures) {
            return fail("no card is left", one.record.name, "make another class");
        }
        rows.cards.push_back(
            {random_record_id(), one.record.id, learner->id, *pictures, utc_now_ms()});
        one.pupils.push_back({std::move(*learner), *pictures});
    }
    return {};
}

Expected<void> keep_and_tell(ProgressStore& store, const ClassRows& rows, const std::string& name) {
    return store.add_class_rows(rows)
        .and_then([&] { return read_classes(store); })
        .and_then([&](const auto& classes) { return find_class(classes, name); })
        .map([](const SchoolClass& now) { tell_class(now); });
}

Expected<void> make_class(ProgressStore& store, const Options& options, Words words) {
    if (words.empty()) {
        return fail("a new class needs a name", {}, "write for instance fulcrum class new 4b Mina");
    }
    const auto name = checked_nickname(words[0]);
    if (!name) {
        return fail("the class \"" + words[0] + "\" cannot be called so", {},
                    "give 1 to 40 letters, digits and blanks");
    }
    const auto names = read_names(options, words.subspan(1));
    if (!names) {
        return tl::unexpected(names.error());
    }
    const auto classes = read_classes(store);
    if (!classes) {
        return tl::unexpected(classes.error());
    }
    if (find_class(*classes, *name)) {
        return fail("there is a class \"" + *name + "\" already", {},
                    "add to it with fulcrum class add NAME --class \"" + *name + '"');
    }
    ClassRows rows;
    SchoolClass one{{random_record_id(), *name, utc_now_ms()}, ShownAs::pictures, {}};
    rows.classes.push_back(one.record);
    return add_pupils(store, *names, one, rows).and_then([&] {
        return keep_and_tell(store, rows, *name);
    });
}

Expected<void> add_to_class(ProgressStore& store, const Options& options, SchoolClass one,
                            Words words) {
    return read_names(options, words).and_then([&](const std::vector<std::string>& names) {
        ClassRows rows;
        return add_pupils(store, names, one, rows).and_then([&] {
            return keep_and_tell(store, rows, one.record.name);
        });
    });
}

Expected<void> show_class(ProgressStore& store, const SchoolClass& one, Words words) {
    if (words.size() != 1) {
        return fail("how shall the class be shown", {}, "write pictures or names");
    }
    return read_shown_as(words[0]).and_then([&](ShownAs) {
        ClassRows rows;
        rows.settings.push_back(
            {random_record_id(), one.record.id, kShownAs, words[0], utc_now_ms()});
        return keep_and_tell(store, rows, one.record.name);
    });
}

// Those that are said, else another secret beside the same card.
Expected<PupilPictures> other_pictures(const SchoolClass& one, const Pupil& pupil, Words words) {
    if (words.empty()) {
        const auto& [card, secret] = pupil.pictures;
        return PupilPictures{card, draw_secret(card, secret, draw_by_chance)};
    }
    if (words.size() != 3) {
        return fail("a pupil has three pictures", {},
                    "write two for the card and then the secret one, or none for a new secret");
    }
    const PupilPictures pictures{{words[0], words[1]}, words[2]};
    if (auto checked = validate(pictures); !checked) {
        return tl::unexpected(checked.error());
    }
    for (const Pupil& other : one.pupils) {
        if (other.learner.id != pupil.learner.id &&
            is_same_card(other.pictures.card, pictures.card)) {
            return fail(words[0] + " and " + words[1] + " are on the card of \"" +
                            other.learner.nickname + '"',
                        one.record.name, "write other pictures");
        }
    }
    return pictures;
}

Expected<void> give_pictures(ProgressStore& store, const SchoolClass& one, Words words) {
    if (words.empty()) {
        return fail("whose picture shall be another", {}, "write fulcrum class picture NAME");
    }
    const Pupil* const pupil = find_pupil(one, words[0]);
    if (pupil == nullptr) {
        return fail("there is no pupil \"" + words[0] + "\" in this class", one.record.name,
                    "fulcrum class list shows who is");
    }
    return other_pictures(one, *pupil, words.subspan(1))
        .and_then([&](const PupilPictures& pictures) {
            ClassRows rows;
            rows.cards.push_back(
                {random_record_id(), one.record.id, pupil->learner.id, pictures, utc_now_ms()});
            return store.add_class_rows(rows).map([&] {
                tell_pupil({pupil->learner, pictures}, 0);
            });
        });
}

Expected<void> tell_classes(const std::vector<SchoolClass>& classes, const std::string& only,
                            Words words) {
    if (!words.empty()) {
        return fail("\"" + words[0] + "\" is one word too many", {},
                    "write fulcrum class list, or with --class NAME one alone");
    }
    if (classes.empty()) {
        std::printf("There is no class yet; make one: fulcrum class new 4b Mina Jonas\n");
        return {};
    }
    if (only.empty()) {
        std::ranges::for_each(classes, tell_class);
        return {};
    }
    return find_class(classes, only).map([](const SchoolClass& one) { tell_class(one); });
}

Expected<void> run_class_command(ProgressStore& store, const Options& options) {
    const std::string& what = options.words.front();
    const Words words = Words(options.words).subspan(1);
    if (what == "new") {
        return make_class(store, options, words);
    }
    return read_classes(store).and_then([&](const auto& classes) -> Expected<void> {
        if (what == "list") {
            return tell_classes(classes, options.class_name, words);
        }
        if (what != "add" && what != "show-as" && what != "picture") {
            return fail("\"" + what + "\" is nothing that can be done with a class", {},
                        "write new, add, list, show-as or picture");
        }
        return find_class(classes, options.class_name).and_then([&](const SchoolClass& one) {
            return what == "add"       ? add_to_class(store, options, one, words)
                   : what == "show-as" ? show_class(store, one, words)
                                       : give_pictures(store, one, words);
        });
    });
}

}  // namespace

int class_command(const Options& options) {
    const auto done = open_store(options.database).and_then([&](const auto& store) {
        return run_class_command(*store, options);
    });
    return done ? 0 : complain(done.error(), 2);
}

}  // namespace fulcrum::runtime
