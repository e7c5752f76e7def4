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
    @BASE@_a = late(:, 1) + gravity(:);
