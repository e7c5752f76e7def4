{% if robot.is_floating %}
function [tau, @base@_a] = inverseDynamics(ip, xm, @base@_v, gravity, qd, qdd, varargin)
% The joint forces of a motion, and the acceleration of the base, which is free.
%
% Velocity and gravity are six numbers in base coordinates, angular part first. Joint positions q
% may follow, which xm is updated for, and a cell array of the wrenches on base and links in their
% own coordinates.
{% else %}
function tau = inverseDynamics(ip, xm, qd, qdd, varargin)
% The joint forces of a motion, gravity acting along the base's -z.
%
% Joint positions q may follow, which xm is updated for, and a cell array of the wrenches on the
% links in their own coordinates.
{% endif %}
    names = {{% for i in links %}'lf_@robot.bodies[i]@'@'' if loop.last else ', '@{% endfor %}};
    across = {{% for i in links %}'@robot.frame(i)@_XM_@robot.frame(robot.tree.parents[i])@'@'' if loop.last else ', '@{% endfor %}};
    parents = [{% for i in links %}@robot.tree.parents[i]@@'' if loop.last else ', '@{% endfor %}];
    axes = [{% for i in links %}@3 if robot.tree.kinds[i] == 'revolute' else 6@@'' if loop.last else ', '@{% endfor %}];
    n = numel(parents);
    fext = {};
    for k = 1:numel(varargin)
        if iscell(varargin{k})
            fext = varargin{k};
        else
            xm = updateMotionTransforms(xm, varargin{k});
        end
    end
    v = zeros(6, n + 1);
    a = zeros(6, n + 1);
    f = zeros(6, n + 1);
{% if robot.is_floating %}
    v(:, 1) = @base@_v(:);
    Ic = cell(1, n + 1);
    Ic{1} = ip.lf_@base@.tensor6D;
    f(:, 1) = -motion_cross(v(:, 1))' * Ic{1} * v(:, 1);
    if ~isempty(fext)
        f(:, 1) = f(:, 1) - fext{1}(:);
    end
{% else %}
    a(6, 1) = 9.81;
{% endif %}
    for i = 1:n
        X = xm.(across{i});
        p = parents(i) + 1;
        joint = zeros(6, 1);
        joint(axes(i)) = qd(i);
        v(:, i + 1) = X * v(:, p) + joint;
        a(:, i + 1) = X * a(:, p) + motion_cross(v(:, i + 1)) * joint;
        a(axes(i), i + 1) = a(axes(i), i + 1) + qdd(i);
        I = ip.(names{i}).tensor6D;
        f(:, i + 1) = I * a(:, i + 1) - motion_cross(v(:, i + 1))' * I * v(:, i + 1);
        if ~isempty(fext)
            f(:, i + 1) = f(:, i + 1) - fext{i + @1 if robot.is_floating else 0@}(:);
        end
    end
{% if robot.is_floating %}
    for i = 1:n
        Ic{i + 1} = ip.(names{i}).tensor6D;
    end
    for i = n:-1:1
        X = xm.(across{i});
        p = parents(i) + 1;
        f(:, p) = f(:, p) + X' * f(:, i + 1);
        Ic{p} = Ic{p} + X' * Ic{i + 1} * X;
    end
    late = zeros(6, n + 1);
    late(:, 1) = -Ic{1} \ f(:, 1);
    tau = zeros(n, 1);
    for i = 1:n
        late(:, i + 1) = xm.(across{i}) * late(:, parents(i) + 1);
        tau(i) = Ic{i + 1}(axes(i), :) * late(:, i + 1) + f(axes(i), i + 1);
    end
    @base@_a = late(:, 1) + gravity(:);
{% else %}
    tau = zeros(n, 1);
    for i = n:-1:1
        tau(i) = f(axes(i), i + 1);
        p = parents(i) + 1;
        f(:, p) = f(:, p) + xm.(across{i})' * f(:, i + 1);
    end
{% endif %}
end

function vx = motion_cross(v)
    w = [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
    u = [0, -v(6), v(5); v(6), 0, -v(4); -v(5), v(4), 0];
    vx = [w, zeros(3); u, w];
end
