#include "sample_class/sample_class.h"

#include "host/build_config.h"
#include "sample_class/pack.h"
#include "variants/variant.h"
#include "worker/contract.h"

#include <string>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

const fs::path kProjectFolder{build::kProjectFolder};

void copyInto(const fs::path& folder, const fs::path& file) {
  fs::copy_file(file, folder / file.filename(), fs::copy_options::overwrite_existing);
}

void fill(const fs::path& folder, const SampleSubmission& sample) {
  fs::create_directories(folder);
  if (sample.patch.empty()) {
    for (const PartContract& part : parts())
      copyInto(folder, kProjectFolder / "solutions" / part.file);
  } else {
    applyVariant(readVariant(kProjectFolder / "grader" / sample.patch), folder);
  }
  for (const PartContract& part : parts())
    if (part.part >= sample.partsWritten) copyInto(folder, kProjectFolder / "student" / part.file);
  if (sample.hasScene)
    fs::copy(kProjectFolder / "solutions/scenes", folder / "scenes", fs::copy_options::recursive);
}

}  // namespace

const std::vector<SampleSubmission>& sampleClass() {
  using enum SamplePacking;
  static const std::vector<SampleSubmission> all{
      {"complete", "", 7, true, kFolder},
      {"half-done", "", 4, false, kFolder},
      {"mistake-corner-favoured", "variants/wrong/part2_triangle_without_root.patch", 7, true,
       kFolder},
      {"mistake-cosine-twice", "variants/wrong/part3_cosine_in_brdf.patch", 7, true, kZip},
      {"mistake-light-counted-twice", "variants/wrong/part5_emission_at_every_hit.patch", 7, true,
       kTarGz},
      {"mistake-roulette-without-weight", "variants/wrong/part6_no_weight.patch", 7, true, kFolder},
      {"does-not-compile", "sample_class/does_not_compile.patch", 7, true, kFolder},
      {"crashes", "sample_class/crashes.patch", 7, false, kFolder},
      {"never-ends", "sample_class/never_ends.patch", 7, false, kFolder},
      {"cheats", "sample_class/cheats.patch", 7, false, kFolder},
  };
  return all;
}

void makeSampleClass(const fs::path& folder) {
  for (const SampleSubmission& sample : sampleClass()) {
    const fs::path target = folder / sample.name;
    fill(target, sample);
    if (sample.packing == SamplePacking::kFolder) continue;
    const bool zip = sample.packing == SamplePacking::kZip;
    packFolder(target, target.string() + (zip ? ".zip" : ".tar.gz"), zip);
    fs::remove_all(target);
  }
}

}  // namespace pathmark
