using System.CommandLine;

namespace Alate.Cli;

/// <summary>The options of <c>film</c>, but for those of a sample scene.</summary>
internal sealed class FilmOptions
{
    private readonly Argument<string> m_Species = new("SPECIES")
    {
        Arity = ArgumentArity.ZeroOrOne,
        Description = $"The insect: {KnownSpecies.Names}. None with --scene.",
    };

    private readonly Option<InsectVariant?> m_Variant = FlightOptions.Variant();

    private readonly Option<double?> m_Speed = FlightOptions.Speed();

    private readonly Option<bool> m_Free =
        new("--free") { Description = "The insect flies about by its own wings, and the camera goes along; the film plays once." };

    private readonly Option<bool> m_Compare = new("--compare") { Description = "The four columns of 'compare' beside one another." };

    private readonly Option<bool> m_Wake =
        new("--wake") { Description = "Shows the vortex rings that the wings leave, as 'wake' computes them." };

    private readonly Option<int?> m_Beats = Numbers.OptionalCount("--beats", "N", 1, FilmPlan.MostBeats,
        $"Beats, 1 to {FilmPlan.MostBeats}. [default: {FilmPlan.DefaultBeats}, with --free {FilmPlan.FreeBeats}]");

    private readonly Option<int?> m_Frames = Numbers.OptionalCount(
        "--frames", "N", FilmPlan.LeastFrames, FilmPlan.MostFrames,
        $"Frames of a beat, {FilmPlan.LeastFrames} to {FilmPlan.MostFrames}. [default: "
        + $"{FilmPlan.DefaultFrames}, with --free {FilmPlan.FreeFrames}]");

    private readonly Option<int?> m_Rate = Numbers.OptionalCount(
        "--rate", "N", 1, FilmPlan.MostRate, $"Frames a second, 1 to {FilmPlan.MostRate}. "
        + $"[default: {FilmPlan.DefaultRate}, with --scene {SceneFilmPlan.DefaultRate}]");

    private readonly Option<double> m_Turn = Numbers.Option(
        "--turn", "DEG", 0, -360, 360, "Degrees by which the camera goes around the insect or scene, -360 to 360.");

    private readonly Option<int?> m_Width = Numbers.OptionalCount(
        "--width", "N", FilmPlan.LeastWidth, FilmPlan.MostWidth,
        $"Pixels from side to side, {FilmPlan.LeastWidth} to {FilmPlan.MostWidth}. [default: {FilmPlan.DefaultWidth}]");

    private readonly Option<PictureView?> m_View = FlightOptions.View();

    private readonly Option<bool> m_Transparent = new("--transparent")
    {
        Description = "Nothing lies behind the insect, for a ground of your own: pictures and a .webm video have an opacity.",
    };

    private readonly Option<BackdropLook?> m_Backdrop = FlightOptions.Backdrop("the insect");

    private readonly Option<string> m_Sound = new("--sound")
    {
        HelpName = "FILE.wav",
        Description = "Writes the hum of the wings too, as long as the film: a WAV file, in the insect's own time.",
    };

    private readonly Option<bool> m_SlowSound = new("--slow-sound")
    {
        Description = "With --sound: as slow as the film. Few insects beat fast enough to be heard so.",
    };

    private readonly Option<string> m_Video = new("--video")
    {
        HelpName = "FILE",
        Description = "Writes the film as a video too, .mp4 or .webm, with the sound where there is one. Needs ffmpeg.",
    };

    private readonly Option<string> m_Out = new("--out")
    {
        HelpName = "DIR",
        Description = "Where the files go. [default: out/SPECIES-film, out/NAME-film]",
    };

    private Option[] OfInsects =>
        [m_Variant, m_Speed, m_Free, m_Compare, m_Wake, m_Beats, m_Frames, m_View, m_Transparent, m_Backdrop, m_Sound, m_SlowSound];

    public void AddTo(Command command)
    {
        command.Arguments.Add(m_Species);
        foreach (Option option in (Option[])
        [
            m_Variant, m_Speed, m_Free, m_Compare, m_Wake, m_Beats, m_Frames, m_Rate, m_Turn, m_Width, m_View, m_Transparent, m_Backdrop,
            m_Sound, m_SlowSound, m_Video, m_Out,
        ])
        {
            command.Options.Add(option);
        }
    }

    /// <summary>Folder of the film's files.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="name">Name of the insect or scene.</param>
    public string Folder(ParseResult parsed, string name) => parsed.GetValue(m_Out) ?? Path.Combine("out", name + "-film");

    /// <summary>Adds to a scene's film what films of insects and scenes both take.</summary>
    /// <exception cref="UserException">An insect is named, or an option of films of one is given.</exception>
    public SceneFilmPlan With(ParseResult parsed, SceneFilmPlan scene)
    {
        if (parsed.GetResult(m_Species) is { Tokens.Count: > 0 } named)
            throw new UserException($"--scene shows its own insects; it takes no {Quote.Of(named.Tokens[0].Value)}.");
        if (OfInsects.FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false }) is { } given)
            throw new UserException($"{given.Name} is of one insect; it does not go with --scene.");
        return scene with
        {
            Rate = parsed.GetValue(m_Rate) ?? SceneFilmPlan.DefaultRate,
            Turn = parsed.GetValue(m_Turn),
            Width = parsed.GetValue(m_Width) ?? FilmPlan.DefaultWidth,
            VideoFile = parsed.GetValue(m_Video),
        };
    }

    /// <summary>The film of an insect that is asked for.</summary>
    /// <exception cref="UserException">There is no such insect, or options do not go together.</exception>
    public FilmPlan Plan(ParseResult parsed)
    {
        bool isFree = parsed.GetValue(m_Free);
        Check(parsed, isFree);
        InsectVariant shown = isFree ? InsectVariant.Flight : parsed.GetValue(m_Variant) ?? InsectVariant.Standard;
        var flight = FlightPlan.Cruise(KnownSpecies.Find(parsed.GetValue(m_Species), shown), shown);
        return new FilmPlan
        {
            Flight = flight with
            {
                Speed = parsed.GetValue(m_Speed) ?? flight.Speed,
                View = parsed.GetValue(m_View) ?? PictureView.FrontLeft,
            },
            Columns = parsed.GetValue(m_Compare) ? ComparisonColumn.All : [ComparisonColumn.FullModel],
            IsFree = isFree,
            HasWake = parsed.GetValue(m_Wake),
            IsTransparent = parsed.GetValue(m_Transparent),
            Backdrop = parsed.GetValue(m_Backdrop),
            Beats = parsed.GetValue(m_Beats) ?? (isFree ? FilmPlan.FreeBeats : FilmPlan.DefaultBeats),
            Frames = parsed.GetValue(m_Frames) ?? (isFree ? FilmPlan.FreeFrames : FilmPlan.DefaultFrames),
            Rate = parsed.GetValue(m_Rate) ?? FilmPlan.DefaultRate,
            Turn = parsed.GetValue(m_Turn),
            Width = parsed.GetValue(m_Width) ?? FilmPlan.DefaultWidth,
            SoundFile = parsed.GetValue(m_Sound),
            IsSoundSlow = parsed.GetValue(m_SlowSound),
            VideoFile = parsed.GetValue(m_Video),
        };
    }

    private void Check(ParseResult parsed, bool isFree)
    {
        bool compares = parsed.GetValue(m_Compare), isTransparent = parsed.GetValue(m_Transparent);
        if (parsed.GetValue(m_Species) == null)
            throw new UserException($"film takes an insect ({KnownSpecies.Names}) or --scene NAME.");
        if (isFree && (compares || parsed.GetValue(m_Variant) != null || parsed.GetValue(m_Speed) != null))
            throw new UserException("--free flies with the variant flight; it takes neither --compare, --variant nor --speed.");
        if (parsed.GetValue(m_Wake) && (isFree || compares))
            throw new UserException("--wake goes with one insect on the spot, neither with --free nor with --compare.");
        if (isTransparent && compares)
            throw new UserException("--transparent goes with one insect, not with --compare, whose words need a ground.");
        if (parsed.GetValue(m_Backdrop) != null && (compares || isTransparent))
            throw new UserException("--backdrop is a wall behind one insect; it goes neither with --compare nor with --transparent.");
        if (parsed.GetValue(m_SlowSound) && parsed.GetValue(m_Sound) == null)
            throw new UserException("--slow-sound needs --sound FILE.wav.");
    }
}
