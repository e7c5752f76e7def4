    names = {@NAMES@};
    across = {@ACROSS@};
    parents = [@PARENTS@];
    axes = [@AXES@];
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
@BASE_MOTION@    for i = 1:n
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
            f(:, i + 1) = f(:, i + 1) - fext{i + @FEXT@}(:);
        end
    end
@REST@end

function vx = motion_cross(v)
    w = [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
    u = [0, -v(6), v(5); v(6), 0, -v(4); -v(5), v(4), 0];
    vx = [w, zeros(3); u, w];
end
