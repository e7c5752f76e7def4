template <class TRAIT>
inline void @LETTER@_@NAME@_constants(typename TRAIT::Scalar* X) { (void)X; }
template <class TRAIT>
inline void @LETTER@_@NAME@(
    @TAKES@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X)
{
    typename TRAIT::Scalar T[16];
    h_@NAME@<TRAIT>(@P@q, T);
    @LETTER@_fill(T, X);
}
