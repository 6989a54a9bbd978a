// The files that a model may name, and the model file itself.
#include "runtime/scene/gltf/model_files.h"

#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <sys/stat.h>

using namespace fulcrum::runtime::test;

TEST_CASE("gltf refuses: a file above its size limit, before reading it") {
    check_says(refusal(read_gltf(Bytes((std::size_t{64} << 20) + 1), "test.glb")), {"64 MiB"});
    const Folder folder;
    write(folder.model(), "x");
    std::filesystem::resize_file(folder.model(), std::uintmax_t{1} << 40);  // sparse: takes no disk
    check_says(refusal(load_gltf(folder.model())), {"64 MiB"});
}

TEST_CASE("gltf refuses: a path that is missing, a folder, a pipe or a device") {
    const Folder folder;
    check_says(refusal(load_gltf(folder.model())), {"cannot be read"});
    check_says(refusal(load_gltf(folder.path)), {"is not a file"});
    REQUIRE(::mkfifo(folder.model().c_str(), 0600) == 0);
    check_says(refusal(load_gltf(folder.model())), {"is not a file"});
    CHECK_FALSE(load_gltf("/dev/zero").has_value());
}

TEST_CASE("gltf refuses: uris that leave the model's folder, whatever lies there") {
    const Folder folder;
    Gltf gltf;
    write(folder.path / "secret.bin", gltf.binary);
    const std::string absolute = (folder.path / "secret.bin").string();
    const std::string kUris[] = {".",
                                 "..",
                                 "",
                                 "../secret.bin",
                                 "./../secret.bin",
                                 "%2e%2e/secret.bin",
                                 "..%2fsecret.bin",
                                 "%2E%2E%2Fsecret.bin",
                                 absolute,
                                 "file://" + absolute,
                                 "..\\secret.bin",
                                 "C:secret.bin",
                                 "http://example.com/x.bin",
                                 "a/b.bin",
                                 std::string("x\0y", 3),
                                 "x%00y",
                                 std::string(300, 'x')};
    for (const std::string& uri : kUris) {
        CAPTURE(uri);
        Gltf by_buffer;
        by_buffer.at("/buffers/0/uri") = uri;
        write(folder.model(), by_buffer.document.dump());
        check_says(refusal(load_gltf(folder.model())), {"own folder"});
        Gltf by_image;
        by_image.document["images"] = json::array({{{"uri", uri}}});
        write(folder.model(), by_image.glb_text());
        check_says(refusal(load_gltf(folder.model())), {"own folder"});
    }
}

TEST_CASE("gltf refuses: a link, a pipe, a folder or nothing in place of a named file") {
    const Folder folder;
    Gltf gltf;
    gltf.at("/buffers/0/uri") = "points.bin";
    write(folder.model(), gltf.document.dump());
    write(folder.path / "secret.bin", gltf.binary);
    const auto points = folder.path / "models" / "points.bin";
    check_says(refusal(load_gltf(folder.model())), {"points.bin"});
    std::filesystem::create_symlink(folder.path / "secret.bin", points);
    check_says(refusal(load_gltf(folder.model())), {"is a link"});
    std::filesystem::remove(points);
    REQUIRE(::mkfifo(points.c_str(), 0600) == 0);
    check_says(refusal(load_gltf(folder.model())), {"is not a file"});
    std::filesystem::remove(points);
    std::filesystem::create_directory(points);
    check_says(refusal(load_gltf(folder.model())), {"is not a file"});
}

TEST_CASE("gltf: buffers and pictures may be plain files beside the model") {
    const Folder folder;
    Gltf gltf;
    gltf.add_picture(small_png());
    gltf.at("/images/0") = {{"uri", "my%20skin.png"}};
    gltf.at("/buffers/0/uri") = "points.bin";
    write(folder.model(), gltf.document.dump());
    write(folder.path / "models" / "points.bin", gltf.binary);
    write(folder.path / "models" / "my skin.png", text_of(small_png()));
    const auto model = load_gltf(folder.model());
    INFO((model ? "" : to_sentence(model.error())));
    REQUIRE(model.has_value());
    CHECK(model->name == "test");
    CHECK(model->images.at(0).rgba.size() == 16);
}

TEST_CASE("gltf: a file name is decoded before it is judged") {
    CHECK(gltf::plain_file_name("skin.png") == "skin.png");
    CHECK(gltf::plain_file_name("my%20skin%2Epng") == "my skin.png");
    CHECK(gltf::plain_file_name("50%.png") == "50%.png");
    CHECK(gltf::plain_file_name("...png") == "...png");
    for (const char* bad :
         {"", ".", "..", "%2e", "%2E%2e", "a/b", "a%2Fb", "a%5cb", "%00", "x%0A"}) {
        CAPTURE(bad);
        CHECK_FALSE(gltf::plain_file_name(bad).has_value());
    }
}

TEST_CASE("gltf: a model may itself be reached by a link") {
    const Folder folder;
    const Gltf gltf;
    write(folder.path / "real.glb", gltf.glb_text());
    std::filesystem::create_symlink(folder.path / "real.glb", folder.model());
    CHECK(load_gltf(folder.model()).has_value());
}
