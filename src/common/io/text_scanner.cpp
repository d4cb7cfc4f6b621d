#include "common/io/text_scanner.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "common/io/read_formats.h"

namespace kerf::io {

namespace {

bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// What a number is that std::from_chars calls out of range for a float: 0, or too large.
NumberError resolve_out_of_range(std::string_view text, float& value)
{
    double wide = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), wide);
    bool small = false;
    if (error == std::errc::result_out_of_range) {
        // Outside the doubles too: the sign of the exponent tells, or, for a very long number, its first digit.
        const std::size_t exponent = text.find_first_of("eE");
        if (exponent != std::string_view::npos)
            small = exponent + 1 < text.size() && text[exponent + 1] == '-';
        else
            small =
                text.starts_with('.') || text.starts_with("0.") || text.starts_with("-.") || text.starts_with("-0.");
    } else {
        small = std::abs(wide) < 1.0;
    }
    if (!small) return NumberError::too_large;
    value = text.starts_with('-') ? -0.0f : 0.0f;
    return NumberError::none;
}

}  // namespace

NumberError parse_float(std::string_view text, float& value)
{
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) return NumberError::not_a_number;
    if (error == std::errc::result_out_of_range) return resolve_out_of_range(text, value);
    if (std::isfinite(value)) return NumberError::none;
    // "inf" and "nan" are words; digits that end up infinite are a number that is too large.
    return text.find_first_of("0123456789") == std::string_view::npos ? NumberError::not_finite
                                                                      : NumberError::too_large;
}

TextScanner::TextScanner(const std::filesystem::path& path, std::string_view text, Syntax syntax)
    : path_(path), text_(text), syntax_(syntax)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

void TextScanner::skip_line_end()
{
    if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
    ++at_;
    ++line_;
}

/// Moves to the next word of the line, or to its end.
void TextScanner::skip_blanks()
{
    while (!at_line_end()) {
        const char c = text_[at_];
        if (is_blank(c)) {
            ++at_;
        } else if (syntax_.comment != '\0' && c == syntax_.comment) {
            while (!at_line_end()) ++at_;
        } else if (syntax_.continuations && c == '\\' && at_ + 1 < text_.size() &&
                   (text_[at_ + 1] == '\n' || text_[at_ + 1] == '\r')) {
            ++at_;
            skip_line_end();
        } else {
            return;
        }
    }
}

bool TextScanner::next_line()
{
    if (in_line_) end_line();
    in_line_ = true;
    for (;;) {
        skip_blanks();
        if (at_ == text_.size()) return false;
        if (!at_line_end()) return true;
        skip_line_end();
    }
}

void TextScanner::end_line()
{
    while (!word().empty()) {
    }
    if (at_ < text_.size()) skip_line_end();
    in_line_ = false;
}

std::string_view TextScanner::word()
{
    skip_blanks();
    const std::size_t first = at_;
    while (!at_line_end() && !is_blank(text_[at_])) {
        if (syntax_.comment != '\0' && text_[at_] == syntax_.comment) break;
        const bool continued = syntax_.continuations && text_[at_] == '\\' && at_ + 1 < text_.size() &&
                               (text_[at_ + 1] == '\n' || text_[at_ + 1] == '\r');
        if (continued) break;
        ++at_;
    }
    return text_.substr(first, at_ - first);
}

std::string_view TextScanner::word_of_any_line()
{
    for (;;) {
        const std::string_view found = word();
        if (!found.empty() || at_ == text_.size()) return found;
        skip_line_end();
    }
}

std::string_view TextScanner::rest()
{
    while (!at_line_end() && is_blank(text_[at_])) ++at_;
    const std::size_t first = at_;
    while (!at_line_end()) ++at_;
    std::size_t last = at_;
    while (last > first && is_blank(text_[last - 1])) --last;
    return text_.substr(first, last - first);
}

float TextScanner::to_number(std::string_view text, std::string_view what) const
{
    if (text.empty()) fail(std::string(what) + " is missing; add it or take the line out");
    float value = 0.0f;
    switch (parse_float(text, value)) {
        case NumberError::none:
            break;
        case NumberError::not_a_number:
            fail(std::string(what) + " is " + in_quotes(text) + ", which is not a number; write one");
        case NumberError::not_finite:
            fail(std::string(what) + " is " + in_quotes(text) +
                 ", which is not finite; write a number, or take it and its faces out");
        case NumberError::too_large:
            fail(std::string(what) + " is " + in_quotes(text) +
                 ", which is too large for single precision; scale the mesh down");
    }
    return value;
}

std::int64_t TextScanner::to_integer(std::string_view text, std::string_view what) const
{
    if (text.empty()) fail(std::string(what) + " is missing; add it or take the line out");
    const std::string_view digits = text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
        fail(std::string(what) + " is " + in_quotes(text) + ", which is not an integer that fits; write one");
    return value;
}

void TextScanner::fail(const std::string& reason) const
{
    io::fail(path_, "line " + std::to_string(line_) + ": " + reason);
}

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    std::string result = "'";
    for (const char c : text.substr(0, kLongest)) result += (c >= ' ' && c != '\x7f') || c < 0 ? c : '?';
    return result + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace kerf::io
