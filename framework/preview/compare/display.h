// From linear radiance to what the screen shows. For looking only: pictures stay linear.
//
//   ToneCurve         what becomes of radiance that the screen cannot show
//   DisplaySettings   exposure and tone curve
//   toneMapped        one number
//   displayImage      a picture
#pragma once

#include "film/image.h"

#include <cstdint>
#include <vector>

namespace pathmark::preview {

enum class ToneCurve {
  kClip,      // what is above 1 is white, as in PNG files
  kReinhard,  // Reinhard et al., "Photographic Tone Reproduction for Digital Images", SIGGRAPH
              // 2002, equation 4, of the luminance: colours keep their hue
  kFilmic     // Narkowicz, "ACES Filmic Tone Mapping Curve", 2016: a fit to the film curve of the
              // Academy Color Encoding System, of each channel
};

struct DisplaySettings {
  double exposure = 1.0;  // factor on radiance
  ToneCurve curve = ToneCurve::kClip;
  double white = 4.0;  // kReinhard: the smallest luminance, after exposure, that is white

  bool operator==(const DisplaySettings&) const = default;
};

// Of a linear value, 0 or more, after exposure. From 0 to 0, never falling; kClip leaves it as it
// is.
double toneMapped(double linear, const DisplaySettings& settings);

// Four bytes a pixel, sRGB, as the PNG encoder has them if the curve is kClip. Pixels without a
// valid value are magenta. `rgba` is resized; its memory is used again.
void displayImage(const Image& image, const DisplaySettings& settings,
                  std::vector<std::uint8_t>& rgba);

}  // namespace pathmark::preview
