/* What every compiled mechanism shares: arrays in, arrays out, one configuration or many.
 *
 * A kernel computes straight from the memory of float64 arrays of the right length: vectors, or
 * rows of one batch. Anything else, also what is not finite, goes to a function in Python, which
 * converts, broadcasts, or says what is wrong. The generated part follows this text.
 */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_1_7_API_VERSION
#include <Python.h>
#include <numpy/arrayobject.h>
#include <math.h>

#define MOST_ARGUMENTS 8
#define MOST_RESULTS 4
#define MOST_DIMENSIONS 3

typedef struct kernel {
    const char *name;
    int n_arguments;
    int accelerates; /* results that are not finite mean that nothing resists a motion */
    int n_results;
    const char *argument_names[MOST_ARGUMENTS];
    npy_intp lengths[MOST_ARGUMENTS];
    const double *defaults[MOST_ARGUMENTS]; /* for None; NULL where only Python knows */
    int dimensions[MOST_RESULTS];
    npy_intp shapes[MOST_RESULTS][MOST_DIMENSIONS];
    npy_intp sizes[MOST_RESULTS];
    void (*run)(const double *const *in, double *const *out);
    void (*run_many)(npy_intp n, const double *const *in, const npy_intp *strides,
                     double *const *out);
} kernel;

static const double ZEROS[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

static int is_finite(const double *x, npy_intp n)
{
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
    npy_intp i = 0;
    for (; i + 4 <= n; i += 4) {
        a += x[i] * 0.0;
        b += x[i + 1] * 0.0;
        c += x[i + 2] * 0.0;
        d += x[i + 3] * 0.0;
    }
    for (; i < n; i++) {
        a += x[i] * 0.0;
    }
    return a + b + c + d == 0.0;
}

/* Return the numbers of an array of vectors, or NULL if it needs a closer look. */
static const double *numbers(PyObject *object, npy_intp length, npy_intp *n, npy_intp *stride)
{
    PyArrayObject *array = (PyArrayObject *)object;
    int ndim;
    if (!PyArray_CheckExact(object) || PyArray_TYPE(array) != NPY_DOUBLE) {
        return NULL;
    }
    ndim = PyArray_NDIM(array);
    if (!PyArray_ISCARRAY_RO(array) || ndim < 1 || ndim > 2
        || PyArray_DIM(array, ndim - 1) != length) {
        return NULL;
    }
    *stride = 0;
    if (ndim == 2) {
        if (*n >= 0 && *n != PyArray_DIM(array, 0)) {
            return NULL;
        }
        *n = PyArray_DIM(array, 0);
        *stride = length;
    }
    if (!is_finite(PyArray_DATA(array), ndim == 2 ? *n * length : length)) {
        return NULL;
    }
    return PyArray_DATA(array);
}

static int is_result(PyObject *object, const kernel *k, int result, npy_intp n)
{
    PyArrayObject *array = (PyArrayObject *)object;
    int batch = n >= 0, d;
    if (!PyArray_CheckExact(object) || PyArray_TYPE(array) != NPY_DOUBLE
        || !PyArray_ISCARRAY(array) || PyArray_NDIM(array) != k->dimensions[result] + batch
        || (batch && PyArray_DIM(array, 0) != n)) {
        return 0;
    }
    for (d = 0; d < k->dimensions[result]; d++) {
        if (PyArray_DIM(array, d + batch) != k->shapes[result][d]) {
            return 0;
        }
    }
    return 1;
}

static PyObject *new_result(const kernel *k, int result, npy_intp n)
{
    npy_intp shape[MOST_DIMENSIONS + 1];
    int batch = n >= 0, d;
    shape[0] = n;
    for (d = 0; d < k->dimensions[result]; d++) {
        shape[d + batch] = k->shapes[result][d];
    }
    return PyArray_SimpleNew(k->dimensions[result] + batch, shape, NPY_DOUBLE);
}

/* Sort arguments by position and name; return 0 if Python should look at them. */
static int sorted(const kernel *k, PyObject *const *args, Py_ssize_t n_args, PyObject *names,
                  PyObject **found, PyObject **out)
{
    Py_ssize_t i, n_names = names == NULL ? 0 : PyTuple_GET_SIZE(names);
    int a;
    if (n_args > k->n_arguments) {
        return 0;
    }
    for (i = 0; i < n_args; i++) {
        found[i] = args[i];
    }
    for (i = 0; i < n_names; i++) {
        PyObject *name = PyTuple_GET_ITEM(names, i);
        if (PyUnicode_CompareWithASCIIString(name, "out") == 0) {
            *out = args[n_args + i];
            continue;
        }
        for (a = (int)n_args; a < k->n_arguments; a++) {
            if (PyUnicode_CompareWithASCIIString(name, k->argument_names[a]) == 0) {
                break;
            }
        }
        if (a == k->n_arguments || found[a] != NULL) {
            return 0;
        }
        found[a] = args[n_args + i];
    }
    return 1;
}

/* Fill the results' slots with given or new arrays; return 0 for Python, -1 for an error. */
static int prepared(const kernel *k, PyObject *out, npy_intp n, PyObject **results)
{
    int r;
    if (out != NULL && out != Py_None) {
        if (k->n_results > 1 && (!PyTuple_Check(out) || PyTuple_GET_SIZE(out) != k->n_results)) {
            return 0;
        }
        for (r = 0; r < k->n_results; r++) {
            PyObject *given = k->n_results > 1 ? PyTuple_GET_ITEM(out, r) : out;
            if (!is_result(given, k, r, n)) {
                return 0;
            }
            Py_INCREF(given);
            results[r] = given;
        }
        return 1;
    }
    for (r = 0; r < k->n_results; r++) {
        results[r] = new_result(k, r, n);
        if (results[r] == NULL) {
            return -1;
        }
    }
    return 1;
}

/* Compute; return whether the results may be handed out. */
static int computed(const kernel *k, npy_intp n, const double *const *in, const npy_intp *strides,
                    PyObject *const *results)
{
    double *data[MOST_RESULTS];
    int r;
    for (r = 0; r < k->n_results; r++) {
        data[r] = PyArray_DATA((PyArrayObject *)results[r]);
    }
    if (n < 0) {
        k->run(in, data);
    } else {
        Py_BEGIN_ALLOW_THREADS
        k->run_many(n, in, strides, data);
        Py_END_ALLOW_THREADS
    }
    for (r = 0; r < k->n_results && k->accelerates; r++) {
        if (!is_finite(data[r], (n < 0 ? 1 : n) * k->sizes[r])) {
            return 0;
        }
    }
    return 1;
}

/* One result as it is; several as a tuple of the given class. */
static PyObject *packed(const kernel *k, PyObject *const *results, PyObject *class)
{
    PyObject *tuple, *arguments, *whole = NULL;
    int r;
    if (k->n_results == 1) {
        Py_INCREF(results[0]);
        return results[0];
    }
    tuple = PyTuple_New(k->n_results);
    if (tuple == NULL) {
        return NULL;
    }
    for (r = 0; r < k->n_results; r++) {
        Py_INCREF(results[r]);
        PyTuple_SET_ITEM(tuple, r, results[r]);
    }
    if (!PyType_Check(class)) {
        return tuple;
    }
    arguments = PyTuple_Pack(1, tuple);
    if (arguments != NULL) {
        whole = PyTuple_Type.tp_new((PyTypeObject *)class, arguments, NULL);
        Py_DECREF(arguments);
    }
    Py_DECREF(tuple);
    return whole;
}

/* `self` holds what to call in Python, the class of several results, and whether to take batches. */
static PyObject *answer(const kernel *k, PyObject *self, PyObject *const *args, Py_ssize_t n_args,
                        PyObject *names)
{
    PyObject *found[MOST_ARGUMENTS] = {NULL}, *out = NULL, *results[MOST_RESULTS] = {NULL};
    PyObject *whole = NULL;
    const double *in[MOST_ARGUMENTS];
    npy_intp strides[MOST_ARGUMENTS], n = -1;
    int a, r, state = 0;
    if (!sorted(k, args, n_args, names, found, &out)) {
        goto python;
    }
    for (a = 0; a < k->n_arguments; a++) {
        if (found[a] == NULL || found[a] == Py_None) {
            if (k->defaults[a] == NULL) {
                goto python;
            }
            in[a] = k->defaults[a];
            strides[a] = 0;
        } else {
            in[a] = k->lengths[a] > 0 ? numbers(found[a], k->lengths[a], &n, &strides[a]) : NULL;
            if (in[a] == NULL) {
                goto python;
            }
        }
    }
    if (n >= 0 && PyTuple_GET_ITEM(self, 2) != Py_True) {
        goto python;
    }
    state = prepared(k, out, n, results);
    if (state > 0) {
        state = computed(k, n, in, strides, results);
        if (state > 0) {
            whole = packed(k, results, PyTuple_GET_ITEM(self, 1));
            state = whole == NULL ? -1 : 1;
        }
    }
    for (r = 0; r < k->n_results; r++) {
        Py_XDECREF(results[r]);
    }
    if (state != 0) {
        return whole;
    }
python:
    return PyObject_Vectorcall(PyTuple_GET_ITEM(self, 0), args, (size_t)n_args, names);
}

#define ENTRY(number)                                                                             \
    static PyObject *entry_##number(PyObject *self, PyObject *const *args, Py_ssize_t n_args,     \
                                    PyObject *names)                                              \
    {                                                                                             \
        return answer(&KERNELS[number], self, args, n_args, names);                               \
    }
#define METHOD(number)                                                                            \
    {KERNELS_NAME_##number, (PyCFunction)(void (*)(void))entry_##number,                          \
     METH_FASTCALL | METH_KEYWORDS, KERNELS_HELP_##number}

@LANES@
