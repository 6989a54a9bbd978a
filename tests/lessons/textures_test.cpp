// The lesson on materials, played to its end by its own simulated hand and pupil.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// Scene indices, in the order of lesson.lua.
enum Body : int { board, metal, wood, rock, spaceship, table, statue };

constexpr const char* kRun = "run textures --headless --record r.rec";

/// How often a body was touched, and how far it was stroked while it was: metres, pressed with at least 0.3 N.
struct Felt {
    int touches = 0;
    double stroked_m = 0.0;
};
Felt felt_between(const Record& record, double from_s, double to_s) {
    Felt felt;
    for (const RecordEvent& event : record.events) {
        felt.touches +=
            event.kind == RecordEventKind::touched && event.time_s >= from_s && event.time_s < to_s;
    }
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s >= from_s && sample.time_s < to_s &&
            sample.commanded_W.force.norm() > 0.3) {
            felt.stroked_m += sample.twist_W.linear.norm() / record.header.rate_Hz;
        }
    }
    return felt;
}

}  // namespace

TEST_CASE("textures: the hand really taps, presses and strokes each block and each thing") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run(kRun).exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    for (const int body : {metal, wood, rock, spaceship, table, statue}) {
        CAPTURE(body);
        const double touched_s = time_of(record, RecordEventKind::touched, body);
        REQUIRE(touched_s > 0.0);
        CHECK(felt_between(record, touched_s, touched_s + 2.5).stroked_m > 0.03);
    }
    CHECK(largest_force_N(record) > 1.0);
}

TEST_CASE("textures: a wrong meaning is felt again, a wrong form said rightly, the teacher told") {
    const Sandbox sandbox;
    sandbox.write("say.txt",
                  "metal is soft and smooth\n"  // wrong meaning: felt again
                  "metal is hard and smooth\n"
                  "wood are hard and rough\n"  // right meaning, wrong form
                  "bla bla\n"                  // not understood
                  "rock is hard and rough\n"
                  "it is wood\n"  // under the cloth is rock: felt again
                  "it is rock\n"
                  "it is metal\n"
                  "spaceship is made of metal\n"  // the article is missing
                  "a table is made of rock\n"     // wrong meaning
                  "a table is made of wood\n"
                  "a statue is made of rock\n");
    const ProgramRun run =
        sandbox.run("run textures --headless --say say.txt --learner Mina --record r.rec");
    INFO(run.output);
    check_run(run, 0, {"textures: finished"});

    // After each wrong meaning something was touched and stroked before the next answer.
    const Record record = read_run(sandbox.path("r.rec"));
    std::vector<double> answers_s;
    for (const RecordEvent& event : record.events) {
        if (event.kind == RecordEventKind::answered) {
            answers_s.push_back(event.time_s);
        }
    }
    REQUIRE(answers_s.size() == 12);
    for (const std::size_t wrong : {0U, 5U, 9U}) {
        CAPTURE(wrong);
        const Felt felt = felt_between(record, answers_s[wrong], answers_s[wrong + 1]);
        CHECK(felt.touches > 0);
        CHECK(felt.stroked_m > 0.06);
    }
    check_run(sandbox.run("report --learner Mina"), 0, {"Mina", "textures"});
}

TEST_CASE("textures: the truth of adjectives is the physics: sponge is soft, whatever its name") {
    const Sandbox sandbox;
    std::string text = bytes_of(FULCRUM_SCENARIOS "/textures/lesson.lua");
    // The first block is made of something else, under the old name.
    const std::string was = "  for i, name in ipairs(names) do\n    blocks[name] = world:body {\n";
    const std::size_t at = text.find(was);
    REQUIRE(at != std::string::npos);
    text.replace(text.find("material = name,", at), std::string("material = name,").size(),
                 "material = i == 1 and sponge or name,");
    text.insert(
        at,
        "  local sponge = world:material { name = \"sponge\", stiffness = 100, friction = 1.2, "
        "texture = { bumps = 0.004, height = 0.0005 } }\n");
    sandbox.write("soft/lesson.lua", text);
    sandbox.write("soft/stroker.lua", bytes_of(FULCRUM_SCENARIOS "/textures/stroker.lua"));
    sandbox.write("say.txt", "metal is hard\nmetal is soft and sticky\n");
    const ProgramRun run = sandbox.run(
        "run soft --headless --hand soft/stroker.lua --say say.txt --seconds 30 --learner Mina");
    INFO(run.output);
    CHECK(run.output.find("score 2,") != std::string::npos);  // right at the second try
}

TEST_CASE("textures: words that changed places are said again, a wrong material is felt again") {
    const Sandbox sandbox;
    sandbox.write("say.txt",
                  "metal is hard\nwood is hard\nrock is hard\nit is rock\nit is made of metal\n"
                  "metal is made of a spaceship\n"
                  "the spaceship is made of wood\n"
                  "the spaceship is made of metal\n"
                  "the table is made of wood\nthe statue is made of rock\n");
    check_run(sandbox.run("run textures --headless --say say.txt --record r.rec"), 0);
    std::vector<double> answers_s;
    for (const RecordEvent& event : read_run(sandbox.path("r.rec")).events) {
        if (event.kind == RecordEventKind::answered) {
            answers_s.push_back(event.time_s);
        }
    }
    REQUIRE(answers_s.size() == 10);
    constexpr double kPointedAndLed_s = 3.5;  // "Not yet." 2 s, the way to the thing 1.5 s
    CHECK(answers_s[6] - answers_s[5] < kPointedAndLed_s);
    CHECK(answers_s[7] - answers_s[6] > kPointedAndLed_s);
}

TEST_CASE("textures: a star hangs over what is to be felt, for a mouse cannot be led there") {
    const Sandbox sandbox;
    std::string text = bytes_of(FULCRUM_SCENARIOS "/textures/lesson.lua");
    // Prints what the star hangs over whenever a question is asked.
    const std::string was = "  game.ask(question, {\n";
    REQUIRE(text.find(was) != std::string::npos);
    text.insert(text.find(was),
                "  print(question, body.name, star.where, star.x == body.x, star.y > body.y)\n");
    sandbox.write("star/lesson.lua", text);
    sandbox.write("star/stroker.lua", bytes_of(FULCRUM_SCENARIOS "/textures/stroker.lua"));
    const ProgramRun run = sandbox.run("run star --headless");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    for (const std::string asked :
         {"like_metal\tmetal", "like_rock\trock", "under\trock", "under\tmetal",
          "made_spaceship\tspaceship", "made_statue\tstatue"}) {
        CHECK_THAT(run.output, Catch::Contains(asked + "\tplaced\ttrue\ttrue"));
    }
}

TEST_CASE("textures: explain names what is felt and heard, and mute leaves no sound in the plan") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("explain textures");
    INFO(run.output);
    check_run(run, 0, {"friction cone", "sound    touch"});
    const ProgramRun muted = sandbox.run("explain textures --mute");
    CHECK(muted.output.find("sound") == std::string::npos);
}

TEST_CASE("materials: a picture that is none, or is not there, is one sentence with its line") {
    const Sandbox sandbox;
    sandbox.write("felt/lesson.lua", bytes_of(FULCRUM_TEST_LESSONS "/felt/lesson.lua"));
    check_run(sandbox.run("check felt"), 1, {"lesson.lua:5: the file felt.png cannot be read"});
    sandbox.write("felt/felt.png", "\x89PNG\r\n\x1a\nnonsense");
    const ProgramRun broken = sandbox.run("check felt");
    check_run(broken, 1, {"lesson.lua:5: felt.png: the picture is damaged"});
    CHECK(std::count(broken.output.begin(), broken.output.end(), '\n') == 1);
    CHECK(sandbox.run("check " FULCRUM_TEST_LESSONS "/felt").exit_code == 0);
}

TEST_CASE("materials: a picture of one grey is no mistake, but check says it cannot be felt") {
    constexpr char kGrey[] =  // 2 x 2 pixels of 128
        "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000"
        "\000\000\002\000\000\000\002\010\000\000\000\000\127\335\122\370\000"
        "\000\000\016\111\104\101\124\170\234\143\150\150\140\150\150\000\000"
        "\006\006\002\001\054\301\120\327\000\000\000\000\111\105\116\104\256"
        "\102\140\202";
    const Sandbox sandbox;
    sandbox.write("felt/lesson.lua", bytes_of(FULCRUM_TEST_LESSONS "/felt/lesson.lua"));
    sandbox.write("felt/felt.png", std::string(kGrey, sizeof kGrey - 1));
    check_run(sandbox.run("check felt"), 0, {"lesson.lua:5: felt.png is one grey all over"});
}

TEST_CASE("materials: a lesson's process may choose a law, a proxy and a cursor") {
    const Sandbox sandbox;
    sandbox.write(
        "chosen/lesson.lua",
        "local L = lesson { id = \"chosen\", title = \"T\", level = \"A1\" }\n"
        "function L:start(world)\n"
        "  world:hand { proxy = \"friction_cone\", cursor = \"ball\" }\n"
        "  world:material { name = \"m\", texture = { grooves = 0.001, law = \"lateral\" } }\n"
        "end\nreturn L\n");
    check_run(sandbox.run("check chosen"), 0);
}
