{% import "octave_parameters.m" as parameters %}
function out = update@what@(tr, q, params)
@parameters.defaults(robot, 3)@    out = tr;
{% for line in lines %}
    @line@
{% endfor %}
end
