#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace lodsmith {

namespace {

/// The numbers that are still to be worked on, and what went wrong.
class Counter {
public:
    Counter(std::size_t count, const std::function<void(std::size_t)>& work) : mCount(count), mWork(work) {}

    void run() noexcept
    {
        try {
            for (std::size_t i = mNext++; i < mCount; i = mNext++)
                mWork(i);
        } catch (...) {
            mNext = mCount;
            const std::lock_guard lock(mMutex);
            if (!mThrown)
                mThrown = std::current_exception();
        }
    }

    void rethrow() const
    {
        if (mThrown)
            std::rethrow_exception(mThrown);
    }

private:
    const std::size_t mCount;
    const std::function<void(std::size_t)>& mWork;
    std::atomic<std::size_t> mNext{0};
    std::mutex mMutex;
    std::exception_ptr mThrown;
};

} // namespace

void inParallel(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& work)
{
    Counter counter(count, work);
    std::vector<std::thread> others;
    const std::size_t wanted = std::min<std::size_t>(threads, count);
    others.reserve(wanted);
    try {
        while (others.size() + 1 < wanted)
            others.emplace_back([&counter] { counter.run(); });
    } catch (const std::system_error&) { // no further thread: what there are will do
    } catch (const std::bad_alloc&) {
    }
    counter.run();
    for (std::thread& other : others)
        other.join();
    counter.rethrow();
}

} // namespace lodsmith
