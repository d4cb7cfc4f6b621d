/* A file is read, cut and written, and its section measured, in C99. */
#include <kerf/c.h>
#include <stdio.h>

static int complain(const char* what, kerf_status status, const char* reason)
{
    fprintf(stderr, "%s: %s%s%s\n", what, kerf_status_text(status), *reason != '\0' ? ": " : "", reason);
    return 1;
}

/* Writes a piece and says what it is. */
static int keep(kerf_object* piece, const char* path)
{
    char reason[200];
    kerf_object_facts facts = {.size = sizeof facts};
    kerf_mesh* mesh = NULL;
    kerf_status status = kerf_object_get_mesh(piece, &mesh);
    if (status != KERF_DONE) return complain(path, status, "");
    status = kerf_mesh_write(mesh, path, reason, sizeof reason);
    kerf_free(mesh);
    if (status != KERF_DONE) return complain(path, status, reason);
    kerf_object_get_facts(piece, &facts);
    printf("%s: %lu triangles, volume %g\n", path, (unsigned long)facts.triangle_count, facts.volume);
    return 0;
}

int main(int argc, char** argv)
{
    char reason[200];
    kerf_mesh* mesh = NULL;
    kerf_object* object = NULL;
    kerf_section* section = NULL;
    kerf_pieces* pieces = NULL;
    kerf_object_facts facts = {.size = sizeof facts};
    kerf_section_arrays outline = {.size = sizeof outline};
    kerf_plane plane = {.size = sizeof plane};
    kerf_status status;
    int side, failed = 0;

    if (argc != 2) return complain("usage", KERF_INVALID_ARGUMENT, "name a mesh file");
    status = kerf_mesh_read(argv[1], &mesh, reason, sizeof reason);
    if (status != KERF_DONE) return complain("reading", status, reason);
    status = kerf_prepare(mesh, NULL, &object, reason, sizeof reason);
    kerf_free(mesh);
    if (status != KERF_DONE) return complain("preparing", status, reason);

    /* Through the middle, across y. */
    kerf_object_get_facts(object, &facts);
    plane.normal[1] = 1.0;
    for (side = 0; side < 3; ++side) plane.point[side] = 0.5 * ((double)facts.lo[side] + facts.hi[side]);

    /* What the plane meets; the object stays. */
    status = kerf_section_find(object, &plane, NULL, &section, reason, sizeof reason);
    if (status == KERF_DONE && kerf_section_get_arrays(section, &outline) == KERF_DONE)
        printf("section: %lu loops, area %g\n", (unsigned long)outline.path_count, outline.area);
    kerf_free(section);

    /* The pieces take the object's place. */
    status = kerf_cut(&object, &plane, NULL, &pieces, reason, sizeof reason);
    if (status != KERF_DONE && status != KERF_OPEN_SECTION) failed = complain("cutting", status, reason);
    for (side = KERF_NEGATIVE; side <= KERF_POSITIVE && !failed; ++side) {
        kerf_object* piece = kerf_pieces_take(pieces, side, 0);
        failed = keep(piece, side == KERF_POSITIVE ? "top.obj" : "bottom.obj");
        kerf_free(piece);
    }
    kerf_free(pieces);
    kerf_free(object);
    return failed;
}
