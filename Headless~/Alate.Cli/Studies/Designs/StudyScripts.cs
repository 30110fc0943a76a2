using System.Text.Encodings.Web;
using System.Text.Json;

namespace Alate.Cli;

/// <summary>Scripts by which clusters fly a study: an array of jobs of Slurm, and an indexed job of Kubernetes.</summary>
internal static class StudyScripts
{
    /// <summary>Folder of the package in an image of a container.</summary>
    private const string k_Image = "/alate";

    /// <summary>Most jobs.</summary>
    public const int MostJobs = 10_000;

    /// <summary>study.sbatch: <c>sbatch study.sbatch</c> submits it.</summary>
    /// <param name="name">Name of the study.</param>
    /// <param name="file">The study file, a full path that all nodes see.</param>
    /// <param name="folder">Its folder, a full path that all nodes see.</param>
    /// <param name="jobs">Number of jobs.</param>
    public static string Slurm(string name, string file, string folder, int jobs) =>
        "#!/bin/bash\n"
        + $"#SBATCH --job-name={name}\n"
        + $"#SBATCH --array=1-{jobs}\n"
        + "#SBATCH --ntasks=1\n"
        + "#SBATCH --cpus-per-task=1\n"
        + "#SBATCH --requeue\n"
        + $"#SBATCH --output={folder}/slurm-%a.log\n"
        + "# A job that is stopped, requeued or submitted again flies what is left of its share.\n"
        + "set -eu\n"
        + $"if [ -n \"${{ALATE:-}}\" ]; then set -- \"$ALATE\"; else set -- dotnet {Quoted(Program)}; fi\n"
        + $"exec \"$@\" study {Quoted(file)} --out {Quoted(folder)} --shard \"$SLURM_ARRAY_TASK_ID/{jobs}\" --workers 1\n";

    /// <summary>study.yaml: <c>kubectl apply -f study.yaml</c> submits it.</summary>
    /// <param name="name">Name of the study.</param>
    /// <param name="file">The study file, a full path.</param>
    /// <param name="folder">Its folder, a full path.</param>
    /// <param name="read">Full paths of the files that it reads.</param>
    /// <param name="jobs">Number of jobs.</param>
    public static string Kubernetes(string name, string file, string folder, IEnumerable<string> read, int jobs)
    {
        List<string> folders = Outermost([folder, Path.GetDirectoryName(file), .. read.Select(Path.GetDirectoryName)]);
        string program = $"{k_Image}/{Path.GetRelativePath(PackageRoot.Find(), Program)}";
        string command = $"exec dotnet {Quoted(program)} study {Quoted(file)} --out {Quoted(folder)} "
            + $"--shard $((JOB_COMPLETION_INDEX + 1))/{jobs} --workers 1";
        return $"# Fill in IMAGE, with .NET 10 and this package, built, in {k_Image}, and CLAIM, a volume with these folders:\n"
            + string.Concat(folders.Select((mounted, k) => $"#   {Part(k)}: what is in {mounted} here\n"))
            + "apiVersion: batch/v1\n"
            + "kind: Job\n"
            + "metadata:\n"
            + $"  name: {Label(name)}\n"
            + "spec:\n"
            + "  completionMode: Indexed\n"
            + $"  completions: {jobs}\n"
            + $"  parallelism: {jobs}\n"
            + "  backoffLimitPerIndex: 10\n"
            + "  template:\n"
            + "    spec:\n"
            + "      restartPolicy: Never\n"
            + "      containers:\n"
            + "        - name: study\n"
            + "          image: IMAGE\n"
            + "          command:\n"
            + "            - /bin/sh\n"
            + "            - -c\n"
            + $"            - {Scalar(command)}\n"
            + "          resources:\n"
            + "            requests:\n"
            + "              cpu: \"1\"\n"
            + "              memory: 512Mi\n"
            + "          volumeMounts:\n"
            + string.Concat(folders.Select((mounted, k) =>
                $"            - name: study\n              mountPath: {Scalar(mounted)}\n              subPath: {Part(k)}\n"))
            + "      volumes:\n"
            + "        - name: study\n"
            + "          persistentVolumeClaim:\n"
            + "            claimName: CLAIM\n";
    }

    private static string Part(int number) => number == 0 ? "study" : $"input-{number}";

    // Each once, without those that lie in another one.
    private static List<string> Outermost(IEnumerable<string> folders)
    {
        List<string> all = [.. folders.Distinct()];
        return all.FindAll(folder => !all.Exists(other => other != folder && folder.StartsWith(
            other.TrimEnd(Path.DirectorySeparatorChar) + Path.DirectorySeparatorChar, StringComparison.Ordinal)));
    }

    // As names of Kubernetes are (RFC 1123): small letters, digits and hyphens, up to 63.
    private static string Label(string name)
    {
        const int k_Most = 63;
        string small = string.Concat(name.ToLowerInvariant().Select(letter => char.IsAsciiLetterOrDigit(letter) ? letter : '-')).Trim('-');
        return small.Length == 0 ? "study" : small[..Math.Min(small.Length, k_Most)].TrimEnd('-');
    }

    // A string of JSON is one of YAML.
    private static string Scalar(string text) =>
        JsonSerializer.Serialize(text, new JsonSerializerOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });

    // As a shell reads it.
    private static string Quoted(string word) => $"'{word.Replace("'", "'\\''")}'";

    private static string Program => typeof(StudyScripts).Assembly.Location;
}
