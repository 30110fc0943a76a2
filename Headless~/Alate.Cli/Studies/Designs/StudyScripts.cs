namespace Alate.Cli;

/// <summary>Scripts by which clusters fly a study: an array of jobs of Slurm, and an indexed job of Kubernetes.</summary>
internal static class StudyScripts
{
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
    /// <inheritdoc cref="Slurm"/>
    public static string Kubernetes(string name, string file, string folder, int jobs) =>
        "# Fill in the image, with .NET 10 and the command line in /alate, and the volume, with the study's folder.\n"
        + "apiVersion: batch/v1\n"
        + "kind: Job\n"
        + "metadata:\n"
        + $"  name: {name}\n"
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
        + $"            - exec dotnet /alate/Alate.Cli.dll study {Quoted(file)} --out {Quoted(folder)} --shard "
        + $"$((JOB_COMPLETION_INDEX + 1))/{jobs} --workers 1\n"
        + "          resources:\n"
        + "            requests:\n"
        + "              cpu: \"1\"\n"
        + "              memory: 512Mi\n"
        + "          volumeMounts:\n"
        + "            - name: study\n"
        + $"              mountPath: {folder}\n"
        + "      volumes:\n"
        + "        - name: study\n"
        + "          persistentVolumeClaim:\n"
        + "            claimName: CLAIM\n";

    // As a shell reads it.
    private static string Quoted(string word) => $"'{word.Replace("'", "'\\''")}'";

    private static string Program => typeof(StudyScripts).Assembly.Location;
}
