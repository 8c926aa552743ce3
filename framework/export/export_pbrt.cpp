#include "export/export_scene.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pathmark {

namespace {

// More are read faster from a file of their own.
constexpr std::size_t kMostInline = 100;

class PbrtText {
 public:
  template <class... Args>
  void line(fmt::format_string<Args...> pattern, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), pattern, std::forward<Args>(args)...);
    text_.push_back('\n');
  }
  std::string take() const { return fmt::to_string(text_); }

 private:
  fmt::memory_buffer text_;
};

// In the shortest form that is the same float: that is what pbrt keeps. A sum of 0 avoids "-0".
std::string triple(const Float3& v) {
  return fmt::format("{} {} {}", v[0] + 0.0f, v[1] + 0.0f, v[2] + 0.0f);
}
std::string triple(const glm::dvec3& v) {
  return triple(Float3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

// A comment ends with its line.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

// pbrt's field of view is that of the shorter side.
double shorterFieldOfView(const WorldCamera& camera) {
  if (camera.width >= camera.height) return camera.fieldOfView;
  const double half = 0.5 * camera.fieldOfView * glm::pi<double>() / 180.0;
  return 2.0 * std::atan(std::tan(half) * camera.width / camera.height) * 180.0 / glm::pi<double>();
}

// LookAt makes left-handed coordinates, in which a scene of ours would be mirrored.
void writeHead(PbrtText& out, const WorldScene& scene, const ExportRequest& request) {
  const WorldCamera& c = scene.camera;
  out.line("Scale -1 1 1");
  out.line("LookAt {}  {}  {}", triple(c.eye), triple(c.target), triple(c.up));
  out.line("Camera \"perspective\" \"float fov\" [ {} ]",
           static_cast<float>(shorterFieldOfView(c)));
  out.line("Film \"rgb\" \"integer xresolution\" [ {} ] \"integer yresolution\" [ {} ]", c.width,
           c.height);
  out.line("  \"string filename\" \"{}.exr\" \"bool savefp16\" false", request.stem);
  out.line("PixelFilter \"box\" \"float xradius\" [ 0.5 ] \"float yradius\" [ 0.5 ]");
  out.line("Sampler \"zsobol\" \"integer pixelsamples\" [ {} ]", request.raysPerPixel);
  out.line("# At most {0} scattering events on a path.", scene.maxBounces);
  out.line("Integrator \"path\" \"integer maxdepth\" [ {} ]", scene.maxBounces);
  out.line("");
  out.line("WorldBegin");
  out.line("");
}

void writePhong(PbrtText& out, std::size_t number, const FlatMaterial& m) {
  const PhongMixture mixture = phongMixture(m);
  out.line("# Phong: Kd {}, Ks {}, exponent {}", triple(m.kd), triple(m.ks), m.exponent);
  out.line(
      "MakeNamedMaterial \"m{} diffuse\" \"string type\" \"diffuse\" \"rgb reflectance\" [ {} ]",
      number, triple(mixture.diffuse));
  out.line(
      "MakeNamedMaterial \"m{} specular\" \"string type\" \"conductor\" \"rgb reflectance\" [ {} ]",
      number, triple(mixture.specular));
  out.line("  \"float roughness\" [ {:.9g} ] \"bool remaproughness\" false",
           phongRoughness(static_cast<double>(m.exponent)));
  out.line("MakeNamedMaterial \"m{}\" \"string type\" \"mix\"", number);
  out.line(
      "  \"string materials\" [ \"m{0} diffuse\" \"m{0} specular\" ] \"float amount\" [ {1:.9g} ]",
      number, mixture.weight);
}

void writeMaterials(PbrtText& out, const WorldScene& scene) {
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    const FlatMaterial& m = scene.materials[k];
    if (m.kind == FlatMaterialKind::kPhong)
      writePhong(out, k, m);
    else
      out.line("MakeNamedMaterial \"m{}\" \"string type\" \"diffuse\" \"rgb reflectance\" [ {} ]",
               k, triple(m.kd));
  }
  out.line("");
}

void beginShape(PbrtText& out, const WorldScene& scene, std::uint32_t shape) {
  out.line("AttributeBegin  # shape {}", shape);
  out.line("  NamedMaterial \"m{}\"", scene.shapes[shape].material);
  // One-sided, the side of the normal.
  if (scene.emits(shape))
    out.line("  AreaLightSource \"diffuse\" \"rgb L\" [ {} ] \"bool twosided\" false",
             triple(scene.shapes[shape].emission));
}

std::string inlineMesh(const WorldMesh& mesh) {
  std::string points, indices;
  for (const glm::dvec3& v : mesh.vertices) points += fmt::format(" {}", triple(v));
  for (const auto& t : mesh.triangles) indices += fmt::format(" {} {} {}", t[0], t[1], t[2]);
  return fmt::format("  Shape \"trianglemesh\" \"point3 P\" [{} ]\n    \"integer indices\" [{} ]",
                     points, indices);
}

}  // namespace

std::vector<ExportedFile> exportPbrt(const WorldScene& scene, const ExportRequest& request) {
  std::vector<ExportedFile> files{{fmt::format("{}.pbrt", request.stem), {}}};
  PbrtText out;
  out.line("# {}, by pathmark export, for pbrt-v4: {}", scene.name, oneLine(request.command));
  if (!scene.caption.empty()) out.line("# {}", oneLine(scene.caption));
  for (const std::string& note : exportNotes(scene, ExportFormat::kPbrt))
    out.line("# Note: {}", note);
  out.line("");
  writeHead(out, scene, request);
  writeMaterials(out, scene);
  for (const WorldMesh& mesh : scene.meshes) {
    beginShape(out, scene, mesh.shape);
    if (mesh.triangles.size() <= kMostInline) {
      out.line("{}", inlineMesh(mesh));
    } else {
      const std::string ply = fmt::format("{}_meshes/shape_{}.ply", request.stem, mesh.shape);
      out.line("  Shape \"plymesh\" \"string filename\" \"{}\"", ply);
      files.push_back({ply, plyText(mesh)});
    }
    out.line("AttributeEnd");
  }
  for (const WorldSphere& sphere : scene.spheres) {
    beginShape(out, scene, sphere.shape);
    if (sphere.inward) out.line("  ReverseOrientation");
    out.line("  Translate {}", triple(sphere.centre));
    out.line("  Shape \"sphere\" \"float radius\" [ {:.9g} ]", sphere.radius);
    out.line("AttributeEnd");
  }
  files.front().content = out.take();
  return files;
}

}  // namespace pathmark
