#include "runtime/app/screen_trouble.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// Each text is its key.
fulcrum::dialogue::Catalogue words() {
    std::string text;
    for (const char* key :
         {"banner.stopped", "banner.retry", "banner.busy", "banner.slow", "banner.device_lost",
          "banner.not_saved", "banner.hold_still", "hud.emergency"}) {
        text += std::string(key) + " = " + key + "\n";
    }
    return fulcrum::dialogue::Catalogue::parse(text + "banner.teacher = {sentence}\n").value();
}

}  // namespace

TEST_CASE("screen trouble: the worst is told, and where nothing plays Enter begins again") {
    const auto catalogue = words();
    struct Case {
        ScreenTrouble trouble;
        const char* key;
        bool begins_again;
        bool is_error;
    };
    const Case cases[] = {
        {{}, "", false, false},
        {{.waited_s = 0.4}, "", false, false},
        {{.holds_back = true}, "banner.hold_still", false, false},
        {{.is_unkept = true, .holds_back = true}, "banner.not_saved", false, false},
        {{.device_is_lost = true, .is_unkept = true}, "banner.device_lost", false, true},
        {{.waited_s = 0.6, .device_is_lost = true}, "banner.slow", false, false},
        {{.waited_s = 9.9, .is_stopped = true}, "hud.emergency", false, true},
        {{.waited_s = 10.1, .is_stopped = true}, "banner.busy", true, true},
    };
    for (const Case& c : cases) {
        CAPTURE(c.trouble.waited_s, c.trouble.is_stopped, c.trouble.device_is_lost);
        View view;
        view.choices = {{}};
        show(c.trouble, catalogue, view);
        CHECK(view.banner == c.key);
        CHECK(view.banner_is_error == c.is_error);
        CHECK(offers_another_begin(c.trouble) == c.begins_again);
        CHECK(view.caption.empty() != c.begins_again);
        CHECK(view.choices.size() == 1);
    }
    View view;
    view.choices = {{}};
    view.input_visible = true;
    show({.error = "lesson.lua:3: no.", .waited_s = 20.0}, catalogue, view);
    CHECK(view.banner == "banner.stopped lesson.lua:3: no.");
    CHECK(view.choices.empty());
    CHECK_FALSE(view.input_visible);
}
