using System.CommandLine;
using System.ComponentModel;
using System.Diagnostics;
using System.Threading;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary><c>view [SPECIES]</c>: serves a page on which an insect flies, or a sample scene plays, and answers to sliders.</summary>
internal static class ViewCommand
{
    private const string k_First = "monarch";

    public static Command Create(TextWriter output)
    {
        var species = new Argument<string>("SPECIES")
        {
            Arity = ArgumentArity.ZeroOrOne,
            Description = $"The insect that flies first: {KnownSpecies.Names}. [default: {k_First}]",
        };
        Option<InsectVariant?> variant = FlightOptions.Variant();
        var scene = new Option<string>("--scene")
        {
            HelpName = "NAME",
            Description = $"A sample scene of the package plays on the page, in place of an insect: {SampleScene.Names}.",
        };
        Option<int?> port = Numbers.OptionalCount(
            "--port", "N", 0, 65535, $"Port on this machine, 0 to 65535; 0 is any that is free. [default: {ViewServer.DefaultPort}]");
        Option<string> three = Three();
        var silent = new Option<bool>("--no-browser") { Description = "Opens no browser." };
        var command =
            new Command("view", "Opens a page in which an insect flies, by the real simulation, and answers to sliders.") { species,
            variant, scene, port, three, silent };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            (IServedView view, string shown) = parsed.GetValue(scene) is string name
                ? Scene(name, parsed.GetValue(species) != null || parsed.GetValue(variant) != null)
                : Insect(parsed.GetValue(species) ?? k_First, parsed.GetValue(variant) ?? InsectVariant.Standard);
            ThreeSource source = parsed.GetValue(three) is string folder ? ThreeSource.Of(folder) : ThreeSource.Find();
            Serve(view, shown, parsed.GetValue(port) ?? ViewServer.DefaultPort, source, !parsed.GetValue(silent), output);
            return 0;
        });
        return command;
    }

    /// <summary>The option for a folder with three.js.</summary>
    public static Option<string> Three() => new("--three")
    {
        HelpName = "DIR",
        Description = $"A folder with three.js {ThreeSource.Version}. [default: found by itself, else a public server]",
    };

    private static (IServedView View, string Shown) Insect(string name, InsectVariant variant)
    {
        InsectDefinition insect = KnownSpecies.Find(name, variant);
        return (new InsectView(insect, variant), $"The {insect.DisplayName} flies");
    }

    private static (IServedView View, string Shown) Scene(string name, bool hasInsect)
    {
        if (hasInsect)
            throw new UserException("A scene has its own insects: leave out SPECIES and --variant, or --scene.");
        var scene = SampleScene.Find(name);
        return (new SampleView(scene), $"The sample {scene.Name} plays");
    }

    private static void Serve(IServedView view, string shown, int port, ThreeSource three, bool opens, TextWriter output)
    {
        ViewServer server = ViewServer.Start(view, port, three).GetAwaiter().GetResult();
        output.WriteLine($"{shown} at {server.Address}  (Ctrl-C stops)");
        output.Flush();
        if (opens)
            Open(server.Address.ToString());
        server.Simulation.RunUntil(Task.Delay(Timeout.Infinite));
    }

    // Where there is no browser the address stands on the terminal.
    private static void Open(string address)
    {
        try
        {
            using var browser = Process.Start(new ProcessStartInfo(address) { UseShellExecute = true });
        }
        catch (Exception problem) when (problem is Win32Exception or PlatformNotSupportedException or InvalidOperationException
            or FileNotFoundException)
        {
        }
    }

    private const string k_Examples =
        "Examples:\n"
        + "  view\n"
        + "  view firefly --variant expressive --port 8080\n"
        + "  view --scene garden\n"
        + "  view --three /opt/three\n\n"
        + "The page has all species and variants, sliders, the columns of 'compare', and overlays: skeleton, loads, angle of attack, "
        + "stretch, lift and\n"
        + "drag. A wing of your own (OBJ, PNG or JPEG) or an insect file flies when it is dropped on the page; its beat can be saved as\n"
        + "GLB.\n\n"
        + "With --scene a sample of the package plays on the page, with its own panel: drag to turn its camera, drag with Shift to move,\n"
        + "scroll to come nearer. One page at a time shows it.\n\n"
        + "Listens on the loopback only; nothing of it is seen from another machine.\n\n"
        + "Exit code: 2 for bad usage or a port that is taken, 130 when stopped by Ctrl-C.\n";
}
