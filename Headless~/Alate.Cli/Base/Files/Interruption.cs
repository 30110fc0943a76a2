using System.Runtime.InteropServices;
using System.Threading;

namespace Alate.Cli;

/// <summary>
/// Ends the program when the user presses Ctrl-C, or the system asks for it: removes what unfinished folders hold, shows the cursor again,
/// and leaves with the exit code that a shell expects, 128 and the signal's number.
/// </summary>
internal static class Interruption
{
    private const int k_SignalExit = 128;

    private static readonly (PosixSignal Signal, int Number)[] s_Signals =
        [(PosixSignal.SIGINT, 2), (PosixSignal.SIGTERM, 15), (PosixSignal.SIGHUP, 1)];

    private static readonly List<OutputFolder> s_Unfinished = [];

    /// <summary>Held while files are made, renamed or removed: none of that happens once the program is ending.</summary>
    public static Lock Files { get; } = new();

    /// <summary>Watches for signals until it is disposed.</summary>
    public static IDisposable Watch() => new Registrations(Array.ConvertAll(
        s_Signals, known => PosixSignalRegistration.Create(known.Signal, context =>
        {
            context.Cancel = true;
            End(k_SignalExit + known.Number);
        })));

    /// <summary>Takes a folder that is to be removed when the program is stopped; the lock on <see cref="Files"/> is held.</summary>
    public static void Add(OutputFolder folder) => s_Unfinished.Add(folder);

    /// <summary>Lets go of a folder that is finished; the lock on <see cref="Files"/> is held.</summary>
    public static void Remove(OutputFolder folder) => s_Unfinished.Remove(folder);

    private static void End(int exitCode)
    {
        // Held to the end: the program's other threads make no more files.
        Files.Enter();
        foreach (OutputFolder folder in s_Unfinished.ToArray())
            folder.Remove();
        ShowCursor();
        Environment.Exit(exitCode);
    }

    // The bar of progress hides it.
    private static void ShowCursor()
    {
        try
        {
            if (Console.IsOutputRedirected)
                return;
            Console.CursorVisible = true;
            Console.Out.WriteLine();
        }
        catch (IOException)
        {
            // The terminal is gone, and its cursor with it.
        }
    }

    private sealed class Registrations(PosixSignalRegistration[] signals) : IDisposable
    {
        public void Dispose() => Array.ForEach(signals, signal => signal.Dispose());
    }
}
