// What a user's file or flag can get wrong travels as a value: Result<T> holds a T or an Error.
// Same spelling as C++23's std::expected, which GCC 12 lacks.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace reflectance {

/// One sentence for the user, with the place it speaks of.
struct Error {
    std::string message;   ///< what is wrong; what to do
    std::string file = {}; ///< empty when no file is concerned
    long line = 0;         ///< 1-based; 0 when no line is concerned

    /// "FILE:LINE: message", leaving out what is unknown; one line of legible length, whatever it quotes from a file.
    [[nodiscard]] std::string sentence() const;
};

template <class T> class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    T& value() & { return std::get<0>(state_); }
    const T& value() const& { return std::get<0>(state_); }
    T&& value() && { return std::get<0>(std::move(state_)); }
    [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, Error> state_;
};

/// A Result without a value: success or an Error.
template <> class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    [[nodiscard]] bool has_value() const { return !error_; }
    explicit operator bool() const { return has_value(); }
    [[nodiscard]] const Error& error() const { return *error_; }

private:
    std::optional<Error> error_;
};

} // namespace reflectance
