/* The foreign FMU for FMI 2.0: its logger is used printf-like, its Booleans are any int. */

#include "foreign.h"

typedef void (*Logger)(void *, const char *, int, const char *, const char *, ...);
typedef struct {
    Logger logger;
    void *allocate, *release, *finished, *environment;
} Callbacks;

static int stopped;

const char *fmi2GetVersion(void) { return "2.0"; }
const char *fmi2GetTypesPlatform(void) { return "default"; }

void *fmi2Instantiate(const char *name, int type, const char *guid, const char *resources, const Callbacks *callbacks,
                      int visible, int logging) {
    Model *m = model_new(name, guid, callbacks->environment);
    (void)visible;
    if (!m) return NULL;
    m->logger = (void *)callbacks->logger;
    if (m->wrong_token || type != 1) {
        callbacks->logger(m->environment, name, 3, "logStatusError", "wrong token %s, %d of %.2f", guid, 42, 2.5);
        free(m);
        return NULL;
    }
    if (logging) callbacks->logger(m->environment, name, 0, "logAll", "resources: %s", resources);
    return m;
}
void fmi2FreeInstance(void *c) { free(c); }
int fmi2SetDebugLogging(void *c, int on, size_t n, const char *const *categories) {
    model_log(c, on, n, categories);
    return 0;
}
int fmi2SetupExperiment(void *c, int d, double t, double s, int e, double p) {
    (void)c, (void)d, (void)t, (void)s, (void)e, (void)p;
    return 0;
}
int fmi2EnterInitializationMode(void *c) { (void)c; return 0; }
int fmi2ExitInitializationMode(void *c) { (void)c; return 0; }
int fmi2Terminate(void *c) { (void)c; return 0; }
int fmi2Reset(void *c) {
    Model *m = c;
    m->x = m->x_start = m->rate = 0, m->counter = 0;
    return 0;
}
int fmi2GetReal(void *c, const unsigned *vr, size_t n, double *v) {
    for (size_t i = 0; i < n; i++) v[i] = model_get(c, vr[i]);
    return 0;
}
int fmi2SetReal(void *c, const unsigned *vr, size_t n, const double *v) {
    Model *m = c;
    for (size_t i = 0; i < n; i++)
        if (model_set(m, vr[i], v[i])) {
            ((Logger)m->logger)(m->environment, m->name, 3, "logStatusError", "%g is below 0", v[i]);
            return 3;
        }
    return 0;
}
int fmi2GetInteger(void *c, const unsigned *vr, size_t n, int *v) {
    (void)vr;
    for (size_t i = 0; i < n; i++) v[i] = ((Model *)c)->counter;
    return 0;
}
int fmi2SetInteger(void *c, const unsigned *vr, size_t n, const int *v) {
    (void)vr;
    for (size_t i = 0; i < n; i++) ((Model *)c)->counter = v[i];
    return 0;
}
int fmi2GetBoolean(void *c, const unsigned *vr, size_t n, int *v) {
    (void)vr;
    for (size_t i = 0; i < n; i++) v[i] = ((Model *)c)->rate != 0 ? -7 : 0;
    return 0;
}
int fmi2GetString(void *c, const unsigned *vr, size_t n, const char **v) {
    (void)vr;
    for (size_t i = 0; i < n; i++) v[i] = ((Model *)c)->label;
    return 0;
}
int fmi2SetString(void *c, const unsigned *vr, size_t n, const char *const *v) {
    (void)vr;
    for (size_t i = 0; i < n; i++) strncpy(((Model *)c)->label, v[i], 63);
    return 0;
}
int fmi2DoStep(void *c, double t, double h, int no_set) {
    Model *m = c;
    int status = model_step(m, h);
    (void)t, (void)no_set;
    stopped = status == 5;
    if (status == 2 && m->log_discard)
        ((Logger)m->logger)(m->environment, m->name, 2, "logStatusDiscard", "rate is %f", m->rate);
    return status == 5 ? 2 : status;
}
int fmi2GetRealStatus(void *c, int kind, double *v) {
    *v = ((Model *)c)->counter * 0.5;
    return kind == 2 ? 0 : 2;
}
int fmi2GetBooleanStatus(void *c, int kind, int *v) {
    (void)c;
    *v = stopped;
    return kind == 3 ? 0 : 2;
}
