using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>Values of files that are written.</summary>
    internal static class FileValue
    {
        /// <summary>A value as a key has it: a decimal, a place in metres, a bool or a word.</summary>
        public static JsonPlace Of(object value) => value switch
        {
            decimal number => new JsonPlace(JsonKind.Number, "", 0, number.ToString(CultureInfo.InvariantCulture)),
            bool isSo => new JsonPlace(isSo ? JsonKind.True : JsonKind.False, "", 0, isSo ? "true" : "false"),
            Vector3 metres => List(new[] { metres.x, metres.y, metres.z }.Select(one => Number(one, FilePlace.PerMetre))),
            _ => new JsonPlace(JsonKind.Text, "", 0, (string)value),
        };

        /// <summary>A number of a preset in the unit of a file.</summary>
        public static JsonPlace Number(float value, decimal perUnit) => Of(FileNumber.ToFile(value, perUnit));

        /// <summary>A list.</summary>
        public static JsonPlace List(IEnumerable<JsonPlace> items) => new JsonPlace(JsonKind.List, "", 0, null, items: items.ToArray());
    }
}
