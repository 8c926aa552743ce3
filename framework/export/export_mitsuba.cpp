#include "export/export_scene.h"
#include "scene/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace pathmark {

namespace {

// XML 1.0, production 2.
bool isXmlCharacter(char32_t c) {
  return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c != 0xFFFE && c != 0xFFFF);
}

class XmlText {
 public:
  template <class... Args>
  void line(fmt::format_string<Args...> pattern, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), pattern, std::forward<Args>(args)...);
    text_.push_back('\n');
  }
  // A comment must not hold two hyphens in a row, nor end with one, nor hold what is no text.
  void comment(std::string_view text) {
    std::string safe;
    for (std::string_view rest = text; !rest.empty();) {
      const Utf8Character first = firstCharacter(rest);
      const std::string_view bytes = rest.substr(0, std::max<std::size_t>(first.bytes, 1));
      rest.remove_prefix(bytes.size());
      if (bytes == "-" && safe.ends_with('-')) safe += ' ';
      safe += first.bytes > 0 && isXmlCharacter(first.code) ? bytes : "?";
    }
    line("<!-- {} -->", safe);
  }
  std::string take() const { return fmt::to_string(text_); }

 private:
  fmt::memory_buffer text_;
};

// In the shortest form that is the same float. A sum of 0 avoids "-0".
std::string triple(const Float3& v) {
  return fmt::format("{}, {}, {}", v[0] + 0.0f, v[1] + 0.0f, v[2] + 0.0f);
}
std::string triple(const glm::dvec3& v) {
  return triple(Float3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

// The depths at which Mitsuba lets camera rays begin and end: 0.01 and 10000 if nothing is said.
// What lies nearer than 1e-9 of the farthest distance is lost in the rounding of its floats.
void writeClipping(XmlText& out, const WorldScene& scene) {
  const double farthest = 2.0 * farthestSurface(scene);
  constexpr double kNearest = 1e-9;
  out.line("  <float name=\"near_clip\" value=\"{:.9g}\"/>", kNearest * farthest);
  out.line("  <float name=\"far_clip\" value=\"{:.9g}\"/>", farthest);
}

void writeHead(XmlText& out, const WorldScene& scene, const ExportRequest& request) {
  const WorldCamera& c = scene.camera;
  out.comment(fmt::format("At most {} scattering events on a path: max_depth counts one more.",
                          scene.maxBounces));
  out.line("<integrator type=\"path\">");
  out.line("  <integer name=\"max_depth\" value=\"{}\"/>", scene.maxBounces + 1);
  out.line("</integrator>");
  out.line("<sensor type=\"perspective\">");
  out.line("  <float name=\"fov\" value=\"{}\"/>", static_cast<float>(c.fieldOfView));
  out.line("  <string name=\"fov_axis\" value=\"y\"/>");
  writeClipping(out, scene);
  out.line("  <transform name=\"to_world\">");
  out.line("    <lookat origin=\"{}\" target=\"{}\" up=\"{}\"/>", triple(c.eye), triple(c.target),
           triple(c.up));
  out.line("  </transform>");
  out.line("  <sampler type=\"multijitter\">");
  out.line("    <integer name=\"sample_count\" value=\"{}\"/>", request.raysPerPixel);
  out.line("  </sampler>");
  out.line("  <film type=\"hdrfilm\">");
  out.line("    <integer name=\"width\" value=\"{}\"/>", c.width);
  out.line("    <integer name=\"height\" value=\"{}\"/>", c.height);
  out.line("    <string name=\"file_format\" value=\"openexr\"/>");
  out.line("    <string name=\"pixel_format\" value=\"rgb\"/>");
  out.line("    <string name=\"component_format\" value=\"float32\"/>");
  out.line("    <rfilter type=\"box\"/>");
  out.line("  </film>");
  out.line("</sensor>");
}

void writePhong(XmlText& out, std::size_t number, const FlatMaterial& m) {
  const PhongMixture mixture = phongMixture(m);
  out.comment(
      fmt::format("Phong: Kd {}, Ks {}, exponent {:.9g}", triple(m.kd), triple(m.ks), m.exponent));
  out.line("<bsdf type=\"blendbsdf\" id=\"m{}\">", number);
  out.line("  <float name=\"weight\" value=\"{:.9g}\"/>", mixture.weight);
  out.line("  <bsdf type=\"diffuse\">");
  out.line("    <rgb name=\"reflectance\" value=\"{}\"/>", triple(mixture.diffuse));
  out.line("  </bsdf>");
  out.line("  <bsdf type=\"roughconductor\">");
  out.line("    <string name=\"material\" value=\"none\"/>");
  out.line("    <string name=\"distribution\" value=\"beckmann\"/>");
  out.line("    <float name=\"alpha\" value=\"{:.9g}\"/>",
           phongRoughness(static_cast<double>(m.exponent)));
  out.line("    <rgb name=\"specular_reflectance\" value=\"{}\"/>", triple(mixture.specular));
  out.line("  </bsdf>");
  out.line("</bsdf>");
}

// One-sided, as ours are: the back is black.
void writeMaterials(XmlText& out, const WorldScene& scene) {
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    const FlatMaterial& m = scene.materials[k];
    if (m.kind == FlatMaterialKind::kPhong) {
      writePhong(out, k, m);
      continue;
    }
    out.line("<bsdf type=\"diffuse\" id=\"m{}\">", k);
    out.line("  <rgb name=\"reflectance\" value=\"{}\"/>", triple(m.kd));
    out.line("</bsdf>");
  }
}

// Emission leaves the side of the normal.
void endShape(XmlText& out, const WorldScene& scene, std::uint32_t shape) {
  out.line("  <ref id=\"m{}\"/>", scene.shapes[shape].material);
  if (scene.emits(shape)) {
    out.line("  <emitter type=\"area\">");
    out.line("    <rgb name=\"radiance\" value=\"{}\"/>", triple(scene.shapes[shape].emission));
    out.line("  </emitter>");
  }
  out.line("</shape>");
}

}  // namespace

std::vector<ExportedFile> exportMitsuba(const WorldScene& scene, const ExportRequest& request) {
  std::vector<ExportedFile> files{{fmt::format("{}.xml", request.stem), {}}};
  XmlText out;
  out.line("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
  out.comment(
      fmt::format("{}, by pathmark export, for Mitsuba 3: {}", scene.name, request.command));
  if (!scene.caption.empty()) out.comment(scene.caption);
  for (const std::string& note : exportNotes(scene, ExportFormat::kMitsuba))
    out.comment(fmt::format("Note: {}", note));
  out.line("<scene version=\"3.0.0\">");
  writeHead(out, scene, request);
  writeMaterials(out, scene);
  for (const WorldMesh& mesh : scene.meshes) {
    const std::string ply = fmt::format("{}_meshes/shape_{}.ply", request.stem, mesh.shape);
    files.push_back({ply, plyText(mesh)});
    out.line("<shape type=\"ply\" id=\"shape {}\">", mesh.shape);
    out.line("  <string name=\"filename\" value=\"{}\"/>", ply);
    out.line("  <boolean name=\"face_normals\" value=\"true\"/>");
    endShape(out, scene, mesh.shape);
  }
  for (const WorldSphere& sphere : scene.spheres) {
    const glm::dvec3& c = sphere.centre;
    out.line("<shape type=\"sphere\" id=\"shape {}\">", sphere.shape);
    out.line("  <point name=\"center\" x=\"{:.9g}\" y=\"{:.9g}\" z=\"{:.9g}\"/>", c.x, c.y, c.z);
    out.line("  <float name=\"radius\" value=\"{:.9g}\"/>", sphere.radius);
    if (sphere.inward) out.line("  <boolean name=\"flip_normals\" value=\"true\"/>");
    endShape(out, scene, sphere.shape);
  }
  out.line("</scene>");
  files.front().content = out.take();
  return files;
}

}  // namespace pathmark
