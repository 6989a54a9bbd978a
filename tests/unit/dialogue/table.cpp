#include "tests/unit/dialogue/table.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {
namespace {

std::string trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    return begin == std::string_view::npos
               ? ""
               : std::string(text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
}

/// What a field of a line says: as it stands, or what its quotes hold.
std::string field(std::string_view written) {
    std::string text = trimmed(written);
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') {
        return text;
    }
    std::string said;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        if (text[i] != '\\') {
            said += text[i];
        } else if (text[++i] == 'x') {
            said += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            said += text[i] == 'n' ? '\n' : text[i] == 't' ? '\t' : text[i] == 'r' ? '\r' : text[i];
        }
    }
    return said;
}

std::vector<std::string> parts_of(const std::string& text, const std::string& between) {
    std::vector<std::string> parts;
    std::size_t at = 0;
    for (std::size_t next; (next = text.find(between, at)) != std::string::npos;
         at = next + between.size()) {
        parts.push_back(text.substr(at, next - at));
    }
    parts.push_back(text.substr(at));
    return parts;
}

/// " … " in `wanted` stands for anything, also at its begin and end.
bool fits(const std::string& text, const std::string& wanted) {
    const std::vector<std::string> parts = parts_of(" " + wanted + " ", " … ");
    std::size_t at = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string part = trimmed(parts[i]);
        const bool last = i + 1 == parts.size();
        const std::size_t found = last && !part.empty()
                                      ? text.size() - std::min(text.size(), part.size())
                                      : text.find(part, at);
        if (found == std::string::npos || found < at ||
            text.compare(found, part.size(), part) != 0 || (i == 0 && found != 0)) {
            return false;
        }
        at = found + part.size();
    }
    return true;
}

Question asked(const std::string& name) {
    for (Question& question : all_questions()) {
        if (question.id == name) {
            return std::move(question);
        }
    }
    throw std::runtime_error("questions.h has no question " + name);
}

/// One table, line by line.
class Table {
  public:
    Table(std::filesystem::path path, const std::map<std::string, Probe>& probes)
        : path_(std::move(path)), probes_(probes) {}

    void hold() {
        std::ifstream file(path_);
        for (std::string line; std::getline(file, line);) {
            ++line_;
            if (line.empty() || line[0] == '#') {
                continue;
            }
            INFO(path_.filename().string() << ":" << line_ << ": " << scene_.law << ": " << line);
            if (line[0] == '@') {
                const std::size_t blank = std::min(line.find(' '), line.size());
                direct(line.substr(1, blank - 1), trimmed(line.substr(blank)));
            } else {
                row(line);
            }
        }
        INFO(path_);
        CHECK(rows_ > 0);
    }

  private:
    void direct(const std::string& word, const std::string& rest) {
        if (word == "law") {
            scene_.law = rest;
            given_.clear();
            has_given_ = false;
        } else if (word == "give") {
            given_ = field(rest);
            has_given_ = true;
        } else if (word == "each") {
            for (const std::string& in : parts_of(rest, " / ")) {
                INFO(in);
                row(in);
            }
        } else if (word == "try") {
            const std::size_t blank = std::min(rest.find(' '), rest.size());
            const auto found = probes_.find(rest.substr(0, blank));
            REQUIRE(found != probes_.end());
            probe_ = found->second;
            scene_.with = trimmed(rest.substr(blank));
        } else {
            scene_.read(word, rest);
        }
    }

    void row(const std::string& line) {
        ++rows_;
        const std::string padded = line + " ";
        const std::size_t is = padded.find(" => ");
        const std::size_t like = padded.find(" =~ ");
        const std::size_t arrow = std::min(is, like);
        const std::string in = field(padded.substr(0, arrow));
        REQUIRE((arrow != std::string::npos || has_given_));
        const std::string out =
            arrow == std::string::npos ? given_ : field(std::string_view(padded).substr(arrow + 4));
        REQUIRE(probe_);
        const std::string came = probe_(scene_, in);
        if (like < is) {
            INFO(came);
            CHECK(fits(came, out));
        } else {
            CHECK(came == out);
        }
        scene_.row_done();
    }

    std::filesystem::path path_;
    const std::map<std::string, Probe>& probes_;
    TableScene scene_{};
    Probe probe_{};
    std::string given_{};
    bool has_given_ = false;
    int line_ = 0;
    int rows_ = 0;
};

}  // namespace

const Question& TableScene::question() {
    if (!question_) {
        question_ = std::make_shared<const Question>(compiled(source));
    }
    return *question_;
}

void TableScene::read(const std::string& word, const std::string& rest) {
    question_.reset();
    if (std::exchange(done_, false) || word == "question") {
        source = {"q", "Which one?", {}};
    }
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    const std::string name = rest.substr(0, colon);
    const std::string behind = colon < rest.size() ? trimmed(rest.substr(colon + 1)) : "";
    if (word == "question") {
        question_ = std::make_shared<const Question>(asked(rest));
        done_ = true;
    } else if (word == "prompt") {
        source.prompt = rest;
    } else if (word == "answer") {
        source.answers.push_back(field(rest));
    } else if (word == "nearly") {
        source.nearly.push_back(field(rest));
    } else if (word == "list") {
        source.lists.emplace_back(name, listed(behind));
    } else if (word == "rule") {
        source.rules.emplace_back(name, behind);
    } else if (word == "lists") {
        const NamedLists& lists = rest == "fruit" ? fruit() : textures();
        source.lists.insert(source.lists.end(), lists.begin(), lists.end());
    } else {
        throw std::runtime_error("a table has no @" + word);
    }
}

std::vector<std::string> listed(const std::string& text, const std::string& between) {
    return text.empty() ? std::vector<std::string>{} : parts_of(text, between);
}

void hold_tables(const std::string& folder, const std::map<std::string, Probe>& probes) {
    constexpr std::string_view kEnding = "_table.txt";
    std::vector<std::filesystem::path> tables;
    const std::filesystem::path path(FULCRUM_SOURCE_DIR "/tests/unit/dialogue/" + folder);
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
        if (entry.path().filename().string().ends_with(kEnding)) {
            tables.push_back(entry.path());
        }
    }
    REQUIRE_FALSE(tables.empty());
    std::sort(tables.begin(), tables.end());
    for (const std::filesystem::path& table : tables) {
        DYNAMIC_SECTION(table.stem().string()) {
            Table(table, probes).hold();
        }
    }
}

}  // namespace fulcrum::dialogue
