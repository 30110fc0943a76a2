using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>new-project DIR</c>: a Unity project that hosts this package, with its tests enabled.</summary>
internal static class NewProjectCommand
{
    public static Command Create(TextWriter output)
    {
        var folder = new Argument<string>("DIR") { Description = "A new or empty folder." };
        var command = new Command(
            "new-project", "Makes a Unity project that hosts this package from where it lies, with its tests enabled.") { folder };
        HelpExamples.Set(command, "Example:\n  new-project ../AlateProject");
        command.SetAction(parsed =>
        {
            string made = UnityProject.Make(parsed.GetValue(folder));
            output.WriteLine($"Made a Unity project in {made}.");
            output.WriteLine($"Open it with Unity {UnityProject.UnityVersion} or newer; the tests are in Window > General > Test Runner.");
            return 0;
        });
        return command;
    }
}
