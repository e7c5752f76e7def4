template <class TRAIT>
inline void @function@(@declared|join(", ")@)
{
    typename TRAIT::Scalar none[@size@];
    for (int i = 0; i < @size@; i++) {
        none[i] = typename TRAIT::Scalar(0);
    }
    @function@_loaded<TRAIT>(@handed_on|join(", ")@);
}
