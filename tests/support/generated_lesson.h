// Lessons made by chance out of the binding table: each calls some of its functions with values by the table's own types and ranges, and
// most of them put a force on the hand. Where fields do not go together a call is refused with a sentence; the lesson passes it over and
// goes on, so that what is left is a right lesson. A `hostile` one has whatever else Lua can pass as well.
#pragma once

#include "tests/support/generated_values.h"

#include <cstdlib>

namespace fulcrum::test {

/// A call that stands in a lesson, and the fields that are given in it.
struct GeneratedCall {
    const Binding* binding = nullptr;
    std::vector<std::string> fields;
};

struct GeneratedLesson {
    std::string text;
    std::string hand;  ///< a simulated hand that goes with it: about where it began, slowly
    /// What its prints "done 3 5 …" tell by their numbers: the calls that were accepted.
    std::vector<GeneratedCall> calls;
};

class LessonWriter {
  public:
    explicit LessonWriter(Choices choices, bool hostile = false)
        : choices_(choices), hostile_(hostile), values_(choices_, declared_, hostile) {}

    GeneratedLesson write() {
        lesson_.text = kPrelude;
        write_head();
        write_start();
        write_update();
        lesson_.text += "return L\n";
        lesson_.hand =
            "local x, y, z\nreturn function(hand, t)\n  if t < 0.1 then return end\n"
            "  x, y, z = x or hand.x, y or hand.y, z or hand.z\n  local way = " +
            lua_number(0.03 * scale_) +
            " * math.sin(2 * math.max(t - 1.1, 0))\n"
            "  return x + way, y - way, z + 0.5 * way, t > 1 and t < 2\nend\n";
        return std::move(lesson_);
    }

  private:
    // Forces are switched on where the hand is, as a lesson does that wants them felt: a hand that begins far from where a spring pulls
    // it to is given no force at all.
    static constexpr const char* kPrelude = R"lua(
local held = { body = {}, force = {}, hand = {}, material = {}, kite = {} }
local done, frame, x0 = {}, 0, false
local function try(id, kind, place, call)
  local fine, value = pcall(call)
  if fine and done[#done] ~= id then done[#done + 1] = id end
  if fine and kind then held[kind][place] = value end
end
local function some(things, call)
  local fine, why = false, "there is none"
  for _, thing in ipairs(things) do
    local took, problem = pcall(call, thing)
    fine, why = fine or took, problem
  end
  if not fine then error(why, 0) end
end
local function tell() print("done " .. table.concat(done, " ")) done = {} end
local function from_start(x) x0 = frame > 5 and (x0 or x) return x0 and x - x0 or 0 end
local function many(value, n) local all = {} for i = 1, n do all[i] = value end return all end
)lua";
    static constexpr const char* kHostilePrelude = R"lua(
local L, acts, depth = nil, {}, 0
local function deep(n) local all = {} for i = 1, n do all = { all, at = all } end return all end
local function act(...)
  depth = depth + 1
  local call = acts[1 + (depth * 7) % 5]
  if depth < 12 and call then call() end
  if depth % 3 == 0 then error("half-way") end
  if depth % 4 == 0 then coroutine.yield(1) end
  return depth % 2 == 0 and 0.1 or held
end
local function haunted(value)
  return setmetatable(value, { __index = act, __newindex = act, __len = act, __pairs = act, __call = act, __eq = act, __lt = act,
    __concat = act, __unm = act, __add = act, __tostring = act, __close = act, __name = "world" })
end
)lua";

    struct BodyKind {
        const char* first;   ///< what makes it one
        const char* fields;  ///< what goes with that
    };
    static constexpr BodyKind kBodyKinds[] = {
        {"", "noun radius mass exaggeration visible at drag_area"},
        {"solid = true, ",
         "noun radius mass material rounded visible at about felt_model felt_shape"},
        {"solid = true, model = \"box\", ", "size material visible at"},
        {"solid = true, model = \"box\", ", "boxes material at visible"},
        {"solid = true, ", "radius mass material hinge at visible"},
        {"solid = true, hinge = { axis = { 0, 0, 1 }, inertia = 10 }, ", "radius mass at visible"},
        {"movable = true, ", "noun radius mass exaggeration visible at drag_area about"},
        {"movable = true, solid = true, ", "radius mass exaggeration visible at material"},
        {"rigid = true, ",
         "noun radius mass material at about felt_model felt_shape simulated_model shape joint"},
        {"rigid = true, model = \"box\", ", "size density material at joint"},
        {"", ""}};
    static constexpr std::size_t kMovable = 6;

    void write_head() {
        lesson_.text += hostile_ ? kHostilePrelude : "";
        const Binding& head = function("", "lesson");
        const std::string record = values_.record(head.parameters, 20);
        two_hands_ = record.find("hands = 2") != std::string::npos;
        lesson_.text += (hostile_ ? "L = lesson " : "local L = lesson ") + record + '\n';
        for (std::size_t n = choices_.below(3); n > 0; --n) {
            const char* const kinds[] = {"question", "knows", "test"};
            write_call(function("lesson", pick(choices_, kinds)), "L");
        }
    }

    void write_start() {
        declared_.has_world = true;
        lesson_.text += "function L:start(world)\n";
        write_haunts();
        write_call(function("world", "hand"), "world");
        if (two_hands_) {
            write_call(function("world", "hand"), "world");
        }
        write_felt();
        std::vector<const Binding*> declaring;
        for (const Binding& binding : api_table().functions) {
            const int weight = binding.name == std::string_view("body")       ? 4
                               : binding.name == std::string_view("material") ? 2
                                                                              : 1;
            if (binding.time == CallTime::declaring && binding.name != std::string_view("hand")) {
                declaring.insert(declaring.end(), static_cast<std::size_t>(weight), &binding);
            }
        }
        for (std::size_t n = 1 + choices_.below(9); n > 0; --n) {
            write_some(declaring);
        }
        write_acting(choices_.below(4));
        lesson_.text += "  for _, force in pairs(held.force) do force:off() end\n  tell()\nend\n";
    }

    /// What is felt once the lesson runs: a declared force, one of the lesson's own, or a weight in the bucket.
    void write_felt() {
        const char* const forces[] = {"spring", "magnet", "viscosity"};
        write_call(function("world", pick(choices_, forces)), "world");
        switch (choices_.below(4)) {
            case 0:
                write_call(function("hand", "force"), "held.hand[1]");
                break;
            case 1:
                write_call(function("world", "bucket"), "world");
                write_body(kMovable);
                break;
            default:
                write_call(function("world", pick(choices_, forces)), "world");
        }
    }

    void write_update() {
        const bool is_short = choices_.chance(3);
        const bool fails = !is_short && choices_.chance(20);
        const std::string stars = std::to_string(choices_.below(4));
        declared_.is_running = true;
        lesson_.text += "function L:update(world, dt)\n  frame = frame + 1\n  if frame == 1 then\n";
        write_acting(2 + choices_.below(6));
        lesson_.text += "    tell()\n  elseif frame == 2 then\n";
        write_haunts();
        write_acting(2 + choices_.below(6));
        lesson_.text +=
            R"lua(    tell()
  elseif frame == 5 then
    for _, force in pairs(held.force) do force:off() end
  elseif frame == 40 then
    for _, force in pairs(held.force) do
      force:move { at = world:tool().position }
      force:strength(1)
      force:on()
    end
  elseif frame == 60 then
    for _, body in pairs(held.body) do pcall(function() body:hold() end) end
  elseif frame == )lua" +
            std::string(is_short ? "3" : "150") + " then\n    " +
            (fails ? "error(\"generated to fail\")" : "world:finish { stars = " + stars + " }") +
            "\n  end\nend\n";
    }

    void write_acting(std::size_t n) {
        std::vector<const Binding*> acting;
        for (const Binding& binding : api_table().functions) {
            if ((binding.time == CallTime::acting || binding.time == CallTime::looking) &&
                binding.name != std::string_view("finish") &&
                (declared_.is_running || !needs_another(binding))) {
                acting.push_back(&binding);
            }
        }
        for (; n > 0; --n) {
            write_some(acting);
        }
    }

    /// Whether L:start ends with an error where it is called and what it needs is not declared.
    static bool needs_another(const Binding& binding) {
        return binding.owner == std::string_view("body") ||
               binding.name == std::string_view("wind_speed");
    }

    /// One of those whose owner there is.
    void write_some(const std::vector<const Binding*>& bindings) {
        for (int i = 0; i < 4; ++i) {
            const Binding& binding = *pick(choices_, bindings);
            const std::string_view owner = binding.owner;
            const std::string receiver =
                owner == "lesson" ? "L" : declared_.handle(choices_, owner);
            // The wind is for a kite, and contacts for rigid bodies.
            const bool is_of_no_use =
                (binding.name == std::string_view("wind") && !declared_.handles.contains("kite")) ||
                (binding.name == std::string_view("contacts") &&
                 lesson_.text.find("rigid = true") == std::string::npos);
            if (is_of_no_use && !choices_.chance(3)) {
                continue;
            }
            if (!receiver.empty() && binding.name == std::string_view("body")) {
                write_body(choices_.below(std::size(kBodyKinds)));
                return;
            }
            if (!receiver.empty()) {
                write_call(binding, owner == "body" ? "it" : receiver);
                return;
            }
        }
    }

    void write_body(std::size_t kind) {
        const BodyKind& chosen = kBodyKinds[kind];
        constexpr std::string_view kModels[] = {"sphere", "box", "earth", "apple"};
        std::string first = chosen.first;
        if (first.find("model") == std::string::npos && *chosen.fields != '\0') {
            first += "model = " + in_quotes(pick(choices_, kModels)) + ", ";
        }
        GeneratedCall call{&function("world", "body"), {}};
        const std::string record =
            values_.record(call.binding->parameters, 35, chosen.fields, &call.fields, first);
        add_try(std::move(call), "world:body " + record);
    }

    void write_call(const Binding& binding, const std::string& receiver) {
        GeneratedCall call{&binding, {}};
        std::string text = receiver + ':' + binding.name;
        std::span<const Parameter> fields(binding.parameters);
        if (binding.shape == CallShape::positional) {
            text += '(';
            for (std::size_t i = 0; i < fields.size(); ++i) {
                if (fields[i].fallback != kRequired && choices_.chance(50)) {
                    break;
                }
                text += (i > 0 ? ", " : "") + values_.value(fields[i]);
                call.fields.emplace_back(fields[i].name);
            }
            add_try(std::move(call), text + (hostile_ && choices_.chance(5) ? ", 1)" : ")"));
            return;
        }
        if (binding.shape == CallShape::named_record) {
            const std::string name = values_.new_name("q");
            text += " " + name;
            fields = fields.subspan(1);
            if (binding.name == std::string_view("question")) {
                declared_.questions.push_back(name);
            }
        }
        // What is asked and answered has to fit together in more than the table tells.
        const bool is_talk = binding.shape == CallShape::named_record && !choices_.chance(20);
        const char* only = is_talk ? "prompt answers right again feedback asked answer" : "";
        const bool is_hand = binding.name == std::string_view("hand");
        const std::size_t percents[] = {30, 0, 10, 60};
        const std::size_t percent = is_hand ? 10 : pick(choices_, percents);
        const std::string record = values_.record(fields, percent, only, &call.fields);
        if (is_hand && scale_ == 1.0) {
            const std::size_t at = record.find(" scale = ");
            scale_ = at == std::string::npos ? 1.0 : std::strtod(record.c_str() + at + 9, nullptr);
        }
        add_try(std::move(call), text + ' ' + record);
    }

    void add_try(GeneratedCall call, const std::string& text) {
        constexpr std::pair<std::string_view, const char*> kResults[] = {{"Body", "body"},
                                                                         {"Force", "force"},
                                                                         {"Hand", "hand"},
                                                                         {"Material", "material"},
                                                                         {"Kite", "kite"}};
        std::string keeps = "nil, nil";
        for (const auto& [result, kind] : kResults) {
            if (call.binding->result == result && call.binding->time == CallTime::declaring) {
                keeps = in_quotes(kind) + ", " + std::to_string(++declared_.handles[kind]);
            }
        }
        lesson_.calls.push_back(std::move(call));
        std::string does = "function() return " + text + " end";
        if (text.starts_with("it:")) {  // any body that it can be done to
            does = "function() return some(held.body, function(it) return " + text + " end) end";
        }
        if (hostile_ && choices_.chance(10)) {
            does = "coroutine.wrap(" + does + ")";
        }
        const std::string again = choices_.chance(2) ? "  for _ = 1, 250 do" : "";
        lesson_.text += again + "  try(" + std::to_string(lesson_.calls.size() - 1) + ", " + keeps +
                        ", " + does + ")" + (again.empty() ? "\n" : " end\n");
    }

    /// What metamethods and callbacks do next: calls like all others.
    void write_haunts() {
        for (std::size_t n = hostile_ ? 5 : 0; n > 0; --n) {
            const Binding& binding = pick(choices_, api_table().functions);
            const std::string receiver = declared_.handle(choices_, binding.owner);
            if (!receiver.empty() && binding.shape != CallShape::named_record) {
                lesson_.text +=
                    "  acts[" + std::to_string(n) + "] = function() return " + receiver + ':' +
                    binding.name +
                    (binding.shape == CallShape::record ? values_.record(binding.parameters, 20)
                                                        : "()") +
                    " end\n";
            }
        }
    }

    static const Binding& function(std::string_view owner, std::string_view name) {
        const auto& all = api_table().functions;
        return *std::ranges::find_if(all, [&](const Binding& binding) {
            return owner == binding.owner && name == binding.name;
        });
    }

    Choices choices_;
    bool hostile_;
    Declared declared_;
    ValueWriter values_;
    GeneratedLesson lesson_;
    bool two_hands_ = false;
    double scale_ = 1.0;
};

}  // namespace fulcrum::test
