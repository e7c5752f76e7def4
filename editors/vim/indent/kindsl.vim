" Vim indent file for robots in the Kinematics-DSL, in the style of `kindsl format`: the blocks of
" a robot stand at the margin, what is in them four columns further in.
if exists('b:did_indent')
  finish
endif
let b:did_indent = 1

setlocal indentexpr=kindsl#indent(v:lnum)
setlocal indentkeys=0},!^F,o,O,=RobotBase,=link,=r_joint,=p_joint
let b:undo_indent = 'setlocal indentexpr< indentkeys<'
