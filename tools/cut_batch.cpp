#include "tools/cut_batch.h"

#include <kerf/version.h>

#include <bit>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>
#include <stdexcept>

#include "tools/commands.h"
#include "tools/in_order.h"
#include "tools/progress_line.h"

namespace kerf::tools {

namespace {

/// FNV-1a (Fowler, Noll, Vo) over words of eight bytes.
class Key
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

private:
    void add_word(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3; }

    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// What the files of a job depend on.
std::string key_of(const CutBatch& batch, const CutJob& job, const Plane& plane)
{
    Key key;
    key.add(std::uint64_t(bits_version()));
    key.add(batch.mesh_key);
    key.add(batch.report.backend);
    for (const std::string& text : {batch.output.prefix, batch.output.format, job.name}) key.add(text);
    key.add(std::uint64_t(batch.output.keep ? 1 + static_cast<unsigned>(*batch.output.keep) : 0));
    const Vec3d normal = plane.normal();
    for (const double number : {normal.x, normal.y, normal.z, plane.offset(), job.cut.gap}) key.add(number);
    key.add(std::uint64_t(job.cut.cap) + 2 * std::uint64_t(job.cut.components) +
            4 * static_cast<std::uint64_t>(job.cut.cap_quality));
    if (job.cut.only) {
        const Vec3d& near = job.cut.only->point;
        for (const double number : {near.x, near.y, near.z}) key.add(number);
        key.add(static_cast<std::uint64_t>(job.cut.only->extent));
    }
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(key.value()));
    return digits;
}

/// What became of a job: a line, and what counts at the end.
struct Done
{
    std::string line;
    bool has_failed = false, has_missed = false;
};

/// Makes a cut and writes its files.
Done perform(const CutBatch& batch, std::size_t i)
{
    const CutJob& job = batch.jobs[i];
    CutReport report = batch.report;
    report.plane = job.cut.plane_in(batch.bounds);
    Json line{{"job", i + 1}, {"name", job.name}, {"key", key_of(batch, job, report.plane)}};
    Cut cut = cut_copy(batch.object, report.plane, job.cut.options());
    report.take(cut);
    Done done;
    if (cut.status == Status::out_of_memory) throw std::bad_alloc();
    if (ok(cut.status)) {
        CutOutput output = batch.output;
        output.prefix += "." + job.name;
        MeshFileSet files(batch.read);
        add_pieces(files, output, job.cut.components, cut, report);
        check(files.commit());
    }
    done.has_missed = cut.status == Status::missed;
    done.has_failed = !ok(cut.status) && !done.has_missed;
    line.update(cut_json(report));
    if (done.has_failed) line["error"] = cut.reason();
    done.line = line_text(line);
    return done;
}

/// Lines of an earlier run.
class EarlierResults
{
public:
    EarlierResults(const std::string& path, const CutBatch& batch) : path_(path)
    {
        std::ifstream file(path, std::ios::binary);
        for (std::string line; std::getline(file, line) && !file.eof();) {
            // The last line may be half a one: then it has no end, or its files are not there.
            if (count_ == batch.jobs.size() || !is_of(line, batch)) break;
            ++count_;
            bytes_ += line.size() + 1;
        }
    }

    std::size_t count() const { return count_; }
    std::size_t missed() const { return missed_; }
    std::size_t failed() const { return failed_; }
    /// Only those lines are left.
    void keep() const
    {
        if (std::filesystem::exists(path_)) std::filesystem::resize_file(path_, bytes_);
    }

private:
    bool is_of(const std::string& line, const CutBatch& batch)
    {
        const Json json = Json::parse(line, nullptr, false);
        const CutJob& job = batch.jobs[count_];
        if (!json.is_object() || json.value("key", "") != key_of(batch, job, job.cut.plane_in(batch.bounds)))
            throw FileError(path_ + ": line " + std::to_string(count_ + 1) +
                            " is no result of this job; name another file of results, or remove it");
        for (const char* side : {"positive", "negative"}) {
            if (!json.contains(side)) continue;
            for (const Json& piece : json[side]["pieces"])
                if (!std::filesystem::exists(piece["file"].get<std::string>())) return false;
        }
        missed_ += json.value("status", "") == "missed";
        failed_ += json.contains("error");
        return true;
    }

    std::string path_;
    std::size_t count_ = 0, missed_ = 0, failed_ = 0;
    std::uintmax_t bytes_ = 0;
};

/// Where lines go, each at once.
class Results
{
public:
    explicit Results(const std::string& path) : path_(path)
    {
        if (path.empty()) return;
        file_.open(path, std::ios::binary | std::ios::app);
        if (!file_) throw FileError(path + ": it can't be written");
    }
    void add(const std::string& line)
    {
        if (path_.empty()) {
            print(line);
            return;
        }
        if (!(file_ << line << std::flush)) throw FileError(path_ + ": it can't be written");
    }

private:
    std::string path_;
    std::ofstream file_;
};

}  // namespace

std::uint64_t key_of(const Mesh& mesh)
{
    Key key;
    const MeshArrays arrays = mesh.arrays();
    key.add(std::as_bytes(arrays.positions));
    key.add(std::as_bytes(arrays.normals));
    key.add(std::as_bytes(arrays.uvs));
    key.add(std::as_bytes(arrays.indices));
    key.add(std::as_bytes(arrays.triangle_materials));
    for (std::size_t i = 0; i < mesh.stream_count(); ++i) key.add(std::as_bytes(mesh.stream(i).values));
    return key.value();
}

void run_jobs(const CutBatch& batch, const BatchOptions& options, bool must_cut)
{
    const std::size_t count = batch.jobs.size();
    const EarlierResults earlier(options.results, batch);
    earlier.keep();
    Results results(options.results);
    std::size_t missed = earlier.missed(), failed = earlier.failed();
    const std::size_t first = earlier.count();
    ProgressLine progress("cuts");
    in_order(
        count - first, thread_count(options.threads), [&](std::size_t i) { return perform(batch, first + i); },
        [&](std::size_t i, const Done& done) {
            results.add(done.line);
            missed += done.has_missed;
            failed += done.has_failed;
            progress.show(double(first + i + 1) / double(count));
        });
    if (failed > 0)
        throw std::runtime_error(grouped(failed) + " of " + counted(count, "job") + " failed: their lines say why");
    if (must_cut && missed > 0)
        throw NothingToCut(grouped(missed) + " of " + counted(count, "plane") + " did not divide " + batch.report.file);
}

}  // namespace kerf::tools
