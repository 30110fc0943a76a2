using System.Text.Json;

namespace Alate.Cli;

/// <summary>
/// An insect file that a viewer dropped on the page with the files that it names. They are read in a folder of their own, which is removed
/// at once, and name nothing beside it.
/// </summary>
internal static class DroppedInsect
{
    private static readonly string[] s_Files =
        [InsectKeys.Mesh, InsectKeys.Skeleton, InsectKeys.Texture, InsectKeys.Kinematics, InsectKeys.Trims];

    private static readonly string[] s_ObjFiles = ["mtllib ", "map_Kd "];

    /// <summary>The insect file among dropped files; null where there is none.</summary>
    public static DroppedFile Find(IReadOnlyList<DroppedFile> files)
    {
        var named = files.Where(file => file.Name.EndsWith(InsectFile.Ending, StringComparison.OrdinalIgnoreCase)).ToList();
        var texts = files.Where(file => KnownSpecies.IsFile(file.Name)).ToList();
        return named.Count == 1 ? named[0] : named.Count == 0 && texts.Count == 1 ? texts[0] : null;
    }

    /// <summary>Reads the insect.</summary>
    /// <param name="insect">The insect file.</param>
    /// <param name="files">All that was dropped.</param>
    /// <exception cref="UserException">It is none, or names a file that was not dropped.</exception>
    public static InsectDefinition Read(DroppedFile insect, IReadOnlyList<DroppedFile> files)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("alate-dropped-");
        try
        {
            string main = Write(folder.FullName, insect.Name, insect.Content);
            foreach (string path in PathsIn(insect))
            {
                DroppedFile file = files.FirstOrDefault(dropped => dropped.Name == Path.GetFileName(path)) ?? throw new UserException(
                    $"{insect.Name}: it names {Quote.Of(path)}. Drop that file together with it.");
                Write(folder.FullName, path, file.Content);
            }

            // Materials and their pictures lie beside the meshes that name them.
            foreach (DroppedFile file in files)
            {
                CheckObj(file);
                foreach (string beside in PathsIn(insect).Select(path => Path.GetDirectoryName(path) ?? "").Distinct())
                    Write(folder.FullName, Path.Combine(beside, file.Name), file.Content);
            }

            return InsectFile.Read(main, InputFiles.Instance);
        }
        catch (UserException problem)
        {
            throw new UserException(problem.Message.Replace(folder.FullName + Path.DirectorySeparatorChar, ""));
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            throw new UserException($"{insect.Name}: {FileProblem.Reason(problem)}");
        }
        finally
        {
            folder.Delete(true);
        }
    }

    private static string Write(string folder, string path, byte[] content)
    {
        string full = IsWithin(path)
            ? Path.Combine(folder, path)
            : throw new UserException($"The file {Quote.Of(path)} lies outside of the folder of the insect file; put it beside it.");
        Directory.CreateDirectory(Path.GetDirectoryName(full));
        File.WriteAllBytes(full, content);
        return full;
    }

    private static bool IsWithin(string path) =>
        !Path.IsPathRooted(path) && !path.Contains(':') && !path.Split('/', '\\').Contains("..") && !FileProblem.IsNoName(path);

    // What is no JSON is told by the reader, with its line.
    private static List<string> PathsIn(DroppedFile insect)
    {
        var paths = new List<string>();
        try
        {
            using var json = JsonDocument.Parse(insect.Content, new JsonDocumentOptions { MaxDepth = 16 });
            AddPaths(json.RootElement, paths);
        }
        catch (JsonException)
        {
        }

        return paths;
    }

    private static void AddPaths(JsonElement element, List<string> paths)
    {
        if (element.ValueKind != JsonValueKind.Object)
            return;
        foreach (JsonProperty property in element.EnumerateObject())
        {
            if (property.Value.ValueKind == JsonValueKind.String && s_Files.Contains(property.Name))
                paths.Add(property.Value.GetString());
            AddPaths(property.Value, paths);
        }
    }

    private static void CheckObj(DroppedFile file)
    {
        if (Path.GetExtension(file.Name).ToLowerInvariant() is not (".obj" or ".mtl"))
            return;
        foreach (string line in Encoding.UTF8.GetString(file.Content).Split('\n').Select(line => line.Trim()))
        {
            string start = Array.Find(s_ObjFiles, word => line.StartsWith(word, StringComparison.Ordinal));
            if (start != null && !IsWithin(line[start.Length..].Trim()))
            {
                throw new UserException(
                    $"{file.Name}: it names {Quote.Of(line[start.Length..].Trim())} outside of its folder; put that file beside it.");
            }
        }
    }
}
