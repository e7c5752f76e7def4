
namespace iit {
namespace @NS@ {
namespace dyn {

/** The parameters of links' inertia. */
@STRUCT@
/** What tells their values. */
@GETTER@
}
}
}
