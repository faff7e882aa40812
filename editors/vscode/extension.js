// Starts `cncsub lsp` for NC programs and `cncsub dap` for their debugging.
"use strict";

const vscode = require("vscode");

const LANGUAGE = "nc";
let client;

/** Return the words that start a command of cncsub. */
function command(...words) {
  const [program, ...first] = vscode.workspace.getConfiguration("cncsub").get("command");
  return { command: program, args: [...first, ...words] };
}

/** Return the client of the library, or nothing where the extension was packed without it. */
function languageClient() {
  try {
    return require("vscode-languageclient/node");
  } catch {
    vscode.window.showWarningMessage(
      "cncsub: this extension was packed without vscode-languageclient, so that no server is started;" +
        " run `npm install --omit=dev` in editors/vscode and pack it again"
    );
    return undefined;
  }
}

async function start() {
  const library = languageClient();
  if (library === undefined) return;
  const settings = vscode.workspace.getConfiguration("cncsub");
  const options = {
    documentSelector: [{ language: LANGUAGE }, { scheme: "file", pattern: "**/cncsub.toml" }],
    initializationOptions: {
      control: settings.get("control"),
      run: settings.get("run"),
      maxBlocks: settings.get("maxBlocks"),
      maxSeconds: settings.get("maxSeconds"),
      debug: true,
    },
    synchronize: {
      configurationSection: "cncsub", // changed settings count at once
      fileEvents: vscode.workspace.createFileSystemWatcher("**/*"),
    },
  };
  client = new library.LanguageClient("cncsub", "cncsub", command("lsp"), options);
  await client.start();
}

/** Ask the server for a command about the program that is open. */
function onServer(name) {
  return async () => {
    const editor = vscode.window.activeTextEditor;
    if (client === undefined || editor === undefined) return;
    await client.sendRequest("workspace/executeCommand", {
      command: name,
      arguments: [editor.document.uri.fsPath],
    });
  };
}

async function debug(path, main) {
  const program = path ?? vscode.window.activeTextEditor?.document.uri.fsPath;
  if (program === undefined) return;
  const control = vscode.workspace.getConfiguration("cncsub").get("control") ?? undefined;
  await vscode.debug.startDebugging(undefined, {
    type: "cncsub",
    request: "launch",
    name: "NC program",
    program,
    main,
    control,
    stopOnEntry: true,
  });
}

const adapters = {
  createDebugAdapterDescriptor() {
    const { command: program, args } = command("dap");
    return new vscode.DebugAdapterExecutable(program, args);
  },
};

const tasks = {
  provideTasks() {
    return ["check", "run"].map((task) => taskOf({ type: "cncsub", task }));
  },
  resolveTask(task) {
    return taskOf(task.definition);
  },
};

function taskOf(definition) {
  const { command: program, args } = command(definition.task, "${file}");
  const execution = new vscode.ProcessExecution(program, args);
  const scope = vscode.TaskScope.Workspace;
  return new vscode.Task(definition, scope, definition.task, "cncsub", execution, "$cncsub");
}

async function activate(context) {
  const commands = {
    "cncsub.runProgram": onServer("cncsub.run"),
    "cncsub.plotProgram": onServer("cncsub.plot"),
    "cncsub.renumberProgram": onServer("cncsub.renumber"),
    "cncsub.debugProgram": debug,
    "cncsub.restart": async () => {
      await client?.stop();
      await start();
    },
  };
  for (const [name, run] of Object.entries(commands)) {
    context.subscriptions.push(vscode.commands.registerCommand(name, run));
  }
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory("cncsub", adapters),
    vscode.tasks.registerTaskProvider("cncsub", tasks)
  );
  await start();
}

function deactivate() {
  return client?.stop();
}

module.exports = { activate, deactivate };
