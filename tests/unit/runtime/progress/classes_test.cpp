#include "runtime/progress/class_list.h"
#include "runtime/progress/guest_name.h"
#include "runtime/progress/name_list.h"
#include "runtime/progress/store.h"
#include "runtime/progress/text_rules.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

using Strings = std::vector<std::string>;

// A pupil more for each call, with pictures that the class has not.
Pupil join(std::vector<Pupil>& pupils, const Draw& draw) {
    const auto pictures = draw_pictures(pupils, draw);
    REQUIRE(pictures);
    pupils.push_back(
        {{random_record_id(), "pupil " + std::to_string(pupils.size()), 0}, *pictures});
    return pupils.back();
}

std::size_t last(std::size_t below) {
    return below - 1;
}

ClassRows rows_of(const Strings& names) {
    ClassRows rows;
    rows.classes.push_back({random_record_id(), "4b", 1});
    for (const std::string& name : names) {
        rows.pupils.push_back({random_record_id(), name, 2});
        rows.cards.push_back({random_record_id(),
                              rows.classes[0].id,
                              rows.pupils.back().id,
                              {{"apple", "kite"}, "egg"},
                              3});
    }
    return rows;
}

std::string why_not(const Strings& names) {
    const auto checked = check_names(names);
    return checked ? "" : to_sentence(checked.error());
}

std::string why_not(std::string_view text) {
    const auto read = read_name_list(text, "4b.txt");
    return read ? "" : to_sentence(read.error());
}

}  // namespace

TEST_CASE("class: 36 pupils have 36 cards, no two alike in whichever order, whatever is drawn") {
    for (const Draw& draw :
         {Draw(draw_by_chance), Draw(last), Draw([](std::size_t) { return 0U; })}) {
        std::vector<Pupil> pupils;
        std::set<std::set<std::string>> cards;
        for (std::size_t i = 0; i < kMostPupils; ++i) {
            const PupilPictures pictures = join(pupils, draw).pictures;
            CHECK(validate(pictures));
            cards.insert({pictures.card[0], pictures.card[1]});
        }
        CHECK(cards.size() == kMostPupils);
        for (const auto& card : cards) {
            CHECK(card.size() == 2);
        }
    }
}

TEST_CASE("class: cards are found until each pair of pictures has one, and then none") {
    std::vector<Pupil> pupils;
    for (std::size_t i = 0; i < kClassPictures.size() * (kClassPictures.size() - 1) / 2; ++i) {
        (void)join(pupils, last);
    }
    CHECK_FALSE(draw_pictures(pupils, last));
}

TEST_CASE("class: a secret is any picture that is not on the card, and a new one another") {
    std::set<std::string> secrets;
    for (std::size_t i = 0; i < 20; ++i) {
        secrets.insert(draw_secret({"apple", "kite"}, "egg", [&](std::size_t below) {
            CHECK(below == kClassPictures.size() - 3);
            return i % below;
        }));
    }
    CHECK(secrets.size() == kClassPictures.size() - 3);
    for (const char* taken : {"apple", "kite", "egg"}) {
        CHECK_FALSE(secrets.contains(taken));
    }
}

TEST_CASE("class: chance draws each number below, and no other") {
    std::set<std::size_t> drawn;
    for (int i = 0; i < 1000; ++i) {
        drawn.insert(draw_by_chance(7));  // one is missing once in 10^66
    }
    CHECK(drawn == std::set<std::size_t>{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("class: what a pupil's pictures cannot be is refused with those there are") {
    for (const PupilPictures& bad : {PupilPictures{{"apple", "apple"}, "egg"},
                                     {{"apple", "kite"}, "kite"},
                                     {{"apple", "kite"}, "apple"},
                                     {{"apple", "elephant"}, "kite"},
                                     {{"", "apple"}, "kite"},
                                     {{"kite", "apple"}, ""}}) {
        const auto checked = validate(bad);
        REQUIRE_FALSE(checked);
        check_says(to_sentence(checked.error()), {"apple, banana, "});
        ClassRows rows = rows_of({"Mina"});
        rows.cards[0].pictures = bad;
        CHECK_FALSE(validate(rows));
    }
    CHECK(validate(rows_of({"Mina"})));
}

TEST_CASE("class: rows without ids and names are refused") {
    const auto bad = [](auto change) {
        ClassRows rows = rows_of({"Mina"});
        rows.settings.push_back({random_record_id(), rows.classes[0].id, "shown_as", "names", 1});
        CHECK(validate(rows));
        change(rows);
        CHECK_FALSE(validate(rows));
    };
    bad([](ClassRows& rows) { rows.classes[0].id = "4b"; });
    bad([](ClassRows& rows) { rows.classes[0].name = " 4b"; });
    bad([](ClassRows& rows) { rows.classes[0].name = ""; });
    bad([](ClassRows& rows) { rows.settings[0].name = ""; });
    bad([](ClassRows& rows) { rows.settings[0].id = ""; });
    bad([](ClassRows& rows) { rows.settings[0].class_id = ""; });
    bad([](ClassRows& rows) { rows.cards[0].id = ""; });
    bad([](ClassRows& rows) { rows.cards[0].class_id = ""; });
    bad([](ClassRows& rows) { rows.cards[0].learner = ""; });
}

TEST_CASE("class: pupils stand by name, and the newest card and setting of each count") {
    ClassRows rows = rows_of({"mina", "Anna", "Zoë"});
    const PupilPictures other{{"star", "tree"}, "ring"};
    rows.cards.push_back({random_record_id(), rows.classes[0].id, rows.pupils[0].id, other, 4});
    for (const char* shown : {"names", "pictures", "names", "walls"}) {
        rows.settings.push_back({random_record_id(), rows.classes[0].id, kShownAs, shown, 1});
    }
    rows.settings.push_back({random_record_id(), rows.classes[0].id, "room", "pictures", 1});
    rows.cards.push_back({random_record_id(), random_record_id(), rows.pupils[0].id, other, 4});
    rows.cards.push_back({random_record_id(), rows.classes[0].id, random_record_id(), other, 4});
    const auto classes = list_classes(rows);
    REQUIRE(classes.size() == 1);
    CHECK(classes[0].record == rows.classes[0]);
    CHECK(classes[0].shown_as == ShownAs::names);
    REQUIRE(classes[0].pupils.size() == 3);
    CHECK(classes[0].pupils[0].learner == rows.pupils[1]);
    CHECK(classes[0].pupils[1].learner == rows.pupils[0]);
    CHECK(classes[0].pupils[2].learner == rows.pupils[2]);
    CHECK(classes[0].pupils[0].pictures == rows.cards[1].pictures);
    CHECK(classes[0].pupils[1].pictures == other);
    CHECK(list_classes(rows_of({}))[0].shown_as == ShownAs::pictures);
}

TEST_CASE(
    "class: it and its pupils are found however their names are written, and none by a slip") {
    std::vector<SchoolClass> classes = list_classes(rows_of({"Zoë"}));
    CHECK_FALSE(find_class({}, ""));
    CHECK(find_class(classes, "")->record.name == "4b");
    CHECK(find_class(classes, " 4B ")->record.name == "4b");
    CHECK_FALSE(find_class(classes, "4c"));
    CHECK(find_pupil(classes[0], "zoe\xCC\x88") == &classes[0].pupils[0]);
    CHECK(find_pupil(classes[0], "Zoe") == nullptr);
    ClassRows second = rows_of({});
    second.classes[0].name = "5a";
    classes.push_back(list_classes(second)[0]);
    CHECK(find_class(classes, "5A")->record.name == "5a");
    const auto which = find_class(classes, "");
    REQUIRE_FALSE(which);
    check_says(to_sentence(which.error()), {"several", "--class", "\"4b\", \"5a\""});
}

TEST_CASE("class: a store that has none keeps none, and says so") {
    const auto store = make_null_store();
    CHECK(store->read_classes()->classes.empty());
    CHECK_FALSE(store->add_class_rows(rows_of({"Mina"})));
}

TEST_CASE("names: one a line, whatever ends lines, begins the file or lies empty between") {
    const std::string text =
        "\xEF\xBB\xBF"
        "Mina\r\n\n  Zoe\xCC\x88 \n \t\n민수\nAnna Maria";
    CHECK(value_of(read_name_list(text, "4b.txt")) ==
          Strings{"Mina", "Zo\xC3\xAB", "민수", "Anna Maria"});
    CHECK(value_of(check_names({"Mina", " Tim "})) == Strings{"Mina", "Tim"});
}

TEST_CASE("names: what cannot be is refused with its file, its line and what to write instead") {
    check_says(why_not("Mina\nTim\n\nmina\n"),
               {"4b.txt:4: \"mina\" stands there twice (first in 4b.txt:1)", "\"mina B\""});
    check_says(why_not("Mina\nTi\x01m\n"), {"4b.txt:2: ", "control character"});
    check_says(why_not("Mina\n\xFF\n"), {"4b.txt:2: ", "UTF-8"});
    check_says(why_not(std::string(41, 'a')), {"4b.txt:1: ", "1 to 40"});
    check_says(why_not(" \n\n"), {"4b.txt: there are no names", "one a line"});
    check_says(why_not(""), {"4b.txt: there are no names"});
    check_says(why_not(Strings{}), {"there are no names", "--names FILE"});
    check_says(why_not(Strings{"A", "a"}), {"\"a\" stands there twice"});
    check_says(why_not("simulated pupil"), {"4b.txt:1: ", "of its own"});
    for (const std::string& own : {new_guest_name(), std::string("Guest")}) {
        check_says(why_not(Strings{own}), {"of its own"});
    }
    Strings names;
    std::string text;
    for (std::size_t i = 0; i < kMostPupils; ++i) {
        names.push_back("pupil " + std::to_string(i));
        text += names.back() + '\n';
    }
    CHECK(why_not(names).empty());
    CHECK(why_not(text).empty());
    names.emplace_back("one more");
    check_says(why_not(names), {"37 names", "36 pupils at most"});
    check_says(why_not(text + "one more"), {"4b.txt: there are 37 names", "two classes"});
}

TEST_CASE("guest name: each is another, is known as a guest's, and is a nickname") {
    const std::string one = new_guest_name();
    CHECK(one != new_guest_name());
    CHECK(is_guest_name(one));
    CHECK(value_of(checked_nickname(one)) == one);
    CHECK(folded_nickname(one) == one);  // so no two fold to one
    const std::string morning = guest_name_at(1'772'446'500'000, "0123456789abcdef");
    CHECK(is_guest_name(morning));
    check_says(morning, {"guest 2026-03-0", " 01234567"});
    CHECK(morning.size() == one.size());
}

TEST_CASE("guest name: no name that somebody gives is taken for one") {
    for (const char* name :
         {"guest", "Guest", "", "Mina", "guest 2026-11-30 14:05", "guest 2026-11-30 14:05 7f3a91c",
          "guest 2026-11-30 14:05 7f3a91c20", "guest 2026-11-30 14:05 7f3a91cg",
          "guest 2026-11-30 14:05 7F3A91C2", "Guest 2026-11-30 14:05 7f3a91c2",
          "guest 2026-1a-30 14:05 7f3a91c2"}) {
        CHECK_FALSE(is_guest_name(name));
    }
    CHECK(is_guest_name("guest 2026-11-30 14:05 7f3a91c2"));
}
