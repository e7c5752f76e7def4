namespace of_plain_numbers {
template <class S>
inline S sign(const S& x)
{
    return x > S(0) ? S(1) : x < S(0) ? S(-1) : x;
}
} // namespace of_plain_numbers

/* A type of numbers may have a `sign` of its own in its namespace, as CppAD's has. */
template <class S>
inline S sign(const S& x)
{
    using of_plain_numbers::sign;
    return sign(x);
}

