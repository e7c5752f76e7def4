autocmd BufRead,BufNewFile *.kindsl setfiletype kindsl
