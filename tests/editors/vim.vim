" Attaches to the language server through ALE as docs/editors.md says; quits with an error if no
" diagnostic comes, or if it stays when its cause is gone.
set nocompatible noswapfile viminfo=
let &runtimepath = $KINDSL_VIM . ',' . &runtimepath
filetype plugin indent on
syntax on
packadd ale

function! s:Errors() abort
  return filter(copy(ale#engine#GetLoclist(bufnr(''))), 'v:val.type is# "E"')
endfunction

function! s:Wait(is_there) abort
  let l:start = reltime()
  while reltimefloat(reltime(l:start)) < 60 && empty(s:Errors()) == a:is_there
    sleep 50m
  endwhile
  return empty(s:Errors()) != a:is_there
endfunction

execute 'edit' fnameescape($KINDSL_DOCUMENT)
let s:known = [&filetype is# 'kindsl', &commentstring is# '// %s',
\   synIDattr(synID(search('^link'), 1, 1), 'name') is# 'kindslBlock', exists(':KindslPreview') == 2]
let s:before = getline(1, '$')
silent %left
silent normal! gg=G
let s:known += [getline(1, '$') == map(s:before, 'v:val is# "  id=1" ? "    id=1" : v:val')]
ALELint
let s:seen = s:Wait(1)
let s:found = map(copy(s:Errors()), 'v:val.lnum . ": " . v:val.text')
call search('missing via')
delete _
ALELint
let s:cleared = s:Wait(0)
let s:steps = ['known: ' . string(s:known), 'diagnostic: ' . (s:seen ? 'true' : 'false'), 'cleared: ' . (s:cleared ? 'true' : 'false')]
call writefile(s:steps + s:found, 'steps')
silent! ALEStopAllLSPs
if s:seen && s:cleared && index(s:known, 0) < 0
  qall!
endif
cquit!
