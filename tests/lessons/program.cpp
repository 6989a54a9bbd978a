#include "tests/lessons/program.h"

#include "haptics/record/record_reader.h"

#include <cstdio>
#include <cstdlib>
#include <sys/wait.h>

namespace fulcrum::test {

std::string program_path() {
    return FULCRUM_PROGRAM;
}

ProgramRun Sandbox::run(const std::string& arguments, const std::string& under) const {
    const std::string command =
        "cd '" + folder_.path().string() +
        "' && env -u DISPLAY -u WAYLAND_DISPLAY -u XDG_DATA_HOME -u XDG_CACHE_HOME HOME='" +
        folder_.path().string() + "' " + under + " '" FULCRUM_PROGRAM "' " + arguments +
        " 2>&1 </dev/null";
    ProgramRun run;
    std::FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> chunk{};
    for (std::size_t n = 0; (n = std::fread(chunk.data(), 1, chunk.size(), pipe)) > 0;) {
        run.output.append(chunk.data(), n);
    }
    const int status = pclose(pipe);
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return run;
}

std::string Sandbox::write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    folder_.write(name, text);
    return path(name);
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    INFO(path);
    REQUIRE(file);
    return {std::istreambuf_iterator<char>(file), {}};
}

Record read_run(const std::string& path) {
    auto record = load_record(path);
    INFO((record ? std::string("read") : to_sentence(record.error())));
    REQUIRE(record.has_value());
    return std::move(*record);
}

double time_of(const Record& record, RecordEventKind kind, int body, double from_s) {
    const auto found =
        std::find_if(record.events.begin(), record.events.end(), [&](const RecordEvent& event) {
            return event.kind == kind && event.body == body && event.time_s >= from_s;
        });
    return found == record.events.end() ? -1.0 : found->time_s;
}

double largest_force_N(const Record& record) {
    double largest_N = 0.0;
    for (const RecordSample& sample : record.samples) {
        largest_N = std::max(largest_N, sample.applied_W.force.norm());
    }
    return largest_N;
}

const RecordSample& sample_at(const Record& record, double time_s) {
    const auto found =
        std::find_if(record.samples.begin(), record.samples.end(),
                     [&](const RecordSample& sample) { return sample.time_s >= time_s; });
    REQUIRE(found != record.samples.end());
    return *found;
}

}  // namespace fulcrum::test
