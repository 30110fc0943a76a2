using System.Diagnostics;
using System.Runtime.InteropServices;
using UnityEngine;

namespace Alate.Cli;

/// <summary>A film as a video file, by the program ffmpeg where it is installed.</summary>
internal static class FilmVideo
{
    private const string k_Program = "ffmpeg";

    /// <summary>Ending of videos that have an opacity.</summary>
    private const string k_SeenThrough = ".webm";

    /// <summary>[ending] Codecs of picture and sound: H.264 for editors and players, VP9 for pages.</summary>
    private static readonly Dictionary<string, (string[] Picture, string[] Sound)> s_Formats = new()
    {
        [".mp4"] = (["-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"], ["-c:a", "aac", "-b:a", "160k"]),
        [".webm"] = (["-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0"], ["-c:a", "libopus", "-b:a", "128k"]),
    };

    /// <summary>Checks that a video can be written, before anything is flown.</summary>
    /// <param name="file">Where it goes.</param>
    /// <param name="isTransparent">True where pixels are seen through.</param>
    /// <exception cref="UserException">It cannot.</exception>
    public static void Check(string file, bool isTransparent)
    {
        if (!s_Formats.ContainsKey(Ending(file)))
            throw new UserException($"--video takes a file that ends in .mp4 or .webm, not {Quote.Of(file)}.");
        if (isTransparent && Ending(file) != k_SeenThrough)
        {
            throw new UserException($"--transparent goes into a video that ends in {k_SeenThrough}, not {Quote.Of(file)}: H.264 has no "
                + "opacity.");
        }

        OutputFile.Check(file);
        if (!IsInstalled())
        {
            throw new UserException("--video needs the program ffmpeg, which was not found: install it (https://ffmpeg.org), or leave "
                + "--video out and use the frames.");
        }
    }

    /// <summary>Writes a video.</summary>
    /// <param name="file">Where it goes.</param>
    /// <param name="size">Pixels of a frame.</param>
    /// <param name="rate">Frames a second.</param>
    /// <param name="frames">[frame] Pixels, rows from above.</param>
    /// <param name="sound">WAV file as long as the film; null for none.</param>
    /// <param name="isTransparent">True where pixels are seen through.</param>
    /// <exception cref="UserException">It cannot be written.</exception>
    public static void Write(string file, int2 size, int rate, IReadOnlyList<Color32[]> frames, byte[] sound, bool isTransparent = false)
    {
        string folder = Directory.CreateTempSubdirectory("alate-").FullName;
        try
        {
            string made = Path.Combine(folder, "film" + Ending(file)), heard = null;
            if (sound != null)
                File.WriteAllBytes(heard = Path.Combine(folder, "film.wav"), sound);
            Encode([.. Words(size, rate, heard, s_Formats[Ending(file)], isTransparent), made], frames);
            OutputFile.Write(file, stream => stream.Write(File.ReadAllBytes(made)));
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    // Four pixels of a video share a colour, so that its sides are even: an odd one gets a line of paper.
    private static string[] Words(
        int2 size, int rate, string sound, (string[] Picture, string[] Sound) format, bool isTransparent) =>
    [
        "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgba", "-s", $"{size.x}x{size.y}", "-r", $"{rate}", "-i", "-",
        .. sound == null ? [] : new[] { "-i", sound },
        "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=" + (isTransparent ? "0x00000000,format=yuva420p" : "0xf7f4ec,format=yuv420p"),
        .. format.Picture, .. isTransparent ? ["-auto-alt-ref", "0"] : Array.Empty<string>(),
        .. sound == null ? [] : format.Sound,
    ];

    private static void Encode(string[] words, IReadOnlyList<Color32[]> frames)
    {
        var start = new ProcessStartInfo(k_Program, words) { RedirectStandardInput = true, RedirectStandardError = true };
        using var process = Process.Start(start);
        System.Threading.Tasks.Task<string> told = process.StandardError.ReadToEndAsync();
        try
        {
            using Stream input = process.StandardInput.BaseStream;
            foreach (Color32[] frame in frames)
                input.Write(MemoryMarshal.AsBytes(frame.AsSpan()));
        }
        catch (IOException)
        {
            // It ended before: its own words say why.
        }

        process.WaitForExit();
        string last = told.Result.Trim().Split('\n')[^1];
        if (process.ExitCode != 0)
            throw new UserException($"ffmpeg could not make the video: {last}");
    }

    private static bool IsInstalled()
    {
        try
        {
            using var process = Process.Start(
                new ProcessStartInfo(k_Program, ["-version"]) { RedirectStandardOutput = true, RedirectStandardError = true });
            process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return process.ExitCode == 0;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return false;
        }
    }

    private static string Ending(string file) => Path.GetExtension(file).ToLowerInvariant();
}
