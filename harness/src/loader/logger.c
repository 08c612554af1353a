/* FMI 2.0's logger is variadic, which stable Rust cannot define: this formats the message and hands it on. */

#include <stdarg.h>
#include <stdio.h>

/* What the logger finds behind the component environment. */
struct swayless_environment {
    void (*take)(void *environment, const char *instance, int status, const char *category, const char *text);
};

void swayless_fmi2_logger(void *environment, const char *instance, int status, const char *category,
                          const char *format, ...) {
    char text[4096];
    va_list arguments;
    if (!environment || !format) return;
    va_start(arguments, format);
    /* An over-long message is cut off; a format that cannot be followed leaves an empty one. */
    if (vsnprintf(text, sizeof text, format, arguments) < 0) text[0] = '\0';
    va_end(arguments);
    ((struct swayless_environment *)environment)->take(environment, instance, status, category, text);
}
