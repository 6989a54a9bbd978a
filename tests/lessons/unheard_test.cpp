#include "tests/lessons/program.h"

using namespace fulcrum::test;

TEST_CASE("spoken: without what hears there is one sentence, and the lesson goes on by typing") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("run gravity --headless --speech exec:no_such_program_5");
    CAPTURE(run.output);
    check_run(run, 0,
              {"Nobody hears any more: the program no_such_program_5 has ended; type the answers.",
               "gravity: finished after"});
    check_run(sandbox.run("run gravity --headless --hear said.txt"), 2,
              {"--hear without somebody who hears"});
    check_run(sandbox.run("run gravity --headless --sure 0.5"), 2,
              {"--sure without somebody who hears; add --speech sphinx"});
}
