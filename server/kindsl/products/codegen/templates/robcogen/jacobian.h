    class Type_@NAME@ : public JacobianT<Scalar, @COLUMNS@, Type_@NAME@> {
    public:
        EIGEN_MAKE_ALIGNED_OPERATOR_NEW
        Type_@NAME@()
        {
            this->setZero();
            kernels::@NAME@_constants<TRAIT>(this->data());
            update(JState::Zero());
        }
        const Type_@NAME@& update(const JState& q)
        {
@PARAMETERS@            kernels::@NAME@<TRAIT>(@P@raw(q), this->data());
            return *this;
        }
@MEMORY@    };
