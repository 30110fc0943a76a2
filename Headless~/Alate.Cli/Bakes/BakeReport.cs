using Alate.Crowds;

namespace Alate.Cli;

/// <summary>Bakes a plan, writes all of its files or none, and shows what the bake differs from the flown wings by.</summary>
internal static class BakeReport
{
    /// <exception cref="UserException">Anything the user can mend; nothing has been written then.</exception>
    public static void Run(BakePlan plan, TextWriter output)
    {
        using var folder = OutputFolder.Prepare(plan.Folder);
        InsectBake bake = plan.Bake(out float smallerError);
        string[] files = plan.Format switch
        {
            BakeFormat.GltfSkin => [Write(folder, $"{bake.Name}-skin.glb", stream => SkinGlb.Write(bake, plan.Pictures, stream))],
            BakeFormat.GltfMorph => [Write(folder, $"{bake.Name}-morph.glb", stream => MorphGlb.Write(bake, plan.Pictures, stream))],
            BakeFormat.Usd => WriteUsd(folder, plan, bake),
            _ => WriteOpenVat(folder, plan, bake),
        };
        folder.Commit();
        var terminal = new Terminal(output);
        terminal.ShowTable($"{plan.DisplayName}: {bake.Surface.VertexCount} vertices, {bake.Surface.TriangleCount} triangles", Rows(bake));
        if (smallerError > 0f)
        {
            output.WriteLine(
                $"The smaller mesh is {Number(100f * smallerError)} % of the wing length from the whole wings (root of the mean square).");
        }
        terminal.ShowFiles(plan.Folder, files);
    }

    private static string[] WriteOpenVat(OutputFolder folder, BakePlan plan, InsectBake bake)
    {
        OpenVat vat;
        try
        {
            vat = new OpenVat(bake, plan.MaxSize, plan.Normals == BakeNormals.Packed);
        }
        catch (BakeException problem)
        {
            throw new UserException(problem.Message);
        }

        string stem = Path.Combine($"{bake.Name}_vat", bake.Name);
        var files = new List<string> { Write(folder, stem + ".png", vat.Positions.Write) };
        if (plan.Normals == BakeNormals.Separate)
            files.Add(Write(folder, stem + "-vnrm.png", vat.Normals.Write));
        files.Add(Write(folder, stem + "-remap_info.json", vat.WriteJson));
        files.Add(Write(folder, stem + ".glb", stream => vat.WriteMesh(plan.Pictures, stream)));
        return files.ToArray();
    }

    private static string[] WriteUsd(OutputFolder folder, BakePlan plan, InsectBake bake)
    {
        var materials = new UsdMaterials(bake, plan.Pictures);
        string within = $"{bake.Name}_usd";
        return
        [
            Write(folder, Path.Combine(within, bake.Name + ".usda"), stream => SkinUsd.Write(bake, materials, stream)),
            .. materials.Files.Select(file => Write(folder, Path.Combine(within, file.File), stream => stream.Write(file.Png))),
        ];
    }

    private static string Write(OutputFolder folder, string name, System.Action<Stream> write)
    {
        folder.Write(name, write);
        return name;
    }

    /// <summary>A row for each clip with what its bake differs from the flown wings by, under a heading.</summary>
    public static IEnumerable<IReadOnlyList<string>> Rows(InsectBake bake)
    {
        yield return ["clip", "frames", "loop Hz", "between frames %", "normals °", "loop end %", "linear skin %"];
        foreach (BakedClip clip in bake.Clips)
        {
            string frames = clip.Frames.Count.ToString(CultureInfo.InvariantCulture);
            if (clip.Path != null)
            {
                yield return [clip.Name, frames, $"once, {Number(1f / clip.Frequency)} s", "", "", "", ""];
                continue;
            }

            yield return
            [
                clip.Name, frames, Number(clip.Frequency),
                Number(100f * clip.Error.between),
                Number(clip.Error.normalBetween), Number(100f * clip.Error.closure), Number(100f * clip.Error.linearSkin),
            ];
        }
    }

    private static string Number(float value) => value.ToString("0.00", CultureInfo.InvariantCulture);
}
