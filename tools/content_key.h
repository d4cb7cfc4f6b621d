#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>

namespace kerf::tools {

/// A number that differs if the content differs: FNV-1a (Fowler, Noll, Vo) over words of eight bytes. No secret: who
/// wants two contents with one number finds them.
class ContentKey
{
public:
    void add(std::span<const std::byte> bytes)
    {
        add_word(bytes.size());
        for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
            std::uint64_t word;
            std::memcpy(&word, bytes.data(), 8);
            add_word(word);
        }
        std::uint64_t rest = 0;
        if (!bytes.empty()) std::memcpy(&rest, bytes.data(), bytes.size());
        add_word(rest);
    }
    void add(const std::string& text) { add(std::as_bytes(std::span(text))); }
    void add(double value) { add_word(std::bit_cast<std::uint64_t>(value)); }
    void add(std::uint64_t value) { add_word(value); }
    std::uint64_t value() const { return value_; }
    /// Sixteen hexadecimal digits.
    std::string text() const
    {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value_));
        return digits;
    }

private:
    void add_word(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3; }

    std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace kerf::tools
