" For ALE: finds this by itself in the runtime path.
call ale#Set('kindsl_executable', 'kindsl-language-server')

call ale#linter#Define('kindsl', {
\   'name': 'kindsl',
\   'lsp': 'stdio',
\   'executable': {buffer -> ale#Var(buffer, 'kindsl_executable')},
\   'command': '%e',
\   'language': 'kinematics-dsl',
\   'project_root': {buffer -> fnamemodify(bufname(buffer), ':p:h')},
\})
