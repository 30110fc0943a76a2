using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>Reads kinematics as JSON; Documentation~/kinematics.md has the schema.</summary>
    internal static class KinematicsJson
    {
        private const double k_Largest = 180.0, k_Periodic = 1e-3, k_Even = 1e-3, k_Hole = 1.5;
        private const string k_Frequency = "frequencyHz", k_Angles = "angles";

        /// <summary>Reads a file.</summary>
        /// <exception cref="FormatException">It is not such a file; the message names the place, the value and what is allowed.</exception>
        public static KinematicsFile Read(TextReader reader)
        {
            var root = JsonPlace.Read(reader);
            if (!root.IsObject)
                throw root.Wrong("it must be a JSON object");
            Known(root, "name", "source", k_Frequency, k_Angles, "waves", "wings");
            JsonPlace beat = Needed(root, k_Frequency);
            double frequency = Number(beat);
            if (!((float)frequency >= WingBounds.MaxFrequency.Min && (float)frequency <= WingBounds.MaxFrequency.Max))
            {
                throw beat.Wrong(FormattableString.Invariant(
                    $"{frequency} is out of range: {WingBounds.MaxFrequency.Min} to {WingBounds.MaxFrequency.Max} hertz"));
            }
            double unit = Unit(Needed(root, k_Angles));
            bool waves = root["waves"] is { } wave && Flag(wave);
            JsonPlace all = Needed(root, "wings");
            if (!all.IsObject || all.Members.Count == 0)
                throw all.Wrong("it must be an object with the name of each wing, or 'all'");
            var wings = new Dictionary<string, PresetKinematics>();
            foreach ((string name, JsonPlace wing) in all.Members)
            {
                PresetKinematics motion = Motion(wing, unit);
                motion.prescribed = true;
                motion.waves = waves;
                motion.frequency = (float)frequency;
                wings.Add(name, motion);
            }

            return new KinematicsFile(Text(root, "name"), Text(root, "source"), wings);
        }

        private static PresetKinematics Motion(JsonPlace wing, double unit)
        {
            if (!wing.IsObject)
                throw wing.Wrong("it must be an object with flap and, where they are not 0, sweep, feather or pitch, tilt or strokePlane");
            Known(wing, "flap", "sweep", "feather", "pitch", "tilt", "strokePlane");
            Exclusive(wing, "feather", "pitch");
            Exclusive(wing, "tilt", "strokePlane");
            PresetKinematics motion = default;
            motion.flap = Series(Needed(wing, "flap"), unit);
            motion.sweep = Optional(wing, "sweep", unit);
            motion.feather = wing["pitch"] is { } pitch ? Turned(Series(pitch, unit), 0f) : Optional(wing, "feather", unit);
            motion.tilt = wing["strokePlane"] is { } plane ? Turned(Series(plane, unit), 90f) : Optional(wing, "tilt", unit);
            return motion;
        }

        private static AngleSeries Optional(JsonPlace wing, string key, double unit) =>
            wing[key] is { } value ? Series(value, unit) : default;

        // An angle less a series.
        private static AngleSeries Turned(AngleSeries series, float from) =>
            new AngleSeries(from - series.mean, series.harmonics?.Select(harmonic => new Vector2(-harmonic.x, harmonic.y)).ToArray());

        // A number is a constant.
        private static AngleSeries Series(JsonPlace value, double unit)
        {
            if (value.Kind == JsonKind.Number)
                return new AngleSeries((float)Degrees(value, unit));
            if (!value.IsObject)
                throw value.Wrong("it must be a number, or an object with mean and harmonics, or with a table");
            Known(value, "mean", "harmonics", "table");
            if (value["table"] is { } table)
                return value.Members.Count == 1 ? Table(table, unit) : throw value.Wrong("a table excludes mean and harmonics");
            var harmonics = new List<Vector2>();
            foreach (JsonPlace pair in value["harmonics"] is { } list ? Items(list) : Array.Empty<JsonPlace>())
            {
                (double amplitude, double phase) = Pair(pair, "an amplitude and a phase");
                harmonics.Add(new Vector2((float)Checked(amplitude * unit, pair), (float)(phase * unit)));
            }

            if (harmonics.Count > WingKinematics.Harmonics)
                throw value["harmonics"].Wrong($"it has {harmonics.Count}; at most {WingKinematics.Harmonics} are taken");
            return new AngleSeries((float)Degrees(Needed(value, "mean"), unit), harmonics.ToArray());
        }

        // Rows of t/T and angle, from 0 to 1 in equal steps; the last is the first again.
        private static AngleSeries Table(JsonPlace rows, double unit)
        {
            var times = new List<double>();
            var angles = new List<double>();
            foreach (JsonPlace row in Items(rows))
            {
                (double time, double angle) = Pair(row, "a time t/T and an angle");
                times.Add(time);
                angles.Add(Checked(angle * unit, row));
            }

            int last = times.Count - 1;
            if (last < 3)
                throw rows.Wrong($"it has {last + 1} rows; a beat needs at least four, from 0 to 1");
            if (times[0] != 0 || Math.Abs(times[last] - 1) > k_Even / last)
                throw rows.Wrong(FormattableString.Invariant($"it runs from {times[0]} to {times[last]}; it must run from 0 to 1"));
            double[] steps = Enumerable.Range(0, last).Select(k => times[k + 1] - times[k]).ToArray();
            int hole = Array.FindIndex(steps, step => step > k_Hole * Math.Max(steps.Min(), 0.0)),
                uneven = Array.FindIndex(steps, step => Math.Abs(step * last - 1) > k_Even * last);
            if (hole >= 0)
            {
                throw rows.Wrong(FormattableString.Invariant(
                    $"there is a hole between {times[hole]} and {times[hole + 1]}; the rows must lie equally apart"));
            }
            if (uneven >= 0)
            {
                throw rows.Wrong(FormattableString.Invariant(
                    $"{times[uneven]} and {times[uneven + 1]} are not {1.0 / last:0.####} apart; the rows must lie equally apart"));
            }
            double range = Math.Max(angles.Max() - angles.Min(), 1e-6);
            if (Math.Abs(angles[last] - angles[0]) > k_Periodic * range)
            {
                throw rows.Wrong(FormattableString.Invariant(
                    $"it is not periodic: {angles[0]:0.###}° at 0 and {angles[last]:0.###}° at 1"));
            }
            return AngleSeries.FromTable(angles.Take(last).Select(angle => (float)angle).ToList());
        }

        private static double Unit(JsonPlace value) => value.Kind == JsonKind.Text && value.Text is "degrees" or "radians"
            ? value.Text == "degrees" ? 1.0 : 180.0 / Math.PI
            : throw value.Wrong($"{value.Shown} is no unit that is known: \"degrees\" or \"radians\"");

        private static double Degrees(JsonPlace value, double unit) => Checked(Number(value) * unit, value);

        private static double Checked(double degrees, JsonPlace place) => Math.Abs(degrees) <= k_Largest
            ? degrees
            : throw place.Wrong(FormattableString.Invariant($"{degrees:0.###}° is beyond {k_Largest}°; see the unit in '{k_Angles}'"));

        private static (double First, double Second) Pair(JsonPlace value, string what) => value.Items.Count == 2
            ? (Number(value.Items[0]), Number(value.Items[1]))
            : throw value.Wrong(
                $"it must be {what}, not {(value.Kind == JsonKind.List ? $"{value.Items.Count} values" : value.Shown)}");

        private static IReadOnlyList<JsonPlace> Items(JsonPlace value) =>
            value.Kind == JsonKind.List ? value.Items : throw value.Wrong("it must be a list");

        private static double Number(JsonPlace value) =>
            value.Kind == JsonKind.Number
                && double.TryParse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
                && double.IsFinite(number)
                ? number
                : throw value.Wrong($"it must be a number, not {value.Shown}");

        private static bool Flag(JsonPlace value) => value.Kind == JsonKind.True || value.Kind == JsonKind.False
            ? value.Kind == JsonKind.True
            : throw value.Wrong($"it must be true or false, not {value.Shown}");

        private static string Text(JsonPlace root, string key) => root[key] is not { } value ? null
            : value.Kind == JsonKind.Text ? value.Text : throw value.Wrong("it must be a text");

        private static JsonPlace Needed(JsonPlace value, string key) => value[key] ?? throw value.Wrong($"'{key}' is missing");

        private static void Known(JsonPlace value, params string[] keys)
        {
            foreach ((string key, JsonPlace member) in value.Members)
            {
                if (!keys.Contains(key))
                    throw member.Wrong($"unknown key; known: {string.Join(", ", keys)}");
            }
        }

        private static void Exclusive(JsonPlace value, string one, string other)
        {
            if (value[one] != null && value[other] != null)
                throw value.Wrong($"'{one}' and '{other}' exclude each other");
        }
    }
}
