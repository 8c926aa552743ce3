// What a picture shows of compensating mistakes, and what the checks find.
//
//   PairFinding   of one pair
//   PairStudy     makes its pictures, and runs the checks
#pragma once

#include "host/coursework_builder.h"
#include "marking/pictures.h"
#include "record/record.h"
#include "variants/pair.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pathmark::pairs {

// Tile biases and errors of means are those of marking/picture_statistics.h, with intervals of
// 99 %, against the solutions' picture of the scene.
struct PairFinding {
  record::Estimate bias;                       // with all of the mistakes
  std::array<record::Estimate, 3> meanErrors;  // of the picture's channels
  bool same = false;                           // the verdict of compareImages, with kSameAlpha
  std::vector<record::Estimate> alone;         // tile bias with each mistake by itself

  std::vector<std::string> failed;  // functions one of whose checks fails, with all the mistakes
  std::vector<int> partsAtFault;    // of those functions, or that cannot be checked
  double seconds = 0.0;             // of the checks
};

// "cornell_box (1 bounce)".
std::string sceneWords(const Pair& pair);

// The probability that a picture of correct coursework is said to differ from the solutions'.
inline constexpr double kSameAlpha = 1e-4;

// Of the pictures of a whole pair and of the solutions. With each mistake alone they take
// marking::kRaysPerPixel: what must show needs fewer.
// The warm-up, which meets lights by chance, takes kTimesForWarmUp as many.
inline constexpr std::uint64_t kRaysPerPixel = 2048, kTimesForWarmUp = 8;
inline constexpr std::uint32_t kReplicates = 32;

// The least relative bias that an eye may see. A pair hides if its picture is the same, and the
// interval of its bias lies below this; that of each mistake alone must lie above.
inline constexpr double kSeen = 0.02;
bool hides(const PairFinding& finding);

// Whether each mistake's function fails, and no part fails but theirs.
bool caught(const Pair& pair, const PairFinding& finding);

struct PairOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;           // 0: one for each processor
  std::filesystem::path scratch;  // where the patched files go

  // The parts of the mistakes alone: the others are the solutions' own.
  bool onlyPartsOfMistakes = false;
};

class PairStudy {
 public:
  explicit PairStudy(PairOptions options);

  // Throws WorkerError, and std::runtime_error if coursework does not build.
  PairFinding of(const Pair& pair);

 private:
  marking::Measured picture(const CourseworkBuild& build, const marking::MarkingScene& scene,
                            const std::string& name, const marking::Effort& effort);

  PairOptions options_;
  CourseworkBuild solutions_;
  std::map<std::string, marking::Measured> solved_;  // by the scene's name
};

}  // namespace pathmark::pairs
