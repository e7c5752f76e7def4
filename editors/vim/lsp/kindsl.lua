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
  -- Lists open at letters, too, as keywords and names begin with one.
  on_init = function(client)
    local provider = client.server_capabilities.completionProvider
    if provider then
      local letters = vim.split("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", "")
      vim.list_extend(provider.triggerCharacters, letters)
    end
  end,
  handlers = {
    ["window/showMessage"] = function(_, params)
      require("kindsl").show(params.message)
    end,
  },
  get_language_id = function()
    return "kinematics-dsl"
  end,
}
