    class Type_@NAME@ : public @BASE@<Scalar, Type_@NAME@> {
    public:
        EIGEN_MAKE_ALIGNED_OPERATOR_NEW
        Type_@NAME@()@INITIAL@
        {
            this->setZero();
            kernels::@KIND@_@NAME@_constants<TRAIT>(this->data());
            update(JState::Zero());
        }
        const Type_@NAME@& update(const JState& q)
        {
@PARAMETERS@            kernels::@KIND@_@NAME@<TRAIT>(@P@raw(q), this->data());
@STORE@            return *this;
        }
@MEMORY@    };
