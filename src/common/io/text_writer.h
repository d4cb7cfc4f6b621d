#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include "common/files/byte_sink.h"

namespace kerf::core::io {

/// Gathers short pieces of text and hands them on in large ones.
class TextWriter
{
public:
    explicit TextWriter(ByteSink& file) : file_(file) {}

    TextWriter& operator<<(std::string_view text)
    {
        text_ += text;
        if (text_.size() > kBufferBytes) flush();
        return *this;
    }

    /// The shortest decimal number that reads back as the same float.
    TextWriter& operator<<(float value) { return number(value); }
    TextWriter& operator<<(std::uint32_t value) { return number(value); }

    void flush()
    {
        file_.write(text_);
        text_.clear();
    }

private:
    template <class T>
    TextWriter& number(T value)
    {
        std::array<char, 32> digits;
        const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
        return *this << std::string_view(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
    }

    static constexpr std::size_t kBufferBytes = 1 << 16;
    ByteSink& file_;
    std::string text_;
};

}  // namespace kerf::core::io
