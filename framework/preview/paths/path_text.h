// Words about a path, for tables and tooltips. Lengths are those of the scene file.
#pragma once

#include "preview/paths/path_account.h"
#include "preview/paths/path_record.h"
#include "scene/load_scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pathmark::preview {

// "Phong 3", of the scene's materials; "light" for what emits.
std::string surfaceName(const PathVertex& vertex, const LoadedScene& scene);

// Why a path has ended, in a word or two.
std::string endOf(const TracedPath& path);

// All that is known of the k-th vertex.
std::vector<std::string> describeVertex(const TracedPath& path, const PathAccount& account,
                                        std::size_t k, const LoadedScene& scene);

}  // namespace pathmark::preview
