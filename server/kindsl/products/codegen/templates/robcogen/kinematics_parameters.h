
namespace iit {
namespace @NS@ {

@STRUCTS@
@GETTERS@
/** Tells the values that parameters had when this was generated; NaN where they had none. */
class DefaultParamsGetter : public ParamsGetter_lengths, public ParamsGetter_angles {
public:
    DefaultParamsGetter() { resetDefaults(); }
    void resetDefaults()
    {
        lengths.defaults();
        angles.defaults();
    }
@DEFAULTS@
private:
    Params_lengths lengths;
    Params_angles angles;
};

}
}
