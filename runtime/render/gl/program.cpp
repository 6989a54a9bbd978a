#include "runtime/render/gl/program.h"

#include <array>
#include <vector>

namespace fulcrum::runtime::gl {

namespace {

constexpr std::string_view kVersion = "#version 330 core\n";

/// The first line of a driver's log.
std::string first_line(const std::vector<char>& log) {
    const std::string text(log.data());
    return text.substr(0, text.find('\n'));
}

Expected<GLuint> compile(const std::string& name, GLenum stage, std::string_view prelude,
                         std::string_view source) {
    const GLuint shader = glCreateShader(stage);
    const std::array<const GLchar*, 3> parts{kVersion.data(), prelude.data(), source.data()};
    const std::array<GLint, 3> lengths{static_cast<GLint>(kVersion.size()),
                                       static_cast<GLint>(prelude.size()),
                                       static_cast<GLint>(source.size())};
    glShaderSource(shader, 3, parts.data(), lengths.data());
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE) {
        return shader;
    }
    std::vector<char> log(1024, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size() - 1), nullptr, log.data());
    glDeleteShader(shader);
    return fail("the shader " + name + " did not compile (" + first_line(log) + ")", {},
                "update the graphics driver");
}

}  // namespace

Expected<Program> Program::build(const std::string& name, std::string_view prelude,
                                 std::string_view vertex, std::string_view fragment) {
    const auto vertex_shader = compile(name, GL_VERTEX_SHADER, prelude, vertex);
    if (!vertex_shader) {
        return tl::make_unexpected(vertex_shader.error());
    }
    const auto fragment_shader = compile(name, GL_FRAGMENT_SHADER, prelude, fragment);
    if (!fragment_shader) {
        glDeleteShader(*vertex_shader);
        return tl::make_unexpected(fragment_shader.error());
    }
    Program program;
    program.handle_ = Handle<ProgramKind>::make();
    const GLuint id = program.handle_.name();
    glAttachShader(id, *vertex_shader);
    glAttachShader(id, *fragment_shader);
    glLinkProgram(id);
    glDeleteShader(*vertex_shader);
    glDeleteShader(*fragment_shader);
    GLint done = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &done);
    if (done != GL_TRUE) {
        std::vector<char> log(1024, '\0');
        glGetProgramInfoLog(id, static_cast<GLsizei>(log.size() - 1), nullptr, log.data());
        return fail("the shader " + name + " did not link (" + first_line(log) + ")", {},
                    "update the graphics driver");
    }

    // Remember where every uniform lies.
    GLint count = 0;
    glGetProgramiv(id, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<GLchar, 128> uniform{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(id, static_cast<GLuint>(i), static_cast<GLsizei>(uniform.size()),
                           nullptr, &size, &type, uniform.data());
        program.locations_[uniform.data()] = glGetUniformLocation(id, uniform.data());
    }
    return program;
}

GLint Program::location(const char* name) const {
    const auto found = locations_.find(name);
    return found == locations_.end() ? -1 : found->second;
}

void Program::set(const char* name, int value) const {
    glUniform1i(location(name), value);
}
void Program::set(const char* name, float value) const {
    glUniform1f(location(name), value);
}
void Program::set(const char* name, const Vector2f& value) const {
    glUniform2fv(location(name), 1, value.data());
}
void Program::set(const char* name, const Vector3f& value) const {
    glUniform3fv(location(name), 1, value.data());
}
void Program::set(const char* name, const Vector4f& value) const {
    glUniform4fv(location(name), 1, value.data());
}
void Program::set(const char* name, const Matrix3f& value) const {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, value.data());
}
void Program::set(const char* name, const Matrix4f& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
}

}  // namespace fulcrum::runtime::gl
