-- Attaches to the language server as docs/editors.md says, then uses it like a hand would.
-- Prints one line `name: true|false ...` a step; quits with an error if one is false.
vim.opt.swapfile = false
vim.cmd("filetype plugin indent on | syntax on")

vim.api.nvim_create_autocmd("FileType", {
  pattern = "kindsl",
  callback = function(event)
    local config = {
      name = "kindsl",
      cmd = { "kindsl-language-server" },
      root_dir = vim.fn.fnamemodify(event.file, ":p:h"),
    }
    if vim.lsp.start then
      vim.lsp.start(config)
    else
      vim.lsp.buf_attach_client(event.buf, vim.lsp.start_client(config))
    end
  end,
})

local all_is_well = true
local function step(name, is_well, more)
  all_is_well = all_is_well and is_well
  io.stdout:write(("%s: %s %s\n"):format(name, tostring(is_well), more or ""))
end

local function wait(condition)
  return vim.wait(60000, condition, 20)
end

local function text()
  return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), "\n")
end

local function ask(method, line, character, more)
  local params = vim.tbl_extend("force", {
    textDocument = vim.lsp.util.make_text_document_params(0),
    position = { line = line, character = character },
  }, more or {})
  for _, answer in pairs(vim.lsp.buf_request_sync(0, method, params, 60000) or {}) do
    return answer.result
  end
end

local function apply(edit)
  local client = vim.lsp.get_active_clients()[1]
  vim.lsp.util.apply_workspace_edit(edit, client.offset_encoding)
end

vim.cmd("edit " .. vim.env.KINDSL_DOCUMENT)
step("filetype", vim.bo.filetype == "kindsl", vim.bo.filetype)
step("comments", vim.bo.commentstring == "// %s", vim.bo.commentstring)
local group = vim.fn.synIDattr(vim.fn.synID(vim.fn.search("^link"), 1, 1), "name")
step("syntax", group == "kindslBlock", group)
step("diagnostic", wait(function() return #vim.diagnostic.get(0) > 0 end))
for _, found in ipairs(vim.diagnostic.get(0)) do
  io.stdout:write(("  %d:%d %s %s\n"):format(found.lnum + 1, found.col + 1, found.source, found.message))
end

local hover = ask("textDocument/hover", 6, 6)
step("hover", hover ~= nil and vim.inspect(hover):find("arm") ~= nil)

local offered = ask("textDocument/completion", 8, 18)
step("completion", offered ~= nil and #(offered.items or offered) > 0)

apply(ask("textDocument/rename", 6, 6, { newName = "forearm" }))
step("rename", text():find("link forearm") ~= nil and text():find("forearm via") ~= nil)

vim.lsp.buf.formatting_sync(nil, 60000)
step("format", text():find("\n    id = 1") ~= nil)

vim.cmd("let &undolevels = &undolevels") -- what follows is a step of its own
local before, steps = text(), vim.fn.undotree().seq_last
local number = { kind = "joint", name = "shoulder", component = "z", value = 0.6 }
local answer = ask("workspace/executeCommand", 0, 0, {
  command = "kindsl.setComponent",
  arguments = { vim.lsp.util.make_text_document_params(0).uri, number },
})
local is_set = wait(function() return text() ~= before end)
local is_one = vim.fn.undotree().seq_last == steps + 1
local written = text():find("translation = (height, 0.0, 0.6)", 1, true) ~= nil
vim.cmd("undo")
step("set", answer ~= nil and answer.applied and is_set and written)
step("undone", is_one and text() == before)

local formatted = text()
vim.cmd("silent %left")
vim.cmd("silent normal! gg=G")
step("indent", text() == formatted, text())

vim.cmd("KindslPreview")
step("preview", wait(function()
  return (vim.g.kindsl_preview or ""):find("^http://127%.0%.0%.1:%d+/") ~= nil
end))

local line = vim.fn.search("missing via")
vim.api.nvim_buf_set_lines(0, line - 1, line, false, {})
local function errors()
  return vim.diagnostic.get(0, { severity = vim.diagnostic.severity.ERROR })
end
step("cleared", wait(function() return #errors() == 0 end), vim.inspect(errors()))

for _, client in ipairs(vim.lsp.get_active_clients()) do
  client.stop()
end
step("stopped", wait(function() return #vim.lsp.get_active_clients() == 0 end))
vim.cmd(all_is_well and "qa!" or "cq!")
