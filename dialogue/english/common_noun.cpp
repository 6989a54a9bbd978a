#include "dialogue/english/common_noun.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/wordnet_line.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fulcrum::dialogue {
namespace {

constexpr std::string_view kNounsPackage = "wordnet-base";

std::vector<std::string_view> parts_of_line(std::string_view line) {
    std::vector<std::string_view> fields;
    while (!line.empty()) {
        const std::string_view field = take_field(line);
        if (!field.empty()) {
            fields.push_back(field);
        }
    }
    return fields;
}

/// Where the first sense stands: of "apple n 2 5 … 07739125 12633994" the first of the two numbers at the end.
std::size_t first_sense(std::string_view index_line) {
    const auto fields = parts_of_line(index_line.substr(0, index_line.find('\n')));
    const std::size_t n_senses = fields.size() > 2 ? number_in(fields[2], 10) : 0;
    return n_senses == 0 || n_senses > fields.size()
               ? std::string_view::npos
               : number_in(fields[fields.size() - n_senses], 10);
}

}  // namespace

Expected<CommonNouns> CommonNouns::open(std::string_view folder) {
    auto index = SortedLines::open(concat({folder, "/index.noun"}), kNounsPackage);
    if (!index) {
        return tl::unexpected(index.error());
    }
    auto data = SortedLines::open(concat({folder, "/data.noun"}), kNounsPackage);
    if (!data) {
        return tl::unexpected(data.error());
    }
    return CommonNouns(std::move(*index), std::move(*data));
}

bool CommonNouns::has(std::string_view word) const {
    const std::string lower = lower_case(word);
    if (lower.empty() || lower.front() == ' ') {
        return false;
    }
    const std::string_view entry = index_.starting_with(lower + " ");
    const std::size_t sense = entry.empty() ? std::string_view::npos : first_sense(entry);
    if (sense >= data_.text().size()) {
        return false;
    }
    const std::string_view line = data_.text().substr(sense);
    const auto fields = parts_of_line(line.substr(0, line.find('\n')));
    const std::size_t n_words = fields.size() > 3 ? number_in(fields[3], 16) : 0;
    bool in_small_letters = false;
    for (std::size_t i = 0; i < n_words && 4 + 2 * i < fields.size(); ++i) {
        const std::string_view said = fields[4 + 2 * i];
        if (said != lower && lower_case(said) == lower) {
            return false;  // a name in the same sense
        }
        in_small_letters = in_small_letters || said == lower;
    }
    return in_small_letters;
}

}  // namespace fulcrum::dialogue
