#pragma once

#include <atomic>

namespace lodsmith {

/// A line between a running job and whoever watches it: a fraction one way, a wish to stop the other way.
///
/// Any thread may call any member. The owner keeps it alive until the job has returned. A cancel always wins: a job
/// that has seen it returns ErrorCode::Cancelled and no partial result, even when it was about to finish; a cancel
/// that comes after the job has returned changes nothing. Work started with an already cancelled Progress returns at once.
class Progress {
public:
    /// Share of the work done, 0..1, never falling.
    float fraction() const { return mFraction.load(std::memory_order_relaxed); }
    void cancel() { mCancelled.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return mCancelled.load(std::memory_order_relaxed); }

    /// For the job: reports how far it is.
    void report(float fraction) { mFraction.store(fraction, std::memory_order_relaxed); }

private:
    std::atomic<float> mFraction{0.0f};
    std::atomic<bool> mCancelled{false};
};

} // namespace lodsmith
