#include "tests/support/table.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>

namespace fulcrum {
namespace {

std::string trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    return begin == std::string_view::npos
               ? ""
               : std::string(text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
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

/// One table, line by line.
class Table {
  public:
    Table(std::filesystem::path path, TableReader reader)
        : path_(std::move(path)), reader_(std::move(reader)) {}

    void hold() {
        std::ifstream file(path_);
        for (std::string line; std::getline(file, line);) {
            ++line_;
            if (line.empty() || line[0] == '#') {
                continue;
            }
            INFO(path_.filename().string() << ":" << line_ << ": " << law_ << ": " << line);
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
            law_ = rest;
            given_.clear();
            has_given_ = false;
            if (reader_.direct) {
                reader_.direct(word, rest);
            }
        } else if (word == "give") {
            given_ = table_field(rest);
            has_given_ = true;
        } else if (word == "each") {
            for (const std::string& in : parts_of(rest, " / ")) {
                INFO(in);
                row(in);
            }
        } else if (word == "try") {
            const std::size_t blank = std::min(rest.find(' '), rest.size());
            const auto found = reader_.probes.find(rest.substr(0, blank));
            REQUIRE(found != reader_.probes.end());
            probe_ = found->second;
            with_ = trimmed(rest.substr(blank));
        } else {
            REQUIRE(reader_.direct);
            reader_.direct(word, rest);
        }
    }

    void row(const std::string& line) {
        ++rows_;
        const std::string padded = line + " ";
        const std::size_t is = padded.find(" => ");
        const std::size_t like = padded.find(" =~ ");
        const std::size_t arrow = std::min(is, like);
        const std::string in = table_field(padded.substr(0, arrow));
        REQUIRE((arrow != std::string::npos || has_given_));
        const std::string out =
            arrow == std::string::npos ? given_ : table_field(padded.substr(arrow + 4));
        REQUIRE(probe_);
        const std::string came = probe_(with_, in);
        if (like < is) {
            INFO(came);
            CHECK(fits(came, out));
        } else {
            CHECK(came == out);
        }
    }

    std::filesystem::path path_;
    TableReader reader_;
    TableReader::Probe probe_{};
    std::string with_{};
    std::string law_{};
    std::string given_{};
    bool has_given_ = false;
    int line_ = 0;
    int rows_ = 0;
};

}  // namespace

std::string table_field(const std::string& written) {
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

std::vector<std::string> listed(const std::string& text, const std::string& between) {
    return text.empty() ? std::vector<std::string>{} : parts_of(text, between);
}

void hold_tables(const std::filesystem::path& folder,
                 const std::function<TableReader()>& make_reader) {
    std::vector<std::filesystem::path> tables;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().filename().string().ends_with("_table.txt")) {
            tables.push_back(entry.path());
        }
    }
    REQUIRE_FALSE(tables.empty());
    std::sort(tables.begin(), tables.end());
    for (const std::filesystem::path& table : tables) {
        DYNAMIC_SECTION(table.stem().string()) {
            Table(table, make_reader()).hold();
        }
    }
}

}  // namespace fulcrum
