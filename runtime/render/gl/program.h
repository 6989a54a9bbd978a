// A linked vertex and fragment shader, and its uniforms by name.
//
// Thread: the one that holds the context. Cost: a hash look-up a uniform.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/matrix.h"
#include "runtime/render/gl/handle.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace fulcrum::runtime::gl {

/// A shader program.
class Program {
  public:
    Program() = default;
    /// Compiles and links GLSL 3.30 sources without their #version line; `name` is for errors,
    /// `prelude` (such as #defines) stands before both sources.
    [[nodiscard]] static Expected<Program> build(const std::string& name, std::string_view prelude,
                                                 std::string_view vertex,
                                                 std::string_view fragment);

    /// Makes it the current program.
    void use() const { glUseProgram(handle_.name()); }

    /// The program must be current. A name that the program does not use is left alone.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const Vector2f& value) const;
    void set(const char* name, const Vector3f& value) const;
    void set(const char* name, const Vector4f& value) const;
    void set(const char* name, const Matrix3f& value) const;
    void set(const char* name, const Matrix4f& value) const;

  private:
    [[nodiscard]] GLint location(const char* name) const;

    Handle<ProgramKind> handle_;
    std::unordered_map<std::string, GLint> locations_;
};

}  // namespace fulcrum::runtime::gl
