using System;
using System.IO;
using System.Linq;
using System.Reflection;
using StandIns;

namespace Alate.FakeEditor;

/// <summary>
/// A Unity editor on the command line, as far as the stand-ins go: appends its arguments to <c>editor-calls.txt</c> in the folder of a
/// proof, enters the project, and calls the method of <c>-executeMethod</c>. Tests, scenes and players are beyond it: it ends with 0 and
/// leaves nothing, as an editor does that was told to quit.
/// </summary>
internal static class FakeEditorProgram
{
    private const string k_Calls = "editor-calls.txt", k_Assembly = "Alate.Proof";

    private static readonly string[] s_Known =
        ["Alate.Proof.ProofCommand.Run", "Alate.Proof.ProofSteps.Import", "Alate.Proof.ProofSteps.Golden"];

    private static int Main(string[] arguments)
    {
        string project = Value(arguments, "-projectPath"), method = Value(arguments, "-executeMethod"), log = Value(arguments, "-logFile");
        if (project == null || log == null)
        {
            Console.Error.WriteLine("An editor needs -projectPath and -logFile.");
            return 1;
        }

        File.WriteAllText(log, string.Join(' ', arguments) + "\n");
        File.AppendAllText(Path.Combine(CallsFolder(log), k_Calls), string.Join(' ', arguments) + "\n");
        if (!s_Known.Contains(method))
            return 0;
        RunningEditor.Path = Environment.ProcessPath;
        RunningEditor.Contents = AppContext.BaseDirectory;
        Environment.CurrentDirectory = project;
        Call(method);
        return RunningEditor.ExitCode ?? 0;
    }

    private static void Call(string method)
    {
        int dot = method.LastIndexOf('.');
        Type type = Assembly.Load(k_Assembly).GetType(method[..dot], true);
        type.GetMethod(method[(dot + 1)..], BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic).Invoke(null, null);
    }

    // Logs of steps are in a folder a pipeline; that of the first editor is beside these.
    private static string CallsFolder(string log)
    {
        string folder = Path.GetDirectoryName(Path.GetFullPath(log));
        return File.Exists(Path.Combine(folder, "start.log")) ? folder : Path.GetDirectoryName(folder);
    }

    private static string Value(string[] arguments, string name)
    {
        int at = Array.IndexOf(arguments, name);
        return at >= 0 && at + 1 < arguments.Length ? arguments[at + 1] : null;
    }
}
