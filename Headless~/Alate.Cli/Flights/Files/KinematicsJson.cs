using System.Text.Json;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Reads kinematics as JSON; Documentation~/kinematics.md has the schema.</summary>
internal static class KinematicsJson
{
    private const double k_Largest = 180.0, k_Periodic = 1e-3, k_Even = 1e-3, k_Hole = 1.5;
    private const string k_Frequency = "frequencyHz", k_Angles = "angles";

    /// <summary>Reads a file.</summary>
    /// <exception cref="FormatException">It is not such a file; the message names the place, the value and what is allowed.</exception>
    public static KinematicsFile Read(TextReader reader)
    {
        JsonElement root = Root(reader);
        Known(root, "", "name", "source", k_Frequency, k_Angles, "waves", "wings");
        double frequency = Number(Needed(root, "", k_Frequency), k_Frequency);
        if (!((float)frequency >= WingBounds.MaxFrequency.Min && (float)frequency <= WingBounds.MaxFrequency.Max))
        {
            throw Wrong(k_Frequency, FormattableString.Invariant(
                $"{frequency} is out of range: {WingBounds.MaxFrequency.Min} to {WingBounds.MaxFrequency.Max} hertz"));
        }
        double unit = Unit(Needed(root, "", k_Angles));
        bool waves = root.TryGetProperty("waves", out JsonElement wave) && Flag(wave, "waves");
        JsonElement all = Needed(root, "", "wings");
        if (all.ValueKind != JsonValueKind.Object || !all.EnumerateObject().Any())
            throw Wrong("wings", "it must be an object with the name of each wing, or 'all'");
        var wings = new Dictionary<string, PresetKinematics>();
        foreach (JsonProperty wing in all.EnumerateObject())
        {
            PresetKinematics motion = Motion(wing.Value, $"wings.{wing.Name}", unit);
            motion.prescribed = true;
            motion.waves = waves;
            motion.frequency = (float)frequency;
            if (!wings.TryAdd(wing.Name, motion))
                throw Wrong($"wings.{wing.Name}", "it stands there twice");
        }

        return new KinematicsFile(Text(root, "name"), Text(root, "source"), wings);
    }

    private static JsonElement Root(TextReader reader)
    {
        try
        {
            JsonElement root = JsonDocument.Parse(reader.ReadToEnd()).RootElement;
            return root.ValueKind == JsonValueKind.Object ? root : throw new FormatException("it must be a JSON object.");
        }
        catch (JsonException problem)
        {
            throw new FormatException($"not JSON at line {problem.LineNumber + 1}, column {problem.BytePositionInLine + 1}.");
        }
    }

    private static PresetKinematics Motion(JsonElement wing, string place, double unit)
    {
        if (wing.ValueKind != JsonValueKind.Object)
            throw Wrong(place, "it must be an object with flap and, where they are not 0, sweep, feather or pitch, tilt or strokePlane");
        Known(wing, place, "flap", "sweep", "feather", "pitch", "tilt", "strokePlane");
        Exclusive(wing, place, "feather", "pitch");
        Exclusive(wing, place, "tilt", "strokePlane");
        PresetKinematics motion = default;
        motion.flap = Series(Needed(wing, place, "flap"), $"{place}.flap", unit);
        motion.sweep = Optional(wing, place, "sweep", unit);
        motion.feather = wing.TryGetProperty("pitch", out JsonElement pitch)
            ? Turned(Series(pitch, $"{place}.pitch", unit), 0f)
            : Optional(wing, place, "feather", unit);
        motion.tilt = wing.TryGetProperty("strokePlane", out JsonElement plane)
            ? Turned(Series(plane, $"{place}.strokePlane", unit), 90f)
            : Optional(wing, place, "tilt", unit);
        return motion;
    }

    private static AngleSeries Optional(JsonElement wing, string place, string key, double unit) =>
        wing.TryGetProperty(key, out JsonElement value) ? Series(value, $"{place}.{key}", unit) : default;

    // An angle less a series.
    private static AngleSeries Turned(AngleSeries series, float from) =>
        new(from - series.mean, series.harmonics?.Select(harmonic => new Vector2(-harmonic.x, harmonic.y)).ToArray());

    // A number is a constant.
    private static AngleSeries Series(JsonElement value, string place, double unit)
    {
        if (value.ValueKind == JsonValueKind.Number)
            return new AngleSeries((float)Degrees(value, place, unit));
        if (value.ValueKind != JsonValueKind.Object)
            throw Wrong(place, "it must be a number, or an object with mean and harmonics, or with a table");
        Known(value, place, "mean", "harmonics", "table");
        if (value.TryGetProperty("table", out JsonElement table))
        {
            if (value.EnumerateObject().Count() > 1)
                throw Wrong(place, "a table excludes mean and harmonics");
            return Table(table, $"{place}.table", unit);
        }

        var harmonics = new List<Vector2>();
        if (value.TryGetProperty("harmonics", out JsonElement list))
        {
            foreach (JsonElement pair in Items(list, $"{place}.harmonics"))
            {
                string at = $"{place}.harmonics[{harmonics.Count}]";
                (double amplitude, double phase) = Pair(pair, at, "an amplitude and a phase");
                harmonics.Add(new Vector2((float)Checked(amplitude * unit, at), (float)(phase * unit)));
            }
        }

        if (harmonics.Count > WingKinematics.Harmonics)
            throw Wrong($"{place}.harmonics", $"it has {harmonics.Count}; at most {WingKinematics.Harmonics} are taken");
        return new AngleSeries((float)Degrees(Needed(value, place, "mean"), $"{place}.mean", unit), harmonics.ToArray());
    }

    // Rows of t/T and angle, from 0 to 1 in equal steps; the last is the first again.
    private static AngleSeries Table(JsonElement rows, string place, double unit)
    {
        var times = new List<double>();
        var angles = new List<double>();
        foreach (JsonElement row in Items(rows, place))
        {
            string at = $"{place}[{times.Count}]";
            (double time, double angle) = Pair(row, at, "a time t/T and an angle");
            times.Add(time);
            angles.Add(Checked(angle * unit, at));
        }

        int last = times.Count - 1;
        if (last < 3)
            throw Wrong(place, $"it has {last + 1} rows; a beat needs at least four, from 0 to 1");
        if (times[0] != 0 || Math.Abs(times[last] - 1) > k_Even / last)
            throw Wrong(place, FormattableString.Invariant($"it runs from {times[0]} to {times[last]}; it must run from 0 to 1"));
        double[] steps = Enumerable.Range(0, last).Select(k => times[k + 1] - times[k]).ToArray();
        int hole = Array.FindIndex(steps, step => step > k_Hole * Math.Max(steps.Min(), 0.0)),
            uneven = Array.FindIndex(steps, step => Math.Abs(step * last - 1) > k_Even * last);
        if (hole >= 0)
        {
            throw Wrong(place, FormattableString.Invariant(
                $"there is a hole between {times[hole]} and {times[hole + 1]}; the rows must lie equally apart"));
        }
        if (uneven >= 0)
        {
            throw Wrong(place, FormattableString.Invariant(
                $"{times[uneven]} and {times[uneven + 1]} are not {1.0 / last:0.####} apart; the rows must lie equally apart"));
        }
        double range = Math.Max(angles.Max() - angles.Min(), 1e-6);
        if (Math.Abs(angles[last] - angles[0]) > k_Periodic * range)
            throw Wrong(place, FormattableString.Invariant($"it is not periodic: {angles[0]:0.###}° at 0 and {angles[last]:0.###}° at 1"));
        return AngleSeries.FromTable(angles.Take(last).Select(angle => (float)angle).ToList());
    }

    private static double Unit(JsonElement value) => value.ValueKind == JsonValueKind.String && value.GetString() is "degrees" or "radians"
        ? value.GetString() == "degrees" ? 1.0 : 180.0 / Math.PI
        : throw Wrong(k_Angles, $"{value.GetRawText()} is no unit that is known: \"degrees\" or \"radians\"");

    private static double Degrees(JsonElement value, string place, double unit) => Checked(Number(value, place) * unit, place);

    private static double Checked(double degrees, string place) => Math.Abs(degrees) <= k_Largest
        ? degrees
        : throw Wrong(place, FormattableString.Invariant($"{degrees:0.###}° is beyond {k_Largest}°; see the unit in '{k_Angles}'"));

    private static (double First, double Second) Pair(JsonElement value, string place, string what)
    {
        JsonElement[] two = value.ValueKind == JsonValueKind.Array ? value.EnumerateArray().ToArray() : [];
        return two.Length == 2
            ? (Number(two[0], place), Number(two[1], place))
            : throw Wrong(place, $"it must be {what}, not {value.GetRawText()}");
    }

    private static IEnumerable<JsonElement> Items(JsonElement value, string place) =>
        value.ValueKind == JsonValueKind.Array ? value.EnumerateArray() : throw Wrong(place, "it must be a list");

    private static double Number(JsonElement value, string place) =>
        value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) && double.IsFinite(number)
            ? number
            : throw Wrong(place, $"it must be a number, not {value.GetRawText()}");

    private static bool Flag(JsonElement value, string place) => value.ValueKind is JsonValueKind.True or JsonValueKind.False
        ? value.GetBoolean()
        : throw Wrong(place, $"it must be true or false, not {value.GetRawText()}");

    private static string Text(JsonElement root, string key) =>
        !root.TryGetProperty(key, out JsonElement value) ? null
            : value.ValueKind == JsonValueKind.String ? value.GetString() : throw Wrong(key, "it must be a text");

    private static JsonElement Needed(JsonElement value, string place, string key) => value.TryGetProperty(key, out JsonElement found)
        ? found
        : throw Wrong(place.Length == 0 ? "the file" : place, $"'{key}' is missing");

    private static void Known(JsonElement value, string place, params string[] keys)
    {
        foreach (JsonProperty property in value.EnumerateObject())
        {
            if (!keys.Contains(property.Name))
            {
                throw Wrong(
                    place.Length == 0 ? property.Name : $"{place}.{property.Name}", $"unknown key; known: {string.Join(", ", keys)}");
            }
        }
    }

    private static void Exclusive(JsonElement value, string place, string one, string other)
    {
        if (value.TryGetProperty(one, out _) && value.TryGetProperty(other, out _))
            throw Wrong(place, $"'{one}' and '{other}' exclude each other");
    }

    private static FormatException Wrong(string place, string problem) => new($"{place}: {problem}.");
}
