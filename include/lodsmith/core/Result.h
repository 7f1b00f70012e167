#pragma once

#include <lodsmith/core/Assert.h>
#include <lodsmith/core/Export.h>

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace lodsmith {

/// What kind of bad data, or of failure from outside, stopped an operation.
enum class ErrorCode {
    InvalidGeometry, ///< positions or attributes that no cleaning can mend (non-finite, out of range)
    IndexOutOfRange, ///< an index that names no vertex of its buffer
    InvalidSetting,  ///< an option or a level target outside its range
    Unsupported,     ///< well-formed, but nothing this library can work on
    NotFound,        ///< a file, mesh or resource that does not exist
    Io,              ///< the operating system refused to read or write
    BadFile,         ///< a file whose content is not what its name promises
    Cancelled,       ///< stopped through Progress::cancel()
    OutOfMemory,     ///< an allocation failed
};

/// The word for a code, as used in messages and in JSON ("index_out_of_range").
LODSMITH_API const char* toString(ErrorCode code);

/// Bad data, said so that a person can mend it: what, where, and what was expected.
struct Error {
    ErrorCode code = ErrorCode::InvalidGeometry;
    std::string message;    ///< one sentence, without the place
    std::string file{};     ///< file or resource name, empty when not known
    int line = -1;          ///< line in a text file, from 1; -1 when not known
    int subMesh = -1;       ///< submesh number, from 0; -1 when not known
    std::int64_t item = -1; ///< vertex or index number, from 0; -1 when not known
};

/// One line: "FILE:LINE: submesh S, item I: message", leaving out what is not known.
LODSMITH_API std::string describe(const Error& error);

/// A value, or the reason why there is none. Asking for the wrong one is misuse and asserts.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : mState(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : mState(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return mState.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() & { return LODSMITH_ASSERT(ok(), "Result holds an error"), *std::get_if<0>(&mState); }
    const T& value() const& { return LODSMITH_ASSERT(ok(), "Result holds an error"), *std::get_if<0>(&mState); }
    T value() && { return LODSMITH_ASSERT(ok(), "Result holds an error"), std::move(*std::get_if<0>(&mState)); }
    const Error& error() const { return LODSMITH_ASSERT(!ok(), "Result holds a value"), *std::get_if<1>(&mState); }

private:
    std::variant<T, Error> mState;
};

/// Success without a value.
struct Done {};

} // namespace lodsmith
