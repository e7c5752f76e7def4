#include "@PREFIX@.hpp"

typedef @PREFIX@::Model @PREFIX@_model;
typedef @PREFIX@::Model::Scalar @PREFIX@_real;
typedef @PREFIX@::Parameters @PREFIX@_parameters;

static @PREFIX@_parameters @PREFIX@_default_parameters() { return @PREFIX@_parameters(); }
static void @PREFIX@_model_init(@PREFIX@_model *m, const @PREFIX@_parameters *parameters)
{
    m->set(*parameters);
}
@CALLS@