/* Loops over bodies, in base coordinates about the base's origin; spatial vectors have the angular
 * part first. A table has for each body, base first: rotation and position of its joint's frame in
 * its parent, mass, first moment, second moment (xx xy xz yy yz zz), rotor, damping and friction
 * of its joint. Coordinates are a floating base's six, then the joints. NULL stands for zeros.
 */
static const int @P@parents[@NB@] = {@PARENTS@};
static const int @P@turns[@NB@] = {@TURNS@};
/* Which coordinate carries each; none is -1. */
static const int @P@before[@NV@] = {@BEFORE@};

@FN@ @S@ @P@dot3(const @S@ *a, const @S@ *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

@FN@ @S@ @P@dot(const @S@ *a, const @S@ *b)
{
    return @P@dot3(a, b) + @P@dot3(a + 3, b + 3);
}

@FN@ void @P@cross(const @S@ *a, const @S@ *b, @S@ *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

@FN@ void @P@turned(const @S@ *R, const @S@ *v, @S@ *found)
{
    found[0] = @P@dot3(R, v);
    found[1] = @P@dot3(R + 3, v);
    found[2] = @P@dot3(R + 6, v);
}

/* v x s of two motions. */
@FN@ void @P@moved(const @S@ *v, const @S@ *s, @S@ *found)
{
    @P@cross(v, s, found);
    found[3] = v[4] * s[2] - v[5] * s[1] + (v[1] * s[5] - v[2] * s[4]);
    found[4] = v[5] * s[0] - v[3] * s[2] + (v[2] * s[3] - v[0] * s[5]);
    found[5] = v[3] * s[1] - v[4] * s[0] + (v[0] * s[4] - v[1] * s[3]);
}

/* Add the rate at which momentum h that moves with v changes. */
@FN@ void @P@add_moved(const @S@ *v, const @S@ *h, @S@ *f)
{
    f[0] += v[1] * h[2] - v[2] * h[1] + (v[4] * h[5] - v[5] * h[4]);
    f[1] += v[2] * h[0] - v[0] * h[2] + (v[5] * h[3] - v[3] * h[5]);
    f[2] += v[0] * h[1] - v[1] * h[0] + (v[3] * h[4] - v[4] * h[3]);
    f[3] += v[1] * h[5] - v[2] * h[4];
    f[4] += v[2] * h[3] - v[0] * h[5];
    f[5] += v[0] * h[4] - v[1] * h[3];
}

/* The momentum of a body, of ten numbers as in the table. */
@FN@ void @P@momentum(const @S@ *body, const @S@ *v, @S@ *f)
{
    const @S@ m = body[0], *h = body + 1, *J = body + 4, trace = J[0] + J[3] + J[5];
    f[0] = trace * v[0] - (J[0] * v[0] + J[1] * v[1] + J[2] * v[2]) + (h[1] * v[5] - h[2] * v[4]);
    f[1] = trace * v[1] - (J[1] * v[0] + J[3] * v[1] + J[4] * v[2]) + (h[2] * v[3] - h[0] * v[5]);
    f[2] = trace * v[2] - (J[2] * v[0] + J[4] * v[1] + J[5] * v[2]) + (h[0] * v[4] - h[1] * v[3]);
    f[3] = m * v[3] + (v[1] * h[2] - v[2] * h[1]);
    f[4] = m * v[4] + (v[2] * h[0] - v[0] * h[2]);
    f[5] = m * v[5] + (v[0] * h[1] - v[1] * h[0]);
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
            for (int k = 0; k < 9; k += 3) {
                E[k] = A[k] * t[0] + A[k + 1] * t[3] + A[k + 2] * t[6];
                E[k + 1] = A[k] * t[1] + A[k + 1] * t[4] + A[k + 2] * t[7];
                E[k + 2] = A[k] * t[2] + A[k + 1] * t[5] + A[k + 2] * t[8];
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
                bodies[k] = @P@dot3(half + 3 * a, R + 3 * b)
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
        @S@ *carrier = x + length * @P@parents[i];
        for (int k = 0; k < length; k++) {
            carrier[k] += x[length * i + k];
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

/* The same for a floating base that falls. */
@FN@ void @P@falling(const @S@ *v0, const @S@ *g, @S@ *base)
{
    const @S@ *none = (const @S@ *)0;
    @P@start(v0, none, v0 ? none : g, base);
    for (int k = 6; k < 9 && v0; k++) {
        base[k] = (@S@)0;
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

/* Solve A x = b for a symmetric 6x6 matrix, which is overwritten, and n columns, which x has. */
@FN@ void @P@resisted(@S@ *A, @S@ *x, int n)
{
    for (int k = 0; k < 6; k++) {
        for (int i = k + 1; i < 6; i++) {
            const @S@ factor = A[6 * i + k] / A[7 * k];
            for (int j = k + 1; j < 6; j++) {
                A[6 * i + j] -= factor * A[6 * k + j];
            }
            for (int c = 0; c < n; c++) {
                x[n * i + c] -= factor * x[n * k + c];
            }
        }
    }
    for (int k = 5; k >= 0; k--) {
        for (int c = 0; c < n; c++) {
            for (int j = k + 1; j < 6; j++) {
                x[n * k + c] -= A[6 * k + j] * x[n * j + c];
            }
            x[n * k + c] /= A[7 * k];
        }
    }
}

/* The 6x6 inertia of a body. */
@FN@ void @P@inertia(const @S@ *body, @S@ *found)
{
    const @S@ m = body[0], *h = body + 1, *J = body + 4, none = (@S@)0;
    const @S@ rows[36] = {
        J[3] + J[5], -J[1], -J[2], none, -h[2], h[1],
        -J[1], J[0] + J[5], -J[4], h[2], none, -h[0],
        -J[2], -J[4], J[0] + J[3], -h[1], h[0], none,
        none, h[2], -h[1], m, none, none,
        -h[2], none, h[0], none, m, none,
        h[1], -h[0], none, none, none, m};
    for (int k = 0; k < 36; k++) {
        found[k] = rows[k];
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
        tau[i - 1] = @P@dot(axes + 6 * (@K@ + i - 1), f + 6 * i) + @P@drive(t, qd, qdd, i);
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
    @P@falling(v0, g, base);
    @P@newton_euler(t, q, qd, qdd, base, fext, tau, wrench, axes, bodies);
    @P@carry(bodies, 10);
    @P@inertia(bodies, whole);
    for (int k = 0; k < 6; k++) {
        found[k] = -wrench[k];
    }
    @P@resisted(whole, found, 1);
    for (int i = 1; i < @NB@; i++) {
        @S@ f[6];
        @P@momentum(bodies + 10 * i, found, f);
        tau[i - 1] += @P@dot(axes + 6 * (@K@ + i - 1), f);
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

/* Articulated bodies: their inertias and, of each coordinate, the inverse of the inertia along it
 * and how much it is accelerated the other way by accelerations (and, when known, by turns) of what
 * carries it: a floating base's by its own. */
@FN@ void @P@articulate(const @S@ *t, const @S@ *axes, const @S@ *bodies, @S@ *whole, @S@ *along,
    @S@ *pivots)
{
    for (int i = 0; i < @NB@; i++) {
        @P@inertia(bodies + 10 * i, whole + 36 * i);
    }
    for (int k = 0; k < 9 * @NV@; k++) {
        along[k] = (@S@)-(k < 9 * @K@ && k % 10 == 0);
        pivots[k / 9] = (@S@)0;
    }
    for (int i = @NB@ - 1; i > 0; i--) {
        const int joint = @K@ + i - 1;
        const @S@ *axis = axes + 6 * joint, *own = whole + 36 * i;
        @S@ *V = along + 9 * joint, *carrier = whole + 36 * @P@parents[i], U[6];
        for (int k = 0; k < 6; k++) {
            U[k] = @P@dot(own + 6 * k, axis);
        }
        pivots[joint] = (@S@)1 / (@P@dot(U, axis) + t[25 * i + 22]);
        for (int k = 0; k < 6; k++) {
            V[k] = U[k] * pivots[joint];
#if defined(__GNUC__)
#pragma GCC unroll 6
#endif
            for (int j = 0; j < 6; j++) {
                carrier[6 * k + j] += own[6 * k + j] - V[k] * U[j];
            }
        }
    }
}

/* What joint forces accelerate, with the wrenches f of bodies without, which are overwritten. */
@FN@ void @P@accelerations(const @S@ *t, const @S@ *qd, const @S@ *tau, const @S@ *axes,
    const @S@ *whole, const @S@ *along, const @S@ *pivots, @S@ *f, @S@ *qdd, @S@ *a)
{
    for (int i = @NB@ - 1; i > 0; i--) {
        const int joint = @K@ + i - 1;
        const @S@ *none = (const @S@ *)0;
        qdd[i - 1] = tau[i - 1] - @P@drive(t, qd, none, i) - @P@dot(axes + 6 * joint, f + 6 * i);
        for (int k = 0; k < 6; k++) {
            f[6 * @P@parents[i] + k] += f[6 * i + k] + along[9 * joint + k] * qdd[i - 1];
        }
    }
    for (int k = 0; k < 6; k++) {
        a[k] = @K@ > 0 ? -f[k] : (@S@)0;
    }
    if (@K@ > 0) {
        @S@ base[36];
        for (int k = 0; k < 36; k++) {
            base[k] = whole[k];
        }
        @P@resisted(base, a, 1);
    }
    for (int i = 1; i < @NB@; i++) {
        const int joint = @K@ + i - 1;
        const @S@ *carrier = a + 6 * @P@parents[i];
        qdd[i - 1] = qdd[i - 1] * pivots[joint] - @P@dot(along + 9 * joint, carrier);
        for (int k = 0; k < 6; k++) {
            a[6 * i + k] = carrier[k] + axes[6 * joint + k] * qdd[i - 1];
        }
    }
}

@FN@ void @P@forward_dynamics(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *tau,
    const @S@ *v0, const @S@ *g, const @S@ *fext, @S@ *qdd, @S@ *a0)
{
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@], base[9];
    @S@ v[6 * @NB@], a[6 * @NB@], f[6 * @NB@], whole[36 * @NB@], along[9 * @NV@], pivots[@NV@];
    const @S@ *none = (const @S@ *)0;
    @P@place(t, q, R, r, axes, bodies);
    @P@falling(v0, g, base);
    @P@motions(axes, qd, none, base, v, a);
    @P@wrenches(R, r, bodies, v, a, fext, f);
    @P@articulate(t, axes, bodies, whole, along, pivots);
    @P@accelerations(t, qd, tau, axes, whole, along, pivots, f, qdd, a);
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
            M[@NV@ * i + j] = M[@NV@ * j + i] = @P@dot(axes + 6 * j, f);
        }
        if (i >= @K@) {
            M[(@NV@ + 1) * i] += t[25 * body + 22];
        }
    }
}

/* M = L^T D L, with L unit lower triangular. */
@FN@ void @P@inertia_factorization(const @S@ *t, const @S@ *q, @S@ *L, @S@ *D)
{
    @P@joint_space_inertia(t, q, L);
    for (int k = @NV@ - 1; k >= 0; k--) {
        @S@ *row = L + @NV@ * k;
        D[k] = row[k];
        for (int i = @P@before[k]; i >= 0; i = @P@before[i]) {
            const @S@ factor = row[i] / D[k];
            for (int j = i; j >= 0; j = @P@before[j]) {
                L[@NV@ * i + j] -= factor * row[j];
            }
        }
        for (int j = 0; j < @NV@; j++) {
            row[j] = j < k ? row[j] / D[k] : (@S@)(j == k);
        }
    }
}

/* Columns of matrices lie side by side in rows of some numbers, depth first: those of what a
 * coordinate carries follow its own, up to an end. */
@ROWS@
enum { @P@length = (@NV@ + @P@width - 1) / @P@width, @P@block = 4 * @P@width };
static const int @P@order[@NV@] = {@ORDER@};
static const int @P@column[@NV@] = {@COLUMNS@};
static const int @P@end[@NV@] = {@ENDS@};

/* The products of three numbers, and of six, with as many rows, which lie some rows apart. */
@FN@ @ROW@ @P@dot3_rows(const @S@ *a, const @ROW@ *rows, int apart)
{
    return a[0] * rows[0] + a[1] * rows[apart] + a[2] * rows[2 * apart];
}

@FN@ @ROW@ @P@dot_rows(const @S@ *a, const @ROW@ *rows, int apart)
{
    return @P@dot3_rows(a, rows, apart) + @P@dot3_rows(a + 3, rows + 3 * apart, apart);
}

/* Subtract the products of six numbers with blocks of four rows from one block. */
@FN@ void @P@subtract_products(const @S@ *a, const @ROW@ *rows, @ROW@ *found)
{
    @ROW@ x = found[0], y = found[1], z = found[2], w = found[3];
#if defined(__GNUC__)
#pragma GCC unroll 6
#endif
    for (int k = 0; k < 6; k++) {
        x -= a[k] * rows[4 * k];
        y -= a[k] * rows[4 * k + 1];
        z -= a[k] * rows[4 * k + 2];
        w -= a[k] * rows[4 * k + 3];
    }
    found[0] = x;
    found[1] = y;
    found[2] = z;
    found[3] = w;
}

/* The inverse of M, a block of its rows at once: what accelerates under a unit force of each
 * coordinate, by articulated bodies; the base's inertia is overwritten.
 *
 * Where some are asked for, the other results are what fields change. Of each coordinate there are
 * the products of both with the wrench on what it carries, and the moment of all from there on; of
 * both with its carrier's acceleration; and with its own force. */
@FN@ void @P@answers(const @S@ *axes, @S@ *whole, const @S@ *along, const @S@ *pivots,
    const @S@ *asked, @S@ *dq, @S@ *dqd, @S@ *Minv)
{
    @S@ inverse[36];
    @ROW@ kept[@P@width];
    for (int k = 0; k < @P@width * @P@width; k++) {
        ((@S@ *)kept)[k] = (@S@)(k < @P@width || k % @P@width < k / @P@width);
    }
    for (int k = 0; k < 36 && @K@ > 0; k++) {
        inverse[k] = (@S@)(k % 7 == 0);
    }
    if (@K@ > 0) {
        @P@resisted(whole, inverse, 6);
    }
    for (int from = 0; from < @NV@; from += @P@block) {
        const int to = from + @P@block < @NV@ ? from + @P@block : @NV@;
        @ROW@ p[36], a[24 * @NB@], found[12 * @NV@];
        @S@ *wrench = (@S@ *)p, *numbers = (@S@ *)found;
        for (int k = 0; k < 3 * @NV@ * @P@block; k++) {
            numbers[k] = (@S@)0;
        }
        for (int k = 0; k < 9 * @P@block; k++) {
            wrench[k] = (@S@)0;
        }
        for (int k = 0; k < 24; k++) {
            a[k] = p[k];
        }
        for (int k = to - 1; k >= 0; k--) {
            const int i = @P@order[k], own = k - from, end = @P@end[i] - from;
            const @S@ *s = axes + 6 * i, *V = along + 9 * i, *X = asked ? asked + 32 * i : s;
            for (int c = own < 0 ? 0 : own / @P@width; c < 4 && c * @P@width < end; c++) {
                /* Other branches may begin in the last row. */
                const @ROW@ own_lanes = kept[(c + 1) * @P@width > end ? end % @P@width : 0];
                @ROW@ *sum = found + 12 * i + c;
                if (asked) {
                    sum[4] -= own_lanes
                        * (@P@dot_rows(X, p + c, 4) + @P@dot3_rows(X + 6, p + 24 + c, 4));
                    sum[8] -= own_lanes
                        * (@P@dot_rows(X + 9, p + c, 4) + @P@dot3_rows(X + 15, p + 24 + c, 4));
                }
                if (i >= @K@) {
                    const @ROW@ push = own_lanes * @P@dot_rows(s, p + c, 4);
                    sum[0] -= pivots[i] * push;
#if defined(__GNUC__)
#pragma GCC unroll 9
#endif
                    for (int row = 0; row < 9; row++) {
                        p[4 * row + c] -= V[row] * push;
                    }
                }
            }
            if (i >= @K@ && k >= from) {
                @S@ *sum = numbers + 3 * @P@block * i + own;
                sum[0] = pivots[i];
                if (asked) {
                    sum[@P@block] -= X[30];
                    sum[2 * @P@block] -= X[31];
                }
                for (int row = 0; row < 9; row++) {
                    wrench[@P@block * row + own] = V[row];
                }
            }
        }
        for (int k = from; k < to && k < @K@; k++) {
            wrench[(@P@block + 1) * k - from] = (@S@)-1;
        }
        for (int k = 0; k < @K@; k++) {
            @P@subtract_products(inverse + 6 * k, p, a + 4 * k);
        }
        for (int k = 0; k < @NV@; k++) {
            const int i = @P@order[k], body = i < @K@ ? 0 : i - @K@ + 1;
            const @ROW@ *carrier = a + 24 * @P@parents[body];
            @ROW@ *sum = found + 12 * i, *own = a + 24 * body;
            @P@subtract_products(along + 9 * i, carrier, sum);
            if (asked) {
                @P@subtract_products(asked + 32 * i + 18, carrier, sum + 4);
                @P@subtract_products(asked + 32 * i + 24, carrier, sum + 8);
            }
            if (i >= @K@ && k + 1 < @P@end[i]) {
                const @ROW@ x = sum[0], y = sum[1], z = sum[2], w = sum[3];
#if defined(__GNUC__)
#pragma GCC unroll 6
#endif
                for (int row = 0; row < 6; row++) {
                    const @S@ s = axes[6 * i + row];
                    own[4 * row] = carrier[4 * row] + s * x;
                    own[4 * row + 1] = carrier[4 * row + 1] + s * y;
                    own[4 * row + 2] = carrier[4 * row + 2] + s * z;
                    own[4 * row + 3] = carrier[4 * row + 3] + s * w;
                }
            }
        }
        for (int k = from; k < to; k++) {
            const @S@ *sum = numbers + k - from;
            const int row = @NV@ * @P@order[k];
            for (int i = 0; i < @NV@; i++, sum += 3 * @P@block) {
                Minv[row + i] = sum[0];
                if (asked) {
                    dq[row + i] = sum[@P@block];
                    dqd[row + i] = sum[2 * @P@block];
                }
            }
        }
    }
}

@FN@ void @P@joint_space_inertia_inverse(const @S@ *t, const @S@ *q, @S@ *Minv)
{
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@];
    @S@ whole[36 * @NB@], along[9 * @NV@], pivots[@NV@], *none = (@S@ *)0;
    @P@place(t, q, R, r, axes, bodies);
    @P@articulate(t, axes, bodies, whole, along, pivots);
    @P@answers(axes, whole, along, pivots, none, none, none, Minv);
}

/* The wrench that a small turn takes of each body that moves by v: six rows, three columns. */
@FN@ void @P@flows(const @S@ *bodies, const @S@ *v, @S@ *B)
{
    for (int i = 0; i < @NB@; i++, bodies += 10, v += 6, B += 18) {
        const @S@ *J = bodies + 4;
        const @S@ second[9] = {J[0], J[1], J[2], J[1], J[3], J[4], J[2], J[4], J[5]};
        @S@ Q[9], P[3];
        @P@cross(v, bodies + 1, P);
        for (int k = 0; k < 3; k++) {
            @S@ column[3];
            @P@cross(v, second + 3 * k, column);
            for (int row = 0; row < 3; row++) {
                Q[3 * row + k] = column[row] + v[3 + row] * bodies[1 + k];
            }
            P[k] += bodies[0] * v[3 + k];
        }
        const @S@ trace = Q[0] + Q[4] + Q[8], none = (@S@)0;
        const @S@ rows[18] = {
            trace - Q[0], -Q[1], -Q[2], -Q[3], trace - Q[4], -Q[5], -Q[6], -Q[7], trace - Q[8],
            none, P[2], -P[1], -P[2], none, P[0], P[1], -P[0], none};
        for (int k = 0; k < 18; k++) {
            B[k] = rows[k] + rows[k];
        }
    }
}

/* What wrenches in a column of three are along an axis. */
@FN@ @S@ @P@along(const @S@ *B, const @S@ *axis)
{
    return B[0] * axis[0] + B[3] * axis[1] + B[6] * axis[2]
        + (B[9] * axis[3] + B[12] * axis[4] + B[15] * axis[5]);
}

/* What each coordinate changes: x where its position does, y where its rate does, of nine numbers
 * each, an acceleration and a turn of what it carries; those of the next are a stride away. */
@FN@ void @P@fields(const @S@ *axes, const @S@ *v, const @S@ *a, const @S@ *v0, const @S@ *g, @S@ *x,
    @S@ *y, int stride)
{
    for (int i = 0; i < @NV@; i++, axes += 6, x += stride, y += stride) {
        for (int k = 0; k < 9; k++) {
            x[k] = y[k] = (@S@)0;
        }
        for (int k = 0; k < 3; k++) {
            y[6 + k] = axes[k];
        }
        if (i >= @K@) {
            const int up = 6 * @P@parents[i - @K@ + 1];
            @S@ further[6];
            @P@moved(v + up, axes, y);
            @P@moved(a + up, axes, x);
            @P@moved(v + up, y, further);
            for (int k = 0; k < 3; k++) {
                x[6 + k] = y[k];
            }
            for (int k = 0; k < 6; k++) {
                x[k] += further[k];
                y[k] += y[k];
            }
        } else if (i < 3) {
            @P@cross(v0, axes, y);
            @P@cross(axes, v0 + 3, y + 3);
            if (g) {
                @P@cross(axes, g, x + 3);
            }
        } else {
            @P@cross(v0, axes + 3, y + 3);
        }
    }
}

/* Derivatives of the forces of bodies alone, without drives.
 *
 * Source: Singh, Russell, Wensing 2022.
 */
@FN@ void @P@force_derivatives(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *qdd,
    const @S@ *v0, const @S@ *a0, const @S@ *g, @S@ *dq, @S@ *dqd, @S@ *M)
{
    enum { stride = @P@length * @P@width };
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@], base[9];
    @S@ v[6 * @NB@], a[6 * @NB@], f[6 * @NB@], B[18 * @NB@];
    @S@ x[9 * @NV@], y[9 * @NV@];
    @ROW@ carried[21 * @P@length];
    @S@ *entries = (@S@ *)carried;
    @P@place(t, q, R, r, axes, bodies);
    @P@start(v0, a0, g, base);
    @P@motions(axes, qd, qdd, base, v, a);
    @P@wrenches(R, r, bodies, v, a, (const @S@ *)0, f);
    @P@flows(bodies, v, B);
    @P@fields(axes, v, a, v0, g, x, y, 9);
    @P@carry(bodies, 10);
    @P@carry(B, 18);
    @P@carry(f, 6);
    for (int k = 0; k < 21 * stride; k++) {
        entries[k] = (@S@)0;
    }
    for (int k = 0; k < @NV@ * @NV@; k++) {
        dq[k] = dqd[k] = M[k] = (@S@)0;
    }
    for (int i = 0; i < @NV@; i++) {
        const int body = i < @K@ ? 0 : i - @K@ + 1;
        const @S@ *axis = axes + 6 * i, *flow = B + 18 * body;
        /* The reaction, by position, by rate, and what the reaction has for small turns. */
        @S@ own[21];
        @P@momentum(bodies + 10 * body, axis, own);
        @P@momentum(bodies + 10 * body, x + 9 * i, own + 6);
        @P@momentum(bodies + 10 * body, y + 9 * i, own + 12);
        for (int k = 0; k < 6; k++) {
            own[6 + k] += @P@dot3(flow + 3 * k, x + 9 * i + 6);
            own[12 + k] += @P@dot3(flow + 3 * k, axis);
        }
        if (i >= @K@) {
            @P@add_moved(axis, f + 6 * body, own + 6);
        }
        for (int k = 0; k < 3; k++) {
            own[18 + k] = @P@along(flow + k, axis);
        }
        for (int k = 0; k < 21; k++) {
            entries[stride * k + @P@column[i]] = own[k];
        }
    }
    for (int first = 0; first < @NV@; first++) {
        const int i = @P@order[first];
        const @S@ *s = axes + 6 * i, *X = x + 9 * i, *Y = y + 9 * i;
        const int start = first / @P@width, end = @P@end[i];
        @ROW@ found[5 * @P@length];
        for (int row = start; row * @P@width < end; row++) {
            enum { n = @P@length };
            const @ROW@ *c = carried + row;
            @ROW@ *to = found + row - start;
            to[0] = @P@dot_rows(s, c, n);
            to[n] = @P@dot_rows(s, c + 6 * n, n);
            to[2 * n] = @P@dot_rows(s, c + 12 * n, n);
            to[3 * n] = @P@dot_rows(X, c, n) + @P@dot3_rows(X + 6, c + 18 * n, n);
            to[4 * n] = @P@dot_rows(Y, c, n) + @P@dot3_rows(s, c + 18 * n, n);
        }
        const @S@ *numbers = (const @S@ *)found + first % @P@width;
        for (int k = first; k < end; k++, numbers++) {
            const int j = @P@order[k], row = @NV@ * i + j, mirrored = @NV@ * j + i;
            M[row] = M[mirrored] = numbers[0];
            dq[mirrored] = numbers[3 * stride];
            dqd[mirrored] = numbers[4 * stride];
            dq[row] = numbers[stride];
            dqd[row] = numbers[2 * stride];
        }
        if (i >= @K@) {
            M[(@NV@ + 1) * i] += t[25 * (i - @K@ + 1) + 22];
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

/* At the solution M d qdd = -d tau with the accelerations held: `answers` to what positions and
 * rates change. What a floating base's turn or linear velocity changes are accelerations of all
 * points alike, which the base's undoes. */
@FN@ void @P@forward_dynamics_derivatives(const @S@ *t, const @S@ *q, const @S@ *qd, const @S@ *tau,
    const @S@ *v0, const @S@ *g, @S@ *dqdd_dq, @S@ *dqdd_dqd, @S@ *dqdd_dtau)
{
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@], base[9], qdd[@NV@];
    @S@ v[6 * @NB@], a[6 * @NB@], f[6 * @NB@], whole[36 * @NB@], along[9 * @NV@], pivots[@NV@];
    @S@ added[6 * @NB@], wrenches[6 * @NB@], B[18 * @NB@], asked[32 * @NV@];
    const @S@ *none = (const @S@ *)0;
    @P@place(t, q, R, r, axes, bodies);
    @P@falling(v0, g, base);
    @P@motions(axes, qd, none, base, v, a);
    @P@wrenches(R, r, bodies, v, a, none, f);
    for (int k = 0; k < 6 * @NB@; k++) {
        wrenches[k] = f[k];
    }
    @P@articulate(t, axes, bodies, whole, along, pivots);
    @P@accelerations(t, qd, tau, axes, whole, along, pivots, wrenches, qdd, added);
    for (int i = 0; i < @NB@; i++) {
        @S@ taken[6];
        @P@momentum(bodies + 10 * i, added + 6 * i, taken);
        for (int k = 0; k < 6; k++) {
            f[6 * i + k] += taken[k];
            a[6 * i + k] += added[6 * i + k];
        }
    }
    @P@carry(f, 6);
    @P@flows(bodies, v, B);
    @P@fields(axes, v, a, v0, none, asked, asked + 9, 32);
    for (int i = @NB@ - 1; i > 0; i--) {
        const int joint = @K@ + i - 1;
        const @S@ *own = B + 18 * i;
        @S@ *V = along + 9 * joint, *carrier = B + 18 * @P@parents[i], turned[3];
        for (int k = 0; k < 3; k++) {
            turned[k] = @P@along(own + k, axes + 6 * joint);
            V[6 + k] = pivots[joint] * turned[k];
        }
        for (int k = 0; k < 6; k++, own += 3, carrier += 3) {
            carrier[0] += own[0] - V[k] * turned[0];
            carrier[1] += own[1] - V[k] * turned[1];
            carrier[2] += own[2] - V[k] * turned[2];
        }
    }
    for (int i = 0; i < @NV@; i++) {
        const int body = i < @K@ ? 0 : i - @K@ + 1;
        const @S@ *s = axes + 6 * i, *V = along + 9 * i;
        @S@ *X = asked + 32 * i, *Y = X + 9, *P = X + 18, *Q = X + 24;
        for (int k = 0; k < 6; k++) {
            const @S@ *row = whole + 36 * body + 6 * k, *turn = B + 18 * body + 3 * k;
            P[k] = @P@dot(row, X) + @P@dot3(turn, X + 6);
            Q[k] = @P@dot(row, Y) + @P@dot3(turn, Y + 6);
        }
        X[30] = X[31] = (@S@)0;
        if (i >= @K@) {
            @P@add_moved(s, f + 6 * body, P);
            const @S@ x = @P@dot(P, s), y = @P@dot(Q, s) + t[25 * body + 23];
            X[30] = x * pivots[i];
            X[31] = y * pivots[i];
            for (int k = 0; k < 6; k++) {
                P[k] -= x * V[k];
                Q[k] -= y * V[k];
                X[k] -= X[30] * s[k];
                Y[k] -= X[31] * s[k];
            }
        }
    }
    @P@answers(axes, whole, along, pivots, asked, dqdd_dq, dqdd_dqd, dqdd_dtau);
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
            C[@NV@ * i + column] += @P@dot(M + @NV@ * i, turned);
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
    static const int lefts[10] = {3, 0, 1, 2, 0, 0, 1, 0, 1, 2};
    static const int rights[10] = {3, 3, 3, 3, 0, 1, 1, 2, 2, 2};
    @S@ R[9 * @NB@], r[3 * @NB@], axes[6 * @NV@], bodies[10 * @NB@], base[9];
    @S@ v[6 * @NB@], a[6 * @NB@];
    @P@place(t, q, R, r, axes, bodies);
    @P@start(v0, a0, g, base);
    @P@motions(axes, qd, qdd, base, v, a);
    for (int k = 0; k < @NV@ * COLUMNS; k++) {
        Y[k] = (@S@)0;
    }
    for (int i = FIRST; i < @NB@; i++) {
        const @S@ *w = v + 6 * i, *wd = a + 6 * i;
        @S@ vectors[12];
        for (int k = 0; k < 12; k++) {
            vectors[k] = k < 9 ? R[9 * i + 3 * (k % 3) + k / 3] : r[3 * i + k - 9];
        }
        for (int parameter = 0; parameter < 10; parameter++) {
            /* Mass and first moment where they are; an inertia alone: half its trace, less itself. */
            const int is_mass = parameter < 4, is_square = lefts[parameter] == rights[parameter];
            const @S@ *x = vectors + 3 * lefts[parameter], *y = vectors + 3 * rights[parameter];
            const @S@ half = (@S@)is_square / (@S@)2;
            const @S@ size = is_mass ? (@S@)1 - half : half - (@S@)1;
            @S@ body[10], h[6], f[6];
            body[0] = (@S@)(parameter == 0);
            for (int row = 0, k = 4; row < 3; row++) {
                body[1 + row] = is_mass ? x[row] : (@S@)0;
                for (int column = row; column < 3; column++, k++) {
                    body[k] = size * (x[row] * y[column] + y[row] * x[column]);
                    body[k] += !is_mass && row == column ? half : (@S@)0;
                }
            }
            @P@momentum(body, w, h);
            @P@momentum(body, wd, f);
            @P@add_moved(w, h, f);
            for (int j = i > 0 ? @K@ + i - 1 : @K@ - 1; j >= 0; j = @P@before[j]) {
                Y[COLUMNS * j + 10 * (i - FIRST) + parameter] = @P@dot(axes + 6 * j, f);
            }
        }
    }
}
