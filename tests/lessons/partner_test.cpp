// Who talks back to the learner changes what is said, and nothing else.
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

/// Talks at most turns, is silent at one and says what nobody can show at another.
constexpr const char* kPartner =
    "#!/bin/sh\n"
    "while read -r line; do\n"
    "    n=$(printf '%s' \"$line\" | sed 's/.*\"turn\":\\([0-9]*\\).*/\\1/')\n"
    "    case $n in\n"
    "        3) ;;\n"
    "        5) echo nonsense ;;\n"
    "        *) echo \"{\\\"turn\\\":$n,\\\"text\\\":\\\"Partner to $n.\\\"}\" ;;\n"
    "    esac\n"
    "done\n";

/// The lesson's answers as they were kept, but for what differs from run to run anyway; and what the record tells of learner and lesson.
struct Kept {
    std::vector<runtime::AttemptRecord> attempts;
    std::vector<std::string> said;
    std::vector<std::string> notes;
    std::string output;
};

Kept play(const Sandbox& sandbox, const std::string& name, const std::string& arguments) {
    const std::string files = " --db " + name + ".db --record " + name + ".rec";
    const ProgramRun run = sandbox.run("run textures --headless --seed 4 " + arguments + files);
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    Kept kept{{}, {}, {}, run.output};
    const auto store = value_of(runtime::open_sqlite_store(sandbox.path(name + ".db")));
    kept.attempts = value_of(store->read({})).attempts;
    for (runtime::AttemptRecord& attempt : kept.attempts) {
        attempt.id = attempt.session = "";
        attempt.said_utc_ms = 0;
    }
    const Record record = read_run(sandbox.path(name + ".rec"));
    for (const RecordEvent& event : record.events) {
        if (event.kind == RecordEventKind::said) {
            kept.said.push_back(event.text);
        } else if (event.kind == RecordEventKind::note) {
            kept.notes.push_back(event.text);
        }
    }
    return kept;
}

/// Without what was said back.
std::vector<std::string> without_replies(const std::vector<std::string>& said) {
    std::vector<std::string> rest;
    for (const std::string& line : said) {
        const bool is_reply = line.find(" s  answers  ") != std::string::npos ||
                              line.find(" s  partner  ") != std::string::npos;
        if (!is_reply) {
            rest.push_back(line);
        }
    }
    return rest;
}

}  // namespace

TEST_CASE("partner: a lesson is marked and kept alike whoever talks, and repeats without them") {
    const Sandbox sandbox;
    sandbox.write("talk.sh", kPartner);
    sandbox.write("say.txt",
                  "metal is soft and smooth\nmetal is hard and smooth\nwood are hard and rough\n"
                  "bla bla\nrock is hard and rough\nit is wood\nit is rock\nit is metal\n"
                  "spaceship is made of metal\na table is made of rock\na table is made of wood\n"
                  "a statue is made of rock\n");
    const std::string say = "--learner Mina --say say.txt ";
    const Kept shipped = play(sandbox, "shipped", say);
    REQUIRE(shipped.attempts.size() == 12);
    CHECK(shipped.notes.empty());
    const Kept none = play(sandbox, "none", say + "--dialogue none");
    const Kept external = play(sandbox, "external", say + "--dialogue 'exec:sh talk.sh'");
    const Kept repeated = play(sandbox, "repeated", "--learner Mina --hand replay:external.rec");
    const Kept repeated_shipped =
        play(sandbox, "own", "--learner Mina --dialogue shipped --hand replay:external.rec");
    for (const Kept* kept : {&none, &external, &repeated, &repeated_shipped}) {
        CHECK(kept->attempts == shipped.attempts);
        CHECK(without_replies(kept->said) == without_replies(shipped.said));
    }
    // What is said back is another thing each time.
    CHECK(repeated_shipped.said == shipped.said);
    CHECK(none.said == without_replies(shipped.said));
    CHECK(none.notes.empty());
    REQUIRE(external.notes.size() == 10);  // of 12 turns
    CHECK(external.notes.front() == "partner 1: Partner to 1.");
    CHECK(external.notes.back() == "partner 12: Partner to 12.");
    check_says(external.output, {"partner  Partner to 1.",
                                 "What another program was to say is missing: the partner"});
    CHECK(std::ranges::count_if(external.said, [](const std::string& line) {
              return line.find(" s  answers  ") != std::string::npos;
          }) == 2);
    // The record alone gives the same words and the same forces.
    CHECK(repeated.said == external.said);
    CHECK(repeated.notes == external.notes);
    check_says(repeated.output, {"All forces are the record's, bit for bit"});
}

TEST_CASE("partner: the example talks, and one that is not there is one sentence") {
    const Sandbox sandbox;
    const Kept kept =
        play(sandbox, "example", "--dialogue 'exec:sh " FULCRUM_EXAMPLES "/own-partner/talk.sh'");
    CHECK_FALSE(kept.notes.empty());
    check_lacks(kept.output, {"What another program was to say is missing", "Nobody else talks"});
    check_run(
        sandbox.run("run textures --headless --seconds 20 --dialogue exec:no_such_program_7"), 0,
        {"Nobody else talks any more: the program no_such_program_7 has ended; the program's own "
         "words are said."});
    check_run(sandbox.run("explain textures --dialogue none"), 0,
              {"partner", "nobody talks back to the learner"});
    check_lacks(sandbox.run("explain textures").output, {"partner"});
    check_run(sandbox.run("run textures --headless --dialogue parrot"), 2,
              {"--dialogue parrot is not known; use shipped, none or exec:COMMAND"});
}
