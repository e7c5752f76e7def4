static const kernel KERNELS[@COUNT@] = {
@ROWS@
};
@NAMES@@ENTRIES@
static PyMethodDef METHODS[@COUNT@] = {
    @METHODS@
};

static PyObject *bind(PyObject *module, PyObject *args)
{
    const char *name;
    PyObject *python, *class, *batches, *self, *function = NULL;
    (void)module;
    if (!PyArg_ParseTuple(args, "sOOO", &name, &python, &class, &batches)) {
        return NULL;
    }
    for (size_t i = 0; i < sizeof METHODS / sizeof METHODS[0]; i++) {
        if (strcmp(METHODS[i].ml_name, name) == 0) {
            self = PyTuple_Pack(3, python, class, batches);
            if (self != NULL) {
                function = PyCFunction_New(&METHODS[i], self);
                Py_DECREF(self);
            }
            return function;
        }
    }
    PyErr_SetString(PyExc_KeyError, name);
    return NULL;
}

static PyMethodDef MODULE_METHODS[] = {
    {"bind", bind, METH_VARARGS, NULL}, {NULL, NULL, 0, NULL}};
static struct PyModuleDef DEFINITION = {
    PyModuleDef_HEAD_INIT, "@MODULE@", NULL, -1, MODULE_METHODS, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit_@MODULE@(void)
{
    (void)ZEROS;
    (void)GRAVITY;
    import_array();
    return PyModule_Create(&DEFINITION);
}
