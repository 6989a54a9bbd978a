#include "runtime/app/screen_words.h"

#include "runtime/app/begin_help.h"

namespace fulcrum::runtime {

void show_answer_line(const LessonInput& input, const std::string& next,
                      const dialogue::Catalogue& catalogue, View& view) {
    if (input.ended()) {
        for (const LessonInput::EndChoice choice : input.end_choices()) {
            view.choices.push_back({choice == LessonInput::EndChoice::again
                                        ? catalogue.say("end.play_again")
                                    : choice == LessonInput::EndChoice::next
                                        ? catalogue.say("end.next", {{"title", next}})
                                        : catalogue.say("end.menu"),
                                    {}});
        }
    } else if (!view.choices.empty()) {
        view.microphone.words = catalogue.say("hud.choose_here");
    } else if (input.asking()) {
        view.microphone.words = catalogue.say("hud.ask_here");
    } else if (view.input_visible && view.microphone.words.empty()) {
        view.microphone.words = catalogue.say("hud.type_here");
    }
}

void show_hints(const LessonRun& run, const RunRequest& request, const std::string& before,
                bool has_begun, bool paused, Glosses& glosses, View& view) {
    const dialogue::Catalogue& catalogue = glosses.words().shown();
    show_glosses(run.session().hud().said, paused, glosses, view);
    if (view.banner.empty() && !before.empty()) {
        view.banner = catalogue.say("hud.said_before", {{"text", before}});
        add_glosses(before, glosses, view.banner);
    }
    if (view.banner.empty() && has_begun && !run.session().result().finished) {
        view.banner = say_begin_help(find_begin_help(run, request), catalogue);
    }
}

ScreenTrouble find_trouble(const LessonRun* run, const LessonInput& input,
                           const std::string& error) {
    ScreenTrouble trouble;
    trouble.error = error;
    trouble.is_stopped = input.stopped();
    trouble.is_paused = input.paused();
    if (run != nullptr) {
        trouble.waited_s = run->process().waited_s();
        trouble.device_is_lost = device_is_lost(run->hands());
        trouble.is_unkept = !run->session().store_trouble().empty();
        trouble.holds_back = holds_back(run->hands(), run->plan());
    }
    return trouble;
}

}  // namespace fulcrum::runtime
