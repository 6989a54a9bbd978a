// The binding table as texts for people: annotations for editors, a page of reference.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/reference_sections.h"

#include <array>

namespace fulcrum::runtime {
namespace {

struct Owner {
    const char* name;
    const char* type;
    const char* variable;
    const char* text;
};

constexpr std::array kOwners = {
    Owner{"lesson", "Lesson", "L",
          "A lesson: what lesson { … } gives. Define functions on it; they are looked up on every "
          "call."},
    Owner{"world", "World", "world", "The scene of a lesson."},
    Owner{"hand", "Hand", "hand", "The learner's hand: what world:hand { … } gives."},
    Owner{"body", "Body", "body", "A thing in the scene."},
    Owner{"material", "Material", "material",
          "What a body is made of: what world:material { … } gives, and body.material. Its numbers "
          "are those of "
          "the surface that the hand feels."},
    Owner{"tool", "Tool", "tool", "What the hand holds."},
    Owner{"kite", "Kite", "kite",
          "A kite on the line that the hand holds: what world:kite { … } gives."},
    Owner{"force", "Force", "force", "A force on the hand."},
};

constexpr const char* kAnnotationsHead = R"(---@meta fulcrum
-- Generated from the binding table in runtime/lua; do not edit.
-- Names, types, units and ranges of everything a lesson can call, for the Lua language server.

---@alias Vector number[]|{x: number, y: number, z: number}

)";

constexpr const char* kReferenceHead = R"(# What a lesson can call

Generated from the binding table in `runtime/lua` and the comments in `scripts/lib`; do not edit. Each line names its units: metres, kilograms, newtons, seconds. A place is `{x, y, z}`: to the right, up, towards you; or a body or the tool. A letter with an accent counts as two.

## Functions you may define

| function | when it is called |
|---|---|
)";

const char* lua_type(const Parameter& parameter) {
    switch (parameter.type) {
        case ParameterType::number:
            return "number";
        case ParameterType::integer:
            return "integer";
        case ParameterType::flag:
            return "boolean";
        case ParameterType::text:
        case ParameterType::name:
            return "string";
        case ParameterType::vector:
            return "Vector|Body|Tool";
        case ParameterType::function:
            return "function";
        case ParameterType::texts:
            return "string[]";
        case ParameterType::lists:
            return "table<string, string[]>";
        case ParameterType::rules:
            return "table<string, string>";
        case ParameterType::values:
            return "table<string, string|number|boolean>";
        case ParameterType::choice:
            return "string";
        case ParameterType::record:
            return "table";
        case ParameterType::material:
            return "Material|string";
        case ParameterType::boxes:
            return "table[]";
    }
    return "any";
}

/// What stands behind a parameter's type: its text, range and default.
std::string explained(const Parameter& parameter) {
    std::string text = parameter.text;
    for (const std::string& part :
         {range_text(parameter), parameter.fallback != kRequired &&
                                         std::string_view(parameter.fallback) != "nil" &&
                                         *parameter.fallback != '\0'
                                     ? std::string("default ") + parameter.fallback
                                     : std::string()}) {
        if (!part.empty()) {
            text += (text.empty() ? "" : "; ") + part;
        }
    }
    return text;
}

std::string options_type(const Binding& binding) {
    std::string type = binding.name;
    type[0] = static_cast<char>(type[0] - 'a' + 'A');
    return type + "Options";
}

std::size_t n_positional(const Binding& binding) {
    return binding.shape == CallShape::positional ? binding.parameters.size()
           : binding.shape == CallShape::record   ? 0
                                                  : 1;
}

std::string record_type(const Binding& binding, const Parameter& parameter) {
    std::string type = parameter.name;
    type[0] = static_cast<char>(type[0] - 'a' + 'A');
    std::string owner = binding.name;
    owner[0] = static_cast<char>(owner[0] - 'a' + 'A');
    return owner + type;
}

std::string field_type(const Binding& binding, const Parameter& parameter) {
    return parameter.type == ParameterType::record ? record_type(binding, parameter)
                                                   : lua_type(parameter);
}

void annotate_field(std::string& out, const Binding& binding, const Parameter& parameter) {
    out += std::string("---@field ") + parameter.name +
           (parameter.fallback == kRequired ? "" : "?") + ' ' + field_type(binding, parameter) +
           ' ' + explained(parameter) + '\n';
}

void annotate_options(std::string& out, const Binding& binding) {
    for (const Parameter& parameter : binding.parameters) {
        if (parameter.type == ParameterType::record) {
            out += "---@class " + record_type(binding, parameter) + '\n';
            for (std::size_t i = 0; i < parameter.n_fields; ++i) {
                annotate_field(out, binding, parameter.fields[i]);
            }
            out += '\n';
        }
    }
    out += "---@class " + options_type(binding) + '\n';
    for (std::size_t i = n_positional(binding); i < binding.parameters.size(); ++i) {
        annotate_field(out, binding, binding.parameters[i]);
    }
    out += '\n';
}

std::string class_of(std::string_view owner) {
    for (const Owner& known : kOwners) {
        if (owner == known.name) {
            return known.type;
        }
    }
    return {};
}

void annotate_function(std::string& out, const Binding& binding) {
    const bool has_options = binding.shape != CallShape::positional;
    if (has_options) {
        annotate_options(out, binding);
    }
    out += std::string("---") + binding.text + '\n';
    std::string names;
    for (std::size_t i = 0; i < n_positional(binding); ++i) {
        const Parameter& parameter = binding.parameters[i];
        // "function" is a word of Lua itself.
        const std::string name =
            std::string_view(parameter.name) == "function" ? "compute" : parameter.name;
        out += "---@param " + name + (parameter.fallback == kRequired ? "" : "?") + ' ' +
               lua_type(parameter) + ' ' + explained(parameter) + '\n';
        names += (names.empty() ? "" : ", ") + name;
    }
    if (binding.shape == CallShape::record) {
        out += "---@param options " + options_type(binding) + '\n';
        names = "options";
    } else if (binding.shape == CallShape::named_record) {
        out += "---@return fun(options: " + options_type(binding) + ")\n";
    }
    if (*binding.result != '\0') {
        out += std::string("---@return ") + binding.result + '\n';
    }
    const std::string owner = class_of(binding.owner);
    out +=
        "function " + (owner.empty() ? "" : owner + ':') + binding.name + '(' + names + ") end\n\n";
}

std::string callback_signature(const Callback& callback) {
    std::string names;
    for (const auto& [name, type] : callback.parameters) {
        names += (names.empty() ? "" : ", ") + std::string(name);
    }
    return std::string("L:") + callback.name + '(' + names + ')';
}

/// Without blanks before line ends.
std::string tidied(const std::string& text) {
    std::string tidy;
    for (const char c : text) {
        while (c == '\n' && tidy.ends_with(' ')) {
            tidy.pop_back();
        }
        tidy += c;
    }
    return tidy;
}

/// The class of an owner with its fields; a lesson's are the functions it may define.
void annotate_owner(std::string& out, const ApiTable& table, const Owner& owner) {
    out += std::string("---") + owner.text + "\n---@class " + owner.type + '\n';
    for (const Property& property : table.properties) {
        if (std::string_view(owner.name) == property.owner) {
            const std::string gap = *property.unit != '\0' && *property.text != '\0' ? "; " : "";
            out += std::string("---@field ") + property.name + ' ' + property.type + ' ' +
                   property.unit + gap + property.text + '\n';
        }
    }
    if (std::string_view(owner.name) == "lesson") {
        for (const Callback& callback : table.callbacks) {
            std::string parameters = "self: Lesson";
            for (const auto& [name, type] : callback.parameters) {
                parameters += std::string(", ") + name + ": " + type;
            }
            out += std::string("---@field ") + callback.name + "? fun(" + parameters + ") " +
                   callback.text + '\n';
        }
    }
    out += std::string("local ") + owner.type + " = {}\n\n";
}

const char* time_text(CallTime time) {
    switch (time) {
        case CallTime::loading:
            return "outside all functions";
        case CallTime::declaring:
            return "in `L:start` only";
        case CallTime::acting:
            return "in `L:start` and later";
        case CallTime::looking:
            return "always, in simulated hands too";
    }
    return "";
}

void refer_to_fields(std::string& out, const ApiTable& table, const Owner& owner) {
    bool has_fields = false;
    for (const Property& property : table.properties) {
        if (std::string_view(owner.name) == property.owner) {
            out += has_fields ? "" : "\n| field | unit | |\n|---|---|---|\n";
            has_fields = true;
            out += std::string("| `") + owner.variable + '.' + property.name + "` | " +
                   property.unit + " | " + property.text + " |\n";
        }
    }
}

/// "(question)", "(hour, [minute])": what may be left out stands in brackets.
std::string call_form(const Binding& binding) {
    std::string form;
    for (const Parameter& parameter : binding.parameters) {
        const bool is_required = parameter.fallback == kRequired;
        form += (form.empty() ? "" : ", ") + std::string(is_required ? "" : "[") + parameter.name +
                (is_required ? "" : "]");
    }
    return '(' + form + ')';
}

void refer_to_function(std::string& out, const Binding& binding, const Owner& owner) {
    const std::string called =
        *owner.name == '\0' ? binding.name : std::string(owner.variable) + ':' + binding.name;
    std::string form = binding.shape == CallShape::named_record ? " \"name\" { … }" : " { … }";
    if (binding.shape == CallShape::positional) {
        form = call_form(binding);
    }
    out += "\n### `" + called + form + "`\n\n" + binding.text + " Called " +
           time_text(binding.time) + ".\n";
    for (const Parameter& parameter : binding.parameters) {
        const bool stands_before =
            binding.shape == CallShape::named_record && &parameter == binding.parameters.data();
        const char* required = stands_before                     ? "(stands before the braces) "
                               : parameter.fallback == kRequired ? "(must be given) "
                                                                 : "";
        out += std::string("- `") + parameter.name + "` " + required + explained(parameter) + '\n';
        for (std::size_t i = 0; i < parameter.n_fields; ++i) {
            const Parameter& field = parameter.fields[i];
            out += std::string("  - `") + field.name + "` " +
                   (field.fallback == kRequired ? "(must be given) " : "") + explained(field) +
                   '\n';
        }
    }
}

void annotate_answer_and_event(std::string& out) {
    out += "---@class Answer\n";
    for (const FieldText& field : answer_fields()) {
        out += "---@field " + std::string(field.name) + ' ' + std::string(field.type) + ' ' +
               std::string(field.text) + '\n';
    }
    out +=
        "---@field [string] any the slots of the template\n\n"
        "---@class Event: Answer\n"
        "---@field name string\n---@field body Body|nil\n---@field speed number|nil\n"
        "---@field key string|nil\n---@field dt number|nil\n\n";
}

}  // namespace

std::string make_annotations(const ApiTable& table) {
    std::string out = kAnnotationsHead;
    annotate_answer_and_event(out);
    for (const Owner& owner : kOwners) {
        annotate_owner(out, table, owner);
    }
    for (const Binding& binding : table.functions) {
        annotate_function(out, binding);
    }
    return tidied(out);
}

std::string make_reference(const ApiTable& table, const std::vector<LibraryModule>& library) {
    std::string out = kReferenceHead;
    for (const Callback& callback : table.callbacks) {
        out += "| `function " + callback_signature(callback) + "` | " + callback.text + " |\n";
    }
    std::vector<Owner> owners = {Owner{"", "", "", ""}};  // the globals first
    owners.insert(owners.end(), kOwners.begin(), kOwners.end());
    for (const Owner& owner : owners) {
        out += std::string("\n## ") + (*owner.name == '\0' ? "Global" : owner.variable) + '\n';
        out += *owner.text == '\0' ? "" : std::string("\n") + owner.text + '\n';
        refer_to_fields(out, table, owner);
        for (const Binding& binding : table.functions) {
            if (std::string_view(owner.name) == binding.owner) {
                refer_to_function(out, binding, owner);
            }
        }
    }
    out += general_sections();
    for (const LibraryModule& module : library) {
        out += library_section(module);
    }
    return tidied(out);
}

}  // namespace fulcrum::runtime
