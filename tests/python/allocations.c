/* Counts what is allocated and freed within calls; preloaded into the process of allocations.py (glibc). */

#include <errno.h>
#include <stddef.h>

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);
void *__libc_memalign(size_t, size_t);
void __libc_free(void *);

static __thread long counting, count;

#define COUNTED(call) do { if (counting) ++count; return call; } while (0)

void *malloc(size_t n) { COUNTED(__libc_malloc(n)); }
void *calloc(size_t n, size_t size) { COUNTED(__libc_calloc(n, size)); }
void *realloc(void *old, size_t n) { COUNTED(__libc_realloc(old, n)); }
void *memalign(size_t to, size_t n) { COUNTED(__libc_memalign(to, n)); }
void *aligned_alloc(size_t to, size_t n) { COUNTED(__libc_memalign(to, n)); }
void free(void *old) { if (counting && old) ++count; __libc_free(old); }

int posix_memalign(void **place, size_t to, size_t n) {
    if (counting) ++count;
    *place = __libc_memalign(to, n);
    return *place ? 0 : ENOMEM;
}

/* The status of a step, and how often it allocates or frees. FMI 2.0 has the first four arguments only, which the
   calling conventions of x86_64 and aarch64 pass alike. */
typedef int Step(void *, double, double, int, void *, void *, void *, void *);
int counted_step(Step *step, void *instance, double time, double size, char *flags, double *last, long *counted) {
    count = 0;
    counting = 1;
    int status = step(instance, time, size, 1, flags, flags + 1, flags + 2, last);
    counting = 0;
    *counted = count;
    return status;
}

/* The same for a call whose arguments are pointers and lengths. */
typedef int Call(void *, void *, void *, void *, void *, void *, void *);
int counted_call(Call *call, void *a, void *b, void *c, void *d, void *e, void *f, void *g, long *counted) {
    count = 0;
    counting = 1;
    int status = call(a, b, c, d, e, f, g);
    counting = 0;
    *counted = count;
    return status;
}
