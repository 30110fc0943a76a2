using UnityEngine;

namespace Alate.Cli;

/// <summary>Files of a film in its folder.</summary>
internal static class FilmFiles
{
    /// <summary>The film, an animated PNG file.</summary>
    public const string Film = "film.png";

    /// <summary>Writes the film and its frames.</summary>
    /// <param name="folder">Where they go.</param>
    /// <param name="animation">The film.</param>
    /// <param name="frames">[frame] Rows from above.</param>
    /// <param name="size">Columns and rows.</param>
    /// <param name="hasOpacity">True where pixels are seen through.</param>
    public static void Write(OutputFolder folder, byte[] animation, Color32[][] frames, int2 size, bool hasOpacity)
    {
        folder.Write(Film, stream => stream.Write(animation));
        byte[][] files = Concurrently.Map(
            frames, 8L * size.x * size.y, frame => TrueColourPng.Write(size.x, size.y, frame, [], hasOpacity));
        for (int k = 0; k < frames.Length; k++)
            folder.Write(Path.Combine("frames", $"{k + 1:0000}.png"), stream => stream.Write(files[k]));
    }

    /// <summary>Says where the files are.</summary>
    /// <param name="terminal">Where.</param>
    /// <param name="path">The folder.</param>
    /// <param name="count">Number of frames.</param>
    /// <param name="others">Files elsewhere; null is none.</param>
    public static void Show(Terminal terminal, string path, int count, params string[] others)
    {
        string numbered = Path.Combine("frames", $"0001.png … {count:0000}.png");
        terminal.ShowFiles(path, [Film, numbered, .. others.Where(file => file != null).Select(Path.GetFullPath)]);
    }
}
