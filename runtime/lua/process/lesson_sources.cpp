#include "runtime/lua/process/lesson_sources.h"

#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/sandbox/safe_library.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <initializer_list>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr char kCompiledMark = '\x1B';

/// Closes the file when it goes.
struct OpenFile {
    int descriptor;
    ~OpenFile() {
        if (descriptor >= 0) {
            close(descriptor);
        }
    }
};

/// A module's name stands in a path: letters, digits and _ only.
bool is_module_name(std::string_view name) {
    return is_name(name) && name.find('-') == std::string_view::npos;
}

/// No more than a lesson may have; false where it can't be read: then `errno` says why.
bool read_all(const OpenFile& file, std::string& text) {
    text.assign(kMaxSourceBytes + 1, '\0');
    std::size_t filled = 0;
    while (filled < text.size()) {
        const ssize_t n = read(file.descriptor, text.data() + filled, text.size() - filled);
        if (n < 0 && errno != EINTR) {
            return false;
        }
        if (n == 0) {
            break;
        }
        filled += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
    text.resize(std::min(filled, kMaxSourceBytes));
    return true;
}

/// The modules of `folders`, by name.
std::vector<std::string> modules_in(std::initializer_list<std::filesystem::path> folders) {
    std::vector<std::string> names;
    for (const std::filesystem::path& folder : folders) {
        std::error_code error;
        for (auto entry = std::filesystem::directory_iterator(folder, error);
             !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
            if (entry->path().extension() == ".lua") {
                names.push_back(entry->path().stem().string());
            }
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// By its mark, or by the zeros that it has between letters.
bool is_utf16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
           (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0'));
}

/// A word processor's.
bool is_document(std::string_view text) {
    return text.starts_with("PK\x03\x04") || text.starts_with("{\\rtf") ||
           text.starts_with("\xD0\xCF\x11\xE0");
}

}  // namespace

Expected<LuaSource> read_lua_file(const std::filesystem::path& path, const std::string& shown_name,
                                  bool may_be_link) {
    // Not blocking, so that a pipe that has the name can't hold us.
    const OpenFile file{
        open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | (may_be_link ? 0 : O_NOFOLLOW))};
    if (file.descriptor < 0) {
        const char* why = errno == ELOOP ? "is a symbolic link" : std::strerror(errno);
        return fail(std::string("the file can't be read (") + why + ")", path.string(),
                    "check the name and the folder");
    }
    struct stat about {};
    if (fstat(file.descriptor, &about) != 0 || !S_ISREG(about.st_mode)) {
        return fail("this is no plain file", path.string(), "give a Lua file");
    }
    if (std::cmp_greater(about.st_size, kMaxSourceBytes)) {
        return fail("the file is longer than " + std::to_string(kMaxSourceBytes >> 10U) + " KB",
                    path.string(), "split it into modules");
    }
    LuaSource source{shown_name, {}};
    if (!read_all(file, source.text)) {
        return fail(std::string("the file can't be read (") + std::strerror(errno) + ")",
                    path.string());
    }
    if (source.text.starts_with(kByteOrderMark)) {
        source.text.erase(0, kByteOrderMark.size());
    }
    if (is_utf16(source.text)) {
        return fail("this is saved as UTF-16, not as UTF-8", shown_name,
                    "save it again with the encoding UTF-8, which every text editor offers");
    }
    if (is_document(source.text)) {
        return fail("this is a document of a word processor, not a plain text", shown_name,
                    "save it as plain text, with the encoding UTF-8");
    }
    if (source.text.starts_with(kCompiledMark)) {
        return fail("this is compiled Lua", path.string(), "give the text of the lesson");
    }
    return source;
}

Expected<LuaSource> LessonSources::read(const std::filesystem::path& path,
                                        const std::string& shown_name, bool may_be_link) {
    auto source = read_lua_file(path, shown_name, may_be_link);
    if (source) {
        files_read_.push_back(path);
        shown_names_.push_back(shown_name);
    }
    return source;
}

Expected<LuaSource> LessonSources::read_lesson() {
    return read(files_.folder / files_.lesson, files_.lesson, false);
}

Expected<LuaSource> LessonSources::read_hand(const std::filesystem::path& file) {
    if (file.empty()) {
        return LuaSource{};
    }
    return read(file, file.filename().string(), true);
}

ModuleAnswer LessonSources::find_module(const std::string& name) {
    ModuleAnswer answer;
    if (!is_module_name(name)) {
        answer.problem = "a module's name has only a to z, 0 to 9 and _";
        return answer;
    }
    if (files_read_.size() >= static_cast<std::size_t>(kMaxModules)) {
        answer.problem = "a lesson has at most " + std::to_string(kMaxModules) + " files";
        return answer;
    }
    const std::string file = name + ".lua";
    answer.problem = "there is no " + file + " beside the lesson nor in the library";
    struct Place {
        std::filesystem::path folder;
        std::string shown_prefix;
    };
    for (const Place& place : {Place{files_.library, "lib/"}, Place{files_.folder, ""}}) {
        struct stat about {};
        const std::filesystem::path path = place.folder / file;
        if (place.folder.empty() || lstat(path.c_str(), &about) != 0) {
            continue;
        }
        auto source = read(path, place.shown_prefix + file, false);
        answer.found = source.has_value();
        answer.problem = source ? "" : source.error().message;
        answer.source = source ? std::move(*source) : LuaSource{};
        return answer;
    }
    const std::string near = nearest_word(name, modules_in({files_.library, files_.folder}));
    answer.problem += near.empty() ? "" : "; did you mean \"" + near + "\"?";
    return answer;
}

std::string LessonSources::known_name(const std::string& shown_name) const {
    const bool known =
        std::find(shown_names_.begin(), shown_names_.end(), shown_name) != shown_names_.end();
    return known ? shown_name : files_.lesson;
}

}  // namespace fulcrum::runtime
