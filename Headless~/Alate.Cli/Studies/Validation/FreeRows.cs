namespace Alate.Cli;

/// <summary>Comparisons of free flights of the catalogue's insects with published ones of their kin.</summary>
internal static class FreeRows
{
    /// <summary>Quantities of the rows.</summary>
    public const string Impulse = "upward impulse of the downstroke over that of the weight in the beat, %",
        Down = "mean angle of attack in the middle of the downstroke, °", Up = "mean angle of attack in the middle of the upstroke, °",
        Stored = "power, all that is given back stored, W/kg", Unstored = "power, nothing stored, W/kg",
        UpForce = "upstroke's share of the force, %", Bob = "bob of the pitch, half of its range, °";

    /// <summary>Source of the climbing monarch.</summary>
    public const string Kang = "Kang, Sridhar et al. 2020, a monarch that climbs by 0.75 m/s at 1.28 m/s";

    private const float k_Speed = 1.3f, k_Slower = 1f, k_Faster = 1.6f;

    /// <summary>Substeps of the beats on the spot of the experiments.</summary>
    private const int k_Substeps = 96;

    private const string k_Dudley = "Dudley 1991, J. exp. Biol. 159, means of 15 species of butterflies",
        k_BodeOke = "Bode-Oke and Dong 2020, J. R. Soc. Interface 17, a monarch in forward flight",
        k_Willmott = "Willmott and Ellington 1997, J. exp. Biol. 200, a hawkmoth, hover to 5 m/s";
    private const string k_Two = "from the one source to the other",
        k_Span = "± half of 17°: along the span the angle varies by more than that, the difference between the strokes",
        k_Erratic = "from steady flight to the erratic one that was filmed, which costs 43 % more", k_Speeds = "at all speeds";
    private const string k_NoSpread = "one value, without a spread", k_None = "no published number was found for an insect of its kind";

    /// <summary>Rows of a butterfly, level at 1.3 m/s.</summary>
    /// <param name="species">Its name.</param>
    /// <param name="fineness">Substeps.</param>
    /// <param name="done">Called when all are flown.</param>
    /// <param name="explains">Whether rows outside get experiments.</param>
    public static IEnumerable<ValidationRow> Butterfly(string species, Fineness fineness, Action done, bool explains = true)
    {
        HalfStrokes ours = HalfStrokes.Fly(species, k_Speed, fineness.Substeps), fine = HalfStrokes.Fly(species, k_Speed, fineness.Fine);
        string record = $"{species}, free flight";
        List<ValidationRow> rows =
        [
            new(record, Impulse, 92, 118, "computed: 118 and 92", k_Two, $"{k_Dudley}; {k_BodeOke}", ours.DownImpulse, fine.DownImpulse),
            new(record, Down, 30.5, 47.5, "computed from the motion: 39", k_Span, k_Dudley, ours.DownAttack, fine.DownAttack),
            new(record, Up, 13.5, 30.5, "computed from the motion: 22", k_Span, k_Dudley, ours.UpAttack, fine.UpAttack),
            new(record, Stored, 12.5, 12.5 * 1.43, "computed: 12.5", k_Erratic, k_Dudley, ours.Stored, fine.Stored),
            Bare(record, Unstored, "computed: 20.2", k_Dudley, ours.Unstored, fine.Unstored, k_NoSpread),
        ];
        if (species == "monarch")
        {
            rows.Add(Bare(record, UpForce, "computed: 32", k_BodeOke, ours.UpForce, fine.UpForce, k_NoSpread));
            rows.Add(Bare(record, Bob, "measured: 8.3", Kang, ours.PitchBob, fine.PitchBob,
                "one value, without a spread, in a climb; ours flies level, and its abdomen is rigid"));
        }

        foreach (ValidationRow row in explains ? Explained(species, rows) : rows)
            yield return row;
        done();
    }

    /// <summary>Rows of the moth, level at 1.3 m/s.</summary>
    /// <inheritdoc cref="Butterfly"/>
    public static IEnumerable<ValidationRow> Moth(Fineness fineness, Action done)
    {
        const string k_Moth = "painted-lichen-moth";
        HalfStrokes ours = HalfStrokes.Fly(k_Moth, k_Speed, fineness.Substeps), fine = HalfStrokes.Fly(k_Moth, k_Speed, fineness.Fine);
        List<ValidationRow> rows =
        [
            new($"{k_Moth}, free flight", Down, 30, 40, "measured: 30 to 40", k_Speeds, k_Willmott, ours.DownAttack, fine.DownAttack),
            .. Found(k_Moth, ours, fine),
        ];
        foreach (ValidationRow row in Explained(k_Moth, rows))
            yield return row;
        done();
    }

    /// <summary>Rows of the firefly, level at 1.3 m/s.</summary>
    /// <inheritdoc cref="Butterfly"/>
    public static IEnumerable<ValidationRow> Firefly(Fineness fineness, Action done)
    {
        const string k_Firefly = "firefly";
        HalfStrokes ours = HalfStrokes.Fly(k_Firefly, k_Speed, fineness.Substeps),
            fine = HalfStrokes.Fly(k_Firefly, k_Speed, fineness.Fine);
        yield return Bare($"{k_Firefly}, free flight", Down, "–", "–", ours.DownAttack, fine.DownAttack, k_None);
        foreach (ValidationRow row in Found(k_Firefly, ours, fine))
            yield return row;
        done();
    }

    /// <summary>A quantity of the rows.</summary>
    public static double Of(string quantity, HalfStrokes strokes) => quantity switch
    {
        Impulse => strokes.DownImpulse,
        Down => strokes.DownAttack,
        Up => strokes.UpAttack,
        Stored => strokes.Stored,
        Unstored => strokes.Unstored,
        UpForce => strokes.UpForce,
        _ => strokes.PitchBob,
    };

    private static IEnumerable<ValidationRow> Found(string species, HalfStrokes ours, HalfStrokes fine) =>
        new[] { Impulse, Up, Stored, Unstored }.Select(quantity =>
            Bare($"{species}, free flight", quantity, "–", "–", Of(quantity, ours), Of(quantity, fine), k_None));

    private static ValidationRow Bare(
        string record, string quantity, string published, string source, double ours, double fine, string reason) =>
        new(record, quantity, double.NegativeInfinity, double.PositiveInfinity, published, "", source, ours, fine) { Reason = reason };

    private static IEnumerable<ValidationRow> Explained(string species, IEnumerable<ValidationRow> rows)
    {
        var experiments = new Lazy<List<(string Changed, HalfStrokes Strokes)>>(() => [.. Changes(species)]);
        return rows.Select(row => row.IsInside || !row.IsCounted ? row : row with
        {
            Experiments = experiments.Value.ConvertAll(one => new ValidationExperiment(one.Changed, Of(row.Quantity, one.Strokes))),
        });
    }

    private static IEnumerable<(string Changed, HalfStrokes Strokes)> Changes(string species)
    {
        foreach (float speed in new[] { k_Slower, k_Faster })
            yield return (Text($"{speed:0.0} m/s"), HalfStrokes.Fly(species, speed, k_Substeps));
        foreach ((string changed, TrimChange change) in new (string, TrimChange)[]
        {
            ("the body held still in its trim", new()), ("held still, trimmed in air at rest", new() { StillAir = true }),
            ("held still, trimmed with the drag of a dragonfly's wing", new() { Coefficients = CoefficientSet.Dragonfly }),
            ("held still, trimmed for twice the mass", new() { Mass = 2 }),
            ("held still, trimmed for twice the mass with the drag of a dragonfly's wing",
                new() { Mass = 2, Coefficients = CoefficientSet.Dragonfly }),
            ("held still, trimmed for a beat about 0.7 of the frequency", new() { Frequency = 0.7f }),
        })
        {
            // Some have no trim.
            HalfStrokes strokes = change.Fly(species, k_Speed, k_Substeps);
            if (double.IsFinite(strokes.Stored))
                yield return (changed, strokes);
        }
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
