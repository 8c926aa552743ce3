#include "bench/stress/coarse_blob.h"

#include "host/blob_file.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace pathmark::bench {

namespace fs = std::filesystem;

CoarseBlob::CoarseBlob(int subdivisions) {
  std::string folder = (fs::temp_directory_path() / "pathmark-blob.XXXXXX").string();
  if (!mkdtemp(folder.data()))
    throw std::system_error(errno, std::generic_category(), "making a folder");
  folder_ = folder;
  fs::create_directories(folder_ / "meshes");
  writeBlobFile(folder_ / "meshes" / shippedBlobFile().filename(), subdivisions);
}

CoarseBlob::~CoarseBlob() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path CoarseBlob::sceneFile() const { return folder_ / "blob.json"; }

}  // namespace pathmark::bench
