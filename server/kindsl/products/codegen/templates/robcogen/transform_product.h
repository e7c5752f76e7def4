template <class TRAIT>
inline void h_@pair.name@_constants(typename TRAIT::Scalar* X) { (void)X; }
template <class TRAIT>
inline void h_@pair.name@(
    @takes_p@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X)
{
    typedef typename TRAIT::Scalar S;
    S B[16] = {};
    for (int k = 0; k < 16; k++) {
        X[k] = S(k % 5 == 0 ? 1 : 0);
    }
{% for step in steps %}
    h_@step@_constants<TRAIT>(B);
    h_@step@<TRAIT>(@p@q, B);
    append(X, B);
{% endfor %}
}

template <class TRAIT>
inline void s_@pair.name@_constants(typename TRAIT::Scalar* X, typename TRAIT::Scalar* C) { (void)X, (void)C; }
template <class TRAIT>
inline void s_@pair.name@(
    @takes_p@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X, typename TRAIT::Scalar* C)
{
    typename TRAIT::Scalar T[16];
    h_@pair.name@<TRAIT>(@p@q, T);
    fill(T, X, C);
}
