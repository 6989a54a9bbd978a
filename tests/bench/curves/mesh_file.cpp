#include "tests/bench/curves/mesh_file.h"

#include "runtime/scene/gltf/collision_from_model.h"
#include "runtime/scene/gltf/gltf_model.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace fulcrum::bench {
namespace {

// The corner's number in "7", "7/1" or "7//3"; -1 where that is none of the vertices there are.
std::int32_t read_corner(const std::string& word, std::size_t n_vertices) {
    std::istringstream text(word);
    std::int64_t number = 0;
    text >> number;
    const auto n = static_cast<std::int64_t>(n_vertices);
    const std::int64_t index = number < 0 ? n + number : number - 1;
    return !text.fail() && index >= 0 && index < n ? static_cast<std::int32_t>(index) : -1;
}

}  // namespace

Expected<TriangleMesh> read_obj(const std::string& text, const std::string& where) {
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        const std::string here = where + ":" + std::to_string(number);
        if (kind == "v") {
            Vector3 v = Vector3::Zero();
            if (!(words >> v.x() >> v.y() >> v.z())) {
                return fail("a vertex has not three coordinates", here, "export the model again");
            }
            vertices.push_back(v);
        } else if (kind == "f") {
            std::vector<std::int32_t> face;
            for (std::string word; words >> word;) {
                face.push_back(read_corner(word, vertices.size()));
            }
            if (face.size() < 3 || std::count(face.begin(), face.end(), -1) > 0) {
                return fail("a face names a vertex that is not there, or too few", here,
                            "export the model again");
            }
            for (std::size_t i = 1; i + 1 < face.size(); ++i) {
                triangles.push_back({face[0], face[i], face[i + 1]});
            }
        }
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), {}, where);
}

TriangleMesh make_scaled(const TriangleMesh& mesh, double scale) {
    const Vector3 middle = 0.5 * (mesh.lower_B() + mesh.upper_B());
    return make_changed(mesh, [&](const Vector3& v) -> Vector3 { return scale * (v - middle); });
}

Expected<TriangleMesh> load_mesh_file(const std::string& file) {
    const std::string ending = std::filesystem::path(file).extension();
    if (ending == ".glb" || ending == ".gltf") {
        return runtime::load_gltf(file).and_then([&](const runtime::LoadedModel& model) {
            return runtime::collision_from_model(model, file);
        });
    }
    if (ending != ".obj") {
        return fail("this is no OBJ, GLB or glTF file", file,
                    "name one that ends in .obj, .glb or .gltf");
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
        return fail("the file cannot be read", file, "check its name");
    }
    return read_obj(text, file);
}

}  // namespace fulcrum::bench
