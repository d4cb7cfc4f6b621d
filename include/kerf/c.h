#ifndef KERF_C_H
#define KERF_C_H

// The library for C, and for every language that calls C. C99; nothing here throws.
//
// Handles. What a function makes belongs to the caller, who gives it to kerf_free(). What a function only names (arrays,
// texts) belongs to the handle that was asked and ends with it.
//
// Structs begin with their size. Callers set it to sizeof of what they were compiled with, and the rest to 0, which stands
// for the default of every member: `kerf_cut_options options = {.size = sizeof options};`. A library takes the structs of programs
// that were compiled with an older kerf/c.h, and says KERF_INVALID_ARGUMENT to those of a newer one.
//
// Reasons. A function that takes `reason` writes one sentence for people into it if it says something else than KERF_DONE,
// and "" otherwise; as much as fits, and always a 0 at the end. It may be null.
//
// Null. A null handle, struct or output is KERF_INVALID_ARGUMENT, if the comment says nothing else.
//
// Threads as in kerf/object.h: any number may read a handle, one at a time may change it.

#include <stddef.h>
#include <stdint.h>

#if defined(KERF_STATIC)
#define KERF_C_API
#elif defined(_WIN32)
#if defined(KERF_BUILDING)
#define KERF_C_API __declspec(dllexport)
#else
#define KERF_C_API __declspec(dllimport)
#endif
#else
#define KERF_C_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// What became of a call. Numbers never change; new ones are added at the end.
typedef int32_t kerf_status;
enum
{
    KERF_DONE = 0,              ///< it did what was asked for
    KERF_MISSED = 1,            ///< of a cut: the plane does not go through the object, which stays as it was
    KERF_OPEN_SECTION = 2,      ///< done, but the mesh has holes where the plane meets it, and these stay open
    KERF_INVALID_ARGUMENT = 3,  ///< an argument says something that can't be; nothing was done
    KERF_INVALID_MESH = 4,      ///< what was given is no mesh that can be cut; nothing was done
    KERF_OUT_OF_MEMORY = 5,     ///< nothing was done
    KERF_CANCELLED = 6,         ///< the caller asked to stop; nothing was done
    KERF_UNUSABLE_FILE = 7,     ///< a file that can't be read or written; nothing was done
    KERF_NOT_SEPARATED = 8      ///< of a cut: what was chosen does not part the object; nothing was done
};

/// No index: of a cap's triangle the source, of an outer loop the parent.
#define KERF_NONE UINT32_MAX

/// The sides of a plane: where its normal points to is the positive one.
enum
{
    KERF_NEGATIVE = 0,
    KERF_POSITIVE = 1
};

typedef struct kerf_mesh kerf_mesh;          ///< triangles that can be cut; can't be changed
typedef struct kerf_object kerf_object;      ///< what is cut: a prepared mesh, or a piece of one
typedef struct kerf_pieces kerf_pieces;      ///< what a cut yields
typedef struct kerf_section kerf_section;    ///< what a plane meets of an object
typedef struct kerf_draw kerf_draw;          ///< what to draw of an object
typedef struct kerf_fracture kerf_fracture;  ///< the pieces of an object that was broken

/// The version of the library that the program runs with: "0.2.0". Never null.
KERF_C_API const char* kerf_version(void);
/// The same object, plane and options give the same bytes as long as this number stays (kerf/version.h).
KERF_C_API uint32_t kerf_bits_version(void);
/// "done", "missed", ...; "unknown" for a number that is none of them. Never null.
KERF_C_API const char* kerf_status_text(kerf_status status);
/// Ends a handle of any kind. Null is nothing.
KERF_C_API void kerf_free(void* handle);

/// Further numbers of each vertex: colours, tangents, anything.
typedef struct kerf_stream
{
    uint32_t size;        ///< sizeof(kerf_stream)
    uint32_t width;       ///< floats of a vertex, 1 to 16
    const char* name;     ///< UTF-8
    const float* values;  ///< `width` for each vertex, one after another
} kerf_stream;

/// How a material looks, for programs that draw or write files; a cut looks at none of it.
typedef struct kerf_material
{
    uint32_t size;         ///< sizeof(kerf_material)
    float base_colour[4];  ///< linear, with alpha; all 0: white
    const char* name;      ///< UTF-8; may be null
    const char* image;     ///< a file name of the base colour's image; may be null
} kerf_material;

/// A mesh as a program holds it: plain arrays, borrowed for the call and only read. Vertices with the same coordinates, bit
/// for bit, are one place of the surface, whatever their indices.
typedef struct kerf_mesh_input
{
    uint32_t size;                       ///< sizeof(kerf_mesh_input)
    float crease_degrees;                ///< if normals are made: edges that turn by more stay sharp; 0: 40; up to 180
    const float* positions;              ///< three for each vertex, in the caller's unit of length
    size_t position_stride;              ///< bytes from vertex to vertex; 0: 12
    size_t vertex_count;                 ///< below 2^32 - 1
    const uint32_t* indices;             ///< three for each triangle, counter-clockwise seen from outside; null: each
                                         ///< three vertices are a triangle
    size_t triangle_count;               ///< below 2^32 / 3
    const float* normals;                ///< three for each vertex; null: smooth ones are made
    size_t normal_stride;                ///< bytes from vertex to vertex; 0: 12
    const float* uvs;                    ///< two for each vertex; null: all 0
    size_t uv_stride;                    ///< bytes from vertex to vertex; 0: 8
    const uint32_t* triangle_materials;  ///< one for each triangle; null: all 0
    const kerf_material* materials;      ///< null: one without a name
    size_t material_count;               ///< of `materials`
    const kerf_stream* streams;          ///< further numbers of each vertex; may be null
    size_t stream_count;                 ///< of `streams`
} kerf_mesh_input;

/// Makes a mesh of arrays, and repairs it: kerf::Mesh::make(). Nothing of that moves a vertex. O(n log n).
/// Status: KERF_INVALID_MESH with a reason that names the first fault, KERF_INVALID_ARGUMENT, KERF_OUT_OF_MEMORY.
KERF_C_API kerf_status kerf_mesh_make(const kerf_mesh_input* input, kerf_mesh** mesh, char* reason, size_t reason_size);

/// Reads and repairs a file: OBJ, PLY, STL, OFF, glTF, GLB, by its extension. `path` is UTF-8. O(n log n).
/// Status: KERF_UNUSABLE_FILE with a reason, KERF_INVALID_ARGUMENT, KERF_OUT_OF_MEMORY.
KERF_C_API kerf_status kerf_mesh_read(const char* path, kerf_mesh** mesh, char* reason, size_t reason_size);

/// Writes OBJ, PLY, STL, OFF or GLB, by the extension. The file appears complete or not at all. O(n).
/// Status: KERF_UNUSABLE_FILE with a reason, KERF_INVALID_ARGUMENT, KERF_OUT_OF_MEMORY.
KERF_C_API kerf_status kerf_mesh_write(const kerf_mesh* mesh, const char* path, char* reason, size_t reason_size);

/// The arrays of a mesh. They live as long as the mesh.
typedef struct kerf_mesh_arrays
{
    uint32_t size;                       ///< sizeof(kerf_mesh_arrays)
    uint32_t point_count;                ///< how many places of the surface there are
    size_t vertex_count;                 ///< a place with a seam has several vertices
    size_t triangle_count;               ///< without those that were dropped as degenerate or double
    const float* positions;              ///< three for each vertex
    const float* normals;                ///< three for each vertex, of length 1
    const float* uvs;                    ///< two for each vertex
    const uint32_t* points;              ///< for each vertex the place on the surface that it is at
    const uint32_t* indices;             ///< three for each triangle
    const uint32_t* sources;             ///< for each triangle that of the input; KERF_NONE of a cap
    const uint32_t* triangle_materials;  ///< for each triangle
    const uint32_t* solids;              ///< for each triangle the body that it bounds
    const uint8_t* is_cap;               ///< for each triangle 1 if it closes a section, otherwise 0
    size_t stream_count;                 ///< of kerf_mesh_get_stream()
} kerf_mesh_arrays;

/// O(n) at the first call for a mesh, O(1) then. Status: KERF_OUT_OF_MEMORY, KERF_INVALID_ARGUMENT.
KERF_C_API kerf_status kerf_mesh_get_arrays(const kerf_mesh* mesh, kerf_mesh_arrays* arrays);
/// Stream `i`, which lives as long as the mesh. Status: KERF_INVALID_ARGUMENT also if there is none of that number.
KERF_C_API kerf_status kerf_mesh_get_stream(const kerf_mesh* mesh, size_t i, kerf_stream* stream);

/// A plane, through a point, with the positive side where the normal points to. The normal has any length but 0.
typedef struct kerf_plane
{
    uint32_t size;     ///< sizeof(kerf_plane)
    double point[3];   ///< a place that it goes through, in the mesh's unit
    double normal[3];  ///< the direction in which the positive side lies
} kerf_plane;

/// The plane of the world as the object sees it that the matrix places there, column by column as OpenGL has it. The sides
/// stay those of the world. Status: KERF_INVALID_ARGUMENT also if the matrix has no inverse or is no affine one.
KERF_C_API kerf_status kerf_plane_to_local(const kerf_plane* world, const double object_to_world[16],
                                           kerf_plane* local);

/// Options of kerf_prepare().
typedef struct kerf_prepare_options
{
    uint32_t size;           ///< sizeof(kerf_prepare_options)
    uint32_t threads;        ///< that may work at it; 0: one
    const char* back_end;    ///< "halfedge", "linear", ...; null: chosen by `cuts_expected`
    uint32_t cuts_expected;  ///< how many times the object and its pieces will be cut, about; 0: 1000
    /// For how many cuts there is room from the start, in memory that was touched; 0: one.
    uint32_t cuts_with_room;
    /// Called now and then with the share that is done, 0 first, 1 last. Returns 0 to stop. May be null.
    int (*progress)(void* user, double share);
    void* user;  ///< for `progress`
} kerf_prepare_options;

/// Makes an object of a mesh, which stays. O(n). Status: KERF_INVALID_ARGUMENT (also a back end that this build lacks),
/// KERF_CANCELLED, KERF_OUT_OF_MEMORY.
/// @param options  may be null
KERF_C_API kerf_status kerf_prepare(const kerf_mesh* mesh, const kerf_prepare_options* options, kerf_object** object,
                                    char* reason, size_t reason_size);

/// An independent copy of an object: a copy of memory, not a kerf_prepare(). O(n). Status: KERF_OUT_OF_MEMORY.
KERF_C_API kerf_status kerf_object_clone(const kerf_object* object, kerf_object** copy);

/// Facts of an object.
typedef struct kerf_object_facts
{
    uint32_t size;             ///< sizeof(kerf_object_facts)
    int32_t is_solid;          ///< 1 if the surface is known to bound a solid, otherwise 0
    uint64_t triangle_count;   ///< with caps
    float lo[3];               ///< least coordinates
    float hi[3];               ///< largest coordinates
    double volume;             ///< in the unit of length, cubed
    double centre_of_mass[3];  ///< of the bounds if there is no volume
    double inertia[9];         ///< of density 1, about the centre of mass; column by column
    const char* back_end;      ///< the name of the one that cuts it
} kerf_object_facts;

/// O(log n) with the half-edge back end, O(n) with the linear one.
KERF_C_API kerf_status kerf_object_get_facts(const kerf_object* object, kerf_object_facts* facts);
/// A compact copy of the triangles. O(n). Status: KERF_OUT_OF_MEMORY.
KERF_C_API kerf_status kerf_object_get_mesh(const kerf_object* object, kerf_mesh** mesh);

/// Options of kerf_cut().
typedef struct kerf_cut_options
{
    uint32_t size;          ///< sizeof(kerf_cut_options)
    int32_t leave_open;     ///< 0: sections are closed by caps
    int32_t components;     ///< 0: one piece a side; 1: its connected pieces
    uint32_t cap_material;  ///< of the caps, and one more: 0: one is added, "cap"; 1: material 0, ...
    double cap_uv_scale;    ///< uv of a cap for each unit of length; 0: 1
    double gap;             ///< width of the blade: what lies within half of it is taken away
    int32_t delaunay;       ///< 1: caps are constrained Delaunay triangulations, which needs the component caps_cgal
} kerf_cut_options;

/// Cuts an object by a plane, in the object's own coordinates. If it was cut, the pieces take its place: `*object` is null
/// then, and otherwise stays as it was. Half-edge back end: O(s log n + k) for a section of k triangles in s leaves of the
/// tree; linear: O(n). Status: KERF_DONE, KERF_OPEN_SECTION, KERF_MISSED, KERF_INVALID_ARGUMENT, KERF_OUT_OF_MEMORY (with a
/// gap there may be pieces then: those of the first of two cuts).
/// @param options  may be null
/// @param pieces   receives a handle if the object was cut or missed, otherwise null
KERF_C_API kerf_status kerf_cut(kerf_object** object, const kerf_plane* plane, const kerf_cut_options* options,
                                kerf_pieces** pieces, char* reason, size_t reason_size);

/// What a cut, or a miss, has to say.
typedef struct kerf_cut_facts
{
    uint32_t size;                ///< sizeof(kerf_cut_facts)
    kerf_status status;           ///< what kerf_cut() said
    size_t count[2];              ///< pieces by side; those that were taken, too
    double section_area;          ///< in the unit of length, squared
    int32_t side_of_object;       ///< of a miss: the side that the object lies on
    int32_t caps_exceed_section;  ///< 1: a warning; caps overlap, because the section crosses itself
    uint64_t crossing_triangles;  ///< with vertices strictly on both sides of the plane
    uint64_t triangles_touched;   ///< distinct triangle records read or written
    uint64_t section_loops;       ///< closed loops of the section
    uint64_t open_chains;         ///< polylines of the section that end at holes of the mesh
    double milliseconds;          ///< what it took
} kerf_cut_facts;

KERF_C_API kerf_status kerf_pieces_get_facts(const kerf_pieces* pieces, kerf_cut_facts* facts);
/// Piece `i` of a side, which belongs to the caller from then on; null beyond the last, and of one that was taken. What was
/// not taken ends with the handle.
KERF_C_API kerf_object* kerf_pieces_take(kerf_pieces* pieces, int32_t side, size_t i);

/// Options of kerf_section_find().
typedef struct kerf_section_options
{
    uint32_t size;  ///< sizeof(kerf_section_options)
    int32_t fill;   ///< 1: also the triangles that close it
    double up[3];   ///< the direction that points upwards in the section's frame; all 0: chosen (kerf/section.h)
} kerf_section_options;

/// What a plane meets of an object, which does not change, so that any number of threads may ask at once. Pass a section that
/// was used before, or one that is null, which is made then. Status: KERF_DONE, KERF_OPEN_SECTION, KERF_MISSED,
/// KERF_INVALID_ARGUMENT, KERF_OUT_OF_MEMORY.
/// @param options  may be null
KERF_C_API kerf_status kerf_section_find(const kerf_object* object, const kerf_plane* plane,
                                         const kerf_section_options* options, kerf_section** section, char* reason,
                                         size_t reason_size);

/// A section in flat arrays, which live until the section is found again or ends. Path p has the points from
/// path_starts[p] to path_starts[p + 1].
typedef struct kerf_section_arrays
{
    uint32_t size;              ///< sizeof(kerf_section_arrays)
    kerf_status status;         ///< what kerf_section_find() said
    double area;                ///< enclosed by all loops, holes taken away; in the unit of length, squared
    double length;              ///< of all paths, in the unit of length
    double centroid[3];         ///< of the enclosed area; of the outline, if nothing is enclosed
    double origin[3];           ///< of the section's frame: the place of the plane that is nearest to that of space
    double x[3];                ///< first axis of the frame: points to the right if y points upwards
    double y[3];                ///< second axis of the frame, seen from the positive side
    size_t path_count;          ///< loops and chains
    const size_t* path_starts;  ///< one more than paths
    const uint32_t* parents;    ///< for each path the smallest loop around it, or KERF_NONE
    const double* areas;        ///< for each path; negative of a hole, 0 of a chain
    const uint8_t* is_closed;   ///< for each path: 0 of a chain
    size_t point_count;         ///< those of the fill that are on no path stand behind the others
    const float* points;        ///< three for each
    const uint32_t* sources;  ///< for each point of a path the input triangle of the edge that begins there; KERF_NONE
                              ///< in a cap, and of a chain's last point
    size_t triangle_count;    ///< of the fill
    const uint32_t* triangles;  ///< of the fill: three points for each, counter-clockwise seen from the positive side
} kerf_section_arrays;

/// O(1). Status: KERF_INVALID_ARGUMENT.
KERF_C_API kerf_status kerf_section_get_arrays(const kerf_section* section, kerf_section_arrays* arrays);

/// Where the cells of kerf_fracture_make() lie (kerf/fracture.h).
enum
{
    KERF_UNIFORM = 0,   ///< anywhere in the object
    KERF_IMPACT = 1,    ///< the nearer to a point, the smaller
    KERF_CRACK = 2,     ///< the nearer to a plane, the smaller
    KERF_GRID = 3,      ///< in rows and layers, each moved a little
    KERF_SPLINTERS = 4  ///< long, along a direction
};

/// Options of kerf_fracture_make().
typedef struct kerf_fracture_options
{
    uint32_t size;        ///< sizeof(kerf_fracture_options)
    int32_t pattern;      ///< KERF_UNIFORM, ...
    uint32_t cells;       ///< how many; 0: 50
    int32_t has_at;       ///< 1: `at` is given; 0: the middle of the box is meant
    double at[3];         ///< of an impact; on the plane of a crack; in the middle of splinters
    double direction[3];  ///< across the plane of a crack; along splinters; all 0: y
    uint64_t seed;        ///< another one, other cells; the same one, the same bytes, on every machine
    const double* sites;  ///< of the cells, three for each, instead of a pattern; may be null
    size_t site_count;    ///< of `sites`
    double least_volume;  ///< a piece that is smaller is joined to the largest of its neighbours
    double uv_scale;      ///< uv of the inside for each unit of length; 0: 1
    uint32_t material;    ///< of the inside, and one more: 0: one is added, "cap"; 1: material 0, ...
    uint32_t reserved;    ///< 0
    /// Called now and then with the share that is done, 0 first, 1 last. Returns 0 to stop. May be null.
    int (*progress)(void* user, double share);
    void* user;  ///< for `progress`
} kerf_fracture_options;

/// Breaks a closed object into the cells of points: kerf::fracture(), which says what it costs. The object stays. Status:
/// KERF_DONE, KERF_INVALID_ARGUMENT, KERF_INVALID_MESH (it is open, or its surface passes through itself where cells meet),
/// KERF_CANCELLED, KERF_OUT_OF_MEMORY.
/// @param options   may be null
/// @param fracture  receives a handle if there are pieces, otherwise null
KERF_C_API kerf_status kerf_fracture_make(const kerf_object* object, const kerf_fracture_options* options,
                                          kerf_fracture** fracture, char* reason, size_t reason_size);

/// How pieces hang together, in flat arrays, which live as long as the fracture. Piece p consists of the cells from
/// cell_starts[p] to cell_starts[p + 1]. A bond is where two pieces touch: both are closed there by the same triangles,
/// those of the second turned over.
typedef struct kerf_fracture_arrays
{
    uint32_t size;              ///< sizeof(kerf_fracture_arrays)
    uint32_t reserved;          ///< 0
    size_t piece_count;         ///< those that were taken, too
    const size_t* cell_starts;  ///< one more than pieces
    const uint32_t* cells;      ///< ascending within a piece; one for each, unless small ones were joined
    size_t site_count;          ///< of all cells, also those in which nothing of the object lies
    const double* sites;        ///< three for each
    size_t bond_count;          ///< pairs of pieces that touch
    const uint32_t* bonds;      ///< two pieces for each, the first the smaller number
    const double* areas;        ///< for each bond, in the unit of length, squared
    const double* centres;      ///< three for each bond: of that area
    const double* normals;      ///< three for each bond: from its first piece to its second
} kerf_fracture_arrays;

/// O(1). Status: KERF_INVALID_ARGUMENT.
KERF_C_API kerf_status kerf_fracture_get_arrays(const kerf_fracture* fracture, kerf_fracture_arrays* arrays);
/// Piece `i`, which belongs to the caller from then on; null beyond the last, and of one that was taken. What was not taken
/// ends with the handle.
KERF_C_API kerf_object* kerf_fracture_take(kerf_fracture* fracture, size_t i);

/// Vertices and indices for the GPU (kerf/draw.h), which live until the object changes or ends. Objects that share buffers
/// have the same number, vertices and indices, and ranges of their own.
typedef struct kerf_draw_arrays
{
    uint32_t size;             ///< sizeof(kerf_draw_arrays)
    uint32_t reserved;         ///< 0
    uint64_t buffers;          ///< a number that no other buffers of the program ever get
    size_t vertex_count;       ///< of the whole vertex buffer
    size_t index_count;        ///< of the whole index buffer
    const float* vertices;     ///< eight for each: position, normal, uv
    const uint32_t* indices;   ///< three for each triangle
    size_t new_vertices_from;  ///< what stands before is on the GPU, as kerf_object_mark_uploaded() was told
    size_t new_indices_from;   ///< the same of indices
    size_t range_count;        ///< of `ranges`
    const uint32_t* ranges;    ///< four for each: first index, how many, material, and 1 for caps
} kerf_draw_arrays;

/// What to draw. Pass one that was used before, or one that is null, which is made then. Status: KERF_INVALID_ARGUMENT,
/// KERF_OUT_OF_MEMORY.
KERF_C_API kerf_status kerf_object_draw(const kerf_object* object, kerf_draw** draw);
/// O(1). Status: KERF_INVALID_ARGUMENT.
KERF_C_API kerf_status kerf_draw_get_arrays(const kerf_draw* draw, kerf_draw_arrays* arrays);
/// What `draw` calls new is on the GPU now. Status: KERF_INVALID_ARGUMENT.
KERF_C_API kerf_status kerf_object_mark_uploaded(kerf_object* object, const kerf_draw* draw);

#ifdef __cplusplus
}
#endif

#endif
