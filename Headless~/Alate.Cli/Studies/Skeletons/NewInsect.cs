using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>A new insect of the user's: wings and a few numbers, on a body of the user's or that of one of the catalogue.</summary>
/// <param name="Name">In names of files.</param>
/// <param name="Like">Insect of the catalogue that has the rest.</param>
/// <param name="Mass">Of the whole insect, milligrams.</param>
/// <param name="Frequency">Of the beat, hertz.</param>
internal sealed record NewInsect(string Name, InsectDefinition Like, decimal Mass, decimal Frequency)
{
    /// <summary>Name of the body's file.</summary>
    public const string BodyFile = "body.obj";

    private const string k_Given = "given to 'insect new'";

    /// <summary>Wings, from front to back, and their lengths, millimetres.</summary>
    public IReadOnlyList<(FoundWing Wing, decimal Length)> Wings { get; init; }

    /// <summary>Mesh of the body, and millimetres of one unit of it; null for the body of <see cref="Like"/>.</summary>
    public (string File, decimal Unit)? BodyMesh { get; init; }

    /// <summary>Name of the insect file.</summary>
    public string File => Name + InsectFile.Ending;

    /// <summary>Names of all files.</summary>
    public IEnumerable<string> Files =>
        [File, .. FilesOfWings.SelectMany(wing => wing.All), .. BodyMesh == null ? Array.Empty<string>() : [BodyFile]];

    /// <summary>Files of each wing.</summary>
    public IReadOnlyList<TracedFiles> FilesOfWings =>
        Wings.Count == 1 ? [new TracedFiles("wing")] : [new TracedFiles("fore"), new TracedFiles("hind")];

    /// <summary>Lengths of wings, millimetres, where the first is known: the others as those of another insect.</summary>
    public static decimal LengthBehind(InsectDefinition like, decimal first) =>
        Math.Round(first * (decimal)(SizeOf(like.Wings[1]).wingLength / SizeOf(like.Wings[0]).wingLength), 2);

    /// <summary>Checks that the insect can fly as its file says.</summary>
    /// <exception cref="UserException">It cannot.</exception>
    public void Check()
    {
        for (int k = 0; k < Wings.Count; k++)
            WingFiles.FrameOf(Wings[k].Wing.Skeleton, Wings[k].Wing.Surface, FilesOfWings[k].Mesh);
        if (BodyMesh is { } body && !GlbMesh.IsNamed(body.File))
            TextFile.Read(body.File, ObjReader.Read, InputFile.Mesh);
        else if (BodyMesh != null)
            GlbMesh.Read(BodyMesh.Value.File);
        try
        {
            InsectFile.Read(JsonPlace.Read(new StringReader(Text(hasFiles: false))), File, InputFiles.Instance);
        }
        catch (FormatException problem)
        {
            throw new UserException($"{File} would be no insect that flies: {problem.Message}");
        }
    }

    /// <summary>Writes all files into a folder.</summary>
    public void Write(OutputFolder folder)
    {
        for (int k = 0; k < Wings.Count; k++)
            Wings[k].Wing.Write(folder, FilesOfWings[k]);
        if (BodyMesh is { } body && GlbMesh.IsNamed(body.File))
            folder.Write(BodyFile, stream => stream.Write(GlbMesh.Read(body.File).ToObj()));
        else if (BodyMesh != null)
            folder.Write(BodyFile, stream => InputFile.Copy(BodyMesh.Value.File, InputFile.Mesh, stream));
        folder.Write(File, stream => stream.Write(Encoding.UTF8.GetBytes(Text(hasFiles: true))));
    }

    private string Text(bool hasFiles)
    {
        PresetSize main = SizeOf(Like.Wings[0]);
        double heavier = (double)Mass / (1e6 * main.insectMass);
        var wings = new JsonObject();
        var sources = new JsonArray
        {
            Source("insect mass, frequency", FormattableString.Invariant($"{Mass:0.####} mg, {Frequency:0.####} Hz"), k_Given),
        };
        for (int k = 0; k < Wings.Count; k++)
        {
            string kind = Like.Wings[k].Name;
            var wing = new JsonObject();
            if (hasFiles)
            {
                wing[InsectKeys.Mesh] = FilesOfWings[k].Mesh;
                wing[InsectKeys.Skeleton] = FilesOfWings[k].Skeleton;
                if (Wings[k].Wing.IsTextured)
                    wing[InsectKeys.Texture] = FilesOfWings[k].Picture;
            }

            wing[InsectKeys.OfWing[0].Name] = Wings[k].Length;
            wing[InsectKeys.OfWing[1].Name] = Rounded(heavier * 1e6 * SizeOf(Like.Wings[k]).wingMass);
            wings[kind] = wing;
            string file = Path.GetFileName(Wings[k].Wing.File);
            sources.Add(Source($"{kind}: shape, length", FormattableString.Invariant($"{file}, {Wings[k].Length:0.####} mm"), k_Given));
        }

        var shown = new JsonObject { [InsectKeys.Scale] = Rounded(Math.Cbrt(heavier)) };
        if (BodyMesh is { } mesh)
        {
            if (hasFiles)
                (shown[InsectKeys.Mesh], shown[InsectKeys.MeshUnit]) = (BodyFile, mesh.Unit);
            sources.Add(Source(
                "body: shape", FormattableString.Invariant($"{Path.GetFileName(mesh.File)}, {mesh.Unit:0.######} mm a unit"), k_Given));
        }

        sources.Add(Source(
            "mass of the wings, body, motion", "as written",
            $"those of the {Like.DisplayName}: its share of the mass, its body at this mass"));
        return PrettyJson.Write(new JsonObject
        {
            [InsectKeys.VersionKey] = InsectKeys.Version,
            [InsectKeys.Name] = Name,
            [InsectKeys.Like] = Like.Name,
            [InsectKeys.OfInsect[0].Name] = Mass,
            [InsectKeys.Beat] = new JsonObject { [InsectKeys.Frequency] = Frequency },
            [InsectKeys.Wings] = wings,
            [InsectKeys.Body] = shown,
            [InsectKeys.Sources] = sources,
        });
    }

    private static JsonObject Source(string quantity, string value, string source) => new()
    {
        [InsectKeys.Quantity] = quantity,
        [InsectKeys.Value] = value,
        [InsectKeys.Source] = source,
    };

    // Four digits.
    private static decimal Rounded(double value) =>
        Math.Round((decimal)value, Math.Clamp(3 - (int)Math.Floor(Math.Log10(value)), 0, 12));

    private static PresetSize SizeOf(WingDefinition wing)
    {
        WingPreset preset = wing.CreatePreset();
        PresetSize size = preset.Size;
        UnityEngine.Object.DestroyImmediate(preset);
        return size;
    }
}
