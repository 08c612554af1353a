/* An FMU as somebody else might write it, shared by both versions: an integrator with a few oddities.
 *
 *   x' = rate, x(0) = x_start;  x, doubled = 2 rate (feeds through), counter = steps taken,
 *   moving = rate != 0 (any nonzero byte), label = text that was set
 */

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RATE, X, DOUBLED, X_START, COUNTER, MOVING, LABEL, FACTORS, SCALED };

typedef struct {
    double rate, x, x_start, factors[3];
    int counter, wrong_token, log_discard;
    char label[64], name[64];
    void *environment;
    void *logger;
} Model;

static Model *model_new(const char *name, const char *token, void *environment) {
    Model *m = calloc(1, sizeof *m);
    if (!m) return NULL;
    strncpy(m->name, name, sizeof m->name - 1);
    strcpy(m->label, "foreign");
    m->factors[0] = 1, m->factors[1] = 2, m->factors[2] = 3;
    m->wrong_token = strcmp(token, "{foreign}") != 0;
    m->environment = environment;
    return m;
}

static double model_get(const Model *m, unsigned vr) {
    return vr == RATE ? m->rate : vr == X ? m->x : vr == DOUBLED ? 2 * m->rate : m->x_start;
}

static int model_set(Model *m, unsigned vr, double value) {
    if (vr == RATE) m->rate = value;
    else if (vr == X_START && value >= 0) m->x_start = m->x = value;
    else return 3;
    return 0;
}

static void model_log(Model *m, int on, size_t n, const char *const *categories) {
    m->log_discard = on && n == 0;
    for (size_t i = 0; i < n; i++)
        if (on && strcmp(categories[i], "logStatusDiscard") == 0) m->log_discard = 1;
}

/* 0 OK, 2 Discard (the input is no number), 3 Error, 5 the model has come to its end */
static int model_step(Model *m, double h) {
    if (isnan(m->rate)) return 2;
    if (m->rate < -1e6) return 3;
    m->x += h * m->rate;
    m->counter += 1;
    return m->x > 1000 ? 5 : 0;
}
