#include "support/test_coursework_files.h"

#include "host/coursework_builder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace pathmark::test {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPart0 = R"(
bool ray_triangle_intersection(float&, const Ray&, const Triangle&) { return false; }
bool ray_mesh_intersection(float&, Triangle&, const Ray&, const Mesh&) { return false; }
vec2 get_random_numbers(uvec2& seed) { seed += 1u; return vec2(0.5f); }
vec3 sample_sphere(vec2) { return vec3(0, 0, 1); }
vec3 sample_hemisphere(vec2, vec3 n) { return n; }
vec3 compute_direct_illumination(vec3, const Triangle&, const Mesh&, uvec2&) { return vec3(0); }
vec3 get_ray_radiance(vec3, vec3, const Mesh&, uvec2&) { return vec3(0.75f); }
)";

constexpr const char* kPart1 = R"(
Ray SimpleCamera::StratifiedRandomRay(int i, int j, int, int, int, float s, float t) const {
  const vec2 onFilm = vec2(i, j) + vec2(s, t);
  return {eye(), normalize(topLeft() + onFilm.x * pixelRight() + onFilm.y * pixelDown())};
}
Colour LitScene::renderPixel(int i, int j, const SimpleCamera& camera, int n,
                             Sampler& sampler) const {
  Colour sum(0.0f);
  for (int m = 0; m < n; ++m) {
    sampler.startRay(m);
    const vec2 u = sampler.next2D();
    sum += tracePath(camera.StratifiedRandomRay(i, j, 0, 0, 1, u.x, u.y), sampler);
  }
  return sum / static_cast<float>(n);
}
)";

constexpr const char* kPart2 = R"(
LightSample Polygon::TriangularSampling(float, float) const { return {p(0), normal(), 1.0f}; }
LightSample Polygon::RectangularSampling(float, float) const { return {p(0), normal(), 1.0f}; }
LightSample Polygon::PolygonSampling(float, float) const { return {p(0), normal(), 1.0f}; }
LightSample Sphere::sample(const Point&, float, float) const {
  return {centre() + Vector(radius(), 0, 0), Vector(1, 0, 0), 1.0f};
}
float Sphere::pdf(const Point&, const Point&, const Vector&) const { return 1.0f; }
Colour LitScene::directLighting(const Hit&, const Vector&, Sampler&) const { return Colour(0); }
)";

constexpr const char* kPart3 = R"(
Colour lambertianBRDF::brdf(const Vector&, const Vector&, const Vector&) const { return Kd; }
float lambertianBRDF::pdf(const Vector&, const Vector&, const Vector&) const { return 1.0f; }
DirectionSample lambertianBRDF::reflection(const Vector&, const Vector& n, float, float,
                                           float) const {
  return {n, 1.0f};
}
)";

constexpr const char* kPart4 = R"(
Colour phongBRDF::brdf(const Vector&, const Vector&, const Vector&) const { return Kd; }
float phongBRDF::pdf(const Vector&, const Vector&, const Vector&) const { return 1.0f; }
DirectionSample phongBRDF::reflection(const Vector&, const Vector& n, float, float, float) const {
  return {n, 1.0f};
}
)";

constexpr const char* kPart6 = R"(
Roulette LitScene::RussianRoulette(const Colour&, int, float) const { return {true, 1.0f}; }
)";

constexpr const char* kPart8 = R"(
float powerHeuristic(float, float) { return 1.0f; }
float solidAnglePdf(const Point&, const LightSample&) { return 1.0f; }
Colour LitScene::tracePathMIS(const Ray&, Sampler&) const { return Colour(0.25f); }
)";

constexpr const char* kPart9 = R"(
LightSample Polygon::SphericalTriangleSampling(const Point&, float, float) const {
  return {p(0), normal(), 1.0f};
}
float Polygon::SphericalTrianglePdf(const Point&, const Point&) const { return 1.0f; }
LightSample Polygon::SphericalRectangleSampling(const Point&, float, float) const {
  return {p(0), normal(), 1.0f};
}
float Polygon::SphericalRectanglePdf(const Point&, const Point&) const { return 1.0f; }
)";

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "pathmark-test.XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

TestCoursework::TestCoursework() {
  setFile("part0_warmup.cpp", kPart0);
  setFile("part1_stratified.cpp", kPart1);
  setFile("part2_lights.cpp", kPart2);
  setFile("part3_lambertian.cpp", kPart3);
  setFile("part4_phong.cpp", kPart4);
  setTracePath("(void)ray; const vec2 u = sampler.next2D(); return {u.x, u.y, 1.0f};");
  setFile("part6_roulette.cpp", kPart6);
  setFile("part8_mis.cpp", kPart8);
  setFile("part9_solid_angle.cpp", kPart9);
}

void TestCoursework::write(const std::string& name, const std::string& text) {
  std::ofstream(folder() / name, std::ios::binary) << text;
}

void TestCoursework::setFile(const std::string& name, const std::string& code) {
  write(name, "#include <pathmark/coursework.h>\nnamespace pathmark {\n" + code + "\n}\n");
}

void TestCoursework::setTracePath(const std::string& body) {
  setFile("part5_path.cpp",
          "Colour LitScene::tracePath(const Ray& ray, Sampler& sampler) const {\n" + body + "\n}");
}

std::unique_ptr<WorkerProcess> TestCoursework::start(WorkerLimits limits) {
  const CourseworkBuild build = buildCoursework(folder());
  if (build.worker.empty()) throw std::runtime_error(build.failure());
  WorkerProcess::Options options;
  options.program = build.worker;
  options.courseworkFolder = folder();
  options.limits = limits;
  return std::make_unique<WorkerProcess>(std::move(options));
}

FlatScene emptyScene(int width, int height) {
  FlatScene scene;
  scene.camera.topLeft = {-1.0f, 1.0f, 1.0f};
  scene.camera.pixelRight = {2.0f / static_cast<float>(width), 0.0f, 0.0f};
  scene.camera.pixelDown = {0.0f, -2.0f / static_cast<float>(height), 0.0f};
  scene.camera.width = static_cast<std::uint32_t>(width);
  scene.camera.height = static_cast<std::uint32_t>(height);
  scene.materials.push_back({FlatMaterialKind::kLambertian, {0.5f, 0.5f, 0.5f}, {}, 0.0f});
  return scene;
}

}  // namespace pathmark::test
