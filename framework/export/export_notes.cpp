#include "export/export_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pathmark {

namespace {

std::string shapeNumbers(const WorldScene& scene) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < scene.shapes.size(); ++k)
    if (scene.shapes[k].frontOnly != 0) numbers.push_back(k);
  return fmt::format("{} {}", numbers.size() == 1 ? "shape" : "shapes", fmt::join(numbers, ", "));
}

bool anyClamped(const WorldScene& scene) {
  for (const FlatMaterial& m : scene.materials)
    if (m.kind == FlatMaterialKind::kPhong && phongMixture(m).clamped) return true;
  return false;
}

}  // namespace

std::vector<std::string> exportNotes(const WorldScene& scene, ExportFormat format) {
  const bool pbrt = format == ExportFormat::kPbrt;
  const std::string_view name = pbrt ? "pbrt" : "Mitsuba 3";
  std::vector<std::string> notes;
  if (scene.isMoved())
    notes.push_back(fmt::format(
        "The scene is far from the origin for its size, where {} would round its corners to "
        "floats that are too far apart: the point ({}) of its file is the origin here, for the "
        "camera and all shapes alike. The picture is the same.",
        name, fmt::join(scene.origin, ", ")));
  if (scene.hasPhong())
    notes.push_back(fmt::format(
        "{} has no modified Phong material: each is a mixture of a diffuse material and a rough "
        "conductor with a {} lobe of about the same width. Highlights have another shape, and at "
        "grazing angles another brightness: images differ by more than noise.",
        name, pbrt ? "GGX" : "Beckmann"));
  if (anyClamped(scene))
    notes.emplace_back(
        "A Phong material reflects so much of different colours that no mixture of two materials "
        "has its reflectance: it is darker here.");
  if (scene.hasFrontOnly())
    notes.push_back(fmt::format(
        "{} has no surface that is there from its front only: {} {} also met from the back, where "
        "rays should pass. A camera behind such a wall sees the wall.",
        name, shapeNumbers(scene), shapeNumbers(scene).find("shapes") == 0 ? "are" : "is"));
  if (pbrt) {
    notes.emplace_back(
        "pbrt's surfaces reflect on both sides, and here the backs are black: images differ where "
        "a back is seen or lit.");
    notes.emplace_back(
        "pbrt renders spectra: colours are turned into smooth spectra and back, which changes "
        "light that is reflected several times by a few per cent.");
  }
  return notes;
}

}  // namespace pathmark
