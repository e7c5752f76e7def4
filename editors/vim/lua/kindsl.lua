-- What Neovim does with the language server beyond what its client does by itself.
local M = {}

local function clients(buffer)
  local get = vim.lsp.get_clients or vim.lsp.get_active_clients
  return vim.tbl_filter(function(client)
    return client.name == "kindsl" and client.attached_buffers[buffer] ~= nil
  end, get())
end

local function tell(text, level)
  vim.notify("kindsl: " .. text, level or vim.log.levels.INFO)
end

--- Ask the server to show a buffer's robot in the browser; false if no server is attached.
function M.preview(buffer)
  buffer = buffer == 0 and vim.api.nvim_get_current_buf() or buffer
  local client = clients(buffer)[1]
  if not client then
    return false
  end
  local params = { command = "kindsl.preview", arguments = { vim.uri_from_bufnr(buffer) } }
  vim.lsp.buf_request(buffer, "workspace/executeCommand", params, function(problem, answer)
    if problem then
      tell(problem.message, vim.log.levels.ERROR)
    elseif answer and answer.url then
      vim.g.kindsl_preview = answer.url
      tell("preview at " .. answer.url)
    end
  end)
  return true
end

--- Show what the server says on one line, when the command under way is over: for more, and for what
--- follows it at once, Neovim asks to press ENTER. The client's log has the whole text.
function M.show(message)
  local text = ("kindsl: " .. message):gsub("%s+", " ")
  vim.defer_fn(function()
    vim.lsp.log.warn(text)
    local room = vim.v.echospace
    local is_long = vim.fn.strdisplaywidth(text) > room
    local shown = is_long and vim.fn.strcharpart(text, 0, room - 1) .. "…" or text
    vim.api.nvim_echo({ { shown, "WarningMsg" } }, not is_long, {})
  end, 100)
end

return M
