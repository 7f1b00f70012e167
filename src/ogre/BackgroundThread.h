#pragma once

namespace lodsmith {

/// Puts the calling thread behind those that draw: it does not interrupt the thread that wakes it, and gets a tenth of the time
/// of one that it shares a core with. Linux; elsewhere, and where the system refuses, it stays as it is.
void becomeBackgroundThread();

} // namespace lodsmith
