/* A host that leaves GL state in any legal mess: objects of every kind, bound and set at random. Knows nothing of the library.
 */
#ifndef TEST_SCRAMBLE_H
#define TEST_SCRAMBLE_H

#include "state.h"

enum { HOST_TEXTURE_TARGETS = 11 };

typedef struct test_host {
    unsigned long long random;
    GLuint programs[4]; /* two plain ones, one that captures transform feedback, and one flagged for deletion or 0 */
    GLuint pipeline;
    GLuint vertex_arrays[3];
    GLuint buffers[4];
    GLuint textures[HOST_TEXTURE_TARGETS][2];
    GLuint samplers[2];
    GLuint framebuffers[3];
    GLuint renderbuffer;
    GLuint transform_feedback;
    GLuint queries[3]; /* any samples passed, primitives generated, transform feedback primitives written */
    bool transform_feedback_active;
    bool queries_active;
} test_host;

/* Makes the objects. */
void host_create(test_host *host);

/* Puts all state of the current context into a random but legal condition. The scissor of viewport 0 is what it says; the
 * program in use is flagged for deletion only if `allow_deleted_program`. */
void host_scramble(test_host *host, unsigned long long seed, bool allow_deleted_program);

/* The host's objects, for a comparison of states, but for its framebuffers. The arrays live as long as `host`. */
state_objects host_objects(const test_host *host);

/* Ends transform feedback and the queries. Returns how many primitives were captured since host_scramble. */
GLuint host_settle(test_host *host);

/* A number from 0 to count - 1. */
int host_random(test_host *host, int count);

/* Whether the context has program pipelines. */
bool has_pipelines(void);

/* A linked program: of the host's own, and of these shaders, without their version. */
GLuint build_host_program(void);
GLuint build_program(const char *vertex_shader, const char *fragment_shader, const char *feedback_varying);

#endif
