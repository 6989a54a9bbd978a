// Runs every script of tests/system/hostile in a lesson's process, with a canary file and a canary socket in reach, and prints a
// table. A script says in its head how it must end:
//   fine    it runs and is let off: what it tried came to nothing
//   error   one sentence with file and line
//   long    ended because it took too long
//   memory  ended because it took too much memory
//   any     any of these
// Never: the canaries touched, this program harmed, a process left over, the lesson's process crashed.
#include "haptics/base/clock.h"
#include "runtime/lua/process/lesson_process.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <netinet/in.h>
#include <regex>
#include <string>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

using namespace fulcrum;
using namespace fulcrum::runtime;
namespace fs = std::filesystem;

constexpr const char* kCanary = "alive";
constexpr int kFrames = 3;

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

/// A file that must keep its word, and a socket on loopback that nobody must call.
struct Canaries {
    fs::path file;
    int socket = -1;
    int port = 0;

    explicit Canaries(const fs::path& folder) : file(folder / "canary") {
        std::ofstream(file) << kCanary;
        socket = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof(address);
        if (socket < 0 || bind(socket, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
            listen(socket, 4) != 0 ||
            getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
            std::perror("canary socket");
            std::exit(2);
        }
        port = ntohs(address.sin_port);
    }
    [[nodiscard]] bool touched() const {
        const int caller = accept(socket, nullptr, nullptr);
        if (caller >= 0) {
            close(caller);
        }
        return caller >= 0 || read_text(file) != kCanary;
    }
};

LessonFrame make_frame(const LessonDescription& description, int i) {
    LessonFrame frame;
    frame.time_s = i / 60.0;
    frame.dt_s = 1.0 / 60.0;
    frame.tool_pose_W.position = Vector3(1e-5, 0.2, 0.0);
    frame.bodies.resize(description.bodies.size());
    for (const QuestionDescription& question : description.questions) {
        frame.events.emplace_back(JudgeEvent{question.id, {}});
    }
    return frame;
}

/// The sentence that the script ended with; empty when it ran to the end.
std::string play(const LessonFiles& files, const LessonProcessOptions& options,
                 bool& printed_control) {
    auto process = LessonProcess::start(files, options);
    if (!process) {
        return to_sentence(process.error());
    }
    for (int i = 0; i < kFrames; ++i) {
        const auto reply = (*process)->exchange(make_frame((*process)->description(), i));
        if (!reply) {
            return to_sentence(reply.error());
        }
        for (const LessonCommand& command : reply->commands) {
            const auto* print = std::get_if<PrintCommand>(&command);
            printed_control = printed_control ||
                              (print != nullptr && print->text.find('\x1B') != std::string::npos);
        }
    }
    return {};
}

/// What is wrong with how it ended; empty when nothing is.
std::string judge(const std::string& wanted, const std::string& sentence) {
    static const std::regex kPlaced("^[a-z_/]+\\.lua:[0-9]+: [^\n]+[.?]$");
    const bool is_long = sentence.find("ran for too long") != std::string::npos ||
                         sentence.find("did not answer") != std::string::npos;
    const bool is_memory = sentence.find("memory") != std::string::npos;
    if (sentence.find("crashed") != std::string::npos ||
        sentence.find("not allowed") != std::string::npos ||
        sentence.find("nonsense") != std::string::npos ||
        sentence.find("ended without") != std::string::npos) {
        return "its process broke";
    }
    if (!sentence.empty() && !std::regex_match(sentence, kPlaced)) {
        return "no sentence with file and line";
    }
    const bool as_wanted = wanted == "any" || (wanted == "fine" && sentence.empty()) ||
                           (wanted == "error" && !sentence.empty() && !is_long) ||
                           (wanted == "long" && is_long) ||
                           (wanted == "memory" && (is_memory || is_long));
    return as_wanted ? "" : "should end: " + wanted;
}

struct Run {
    fs::path scripts;
    fs::path folder;
    LessonFiles files{};
    LessonProcessOptions options{};
    int n_bad = 0;

    void run_one(const fs::path& script, const Canaries& canaries) {
        const std::string text = read_text(script);
        std::smatch found;
        const bool has_head =
            std::regex_search(text, found, std::regex("-- Ends: (fine|error|long|memory|any)\n"));
        const std::string wanted = has_head ? found[1].str() : "?";
        std::ofstream(folder / "lesson.lua")
            << replace_all(replace_all(text, "@CANARY@", canaries.file.string()), "@PORT@",
                           std::to_string(canaries.port));
        bool printed_control = false;
        const double begun_s = monotonic_now_s();
        const std::string sentence = play(files, options, printed_control);
        const double took_s = monotonic_now_s() - begun_s;
        std::string problem = judge(wanted, sentence);
        problem = canaries.touched() ? "ESCAPED: a canary was touched"
                  : printed_control  ? "printed control characters"
                                     : problem;
        problem = waitpid(-1, nullptr, WNOHANG) != -1 ? "left a process over" : problem;
        n_bad += problem.empty() ? 0 : 1;
        std::printf("%-4s %-26s %-6s %6.0f ms  %s%s\n", problem.empty() ? "ok" : "BAD",
                    script.stem().c_str(), wanted.c_str(), took_s * 1000.0,
                    problem.empty() ? "" : (problem + " <- ").c_str(),
                    sentence.empty() ? "(ran)" : sentence.c_str());
        std::fflush(stdout);
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (const auto socket = lesson_process_socket(argc, argv)) {
        return lesson_process_main(*socket);
    }
    if (argc < 3) {
        std::fputs("usage: lua_hostile SCRIPTS_FOLDER LIBRARY_FOLDER [NAME]\n", stderr);
        return 2;
    }
    std::string pattern = (fs::temp_directory_path() / "fulcrum-hostile-XXXXXX").string();
    Run run;
    run.scripts = argv[1];
    run.folder = mkdtemp(pattern.data());
    run.files.folder = run.folder;
    run.files.library = argv[2];
    const Canaries canaries(run.folder);
    std::vector<fs::path> scripts;
    for (const auto& entry : fs::directory_iterator(run.scripts)) {
        const bool chosen = argc < 4 || entry.path().stem() == argv[3];
        if (entry.path().extension() == ".lua" && chosen) {
            scripts.push_back(entry.path());
        }
    }
    std::sort(scripts.begin(), scripts.end());
    for (const fs::path& script : scripts) {
        run.run_one(script, canaries);
    }
    fs::remove_all(run.folder);
    std::printf("%zu scripts, %d bad\n", scripts.size(), run.n_bad);
    return run.n_bad == 0 && !scripts.empty() ? 0 : 1;
}
