template <class TRAIT>
inline void @name@_constants(typename TRAIT::Scalar* X)
{
{% if constants %}
    typedef typename TRAIT::Scalar S;
{% for place, value in constants.items() %}
    X[@place@] = S(@value@);
{% endfor %}
{% else %}
    (void)X;
{% endif %}
}
