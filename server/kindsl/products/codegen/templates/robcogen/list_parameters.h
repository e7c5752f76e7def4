{% if robot.has_parameters %}
        Scalar p[@robot.library.robot.parameters|length@] = {};
        @transforms|default("xm")@->parameters(p);
        inertiaProps->parameters(p);
{% endif %}
