template <class TRAIT>
inline void h_@NAME@_constants(typename TRAIT::Scalar* X) { (void)X; }
template <class TRAIT>
inline void h_@NAME@(
    @TAKES@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X)
{
    typedef typename TRAIT::Scalar S;
    S B[16] = {};
    for (int k = 0; k < 16; k++) {
        X[k] = S(k % 5 == 0 ? 1 : 0);
    }
@STEPS@}
