" Vim syntax file for robots in the Kinematics-DSL.
if exists('b:current_syntax')
  finish
endif

syntax keyword kindslBlock Robot RobotBase link r_joint p_joint
syntax keyword kindslSection id inertia_params inertia_properties children frames ref_frame mass CoM Ix Iy Iz Ixy Ixz Iyz translation rotation
syntax keyword kindslWord floating via
syntax keyword kindslConstant PI Pi pI pi
syntax match kindslNumber /\%(\w\)\@<![-+]\?\d*\.\d\+\%([eE][-+]\?\d\+\)\?/
syntax match kindslNumber /\<\d\+\>/
syntax match kindslName /\%(\<\%(Robot\|RobotBase\|link\|r_joint\|p_joint\)\s\+\)\@<=\h\w*/
syntax keyword kindslTodo TODO FIXME XXX contained
syntax region kindslComment start='//' end='$' contains=kindslTodo,@Spell
syntax region kindslComment start='/\*' end='\*/' contains=kindslTodo,@Spell fold
syntax region kindslBody start='{' end='}' transparent fold

syntax sync fromstart

highlight default link kindslBlock Structure
highlight default link kindslSection Keyword
highlight default link kindslWord Statement
highlight default link kindslConstant Constant
highlight default link kindslNumber Number
highlight default link kindslName Identifier
highlight default link kindslTodo Todo
highlight default link kindslComment Comment

let b:current_syntax = 'kindsl'
