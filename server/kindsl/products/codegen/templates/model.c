@PREFIX@_parameters @PREFIX@_default_parameters(void)
{
    @PREFIX@_parameters parameters;
@FIELDS@
    return parameters;
}

@SETUP@
void @PREFIX@_model_init(@PREFIX@_model *model, const @PREFIX@_parameters *parameters)
{
    @PREFIX@_set_up(parameters, model->c);
}

@DEFAULT@const char *@PREFIX@_joint_name(int joint)
{
    static const char *const names[@MACRO@_NJ] = {@JOINTS@};
    return joint >= 0 && joint < @MACRO@_NJ ? names[joint] : NULL;
}
