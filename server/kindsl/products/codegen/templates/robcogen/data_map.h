#include <ostream>
#include "declarations.h"

@opening@

/** Holds one item for each @kind|lower@. */
template <typename T>
class @kind@DataMap {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW

    @kind@DataMap() {}
    @kind@DataMap(const T& defaultValue) { assign(defaultValue); }
    @kind@DataMap(const @kind@DataMap& rhs) { copy(rhs); }

    @kind@DataMap& operator=(const @kind@DataMap& rhs)
    {
        if (&rhs != this) {
            copy(rhs);
        }
        return *this;
    }
    @kind@DataMap& operator=(const T& rhs)
    {
        assign(rhs);
        return *this;
    }

    T& operator[](@kind@Identifiers which) { return data[which]; }
    const T& operator[](@kind@Identifiers which) const { return data[which]; }

private:
    void copy(const @kind@DataMap& rhs)
    {
        for (int i = 0; i < @kind|lower@sCount; i++) {
            data[i] = rhs.data[i];
        }
    }
    void assign(const T& value)
    {
        for (int i = 0; i < @kind|lower@sCount; i++) {
            data[i] = value;
        }
    }

    T data[@kind|lower@sCount];
};

template <typename T>
inline std::ostream& operator<<(std::ostream& out, const @kind@DataMap<T>& map)
{
    static const char* const names[] = {"@names|join('", "')@"};
    for (int i = 0; i < @kind|lower@sCount; i++) {
        out << "   " << names[i] << " = " << map[ordered@kind@IDs[i]];
    }
    return out;
}

@closing@
