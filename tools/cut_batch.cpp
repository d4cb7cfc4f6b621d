#include "tools/cut_batch.h"

#include <kerf/version.h>

#include <span>
#include <stdexcept>

#include "tools/batch_results.h"
#include "tools/commands.h"
#include "tools/content_key.h"
#include "tools/in_order.h"
#include "tools/progress_line.h"

namespace kerf::tools {

namespace {

/// What the files of a job depend on.
std::string key_of_job(const CutBatch& batch, const CutJob& job, const Plane& plane)
{
    ContentKey key;
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
    return key.text();
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
    Json line{{"job", i + 1}, {"name", job.name}, {"key", key_of_job(batch, job, report.plane)}};
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
    for (const char* side : {"positive", "negative"})
        if (line.contains(side))
            for (Json& piece : line[side]["pieces"]) piece["key"] = key_of_file(piece["file"].get<std::string>());
    if (done.has_failed) line["error"] = cut.reason();
    done.line = line_text(line);
    return done;
}

}  // namespace

std::uint64_t key_of(const Mesh& mesh)
{
    ContentKey key;
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
    BatchResults results(options.results, batch.output.prefix);
    std::size_t first = 0, missed = 0, failed = 0;
    results.go_on(count, [&](std::size_t i) {
        const CutJob& job = batch.jobs[i];
        return key_of_job(batch, job, job.cut.plane_in(batch.bounds));
    });
    for (const Json& line : results.earlier()) {
        ++first;
        missed += line.value("status", "") == "missed";
        failed += line.contains("error");
    }
    ProgressLine progress("cuts");
    in_order(
        count - first, thread_count(options.threads), [&](std::size_t i) { return perform(batch, first + i); },
        [&](std::size_t i, const Done& done) {
            results.add(done.line);
            missed += done.has_missed;
            failed += done.has_failed;
            progress.show(double(first + i + 1) / double(count));
        });
    results.finish();
    if (failed > 0)
        throw std::runtime_error(grouped(failed) + " of " + counted(count, "job") + " failed: their lines say why");
    if (must_cut && missed > 0)
        throw NothingToCut(grouped(missed) + " of " + counted(count, "plane") + " did not divide " + batch.report.file);
}

}  // namespace kerf::tools
