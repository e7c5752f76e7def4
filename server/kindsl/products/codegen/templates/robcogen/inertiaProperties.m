{% import "octave_parameters.m" as parameters %}
function ip = inertiaProperties(params)
% Mass, centre of mass and inertia of each link: ip.lf_NAME.mass, .com, .tensor6D.
@parameters.defaults(robot, 1)@{% for line in lines %}
    @line@
{% endfor %}
end

function body = properties(mass, com, moments)
    cross = mass * [0, -com(3), com(2); com(3), 0, -com(1); -com(2), com(1), 0];
    body.mass = mass;
    body.com = com;
    body.tensor = moments;
    body.tensor6D = [moments, cross; cross', mass * eye(3)];
end
