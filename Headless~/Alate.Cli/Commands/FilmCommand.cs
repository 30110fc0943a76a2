using System.CommandLine;
using UnityEngine;

namespace Alate.Cli;

/// <summary><c>film SPECIES</c>: slow beats as an animated picture, and its frames; or a sample scene.</summary>
internal static class FilmCommand
{
    /// <summary>Memory that the frames of a film may take, bytes.</summary>
    private const long k_Memory = 2L << 30;

    public static Command Create(TextWriter output)
    {
        var options = new FilmOptions();
        var scenes = new SceneOptions();
        var command = new Command(
            "film", "Films an insect in slow motion, or a sample scene in real time: an animated picture, and its frames.");
        options.AddTo(command);
        foreach (Option option in scenes.All)
            command.Options.Add(option);
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            if (scenes.Plan(parsed) is { } scene)
            {
                Run(options.With(parsed, scene), options.Folder(parsed, scene.Scene.Name), output);
                return 0;
            }

            FilmPlan plan = options.Plan(parsed);
            Run(plan, options.Folder(parsed, plan.Flight.Species), output);
            return 0;
        });
        return command;
    }

    private static void Run(SceneFilmPlan plan, string path, TextWriter output)
    {
        long bytes = 4L * plan.Size.x * plan.Size.y * plan.Count;
        if (bytes > k_Memory)
        {
            throw new UserException(FormattableString.Invariant(
                $"{plan.Count} frames of {plan.Size.x} x {plan.Size.y} pixels take {bytes / 1e9:0.0} GB, more than {k_Memory / 1e9:0.0}: ")
                + "take fewer --seconds, or a smaller --rate or --width.");
        }

        using var folder = OutputFolder.Prepare(path, FilmFiles.Film);
        if (plan.VideoFile != null)
            FilmVideo.Check(plan.VideoFile, false);
        var terminal = new Terminal(output);
        terminal.ShowProgress(plan.Count, (done, stage) =>
        {
            stage("playing");
            Color32[][] frames = SceneFilm.Play(plan, done);
            stage("writing");
            string title = $"The sample scene {plan.Scene.Folder}, in real time";
            FilmFiles.Write(folder, IndexedPng.Write(plan.Size.x, plan.Size.y, frames, plan.Rate, true, [title]), frames, plan.Size, false);
            if (plan.VideoFile != null)
                FilmVideo.Write(plan.VideoFile, plan.Size, plan.Rate, frames, null);
        });
        folder.Commit();
        FilmFiles.Show(terminal, path, plan.Count, plan.VideoFile);
    }

    private static void Run(FilmPlan plan, string path, TextWriter output)
    {
        using var folder = OutputFolder.Prepare(path, FilmFiles.Film);
        if (plan.SoundFile != null)
            OutputFile.Check(plan.SoundFile);
        if (plan.VideoFile != null)
            FilmVideo.Check(plan.VideoFile, plan.IsTransparent);
        var terminal = new Terminal(output);
        int count = plan.Beats * plan.Frames;
        terminal.ShowProgress(count, (done, stage) =>
        {
            var film = Film.Fly(plan);
            stage("painting");
            Color32[][] frames = film.Draw(done);
            stage("writing");
            FilmFiles.Write(folder, film.Animation(frames), frames, film.Size, plan.IsTransparent);
            byte[] sound = plan.SoundFile == null ? null : Heard(film);
            if (sound != null)
                OutputFile.Write(plan.SoundFile, stream => stream.Write(sound));
            if (plan.VideoFile != null)
                FilmVideo.Write(plan.VideoFile, film.Size, plan.Rate, frames, sound, plan.IsTransparent);
        });
        folder.Commit();
        FilmFiles.Show(terminal, path, count, plan.SoundFile, plan.VideoFile);
    }

    private static byte[] Heard(Film film)
    {
        using var stream = new MemoryStream();
        WavFile.Write(stream, film.Sound(), BeatSound.Rate);
        return stream.ToArray();
    }

    private const string k_Examples =
        "Examples:\n"
        + "  film monarch --variant expressive --turn 360 --beats 4\n"
        + "  film fishfly --compare --width 1200\n"
        + "  film monarch --free\n"
        + "  film monarch --variant flight --wake --beats 1\n"
        + "  film dragonfly --sound dragonfly.wav\n"
        + "  film monarch --beats 6 --video monarch.mp4\n"
        + "  film monarch --transparent --video monarch.webm\n"
        + "  film dragonfly --backdrop dark --turn 360\n"
        + "  film --scene garden --after 8 --seconds 12\n"
        + "  film --scene swarm --set Insects=100 --video swarm.mp4\n\n"
        + "Writes into the output folder:\n"
        + "  film.png         the film, an animated PNG that browsers and README pages play in a loop, with --free once\n"
        + "  frames/0001.png  its frames\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
