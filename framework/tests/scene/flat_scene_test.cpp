#include "scene/flat_scene.h"

#include "scene_files.h"

#include <cstring>
#include <vector>

namespace pathmark {
namespace {

const std::filesystem::path kRoot = PATHMARK_ROOT;

FlatScene cornell() { return loadScene(kRoot / "scenes" / "cornell_box.json").flat; }

template <typename Array, typename Span>
bool sameBytes(const Array& array, const Span& span) {
  return array.size() == span.size() &&
         (array.empty() ||
          std::memcmp(array.data(), span.data(), array.size() * sizeof(array[0])) == 0);
}

void expectSame(const FlatScene& scene, const FlatSceneView& view) {
  EXPECT_EQ(std::memcmp(&scene.camera, &view.camera, sizeof(FlatCamera)), 0);
  EXPECT_EQ(scene.maxBounces, view.maxBounces);
  EXPECT_TRUE(sameBytes(scene.materials, view.materials));
  EXPECT_TRUE(sameBytes(scene.shapes, view.shapes));
  EXPECT_TRUE(sameBytes(scene.vertices, view.vertices));
  EXPECT_TRUE(sameBytes(scene.triangles, view.triangles));
  EXPECT_TRUE(sameBytes(scene.spheres, view.spheres));
  EXPECT_TRUE(sameBytes(scene.lights, view.lights));
  EXPECT_TRUE(sameBytes(scene.faces, view.faces));
  EXPECT_TRUE(sameBytes(scene.lightVertices, view.lightVertices));
  EXPECT_TRUE(sameBytes(scene.lightTriangles, view.lightTriangles));
}

TEST(FlatScene, ComesBackFromItsBlock) {
  for (const char* name : {"cornell_box", "cornell_spheres", "ucl_triangle", "furnace"}) {
    SCOPED_TRACE(name);
    const FlatScene scene = loadScene(kRoot / "scenes" / fmt::format("{}.json", name)).flat;
    const std::vector<std::byte> block = packScene(scene);
    const auto view = viewScene(block);
    ASSERT_TRUE(view);
    expectSame(scene, *view);
  }
}

TEST(FlatScene, IsTheSameBlockInPieces) {
  const FlatScene scene = loadScene(kRoot / "scenes" / "cornell_spheres.json").flat;
  const std::vector<std::byte> block = packScene(scene);
  std::size_t end = 0;
  packScene(scene, [&](std::span<const std::byte> piece) {
    ASSERT_LE(end + piece.size(), block.size());
    EXPECT_TRUE(std::equal(piece.begin(), piece.end(), block.data() + end));
    end += piece.size();
  });
  EXPECT_EQ(end, block.size());
}

TEST(FlatScene, MayBeEmpty) {
  const std::vector<std::byte> block = packScene({});
  const auto view = viewScene(block);
  ASSERT_TRUE(view);
  expectSame({}, *view);
}

TEST(FlatScene, IsReadInPlace) {
  const std::vector<std::byte> block = packScene(cornell());
  const auto view = viewScene(block);
  ASSERT_TRUE(view);
  const auto* triangles = reinterpret_cast<const std::byte*>(view->triangles.data());
  EXPECT_GT(triangles, block.data());
  EXPECT_LT(triangles, block.data() + block.size());
}

TEST(FlatScene, MayStandInALargerBlock) {
  // Shared memory comes in whole pages.
  const FlatScene scene = cornell();
  std::vector<std::byte> block = packScene(scene);
  block.resize(block.size() + 4096);
  const auto view = viewScene(block);
  ASSERT_TRUE(view);
  expectSame(scene, *view);
}

TEST(FlatScene, IsRefusedWhenTruncatedAnywhere) {
  const std::vector<std::byte> block = packScene(cornell());
  for (std::size_t size = 0; size < block.size(); ++size) {
    EXPECT_FALSE(viewScene(std::span(block).first(size))) << size;
  }
}

TEST(FlatScene, IsRefusedWhenNotAligned) {
  std::vector<std::byte> block = packScene(cornell());
  block.insert(block.begin(), 4, std::byte{0});
  EXPECT_FALSE(viewScene(std::span(block).subspan(4)));
}

TEST(FlatScene, IsRefusedWithAnotherMagicOrVersion) {
  const std::vector<std::byte> good = packScene(cornell());
  // Magic, total size, version and header size: the first 24 bytes.
  for (std::size_t i = 0; i < 24; ++i) {
    std::vector<std::byte> block = good;
    block[i] ^= std::byte{0x80};
    EXPECT_FALSE(viewScene(block)) << "byte " << i;
  }
}

TEST(FlatScene, IsNeverReadOutsideItsBlockWhenAnyByteIsWrong) {
  const FlatScene scene = cornell();
  const std::vector<std::byte> good = packScene(scene);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::vector<std::byte> block = good;
    block[i] = std::byte{0xff};
    const auto view = viewScene(block);
    if (!view) continue;
    const auto* end = reinterpret_cast<const std::byte*>(view->lightTriangles.data() +
                                                         view->lightTriangles.size());
    ASSERT_LE(end, block.data() + block.size());
    for (const FlatTriangle& t : view->triangles) {
      ASSERT_LT(t.shape, view->shapes.size());
      for (const std::uint32_t v : t.vertex) ASSERT_LT(v, view->vertices.size());
    }
    for (const FlatShape& s : view->shapes) ASSERT_LT(s.material, view->materials.size());
  }
}

TEST(FlatScene, IsRefusedWhenAnIndexPointsNowhere) {
  const auto refused = [](auto&& change) {
    FlatScene scene = cornell();
    change(scene);
    const std::vector<std::byte> block = packScene(scene);
    return !viewScene(block);
  };
  EXPECT_FALSE(refused([](FlatScene&) {}));
  EXPECT_TRUE(refused([](FlatScene& s) { s.shapes[0].material = 4; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.triangles[5].shape = 16; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.triangles[5].vertex[1] = 96; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.spheres.push_back({{}, 1.0f, 99, 0}); }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.lights[0].sphere = 0; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.lights[0].faceCount = 2; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.lights[0].firstFace = 0xffffffffu; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.faces[0].vertexCount = 5; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.faces[0].firstTriangle = 1; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.lightTriangles[1][2] = 4; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.materials[0].kind = FlatMaterialKind{7}; }));
  EXPECT_TRUE(refused([](FlatScene& s) { s.camera.width = 0; }));
}

}  // namespace
}  // namespace pathmark
