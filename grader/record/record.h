// The record of one submission: everything that was found, and nothing of what it is worth.
//
//   Verdict             what became of a check, a function, a part
//   CheckRecord         one statement, and what was found
//   FunctionRecord      its checks
//   PartRecord          its functions, and what its mistakes do to pictures
//   PictureRecord       one picture beside its reference
//   MistakePicture      what a known mistake does to the same scene
//   SampleRecord        what a sampling function returned
//   SubmissionRecord    all of it
//
// Marks follow from a record and a rubric, reports from a record and its marks: both can be made
// again at any time without running anything.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::record {

enum class Verdict {
  kOk,
  kUndecided,  // nothing wrong was found, but not all of it could be shown
  kBlocked,    // by another function or part, which must be right first
  kNotWritten,
  kWrong,
  kDoesNotCompile,
  kCrashed,
  kTimeLimit,
  kMemoryLimit,
  kOutputLimit,
  kForbiddenCall,
  kInternalError,  // of the grader or the machine
};

// "ok", "not written", "does not compile", "time limit", ...
std::string_view nameOf(Verdict verdict);

// Nothing for a word that is no verdict.
std::optional<Verdict> verdictNamed(std::string_view name);

// How bad a verdict is, for the worst of several: in the order of the list above.
bool worseThan(Verdict a, Verdict b);

struct CheckRecord {
  std::string id;         // "3.3/samples", "images/samples"
  std::string statement;  // what is asked: "the directions follow the density ..."
  Verdict verdict = Verdict::kOk;
  std::string where, expected, got, tolerance;  // empty where there is nothing to say
  std::string cause;                            // likely cause, or what blocks
  std::string evidence;                         // for the cause, where it is a known mistake
  std::string remark;
  std::string read;    // handout and section
  std::string repeat;  // command, for those who have the coursework in student/
  double delta = 0.0;  // the smallest error that is found with probability 0.999; 0: pointwise
  double shown = 0.0;  // of a pass: the error that would have been found
  std::uint64_t calls = 0;
  double seconds = 0.0;
};

struct FunctionRecord {
  std::string section;  // "3.3"
  std::string name;     // "lambertianBRDF::reflection"
  Verdict verdict = Verdict::kOk;
  std::vector<CheckRecord> checks;
  std::string mistake{};   // the known mistake that it makes, by its name; empty: none clearly
  std::string what{};      // the same in words
  std::string evidence{};  // what agrees
};

// A number with its confidence interval.
struct Estimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

// A picture made with the solutions but for some parts, or as submitted, beside the same picture
// made with the solutions alone. Files are PNG, named relative to the record.
struct PictureRecord {
  std::string scene;       // "cornell_box", or words for a scene that was made for marking
  std::string yours;       // file
  std::string reference;   // file
  std::string difference;  // file: signed, red where yours is brighter
  double scale = 0.0;      // relative difference that is fully coloured in it
  int width = 0, height = 0;
  double raysPerPixel = 0.0;

  // Root mean square over coarse tiles of (yours - reference) / mean of the reference, noise taken
  // away: the consequence of a mistake. The interval is of 99 %.
  Estimate bias;
  // (yours - reference) / reference of the whole picture, for each channel.
  std::array<Estimate, 3> meanError{};
  // Efficiency, 1 / (variance x rays), over that of the solutions.
  std::optional<Estimate> efficiency;
  // Of rendering, as the operating system tells; depends on the machine.
  double cpuSeconds = 0.0, cpuSecondsOfSolutions = 0.0;

  // p-values of pixels in equal bins of [0,1]: flat where there is nothing but noise.
  std::vector<std::uint32_t> pValues;

  // Relative error against the reference for growing numbers of rays per pixel.
  struct Convergence {
    std::vector<double> raysPerPixel, yours, solutions;
  } convergence;

  // "16 % of its values are no radiance (45946 NaN)"; empty: all are. Those are left out of the
  // picture and of its numbers; a pixel that has no others is magenta.
  std::string invalid;

  std::string failure;  // why there is no picture: a sentence
};

// A known mistake that a function of the part makes, and its picture of the scene in which the
// part's own picture is furthest off.
struct MistakePicture {
  std::string mistake, what;  // as in FunctionRecord
  std::string scene;
  std::string yours, reference;  // files of the part's own picture of the scene
  std::string picture;           // file, with nothing wrong but this mistake
  Estimate bias;                 // of yours
  Estimate apart;                // of yours with the mistake's picture as the reference
};

struct PartRecord {
  int part = 0;
  std::string file;   // "part3_lambertian.cpp"
  std::string title;  // "The Lambertian BRDF"
  Verdict verdict = Verdict::kOk;
  std::string message;  // what the compiler or linker said, or why there are no functions
  std::vector<FunctionRecord> functions;

  // With this part as submitted and all others from the solutions.
  std::vector<PictureRecord> pictures;
  std::vector<MistakePicture> mistakes{};

  // Whether there was anything to grade: a stub is a file, whose functions are not written.
  bool hasFile() const { return verdict != Verdict::kNotWritten || !functions.empty(); }
};

// Where a sampling function puts its samples.
enum class SampleDomain { kSphere, kHemisphere, kPlane };
std::string_view nameOf(SampleDomain domain);
std::optional<SampleDomain> domainNamed(std::string_view name);

struct Histogram {
  std::string axis;  // "cos(theta)", "x / width"
  double low = 0.0, high = 1.0;
  std::vector<double> yours, expected;  // fractions of all samples, in equal bins
};

struct SampleRecord {
  std::string section, name, inputs;  // "n = (0, 1, 0), s and t stratified"
  SampleDomain domain = SampleDomain::kSphere;
  // Directions in the local frame, y the normal; or places in the plane, x and z in [0,1], y = 0.
  std::vector<std::array<float, 3>> yours;
  std::vector<Histogram> histograms;
};

// Part 7.
struct SceneRecord {
  std::string file, caption;
  Verdict verdict = Verdict::kOk;
  std::string message, noise;
  std::string picture;  // file; empty if it was not rendered
};

// What marks depend on besides coursework and seed.
struct BuildRecord {
  std::string program;       // hash of the grader
  std::string compiler;      // "g++ 12.2.0"
  std::string flags;         // of coursework
  std::string instructions;  // "x86-64, AVX-512"
  std::string sandbox;       // "bubblewrap", "Landlock", "none"
};

struct SubmissionRecord {
  static constexpr int kFormat = 5;

  std::string name;      // unique in a class
  std::string source;    // the folder or archive, as it was given
  std::string contents;  // hash of the files that were taken
  std::uint64_t seed = 0;
  BuildRecord build;
  std::vector<std::string> collecting;     // what was refused, renamed or missing: sentences
  std::vector<std::string> refusedScenes;  // those of them that are about scenes
  std::vector<PartRecord> parts;
  std::vector<CheckRecord> images;  // of the whole coursework
  std::vector<SceneRecord> scenes;
  std::vector<PictureRecord> pictures;  // as submitted
  std::vector<SampleRecord> samples;
  std::string printed;  // the beginning of what the coursework printed
  std::string leftOut;  // why there was nothing to grade: a sentence; there is nothing else then
  std::string failure;  // of the grader or the machine: a sentence; the record is not complete then
  bool outOfTime = false;  // something is missing: the time for the whole submission was up
  double seconds = 0.0;

  bool internalError() const { return !failure.empty(); }

  // Without them there is a sentence in `leftOut` or `failure`: no marks are not 0.
  bool hasMarks() const { return leftOut.empty() && failure.empty(); }
};

}  // namespace pathmark::record
