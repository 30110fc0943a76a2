using System.Text.Json;

namespace Alate.Cli;

/// <summary>A message of a page: what to change, a file that follows, or a wish for one.</summary>
internal sealed class ViewRequest
{
    private const int k_Depth = 4, k_LongestName = 200;

    /// <summary>Most files of one message.</summary>
    public const int MostFiles = 16;

    private readonly Dictionary<string, double> m_Values = [];
    private string m_Species, m_Variant;
    private bool? m_IsCompared, m_IsPaused, m_HasWake, m_IsLanding;

    private ViewRequest()
    {
    }

    /// <summary>Names of files whose contents are the next binary messages; empty for none.</summary>
    public IReadOnlyList<string> Files { get; private set; } = [];

    /// <summary>True where the page wants the beat as a GLB file.</summary>
    public bool IsSave { get; private set; }

    /// <summary>True where the viewer's own wing is to go.</summary>
    public bool IsCatalogue { get; private set; }

    /// <summary>Reads a message.</summary>
    /// <exception cref="FormatException">It is not one of the page's.</exception>
    public static ViewRequest Read(ReadOnlyMemory<byte> text)
    {
        try
        {
            using var json = JsonDocument.Parse(text, new JsonDocumentOptions { MaxDepth = k_Depth });
            var request = new ViewRequest();
            foreach (JsonProperty property in json.RootElement.EnumerateObject())
                request.ReadProperty(property);
            return request;
        }
        catch (Exception problem) when (problem is JsonException or InvalidOperationException or DecoderFallbackException)
        {
            throw new FormatException("That message is none of this page's.");
        }
    }

    /// <summary>Settings with the changes of this message.</summary>
    /// <param name="settings">The settings.</param>
    /// <param name="beside">Insects that are known beside those of the catalogue, before one of the same name; null for none.</param>
    /// <exception cref="UserException">There is no such species, variant or slider, or a value is out of its range.</exception>
    public ViewSettings Apply(ViewSettings settings, IReadOnlyList<InsectDefinition> beside = null)
    {
        if (m_Species != null || m_Variant != null || (m_IsLanding ?? settings.IsLanding) != settings.IsLanding)
        {
            string name = m_Species ?? settings.Species;
            InsectDefinition species = beside?.FirstOrDefault(known => known.Name == name) ?? KnownSpecies.FindInCatalogue(name);
            settings = Other(settings, species);
        }

        foreach ((string name, double value) in m_Values)
            settings = ViewSlider.Set(settings, name, value);
        return settings with
        {
            // What lands has one column, and nothing is computed of its wake.
            IsCompared = !settings.IsLanding && (m_IsCompared ?? settings.IsCompared),
            IsPaused = m_IsPaused ?? settings.IsPaused,
            HasWake = !settings.IsLanding && (m_HasWake ?? settings.HasWake),
        };
    }

    // One that lands goes on landing with another insect, where that one lands too; another variant beats on the spot.
    private ViewSettings Other(ViewSettings settings, InsectDefinition species)
    {
        if (m_IsLanding ?? (settings.IsLanding && m_Variant == null && PerchFlight.CanLand(species)))
            return ViewSettings.Landing(species);
        InsectVariant variant = Variant();
        return ViewSettings.Of(KnownSpecies.With(species, variant), variant) with
        {
            IsCompared = settings.IsCompared,
            HasWake = settings.HasWake,
        };
    }

    private InsectVariant Variant()
    {
        if (m_Variant == null)
            return InsectVariant.Standard;
        foreach (InsectVariant variant in Enum.GetValues<InsectVariant>())
        {
            if (KnownSpecies.Word(variant) == m_Variant)
                return variant;
        }

        throw new UserException($"There is no variant {Quote.Of(m_Variant)}. Known: "
            + $"{string.Join(", ", Enum.GetValues<InsectVariant>().Select(KnownSpecies.Word))}.");
    }

    private void ReadProperty(JsonProperty property)
    {
        switch (property.Name)
        {
            case "species":
                m_Species = Shown(property.Value.GetString());
                break;
            case "variant":
                m_Variant = Shown(property.Value.GetString());
                break;
            case "compare":
                m_IsCompared = property.Value.GetBoolean();
                break;
            case "paused":
                m_IsPaused = property.Value.GetBoolean();
                break;
            case "wake":
                m_HasWake = property.Value.GetBoolean();
                break;
            case "landing":
                m_IsLanding = property.Value.GetBoolean();
                break;
            case "values":
                foreach (JsonProperty value in property.Value.EnumerateObject())
                    m_Values[value.Name] = value.Value.GetDouble();
                break;
            case "file":
                Files = [Shown(property.Value.GetString())];
                break;
            case "files":
                Files = property.Value.EnumerateArray().Select(name => Shown(name.GetString())).ToList();
                if (Files.Count is 0 or > MostFiles)
                    throw new FormatException($"A message of this page names 1 to {MostFiles} files.");
                break;
            case "save":
                IsSave = property.Value.GetBoolean();
                break;
            case "catalogue":
                IsCatalogue = property.Value.GetBoolean();
                break;
            default:
                throw new FormatException($"A message of this page has no {Quote.Of(property.Name)}.");
        }
    }

    // Nobody needs more of it in an answer.
    private static string Shown(string text) =>
        text == null ? throw new FormatException("A name is missing.") : text.Length > k_LongestName ? text[..k_LongestName] : text;
}
