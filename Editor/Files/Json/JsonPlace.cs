using System;
using System.Collections.Generic;
using System.IO;

namespace Alate.Files
{
    /// <summary>A value of a JSON file with its place in it, for messages.</summary>
    internal sealed class JsonPlace
    {
        /// <param name="kind">Kind of the value.</param>
        /// <param name="path">Keys from the root.</param>
        /// <param name="line">Line of the file, from 1.</param>
        /// <param name="text">A text, or what stands there of a number or a word; null for others.</param>
        /// <param name="members">Members of an object; null for others.</param>
        /// <param name="items">Values of a list; null for others.</param>
        public JsonPlace(
            JsonKind kind, string path, int line, string text, IReadOnlyList<(string Key, JsonPlace Value)> members = null,
            IReadOnlyList<JsonPlace> items = null)
        {
            Kind = kind;
            Path = path;
            Line = line;
            Text = text;
            Members = members ?? Array.Empty<(string, JsonPlace)>();
            Items = items ?? Array.Empty<JsonPlace>();
        }

        /// <summary>Kind of the value.</summary>
        public JsonKind Kind { get; }

        /// <summary>Keys from the root, such as <c>wings.fore wing.beat</c>; empty at the root.</summary>
        public string Path { get; }

        /// <summary>Line of the file, from 1.</summary>
        public int Line { get; }

        /// <summary>A text, or a number as it is written.</summary>
        public string Text { get; }

        /// <summary>Members of an object in the file's order, each name once.</summary>
        public IReadOnlyList<(string Key, JsonPlace Value)> Members { get; }

        /// <summary>Values of a list.</summary>
        public IReadOnlyList<JsonPlace> Items { get; }

        /// <summary>Returns true for an object.</summary>
        public bool IsObject => Kind == JsonKind.Object;

        /// <summary>The value as a message shows it.</summary>
        public string Shown => Kind switch
        {
            JsonKind.Object => "an object",
            JsonKind.List => "a list",
            JsonKind.Text => Quote.Of(Text),
            _ => Text,
        };

        /// <summary>The member of an object, null where it has none.</summary>
        public JsonPlace this[string key]
        {
            get
            {
                foreach ((string name, JsonPlace value) in Members)
                {
                    if (name == key)
                        return value;
                }

                return null;
            }
        }

        /// <summary>Reads a whole file.</summary>
        /// <exception cref="FormatException">It is no JSON, or a key stands in an object twice.</exception>
        public static JsonPlace Read(TextReader text) => JsonReader.Read(text.ReadToEnd());

        /// <summary>Problem of this value, with its line and path.</summary>
        public FormatException Wrong(string problem) =>
            new FormatException($"line {Line}{(Path.Length == 0 ? "" : $", {Path}")}: {problem}{(problem.EndsWith('?') ? "" : ".")}");

        /// <summary>A text at this place: the key of this value, to be checked.</summary>
        public JsonPlace Named(string key) => new JsonPlace(JsonKind.Text, Path, Line, key);
    }
}
