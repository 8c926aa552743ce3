#include "scene/to_float.h"

namespace pathmark {

Float3 toFloat3(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace pathmark
