// Lua values for the parameters of the binding table, by the table's own types, ranges and choices: within the range and at its ends,
// the number next to an end, tiny, minus zero, and what the program itself handed to the lesson. Where they are `hostile`, others as well.
#pragma once

#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/wire/wire.h"
#include "runtime/scene/sounds.h"
#include "tests/support/choices.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::test {
using namespace runtime;

/// Exactly that number, as Lua reads it.
inline std::string lua_number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return value == 0.0 && std::signbit(value) ? "-0.0" : text;
}

inline std::string in_quotes(std::string_view text) {
    return '"' + std::string(text) + '"';
}

/// One of a list.
template <class List>
auto pick(Choices& choices, const List& list) {
    return *std::next(std::begin(list),
                      static_cast<std::ptrdiff_t>(choices.below(std::size(list))));
}

/// A number of [low, high]: anywhere, at an end, beside one, tiny, minus zero, or as it usually is in a scene.
inline double generated_number(Choices& choices, double low, double high) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kScene = 0.3;  // metres around the middle, and many other things besides
    const double numbers[] = {std::clamp(kScene * choices.part(), low, high),
                              low + (high - low) * choices.part(),
                              low,
                              high,
                              std::nextafter(low, kInfinity),
                              std::nextafter(high, -kInfinity),
                              std::numeric_limits<double>::denorm_min(),
                              std::numeric_limits<double>::min(),
                              -0.0};
    const double number = choices.chance(60) ? numbers[choices.below(2)] : pick(choices, numbers);
    return number >= low && number <= high ? number : low;
}

/// What has been declared so far, by what a handle of it is called in Lua: "body" -> how many.
struct Declared {
    std::map<std::string, std::size_t, std::less<>> handles;
    std::vector<std::string> names;      ///< of all, in quotation marks
    std::vector<std::string> questions;  ///< likewise
    bool has_world = false;              ///< in a function of the lesson
    bool is_running = false;             ///< in L:update, not in L:start

    /// The Lua of some handle; empty where there is none.
    [[nodiscard]] std::string handle(Choices& choices, std::string_view owner) const {
        if (owner == "world" || owner == "tool") {
            return !has_world ? "" : owner == "world" ? "world" : "world:tool()";
        }
        const auto found = handles.find(owner);
        return found == handles.end() ? ""
                                      : "held." + std::string(owner) + '[' +
                                            std::to_string(1 + choices.below(found->second)) + ']';
    }
};

class ValueWriter {
  public:
    ValueWriter(Choices& choices, Declared& declared, bool hostile)
        : choices_(choices), declared_(declared), hostile_(hostile) {}

    /// `{ name = …, … }` of those fields; one that may be left out stands there in so many of a hundred cases. Of what the list `only`
    /// names, where it is not empty; `given` takes their names.
    std::string record(std::span<const Parameter> fields, std::size_t percent,
                       std::string_view only = {}, std::vector<std::string>* given = nullptr,
                       const std::string& first = {}) {
        std::string text = "{ " + first;
        for (const Parameter& field : fields) {
            const bool is_missing = hostile_ && choices_.chance(3);
            const bool is_given = field.fallback == kRequired
                                      ? !is_missing
                                      : may_give(field, only) && choices_.chance(percent);
            if (is_given && first.find(std::string(field.name) + " = ") == std::string::npos) {
                text += std::string(field.name) + " = " + value(field) + ", ";
                if (given != nullptr) {
                    given->emplace_back(field.name);
                }
            }
        }
        if (hostile_ && choices_.chance(5)) {
            text += choices_.chance(50) ? "naem = 1, " : odd() + ", ";
        }
        text += "}";
        return hostile_ && choices_.chance(10) ? "haunted(" + text + ")" : text;
    }

    std::string value(const Parameter& parameter) {
        if (hostile_ && choices_.chance(8)) {
            return odd();
        }
        if (const std::string known = known_value(parameter); !known.empty()) {
            return known;
        }
        if (choices_.chance(10)) {
            if (const std::string handed = handed_value(parameter.type); !handed.empty()) {
                return handed;
            }
        }
        return plain_value(parameter);
    }

    /// A name that nothing has yet.
    std::string new_name(std::string_view prefix = "n") {
        std::string name = std::string(prefix) + std::to_string(++n_names_);
        if (choices_.chance(5)) {
            name.append(kMaxNameBytes - name.size(), '-');
        }
        return declared_.names.emplace_back(in_quotes(name));
    }

  private:
    static bool may_give(const Parameter& field, std::string_view only) {
        return only.empty() ||
               (' ' + std::string(only) + ' ').find(' ' + std::string(field.name) + ' ') !=
                   std::string::npos;
    }

    /// Where not every text is one that the lesson may say.
    std::string known_value(const Parameter& parameter) {
        const std::string_view name = parameter.name;
        constexpr std::string_view kModels[] = {"sphere", "box", "earth", "apple"};
        constexpr std::string_view kMaterials[] = {"wood", "metal", "rubber"};
        if (name == "model" || name == "felt_model" || name == "simulated_model") {
            return in_quotes(pick(choices_, kModels));
        }
        if (name == "like" || name == "material") {
            const std::string made = declared_.handle(choices_, "material");
            return name == "material" && !made.empty() && choices_.chance(50)
                       ? made
                       : in_quotes(pick(choices_, kMaterials));
        }
        if (name == "level" && parameter.type == ParameterType::text) {
            return in_quotes(pick(choices_, kEnglishLevels));
        }
        if (name == "name" && *parameter.text == 's') {  // "see Sounds"
            return in_quotes(pick(choices_, kSoundNames));
        }
        if (name == "answer") {
            return choices_.chance(50) ? "function() return " + text(2 * kMaxTextBytes) + " end"
                                       : "function() end";
        }
        if (const auto usual = usual_range(parameter); usual && !choices_.chance(10)) {
            return lua_number(usual->first + (usual->second - usual->first) * choices_.part());
        }
        const bool is_sentence = name == "answers" || name == "asked" || name == "prompt";
        if (is_sentence && !choices_.chance(10)) {
            return name == "answers" ? R"({ "it is an apple" })"
                   : name == "asked" ? R"({ "is it an apple" })"
                                     : R"("What is it?")";
        }
        if (name == "feedback") {
            return R"({ "recast", "prompt", "rule", "replay" })";
        }
        if (name == "expect") {
            return "{ finished = true, stars = 3, score = -7 }";
        }
        if (name == "image") {
            return R"("felt.png")";
        }
        if (name == "hand" || name == "second_hand") {
            return R"("hand.lua")";
        }
        if (name == "question" && !declared_.questions.empty()) {
            return pick(choices_, declared_.questions);
        }
        const bool is_known =
            name == "to" || (name == "name" && parameter.type == ParameterType::text);
        return is_known && !declared_.names.empty() ? pick(choices_, declared_.names) : "";
    }

    /// Where most of what the table allows goes with a hand and with nothing else that pulls at it.
    static std::optional<std::pair<double, double>> usual_range(const Parameter& parameter) {
        const std::string_view name = parameter.name;
        if (parameter.type != ParameterType::number) {
            return std::nullopt;
        }
        using Ends = std::optional<std::pair<double, double>>;
        return name == "scale"                                   ? Ends({0.5, 1.5})
               : name == "stiffness" && parameter.high == 2000.0 ? Ends({20.0, 400.0})
               : name == "damping" && parameter.high == 50.0     ? Ends({2.0, 8.0})
               : name == "force" && parameter.high == 10.0       ? Ends({0.5, 8.0})
                                                                 : Ends{};
    }

    /// What the program told the lesson, of the type that is asked for: by the table of what can be read.
    std::string handed_value(ParameterType type) {
        const char* wanted = type == ParameterType::number   ? "number"
                             : type == ParameterType::vector ? "Vector"
                             : type == ParameterType::text   ? "string"
                                                             : nullptr;
        if (wanted == nullptr) {
            return {};
        }
        const auto& properties = api_table().properties;
        for (int i = 0; i < 8; ++i) {
            const Property& property = pick(choices_, properties);
            const std::string owner = declared_.handle(choices_, property.owner);
            const bool is_late = property.name == std::string_view("day") ||
                                 property.name == std::string_view("felt_weight");
            if (std::string_view(property.type) == wanted && !owner.empty() &&
                (declared_.is_running || !is_late)) {
                return owner + '.' + property.name;
            }
        }
        return {};
    }

    std::string plain_value(const Parameter& parameter) {
        switch (parameter.type) {
            case ParameterType::number:
                return number(parameter.low, parameter.high);
            case ParameterType::integer:
                return lua_number(
                    std::trunc(generated_number(choices_, parameter.low, parameter.high)));
            case ParameterType::flag:
                return choices_.chance(50) ? "true" : "false";
            case ParameterType::text:
                return text(static_cast<std::size_t>(parameter.high));
            case ParameterType::name:
                return parameter.name == std::string_view("name") || *parameter.name == 'i'
                           ? new_name()
                           : in_quotes("box");
            case ParameterType::vector:
                return vector(parameter.low, parameter.high);
            case ParameterType::function:
                return function();
            case ParameterType::texts:
                return texts();
            case ParameterType::lists:
                return "{ thing = { \"an apple\", \"a pear\" }, [" + new_name("l") +
                       "] = " + texts() + " }";
            case ParameterType::rules:
                return "{ [" + new_name("r") + "] = " + text(kMaxTextBytes) + " }";
            case ParameterType::values:
                return "{ stars = 1 }";
            case ParameterType::choice:
                return in_quotes(pick(choices_, choices_of(parameter)));
            case ParameterType::record: {
                const std::size_t percents[] = {40, 0, 15, 100};
                return record({parameter.fields, parameter.n_fields}, pick(choices_, percents));
            }
            case ParameterType::material:
                return in_quotes("wood");
            case ParameterType::boxes:
                return boxes();
        }
        return "nil";
    }

    std::string number(double low, double high) {
        return lua_number(generated_number(choices_, low, high));
    }
    std::string vector(double low, double high) {
        const std::string v[] = {number(low, high), number(low, high), number(low, high)};
        return choices_.chance(30) ? "{ x = " + v[0] + ", y = " + v[1] + ", z = " + v[2] + " }"
                                   : "{ " + v[0] + ", " + v[1] + ", " + v[2] + " }";
    }
    std::string text(std::size_t most) {
        const std::string texts[] = {in_quotes("an apple"),
                                     in_quotes(""),
                                     "(\"x\"):rep(" + std::to_string(most) + ")",
                                     "(\"\xC3\xA9\"):rep(" + std::to_string(most / 2) + ")",
                                     R"("a\n\tb")",
                                     in_quotes("\xE6\x97\xA5\xE6\x9C\xAC")};
        return choices_.chance(60) ? texts[0] : pick(choices_, texts);
    }
    std::string texts() {
        std::string all = "{ ";
        for (std::size_t n = choices_.below(4); n > 0; --n) {
            all += "\"word" + std::to_string(n) + "\", ";
        }
        const std::string one = text(kMaxTextBytes);
        return choices_.chance(2) ? "many(" + one + ", 200)" : all + one + " }";
    }
    std::string boxes() {
        std::string all = "{ ";
        for (std::size_t n = choices_.chance(5) ? kMaxBoxes : 1 + choices_.below(3); n > 0; --n) {
            all += "{ at = " + vector(-kFarthestBox_m, kFarthestBox_m) +
                   ", size = " + vector(kLeastEdge_m, kMostEdge_m) + " }, ";
        }
        return all + "}";
    }
    /// Of the hand's force, a question's judge, an answer, a listener.
    std::string function() {
        const std::string k = choices_.chance(80) ? number(-500.0, -50.0) : number(-2000.0, 2000.0);
        if (choices_.chance(20)) {
            const double huge = std::numeric_limits<double>::max();
            return "function() return " + number(-huge, huge) + ", " + number(-huge, huge) +
                   ", 0, " + number(-huge, huge) + ", 0, 0 end";
        }
        return "function(a) if type(a) == \"userdata\" then return " + k +
               " * from_start(a.x), 0, 0 end return \"yes\" end";
    }

    /// What no parameter wants, or not there.
    std::string odd() {
        static constexpr const char* kOdd[] = {"nil",
                                               "true",
                                               "0/0",
                                               "1/0",
                                               "-1/0",
                                               "1e308",
                                               "-1e308",
                                               "math.maxinteger",
                                               "math.mininteger",
                                               "\"\"",
                                               "\"\\xFF\\0x\"",
                                               "(\"x\"):rep(5000)",
                                               "{}",
                                               "{ 1, 2, 3 }",
                                               "{ 0, 0/0, 0 }",
                                               "deep(200)",
                                               "many(1, 5000)",
                                               "print",
                                               "held",
                                               "world",
                                               "L",
                                               "held.body",
                                               "world:tool()",
                                               "haunted({})",
                                               "haunted({ 1, 2, 3 })",
                                               "haunted({ x = 0, y = 0 })",
                                               "function() act() end",
                                               "coroutine.create(act)",
                                               "coroutine.wrap(act)",
                                               "{ at = haunted({}) }",
                                               "{ haunted({}) }",
                                               "setmetatable({}, { __index = world })",
                                               "setmetatable({}, { __index = haunted({}) })",
                                               "{ [1.5] = 1 }",
                                               "{ [\"name\\0x\"] = 1 }"};
        return pick(choices_, kOdd);
    }

    Choices& choices_;
    Declared& declared_;
    bool hostile_;
    int n_names_ = 0;
};

}  // namespace fulcrum::test
