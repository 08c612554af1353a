/* The foreign FMU for FMI 3.0: only the functions that co-simulation needs, Booleans that are neither 0 nor 1. */

#include <stdint.h>

#include "foreign.h"

typedef void (*Logger)(void *, int, const char *, const char *);

const char *fmi3GetVersion(void) { return "3.0"; }

void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources, uint8_t visible,
                                  uint8_t logging, uint8_t event_mode, uint8_t early_return, const uint32_t *required,
                                  size_t n_required, void *environment, Logger logger, void *update) {
    Model *m = model_new(name, token, environment);
    (void)visible, (void)event_mode, (void)early_return, (void)required, (void)n_required, (void)update;
    if (!m) return NULL;
    m->logger = (void *)logger;
    if (m->wrong_token) {
        logger(environment, 3, NULL, "wrong token");
        free(m);
        return NULL;
    }
    if (logging) logger(environment, 0, "logAll", resources);
    return m;
}
void fmi3FreeInstance(void *c) { free(c); }
int fmi3SetDebugLogging(void *c, uint8_t on, size_t n, const char *const *categories) {
    model_log(c, on, n, categories);
    return 0;
}
int fmi3EnterInitializationMode(void *c, uint8_t d, double t, double s, uint8_t e, double p) {
    (void)c, (void)d, (void)t, (void)s, (void)e, (void)p;
    return 0;
}
int fmi3ExitInitializationMode(void *c) { (void)c; return 0; }
int fmi3Terminate(void *c) { (void)c; return 0; }
int fmi3Reset(void *c) {
    Model *m = c;
    m->x = m->x_start = m->rate = 0, m->counter = 0;
    return 0;
}
int fmi3GetFloat64(void *c, const uint32_t *vr, size_t n, double *v, size_t nv) {
    Model *m = c;
    (void)nv;
    for (size_t i = 0; i < n; i++)
        if (vr[i] == FACTORS || vr[i] == SCALED)
            for (int k = 0; k < 3; k++) *v++ = m->factors[k] * (vr[i] == SCALED ? m->x : 1);
        else
            *v++ = model_get(m, vr[i]);
    return 0;
}
int fmi3SetFloat64(void *c, const uint32_t *vr, size_t n, const double *v, size_t nv) {
    Model *m = c;
    (void)nv;
    for (size_t i = 0; i < n; i++)
        if (vr[i] == FACTORS)
            for (int k = 0; k < 3; k++) m->factors[k] = *v++;
        else if (model_set(m, vr[i], *v++)) {
            ((Logger)m->logger)(m->environment, 3, "logStatusError", "the value is below 0");
            return 3;
        }
    return 0;
}
int fmi3GetInt8(void *c, const uint32_t *vr, size_t n, int8_t *v, size_t nv) {
    (void)vr, (void)nv;
    for (size_t i = 0; i < n; i++) v[i] = (int8_t)((Model *)c)->counter;
    return 0;
}
int fmi3SetInt8(void *c, const uint32_t *vr, size_t n, const int8_t *v, size_t nv) {
    (void)vr, (void)nv;
    for (size_t i = 0; i < n; i++) ((Model *)c)->counter = v[i];
    return 0;
}
int fmi3GetBoolean(void *c, const uint32_t *vr, size_t n, uint8_t *v, size_t nv) {
    (void)vr, (void)nv;
    for (size_t i = 0; i < n; i++) v[i] = ((Model *)c)->rate != 0 ? 0xAA : 0;
    return 0;
}
int fmi3GetString(void *c, const uint32_t *vr, size_t n, const char **v, size_t nv) {
    (void)vr, (void)nv;
    for (size_t i = 0; i < n; i++) v[i] = ((Model *)c)->label;
    return 0;
}
int fmi3SetString(void *c, const uint32_t *vr, size_t n, const char *const *v, size_t nv) {
    (void)vr, (void)nv;
    for (size_t i = 0; i < n; i++) strncpy(((Model *)c)->label, v[i], 63);
    return 0;
}
int fmi3DoStep(void *c, double t, double h, uint8_t no_set, uint8_t *event, uint8_t *terminate, uint8_t *early,
               double *last) {
    Model *m = c;
    int status = model_step(m, h);
    (void)no_set;
    *event = *early = 0;
    *terminate = status == 5;
    *last = status == 2 ? t : t + h;
    if (status == 2 && m->log_discard) ((Logger)m->logger)(m->environment, 2, "logStatusDiscard", "rate is no number");
    return status == 5 ? 0 : status;
}
