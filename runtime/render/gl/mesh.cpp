#include "runtime/render/gl/mesh.h"

#include "runtime/render/gl/simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace fulcrum::runtime::gl {

namespace {

constexpr std::size_t kFloatsPerCorner = 8;  // position, normal, uv
constexpr std::size_t kMostMeshCorners = 50'000'000;
constexpr int kLargestPicture = 8192;
// A cell of levels 1, 2 and 3 for a model of length 1: about ten pixels.
constexpr std::array<float, kLevelPixels.size()> kLevelCells{1.0F / 26.0F, 1.0F / 17.0F,
                                                             1.0F / 9.0F};
constexpr std::size_t kFewIndices = std::size_t{3} * 600;  // so few triangles are not made fewer

bool all_finite(const std::vector<float>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); });
}

Expected<void> check(const ModelPrimitive& primitive, std::size_t image_count,
                     const std::string& name) {
    const std::size_t corners = primitive.positions.size() / 3;
    const auto refuse = [&](const char* what) {
        return fail(std::string("the model's ") + what, name, "export the model again");
    };
    if (primitive.positions.empty() || primitive.positions.size() % 3 != 0 ||
        corners > kMostMeshCorners) {
        return refuse("positions are not three numbers a corner");
    }
    if (!primitive.normals.empty() && primitive.normals.size() != corners * 3) {
        return refuse("normals are not three numbers a corner");
    }
    if (!primitive.uvs.empty() && primitive.uvs.size() != corners * 2) {
        return refuse("picture coordinates are not two numbers a corner");
    }
    if (primitive.indices.empty() || primitive.indices.size() % 3 != 0 ||
        std::any_of(primitive.indices.begin(), primitive.indices.end(),
                    [&](std::uint32_t index) { return index >= corners; })) {
        return refuse("indices do not name three corners a triangle");
    }
    if (!all_finite(primitive.positions) || !all_finite(primitive.normals) ||
        !all_finite(primitive.uvs) || !std::isfinite(primitive.roughness)) {
        return refuse("numbers are not all finite");
    }
    if (primitive.image >= 0 && static_cast<std::size_t>(primitive.image) >= image_count) {
        return refuse("picture is not there");
    }
    return {};
}

Expected<void> check(const ModelImage& image, const std::string& name) {
    const bool sized = image.width > 0 && image.height > 0 && image.width <= kLargestPicture &&
                       image.height <= kLargestPicture;
    if (!sized || image.rgba.size() != 4 * static_cast<std::size_t>(image.width) *
                                           static_cast<std::size_t>(image.height)) {
        return fail("the model's picture has a wrong size", name, "export the model again");
    }
    return {};
}

/// Area-weighted normals for a primitive that has none.
std::vector<float> computed_normals(const ModelPrimitive& primitive) {
    std::vector<float> normals(primitive.positions.size(), 0.0F);
    const auto corner = [&](std::uint32_t i) {
        return Vector3f(primitive.positions.data() + 3 * static_cast<std::size_t>(i));
    };
    for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
        const auto a = primitive.indices[t];
        const auto b = primitive.indices[t + 1];
        const auto c = primitive.indices[t + 2];
        const Vector3f area = (corner(b) - corner(a)).cross(corner(c) - corner(a));
        for (const auto i : {a, b, c}) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                normals[3 * std::size_t{i} + axis] += area[static_cast<Index>(axis)];
            }
        }
    }
    for (std::size_t i = 0; i < normals.size(); i += 3) {
        const Vector3f sum(normals.data() + i);
        const float length = sum.norm();
        const Vector3f normal = length > 0.0F ? sum / length : Vector3f::UnitY();
        std::ranges::copy(normal, normals.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return normals;
}

std::vector<float> interleaved(const ModelPrimitive& primitive) {
    const std::size_t corners = primitive.positions.size() / 3;
    std::vector<float> vertices;
    vertices.reserve(corners * kFloatsPerCorner);
    for (std::size_t i = 0; i < corners; ++i) {
        vertices.insert(vertices.end(), primitive.positions.begin() + static_cast<long>(3 * i),
                        primitive.positions.begin() + static_cast<long>(3 * i + 3));
        vertices.insert(vertices.end(), primitive.normals.begin() + static_cast<long>(3 * i),
                        primitive.normals.begin() + static_cast<long>(3 * i + 3));
        vertices.push_back(primitive.uvs.empty() ? 0.0F : primitive.uvs[2 * i]);
        vertices.push_back(primitive.uvs.empty() ? 0.0F : primitive.uvs[2 * i + 1]);
    }
    return vertices;
}

MeshPart upload_part(const ModelPrimitive& primitive) {
    MeshPart part;
    part.vertex_array = VertexArray::make();
    part.vertices = Buffer::make();
    part.indices = Buffer::make();
    part.index_count = static_cast<GLsizei>(primitive.indices.size());
    part.base_colour = primitive.base_colour;
    part.roughness = std::clamp(primitive.roughness, 0.05F, 1.0F);
    part.texture = primitive.image;

    const std::vector<float> vertices = interleaved(primitive);
    glBindVertexArray(part.vertex_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, part.vertices.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)),
                 vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.indices.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(primitive.indices.size() * sizeof(std::uint32_t)),
                 primitive.indices.data(), GL_STATIC_DRAW);
    constexpr GLsizei kStride = kFloatsPerCorner * sizeof(float);
    const std::array<GLint, 3> sizes{3, 3, 2};
    std::size_t offset = 0;
    for (GLuint i = 0; i < sizes.size(); ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, kStride,
                              reinterpret_cast<const void*>(offset));
        offset += static_cast<std::size_t>(sizes[i]) * sizeof(float);
    }
    glBindVertexArray(0);
    return part;
}

/// A part in all its forms.
void add_part(Mesh& mesh, const ModelPrimitive& primitive) {
    const bool closed = is_closed(primitive);
    const bool few = primitive.indices.size() <= kFewIndices;
    const float length_m = std::max((mesh.highest - mesh.lowest).maxCoeff(), 1e-9F);
    for (std::size_t level = 0; level < mesh.levels.size(); ++level) {
        ModelPrimitive coarse;
        if (level > 0 && !few) {
            coarse = simplified(primitive, kLevelCells[level - 1] * length_m);
        }
        mesh.levels[level].push_back(upload_part(coarse.indices.empty() ? primitive : coarse));
        mesh.levels[level].back().closed = closed;
    }
}

Texture upload_picture(const ModelImage& image) {
    Texture texture = Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, image.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

}  // namespace

Expected<Mesh> upload(const LoadedModel& model) {
    // Everything is checked before anything is made.
    if (model.primitives.empty()) {
        return fail("the model holds no triangles", model.name, "export the model again");
    }
    for (const ModelPrimitive& primitive : model.primitives) {
        if (auto fine = check(primitive, model.images.size(), model.name); !fine) {
            return tl::make_unexpected(fine.error());
        }
    }
    for (const ModelImage& image : model.images) {
        if (auto fine = check(image, model.name); !fine) {
            return tl::make_unexpected(fine.error());
        }
    }

    Mesh mesh;
    mesh.lowest.setConstant(std::numeric_limits<float>::max());
    mesh.highest.setConstant(std::numeric_limits<float>::lowest());
    for (const ModelPrimitive& primitive : model.primitives) {
        for (std::size_t i = 0; i + 2 < primitive.positions.size(); i += 3) {
            const Vector3f corner(primitive.positions.data() + i);
            mesh.lowest = mesh.lowest.cwiseMin(corner);
            mesh.highest = mesh.highest.cwiseMax(corner);
        }
    }
    for (const ModelPrimitive& given : model.primitives) {
        ModelPrimitive primitive = given;
        if (primitive.normals.empty()) {
            primitive.normals = computed_normals(primitive);
        }
        add_part(mesh, primitive);
    }
    for (const ModelImage& image : model.images) {
        mesh.textures.push_back(upload_picture(image));
    }
    return mesh;
}

void draw(const MeshPart& part) {
    if (part.closed) {
        glEnable(GL_CULL_FACE);
    }
    glBindVertexArray(part.vertex_array.name());
    glDrawElements(GL_TRIANGLES, part.index_count, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_CULL_FACE);
}

std::size_t level_for(double length_px) {
    const auto fitting = std::count_if(kLevelPixels.begin(), kLevelPixels.end(),
                                       [&](double most_px) { return length_px <= most_px; });
    return static_cast<std::size_t>(fitting);
}

}  // namespace fulcrum::runtime::gl
