#include "runtime/lua/api/binding_table.h"

#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdio>
#include <string_view>

namespace fulcrum::runtime {
namespace {

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.14g", value);
    return text;
}

void add_callbacks(ApiTable& table) {
    table.callbacks = {
        {"start",
         {{"world", "World"}},
         "Once, before the first frame: declares bodies, forces and the view."},
        {"update", {{"world", "World"}, {"dt", "number"}}, "60 times a second; dt is in seconds."},
        {"caught",
         {{"body", "Body"}, {"speed", "number"}},
         "A body fell into the bucket, at so many metres per second."},
        {"landed",
         {{"body", "Body"}, {"speed", "number"}},
         "A body hit the ground, at so many metres per second; a rigid one anything."},
        {"touched", {{"body", "Body"}}, "The tool began to touch a solid body."},
        {"released", {{"body", "Body"}}, "The tool no longer touches a solid body."},
        {"key",
         {{"name", "string"}},
         "A key was pressed: \"space\", \"return\", \"left\", a letter but p, which pauses …"},
        {"answered",
         {{"answer", "Answer"}},
         "The learner's answer has been marked and answered to."},
    };
}

/// The first function that gives such a thing: "world:hand" for a hand; empty when none does.
std::string giver_of(const ApiTable& table, const char* owner) {
    std::string type = owner;
    type[0] = static_cast<char>(type[0] - 'a' + 'A');
    for (const Binding& binding : table.functions) {
        if (type == binding.result && *binding.owner != '\0') {
            return std::string(binding.owner) + ':' + binding.name;
        }
    }
    return {};
}

}  // namespace

std::size_t Arguments::place_of(std::string_view name) const {
    for (std::size_t i = 0; i < values_.size(); ++i) {
        if (name == parameters_[i].name) {
            return i;
        }
    }
    assert(false && "a binding asked for a parameter that it does not have");
    return 0;
}

const Argument& Arguments::operator[](std::string_view name) const {
    return values_[place_of(name)];
}

Arguments Arguments::record(std::string_view name) const {
    const std::size_t place = place_of(name);
    const Parameter& parameter = parameters_[place];
    std::vector<Argument> fields;
    for (const PlainArgument& field : values_[place].fields) {
        fields.push_back({field, {}});
    }
    return {{parameter.fields, parameter.n_fields}, std::move(fields)};
}

const ApiTable& api_table() {
    static const ApiTable kTable = [] {
        ApiTable table;
        add_lesson_api(table);
        add_declaration_api(table);
        add_hand_api(table);
        add_material_api(table);
        add_action_api(table);
        add_room_api(table);
        add_tool_api(table);
        add_body_api(table);
        add_hinge_api(table);
        add_force_api(table);
        add_kite_api(table);
        add_callbacks(table);
        return table;
    }();
    return kTable;
}

std::string range_text(const Parameter& parameter) {
    std::string text;
    if (*parameter.unit != '\0') {
        text = std::string("in ") + parameter.unit;
    }
    const bool has_range = parameter.type == ParameterType::number ||
                           parameter.type == ParameterType::integer ||
                           parameter.type == ParameterType::vector;
    if (has_range) {
        text += (text.empty() ? "" : ", ") + number_text(parameter.low) + " to " +
                number_text(parameter.high);
    } else if (parameter.type == ParameterType::text) {
        text = "of at most " + number_text(parameter.high) + " letters";
    } else if (parameter.type == ParameterType::choice) {
        const std::vector<std::string> names = choices_of(parameter);
        for (std::size_t i = 0; i < names.size(); ++i) {
            text += (i == 0 ? "\"" : i + 1 == names.size() ? " or \"" : ", \"") + names[i] + '"';
        }
    }
    return text;
}

std::vector<std::string> choices_of(const Parameter& parameter) {
    std::vector<std::string> names;
    for_each_choice(parameter.choices, [&](std::string_view name) { names.emplace_back(name); });
    return names;
}

namespace {

/// As it is heard: "torque" and "tork" are the same.
std::string heard(std::string_view word) {
    constexpr std::pair<std::string_view, std::string_view> kSounds[] = {
        {"que", "k"}, {"qu", "kw"}, {"ck", "k"}, {"c", "k"}, {"ph", "f"}, {"gh", "g"}, {"z", "s"}};
    std::string sound(word);
    for (const auto& [written, said] : kSounds) {
        for (std::size_t at = 0; (at = sound.find(written, at)) != std::string::npos;) {
            sound.replace(at, written.size(), said);
            at += said.size();
        }
    }
    return sound;
}

/// The candidate that says the same shape in another word; empty for none.
std::string same_shape(std::string_view word, const std::vector<std::string>& candidates) {
    using Words = std::array<std::string_view, 5>;
    constexpr std::array<Words, 4> kShapes{{{"box", "block", "cube", "brick", "cuboid"},
                                            {"ball", "sphere", "orb", "globe", "marble"},
                                            {"capsule", "pill", "stadium", "spherocylinder"},
                                            {"cylinder", "tube", "pipe", "disc", "can"}}};
    for (const Words& words : kShapes) {
        if (word.empty() || std::ranges::find(words, word) == words.end()) {
            continue;
        }
        for (const std::string& candidate : candidates) {
            if (std::ranges::find(words, candidate) != words.end()) {
                return candidate;
            }
        }
    }
    return {};
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates,
                         std::size_t most_steps) {
    if (std::string same = same_shape(word, candidates); !same.empty()) {
        return same;
    }
    std::string best;
    int least =
        static_cast<int>(std::max<std::size_t>(1, std::min(most_steps, word.size() / 2))) + 1;
    for (const std::string& candidate : candidates) {
        const int distance = std::min(dialogue::edit_distance(word, candidate),
                                      1 + dialogue::edit_distance(heard(word), heard(candidate)));
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

std::string owner_of_name(const ApiTable& table, std::string_view name) {
    std::string places;
    const auto add = [&](const char* owner, char mark) {
        const std::string giver = giver_of(table, owner);
        places += (places.empty() ? "" : " or ") +
                  std::string(std::string_view(owner) == "lesson" ? "L" : owner) + mark +
                  std::string(name) +
                  (giver.empty() ? "" : " (" + giver + " gives the " + owner + ')');
    };
    for (const Binding& binding : table.functions) {
        if (name == binding.name && *binding.owner != '\0') {
            add(binding.owner, ':');
        }
    }
    for (const Property& property : table.properties) {
        if (name == property.name) {
            add(property.owner, '.');
        }
    }
    return places;
}

}  // namespace fulcrum::runtime
