{% macro defaults(robot, position) %}
{% if robot.has_parameters %}
    if nargin < @position@
{% for x in robot.parameters %}
        params.@x.name@ = @"NaN" if x.value is none else x.value@;
{% endfor %}
    end
{% endif %}
{% endmacro %}
