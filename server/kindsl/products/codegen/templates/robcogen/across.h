template <class TRAIT>
inline void across(int link, @takes_p@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X)
{
    switch (link) {
{% for i in links %}
    case @i@:
        s_@robot.across(i)@_constants<TRAIT>(X, X + 3);
        s_@robot.across(i)@<TRAIT>(@p@q, X, X + 3);
        break;
{% endfor %}
    }
}
