template <class TRAIT>
inline void @name@_constants(typename TRAIT::Scalar* @constants|join(", typename TRAIT::Scalar* ")@)
{
{% if constants.values()|select|list %}
    typedef typename TRAIT::Scalar S;
{% endif %}
{% for array, values in constants.items() %}
{% for place, value in values.items() %}
    @array@[@place@] = S(@value@);
{% else %}
    (void)@array@;
{% endfor %}
{% endfor %}
}
