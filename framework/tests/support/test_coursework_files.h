// Coursework for tests: small files of its own, so that tests depend neither on what a student
// has written nor on the solutions.
#pragma once

#include "host/worker_process.h"
#include "scene/flat_scene.h"

#include <filesystem>
#include <string>

namespace pathmark::test {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

// A folder with all coursework files. Every function returns something harmless; renderPixel
// returns the mean over its rays of tracePath, which returns numbers of the sampler.
class TestCoursework {
 public:
  TestCoursework();

  // Replaces the body of LitScene::tracePath(const Ray& ray, Sampler& sampler).
  void setTracePath(const std::string& body);
  // Replaces a whole file; `code` stands between the includes and the end of the namespace.
  void setFile(const std::string& name, const std::string& code);
  void write(const std::string& name, const std::string& text);

  const std::filesystem::path& folder() const { return folder_.path(); }

  // Compiles, links and starts. Fails the test if that is not possible.
  std::unique_ptr<WorkerProcess> start(WorkerLimits limits = {});

 private:
  TemporaryFolder folder_;
};

// A camera in an empty scene, with one material.
FlatScene emptyScene(int width, int height);

}  // namespace pathmark::test
