#include "CorePeer.h"

#include "StoredLevels.h"

#include <chrono>
#include <stdexcept>

namespace lodsmith::benchmarks {

double CorePeer::generate(Subject& subject, const Plan& plan)
{
    const auto start = std::chrono::steady_clock::now();
    Result<LodChain> chain = simplify(subject.view(), targetsOf(plan), mOptions);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (!chain)
        throw std::runtime_error(name() + ": " + describe(chain.error()));
    mChain = std::move(chain).value();
    return taken.count();
}

std::vector<PeerLevel> CorePeer::levels(const Subject& subject) const
{
    return chainLevels(subject.view(), mChain);
}

} // namespace lodsmith::benchmarks
