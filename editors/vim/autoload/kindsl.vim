" What Vim and Neovim do with robots in the Kinematics-DSL beyond what a language client does.

" The indent of a line: by the braces of the last line that is not empty.
function! kindsl#indent(lnum) abort
  let l:line = s:Code(getline(a:lnum))
  if l:line =~# '^\s*\%(RobotBase\|link\|r_joint\|p_joint\)\>'
    return 0
  endif
  let l:last = prevnonblank(a:lnum - 1)
  if l:last == 0
    return 0
  endif
  let l:before = s:Code(getline(l:last))
  let l:indent = indent(l:last)
  if l:before =~# '{\s*$' && l:before !~# '^\s*Robot\>'
    let l:indent += shiftwidth()
  endif
  if l:line =~# '^\s*}'
    let l:indent -= shiftwidth()
  endif
  return max([l:indent, 0])
endfunction

" Shows the robot in the browser: through the language server if one is attached, else by the
" command `kindsl preview`.
function! kindsl#preview() abort
  if has('nvim') && luaeval('require("kindsl").preview(0)')
    return
  endif
  let l:uri = 'file://' . substitute(expand('%:p'), '[^A-Za-z0-9/._~-]', '\=s:Encoded(submatch(0))', 'g')
  let l:params = {'command': 'kindsl.preview', 'arguments': [l:uri]}
  if exists('*lsp#send_request') && index(lsp#get_server_names(), 'kindsl') >= 0
    call lsp#send_request('kindsl', {'method': 'workspace/executeCommand', 'params': l:params})
  elseif s:IsAleOn()
    let l:message = [0, 'workspace/executeCommand', l:params]
    call ale#lsp_linter#SendRequest(bufnr(''), 'kindsl', l:message)
  else
    call s:Run(['kindsl', 'preview', expand('%:p')])
  endif
endfunction

" A line without its comment.
function! s:Code(line) abort
  return substitute(a:line, '//.*$\|/\*.\{-}\*/', '', 'g')
endfunction

function! s:Encoded(character) abort
  return join(map(range(len(a:character)), 'printf("%%%02X", char2nr(a:character[v:val]))'), '')
endfunction

function! s:IsAleOn() abort
  if !exists('*ale#linter#Get') && !exists('g:loaded_ale')
    return 0
  endif
  return !empty(filter(copy(ale#linter#Get(&filetype)), 'v:val.name is# "kindsl"'))
endfunction

function! s:Run(command) abort
  if !executable(a:command[0])
    echohl ErrorMsg | echo 'kindsl is not installed: pip install "kindsl[all]"' | echohl None
  elseif has('nvim')
    call jobstart(a:command)
  else
    let s:job = job_start(a:command)
  endif
endfunction
