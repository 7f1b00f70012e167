#pragma once

#include "PMWorker.h"

#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <chrono>
#include <functional>
#include <memory>

namespace lodsmith {

/// What a queue is made of. Tests put parts of their own in.
struct QueueParts {
    ComputeFunction compute = computeLods;
    std::function<std::chrono::steady_clock::time_point()> now = std::chrono::steady_clock::now;

    static std::unique_ptr<QueuedProgressiveMeshGenerator> makeQueue(const QueueOptions& options, QueueParts parts)
    {
        return std::unique_ptr<QueuedProgressiveMeshGenerator>(
            new QueuedProgressiveMeshGenerator(options, std::move(parts)));
    }
};

} // namespace lodsmith
