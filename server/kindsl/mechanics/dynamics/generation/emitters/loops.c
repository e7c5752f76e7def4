/* Loops over bodies, in base coordinates about the base's origin; spatial vectors have the angular
 * part first. A table has for each body, base first: rotation and position of its joint's frame in
 * its parent, mass, first moment, second moment (xx xy xz yy yz zz), rotor, damping and friction
 * of its joint. Coordinates are a floating base's six, then the joints. NULL stands for zeros.
 */
static const int @P@parents[@NB@] = {@PARENTS@};
static const int @P@turns[@NB@] = {@TURNS@};
/* Which coordinate carries each; none is -1. */
static const int @P@before[@NV@] = {@BEFORE@};

@FN@ @S@ @P@dot(const @S@ *a, const @S@ *b, int n)
{
    @S@ sum = a[0] * b[0];
    for (int k = 1; k < n; k++) {
        sum += a[k] * b[k];
    }
    return sum;
}

@FN@ void @P@cross(const @S@ *a, const @S@ *b, @S@ *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

@FN@ void @P@turned(const @S@ *R, const @S@ *v, @S@ *found)
{
    for (int k = 0; k < 3; k++) {
        found[k] = @P@dot(R + 3 * k, v, 3);
    }
}

/* v x s of two motions. */
@FN@ void @P@moved(const @S@ *v, const @S@ *s, @S@ *found)
{
    @S@ x[3];
    @P@cross(v, s, found);
    @P@cross(v + 3, s, x);
    @P@cross(v, s + 3, found + 3);
    for (int k = 0; k < 3; k++) {
        found[3 + k] += x[k];
    }
}

/* Add the rate at which momentum h that moves with v changes. */
@FN@ void @P@add_moved(const @S@ *v, const @S@ *h, @S@ *f)
{
    @S@ x[3], y[3], z[3];
    @P@cross(v, h, x);
    @P@cross(v + 3, h + 3, y);
    @P@cross(v, h + 3, z);
    for (int k = 0; k < 3; k++) {
        f[k] += x[k] + y[k];
        f[3 + k] += z[k];
    }
}

/* The momentum of a body, of ten numbers as in the table. */
@FN@ void @P@momentum(const @S@ *body, const @S@ *v, @S@ *f)
{
    const @S@ *h = body + 1, *J = body + 4, trace = J[0] + J[3] + J[5];
    @S@ x[3], y[3];
    @P@cross(h, v + 3, x);
    @P@cross(v, h, y);
    f[0] = trace * v[0] - (J[0] * v[0] + J[1] * v[1] + J[2] * v[2]) + x[0];
    f[1] = trace * v[1] - (J[1] * v[0] + J[3] * v[1] + J[4] * v[2]) + x[1];
    f[2] = trace * v[2] - (J[2] * v[0] + J[4] * v[1] + J[5] * v[2]) + x[2];
    for (int k = 0; k < 3; k++) {
        f[3 + k] = body[0] * v[3 + k] + y[k];
    }
}

/* Rotation and position of each body, the direction of each coordinate, and the bodies. */
@FN@ void @P@place(const @S@ *t, const @S@ *q, @S@ *R, @S@ *r, @S@ *axes, @S@ *bodies)
{
    for (int k = 0; k < 36 && @K@ > 0; k++) {
        axes[k] = (@S@)(k % 7 == 0);
    }
    for (int i = 0; i < @NB@; i++, t += 25, R += 9, r += 3, bodies += 10) {
        if (i == 0) {
            for (int k = 0; k < 9; k++) {
                R[k] = (@S@)(k % 4 == 0);
            }
            r[0] = r[1] = r[2] = (@S@)0;
        } else {
            const int up = i - @P@parents[i];
            const @S@ *A = R - 9 * up;
            @S@ *axis = axes + 6 * (@K@ + i - 1);
            @S@ E[9];
            for (int k = 0; k < 9; k++) {
                const int row = k / 3 * 3, column = k % 3;
                E[k] = A[row] * t[column] + A[row + 1] * t[3 + column]
                    + A[row + 2] * t[6 + column];
            }
            @P@turned(A, t + 9, r);
            const @S@ z[3] = {E[2], E[5], E[8]};
            const @S@ c = @P@turns[i] ? @COS@(q[i - 1]) : (@S@)1;
            const @S@ s = @P@turns[i] ? @SIN@(q[i - 1]) : (@S@)0;
            for (int k = 0; k < 3; k++) {
                R[3 * k] = c * E[3 * k] + s * E[3 * k + 1];
                R[3 * k + 1] = c * E[3 * k + 1] - s * E[3 * k];
                R[3 * k + 2] = z[k];
                r[k] += r[k - 3 * up];
                if (!@P@turns[i]) {
                    r[k] += z[k] * q[i - 1];
                }
                axis[k] = @P@turns[i] ? z[k] : (@S@)0;
                axis[3 + k] = z[k];
            }
            if (@P@turns[i]) {
                @P@cross(r, z, axis + 3);
            }
        }
        const @S@ m = t[12], *J = t + 16;
        const @S@ second[9] = {J[0], J[1], J[2], J[1], J[3], J[4], J[2], J[4], J[5]};
        @S@ half[9], h[3];
        @P@turned(R, t + 13, h);
        bodies[0] = m;
        for (int k = 0; k < 3; k++) {
            bodies[1 + k] = h[k] + m * r[k];
            @P@turned(second, R + 3 * k, half + 3 * k);
        }
        for (int a = 0, k = 4; a < 3; a++) {
            for (int b = a; b < 3; b++, k++) {
                bodies[k] = @P@dot(half + 3 * a, R + 3 * b, 3)
                    + (h[a] * r[b] + r[a] * bodies[1 + b]);
            }
        }
    }
}

/* Velocities and accelerations of the bodies, of the base given: those of the base's origin as a
 * point, as seen from one that moves with it and falls. */
@FN@ void @P@motions(const @S@ *axes, const @S@ *qd, const @S@ *qdd, const @S@ *base, @S@ *v, @S@ *a)
{
    for (int k = 0; k < 6; k++) {
        v[k] = k < 3 ? base[k] : (@S@)0;
        a[k] = base[3 + k];
    }
    for (int i = 1; i < @NB@; i++) {
        const int up = 6 * @P@parents[i];
        const @S@ *axis = axes + 6 * (@K@ + i - 1);
        @S@ turning[6];
        @P@moved(v + up, axis, turning);
        for (int k = 0; k < 6; k++) {
            v[6 * i + k] = v[up + k];
            a[6 * i + k] = a[up + k];
            if (qd) {
                v[6 * i + k] += axis[k] * qd[i - 1];
                a[6 * i + k] += turning[k] * qd[i - 1];
            }
            if (qdd) {
                a[6 * i + k] += axis[k] * qdd[i - 1];
            }
        }
    }
}

/* What the motion of each body takes, less what acts on it. */
@FN@ void @P@wrenches(const @S@ *R, const @S@ *r, const @S@ *bodies, const @S@ *v, const @S@ *a,
    const @S@ *fext, @S@ *f)
{
    for (int i = 0; i < @NB@; i++, R += 9, r += 3, bodies += 10, v += 6, a += 6, f += 6) {
        @S@ h[6];
        @P@momentum(bodies, v, h);
        @P@momentum(bodies, a, f);
        @P@add_moved(v, h, f);
        if (fext) {
            @S@ moment[3], force[3], x[3];
            @P@turned(R, fext + 6 * i, moment);
            @P@turned(R, fext + 6 * i + 3, force);
            @P@cross(r, force, x);
            for (int k = 0; k < 3; k++) {
                f[k] -= moment[k] + x[k];
                f[3 + k] -= force[k];
            }
        }
    }
}

/* Add what each body has, of some length, to what carries it. */
@FN@ void @P@carry(@S@ *x, int length)
{
    for (int i = @NB@ - 1; i > 0; i--) {
        for (int k = 0; k < length; k++) {
            x[length * @P@parents[i] + k] += x[length * i + k];
        }
    }
}

/* The base's angular velocity, angular acceleration, and its origin's acceleration that weighs. */
@FN@ void @P@start(const @S@ *v0, const @S@ *a0, const @S@ *g, @S@ *base)
{
    @S@ x[3];
    for (int k = 0; k < 9; k++) {
        base[k] = v0 && k < 3 ? v0[k] : (@S@)0;
        if (a0 && k >= 3) {
            base[k] = a0[k - 3];
        }
        if (g && k >= 6) {
            base[k] -= g[k - 6];
        }
    }
    if (v0) {
        @P@cross(v0, v0 + 3, x);
        for (int k = 0; k < 3; k++) {
            base[6 + k] += x[k];
        }
    }
}

/* A floating base's spatial acceleration, from that of its origin as a point that falls. */
@FN@ void @P@spatial(const @S@ *found, const @S@ *v0, const @S@ *g, @S@ *a0)
{
    @S@ x[3];
    @P@cross(v0, v0 + 3, x);
    for (int k = 0; k < 3; k++) {
        x[k] = found[3 + k] - x[k] + g[k];
    }
    for (int k = 0; k < 3; k++) {
        a0[k] = found[k];
        a0[3 + k] = x[k];
    }
}

/* Solve A x = -b for a symmetric 6x6 matrix, which is overwritten. */
@FN@ void @P@resisted(@S@ *A, const @S@ *b, @S@ *x)
{
    for (int i = 0; i < 6; i++) {
        x[i] = -b[i];
    }
    for (int k = 0; k < 6; k++) {
        for (int i = k + 1; i < 6; i++) {
            const @S@ factor = A[6 * i + k] / A[7 * k];
            for (int j = k + 1; j < 6; j++) {
                A[6 * i + j] -= factor * A[6 * k + j];
            }
            x[i] -= factor * x[k];
        }
    }
    for (int k = 5; k >= 0; k--) {
        for (int j = k + 1; j < 6; j++) {
            x[k] -= A[6 * k + j] * x[j];
        }
        x[k] /= A[7 * k];
    }
}

/* The 6x6 inertia of a body. */
@FN@ void @P@inertia(const @S@ *body, @S@ *found)
{
    for (int k = 0; k < 6; k++) {
        @S@ unit[6];
        for (int j = 0; j < 6; j++) {
            unit[j] = (@S@)(j == k);
        }
        @P@momentum(body, unit, found + 6 * k);
    }
}

/* The force that a joint's drive takes. */
@FN@ @S@ @P@drive(const @S@ *t, const @S@ *qd, const @S@ *qdd, int i)
{
    @S@ force = (@S@)0;
    if (qd) {
        force = t[25 * i + 23] * qd[i - 1] + t[25 * i + 24] * (@SIGN@);
    }
    if (qdd) {
        force += t[25 * i + 22] * qdd[i - 1];
    }
    return force;
}

@FN@ void @P@newton_euler(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *qdd, const @S@ *base,
    const @S@ *fext, @S@ *tau, @S@ *f0, @S@ *axes, @S@ *bodies)
{
    @S@ R[9 * @NB@], r[3 * @NB@], v[6 * @NB@], a[6 * @NB@], f[6 * @NB@];
    @P@place(t, q, R, r, axes, bodies);
    @P@motions(axes, qd, qdd, base, v, a);
    @P@wrenches(R, r, bodies, v, a, fext, f);
    @P@carry(f, 6);
    for (int i = 1; i < @NB@; i++) {
        tau[i - 1] = @P@dot(axes + 6 * (@K@ + i - 1), f + 6 * i, 6) + @P@drive(t, qd, qdd, i);
    }
    for (int k = 0; k < 6 && f0; k++) {
        f0[k] = f[k];
    }
}

@FN@ void @P@inverse_dynamics_actuated(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *qdd,
    const @S@ *v0, const @S@ *a0, const @S@ *g, const @S@ *fext, @S@ *tau, @S@ *f0)
{
    @S@ base[9], axes[6 * @NV@], bodies[10 * @NB@];
    @P@start(v0, a0, g, base);
    @P@newton_euler(t, q, qd, qdd, base, fext, tau, f0, axes, bodies);
}

@FN@ void @P@inverse_dynamics(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *qdd,
    const @S@ *v0, const @S@ *g, const @S@ *fext, @S@ *tau, @S@ *a0)
{
    if (!a0) {
        @P@inverse_dynamics_actuated(t, q, qd, qdd, v0, a0, g, fext, tau, a0);
        return;
    }
    @S@ base[9], axes[6 * @NV@], bodies[10 * @NB@], wrench[6], whole[36], found[6];
    for (int k = 0; k < 9; k++) {
        base[k] = k < 3 ? v0[k] : (@S@)0;
    }
    @P@newton_euler(t, q, qd, qdd, base, fext, tau, wrench, axes, bodies);
    @P@carry(bodies, 10);
    @P@inertia(bodies, whole);
    @P@resisted(whole, wrench, found);
    for (int i = 1; i < @NB@; i++) {
        @S@ f[6];
        @P@momentum(bodies + 10 * i, found, f);
        tau[i - 1] += @P@dot(axes + 6 * (@K@ + i - 1), f, 6);
    }
    @P@spatial(found, v0, g, a0);
}

@FN@ void @P@bias_torque(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *v0, const @S@ *g,
    @S@ *tau)
{
    const @S@ *none = (const @S@ *)0;
    @P@inverse_dynamics_actuated(
        t, q, qd, none, v0, none, g, none, tau + @K@, @K@ > 0 ? tau : (@S@ *)0);
}

@FN@ void @P@gravity_torque(const @S@ *t, const @S@ *q, const @S@ *g, @S@ *tau)
{
    @P@bias_torque(t, q, (const @S@ *)0, (const @S@ *)0, g, tau);
}

/* By articulated bodies. */
@FN@ void @P@forward_dynamics(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *tau,
    const @S@ *v0, const @S@ *g, const @S@ *fext, @S@ *qdd, @S@ *a0)
{
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@], base[9];
    @S@ v[6 * @NB@], a[6 * @NB@], f[6 * @NB@], whole[36 * @NB@];
    @S@ along[6 * @NB@], pivots[@NB@], loads[@NB@];
    const @S@ *none = (const @S@ *)0;
    @P@place(t, q, R, r, axes, bodies);
    @P@start(v0, none, v0 ? none : g, base);
    for (int k = 6; k < 9 && v0; k++) {
        base[k] = (@S@)0;
    }
    @P@motions(axes, qd, none, base, v, a);
    @P@wrenches(R, r, bodies, v, a, fext, f);
    for (int i = 0; i < @NB@; i++) {
        @P@inertia(bodies + 10 * i, whole + 36 * i);
    }
    for (int i = @NB@ - 1; i > 0; i--) {
        const @S@ *axis = axes + 6 * (@K@ + i - 1), *own = whole + 36 * i;
        @S@ *U = along + 6 * i, *carrier = whole + 36 * @P@parents[i];
        for (int k = 0; k < 6; k++) {
            U[k] = @P@dot(own + 6 * k, axis, 6);
        }
        pivots[i] = @P@dot(U, axis, 6) + t[25 * i + 22];
        loads[i] = tau[i - 1] - @P@drive(t, qd, none, i) - @P@dot(axis, f + 6 * i, 6);
        const @S@ share = loads[i] / pivots[i];
        for (int k = 0; k < 6; k++) {
            const @S@ factor = U[k] / pivots[i];
            for (int j = 0; j < 6; j++) {
                carrier[6 * k + j] += own[6 * k + j] - factor * U[j];
            }
            f[6 * @P@parents[i] + k] += f[6 * i + k] + U[k] * share;
        }
    }
    for (int k = 0; k < 6; k++) {
        a[k] = (@S@)0;
    }
    if (@K@ > 0) {
        @P@resisted(whole, f, a);
    }
    for (int i = 1; i < @NB@; i++) {
        const @S@ *axis = axes + 6 * (@K@ + i - 1), *carrier = a + 6 * @P@parents[i];
        qdd[i - 1] = (loads[i] - @P@dot(along + 6 * i, carrier, 6)) / pivots[i];
        for (int k = 0; k < 6; k++) {
            a[6 * i + k] = carrier[k] + axis[k] * qdd[i - 1];
        }
    }
    if (@K@ > 0) {
        @P@spatial(a, v0, g, a0);
    }
}

@FN@ void @P@joint_space_inertia(const @S@ *t, const @S@ *q, @S@ *M)
{
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@];
    @P@place(t, q, R, r, axes, bodies);
    @P@carry(bodies, 10);
    for (int k = 0; k < @NV@ * @NV@; k++) {
        M[k] = (@S@)0;
    }
    for (int i = 0; i < @NV@; i++) {
        const int body = i < @K@ ? 0 : i - @K@ + 1;
        @S@ f[6];
        @P@momentum(bodies + 10 * body, axes + 6 * i, f);
        for (int j = i; j >= 0; j = @P@before[j]) {
            M[@NV@ * i + j] = M[@NV@ * j + i] = @P@dot(axes + 6 * j, f, 6);
        }
        if (i >= @K@) {
            M[(@NV@ + 1) * i] += t[25 * body + 22];
        }
    }
}

/* Rows of matrices are as long as whole lanes have them. */
@ROWS@
enum { @P@length = (@NV@ + @P@width - 1) / @P@width, @P@stride = @P@length * @P@width };

/* Write M = L^T D L, with L unit lower triangular: its entries below D, which is the diagonal. What
 * stands above it is of no use. */
@FN@ void @P@factorize(const @S@ *M, @ROW@ *factors)
{
    @S@ *L = (@S@ *)factors;
    for (int k = 0; k < @NV@ * @P@stride; k++) {
        const int i = k / @P@stride, j = k % @P@stride;
        L[k] = j <= i ? M[@NV@ * i + j] : (@S@)0;
    }
    for (int k = @NV@ - 1; k >= 0; k--) {
        const @S@ pivot = L[@P@stride * k + k];
        for (int i = @P@before[k]; i >= 0; i = @P@before[i]) {
            const @S@ factor = L[@P@stride * k + i] / pivot;
            for (int j = 0; j <= i / @P@width; j++) {
                factors[@P@length * i + j] -= factor * factors[@P@length * k + j];
            }
        }
        for (int i = @P@before[k]; i >= 0; i = @P@before[i]) {
            L[@P@stride * k + i] /= pivot;
        }
    }
}

@FN@ void @P@inertia_factorization(const @S@ *t, const @S@ *q, @S@ *L, @S@ *D)
{
    @ROW@ factors[@NV@ * @P@length];
    const @S@ *found = (const @S@ *)factors;
    @P@joint_space_inertia(t, q, L);
    @P@factorize(L, factors);
    for (int k = 0; k < @NV@ * @NV@; k++) {
        const int i = k / @NV@, j = k % @NV@;
        L[k] = j < i ? found[@P@stride * i + j] : (@S@)(i == j);
    }
    for (int i = 0; i < @NV@; i++) {
        D[i] = found[(@P@stride + 1) * i];
    }
}

/* Solve M x = b for all columns of a matrix, which are overwritten. */
@FN@ void @P@solve(const @ROW@ *factors, @S@ *columns)
{
    enum { block = 4 * @P@width };
    const @S@ *L = (const @S@ *)factors;
    for (int first = 0; first < @NV@; first += block) {
        const int width = @NV@ - first < block ? @NV@ - first : block;
        @ROW@ x[4 * @NV@];
        @S@ *entries = (@S@ *)x;
        for (int k = 0; k < @NV@ * block; k++) {
            const int c = k % block;
            entries[k] = c < width ? columns[k / block * @NV@ + first + c] : (@S@)0;
        }
        for (int k = @NV@ - 1; k >= 0; k--) {
            const @ROW@ *own = x + 4 * k, a = own[0], b = own[1], c = own[2], d = own[3];
            for (int i = @P@before[k]; i >= 0; i = @P@before[i]) {
                const @S@ factor = L[@P@stride * k + i];
                x[4 * i] -= factor * a;
                x[4 * i + 1] -= factor * b;
                x[4 * i + 2] -= factor * c;
                x[4 * i + 3] -= factor * d;
            }
        }
        for (int k = 0; k < @NV@; k++) {
            const @S@ pivot = L[(@P@stride + 1) * k];
            @ROW@ *own = x + 4 * k, a = own[0] / pivot, b = own[1] / pivot, c = own[2] / pivot,
                  d = own[3] / pivot;
            for (int i = @P@before[k]; i >= 0; i = @P@before[i]) {
                const @S@ factor = L[@P@stride * k + i];
                a -= factor * x[4 * i];
                b -= factor * x[4 * i + 1];
                c -= factor * x[4 * i + 2];
                d -= factor * x[4 * i + 3];
            }
            own[0] = a;
            own[1] = b;
            own[2] = c;
            own[3] = d;
        }
        for (int k = 0; k < @NV@; k++) {
            for (int c = 0; c < width; c++) {
                columns[@NV@ * k + first + c] = entries[block * k + c];
            }
        }
    }
}

@FN@ void @P@invert(const @ROW@ *factors, @S@ *found)
{
    for (int k = 0; k < @NV@ * @NV@; k++) {
        found[k] = (@S@)(k % (@NV@ + 1) == 0);
    }
    @P@solve(factors, found);
}

@FN@ void @P@joint_space_inertia_inverse(const @S@ *t, const @S@ *q, @S@ *Minv)
{
    @ROW@ factors[@NV@ * @P@length];
    @P@joint_space_inertia(t, q, Minv);
    @P@factorize(Minv, factors);
    @P@invert(factors, Minv);
}

/* Derivatives of the forces of bodies alone, without drives.
 *
 * Source: Singh, Russell, Wensing 2022. A coordinate changes accelerations by x where its position
 * changes, by y where its rate does. Of points, only how fast they move and where they are matters
 * besides: Q = integral (velocity r^T) dm, and the momentum P.
 */
@FN@ void @P@force_derivatives(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *qdd,
    const @S@ *v0, const @S@ *a0, const @S@ *g, @S@ *dq, @S@ *dqd, @S@ *M)
{
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@], base[9];
    @S@ v[6 * @NB@], a[6 * @NB@], f[6 * @NB@], Q[9 * @NB@], P[3 * @NB@];
    @S@ x[6 * @NV@], y[6 * @NV@], turning[3 * @NV@];
    @P@place(t, q, R, r, axes, bodies);
    @P@start(v0, a0, g, base);
    @P@motions(axes, qd, qdd, base, v, a);
    @P@wrenches(R, r, bodies, v, a, (const @S@ *)0, f);
    for (int i = 0; i < @NB@; i++) {
        const @S@ *body = bodies + 10 * i, *J = body + 4, *w = v + 6 * i;
        const @S@ second[9] = {J[0], J[1], J[2], J[1], J[3], J[4], J[2], J[4], J[5]};
        @S@ momentum[6];
        @P@momentum(body, w, momentum);
        for (int k = 0; k < 3; k++) {
            @S@ column[3];
            @P@cross(w, second + 3 * k, column);
            P[3 * i + k] = momentum[3 + k];
            for (int row = 0; row < 3; row++) {
                Q[9 * i + 3 * row + k] = column[row] + w[3 + row] * body[1 + k];
            }
        }
    }
    @P@carry(bodies, 10);
    @P@carry(Q, 9);
    @P@carry(P, 3);
    @P@carry(f, 6);
    for (int i = 0; i < @NV@; i++) {
        const @S@ *axis = axes + 6 * i;
        @S@ *own = y + 6 * i, *force = x + 6 * i;
        if (i >= @K@) {
            const int up = 6 * @P@parents[i - @K@ + 1];
            @S@ further[6];
            @P@moved(v + up, axis, own);
            @P@moved(a + up, axis, force);
            @P@moved(v + up, own, further);
            for (int k = 0; k < 6; k++) {
                force[k] += further[k];
                turning[3 * i + k % 3] = own[k % 3];
            }
            for (int k = 0; k < 6; k++) {
                own[k] += own[k];
            }
            continue;
        }
        for (int k = 0; k < 6; k++) {
            own[k] = force[k] = turning[3 * i + k % 3] = (@S@)0;
        }
        if (i < 3) {
            @P@cross(v0, axis, own);
            @P@cross(axis, v0 + 3, own + 3);
            if (g) {
                @P@cross(axis, g, force + 3);
            }
        } else {
            @P@cross(v0, axis + 3, own + 3);
        }
    }
    for (int k = 0; k < @NV@ * @NV@; k++) {
        dq[k] = dqd[k] = M[k] = (@S@)0;
    }
    for (int i = 0; i < @NV@; i++) {
        const int body = i < @K@ ? 0 : i - @K@ + 1;
        const @S@ *axis = axes + 6 * i, *flow = Q + 9 * body, *moving = P + 3 * body;
        const @S@ trace = flow[0] + flow[4] + flow[8], *w = turning + 3 * i;
        @S@ reaction[6], by_position[6], by_rate[6], back[3], u[3], z[3];
        @P@momentum(bodies + 10 * body, axis, reaction);
        @P@momentum(bodies + 10 * body, x + 6 * i, by_position);
        @P@momentum(bodies + 10 * body, y + 6 * i, by_rate);
        @P@cross(moving, axis + 3, back);
        for (int k = 0; k < 3; k++) {
            back[k] += trace * axis[k]
                - (flow[k] * axis[0] + flow[3 + k] * axis[1] + flow[6 + k] * axis[2]);
            back[k] += back[k];
            u[k] = w[k] + w[k];
            z[k] = axis[k] + axis[k];
        }
        for (int k = 0; k < 3; k++) {
            by_position[k] += trace * u[k] - @P@dot(flow + 3 * k, u, 3);
            by_rate[k] += trace * z[k] - @P@dot(flow + 3 * k, z, 3);
        }
        @S@ push[3];
        @P@cross(u, moving, push);
        for (int k = 0; k < 3; k++) {
            by_position[3 + k] += push[k];
        }
        @P@cross(z, moving, push);
        for (int k = 0; k < 3; k++) {
            by_rate[3 + k] += push[k];
        }
        if (i >= @K@) {
            @P@add_moved(axis, f + 6 * body, by_position);
        }
        for (int j = i; j >= 0; j = @P@before[j]) {
            const int here = @NV@ * i + j, there = @NV@ * j + i;
            M[here] = M[there] = @P@dot(axes + 6 * j, reaction, 6);
            dq[here] = @P@dot(reaction, x + 6 * j, 6) + @P@dot(back, turning + 3 * j, 3);
            dqd[here] = @P@dot(reaction, y + 6 * j, 6) + @P@dot(back, axes + 6 * j, 3);
            dq[there] = @P@dot(axes + 6 * j, by_position, 6);
            dqd[there] = @P@dot(axes + 6 * j, by_rate, 6);
        }
        if (i >= @K@) {
            M[(@NV@ + 1) * i] += t[25 * body + 22];
        }
    }
}

@FN@ void @P@inverse_dynamics_derivatives(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *qdd,
    const @S@ *v0, const @S@ *a0, const @S@ *g, @S@ *dtau_dq, @S@ *dtau_dqd, @S@ *dtau_dqdd)
{
    @P@force_derivatives(t, q, qd, qdd, v0, a0, g, dtau_dq, dtau_dqd, dtau_dqdd);
    for (int i = @K@; i < @NV@; i++) {
        dtau_dqd[(@NV@ + 1) * i] += t[25 * (i - @K@ + 1) + 23];
    }
}

/* At the solution M d qdd = -d tau with the accelerations held; what a floating base's turn or
 * linear velocity changes are accelerations of all points alike, which the base's undoes. */
@FN@ void @P@forward_dynamics_derivatives(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *tau,
    const @S@ *v0, const @S@ *g, @S@ *dqdd_dq, @S@ *dqdd_dqd, @S@ *dqdd_dtau)
{
    @S@ qdd[@NV@], a0[6];
    @ROW@ factors[@NV@ * @P@length];
    const @S@ *none = (const @S@ *)0;
    @P@forward_dynamics(t, q, qd, tau, v0, g, none, qdd, a0);
    @P@inverse_dynamics_derivatives(
        t, q, qd, qdd, v0, @K@ > 0 ? a0 : none, g, dqdd_dq, dqdd_dqd, dqdd_dtau);
    @P@factorize(dqdd_dtau, factors);
    for (int k = 0; k < @NV@ * @NV@; k++) {
        dqdd_dq[k] = -dqdd_dq[k];
        dqdd_dqd[k] = -dqdd_dqd[k];
    }
    @P@solve(factors, dqdd_dq);
    @P@solve(factors, dqdd_dqd);
    @P@invert(factors, dqdd_dtau);
    for (int column = 0; column < 3 && @K@ > 0; column++) {
        @S@ axis[3], turn[3], moving[3];
        for (int k = 0; k < 3; k++) {
            axis[k] = (@S@)(k == column);
        }
        @P@cross(g, axis, turn);
        @P@cross(axis, v0, moving);
        for (int i = 0; i < @NV@; i++) {
            const int is_linear = i >= 3 && i < 6;
            dqdd_dq[@NV@ * i + column] = is_linear ? turn[i - 3] : (@S@)0;
            dqdd_dqd[@NV@ * i + 3 + column] = is_linear ? moving[i - 3] : (@S@)0;
        }
    }
}

/* Half the derivative of the bias, but for a floating base's columns: their coordinates turn. */
@FN@ void @P@coriolis_matrix(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *v0, @S@ *C)
{
    @S@ dq[@NV@ * @NV@], M[@NV@ * @NV@];
    const @S@ *none = (const @S@ *)0;
    @P@force_derivatives(t, q, qd, none, v0, none, none, dq, C, M);
    for (int column = 0; column < @K@; column++) {
        @S@ unit[6], turned[6];
        for (int k = 0; k < 6; k++) {
            unit[k] = (@S@)(k == column);
        }
        @P@moved(v0, unit, turned);
        for (int i = 0; i < @NV@; i++) {
            C[@NV@ * i + column] += @P@dot(M + @NV@ * i, turned, 6);
        }
    }
    for (int k = 0; k < @NV@ * @NV@; k++) {
        C[k] /= (@S@)2;
    }
}

/* Ten columns a body, a floating base's first: mass, first moment, xx xy yy xz yz zz of the inertia,
 * in its own coordinates. */
@FN@ void @P@regressor(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *qdd, const @S@ *v0,
    const @S@ *a0, const @S@ *g, @S@ *Y)
{
    enum { FIRST = @K@ > 0 ? 0 : 1, COLUMNS = 10 * (@NB@ - FIRST) };
    static const int rows[6] = {0, 0, 1, 0, 1, 2}, columns[6] = {0, 1, 1, 2, 2, 2};
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@], base[9];
    @S@ v[6 * @NB@], a[6 * @NB@];
    @P@place(t, q, R, r, axes, bodies);
    @P@start(v0, a0, g, base);
    @P@motions(axes, qd, qdd, base, v, a);
    for (int k = 0; k < @NV@ * COLUMNS; k++) {
        Y[k] = (@S@)0;
    }
    for (int i = FIRST; i < @NB@; i++) {
        const @S@ *E = R + 9 * i, *p = r + 3 * i, *w = v + 6 * i, *wd = a + 6 * i;
        for (int parameter = 0; parameter < 10; parameter++) {
            @S@ body[10], h[6], f[6], z[3];
            for (int k = 0; k < 10; k++) {
                body[k] = (@S@)0;
            }
            /* Mass and first moment, placed; the inertia has no effect but its own. */
            if (parameter < 4) {
                body[0] = (@S@)(parameter == 0);
                for (int k = 0; k < 3; k++) {
                    z[k] = parameter == 0 ? (@S@)0 : E[3 * k + parameter - 1];
                    body[1 + k] = z[k] + body[0] * p[k];
                }
                for (int k = 0, row = 0; row < 3; row++) {
                    for (int column = row; column < 3; column++, k++) {
                        body[4 + k] = z[row] * p[column] + p[row] * body[1 + column];
                    }
                }
            } else {
                const int A = rows[parameter - 4], B = columns[parameter - 4];
                for (int k = 0, row = 0; row < 3; row++) {
                    for (int column = row; column < 3; column++, k++) {
                        @S@ tensor = E[3 * row + A] * E[3 * column + B];
                        if (A != B) {
                            tensor += E[3 * row + B] * E[3 * column + A];
                        }
                        body[4 + k] = -tensor;
                        if (row == column && A == B) {
                            body[4 + k] += (@S@)1 / (@S@)2;
                        }
                    }
                }
            }
            @P@momentum(body, w, h);
            @P@momentum(body, wd, f);
            @P@add_moved(w, h, f);
            for (int j = i > 0 ? @K@ + i - 1 : @K@ - 1; j >= 0; j = @P@before[j]) {
                Y[COLUMNS * j + 10 * (i - FIRST) + parameter] = @P@dot(axes + 6 * j, f, 6);
            }
        }
    }
}
