#include "preview/compare/compare_session.h"

#include "preview/compare/known_noise.h"

#include <algorithm>

namespace pathmark::preview {

namespace {

Verdict tooEarly(const Picture& picture) {
  return {.judgement = Judgement::kTooEarly,
          .headline = "Too early to tell.",
          .detail =
              "The noise must be known first: it is told by the differences between parts of "
              "the picture that are independent of each other.\n",
          .worst = {},
          .raysPerPixel = picture.raysPerPixel};
}

Verdict sameSeries() {
  return {.judgement = Judgement::kNone,
          .headline = "This is the picture that you kept, with more rays.",
          .detail = "Change a function or the sampler, and see what becomes of it.\n",
          .worst = {}};
}

}  // namespace

std::shared_ptr<const CompareResult> CompareSession::compare(const CompareRequest& request) {
  const auto result = std::make_shared<CompareResult>();
  result->picture = request.picture;
  result->wish = request.wish.number;
  result->view = request.view;
  result->found = finder_.find(request.wish, request.picture);
  const std::shared_ptr<const Image> known = imageWithKnownNoise(request.picture);
  result->noiseKnown = known != nullptr;
  const Image& image = known ? *known : request.picture->image;
  const Reference* reference = result->found.reference.get();
  if (reference != nullptr) {
    compareWithReference(known, *result);
    result->referenceNoise = expectedError(*reference->image, nullptr);
  }
  ErrorPoint point{.raysPerPixel = request.picture->raysPerPixel,
                   .seconds = request.picture->seconds};
  // Pictures of one series have rays in common.
  if (result->comparison && !result->ownReference) point.measured = result->comparison->relativeMse;
  point.expected = expectedError(image, reference != nullptr ? reference->image.get() : nullptr);
  curves_.add(*request.picture, reference != nullptr ? reference->id : 0, point);
  result->curves = curves_;
  colour(known, *result);
  return result;
}

CompareSession::Trial& CompareSession::trialOf(const Picture& picture, const Reference& reference) {
  if (series_ != picture.series) trials_.clear();
  series_ = picture.series;
  return trials_.try_emplace(reference.id, Trial{Looks(alpha_), tooEarly(picture)}).first->second;
}

void CompareSession::compareWithReference(const std::shared_ptr<const Image>& known,
                                          CompareResult& result) {
  const Reference& reference = *result.found.reference;
  const Picture& picture = *result.picture;
  Trial& trial = trialOf(picture, reference);
  const bool look = known && trial.looks.due(picture.raysPerPixel);
  if (look) trial.looks.take(picture.raysPerPixel);
  // Between looks, numbers are coloured by the last one's threshold.
  CompareSettings settings;
  settings.alpha = trial.looks.alphaOf(std::max(trial.looks.taken(), 1));
  // Without known noise there are numbers, but no tests.
  const Replicates replicates =
      known ? Replicates{picture.replicates, reference.replicates} : Replicates{};
  result.comparison =
      compareImages(known ? *known : picture.image, *reference.image, replicates, settings);
  // What has been called a difference once stays one: that is the event whose rate is bounded.
  if (look && trial.verdict.judgement != Judgement::kDiffers)
    trial.verdict = verdictOf(*result.comparison, picture.raysPerPixel);
  result.ownReference = reference.series == picture.series;
  result.verdict = result.ownReference ? sameSeries() : trial.verdict;
  result.nextLook = trial.looks.nextAt();
}

void CompareSession::colour(const std::shared_ptr<const Image>& known, CompareResult& result) {
  const Image& image = known ? *known : result.picture->image;
  switch (result.view) {
    case View::kPicture:
    case View::kReference:
    case View::kSlider:
      return;
    case View::kNoise:
      if (image.variance.empty())
        result.whyNoColours = "The noise is known when the picture has two independent parts.";
      else
        result.colours = noiseColours(image);
      return;
    case View::kError:
      if (result.comparison)
        result.colours =
            errorColours(image, *result.found.reference->image, result.comparison->pixels);
      break;
    case View::kScores:
      if (result.comparison && known && !result.ownReference)
        result.colours = scoreColours(image.width, image.height, *result.comparison);
      else if (result.comparison)
        result.whyNoColours = known ? sameSeries().headline : tooEarly(*result.picture).detail;
      break;
  }
  if (!result.comparison) result.whyNoColours = result.found.why;
}

}  // namespace pathmark::preview
