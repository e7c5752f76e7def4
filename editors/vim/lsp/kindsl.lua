-- For Neovim 0.11 and later: vim.lsp.enable("kindsl")
return {
  cmd = { "kindsl-language-server" },
  filetypes = { "kindsl" },
  root_markers = { "kindsl.toml", "pyproject.toml", ".git" },
  -- One server for all below its folder: a kindsl.toml that appears there starts no second one.
  reuse_client = function(client, config)
    local old, new = client.root_dir, config.root_dir
    local is_below = not old or not new or vim.fs.relpath(old, new) ~= nil
    return client.name == config.name and is_below
  end,
  get_language_id = function()
    return "kinematics-dsl"
  end,
}
