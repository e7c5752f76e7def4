
namespace iit {
namespace @NS@ {

/** Holds one item for each @WHAT@. */
template <typename T>
class @CLASS@ {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW

    @CLASS@() {}
    @CLASS@(const T& defaultValue) { assign(defaultValue); }
    @CLASS@(const @CLASS@& rhs) { copy(rhs); }

    @CLASS@& operator=(const @CLASS@& rhs)
    {
        if (&rhs != this) {
            copy(rhs);
        }
        return *this;
    }
    @CLASS@& operator=(const T& rhs)
    {
        assign(rhs);
        return *this;
    }

    T& operator[](@ID@ which) { return data[which]; }
    const T& operator[](@ID@ which) const { return data[which]; }

private:
    void copy(const @CLASS@& rhs)
    {
        for (int i = 0; i < @COUNT@; i++) {
            data[i] = rhs.data[i];
        }
    }
    void assign(const T& value)
    {
        for (int i = 0; i < @COUNT@; i++) {
            data[i] = value;
        }
    }

    T data[@COUNT@];
};

template <typename T>
inline std::ostream& operator<<(std::ostream& out, const @CLASS@<T>& map)
{
    static const char* const names[] = {@NAMES@};
    for (int i = 0; i < @COUNT@; i++) {
        out << "   " << names[i] << " = " << map[@ORDERED@[i]];
    }
    return out;
}

}
}
