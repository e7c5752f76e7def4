" Attaches to the language server through ALE as docs/editors.md says; quits with an error if no
" diagnostic comes, or if it stays when its cause is gone.
set nocompatible noswapfile viminfo=
filetype plugin on
packadd ale
autocmd BufRead,BufNewFile *.kindsl setfiletype kinematics-dsl
let s:server = json_decode($KINDSL_SERVER)
call ale#linter#Define('kinematics-dsl', {
\   'name': 'kindsl',
\   'lsp': 'stdio',
\   'executable': s:server[0],
\   'command': '%e ' . join(s:server[1:]),
\   'project_root': {buffer -> fnamemodify(bufname(buffer), ':p:h')},
\})

function! s:Errors() abort
  return filter(copy(ale#engine#GetLoclist(bufnr(''))), 'v:val.type is# "E"')
endfunction

function! s:Wait(is_there) abort
  let l:start = reltime()
  while reltimefloat(reltime(l:start)) < 20 && empty(s:Errors()) == a:is_there
    sleep 50m
  endwhile
  return empty(s:Errors()) != a:is_there
endfunction

execute 'edit' fnameescape($KINDSL_DOCUMENT)
ALELint
let s:seen = s:Wait(1)
let s:found = map(copy(s:Errors()), 'v:val.lnum . ": " . v:val.text')
call search('missing via')
delete _
ALELint
let s:cleared = s:Wait(0)
let s:steps = ['diagnostic: ' . (s:seen ? 'true' : 'false'), 'cleared: ' . (s:cleared ? 'true' : 'false')]
call writefile(s:steps + s:found, 'steps')
silent! ALEStopAllLSPs
if s:seen && s:cleared
  qall!
endif
cquit!
