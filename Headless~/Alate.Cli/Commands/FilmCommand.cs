using System.CommandLine;
using UnityEngine;

namespace Alate.Cli;

/// <summary><c>film SPECIES</c>: slow beats as an animated picture, and its frames.</summary>
internal static class FilmCommand
{
    private const string k_Film = "film.png";

    public static Command Create(TextWriter output)
    {
        var species = new Argument<string>("SPECIES") { Description = $"The insect: {KnownSpecies.Names}." };
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
        Option<int?> beats = Numbers.OptionalCount("--beats", "N", 1, FilmPlan.MostBeats,
            $"Beats, 1 to {FilmPlan.MostBeats}. [default: {FilmPlan.DefaultBeats}, with --free {FilmPlan.FreeBeats}]");
        Option<int?> frames = Numbers.OptionalCount(
            "--frames", "N", FilmPlan.LeastFrames, FilmPlan.MostFrames,
            $"Frames of a beat, {FilmPlan.LeastFrames} to {FilmPlan.MostFrames}. [default: "
            + $"{FilmPlan.DefaultFrames}, with --free {FilmPlan.FreeFrames}]");
        Option<int?> rate = Numbers.OptionalCount(
            "--rate", "N", 1, FilmPlan.MostRate, $"Frames a second, 1 to {FilmPlan.MostRate}. [default: {FilmPlan.DefaultRate}]");
        Option<double> turn = Numbers.Option(
            "--turn", "DEG", 0, -360, 360, "Degrees by which the camera goes around the insect, -360 to 360.");
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
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/SPECIES-film]" };
        var command = new Command("film", "Films an insect in slow motion: an animated picture, and its frames.")
        {
            species, variant, speed, free, compare, wake, beats, frames, rate, turn, width, view, transparent, sound, slowSound,
            video, folder,
        };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            bool isFree = parsed.GetValue(free);
            if (isFree && (parsed.GetValue(compare) || parsed.GetValue(variant) != null || parsed.GetValue(speed) != null))
                throw new UserException("--free flies with the variant flight; it takes neither --compare, --variant nor --speed.");
            if (parsed.GetValue(wake) && (isFree || parsed.GetValue(compare)))
                throw new UserException("--wake goes with one insect on the spot, neither with --free nor with --compare.");
            if (parsed.GetValue(transparent) && parsed.GetValue(compare))
                throw new UserException("--transparent goes with one insect, not with --compare, whose words need a ground.");
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

    private static void Run(FilmPlan plan, string path, TextWriter output)
    {
        using var folder = OutputFolder.Prepare(path, k_Film);
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
            folder.Write(k_Film, stream => stream.Write(film.Animation(frames)));
            byte[][] files = Concurrently.Map(frames, 8L * film.Size.x * film.Size.y,
                frame => TrueColourPng.Write(film.Size.x, film.Size.y, frame, [], plan.IsTransparent));
            for (int k = 0; k < count; k++)
                folder.Write(Path.Combine("frames", $"{k + 1:0000}.png"), stream => stream.Write(files[k]));
            byte[] sound = plan.SoundFile == null ? null : Heard(film);
            if (sound != null)
                OutputFile.Write(plan.SoundFile, stream => stream.Write(sound));
            if (plan.VideoFile != null)
                FilmVideo.Write(plan.VideoFile, film.Size, plan.Rate, frames, sound, plan.IsTransparent);
        });
        folder.Commit();
        string numbered = Path.Combine("frames", $"0001.png … {count:0000}.png");
        string[] others = [.. new[] { plan.SoundFile, plan.VideoFile }.Where(file => file != null).Select(Path.GetFullPath)];
        terminal.ShowFiles(path, [k_Film, numbered, .. others]);
    }

    private static byte[] Heard(Film film)
    {
        using var stream = new MemoryStream();
        WavFile.Write(stream, film.Sound(), FilmSound.Rate);
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
        + "  film monarch --transparent --video monarch.webm\n\n"
        + "Writes into the output folder:\n"
        + "  film.png         the film, an animated PNG that browsers and README pages play in a loop, with --free once\n"
        + "  frames/0001.png  its frames\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
