#include "runtime/app/screen_trouble.h"

namespace fulcrum::runtime {
namespace {

constexpr double kShortWait_s = 0.5;  // in which nothing is said

}  // namespace

bool offers_another_begin(const ScreenTrouble& trouble) noexcept {
    return !trouble.error.empty() || trouble.waited_s > kLongestWindowWait_s;
}

void show(const ScreenTrouble& trouble, const dialogue::Catalogue& catalogue, View& view) {
    if (!trouble.error.empty()) {
        view.banner = catalogue.say("banner.stopped") + " " +
                      catalogue.say("banner.teacher", {{"sentence", trouble.error}});
        view.banner_is_error = true;
        view.caption = catalogue.say("banner.retry");
        view.feedback.clear();
        view.input_visible = false;
        view.choices.clear();
        view.why = {};
        view.force.visible = false;
    } else if (offers_another_begin(trouble)) {
        view.banner = catalogue.say("banner.busy");
        view.banner_is_error = true;
        view.caption = catalogue.say("banner.retry");
    } else if (trouble.is_paused) {
        view.force.visible = false;
        view.banner = catalogue.say("hud.paused", {{"key", "P"}, {"leave", "Escape"}});
    } else if (trouble.is_stopped) {
        view.force.visible = false;
        view.banner = catalogue.say("hud.emergency", {{"key", "Enter"}});
        view.banner_is_error = true;
    } else if (trouble.waited_s > kShortWait_s) {
        view.banner = catalogue.say("banner.slow");
    } else if (trouble.device_is_lost) {
        view.banner = catalogue.say("banner.device_lost");
        view.banner_is_error = true;
    } else if (trouble.is_unkept) {
        view.banner = catalogue.say("banner.not_saved");
    } else if (trouble.holds_back) {
        view.banner = catalogue.say("banner.hold_still");
    }
}

}  // namespace fulcrum::runtime
