using System.CommandLine;
using System.IO.Compression;
using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary><c>site DIR</c>: the page of the live view with beats that are flown now, for any web server.</summary>
internal static class SiteCommand
{
    private const string k_Index = "insects/index.json";

    /// <summary>States of a beat; the page goes from one to the next in a straight line.</summary>
    private const int k_Frames = 24;

    public static Command Create(TextWriter output)
    {
        var folder = new Argument<string>("DIR") { Description = "Where the site goes." };
        Argument<string[]> species = FlightOptions.AnySpecies();
        Option<string> three = ViewCommand.Three();
        var command = new Command("site", "Writes the page of 'view' as a gallery of insects in flight, for any web server.") { folder,
            species, three };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            List<InsectDefinition> insects = KnownSpecies.FindAny(parsed.GetValue(species), InsectVariant.Standard);
            ThreeSource source = parsed.GetValue(three) is string own ? ThreeSource.Of(own) : ThreeSource.Find();
            Run(parsed.GetValue(folder), insects, source, output);
            return 0;
        });
        return command;
    }

    private static void Run(string path, List<InsectDefinition> insects, ThreeSource three, TextWriter output)
    {
        var page = new PageFiles(three, PageKind.Baked, insects[0]);
        using var folder = OutputFolder.Prepare(path, page.Names.Append(k_Index).ToArray());
        var terminal = new Terminal(output);
        terminal.ShowProgress(insects.Sum(insect => insect.Variants.Count + 1), (done, _) =>
        {
            foreach (string name in page.Names)
                folder.Write(name, stream => stream.Write(page.Find(name)));
            folder.Write(k_Index,
                stream => stream.Write(Encoding.UTF8.GetBytes(SceneMessage.Hello(insects, [ViewSlider.SlowMotion]).ToJsonString())));
            var looks = new Dictionary<string, string>();
            int count = 0;
            foreach (InsectDefinition insect in insects)
            {
                foreach (InsectVariant variant in insect.Variants)
                {
                    Write(folder, looks, $"{insect.Name}-{KnownSpecies.Word(variant)}", ViewSettings.Of(insect, variant));
                    done(++count);
                }

                Write(folder, looks, $"{insect.Name}-standard-parts",
                    ViewSettings.Of(insect, InsectVariant.Standard) with { IsCompared = true });
                done(++count);
            }
        });
        folder.Commit();
        output.WriteLine($"Written into {path}. Any web server shows it: python3 -m http.server -d {path}");
    }

    // Meshes and paintings, which variants have in common, stand in files of their own; states are packed, and unpacked by the page.
    private static void Write(OutputFolder folder, Dictionary<string, string> looks, string name, ViewSettings settings)
    {
        using var insect = new SceneInsect(settings);
        JsonObject scene = insect.Scene, look = SceneMessage.DetachLook(scene);
        string text = look.ToJsonString();
        if (!looks.TryGetValue(text, out string file))
        {
            file = $"insects/{name}-look.json";
            looks.Add(text, file);
            folder.Write(file, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
        }

        scene["look"] = file;
        folder.Write($"insects/{name}.json", stream => stream.Write(Encoding.UTF8.GetBytes(scene.ToJsonString())));
        folder.Write($"insects/{name}.bin", stream =>
        {
            using var packed = new GZipStream(stream, CompressionLevel.SmallestSize, leaveOpen: true);
            insect.Bake(k_Frames, packed);
        });
    }

    private const string k_Examples =
        "Examples:\n"
        + "  site gallery\n"
        + "  site gallery monarch fishfly --three /opt/three\n\n"
        + "Writes into the folder:\n"
        + "  index.html     the page, with its scripts and styles\n"
        + "  insects/       a settled beat of every variant, and of the columns of 'compare'\n"
        + "  three/         three.js, where it was found; else the page loads it from a public server\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
