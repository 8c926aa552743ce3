// CoarseBlob: a folder with the mesh of the scene blob in fewer triangles, gone afterwards.
#pragma once

#include <filesystem>

namespace pathmark::bench {

class CoarseBlob {
 public:
  explicit CoarseBlob(int subdivisions);
  ~CoarseBlob();
  CoarseBlob(const CoarseBlob&) = delete;
  CoarseBlob& operator=(const CoarseBlob&) = delete;

  // Where the scene's text finds the mesh.
  std::filesystem::path sceneFile() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace pathmark::bench
