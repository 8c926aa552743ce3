#include "study/marks_study.h"

#include "grading/build_record.h"
#include "grading/judge.h"
#include "host/content_hash.h"
#include "record/record_json.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

namespace pathmark::study {

namespace fs = std::filesystem;

namespace {

constexpr double kBonusPoints = 10.0, kBonusEfficiency = 2.0;

std::string readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// What a record depends on, as a name for its file.
std::string keyOf(const fs::path& coursework, int part, std::uint64_t seed) {
  static const record::BuildRecord build = grading::thisBuild("none");
  ContentHasher hasher;
  for (const std::string& text : {build.program, build.compiler, build.flags})
    hasher.add(text + "\n");
  for (const PartContract& p : parts()) hasher.add(readFile(coursework / p.file));
  hasher.add(fmt::format("part {}, seed {}", part, seed));
  return hasher.digits();
}

// Records of variants, each made once; the judge of one part and seed serves those that follow with
// the same.
class Records {
 public:
  explicit Records(const MarksOptions& options) : options_(options) {}

  // Throws Interrupted.
  record::SubmissionRecord of(const Variant& variant, std::uint64_t seed,
                              const grading::OnProgress& onProgress) {
    const fs::path coursework = options_.folder / "coursework" / variant.name;
    applyVariant(variant, coursework);
    const fs::path file = options_.folder / (keyOf(coursework, variant.part, seed) + ".json");
    if (const auto known = knownRecord(file)) return *known;
    record::SubmissionRecord made =
        judge(variant.part, seed).judge(coursework, options_.threads, onProgress).record;
    made.name = variant.name;
    if (!made.internalError()) writeRecord(made, file);
    return made;
  }

 private:
  grading::Judge& judge(int part, std::uint64_t seed) {
    if (!judge_ || part_ != part || seed_ != seed) {
      grading::JudgeOptions options;
      options.seed = seed;
      options.parts = {part};
      options.whole = false;
      judge_.emplace(options, nullptr);
      part_ = part;
      seed_ = seed;
    }
    return *judge_;
  }

  static std::optional<record::SubmissionRecord> knownRecord(const fs::path& file) {
    try {
      if (fs::exists(file)) return record::readRecord(file);
    } catch (const record::RecordError&) {
      // Cut off, or of another format: it is made anew.
    }
    return std::nullopt;
  }

  const MarksOptions& options_;
  std::optional<grading::Judge> judge_;
  int part_ = -1;
  std::uint64_t seed_ = 0;
};

std::string words(const Points& p) {
  return p.outOf == 0.0 ? "-" : fmt::format("{:.4g} of {:.4g}", p.points, p.outOf);
}

}  // namespace

bool VariantMarks::asItMustBe() const {
  return !toReview && correctness.outOf > 0.0 && correctness.all() &&
         (part.all() || !variant.lessEfficient.empty());
}

rubric::Rubric withBonusParts(rubric::Rubric rubric) {
  for (const PartContract& part : parts()) {
    const bool known = std::any_of(rubric.parts.begin(), rubric.parts.end(),
                                   [&](const auto& worth) { return worth.part == part.part; });
    if (part.bonus && !known)
      rubric.parts.push_back({part.part, kBonusPoints, kBonusEfficiency, {}, {}, true});
  }
  return rubric;
}

VariantMarks marksOf(const Variant& variant, const record::SubmissionRecord& record,
                     const rubric::Rubric& rubric) {
  VariantMarks marks;
  marks.variant = variant;
  marks.seed = record.seed;
  const rubric::Marks all = markSubmission(record, rubric);
  marks.reasons = all.toReview;
  marks.toReview = !all.toReview.empty();
  for (const rubric::PartMarks& part : all.parts) {
    if (part.part != variant.part) continue;
    marks.part = {part.points, part.outOf};
    for (const rubric::MarkLine& line : part.lines) {
      if (line.what == rubric::kRoundingLine) continue;
      Points& sum = line.what == rubric::kEfficiencyLine ? marks.efficiency : marks.correctness;
      sum.points += line.points;
      sum.outOf += line.outOf;
      if (line.points < line.outOf)
        marks.reasons.push_back(fmt::format("{}: {}", line.what, line.reason));
    }
  }
  return marks;
}

std::vector<VariantMarks> markVariants(
    const std::vector<Variant>& variants, const rubric::Rubric& rubric, const MarksOptions& options,
    const std::function<bool(std::size_t done, std::size_t all)>& step) {
  const std::size_t all = variants.size() * static_cast<std::size_t>(options.seeds);
  std::vector<VariantMarks> marks;
  Records records(options);
  const auto goOn = [&](double) { return step(marks.size(), all); };
  try {
    for (int seed = 1; seed <= options.seeds; ++seed)
      for (const Variant& variant : variants) {
        if (!goOn(0.0)) return marks;
        marks.push_back(
            marksOf(variant, records.of(variant, static_cast<std::uint64_t>(seed), goOn), rubric));
      }
  } catch (const Interrupted&) {
    // What is done stays.
  }
  return marks;
}

MarksReport reportMarks(const std::vector<VariantMarks>& marks) {
  MarksReport report;
  std::size_t full = 0, onPurpose = 0;
  report.text = fmt::format("{:<44} {:>5} {:>14} {:>14} {:>14}\n", "correct", "seed", "correctness",
                            "efficiency", "part");
  for (const VariantMarks& m : marks) {
    const bool good = m.asItMustBe(), all = m.correctness.all() && m.part.all();
    report.asItMustBe = report.asItMustBe && good;
    full += all ? 1 : 0;
    onPurpose += good && !all ? 1 : 0;
    report.text += fmt::format("{:<44} {:>5} {:>14} {:>14} {:>14}{}{}\n", m.variant.name, m.seed,
                               words(m.correctness), words(m.efficiency), words(m.part),
                               m.variant.lessEfficient.empty() ? "" : "  less efficient on purpose",
                               good ? "" : "   <-- must not be");
    for (const std::string& reason : m.reasons) report.text += fmt::format("    {}\n", reason);
  }
  report.text += fmt::format(
      "\n{} marks: {} of all points, {} of all but those of efficiency, on purpose: {}\n",
      marks.size(), full, onPurpose,
      report.asItMustBe ? "all as they must be" : "NOT all as they must be");
  return report;
}

}  // namespace pathmark::study
