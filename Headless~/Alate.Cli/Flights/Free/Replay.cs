using Alate.Flight;

namespace Alate.Cli;

/// <summary>A recorded flight that is to be flown again.</summary>
/// <param name="Species">The insect.</param>
/// <param name="Recording">Its flight.</param>
internal sealed record Replay(InsectDefinition Species, FlightRecording Recording)
{
    /// <summary>Reads a recording and finds its insect.</summary>
    /// <exception cref="UserException">The file cannot be read or is no recording, or no insect flies by its numbers.</exception>
    /// <param name="file">The recording.</param>
    /// <param name="other">Insect that may have flown it beside those of the catalogue; null for none.</param>
    public static Replay Read(string file, InsectDefinition other = null) => TextFile.Read(file, text =>
    {
        FlightRecording recording = RecordingReader.Read(text);
        return new Replay(InsectOf(recording, other == null ? InsectCatalogue.All : KnownSpecies.With(other).ToList()), recording);
    });

    /// <summary>Makes the model of the insect, its wings placed as they were.</summary>
    /// <exception cref="UserException">The insect has other numbers today.</exception>
    public FlightModel CreateModel()
    {
        FlightModel model = CatalogueFlight.CreateModel(Species);
        if (Recording.Wings.Count == 0)
            return model;
        using (model)
        {
            IReadOnlyList<FlightWing> wings = Recording.PlacedWings(model.Wings)
                ?? throw new UserException(
                    $"The recording has {Recording.Wings.Count} wings, which are not those of the {Species.DisplayName}.");
            return new FlightModel(wings, Species.FlightParts, model.Mass, model.FluidDensity, model.GravityShare);
        }
    }

    // A scene does not know the catalogue: its insect is found by the numbers by which it flies.
    private static InsectDefinition InsectOf(FlightRecording recording, IReadOnlyList<InsectDefinition> known)
    {
        if (recording.Insect.Length > 0 && known.All(insect => insect.Name != recording.Insect))
            throw new FormatException($"The insect '{recording.Insect}' is not known here.");
        foreach (InsectDefinition insect in known)
        {
            if (!CatalogueFlight.Flies(insect) || recording.Insect.Length > 0 && insect.Name != recording.Insect)
                continue;
            using FlightModel model = CatalogueFlight.CreateModel(insect);
            if (model.Key == recording.Key)
                return insect;
        }

        string who = recording.Insect.Length > 0 ? $"the {recording.Insect}" : "an insect";
        throw new FormatException(
            $"It was flown by {who} with numbers of another version, key {recording.KeyText}; no insect that is known here has them.");
    }
}
