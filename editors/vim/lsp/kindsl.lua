-- For Neovim 0.11 and later: vim.lsp.enable("kindsl")
return {
  cmd = { "kindsl-language-server" },
  filetypes = { "kindsl" },
  root_markers = { "kindsl.toml", "pyproject.toml", ".git" },
  get_language_id = function()
    return "kinematics-dsl"
  end,
}
