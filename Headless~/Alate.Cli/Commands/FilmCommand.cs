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
        var species = new Argument<string>("SPECIES")
        {
            Arity = ArgumentArity.ZeroOrOne,
            Description = $"The insect: {KnownSpecies.Names}. None with --scene.",
        };
        var scenes = new SceneOptions();
        Option<InsectVariant?> variant = FlightOptions.Variant();
        Option<double?> speed = FlightOptions.Speed();
        var free = new Option<bool>("--free")
        {
            Description =
            "The insect flies about by its own wings, and the camera goes along; the film plays once."
        };
        var compare = new Option<bool>("--compare") { Description = "The four columns of 'compare' beside one another." };
        var wake = new Option<bool>("--wake") { Description = "Shows the vortex rings that the wings leave, as 'wake' computes them." };
        var transparent = new Option<bool>("--transparent")
        {
            Description = "Nothing lies behind the insect, for a ground of your own: pictures and a .webm video have an opacity.",
        };
        Option<BackdropLook?> backdrop = FlightOptions.Backdrop("the insect");
        Option<int?> beats = Numbers.OptionalCount("--beats", "N", 1, FilmPlan.MostBeats,
            $"Beats, 1 to {FilmPlan.MostBeats}. [default: {FilmPlan.DefaultBeats}, with --free {FilmPlan.FreeBeats}]");
        Option<int?> frames = Numbers.OptionalCount(
            "--frames", "N", FilmPlan.LeastFrames, FilmPlan.MostFrames,
            $"Frames of a beat, {FilmPlan.LeastFrames} to {FilmPlan.MostFrames}. [default: "
            + $"{FilmPlan.DefaultFrames}, with --free {FilmPlan.FreeFrames}]");
        Option<int?> rate = Numbers.OptionalCount(
            "--rate", "N", 1, FilmPlan.MostRate, $"Frames a second, 1 to {FilmPlan.MostRate}. "
            + $"[default: {FilmPlan.DefaultRate}, with --scene {SceneFilmPlan.DefaultRate}]");
        Option<double> turn = Numbers.Option(
            "--turn", "DEG", 0, -360, 360, "Degrees by which the camera goes around the insect or scene, -360 to 360.");
        Option<int?> width = Numbers.OptionalCount(
            "--width", "N", FilmPlan.LeastWidth, FilmPlan.MostWidth,
            $"Pixels from side to side, {FilmPlan.LeastWidth} to {FilmPlan.MostWidth}. [default: {FilmPlan.DefaultWidth}]");
        Option<PictureView?> view = FlightOptions.View();
        var sound = new Option<string>("--sound")
        {
            HelpName = "FILE.wav",
            Description = "Writes the hum of the wings too, as long as the film: a WAV file, in the insect's own time.",
        };
        var slowSound = new Option<bool>("--slow-sound")
        {
            Description = "With --sound: as slow as the film. Few insects beat fast enough to be heard so.",
        };
        var video = new Option<string>("--video")
        {
            HelpName = "FILE",
            Description = "Writes the film as a video too, .mp4 or .webm, with the sound where there is one. Needs ffmpeg.",
        };
        var folder = new Option<string>("--out")
        {
            HelpName = "DIR",
            Description = "Where the files go. [default: out/SPECIES-film, out/NAME-film]",
        };
        var command = new Command(
            "film", "Films an insect in slow motion, or a sample scene in real time: an animated picture, and its frames.")
        {
            species, variant, speed, free, compare, wake, beats, frames, rate, turn, width, view, transparent, backdrop, sound, slowSound,
            video, folder,
        };
        foreach (Option option in scenes.All)
            command.Options.Add(option);
        HelpExamples.Set(command, k_Examples);
        Option[] ofInsects = [variant, speed, free, compare, wake, beats, frames, view, transparent, backdrop, sound, slowSound];
        command.SetAction(parsed =>
        {
            if (scenes.Plan(parsed) is { } shownScene)
            {
                Refuse(parsed, species, ofInsects);
                shownScene = shownScene with
                {
                    Rate = parsed.GetValue(rate) ?? SceneFilmPlan.DefaultRate,
                    Turn = parsed.GetValue(turn),
                    Width = parsed.GetValue(width) ?? FilmPlan.DefaultWidth,
                    VideoFile = parsed.GetValue(video),
                };
                Run(shownScene, parsed.GetValue(folder) ?? Path.Combine("out", shownScene.Scene.Name + "-film"), output);
                return 0;
            }

            if (parsed.GetValue(species) == null)
                throw new UserException($"film takes an insect ({KnownSpecies.Names}) or --scene NAME.");
            bool isFree = parsed.GetValue(free);
            if (isFree && (parsed.GetValue(compare) || parsed.GetValue(variant) != null || parsed.GetValue(speed) != null))
                throw new UserException("--free flies with the variant flight; it takes neither --compare, --variant nor --speed.");
            if (parsed.GetValue(wake) && (isFree || parsed.GetValue(compare)))
                throw new UserException("--wake goes with one insect on the spot, neither with --free nor with --compare.");
            if (parsed.GetValue(transparent) && parsed.GetValue(compare))
                throw new UserException("--transparent goes with one insect, not with --compare, whose words need a ground.");
            if (parsed.GetValue(backdrop) != null && (parsed.GetValue(compare) || parsed.GetValue(transparent)))
                throw new UserException("--backdrop is a wall behind one insect; it goes neither with --compare nor with --transparent.");
            if (parsed.GetValue(slowSound) && parsed.GetValue(sound) == null)
                throw new UserException("--slow-sound needs --sound FILE.wav.");
            InsectVariant shown = isFree ? InsectVariant.Flight : parsed.GetValue(variant) ?? InsectVariant.Standard;
            InsectDefinition insect = KnownSpecies.Find(parsed.GetValue(species), shown);
            var flight = FlightPlan.Cruise(insect, shown);
            var plan = new FilmPlan
            {
                Flight = flight with
                {
                    Speed = parsed.GetValue(speed) ?? flight.Speed,
                    View = parsed.GetValue(view)
                    ?? PictureView.FrontLeft
                },
                Columns = parsed.GetValue(compare) ? ComparisonColumn.All : [ComparisonColumn.FullModel],
                IsFree = isFree,
                HasWake = parsed.GetValue(wake),
                IsTransparent = parsed.GetValue(transparent),
                Backdrop = parsed.GetValue(backdrop),
                Beats = parsed.GetValue(beats) ?? (isFree ? FilmPlan.FreeBeats : FilmPlan.DefaultBeats),
                Frames = parsed.GetValue(frames) ?? (isFree ? FilmPlan.FreeFrames : FilmPlan.DefaultFrames),
                Rate = parsed.GetValue(rate) ?? FilmPlan.DefaultRate,
                Turn = parsed.GetValue(turn),
                Width = parsed.GetValue(width) ?? FilmPlan.DefaultWidth,
                SoundFile = parsed.GetValue(sound),
                IsSoundSlow = parsed.GetValue(slowSound),
                VideoFile = parsed.GetValue(video),
            };
            Run(plan, parsed.GetValue(folder) ?? Path.Combine("out", insect.Name + "-film"), output);
            return 0;
        });
        return command;
    }

    private static void Refuse(ParseResult parsed, Argument species, IEnumerable<Option> ofInsects)
    {
        if (parsed.GetResult(species) is { Tokens.Count: > 0 } named)
            throw new UserException($"--scene shows its own insects; it takes no {Quote.Of(named.Tokens[0].Value)}.");
        if (ofInsects.FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false }) is { } given)
            throw new UserException($"{given.Name} is of one insect; it does not go with --scene.");
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
