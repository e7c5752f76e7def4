@STAMP@@INCLUDE@

#include <math.h>
#include <stddef.h>
#include <stdio.h>

@VALUES@

static int differs(const char *what, const @REAL@ *found, const double *expected, int length,
                   double tolerance)
{
    double largest = 1.0, worst = 0.0;
    for (int i = 0; i < length; i++) {
        largest = fmax(largest, fabs(expected[i]));
    }
    for (int i = 0; i < length; i++) {
        const double difference = fabs((double)found[i] - expected[i]);
        worst = difference <= worst ? worst : difference;
    }
    const int is_wrong = !(worst <= tolerance * largest);
    printf("%s %s (%.1e)\n", is_wrong ? "FAILED" : "ok", what, worst / largest);
    return is_wrong;
}

@TESTS@int main(void)
{
    int failures = 0;
    @PREFIX@_model model;
    @PREFIX@_parameters parameters = @PREFIX@_default_parameters();
@GIVEN@
    @PREFIX@_model_init(&model, &parameters);
@CALLS@
    return failures != 0;
}
