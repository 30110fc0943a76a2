using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>figures</c>: draws and measures again what the documentation's pages of species and accuracy show.</summary>
internal static class FiguresCommand
{
    private const string k_Page = "species.md", k_Sweep = "images/sweep-elasticity.png", k_SweepCharts = "images/sweep-elasticity.svg",
        k_Gallery = "images/insects.png", k_Materials = "images/materials.png",
        k_Film = "images/monarch-film.png", k_Stretch = "images/stretch-monarch.png", k_Veins = "images/veins.svg",
        k_Wake = "images/wake-monarch.png", k_OwnFilm = "images/mymoth-film.png",
        k_Way = "images/flight-monarch.png", k_Front = "images/study.svg", k_Study = "studies/hover.study.json";

    /// <summary>Pixels of the picture of all insects.</summary>
    internal const int GalleryWidth = 900;

    private const string k_Hero = "monarch";
    private const int k_Phases = 3;

    /// <summary>Substeps of the flights behind the page's numbers: within 5 % of their limit, the lift too.</summary>
    internal const int MeasuredSubsteps = 96;

    /// <summary>The softest wing of the sweep needs as many to converge.</summary>
    private const int k_SweptSubsteps = 480;

    public static Command Create(TextWriter output)
    {
        var folder = new Argument<string>("DIR")
        {
            Description = $"The folder of the documentation, with {k_Page}, {AccuracyFigures.Page}, {FlightFigures.Page}, "
                + $"{WakeFigures.Page} and {PerformanceFigures.Page} in it.",
            DefaultValueFactory = _ => "Documentation~",
        };
        var pictures =
            new Option<bool>("--pictures") { Description = "Pictures and films of insects alone: neither tables nor charts of accuracy." };
        var command = new Command("figures", "Makes the pictures and tables of the documentation's pages again.") { folder, pictures };
        HelpExamples.Set(command, "Example:\n  figures Documentation~");
        command.SetAction(parsed =>
        {
            if (parsed.GetValue(pictures))
                Draw(parsed.GetValue(folder), output);
            else
                Run(parsed.GetValue(folder), output);
            return 0;
        });
        return command;
    }

    private static List<string> Pictures =>
        [k_Sweep, k_SweepCharts, k_Gallery, k_Materials, k_Film, k_OwnFilm, k_Stretch, k_Veins, k_Wake, k_Way, k_Front,
            .. ManualFigures.Pictures.Select(picture => picture.Name), .. SceneFigures.Files,
            .. InsectCatalogue.Names.SelectMany(name => new[] { Portrait(name), Compared(name), First(name) })];

    /// <summary>The film of the front page in which wings flex.</summary>
    internal static FilmPlan HeroFilm => new()
    {
        Flight = FlightPlan.Cruise(InsectCatalogue.Find(k_Hero), InsectVariant.Expressive),
        Beats = 3,
        Turn = 360,
    };

    /// <summary>The film of the front page's own insect.</summary>
    internal static FilmPlan OwnFilm(InsectDefinition insect) => new()
    {
        Flight = FlightPlan.Cruise(insect, InsectVariant.Standard),
        Beats = 1,
        Width = 480,
    };

    /// <summary>The flight of the page of flight.</summary>
    internal static FreePlan Wandering => new() { Insect = InsectCatalogue.Find(k_Hero), Pilot = FreePilot.Wander, Seconds = 12 };

    /// <summary>The sweep of the page of species.</summary>
    internal static SweepPlan SweptElasticity => new(FlownParameters.Find("elasticity"), 0.25, 4, SweepPlan.DefaultSteps,
        Plan(InsectCatalogue.Find("fishfly")) with { Substeps = k_SweptSubsteps }, SweepWaves.Both);

    /// <summary>The comparisons of the page of species.</summary>
    internal static ComparisonPlan Comparisons => new(InsectCatalogue.All.Select(Plan).ToList(), ComparisonColumn.All, k_Phases);

    private static void Run(string path, TextWriter output)
    {
        string page = Text(Path.Combine(path, k_Page));
        string accuracy = Text(Path.Combine(path, AccuracyFigures.Page));
        string flight = Text(Path.Combine(path, FlightFigures.Page)), wake = Text(Path.Combine(path, WakeFigures.Page));
        string performance = Text(Path.Combine(path, PerformanceFigures.Page));
        string[] files =
        [
            k_Page, FlightFigures.Page, WanderFigures.Picture, .. AccuracyFigures.Files, .. WakeFigures.Files,
            .. PerformanceFigures.Files, .. Pictures,
        ];
        Make(path, files, output, InsectCatalogue.All.Sum(species => species.Variants.Count) + 2, (folder, done, stage) =>
        {
            List<FlightSummary> summaries = Measure(InsectCatalogue.All, MeasuredSubsteps, done);
            page = PageBlock.Replace(page, "numbers", MarkdownTable.Write(SpeciesTable.Measured(summaries)));
            foreach (InsectDefinition species in InsectCatalogue.All)
                page = PageBlock.Replace(page, "sources of " + species.Name, MarkdownTable.Write(SpeciesTable.Sources(species)));
            Write(folder, k_Page, page);
            WritePictures(path, folder, stage);
            stage("flying freely");
            (flight, string wandering) = WanderFigures.Make(FlightFigures.Make(flight));
            Write(folder, FlightFigures.Page, flight);
            Write(folder, WanderFigures.Picture, wandering);
            stage("measuring errors and winds");
            foreach ((string name, string text) in AccuracyFigures.Make(accuracy).Concat(WakeFigures.Make(wake)))
                Write(folder, name, text);
            stage("measuring frames of crowds");
            foreach ((string name, string text) in PerformanceFigures.Make(performance))
                Write(folder, name, text);
        });
    }

    private static void Draw(string path, TextWriter output) =>
        Make(path, Pictures.ToArray(), output, 1, (folder, _, stage) => WritePictures(path, folder, stage));

    /// <summary>Makes all files of a folder, or none where something fails, and says where they are.</summary>
    /// <param name="path">The folder.</param>
    /// <param name="files">Their names.</param>
    /// <param name="output">Told the files.</param>
    /// <param name="steps">Steps of the work.</param>
    /// <param name="work">Writes the files; told where to report steps done, and the name of what follows them.</param>
    internal static void Make(string path, string[] files, TextWriter output, int steps,
        System.Action<OutputFolder, System.Action<int>, System.Action<string>> work)
    {
        using var folder = OutputFolder.Prepare(path, files);
        var terminal = new Terminal(output);
        terminal.ShowProgress(steps, (done, stage) => work(folder, done, stage));
        folder.Commit();
        terminal.ShowFiles(path, files);
    }

    private static void WritePictures(string path, OutputFolder folder, System.Action<string> stage)
    {
        stage("painting");
        foreach (InsectDefinition species in InsectCatalogue.All)
        {
            FlightRecord flight = TetheredFlight.Fly(Plan(species) with { Substeps = MeasuredSubsteps });
            folder.Write(Portrait(species.Name), stream => stream.Write(SpeciesPortrait.Draw(flight)));
            folder.Write(First(species.Name), stream => stream.Write(FirstPicture.Draw(flight)));
            if (species.Name == k_Hero)
                folder.Write(k_Stretch, stream => stream.Write(StretchMap.Draw(flight)));
        }

        folder.Write(k_Gallery, stream => stream.Write(Gallery.Draw(GalleryWidth)));
        folder.Write(k_Materials, stream => stream.Write(ContactSheet.DrawMaterials(GalleryWidth)));
        stage("comparing");
        foreach (Comparison comparison in Comparison.Fly(Comparisons, _ => { }))
            folder.Write(Compared(comparison.Plan.Species), stream => stream.Write(ComparisonPicture.Draw(comparison)));
        stage("sweeping");
        var swept = Sweep.Fly(SweptElasticity, _ => { });
        folder.Write(k_Sweep, stream => stream.Write(SweepPicture.DrawPoses(swept)));
        Write(folder, k_SweepCharts, SweepPicture.DrawCharts(swept));
        Write(folder, k_Veins, VeinFigure.Draw());
        foreach ((string name, System.Func<string> draw) in ManualFigures.Pictures)
            Write(folder, name, draw());
        using (var wake = WakeFlight.Smooth(TetheredFlight.Fly(WakeFigures.Flown), new WakePlan()))
            folder.Write(k_Wake, stream => stream.Write(WakePicture.Draw(wake)));

        folder.Write(k_Way, stream => stream.Write(PathPicture.Draw(FreeRun.Fly(Wandering, _ => { }), out float _)));
        stage("studying");
        Write(folder, k_Front, Study(path));
        stage("filming");
        var film = Film.Fly(HeroFilm);
        folder.Write(k_Film, stream => stream.Write(film.Animation(film.Draw(_ => { }))));
        folder.Write(k_OwnFilm, stream => stream.Write(UseOwn(path, FilmOwn)));
        stage("playing scenes");
        SceneFigures.Make((name, content) => folder.Write(name, stream => stream.Write(content)));
    }

    /// <summary>Flies the study of the page of studies and draws its best compromises.</summary>
    /// <param name="path">The folder of the documentation.</param>
    internal static string Study(string path)
    {
        StudyPlan plan = StudyCommand.Read(Path.Combine(path, k_Study));
        var rows = new SortedDictionary<int, StudyRow>(
            Enumerable.Range(0, plan.Points.Length).Select(plan.Fly).ToDictionary(row => row.Run));
        return StudyPictures.DrawFront(new StudyResult(plan, rows));
    }

    /// <summary>Makes the film of the front page's own insect.</summary>
    internal static byte[] FilmOwn(InsectDefinition insect)
    {
        var film = Film.Fly(OwnFilm(insect));
        return film.Animation(film.Draw(_ => { }));
    }

    /// <summary>Makes the front page's own insect of its pictures; its files exist while it is used.</summary>
    /// <param name="path">The folder of the documentation.</param>
    /// <param name="use">Gets the insect.</param>
    internal static T UseOwn<T>(string path, System.Func<InsectDefinition, T> use)
    {
        string folder = Directory.CreateTempSubdirectory("alate-").FullName;
        try
        {
            string home = Path.Combine(folder, "mymoth");
            WingSource[] pictures =
                [new(Path.Combine(path, "images", "moth-fore.png")), new(Path.Combine(path, "images", "moth-hind.png"))];
            var insect = new NewInsect("mymoth", InsectCatalogue.Find(InsectNewOptions.LikeOfTwo), 1600, 25);
            using (var made = OutputFolder.Prepare(home))
            {
                // Not at the end of the command, as other files: they are read here.
                InsectNewCommand.WithWings(insect, pictures, [50, 38], isGiven: true).Write(made);
                made.Rename();
            }

            return use(KnownSpecies.Find(Path.Combine(home, "mymoth" + InsectFile.Ending)));
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    internal static List<FlightSummary> Measure(IEnumerable<InsectDefinition> insects, int substeps, System.Action<int> done)
    {
        var summaries = new List<FlightSummary>();
        foreach (InsectDefinition species in insects)
        {
            foreach (InsectVariant variant in species.Variants)
            {
                FlightRecord flight = TetheredFlight.Fly(Plan(species) with { Variant = variant, Substeps = substeps });
                summaries.Add(FlightSummary.Of(flight));
                done(summaries.Count);
            }
        }

        return summaries;
    }

    private static FlightPlan Plan(InsectDefinition species) => new() { Species = species.Name, Speed = FlightPlan.CruiseOf(species) };

    private static string First(string species) => $"images/{PageFiles.FirstPicture(species)}";

    private static string Portrait(string species) => $"images/species-{species}.png";

    private static string Compared(string species) => $"images/compare-{species}.png";

    private static void Write(OutputFolder folder, string name, string text) =>
        folder.Write(name, stream => stream.Write(Encoding.UTF8.GetBytes(text)));

    private static string Text(string path) => TextFile.Read(path, reader => reader.ReadToEnd()).ReplaceLineEndings("\n");
}
