#include "host/blob_file.h"

#include "film/atomic_file.h"
#include "host/build_config.h"
#include "scene/blob_mesh.h"
#include "scene/encode_obj.h"

#include <system_error>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

const fs::path kScenes = fs::path(build::kProjectFolder) / "scenes";

}  // namespace

fs::path shippedBlobFile() { return kScenes / "meshes" / "blob.obj"; }

std::size_t writeBlobFile(const fs::path& file, int subdivisions) {
  const BlobMesh mesh = makeBlobMesh(subdivisions);
  writeFileAtomically(file, encodeObj(mesh));
  return mesh.triangles.size();
}

bool makeShippedBlobFile() {
  if (fs::exists(shippedBlobFile())) return false;
  fs::create_directories(shippedBlobFile().parent_path());
  writeBlobFile(shippedBlobFile(), kBlobSubdivisions);
  return true;
}

bool needsShippedBlobFile(const fs::path& scene) {
  std::error_code missing;
  return fs::equivalent(scene, kScenes / "blob.json", missing);
}

}  // namespace pathmark
