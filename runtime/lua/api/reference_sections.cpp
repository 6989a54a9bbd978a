#include "runtime/lua/api/reference_sections.h"

#include "haptics/surface/materials.h"
#include "runtime/scene/description.h"
#include "runtime/scene/sounds.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace fulcrum::runtime {
namespace {

constexpr std::array kAnswerFields = {
    FieldText{"question", "string", "the name of the question"},
    FieldText{"said", "string", "the learner's words"},
    FieldText{"understood", "boolean", "false: none of the sentences fitted"},
    FieldText{"right", "boolean", "the meaning is right, by the question's own `right`"},
    FieldText{"form_right", "boolean", "the English was right: no error of form was found"},
    FieldText{"form_known", "boolean",
              "false: what heard it hears the meaning alone, nothing is known of the English, and "
              "form_right is false"},
    FieldText{
        "turned_round", "boolean",
        "thing and material changed places, \"Metal is made of a spaceship.\": nothing to feel "
        "again, only to say"},
    FieldText{"replay", "boolean",
              "what the question is about should be felt again: its meaning was wrong, or its form "
              "and the step of feedback is \"replay\""},
    FieldText{"over", "boolean", "the question is done: right, or left after many tries"},
    FieldText{"attempt", "integer", "1 for the first try"},
    FieldText{"bodies", "table<string, Body>",
              "the body that a slot speaks of, by its noun; nil when no body or several have it"},
};

constexpr const char* kAnswerHead = R"(
## answer

What `L:answered`, the event "answered" and `story.ask` give. `right = function(answer)` of a question gets `question`, the
slots and `bodies`; the rest is known after it.

Each `{slot}` of the template that fitted is a field: after "the tennis ball is heavier than the egg", `answer.thing` is
`"tennis ball"` and `answer.other` is `"egg"`. A slot is the **noun** as it was declared, not the body's name: with
`name = "b1", noun = "tennis ball"` compare bodies, `answer.bodies.thing == b1`, or `answer.thing == b1.noun`. A slot that
was left out is nil; to ask for one that none of the question's sentences has is a mistake, told with its line.

| field | |
|---|---|
)";

constexpr const char* kFiles = R"(
## Files of a lesson

A lesson begins with `lesson.lua`. Other Lua files that lie beside it are modules of its own: `require "fruit"` runs `fruit.lua` once and gives
what that returns. They are taken in while the lesson is loaded, so `require` stands at the top of `lesson.lua` (or of another such file), not in
a function that runs later; names are made of letters, digits and _, without folder and ending.

```lua
-- fruit.lua
local fruit = {}
fruit.mass = { apple = 0.2, egg = 0.06 }
function fruit.is_heavier(one, other) return fruit.mass[one] > fruit.mass[other] end
return fruit
```

```lua
-- lesson.lua
local fruit = require "fruit"      -- your own, beside this file
local game = require "game"        -- the program's, see below
```

Pictures, models (`.glb`, `.gltf`) and the simulated hands of `L:test` lie in the same folder.
)";

constexpr const char* kTemplates = R"(
## Templates of answers

The sentences in `answers` of `L:question`, in good English: the program says them back. `<made_of:metal>` has its own "is",
`<superlative:heavy>` needs the template's own "the". Case and punctuation don't matter; learners' usual errors of form (articles,
degrees, plurals, agreement) are understood and corrected.

| in a template | means |
|---|---|
| `[word]` | may be left out; a verb's subject may not: "(it\|the egg) needs …", for of "[it] needs …" the program would say "Needs …" back |
| `[a\|b]` | one of them or none |
| `(a\|b)` | one of them, never none |
| `(a;b)` | both, in any order; at most 4 parts |
| `{thing}`, `{other}` | the noun of any body of the scene, movable, solid or neither, which becomes `answer.thing` and `answer.other` |
| `{colour}` | a word of `lists = { colour = { "red", "blue" } }`, which becomes `answer.colour`. An article in an entry tells how the word is used and is no part of the value: "the Sun" becomes "Sun". A capital makes a name, which takes no article: write "apple", not "Apple" |
| `{thing:first}` | a word of the list `thing` that becomes `answer.first` |
| `[a\|an\|the] {thing}`, `<article> {thing}` | the noun with the article that it needs; the wrong one is an error of form. The first article is the one that is said back: `[the\|a\|an] {thing}` gives "The apple is …" |
| `<comparative:heavy>` | "heavier"; "more heavy", "heavyer" are errors of form |
| `<superlative:heavy>` | "heaviest", after a template's own "the" |
| `<adjective:hard>` | "hard", "very hard"; "hardly", "hardness", "harder" are errors of form |
| `<adjective:{feel}>`, `<comparative:{feel}>`, `<superlative:{feel}>` | the same of any word of `lists = { feel = { "hard", "smooth" } }`, which becomes `answer.feel`. With `<adjective:{feel}> [and <adjective:{feel:also}>]` the learner may give two, `answer.feel` and `answer.also`; without the brackets two are asked for. A missing "and" is an error of form |
| `<made_of:{material}>` | "is made of metal", "are made of metal"; the material, a word of `lists.material`, becomes `answer.material`. List the wrong ones that pupils may say as well: what is in no list is not understood, which is not the same as wrong. "made by", "is make of", "makes of", "made of a metal" and a missing "is" are errors of form |
| `<made_of:metal>` | the same of one material |
| `<place>` | the template of `rules = { place = "(on|under) the {thing}" }`, for what stands in several sentences: `answers = { "(it\|the egg) is <place>", "I see it <place>" }` |
| `<it>` | it, this, that, they, these, those; a verb after it agrees |
| `<plural:moon>` | "moons"; after a {number} that is "one", "a" or "an": "moon". "there are {number} <plural:moon>" gives "There is one moon." |
| `\[` | the character itself |

A learner may point at what is named: "this metal", "these rocks", "that apple" are understood wherever the noun is;
"these metal", "this rocks" are errors of form. Who only points, "this one is heavier", is asked "Which one? Say its name."
A number that is in none of the lists ("fifteen" where they end at ten) is a wrong answer, told so without asking `right`.

A list holds plain words, no template: none of `[ ] ( ) { } < > ; \`. What may be left out or changes its form stands around the
{list} in the sentence: `"[big] {thing}"`, `"<comparative:{size}>"`. A list's word may be several, with the article that it always has
(`"the Moon"`, `"stone block"`), and may be said in several ways, `"bike|bicycle"`; the answer has the first. British and American
spelling of a word ("tyre", "tire") need not be listed. A number ("two"), a place ("far") and what begins with a preposition ("to the left")
never take an article.

Who is not understood is asked again, then shown how the sentence goes, then what may be said; after six answers that are not understood the
question is left, as it is after `tries` of wrong meaning, and `answer.over` is true.

What learners say that is no good English at all stands in `nearly`: `nearly = { "how many moons {planet} has" }` is
understood, is an error of form, and is said back as the first answer that has the same {slots}.

Short answers come by themselves: "The egg." where only `{thing}` is needed; "Metal." and "It is made of metal." where
`<made_of:{material}>` is; "Hard and smooth." and "It feels hard." where `<adjective:{feel}>` is; "Three ramps." where `there are {number} <plural:ramp>`
counts; "Next to the bowl." and "It is next to
the bowl." where `<place>` or `{place} the {thing}` ends a sentence, "the apple is <place>", in which nothing is to be chosen before it. What a short answer
leaves out is nil: after "Metal." to `"{thing} <made_of:{material}>"` `answer.thing` is nil, for it is the thing that was asked
about. "Metal is made of a spaceship." is understood too, and gives `answer.thing == "metal"` and
`answer.material == "spaceship"`: `right` should compare with them, not index by them.

```lua
L:question "heavier" {
  prompt = "Which one is heavier?",
  answers = { "[a|an|the] {thing} is <comparative:heavy> than [a|an|the] {other}" },
  right = function(answer)
    local thing, other = answer.bodies.thing, answer.bodies.other
    return thing ~= nil and other ~= nil and thing.weight > other.weight
  end,
}

L:question "feel" {
  prompt = "How does metal feel?",
  answers = { "{material} (is|feels) <adjective:{feel}> [and <adjective:{feel:also}>]" },
  lists = { material = { "metal", "wood", "rock" }, feel = { "hard", "soft", "smooth", "rough" } },
  right = function(answer)
    local ok = { hard = true, smooth = true }
    return (answer.material or "metal") == "metal" and ok[answer.feel] and (not answer.also or ok[answer.also])
  end,
}

L:question "made" {
  prompt = "What is the spaceship made of?",
  answers = { "(the|a) spaceship <made_of:{material}>" },
  lists = { material = { "metal", "wood", "rock" } },
  right = function(answer) return answer.material == "metal" end,
}

L:question "count" {
  prompt = "How many eggs are there?",
  answers = { "[there are] {number} <plural:egg>" },
  lists = { number = { "two|2", "three|3" } },
  right = function(answer) return answer.number == "two" end,
}
```
)";

constexpr const char* kTests = R"(
## Tests

`./fulcrum test FOLDER` plays the first `L:test` without a window: the hand is the file `hand`, a Lua file beside the lesson
(see `motion` below), the answers are `say` in turn, and the lesson must end as `expect` says. A line of `say` that begins with a question mark, "?What is this",
is asked while no question is open; one that asks for nothing that the lesson knows fails the test, and where a test fails, the answers that were
marked wrong are named.

```lua
L:test { hand = "catcher.lua", say = { "the apple is the heaviest" }, expect = { finished = true, stars = 3 } }
```

`expect` knows )";

template <class Names>
std::string quoted(const Names& names) {
    std::string text;
    for (const std::string_view name : names) {
        text += (text.empty() ? "`" : ", `") + std::string(name) + '`';
    }
    return text;
}

std::string events_section() {
    std::string out =
        "\n## Events\n\nWhat a listener (`L:listen`) and `story.wait_for` get: a table with `name` "
        "and these fields.\n\n| name | when | fields |\n|---|---|---|\n";
    for (const EventText& event : event_texts()) {
        out += "| `" + std::string(event.name) + "` | " + std::string(event.text) + " | " +
               quoted(event.fields) +
               (event.name == "answered" ? " and the slots: see answer" : "") + " |\n";
    }
    return out;
}

std::string names_sections() {
    std::string out = "\n## Sounds\n\n`world:sound` plays one of " + quoted(kSoundNames) +
                      ". Catching, landing, answers, levels and the end sound by themselves.\n";
    out +=
        "\n## Models\n\n`model` of a body or the bucket is one of " + quoted(kModelNames) +
        ", or a `.glb` or `.gltf` file beside the lesson, without its ending: `model = "
        "\"kettle\"` is kettle.glb. `sphere` is a ball of the body's `radius`, `box` a cube twice "
        "that wide, both seen and felt so, and `sun` and the planets `mercury` to `neptune` are "
        "balls "
        "likewise; `cylinder` is a post 0.16 m tall and `capsule` a pill 0.2 m tall, both 0.08 m "
        "across, seen and felt so; `orbit` is a thin line in a circle of that radius, seen and not "
        "felt. Other "
        "models "
        "have their own size. The same names are a tool's `model`, but for `orbit`: there the "
        "tool's "
        "own `radius` says how large a ball or a box is.\n";
    return out;
}

/// A number as a table shows it, with what it is in.
std::string short_number(double value, const char* format) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string materials_section() {
    std::string out =
        "\n## Materials\n\n`material` of a solid body, and `like` of `world:material`, is one of "
        "these. What can truly be said of a material comes from its numbers: "
        "`body.material.hardness` and the others, see material.\n\n| material | stiffness N/m | "
        "friction | tone of a tap Hz | hardness | roughness | slipperiness |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const Material& material : shipped_materials()) {
        const MaterialFacts facts = describe(material);
        out += "| `" + material.name + "` | " + short_number(facts.stiffness_N_per_m, "%.0f") +
               " | " + short_number(material.friction.static_coefficient, "%.2g") + " | " +
               short_number(facts.ringing_Hz, "%.0f") + " | " +
               short_number(facts.hardness, "%.2f") + " | " +
               short_number(facts.roughness, "%.2f") + " | " +
               short_number(facts.slipperiness, "%.2f") + " |\n";
    }
    return out +
           "\nA material out of another one and a photo, which lies beside the lesson; dark is "
           "low, "
           "light is high:\n\n```lua\nlocal felt = world:material {\n  name = \"felt\", like = "
           "\"wood\", stiffness = 300, friction = 0.6,\n  texture = { image = \"felt.jpg\", size = "
           "0.05, height = 0.0004 },\n}\nworld:body { name = \"cushion\", model = \"box\", solid = "
           "true, visible = true, material = felt }\n```\n";
}

// ---- modules of the library ---------------------------------------------------------------------------------------

bool begins(const std::string& line, std::string_view with) {
    return line.starts_with(with);
}

/// "---@param seconds number how long" as "- `seconds` number: how long"; of a type with blanks in it only its text is lost.
std::string annotation_line(const std::string& line) {
    std::istringstream words(line);
    std::string tag;
    std::string name;
    std::string type;
    words >> tag;
    if (tag == "---@param") {
        words >> name;
    }
    std::getline(words >> std::ws, type);
    return tag == "---@param"    ? "- `" + name + "`: " + type + '\n'
           : tag == "---@return" ? "- gives " + type + '\n'
                                 : std::string();
}

/// Comment lines as a text: what is indented becomes code.
std::string block_text(const std::vector<std::string>& lines) {
    std::string out;
    std::string list;
    bool in_code = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (begins(lines[i], "---@")) {
            list += annotation_line(lines[i]);
            continue;
        }
        const std::string text = lines[i].size() > 4 ? lines[i].substr(4) : "";
        const bool is_code =
            begins(text, "  ") ||
            (in_code && text.empty() && i + 1 < lines.size() && begins(lines[i + 1], "---   "));
        if (is_code != in_code) {
            out += is_code ? "```lua\n" : "```\n";
            in_code = is_code;
        }
        out += (is_code && text.size() > 2 ? text.substr(2) : text) + '\n';
    }
    out += in_code ? "```\n" : "";
    return out + (list.empty() ? "" : '\n' + list);
}

}  // namespace

std::span<const FieldText> answer_fields() {
    return kAnswerFields;
}

std::vector<EventText> event_texts() {
    std::vector<EventText> events = {
        {"caught", "a body fell into the bucket", {"body", "speed"}},
        {"landed", "a body hit the ground", {"body", "speed"}},
        {"touched", "the tool began to touch a solid body", {"body", "speed"}},
        {"released", "the tool no longer touches it", {"body", "speed"}},
        {"key", "a key was pressed", {"key"}},
        {"answered", "an answer was marked and answered to", {}},
        {"update", "each frame; for `L:listen` alone", {"dt"}},
    };
    for (const FieldText& field : kAnswerFields) {
        events[5].fields.push_back(field.name);
    }
    return events;
}

std::string general_sections() {
    std::string out = kFiles + events_section() + kAnswerHead;
    for (const FieldText& field : kAnswerFields) {
        out += "| `answer." + std::string(field.name) + "` | " + std::string(field.text) + " |\n";
    }
    out +=
        kTemplates + names_sections() + materials_section() + kTests + quoted(kTestFacts) +
        ": `finished` and `felt`, whether the hand felt anything, are true or false, the others "
        "are "
        "whole numbers. `form_errors` counts errors "
        "of form, not answers: one answer may have several. Where the lesson asks more often than "
        "`say` answers, the test ends there and has failed.\n";
    return out;
}

std::string library_section(const LibraryModule& module) {
    std::string out = "\n## " + module.name + "\n\n`local " + module.name + " = require \"" +
                      module.name + "\"`\n";
    std::istringstream text(module.text);
    std::vector<std::string> block;
    bool at_head = true;
    for (std::string line; std::getline(text, line);) {
        if (begins(line, "---")) {
            block.push_back(line);
            continue;
        }
        const std::string call = "function " + module.name + '.';
        if (begins(line, call) && !block.empty()) {
            const std::size_t end = line.find(')');
            out += "\n### `" + line.substr(9, end == std::string::npos ? end : end - 8) + "`\n\n" +
                   block_text(block);
        } else if (at_head && !block.empty()) {
            out += '\n' + block_text(block);
            at_head = false;
        }
        block.clear();
    }
    return out;
}

}  // namespace fulcrum::runtime
