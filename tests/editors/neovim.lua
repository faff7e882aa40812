-- Opens each file that is given, asks the server as a user would, and prints what came back as JSON.
local server = vim.json.decode(vim.env.CNCSUB_SERVER)
local root = vim.env.CNCSUB_ROOT
local asked = vim.json.decode(vim.env.CNCSUB_ASKED)
local told = {}

local function wait(ready)
  return vim.wait(30000, ready, 20)
end

for _, ask in ipairs(asked) do
  vim.cmd.edit(vim.fn.fnameescape(ask.file))
  local buffer = vim.api.nvim_get_current_buf()
  local published = false
  vim.api.nvim_create_autocmd("DiagnosticChanged", {
    buffer = buffer,
    callback = function() published = true end,
  })
  local id = vim.lsp.start({ name = "cncsub", cmd = server, root_dir = root })
  wait(function() return published end)
  local found = {}
  for _, each in ipairs(vim.diagnostic.get(buffer)) do
    table.insert(found, { line = each.lnum, column = each.col, code = each.code })
  end
  local place = { line = ask.line, character = ask.column }
  local params = { textDocument = { uri = vim.uri_from_bufnr(buffer) }, position = place }
  local function request(method, more)
    local answers = vim.lsp.buf_request_sync(
      buffer, method, vim.tbl_extend("force", params, more or {}), 30000)
    local answer = answers and answers[id] or {}
    return answer.result or vim.NIL, answer.err and answer.err.message or nil
  end
  local hover = request("textDocument/hover")
  table.insert(told, {
    file = ask.file,
    published = published,
    diagnostics = found,
    definition = request("textDocument/definition"),
    hover = type(hover) == "table" and hover.contents.value or vim.NIL,
    rename = request("textDocument/rename", { newName = "77" }),
    format = request("textDocument/formatting", { options = { tabSize = 2, insertSpaces = true } }),
    symbols = request("textDocument/documentSymbol"),
  })
end
io.stdout:write(vim.json.encode(told) .. "\n")
vim.cmd("qall!")
