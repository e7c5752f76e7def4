
    /** The inertia of all bodies together. */
    const InertiaMatrix& getWholeBodyInertia() const
    {
        whole = this->template topLeftCorner<6, 6>();
        return whole;
    }
    /** What joint accelerations take of the base's wrench. */
    const BlockF_t getF() const
    {
        return static_cast<const MatrixType&>(*this).template block<6, @NJ@>(0, 6);
    }
    /** The joints' part, as if the base were fixed. */
    const BlockFixedBase_t getFixedBaseBlock() const
    {
        return static_cast<const MatrixType&>(*this).template block<@NJ@, @NJ@>(6, 6);
    }
