#pragma once

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/fuzzer.h"

namespace kerf::core::fuzz {

/// A command line from bytes: the program's name, then one argument a line.
class CommandLine
{
public:
    CommandLine(const char* program, Bytes bytes) : words_{program}
    {
        std::string word;
        for (const std::uint8_t byte : bytes) {
            if (byte == '\n') {
                words_.push_back(word);
                word.clear();
            } else if (byte != 0) {
                word.push_back(static_cast<char>(byte));
            }
        }
        if (!word.empty()) words_.push_back(word);
        for (std::string& w : words_) pointers_.push_back(w.data());
        pointers_.push_back(nullptr);
    }

    int argc() const { return static_cast<int>(words_.size()); }
    char** argv() { return pointers_.data(); }

private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

/// Catches what programs print while it lives.
class Silence
{
public:
    Silence() : out_(std::cout.rdbuf(text_.rdbuf())), err_(std::cerr.rdbuf(text_.rdbuf())) {}
    ~Silence()
    {
        std::cout.rdbuf(out_);
        std::cerr.rdbuf(err_);
    }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
    std::streambuf* out_;
    std::streambuf* err_;
};

}  // namespace kerf::core::fuzz
