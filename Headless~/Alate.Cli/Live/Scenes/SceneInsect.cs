using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>The insect of one page, once for each column of the model, with what the page has set.</summary>
internal sealed class SceneInsect : IDisposable
{
    /// <summary>States in a second, at most.</summary>
    public const int Rate = 30;

    private const uint k_Magic = 0x54414C41; // ALAT

    /// <summary>Bit of a state that has a wake behind the wings of each column.</summary>
    private const uint k_WithWake = 1;

    /// <summary>Bit of a state in which the insect of each column has a place of its own.</summary>
    private const uint k_WithPlace = 2;

    private readonly List<InsectDefinition> m_Beside = [];
    private List<LiveFlight> m_Flights = [];
    private PerchFlight m_Landing;
    private OwnWing m_Own;
    private uint m_Sequence;

    /// <exception cref="UserException">The species does not fly with its own numbers.</exception>
    public SceneInsect(ViewSettings settings)
    {
        if (!InsectCatalogue.All.Contains(settings.Flight.Definition))
            m_Beside.Add(settings.Flight.Definition);
        Scene = Make(settings, null);
    }

    public ViewSettings Settings { get; private set; }

    /// <summary>Insects that can be chosen: those of files first.</summary>
    public IEnumerable<InsectDefinition> Known =>
        m_Beside.Concat(InsectCatalogue.All.Where(species => m_Beside.TrueForAll(other => other.Name != species.Name)));

    /// <summary>Description of what flies, for the page.</summary>
    public JsonObject Scene { get; private set; }

    /// <summary>Takes what a page asks for.</summary>
    /// <returns>True where another insect, or other columns, fly now, so that the page needs a new <see cref="Scene"/>.</returns>
    /// <exception cref="UserException">A value is wrong; nothing is changed.</exception>
    public bool Change(ViewRequest request)
    {
        ViewSettings settings = request.Apply(Settings, m_Beside);
        bool isOther = settings.Species != Settings.Species || settings.Variant != Settings.Variant
            || settings.IsCompared != Settings.IsCompared || settings.IsLanding != Settings.IsLanding;
        OwnWing own = settings.Species != Settings.Species || request.IsCatalogue || settings.IsLanding ? null : m_Own;
        if (isOther || own != m_Own)
        {
            Scene = Make(settings, own);
            return true;
        }

        if (settings == Settings)
            return false;
        ShowWake(m_Flights, settings.HasWake);
        try
        {
            foreach (LiveFlight flight in m_Flights)
                flight.Change(settings.Plan(flight.Column));
        }
        catch
        {
            ShowWake(m_Flights, Settings.HasWake);
            throw;
        }

        Settings = settings;
        return false;
    }

    /// <summary>Puts a wing of the viewer's own on the insect.</summary>
    /// <exception cref="UserException">The file is no wing; what flew flies on.</exception>
    public void Wear(string name, byte[] content)
    {
        Scene = Make(Settings with { IsLanding = false }, OwnWing.Read(name, content));
    }

    /// <summary>Takes the insect of a file, which is known from here on, and flies it.</summary>
    /// <param name="insect">The insect file.</param>
    /// <param name="files">All that was dropped with it.</param>
    /// <exception cref="UserException">It is no insect that flies; what flew flies on.</exception>
    public void Add(DroppedFile insect, IReadOnlyList<DroppedFile> files)
    {
        InsectDefinition definition = DroppedInsect.Read(insect, files);
        ViewSettings settings = ViewSettings.Of(definition, definition.Variants[0]) with
        {
            IsCompared = Settings.IsCompared,
            HasWake = Settings.HasWake,
        };
        JsonObject scene = Make(settings, null);
        m_Beside.RemoveAll(other => other.Name == definition.Name);
        m_Beside.Insert(0, definition);
        Scene = scene;
    }

    /// <summary>Lets a moment pass and writes the state of all columns.</summary>
    public void Advance(StateBuffer state) => Advance(state, Settings.IsPaused ? 0.0 : Settings.Slow / Rate);

    /// <summary>Writes the states of a settled beat, each behind its length.</summary>
    /// <param name="frames">States, evenly in time.</param>
    /// <param name="stream">Where to.</param>
    public void Bake(int frames, Stream stream)
    {
        const int k_SettledBeats = 8, k_StepsPerBeat = 4;
        double period = 1.0 / m_Flights[0].Frequency;
        var state = new StateBuffer();
        foreach (LiveFlight flight in m_Flights)
        {
            for (int k = 0; k < k_SettledBeats * k_StepsPerBeat; k++)
                flight.Advance(period / k_StepsPerBeat);
        }

        Advance(state, 0.0);
        for (int k = 0; k < frames; k++)
        {
            stream.Write(BitConverter.GetBytes(state.Length));
            stream.Write(state.Content.Span);
            Advance(state, period / frames);
        }
    }

    private void Advance(StateBuffer state, double seconds)
    {
        state.Clear();
        state.Add(k_Magic);
        state.Add((uint)m_Flights.Count);
        state.Add(m_Landing?.Time ?? m_Flights[0].Time);
        state.Add(m_Sequence++);
        state.Add((Settings.HasWake ? k_WithWake : 0u) | (Settings.IsLanding ? k_WithPlace : 0u));
        if (m_Landing != null)
        {
            m_Landing.Advance(seconds);
            m_Landing.Write(state);
            return;
        }

        foreach (LiveFlight flight in m_Flights)
        {
            flight.Advance(seconds);
            flight.Write(state);
        }
    }

    /// <summary>A settled beat of what flies as a file for other programs.</summary>
    public byte[] Save()
    {
        FlightPlan plan = Settings.Plan(ComparisonColumn.FullModel);
        using var flight = new TetheredFlight(plan, InsectOf(Settings, m_Own));
        using var file = new MemoryStream();
        WingsGlb.Write(flight.Run(_ => { }), file);
        return file.ToArray();
    }

    public void Dispose()
    {
        m_Landing?.Dispose();
        m_Flights.ForEach(flight => flight.Dispose());
    }

    private JsonObject Make(ViewSettings settings, OwnWing own)
    {
        Insect insect = InsectOf(settings, own);
        var flights = new List<LiveFlight>();
        PerchFlight landing = null;
        try
        {
            foreach (ComparisonColumn column in settings.Columns)
                flights.Add(new LiveFlight(settings.Plan(column), insect));
            ShowWake(flights, settings.HasWake);
            landing = settings.IsLanding ? new PerchFlight(settings.Flight.Definition, flights[0].Wings) : null;
        }
        catch
        {
            flights.ForEach(flight => flight.Dispose());
            throw;
        }

        m_Landing?.Dispose();
        m_Flights.ForEach(flight => flight.Dispose());
        (m_Flights, m_Landing, m_Own, Settings) = (flights, landing, own, settings);
        string remark = own?.Remark ?? DoubtsOf(settings, flights[0].Wings);
        return SceneMessage.Scene(insect, flights[0].Wings, flights.Select(flight => flight.Column), settings, remark, own != null);
    }

    // Of a file, in which a unit may be mistaken; the catalogue is known.
    private static string DoubtsOf(ViewSettings settings, IReadOnlyList<RecordedWing> wings) =>
        InsectCatalogue.All.Contains(settings.Flight.Definition)
            ? ""
            : string.Join(' ', UnitDoubts.Of(settings.Plan(ComparisonColumn.FullModel), wings));

    // All flights have one, or none has.
    private static void ShowWake(List<LiveFlight> flights, bool isShown)
    {
        try
        {
            flights.ForEach(flight => flight.ShowWake(isShown));
        }
        catch
        {
            flights.ForEach(flight => flight.ShowWake(false));
            throw;
        }
    }

    private static Insect InsectOf(ViewSettings settings, OwnWing own)
    {
        FlightPlan plan = settings.Plan(ComparisonColumn.FullModel);
        return own == null ? Insect.Of(plan) : own.Fit(settings.Flight.Definition, plan);
    }
}
