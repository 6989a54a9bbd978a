#include "runtime/app/who_screen.h"

#include "runtime/app/menu_screen.h"
#include "runtime/app/run_learner.h"
#include "runtime/progress/guest_name.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

dialogue::Catalogue words() {
    std::ifstream file(FULCRUM_SOURCE_DIR "/assets/words/en.txt");
    return value_of(
        dialogue::Catalogue::parse(std::string(std::istreambuf_iterator<char>(file), {})));
}

SchoolClass class_of(std::size_t n_pupils, ShownAs shown_as = ShownAs::pictures) {
    SchoolClass one{{random_record_id(), "4b", 0}, shown_as, {}};
    for (std::size_t i = 0; i < n_pupils; ++i) {
        one.pupils.push_back({{random_record_id(), "pupil " + std::to_string(i), 0},
                              value_of(draw_pictures(one.pupils, draw_by_chance))});
    }
    return one;
}

std::vector<std::string> titles_of(const View& view) {
    std::vector<std::string> titles;
    for (const ViewMenuItem& item : view.menu) {
        titles.push_back(item.title);
    }
    return titles;
}

// What a run keeps under.
RunLearner learner_of(const RunRequest& request, ProgressStore& store,
                      const LessonDescription& lesson = {}) {
    Plan plan;
    const Places places;
    return value_of(find_learner({places, request}, lesson, store, plan));
}

RunRequest of_guest(const std::string& guest) {
    RunRequest request;
    request.guest = guest;
    return request;
}

}  // namespace

TEST_CASE("who: each pupil has a card with two pictures and a name, and the last is a guest's") {
    const SchoolClass one = class_of(kMostPupils);
    const View view = pupils_view(one, {3, 0}, words());
    REQUIRE(view.menu.size() == kMostPupils + 1);
    for (std::size_t i = 0; i < kMostPupils; ++i) {
        CHECK(view.menu[i].title == one.pupils[i].learner.nickname);
        CHECK(view.menu[i].icon == one.pupils[i].pictures.card[0]);
        CHECK(view.menu[i].second_icon == one.pupils[i].pictures.card[1]);
    }
    CHECK(view.menu.back().title == "Guest");
    CHECK(view.menu.back().icon == kGuestPicture);
    CHECK(std::ranges::find(kClassPictures, kGuestPicture) == kClassPictures.end());
    CHECK(view.title == "Who are you?");
    CHECK(view.menu_selected == 3);
    CHECK(view.menu_is_small);
    CHECK_FALSE(view.input_visible);
    CHECK_FALSE(view.tool_visible);
}

TEST_CASE("who: a class shown as names shows no pictures") {
    const View view = pupils_view(class_of(3, ShownAs::names), {}, words());
    CHECK(titles_of(view) == std::vector<std::string>{"pupil 0", "pupil 1", "pupil 2", "Guest"});
    for (const ViewMenuItem& item : view.menu) {
        CHECK((item.icon.empty() && item.second_icon.empty()));
    }
}

TEST_CASE("who: of several classes each is a card") {
    const View view = classes_view({class_of(1), class_of(2)}, {1, 0}, words());
    CHECK(titles_of(view) == std::vector<std::string>{"4b", "4b"});
    CHECK(view.menu[0].icon != view.menu[1].icon);
    CHECK(view.menu_selected == 1);
}

TEST_CASE("who: the secret pictures are all there, alike for each pupil, and tell nobody's") {
    const SchoolClass one = class_of(2);
    const View first = secret_view(one.pupils[0], {}, words(), SecretSaid::asked);
    const View second = secret_view(one.pupils[1], {}, words(), SecretSaid::asked);
    CHECK(titles_of(first) == titles_of(second));
    REQUIRE(first.menu.size() == kClassPictures.size() + 1);
    for (std::size_t i = 0; i < kClassPictures.size(); ++i) {
        CHECK(first.menu[i].icon == kClassPictures[i]);
        CHECK(first.menu[i].title == kClassPictures[i]);  // a word, no key
    }
    CHECK(first.menu.back().leads_back);
    CHECK(first.title == "Hello, pupil 0!");
    CHECK(first.caption == "Which is your picture?");
    CHECK(secret_view(one.pupils[0], {}, words(), SecretSaid::wrong).caption ==
          "That is not your picture.");
}

TEST_CASE("who: pictures that are turned down show nothing and move no card") {
    const View up = secret_view(class_of(1).pupils[0], {2, 0}, words(), SecretSaid::wrong);
    const View down = turned_down(up);
    REQUIRE(down.menu.size() == up.menu.size());
    for (const ViewMenuItem& item : down.menu) {
        CHECK((item.title.empty() && item.icon.empty() && !item.leads_back));
    }
    const auto boxes = [](const View& view) {
        return lay_out_menu(view, Measure(1280, 720), std::vector<runtime::Box>{}).cards;
    };
    for (std::size_t i = 0; i < boxes(up).size(); ++i) {
        CHECK(boxes(up)[i].box.x == boxes(down)[i].box.x);
        CHECK(boxes(up)[i].box.y == boxes(down)[i].box.y);
    }
}

TEST_CASE("who: one picture of all lets a pupil in, and no other place does") {
    for (const Pupil& pupil : class_of(kMostPupils).pupils) {
        int n_right = 0;
        for (int card = -2; card <= static_cast<int>(kClassPictures.size()) + 2; ++card) {
            if (is_secret_of(pupil, card)) {
                ++n_right;
                CHECK(kClassPictures.at(static_cast<std::size_t>(card)) == pupil.pictures.secret);
            }
        }
        CHECK(n_right == 1);
    }
}

TEST_CASE("who: each wrong picture in a row makes the wait longer, to eight seconds") {
    CHECK(wait_after_s(0) == 0.0);
    CHECK(wait_after_s(1) == 1.0);
    CHECK(wait_after_s(2) == 2.0);
    CHECK(wait_after_s(3) == 4.0);
    CHECK(wait_after_s(4) == 8.0);
    CHECK(wait_after_s(5) == 8.0);
    CHECK(wait_after_s(1'000'000) == 8.0);
}

TEST_CASE("who: whoever was found types no name, is greeted, and led back by the last card") {
    LessonCard lesson;
    lesson.title = "Weights";
    const MenuPlayer mina{"Mina", "guest 1", true};
    const View view = menu_view({lesson}, {}, words(), mina);
    CHECK(view.caption == "Hello, Mina! Choose a lesson.");
    CHECK_FALSE(view.input_visible);
    CHECK(view.input.empty());
    REQUIRE(view.menu.size() == 2);
    CHECK(view.menu[1].title == "Back");
    CHECK(view.menu[1].leads_back);
    const View guest = menu_view({lesson}, {}, words(), {"", "guest 1", true});
    CHECK(guest.caption == "Choose a lesson.");
    CHECK_FALSE(guest.input_visible);
    CHECK(menu_view({}, {}, words(), mina).menu.empty());
}

TEST_CASE("who: guests are apart from one another and from those of earlier versions") {
    const ScratchFolder folder;
    const auto store = value_of(open_sqlite_store(folder.file("progress.db")));
    const Learner old = value_of(store->enrol("guest"));
    const RunRequest first = of_guest(new_guest_name());
    const RunLearner one = learner_of(first, *store);
    const RunLearner again = learner_of(first, *store);
    const RunLearner other = learner_of(of_guest(new_guest_name()), *store);
    CHECK(one.id == again.id);
    CHECK(one.id != other.id);
    CHECK(one.id != old.id);
    CHECK(other.id != old.id);
    CHECK_FALSE(one.is_known);
}

TEST_CASE("who: whoever has a name is kept under it, as before, whatever the guest is called") {
    const ScratchFolder folder;
    const auto store = value_of(open_sqlite_store(folder.file("progress.db")));
    const Learner zoe = value_of(store->enrol("Zoë"));
    RunRequest request = of_guest(new_guest_name());
    request.learner = "zoe\xCC\x88 ";
    CHECK(learner_of(request, *store).id == zoe.id);
    CHECK(learner_of(request, *store).is_known);
    CHECK(value_of(store->read({})).learners == std::vector{zoe});
}

TEST_CASE("who: in a room nobody is enrolled, and it knows the lessons that it was given") {
    const ScratchFolder folder;
    const auto store = value_of(open_sqlite_store(folder.file("progress.db")));
    LessonDescription room;
    room.is_room = true;
    RunRequest request = of_guest("guest 1");
    request.lessons = {{"gravity", "Which?", "A1", "apple", 2}};
    const RunLearner visitor = learner_of(request, *store, room);
    CHECK_FALSE(visitor.is_known);
    REQUIRE(visitor.known.lessons.size() == 1);
    CHECK(visitor.known.lessons[0].stars == 2);
    CHECK(value_of(store->read({})).learners.empty());
    (void)learner_of(request, *store);
    CHECK(value_of(store->read({})).learners.size() == 1);
}
