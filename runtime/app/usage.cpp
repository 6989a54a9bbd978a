#include "runtime/app/parse_options.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kUsage = R"(Fulcrum: lessons that are felt.

  fulcrum                    the list of lessons, in a window  (--learner NAME --db FILE --force-limit N --mute --watch)
  fulcrum run LESSON         play a lesson
      --headless             without a window, faster than real time, repeatable to the byte; tells what is said; --real-time: as fast as it is
      --hand FILE.lua|mouse|keys|hid|hid:PATH|udp:HOST:PORT|replay:FILE|none   (once a hand)
                             udp: an arm on another computer, or fulcrum arm on this one  (--key FILE: that arm's key; behind a
                             second --hand the second's)
                             replay: a run that --record wrote, with its keys, answers and seed; --headless says whether every
                             force is the same to the bit, and if not, where first and why
      --handed left|right    for a left hand the arm's first two buttons change places, and I J K L move the pointer
      --scale N --axes -x,y,z --middle X,Y,Z --clutch N|none
                             how the arm stands before the learner: times the lesson's scale, 0.25 to 4; which of its axes are right,
                             up and near; the place, in metres, that is the middle; the button that holds the scene still while the
                             arm moves on (3). All five are kept with the learner and the arm;
                             behind a second --hand the first four are of that one
      --first-use once|again|never  whether an arm or a joystick pushes gently first and asks which way (once for each learner
                             and device): one that is wired or stands wrongly gives no force, and none later with never
      --by arm|mouse|keyboard  without a window: how the simulated hand plays, by an arm or as somebody at a desk (arm)
      --say FILE             what a pupil says, a line each time it is the pupil's turn: an answer to the question that is open; a line
                             that begins with ? is asked instead, between questions too ("?What is this?"); # begins a remark
      --learner NAME         whose progress this is
      --db FILE              where progress is kept
      --record FILE          write poses, forces and events
      --screenshot FILE      write the picture when the run ends  (--screenshot-at S: at that second)
      --seconds N            end early
      --seed N               what the lesson leaves to chance goes as it went with this number; without a window 1
      --force-limit N        newtons at most, 0.5 to 10 (5); never more than /etc/fulcrum/site.conf allows
      --feedback STEP,…      what is done about an error of form the first time, the second …: recast, prompt, rule, replay
                             (as the lesson says, else recast,prompt,rule); kept with a --learner until another is given, or lesson
      --mute                 without sound
      --watch                runs again whenever a file of the lesson is saved, not only after a mistake
      --speech NAME          how answers come beside typing: text, not at all (text); sphinx, spoken, heard by PocketSphinx;
                             exec:COMMAND, heard by a program of your own (dialogue/README.md)
      --hear FILE            one recording (WAV) a line, heard for the questions in turn instead of a microphone
      --listen hold|always   when the microphone is heard: while Control is held, or whenever somebody speaks (hold)
      --sure N               with --speech: what is heard less surely is asked for again, 0 to 1 (as the lesson says, else 0.4)
      --throat N             with --speech sphinx: how much smaller than a grown-up's the pupil's throat is, 1 to 2; without it
                             as it was heard the last time, kept with the pupil's progress
      --voice NAME           who says aloud what stands there: flite, espeak-ng or none (flite)
      --voice-speed N        0.5 to 2, 1 is as a teacher speaks (0.9)
  fulcrum list               the lessons
  fulcrum check LESSON       look for mistakes, also in what is only called in a play  (--quick: without playing it)
      --again                also where nothing has changed since the last time, which is told again otherwise
  fulcrum test LESSON        play the lesson's own tests, by arm, by mouse and by keyboard  (--by NAME: by this one; --hand FILE.lua)
      --errors N             a simulated learner answers, who knows what is right and errs in so many parts of the answers, 0 to 0.9:
                             half of that in form, a third in meaning, else unclear; the lesson must come to its end  (--seed N)
  fulcrum explain LESSON     what runs for it, how often, and which line asked for it
      --analyze              plays it without a window and says what each stage cost  (--hand --say --seconds)
      --json                 for programs
  fulcrum explain --force T FILE.rec
                             why the hand felt that force at T seconds of a record: each effect's share, limits, gate  (--json)
  fulcrum export FILE.rec    a record as CSV: rounds, and beside them .events, .bodies and .facts  (--out FILE.csv)
  fulcrum report             what learners did  (--learner NAME --lesson ID --format text|csv --out FILE)
  fulcrum devices            what can be a hand here, what each can do, what is missing  (--json)
  fulcrum arm                a simulated arm that speaks the arm link, for --hand udp:localhost:4701
      --port N --address A   where it waits (4701 at 127.0.0.1); --key FILE what it shares with the program; --rate N a second (1000)
      --arm wam|desktop      Barrett's WAM of seven joints, or three axes on a desk (wam)
      --motion still|circle  what the hand does that holds it
      --loss P --burst N     per cent of the packets are lost, N in a row;  --delay MS --jitter MS each way;
      --reorder P --duplicate P --corrupt P    and how many are overtaken, doubled, damaged  (--seed N --seconds N)
  fulcrum stop               emergency stop: every hand and arm of yours on this computer fades to no force  (--only PROCESS)
  fulcrum soak               all lessons with an arm on which things break by chance, under a virtual clock: is every force as it may be?
      --lesson NAME --seed N --seeds N --seconds N    one lesson; the first seed (1), how many (3), how long each (60)
  fulcrum bench [NAME…]      what accuracy costs in time  (--out DIR --quick --list --draw FILE.csv)

Exit codes: 0 done, 1 the lesson or a test failed, 2 wrong usage or unreadable input, 3 a replay gave other forces than its record, 4 the lesson was played and what the learner did was not all kept, 130 ended by Ctrl-C, 143 by SIGTERM (what there was of a run is kept).
)";

constexpr std::string_view kHead = "\n  fulcrum ";  // a command's part begins so

}  // namespace

std::string usage(std::string_view command) {
    const std::string_view all = kUsage;
    const std::size_t end = all.find("\n\nExit codes:");
    std::string parts;
    for (std::size_t at = all.find(kHead); at < end;) {
        const std::size_t next = std::min(all.find(kHead, at + 1), end);
        const std::string_view part = all.substr(at + 1, next - at - 1);
        const std::string_view words = part.substr(kHead.size() - 1);
        if (words.substr(0, words.find_first_of(" \n")) == command) {
            parts += std::string(part) + '\n';
        }
        at = next;
    }
    return command.empty() || parts.empty() ? std::string(all)
                                            : parts + "\nfulcrum help shows all commands.\n";
}

}  // namespace fulcrum::runtime
