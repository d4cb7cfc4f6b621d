#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/text.h"

// The lines of a batch: on the standard output, or in a file by which an interrupted batch goes on.

namespace kerf::tools {

/// Of what is in a file. @throws FileError
std::string key_of_file(const std::string& path);

class BatchResults
{
public:
    /// @param path    none: the standard output. The file is made, and no other batch can write it meanwhile
    /// @param prefix  the beginning of the names of the pieces
    /// @throws FileError  another batch writes it; it can't be written
    BatchResults(std::string path, std::string prefix);
    ~BatchResults();
    BatchResults(const BatchResults&) = delete;
    BatchResults& operator=(const BatchResults&) = delete;

    /// Reads the lines of an earlier run, as far as the files that they name are as they were; what stands behind them is
    /// removed, and so is what a run that was killed left under temporary names.
    /// @param key_of  the key of a job, below `count`
    /// @throws FileError  the file holds something else; then it is as it was
    void go_on(std::size_t count, const std::function<std::string(std::size_t)>& key_of);
    const std::vector<Json>& earlier() const { return earlier_; }

    /// Adds a line, at once. @throws FileError
    void add(const std::string& line);
    /// All lines are there.
    void finish();

private:
    void remove_leftovers() const;
    void note_process() const;
    std::string note_path() const { return path_ + ".run"; }

    std::string path_, prefix_;
    int file_ = -1;
    std::vector<Json> earlier_;
};

}  // namespace kerf::tools
