"""Words that are no names in the languages that the generators write."""

_CPP = """alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl
    concept const consteval constexpr constinit const_cast continue co_await co_return co_yield
    decltype default delete do double dynamic_cast else enum explicit export extern false float for
    friend goto if inline int long mutable namespace new noexcept not not_eq nullptr operator or
    or_eq private protected public register reinterpret_cast requires return short signed sizeof
    static static_assert static_cast struct switch template this thread_local throw true try
    typedef typeid typename union unsigned using virtual void volatile wchar_t while xor
    xor_eq"""
_OCTAVE = """break case catch continue do else elseif end end_try_catch end_unwind_protect endfor
    endfunction endif endswitch endwhile for function global if otherwise persistent return switch
    try until unwind_protect unwind_protect_cleanup while"""
RESERVED_BY = dict.fromkeys(_OCTAVE.split(), "Octave") | dict.fromkeys(_CPP.split(), "C++")
