// The mesh of the scene "blob", which is made rather than shipped: its file is large.
#pragma once

#include <cstddef>
#include <filesystem>

namespace pathmark {

// Where the shipped scene looks for it.
std::filesystem::path shippedBlobFile();

// Returns the number of triangles. Throws ImageError if the file cannot be written.
std::size_t writeBlobFile(const std::filesystem::path& file, int subdivisions);

// Writes shippedBlobFile() and its folder unless the file is there; returns whether it did.
bool makeShippedBlobFile();

// Whether `scene` is the shipped scene that needs the mesh.
bool needsShippedBlobFile(const std::filesystem::path& scene);

}  // namespace pathmark
