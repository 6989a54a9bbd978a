#include "dialogue/catalogue.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kLongestCatalogue_bytes = 1 << 20;
constexpr std::string_view kSpaces = " \t\r";

bool is_key(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
    });
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kSpaces);
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

/// The text with \n as a new line.
std::string unescaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool new_line = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == 'n';
        result.push_back(new_line ? '\n' : text[i]);
        i += new_line ? 1 : 0;
    }
    return result;
}

/// Checks that each { is closed around a name; returns the byte of the first that isn't, or npos.
std::size_t broken_slot(std::string_view text) {
    std::size_t at = 0;
    while ((at = text.find_first_of("{}", at)) != std::string_view::npos) {
        const std::size_t end = text.find('}', at);
        if (text[at] == '}' || end == std::string_view::npos ||
            !is_key(text.substr(at + 1, end - at - 1))) {
            return at;
        }
        at = end + 1;
    }
    return std::string_view::npos;
}

/// Calls `visit(name)` for each slot of a text that `broken_slot` passed.
template <class Visit>
void for_each_slot(std::string_view text, const Visit& visit) {
    std::size_t at = 0;
    while ((at = text.find('{', at)) != std::string_view::npos) {
        const std::size_t end = text.find('}', at);
        visit(text.substr(at + 1, end - at - 1));
        at = end + 1;
    }
}

std::string quoted(std::string_view text) {
    return "\"" + std::string(text) + "\"";
}

}  // namespace

Expected<Catalogue> Catalogue::parse(std::string_view text) {
    if (text.size() > kLongestCatalogue_bytes) {
        return fail("the catalogue is larger than 1 MiB; part it");
    }
    Catalogue catalogue;
    int number = 0;
    while (!text.empty()) {
        ++number;
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string_view content = trimmed(line);
        if (content.empty() || content.front() == '#') {
            continue;
        }
        const std::size_t equals = line.find('=');
        const std::string_view key = trimmed(line.substr(0, std::min(equals, line.size())));
        if (equals == std::string_view::npos || !is_key(key)) {
            return fail("a line must be: key = text; keys are of a-z, 0-9, _ and .", 1, number);
        }
        const std::string_view value = trimmed(line.substr(equals + 1));
        if (const std::size_t broken = broken_slot(value); broken != std::string_view::npos) {
            return fail("a slot of " + quoted(key) + " isn't closed or named; write {name}",
                        static_cast<int>(value.data() - line.data()) + static_cast<int>(broken) + 1,
                        number);
        }
        if (!catalogue.texts_.emplace(std::string(key), unescaped(value)).second) {
            return fail("the key " + quoted(key) + " is given twice; take one out", 1, number);
        }
    }
    return catalogue;
}

Expected<std::string> Catalogue::text(std::string_view key, const CatalogueSlots& slots) const {
    const auto found = texts_.find(key);
    if (found == texts_.end()) {
        return fail("the catalogue has no key " + quoted(key) + "; add it");
    }
    const std::string& pattern = found->second;
    std::string result;
    std::size_t at = 0;
    while (at < pattern.size()) {
        const std::size_t open = std::min(pattern.find('{', at), pattern.size());
        result.append(pattern, at, open - at);
        if (open == pattern.size()) {
            break;
        }
        const std::size_t close = pattern.find('}', open);
        const std::string_view name = std::string_view(pattern).substr(open + 1, close - open - 1);
        const auto slot = std::find_if(slots.begin(), slots.end(),
                                       [&](const auto& given) { return given.first == name; });
        if (slot == slots.end()) {
            return fail("the text " + quoted(key) + " asks for {" + std::string(name) +
                        "}, which isn't known there; take it out");
        }
        result += slot->second;
        at = close + 1;
    }
    return result;
}

std::string Catalogue::say(std::string_view key, const CatalogueSlots& slots) const {
    auto result = text(key, slots);
    return result ? std::move(*result) : "[" + std::string(key) + "]";
}

std::string Catalogue::say_counted(std::string_view key, long count,
                                   const CatalogueSlots& slots) const {
    const auto plurals = texts_.find("language.plurals");
    const bool has_one = plurals != texts_.end() && plurals->second.starts_with("one ");
    return say(std::string(key) + (has_one && count == 1 ? ".one" : ".other"), slots);
}

std::vector<std::string> Catalogue::series(std::string_view prefix) const {
    std::vector<std::string> result;
    while (true) {
        std::string key = std::string(prefix) + "." + std::to_string(result.size() + 1);
        if (!has(key)) {
            return result;
        }
        result.push_back(std::move(key));
    }
}

std::vector<std::string> Catalogue::keys() const {
    std::vector<std::string> result;
    for (const auto& [key, text] : texts_) {
        result.push_back(key);
    }
    return result;
}

Expected<bool> Catalogue::check(std::span<const CatalogueNeed> needs) const {
    for (const CatalogueNeed& need : needs) {
        const auto found = texts_.find(need.key);
        if (found == texts_.end()) {
            return fail("the catalogue has no key " + quoted(need.key) + "; add it");
        }
        std::string unknown;
        for_each_slot(found->second, [&](std::string_view name) {
            if (std::find(need.slots.begin(), need.slots.end(), name) == need.slots.end()) {
                unknown = std::string(name);
            }
        });
        if (!unknown.empty()) {
            return fail("the text " + quoted(need.key) + " asks for {" + unknown +
                        "}, which isn't known there; take it out");
        }
    }
    return true;
}

}  // namespace fulcrum::dialogue
