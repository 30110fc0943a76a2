using System.Text.Json;

namespace Alate.Cli;

/// <summary>Message of the page on which a sample plays.</summary>
internal sealed class SampleRequest
{
    private const int k_Depth = 3;
    private const double k_MostTurn = 360.0, k_MostZoom = 100.0, k_MostMove = 1000.0, k_WidestPicture = 10.0;

    private SampleRequest()
    {
    }

    /// <summary>Another sample to play; null for the one that plays.</summary>
    public string Scene { get; private set; }

    /// <summary>Beginning of the label of a slider of the panel, and its value; no name for none.</summary>
    public (string Name, double Value) Slider { get; private set; }

    /// <summary>Words of a button or toggle of the panel that is pressed; null for none.</summary>
    public string Pressed { get; private set; }

    /// <summary>Turn of the camera; null for none.</summary>
    public SampleLook Look { get; private set; }

    /// <summary>True where the camera goes back to where it was first.</summary>
    public bool IsHome { get; private set; }

    /// <summary>Width of the picture over its height; null as it is.</summary>
    public double? Aspect { get; private set; }

    /// <summary>True to stop, false to go on; null as it is.</summary>
    public bool? IsPaused { get; private set; }

    /// <summary>Number of the state that the page took last; null for none.</summary>
    public uint? Seen { get; private set; }

    /// <summary>Reads a message.</summary>
    /// <exception cref="FormatException">It is not one of the page's.</exception>
    public static SampleRequest Read(ReadOnlyMemory<byte> text)
    {
        try
        {
            using var json = JsonDocument.Parse(text, new JsonDocumentOptions { MaxDepth = k_Depth });
            var request = new SampleRequest();
            foreach (JsonProperty property in json.RootElement.EnumerateObject())
                request.ReadProperty(property.Name, property.Value);
            return request;
        }
        catch (Exception problem) when (problem is JsonException or InvalidOperationException or DecoderFallbackException
            or KeyNotFoundException)
        {
            throw new FormatException("That message is none of this page's.");
        }
    }

    private void ReadProperty(string name, JsonElement value)
    {
        switch (name)
        {
            case "scene":
                Scene = Text(value);
                break;
            case "slider":
                Slider = (Text(value.GetProperty("name")), Number(value.GetProperty("value"), double.MaxValue));
                break;
            case "press":
                Pressed = Text(value);
                break;
            case "look":
                Look = ReadLook([.. value.EnumerateArray()]);
                break;
            case "home":
                IsHome = value.GetBoolean();
                break;
            case "aspect":
                Aspect = Math.Max(Number(value, k_WidestPicture), 1.0 / k_WidestPicture);
                break;
            case "seen":
                Seen = Whole(value);
                break;
            case "paused":
                IsPaused = value.GetBoolean();
                break;
            default:
                throw new FormatException($"A message of this page has no {Quote.Of(name)}.");
        }
    }

    private static SampleLook ReadLook(JsonElement[] values) => values.Length == 7
        ? new SampleLook(
            Whole(values[0]), (float)Number(values[1], k_MostTurn), (float)Number(values[2], k_MostTurn),
            (float)Math.Max(Number(values[3], k_MostZoom), 1.0 / k_MostZoom),
            new float3((float)Number(values[4], k_MostMove), (float)Number(values[5], k_MostMove), (float)Number(values[6], k_MostMove)))
        : throw new FormatException("A look has seven numbers.");

    private static uint Whole(JsonElement value) =>
        value.TryGetUInt32(out uint number) ? number : throw new FormatException("A number of a look or state is a whole one.");

    private static double Number(JsonElement value, double most)
    {
        double number = value.GetDouble();
        return double.IsFinite(number) ? Math.Clamp(number, -most, most) : throw new FormatException("A number is not finite.");
    }

    private static string Text(JsonElement value) => value.GetString() ?? throw new FormatException("A name is missing.");
}
