using UnityEngine;

namespace Alate.Files
{
    /// <summary>A place of the insect in a file: millimetres to the right, up and ahead of the middle of the thorax.</summary>
    internal static class FilePlace
    {
        /// <summary>Millimetres of a metre.</summary>
        public const decimal PerMetre = 1000m;

        private const decimal k_Most = 1000m;

        public static ListShape Shape { get; } = new ListShape(
            new NumberShape(-k_Most, k_Most, "millimetres"), 3, 3, "three numbers of millimetres: right, up, ahead");

        /// <summary>Half axes and the like.</summary>
        public static ListShape Lengths { get; } = new ListShape(
            new NumberShape(0.001m, k_Most, "millimetres"), 3, 3, "three lengths in millimetres: across, up, along");

        /// <summary>A checked place, metres.</summary>
        public static Vector3 Read(JsonPlace value) => new Vector3(
            FileNumber.ToPreset(value.Items[0].Text, PerMetre), FileNumber.ToPreset(value.Items[1].Text, PerMetre),
            FileNumber.ToPreset(value.Items[2].Text, PerMetre));
    }
}
