-- Neovim 0.11 as docs/editors.md sets it up: its own client, then a hand that types while a list is
-- asked for at each key and Enter takes what is chosen, as completion plugins do.
-- Prints one line `name: true|false ...` a step; quits with an error if one is false.
vim.opt.swapfile = false
vim.opt.showmode = false
vim.opt.completeopt = { "menuone", "noinsert" }

local all_is_well = true
local function step(name, is_well, more)
  all_is_well = all_is_well and is_well
  io.stdout:write(("%s: %s %s\n"):format(name, tostring(is_well), is_well and "" or more or ""))
end

local function wait(condition)
  return (vim.wait(60000, condition, 10))
end

local function lines()
  return vim.api.nvim_buf_get_lines(0, 0, -1, false)
end

local function text()
  return table.concat(lines(), "\n")
end

local function find(pattern)
  return function()
    for _, found in ipairs(vim.diagnostic.get(0)) do
      if (found.code .. " " .. found.message):find(pattern) then
        return true
      end
    end
    return false
  end
end

local function not_find(pattern)
  return function()
    return #vim.diagnostic.get(0) > 0 and not find(pattern)()
  end
end

local toml = vim.fs.joinpath(vim.fs.dirname(vim.env.KINDSL_DOCUMENT), "kindsl.toml")
vim.fn.delete(toml)
vim.lsp.enable("kindsl")
vim.cmd("edit " .. vim.env.KINDSL_DOCUMENT)
step("filetype", vim.bo.filetype == "kindsl", vim.bo.filetype)
step("comments", vim.bo.commentstring == "// %s", vim.bo.commentstring)
local group = vim.fn.synIDattr(vim.fn.synID(vim.fn.search("^link"), 1, 1), "name")
step("syntax", group == "kindslBlock", group)

step("diagnostic", wait(find("missing")), vim.inspect(vim.diagnostic.get(0)))
local client = vim.lsp.get_clients({ name = "kindsl" })[1]

local function ask(method, line, column)
  local params = {
    textDocument = vim.lsp.util.make_text_document_params(0),
    position = { line = line, character = column },
    range = { start = { line = 0, character = 0 }, ["end"] = { line = #lines(), character = 0 } },
  }
  return client:request_sync(method, params, 60000, 0).result
end

step("hover", vim.inspect(ask("textDocument/hover", 6, 6)):find("arm") ~= nil)
step("hints", #ask("textDocument/inlayHint", 0, 0) > 0)

vim.lsp.buf.format({ timeout_ms = 60000 })
step("format", text():find("\n    id = 1") ~= nil, text())
local formatted = lines()
vim.cmd("silent %left")
vim.cmd("silent normal! gg=G")
step("indent", vim.deep_equal(lines(), formatted), text())

step("unbound", wait(find("KD401")), vim.inspect(vim.diagnostic.get(0)))
vim.fn.writefile({ "[parameters]", "height = 0.5" }, toml)
step("configuration", wait(not_find("KD401")), vim.inspect(vim.diagnostic.get(0)))

vim.cmd("KindslPreview")
step("preview", wait(function()
  return (vim.g.kindsl_preview or ""):find("^http://127%.0%.0%.1:%d+/") ~= nil
end))

-- The hand: a timer presses the next key once nothing is under way that the last one began.
local typed = vim.fn.readfile(vim.env.KINDSL_TYPED)
vim.cmd("edit! " .. vim.fs.joinpath(vim.fs.dirname(vim.env.KINDSL_DOCUMENT), "new.kindsl"))
step("one server", wait(function()
  return client.attached_buffers[vim.api.nvim_get_current_buf()] == true
end) and #vim.lsp.get_clients({ name = "kindsl" }) == 1)
vim.bo.autoindent = false
vim.bo.indentexpr = ""
vim.lsp.completion.enable(true, client.id, 0, { autotrigger = false })
vim.keymap.set("i", "<CR>", function()
  return vim.fn.pumvisible() == 1 and "<C-y>" or "<CR>"
end, { expr = true })
-- As nvim-cmp does: at each key of a word, and behind the characters that the server names.
local triggers = client.server_capabilities.completionProvider.triggerCharacters
local asked = -1
vim.api.nvim_create_autocmd({ "TextChangedI", "TextChangedP" }, {
  callback = function()
    if vim.b.changedtick == asked then
      return
    end
    asked = vim.b.changedtick
    local before = vim.fn.getline("."):sub(vim.fn.col(".") - 1, vim.fn.col(".") - 1)
    if vim.list_contains(triggers, before) then
      vim.lsp.completion.get({ ctx = { triggerKind = 2, triggerCharacter = before } })
    elseif before:match("[%w_]") then
      vim.lsp.completion.get({ ctx = { triggerKind = 1 } })
    end
  end,
})

vim.cmd.startinsert()
local keys = {}
for _, line in ipairs(typed) do
  for index = 1, #line do
    table.insert(keys, line:sub(index, index) == "<" and "<lt>" or line:sub(index, index))
  end
  table.insert(keys, "<CR>")
end

local function is_busy()
  for _, request in pairs(client.requests) do
    if request.type == "pending" then
      return true
    end
  end
  return false
end

local has_seen_lists = false

local function finish()
  local expected = table.concat(typed, "\n")
  local got = text():gsub("\n*$", "")
  step("typed", got == expected, "\n" .. got)
  step("lists", has_seen_lists)
  vim.cmd(all_is_well and "qa!" or "cq!")
end

local pressed, quiet, known, timer = 0, 0, -1, vim.uv.new_timer()
timer:start(0, 2, vim.schedule_wrap(function()
  local changed = vim.b.changedtick ~= known
  quiet = (is_busy() or not changed) and 0 or quiet + 1
  if quiet < 5 or timer:is_closing() then
    return
  end
  quiet, known = 0, vim.b.changedtick
  has_seen_lists = has_seen_lists or vim.fn.pumvisible() == 1
  pressed = pressed + 1
  if keys[pressed] then
    vim.api.nvim_input(keys[pressed])
  else
    timer:close()
    finish()
  end
end))
