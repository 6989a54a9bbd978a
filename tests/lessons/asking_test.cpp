// A learner asks: what the lesson knows is answered from the simulation, what it does not know politely, and a question that is open
// comes first.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

const std::string kLesson = R"(
local know = require "know"
local story = require "story"
local L = lesson { id = "odd", title = "Odd", minutes = 1 }
know.things(L)
L:knows "sky" { asked = { "what colour is the sky" }, answer = function() return "It is blue." end }
L:knows "sea" { asked = { "what colour is the sea" }, answer = function() return nil end }
L:question "q" { prompt = "Is it an egg?", answers = { "it is an egg" }, right = function() return true end }
function L:start(world)
  world:hand { centre = { 0, 0.2, 0 } }
  world:body { name = "block", noun = "block", model = "box", size = { 0.1, 0.1, 0.1 }, solid = true, visible = true,
    material = "metal", mass = 2, at = { 0, 0.2, 0 }, about = "This is a block of metal." }
  story(L, function()
    story.wait(30)
    world:ask "q"
    story.wait_for "answered"
    world:finish { stars = 3 }
  end)
end
return L
)";

const std::string kHand = R"(
local motion = require "motion"
return motion.play(function()
  motion.start_at { 0, 0.35, 0 }
  motion.wait(1)
  motion.move_to({ 0, 0.245, 0 }, 0.5)
  motion.wait(1)
  motion.move_to({ 0, 0.35, 0 }, 0.5)
  motion.move_to({ 0, 0.245, 0 }, 0.5)
  motion.move_to({ 0, 0.35, 0 }, 0.5)
end)
)";

std::string play(const std::string& say) {
    const Sandbox sandbox;
    sandbox.write("odd/lesson.lua", kLesson);
    sandbox.write("hand.lua", kHand);
    sandbox.write("say.txt", say + "\nit is an egg\n");
    const ProgramRun run = sandbox.run("run odd --headless --hand hand.lua --say say.txt");
    INFO(run.output);
    check_run(run, 0, {"finished after"});
    return run.output;
}

std::size_t count(const std::string& text, const std::string& words) {
    std::size_t n = 0;
    for (std::size_t at = text.find(words); at != std::string::npos;
         at = text.find(words, at + 1)) {
        ++n;
    }
    return n;
}

}  // namespace

TEST_CASE("asking: what is in the hand is answered from the simulation") {
    const std::string told = play(
        "?What is this?\n?What is it made of?\n?how heavy is the block\n?is it hard\n?is it "
        "sticky\n"
        "?How does it feel?\n?does it feel hard\n?is it rough or smooth\n?is it harder than the "
        "block");
    for (const char* words :
         {"This is a block.", "It is made of metal.", "The block weighs 19.6 newtons.",
          "Yes, it is.", "No, it isn't.", "It is hard and smooth.", "Yes, it does.",
          "It is smooth.", "No, they are equally hard."}) {
        INFO(told << words);
        CHECK(told.find(words) != std::string::npos);
    }
}

TEST_CASE("asking: whether a thing is made of something is answered, and of what it is made") {
    const struct {
        const char *asked, *answer;
    } rows[] = {
        {"Is it made of metal?", "Yes, it is."},
        {"is the block made of rubber", "No, it is made of metal."},
        {"is this made out of plastic", "No, it is made of metal."},
        {"is it metal", "Yes, it is."},
        {"is it stone", "No, it is made of metal."},
        {"is the block made by wood",
         "We say: Is the block made *of* wood? No, it is made of metal."},
        {"is it made from rubber", "We say: Is it made *of* rubber? No, it is made of metal."},
        {"is the block metal", "Yes, it is."},
        {"is it wooden", "No, it is made of metal."},
        {"is the block wooden", "No, it is made of metal."},
        {"what material is the block", "The block is made of metal."},
        {"what material the block is",
         "We say: *What material is the block*? The block is made of metal."},
    };
    for (const auto& row : rows) {
        const std::string told = play(std::string("?") + row.asked);
        INFO(row.asked << ": " << told);
        CHECK(told.find(std::string("tells    ") + row.answer) != std::string::npos);
    }
    // A lesson's own material is one of them; what nobody said of a thing is not known.
    const Sandbox sandbox;
    std::string lesson = kLesson;
    lesson.replace(lesson.find("material = \"metal\""), 18,
                   "material = world:material { name = \"felt\", like = \"rubber\" }");
    sandbox.write("odd/lesson.lua", lesson);
    sandbox.write("hand.lua", kHand);
    sandbox.write("say.txt", "?is the block made of felt\n?is it made of rock\nit is an egg\n");
    const std::string felt = sandbox.run("run odd --headless --hand hand.lua --say say.txt").output;
    INFO(felt);
    CHECK(felt.find("tells    Yes, it is.") != std::string::npos);
    CHECK(felt.find("tells    No, it is made of felt.") != std::string::npos);
}

TEST_CASE("asking: what weighs more is answered from the simulation, and heavy in newtons") {
    const Sandbox sandbox;
    std::string lesson = kLesson;
    lesson.insert(
        lesson.find("  story(L,"),
        "  world:body { name = \"egg\", noun = \"egg\", model = \"sphere\", visible = true, mass = "
        "0.5 }\n  world:body { name = \"tree\", noun = \"tree\", model = \"sphere\", visible = "
        "true }\n");
    sandbox.write("odd/lesson.lua", lesson);
    sandbox.write("hand.lua", kHand);
    const struct {
        const char *asked, *told;
    } rows[] = {
        {"is the block heavier than the egg", "Yes, it is."},
        {"is the egg heavier than the block", "No, it isn't."},
        {"is the egg lighter than the block", "Yes, it is."},
        {"is it heavier than the egg", "Yes, it is."},
        {"is the block heavier than the block", "No, they weigh the same."},
        {"is the tree heavier than the egg", "I don't know that."},
        {"is the block more heavy than the egg",
         "We say: Is the block *heavier* than the egg? Yes, it is."},
        {"is the block heavy", "The block weighs 19.6 newtons."},
        {"is it heavy", "It weighs 19.6 newtons."},
        {"is it a heavy", "We say: Is it *heavy*? It weighs 19.6 newtons."},
    };
    for (const auto& row : rows) {
        sandbox.write("say.txt", std::string("?") + row.asked + "\nit is an egg\n");
        const std::string told =
            sandbox.run("run odd --headless --hand hand.lua --say say.txt").output;
        INFO(row.asked << ": " << told);
        CHECK(told.find(std::string("tells    ") + row.told) != std::string::npos);
    }
    // What a lesson is about to ask is not told by a comparison either.
    lesson.replace(lesson.find("know.things(L)"), 14, "know.things(L, { weight = false })");
    sandbox.write("odd/lesson.lua", lesson);
    sandbox.write("say.txt", "?is the block heavier than the egg\nit is an egg\n");
    const std::string hidden =
        sandbox.run("run odd --headless --hand hand.lua --say say.txt").output;
    CHECK(hidden.find("I don't know that.") != std::string::npos);
}

TEST_CASE("asking: a statement about a thing is none of the ways to ask for it") {
    const std::string told = play("?it is made of metal\n?the block is made of wood");
    INFO(told);
    CHECK(told.find("We say:") == std::string::npos);
    CHECK(told.find("Yes, it is.") == std::string::npos);
}

TEST_CASE("asking: what is asked with an error of form is said rightly, and answered") {
    const struct {
        const char *asked, *said, *answer;
    } rows[] = {
        {"what is the block make of", "*What is the block made of*?",
         "The block is made of metal."},
        {"what it is made of", "*What is it made of*?", "It is made of metal."},
        {"how heavy the block is", "*How heavy is the block*?", "The block weighs 19.6 newtons."},
        {"how much it weighs", "*How heavy is it*?", "It weighs 19.6 newtons."},
        {"what this is", "*What is this*?", "This is a block."},
        {"how the block feels", "*How does the block feel*?", "The block is hard and smooth."},
        {"does it hard", "*Is it hard*?", "Yes, it is."},
    };
    for (const auto& row : rows) {
        const std::string told = play(std::string("?") + row.asked);
        INFO(row.asked << ": " << told);
        CHECK(told.find(std::string("We say: ") + row.said) != std::string::npos);
        CHECK(told.find(row.answer) != std::string::npos);
    }
}

TEST_CASE("asking: what nobody knows is said politely, with what may be asked") {
    const std::string told = play("?what colour is the sea\n?who are you\n?\x01\xff");
    INFO(told);
    CHECK(told.find("I don't know that.") != std::string::npos);
    CHECK(told.find("I don't know that. You can ask: What is ") != std::string::npos);
}

TEST_CASE("asking: a thing is explained when it is first touched, and only then") {
    const std::string told = play("?what colour is the sky");
    INFO(told);
    CHECK(count(told, "This is a block of metal.") == 1);
    CHECK(told.find("It is blue.") != std::string::npos);
}

TEST_CASE("asking: who asks while a question is open is told it comes first; nothing is counted") {
    const Sandbox sandbox;
    std::string lesson = kLesson;
    lesson.replace(lesson.find("story.wait(30)"), 14, "story.wait(0.5)");
    sandbox.write("odd/lesson.lua", lesson);
    sandbox.write("say.txt", "what colour is the sky\n");
    check_run(sandbox.run("run odd --headless --say say.txt --learner Mina --db p.db --seconds 10"),
              {}, {"Good question! But first answer mine.", "0 answers"}, {"It is blue."});
}

TEST_CASE("asking: a statement is no question while a question is open, however near to one") {
    const Sandbox sandbox;
    std::string lesson = kLesson;
    lesson.replace(lesson.find("story.wait(30)"), 14, "story.wait(0.5)");
    sandbox.write("odd/lesson.lua", lesson);
    for (const auto& [said, asks] :
         {std::pair{"it is made of rubber", false}, std::pair{"what it is made of", true}}) {
        sandbox.write("say.txt", std::string(said) + "\n");
        const ProgramRun run = sandbox.run("run odd --headless --say say.txt --seconds 10");
        INFO(run.output);
        CHECK((run.output.find("Good question!") != std::string::npos) == asks);
    }
}

TEST_CASE("asking: a question answered by asking takes all the lesson knows, and answers it") {
    const Sandbox sandbox;
    std::string lesson = kLesson;
    lesson.replace(lesson.find("story.wait(30)"), 14, "story.wait(0.5)");
    lesson.replace(lesson.find("answers = { \"it is an egg\" }"), 28,
                   "answers = { \"what is an {food}\" }, lists = { food = { \"egg\" } }");
    sandbox.write("odd/lesson.lua", lesson);
    const auto said = [&](const std::string& words, const std::string& answers) {
        sandbox.write("say.txt", words);
        const ProgramRun run =
            sandbox.run("run odd --headless --say say.txt --learner Mina --db p.db --seconds 10");
        INFO(run.output);
        check_says(run.output, {answers});
        check_lacks(run.output, {"But first answer mine"});
        return run.output;
    };
    CHECK(said("what colour is the sky\n", "1 answer").find("Good question! It is blue.") !=
          std::string::npos);
    CHECK(said("what it is made of\n", "1 answer")
              .find("Good question! We say: *What is it made of*?") != std::string::npos);
    // What nobody knows is told so, is not wrong, and the question stays.
    const std::string unknown = said("why is the sky blue\nwhat colour is the sky\n", "2 answers");
    CHECK(unknown.find("answers  I don't know that. You can ask: ") != std::string::npos);
    CHECK(unknown.find("(wrong)") == std::string::npos);
    CHECK(unknown.find("Good question! It is blue.") != std::string::npos);
    // Its own answers are taken as ever, and what asks for nothing is not understood.
    CHECK(said("what is an egg\n", "1 answer").find("Good question!") != std::string::npos);
    CHECK(said("bla bla\n", "1 answer").find("I did not understand") != std::string::npos);
}

TEST_CASE("asking: a file may ask while a question is open, which then waits for the next line") {
    const Sandbox sandbox;
    std::string lesson = kLesson;
    lesson.replace(lesson.find("story.wait(30)"), 14, "story.wait(0.5)");
    sandbox.write("odd/lesson.lua", lesson);
    sandbox.write("say.txt", "?what colour is the sky\n?who are you\nit is an egg\n");
    const ProgramRun run = sandbox.run("run odd --headless --say say.txt");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(count(run.output, "Good question! But first answer mine.") == 1);
    check_says(run.output, {"finished after"});
    check_lacks(run.output, {"nobody answered"});
}

TEST_CASE("asking: examples of what is known come out as they are said to be, or check says so") {
    const auto check = [](const std::string& knows) {
        const Sandbox sandbox;
        sandbox.write("odd/lesson.lua",
                      "local L = lesson { id = \"odd\", title = \"Odd\" }\nL:knows \"size\" { " +
                          knows +
                          " }\nL:knows \"sky\" { asked = { \"what colour is the sky\" }, answer = "
                          "function() return \"Blue.\" end }\nfunction L:start(world) end\nreturn "
                          "L\n");
        ProgramRun run = sandbox.run("check odd");
        INFO(run.output);
        if (run.exit_code != 0) {
            CHECK(run.output.find("lesson.lua:2") != std::string::npos);
        }
        return run.output;
    };
    const auto says = [](const std::string& output, const std::string& words) {
        INFO(output);
        CHECK(output.find(words) != std::string::npos);
    };
    const std::string asked =
        "asked = { \"how big is {planet}\" }, lists = { planet = { \"Mars\", \"Venus\" } }, "
        "nearly = { \"how big {planet} is\" }, ";
    const std::string answer = "answer = function(a) return a.planet .. \" is big.\" end, ";
    says(check(asked + answer +
               "examples = { right = { \"How big is Mars?\" }, form = { \"how big Venus is\" }, "
               "other = { \"what colour is the sky\", \"how are you\" } }"),
         "no mistakes found");
    says(check(asked + answer + "examples = { right = { \"how large is Mars\" } }"),
         "\"how large is Mars\" is said to ask for it, but it is not understood");
    says(check(asked + answer + "examples = { right = { \"what colour is the sky\" } }"),
         "but it asks for \"sky\"");
    says(check(asked + answer + "examples = { right = { \"how big Mars is\" } }"),
         "but its form has R:WO");
    says(check(asked + answer + "examples = { form = { \"how big is Mars\" } }"),
         "but no error of form is found");
    says(check(asked + answer + "examples = { other = { \"how big is Mars\" } }"),
         "is said not to ask for it, but it asks for \"size\"");
    // The lesson's own function is called, with each word of its lists.
    says(check(asked +
               "answer = function(a) return a.planet == \"Venus\" and nothing.here or nil end"),
         "nothing");
    says(check(asked + "answer = function(a) return 5 end"), "is answered with a text, or nil");
    // What another one takes first is told, and so is the line of what does not go together.
    says(check("asked = { \"how big is Mars\", \"what is the colour\" }, answer = function() end } "
               "L:knows \"other\" { asked = { \"how big is Mars\" }, answer = function() end"),
         "asks for \"other\", but \"size\" takes it first.");
}

TEST_CASE("asking: a lesson's mistakes in what it knows are one sentence with their line") {
    const auto refused = [](const std::string& body, const std::string& words) {
        const Sandbox sandbox;
        sandbox.write("odd/lesson.lua", "local L = lesson { id = \"odd\", title = \"Odd\" }\n" +
                                            body + "\nreturn L\n");
        const ProgramRun run = sandbox.run("check odd");
        INFO(run.output);
        CHECK(run.exit_code != 0);
        check_says(run.output, {"lesson.lua:2", words});
    };
    refused("L:knows 'a' { asked = {}, answer = print }", "knows.asked is empty");
    refused("L:knows 'a' { asked = { 'what is {it' }, answer = print }", "what a learner may ask");
    refused(
        "L:knows 'a' { asked = { 'x' }, answer = print } L:knows 'a' { asked = { 'y' }, answer = "
        "print }",
        "knows \"a\" already");
    refused(
        "L:knows 'a' { asked = { 'is it {c}' }, lists = { c = { 'red' } }, answer = print } "
        "L:knows 'b' { asked = { 'was it {c}' }, lists = { c = { 'blue' } }, answer = print }",
        "has other words elsewhere");
}

TEST_CASE("asking: in every lesson that knows things some of it can be asked for") {
    const Sandbox sandbox;
    sandbox.write("say.txt",
                  "?how many moons does Jupiter have\n?how big is Mars\n?does the Earth have a "
                  "moon\n?does Venus have any moons\n");
    std::string solar =
        sandbox.run("run solar-system --headless --seconds 14 --say say.txt").output;
    sandbox.write("say.txt",
                  "?is Mars bigger than the Earth\n?is Saturn smaller than Jupiter\n?is Jupiter "
                  "made of rock\n");
    solar += sandbox.run("run solar-system --headless --seconds 14 --say say.txt").output;
    INFO(solar);
    for (const char* told : {"Jupiter has ", "kilometres wide.", "Yes, the Earth has one moon.",
                             "No, Venus has no moons.", "No, it isn't.", "Yes, it is.",
                             "No, Jupiter is mostly made of gas, hydrogen and helium."}) {
        CHECK(solar.find(told) != std::string::npos);
    }
    sandbox.write(
        "say.txt",
        "?how heavy is the Earth\n?how long is my arm\n?what is torque\n?what means lever\n");
    const std::string lever = sandbox.run("run lever --headless --seconds 20 --say say.txt").output;
    CHECK(lever.find("The toy Earth weighs 2 newtons.") != std::string::npos);
    CHECK(lever.find("Your arm is at most 50 centimetres") != std::string::npos);
    CHECK(lever.find("Torque is force times arm.") != std::string::npos);
    CHECK(lever.find("We say: *What is a lever*?") != std::string::npos);
    sandbox.write(
        "say.txt",
        "?how long is the line\n?is the kite made of paper\n?does it have a tail\n?what is "
        "lift\n?how long is the tail\n");
    const std::string kite = sandbox.run("run kite --headless --seconds 20 --say say.txt").output;
    INFO(kite);
    CHECK(kite.find("The line is ") != std::string::npos);
    CHECK(kite.find("No, it is made of ") != std::string::npos);
    CHECK(kite.find("No, it has no tail.") != std::string::npos);
    CHECK(kite.find("Lift is the force of the air") != std::string::npos);
    CHECK(kite.find("It has no tail yet.") != std::string::npos);
}
