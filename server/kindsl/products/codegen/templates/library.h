@STAMP@
/* SI units and radians. Vectors are in base coordinates unless said otherwise; spatial vectors hold
 * the angular part first. Matrices are stored by rows. Joints are in the order of the links' ids.
 * With a floating base its six rows and columns come first.
 *
 * Functions are pure: no allocation, no global state, no errno. Arguments must not overlap results.
 * What is not finite, or a motion that nothing resists, gives results that are not finite.
 */
#ifndef @MACRO@_H
#define @MACRO@_H
#ifdef __cplusplus
extern "C" {
#endif

#define @MACRO@_DOCUMENT_SHA256 "@SHA256@"
#define @MACRO@_NJ @NJ@ /* joints */
#define @MACRO@_NV @NV@ /* velocity variables */
#define @MACRO@_NB @NB@ /* bodies, base first */
#define @MACRO@_NPOSES @NPOSES@ /* links, then frames */

typedef @REAL@ @PREFIX@_real;

@JOINTS@
@BODIES@
@POSES@
@PARAMETERS@
/* What depends on parameters only, computed once. */
typedef struct @PREFIX@_model {
    @PREFIX@_real c[@SIZE@];
} @PREFIX@_model;

@SETUP@
@FUNCTIONS@
/* The same for n configurations: arguments and results hold n of them one after the other, but
 * there is one g for all. */
@BATCHES@
#ifdef __cplusplus
}
#endif
#endif
