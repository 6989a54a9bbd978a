#include "runtime/lua/api/asked_questions.h"
#include "runtime/lua/api/nouns.h"
#include "runtime/lua/api/sound_names.h"
#include "runtime/lua/api/written_texts.h"
#include "tests/unit/runtime/lua/told_lessons.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// Of a lesson's text before it runs: "name+" of a question with a hint, "name-" of one without; "name@line" of a sound;
/// "line:text" of a text, with an exclamation mark before what a learner reads.
TableReader told_api() {
    TableReader reader = told_lessons();
    reader.probes["asked"] = [](const std::string&, const std::string& in) {
        std::vector<std::string> told;
        for (const AskUse& use : find_asked(in)) {
            told.push_back(use.name + (use.has_hint ? '+' : '-'));
        }
        return spaced(told);
    };
    reader.probes["sounds"] = [](const std::string&, const std::string& in) {
        std::vector<std::string> told;
        for (const SoundUse& use : find_sounds(in)) {
            told.push_back(use.name + '@' + std::to_string(use.line));
        }
        return spaced(told);
    };
    reader.probes["texts"] = [](const std::string&, const std::string& in) {
        std::vector<std::string> told;
        for (const WrittenText& text : find_texts(in)) {
            told.push_back((text.is_shown ? "!" : "") + std::to_string(text.line) + ':' +
                           text.text);
        }
        return spaced(told);
    };
    reader.probes["spoken"] = [](const std::string&, const std::string& in) {
        return std::string(spoken_noun(in));
    };
    return reader;
}

}  // namespace

TEST_CASE("api: what a lesson is told is what the tables say") {
    hold_tables(FULCRUM_SOURCE_DIR "/tests/unit/runtime/lua/api", told_api);
}
