#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace kerf::io {

/// Why a piece of text is not a number that fits.
enum class NumberError : std::uint8_t
{
    none,
    not_a_number,
    not_finite,
    too_large
};

/// The float nearest to a decimal number, ties to even; a number too small for a float is 0. `text` is all number.
NumberError parse_float(std::string_view text, float& value);

/// Walks over the lines and the words of a text file, and reports errors with file and line. A line ends with LF, CR LF
/// or CR. Holds a view: the text must outlive it.
class TextScanner
{
public:
    struct Syntax
    {
        char comment = '\0';         ///< starts a comment that runs to the end of the line; '\0': there are none
        bool continuations = false;  ///< a backslash at the end of a line joins the next one to it
    };

    TextScanner(const std::filesystem::path& path, std::string_view text, Syntax syntax);

    /// Moves to the start of the next line that has a word. False at the end of the file.
    bool next_line();

    /// The next word of this line; empty at its end.
    std::string_view word();

    /// The next word of this line or of a later one; empty at the end of the file.
    std::string_view word_of_any_line();

    /// The rest of the line without white space around it. Comments and continuations are not looked for: it is a name.
    std::string_view rest();

    /// The next word of this line as a finite number. `what` names it in the error: "a coordinate".
    float number(std::string_view what) { return to_number(word(), what); }
    std::int64_t integer(std::string_view what) { return to_integer(word(), what); }

    /// The same for a word that was taken before; an empty word is the end of the line or file.
    float to_number(std::string_view text, std::string_view what) const;
    std::int64_t to_integer(std::string_view text, std::string_view what) const;

    /// Leaves the line: everything up to and with its end is behind us.
    void end_line();

    /// Number of the line, counted from 1; readers that start in the middle of a file say where.
    std::size_t line() const { return line_; }
    void set_line(std::size_t line) { line_ = line; }

    std::size_t bytes_left() const { return text_.size() - at_; }

    /// @throws FileError  "FILE: line N: REASON"
    [[noreturn]] void fail(const std::string& reason) const;

private:
    bool at_line_end() const { return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
    void skip_line_end();
    void skip_blanks();

    const std::filesystem::path& path_;
    std::string_view text_;
    Syntax syntax_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    bool in_line_ = false;  ///< next_line() was called: the current line must be left first
};

/// A piece of a file for an error message: in quotes, shortened, without control characters.
std::string in_quotes(std::string_view text);

}  // namespace kerf::io
