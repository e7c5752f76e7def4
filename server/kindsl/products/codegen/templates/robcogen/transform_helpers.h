template <class S>
inline void fill(const S* T, S* X, S* C)
{
    for (int j = 0; j < 3; j++) {
        const S *e = T + 4 * j, *r = T + 12;
        S *first = X + 6 * j, *second = X + 6 * j + 21, *cross = C + 6 * j;
        for (int i = 0; i < 3; i++) {
            first[i] = second[i] = e[i];
        }
        cross[0] = r[1] * e[2] - r[2] * e[1];
        cross[1] = r[2] * e[0] - r[0] * e[2];
        cross[2] = r[0] * e[1] - r[1] * e[0];
    }
}

/** T = T * B, and zeros in B. */
template <class S>
inline void append(S* T, S* B)
{
    for (int i = 0; i < 3; i++) {
        const S x = T[i], y = T[4 + i], z = T[8 + i];
        for (int j = 0; j < 3; j++) {
            T[4 * j + i] = x * B[4 * j] + y * B[4 * j + 1] + z * B[4 * j + 2];
        }
        T[12 + i] += x * B[12] + y * B[13] + z * B[14];
    }
    for (int k = 0; k < 16; k++) {
        B[k] = S(0);
    }
}
