using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace Alate.Tests.Cli
{
    /// <summary>JSON files with one to three mistakes by a seed: those of people, of programs that write them, and of disks.</summary>
    internal static class DamagedJson
    {
        // Written as texts first: the library writes no such number.
        private static readonly string[] s_Numbers =
        [
            "NaN", "Infinity", "-Infinity", "1e300", "-1e300", "1e-300", "1e999", "0", "-1", "-0", "1e9", "0.1e", "007", "1,5", "true",
            "null", "2147483648", "0x10",
        ];

        private static readonly double[] s_Units = [1e3, 1e-3, 1e6, 1e-6, Math.PI / 180, 180 / Math.PI, -1, 0.5, 2];

        private static readonly JsonSerializerOptions s_Indented = new() { WriteIndented = true };

        /// <summary>Damages a file.</summary>
        /// <param name="text">The file.</param>
        /// <param name="seed">Says the damage.</param>
        public static string Of(string text, int seed)
        {
            var random = new Random(seed);
            var root = JsonNode.Parse(text);
            int mistakes = 1 + random.Next(3);
            var raw = new List<string>();
            for (int k = 0; k < mistakes; k++)
            {
                if (random.Next(6) > 0)
                    Damage(root, random, raw);
            }

            string damaged = root.ToJsonString(s_Indented);
            foreach (string number in raw)
                damaged = damaged.Replace($"\"raw {number}\"", number);
            return random.Next(8) == 0 ? OfText(damaged, random) : damaged;
        }

        private static void Damage(JsonNode root, Random random, List<string> raw)
        {
            var places = new List<JsonNode>();
            Collect(root, places);
            JsonNode place = places[random.Next(places.Count)];
            JsonNode other = random.Next(12) switch
            {
                0 => null,
                1 => JsonValue.Create("text"),
                2 => new JsonObject { ["key"] = 1 },
                3 => new JsonArray(1, "two"),
                >= 4 and < 10 when IsNumber(place) => JsonValue.Create(
                    double.Parse(place.ToJsonString(), CultureInfo.InvariantCulture) * s_Units[random.Next(s_Units.Length)]),
                10 when IsNumber(place) => Raw(s_Numbers[random.Next(s_Numbers.Length)], raw),
                _ => place.DeepClone(),
            };
            switch (place.Parent)
            {
                case JsonObject members:
                    string key = place.GetPropertyName();
                    switch (random.Next(12))
                    {
                        case 0:
                            members.Remove(key);
                            break;
                        case 1:
                            members[key + random.Next(10)] = other;
                            break;
                        case 2:
                            members.Remove(key);
                            members[key[..^1]] = other;
                            break;
                        default:
                            members[key] = other;
                            break;
                    }

                    break;
                case JsonArray items:
                    int index = place.GetElementIndex();
                    switch (random.Next(8))
                    {
                        case 0:
                            items.RemoveAt(index);
                            break;
                        case 1:
                            items.Add(place.DeepClone());
                            break;
                        default:
                            items[index] = other;
                            break;
                    }

                    break;
            }
        }

        private static string OfText(string text, Random random)
        {
            int at = random.Next(text.Length);
            string[] lines = text.Split('\n');
            int line = random.Next(lines.Length);
            return random.Next(6) switch
            {
                0 => text[..at],
                1 => text.Remove(at, Math.Min(1 + random.Next(3), text.Length - at)),
                2 => text.Insert(at, new[] { "\"", "}", "{", ",", "\\", "\0", "é", "\\ud800", "[[[[", "//", "\ufeff" }[random.Next(11)]),
                3 => string.Join('\n', lines.Take(line + 1).Concat(lines.Skip(line))),
                4 => text + text,
                _ => new string('[', 1000) + text,
            };
        }

        private static JsonValue Raw(string number, List<string> raw)
        {
            raw.Add(number);
            return JsonValue.Create("raw " + number);
        }

        private static bool IsNumber(JsonNode node) => node is JsonValue && node.GetValueKind() == JsonValueKind.Number;

        private static void Collect(JsonNode node, List<JsonNode> places)
        {
            IEnumerable<JsonNode> inner = node switch
            {
                JsonObject members => members.Select(member => member.Value),
                JsonArray items => items,
                _ => [],
            };
            foreach (JsonNode one in inner.Where(one => one != null))
            {
                places.Add(one);
                Collect(one, places);
            }
        }
    }
}
