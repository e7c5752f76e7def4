{# What the headers of parameters, and the classes that keep some, have in common. #}
{% macro struct(name, parameters) %}
struct @name@ {
{% for x in parameters %}
    double @x.name@ = @"std::numeric_limits<double>::quiet_NaN()" if x.value is none else x.value@;
{% endfor %}
    void defaults() { *this = {}; }
};
{% endmacro %}

{% macro getter(name, parameters) %}
class @name@ {
public:
    virtual ~@name@() {}
{% for x in parameters %}
    virtual double getValue_@x.name@() const = 0;
{% endfor %}
};
{% endmacro %}

{% macro methods(parameters, place) %}
{% for x in parameters %}
    double getValue_@x.name@() const override
    {
        return @place@.@x.name@;
    }
{% endfor %}
{% endmacro %}

{# The constructors of a container, and how it gets parameters. #}
{% macro construction(name, robot) %}
{% set groups = robot.kinematic_groups %}
{% if groups %}
    /** With the values that parameters had when this was generated; NaN where they had none. */
    @name@() : {% for g in groups %}valuesGetter_@g@(nullptr)@", " if not loop.last else ""@{% endfor %} {}
    explicit @name@({% for g in groups %}const ParamsGetter_@g@& @g@@", " if not loop.last else ""@{% endfor %}) : {% for g in groups %}valuesGetter_@g@(&@g@)@", " if not loop.last else ""@{% endfor %} { updateParameters(); }
    /** Asks for the values again; matrices change when they are updated next. */
    void updateParameters()
    {
{% for g, parameters in groups.items() %}
        if (valuesGetter_@g@ != nullptr) {
{% for x in parameters %}
            values_@g@.@x.name@ = valuesGetter_@g@->getValue_@x.name@();
{% endfor %}
        }
{% endfor %}
        handOn();
    }
    void updateParameters(const Params_lengths& lengths, const Params_angles& angles)
    {
{% for g in ("lengths", "angles") if g not in groups %}
        (void)@g@;
{% endfor %}
{% for g in groups %}
        values_@g@ = @g@;
{% endfor %}
        handOn();
    }
    void updateParams(const Params_lengths& lengths, const Params_angles& angles) { updateParameters(lengths, angles); }
    /** Fills in the kinematic ones of all parameters. */
    void parameters(Scalar* p) const
    {
{% for g, parameters in groups.items() %}
{% for x in parameters %}
        p[@x.place@] = Scalar(values_@g@.@x.name@);
{% endfor %}
{% endfor %}
    }
{% else %}
    @name@() {}
    void updateParameters() {}
    void updateParameters(const Params_lengths&, const Params_angles&) {}
    void updateParams(const Params_lengths&, const Params_angles&) {}
{% if robot.has_parameters %}
    void parameters(Scalar*) const {}
{% endif %}
{% endif %}
{% endmacro %}

{# The parameters that a container keeps and hands on to those of its members that depend on some. #}
{% macro values(matrices, robot) %}
{% set groups = robot.kinematic_groups %}
{% if groups %}

private:
    void handOn()
    {
{% for matrix in matrices if matrix.has_parameters %}
{% for g in groups %}
        @matrix.name@.@g@_values = values_@g@;
{% endfor %}
{% endfor %}
    }

{% for g in groups %}
    Params_@g@ values_@g@;
    const ParamsGetter_@g@* valuesGetter_@g@;
{% endfor %}
{% endif %}
{% endmacro %}

{# The first argument of a matrix's kernel, with a comma. #}
{% macro first(matrix, robot) %}@"" if not robot.has_parameters else "p, " if matrix.has_parameters else "nullptr, "@{% endmacro %}

{% macro array(matrix, robot) %}
{% if matrix.has_parameters %}
            const Scalar p[] = {@robot.kinematic_parameters|join(", ")@};
{% endif %}
{% endmacro %}

{% macro kept(matrix, robot) %}
{% if matrix.has_parameters %}
{% for g in robot.kinematic_groups %}
        Params_@g@ @g@_values;
{% endfor %}
{% endif %}
{% endmacro %}
