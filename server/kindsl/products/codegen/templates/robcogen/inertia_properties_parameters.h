    /** With the values that parameters had when this was generated; NaN where they had none. */
    InertiaProperties() : getter(nullptr) { compute(); }
    explicit InertiaProperties(const RuntimeParamsGetter& values) : getter(&values)
    {
        updateParameters();
    }
    /** Asks for the values again. */
    void updateParameters()
    {
        if (getter != nullptr) {
@READ@        }
        compute();
    }
    void updateParameters(const RuntimeInertiaParams& fresh)
    {
        values = fresh;
        compute();
    }
    /** Fills in those of all parameters that inertia depends on. */
    void parameters(Scalar* p) const
    {
@LISTED@    }
