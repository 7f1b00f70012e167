#pragma once

#include "Subject.h"

#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <vector>

namespace lodsmith::benchmarks {

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - mStart).count(); }

private:
    std::chrono::steady_clock::time_point mStart = std::chrono::steady_clock::now();
};

/// Throws what went wrong.
template <class T>
void expect(const Result<T>& result)
{
    if (!result)
        throw std::runtime_error(describe(result.error()));
}

/// Four levels without 50, 75, 87.5 and 93.75% of the vertices.
LodConfig halvedLevels(const Ogre::MeshPtr& mesh);

/// All subjects of at most so many triangles.
std::vector<std::unique_ptr<Subject>> subjectsUpTo(std::uint32_t triangles);

} // namespace lodsmith::benchmarks
